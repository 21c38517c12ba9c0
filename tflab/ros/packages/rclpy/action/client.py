"""rclpy.action.client"""

from tflab.ros.action import (
    ActionClient as ActionClient,
    ClientGoalHandle as ClientGoalHandle,
)
