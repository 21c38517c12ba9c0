"""rclpy.time"""

from tflab.ros.time import Duration, Time

__all__ = [
    "Duration",
    "Time",
]
