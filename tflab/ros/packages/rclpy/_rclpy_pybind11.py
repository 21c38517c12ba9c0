"""rclpy._rclpy_pybind11: of rclpy's lower half, only what programs touch."""

from tflab.ros.client_library import rmw_implementation
from tflab.ros.exceptions import InvalidHandle as InvalidHandle, RCLError as RCLError
from tflab.ros.qos import CQoSProfile

rclpy_get_rmw_implementation_identifier = rmw_implementation
rmw_qos_profile_t = CQoSProfile
