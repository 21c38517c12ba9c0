"""rclpy.action.server"""

from tflab.ros.action_goals import GoalEvent as GoalEvent
from tflab.ros.action_server import (
    ActionServer as ActionServer,
    CancelResponse as CancelResponse,
    GoalResponse as GoalResponse,
    ServerGoalHandle as ServerGoalHandle,
    default_cancel_callback as default_cancel_callback,
    default_goal_callback as default_goal_callback,
    default_handle_accepted_callback as default_handle_accepted_callback,
)
