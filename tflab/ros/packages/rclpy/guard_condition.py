"""rclpy.guard_condition"""

from tflab.ros.guard_condition import GuardCondition as GuardCondition
