"""rclpy.callback_groups"""

from tflab.ros.callback_groups import (
    CallbackGroup as CallbackGroup,
    MutuallyExclusiveCallbackGroup as MutuallyExclusiveCallbackGroup,
    ReentrantCallbackGroup as ReentrantCallbackGroup,
)
