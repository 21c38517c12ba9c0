"""rclpy.utilities"""

from tflab.ros.arguments import remove_ros_args as remove_ros_args
from tflab.ros.client_library import (
    get_default_context as get_default_context,
    ok as ok,
    rmw_implementation,
    shutdown as shutdown,
    timeout_sec_to_nsec as timeout_sec_to_nsec,
    try_shutdown as try_shutdown,
)

get_rmw_implementation_identifier = rmw_implementation
