"""rclpy.action.client"""

from tflab.ros.action_client import (
    ActionClient as ActionClient,
    ClientGoalHandle as ClientGoalHandle,
)
