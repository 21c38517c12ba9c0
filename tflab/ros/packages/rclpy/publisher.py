"""rclpy.publisher"""

from tflab.ros.publisher import Publisher

__all__ = [
    "Publisher",
]
