"""rclpy.client"""

from tflab.ros.service import Client

__all__ = [
    "Client",
]
