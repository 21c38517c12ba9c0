"""rclpy.utilities"""

from tflab.ros.arguments import remove_ros_args
from tflab.ros.client_library import get_default_context, ok, shutdown, try_shutdown

__all__ = [
    "get_default_context",
    "ok",
    "remove_ros_args",
    "shutdown",
    "try_shutdown",
]
