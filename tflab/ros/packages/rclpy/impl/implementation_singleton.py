"""rclpy.impl.implementation_singleton: of rclpy's lower half, only what it raises."""

from tflab.ros import exceptions as rclpy_implementation

__all__ = ["rclpy_implementation"]
