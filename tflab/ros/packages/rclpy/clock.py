"""rclpy.clock"""

from tflab.ros.clock import (
    Clock as Clock,
    ClockChange as ClockChange,
    ClockType as ClockType,
    JumpHandle as JumpHandle,
    JumpThreshold as JumpThreshold,
    ROSClock as ROSClock,
    TimeJump as TimeJump,
)
from tflab.ros.duration import Duration as Duration
from tflab.ros.time import Time as Time
