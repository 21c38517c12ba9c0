"""rclpy.action: goals and results, in process.  See tflab.ros.action."""

from .client import ActionClient as ActionClient
from .server import (
    ActionServer as ActionServer,
    GoalResponse as GoalResponse,
)
