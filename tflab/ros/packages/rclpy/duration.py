"""rclpy.duration"""

from tflab.ros.duration import Duration, Infinite

__all__ = [
    "Duration",
    "Infinite",
]
