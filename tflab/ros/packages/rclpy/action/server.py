"""rclpy.action.server"""

from tflab.ros.action import (
    ActionServer as ActionServer,
    GoalResponse as GoalResponse,
    ServerGoalHandle as ServerGoalHandle,
)
