"""Define builtin_interfaces: Time and Duration."""

from .base import message

Time = message(
    "builtin_interfaces/msg/Time",
    """
    int32 sec
    uint32 nanosec
""",
)

Duration = message(
    "builtin_interfaces/msg/Duration",
    """
    int32 sec
    uint32 nanosec
""",
)
