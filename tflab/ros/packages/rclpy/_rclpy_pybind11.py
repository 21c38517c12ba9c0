"""rclpy._rclpy_pybind11: of rclpy's lower half, only what programs catch."""

from tflab.ros.exceptions import (
    InvalidHandle as InvalidHandle,
    RCLError as RCLError,
)
