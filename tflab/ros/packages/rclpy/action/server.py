"""rclpy.action.server"""

from tflab.ros.action import ActionServer, GoalResponse, ServerGoalHandle

__all__ = ["ActionServer", "GoalResponse", "ServerGoalHandle"]
