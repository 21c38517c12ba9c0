"""rclpy.action.client"""

from tflab.ros.action import ActionClient, ClientGoalHandle

__all__ = ["ActionClient", "ClientGoalHandle"]
