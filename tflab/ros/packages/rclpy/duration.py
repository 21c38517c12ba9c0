"""rclpy.duration"""

from tflab.ros.duration import (
    Duration as Duration,
    Infinite as Infinite,
)
