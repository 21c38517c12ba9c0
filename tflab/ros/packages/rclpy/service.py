"""rclpy.service"""

from tflab.ros.service import Service

__all__ = [
    "Service",
]
