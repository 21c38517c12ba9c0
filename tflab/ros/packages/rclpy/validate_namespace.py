"""rclpy.validate_namespace"""

from tflab.ros.names import validate_namespace

__all__ = [
    "validate_namespace",
]
