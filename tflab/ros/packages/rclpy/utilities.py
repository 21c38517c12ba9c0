"""rclpy.utilities"""

from tflab.ros.arguments import remove_ros_args as remove_ros_args
from tflab.ros.client_library import (
    get_default_context as get_default_context,
    ok as ok,
    shutdown as shutdown,
    try_shutdown as try_shutdown,
)
