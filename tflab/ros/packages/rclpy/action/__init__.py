"""rclpy.action: goals, feedback and results, in process.  See tflab.ros.action_server and tflab.ros.action_client."""

from .client import ActionClient as ActionClient
from .server import (
    ActionServer as ActionServer,
    CancelResponse as CancelResponse,
    GoalResponse as GoalResponse,
)
