"""rclpy.impl.implementation_singleton: of rclpy's lower half, only what programs touch."""

from rclpy import _rclpy_pybind11

rclpy_implementation = _rclpy_pybind11
