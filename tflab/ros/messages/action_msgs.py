"""Define action_msgs: goals, their status, and cancellation."""

from .base import message, service

GoalInfo = message(
    "action_msgs/msg/GoalInfo",
    """
    unique_identifier_msgs/UUID goal_id
    builtin_interfaces/Time stamp
""",
)

GoalStatus = message(
    "action_msgs/msg/GoalStatus",
    """
    int8 STATUS_UNKNOWN=0
    int8 STATUS_ACCEPTED=1
    int8 STATUS_EXECUTING=2
    int8 STATUS_CANCELING=3
    int8 STATUS_SUCCEEDED=4
    int8 STATUS_CANCELED=5
    int8 STATUS_ABORTED=6
    GoalInfo goal_info
    int8 status
""",
)

GoalStatusArray = message("action_msgs/msg/GoalStatusArray", "GoalStatus[] status_list")

CancelGoal = service(
    "action_msgs/srv/CancelGoal",
    request="GoalInfo goal_info",
    response="""
        int8 ERROR_NONE=0
        int8 ERROR_REJECTED=1
        int8 ERROR_UNKNOWN_GOAL_ID=2
        int8 ERROR_GOAL_TERMINATED=3
        int8 return_code
        GoalInfo[] goals_canceling
    """,
)
