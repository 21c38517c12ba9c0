"""action_msgs.msg"""

from tflab.ros.messages.action_msgs import (
    GoalInfo as GoalInfo,
    GoalStatus as GoalStatus,
    GoalStatusArray as GoalStatusArray,
)
