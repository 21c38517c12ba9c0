"""rclpy.clock"""

from tflab.ros.clock import Clock, ClockChange, ClockType, JumpHandle, JumpThreshold, ROSClock, TimeJump
from tflab.ros.duration import Duration
from tflab.ros.time import Time

__all__ = [
    "Clock",
    "ClockChange",
    "ClockType",
    "Duration",
    "JumpHandle",
    "JumpThreshold",
    "ROSClock",
    "Time",
    "TimeJump",
]
