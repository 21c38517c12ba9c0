"""Define tf2_msgs: the messages of /tf and /tf_static, and the action LookupTransform."""

from .base import action, message, service

TFMessage = message("tf2_msgs/msg/TFMessage", "geometry_msgs/TransformStamped[] transforms")

TF2Error = message(
    "tf2_msgs/msg/TF2Error",
    """
    uint8 NO_ERROR=0
    uint8 LOOKUP_ERROR=1
    uint8 CONNECTIVITY_ERROR=2
    uint8 EXTRAPOLATION_ERROR=3
    uint8 INVALID_ARGUMENT_ERROR=4
    uint8 TIMEOUT_ERROR=5
    uint8 TRANSFORM_ERROR=6
    uint8 error
    string error_string
""",
)

FrameGraph = service(
    "tf2_msgs/srv/FrameGraph",
    response="string frame_yaml",
)

LookupTransform = action(
    "tf2_msgs/action/LookupTransform",
    goal="""
        string target_frame
        string source_frame
        builtin_interfaces/Time source_time
        builtin_interfaces/Duration timeout
        builtin_interfaces/Time target_time
        string fixed_frame
        bool advanced
    """,
    result="""
        geometry_msgs/TransformStamped transform
        TF2Error error
    """,
)
