"""rclpy.timer"""

from tflab.ros.timer import (
    Rate as Rate,
    Timer as Timer,
    TimerInfo as TimerInfo,
)
