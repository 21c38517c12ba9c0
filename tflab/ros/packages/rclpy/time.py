"""rclpy.time"""

from tflab.ros.time import (
    Duration as Duration,
    Time as Time,
)
