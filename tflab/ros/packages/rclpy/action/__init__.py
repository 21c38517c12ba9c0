"""rclpy.action: goals and results, in process.  See tflab.ros.action."""

from .client import ActionClient
from .server import ActionServer, GoalResponse

__all__ = ["ActionClient", "ActionServer", "GoalResponse"]
