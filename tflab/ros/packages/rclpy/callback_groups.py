"""rclpy.callback_groups"""

from tflab.ros.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup

__all__ = [
    "CallbackGroup",
    "MutuallyExclusiveCallbackGroup",
    "ReentrantCallbackGroup",
]
