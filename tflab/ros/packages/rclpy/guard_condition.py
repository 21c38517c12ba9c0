"""rclpy.guard_condition"""

from tflab.ros.guard_condition import GuardCondition

__all__ = [
    "GuardCondition",
]
