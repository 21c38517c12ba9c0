"""Define diagnostic_msgs."""

from .base import message

KeyValue = message(
    "diagnostic_msgs/msg/KeyValue",
    """
    string key
    string value
""",
)

DiagnosticStatus = message(
    "diagnostic_msgs/msg/DiagnosticStatus",
    """
    byte OK=0
    byte WARN=1
    byte ERROR=2
    byte STALE=3
    byte level
    string name
    string message
    string hardware_id
    KeyValue[] values
""",
)

DiagnosticArray = message(
    "diagnostic_msgs/msg/DiagnosticArray",
    """
    std_msgs/Header header
    DiagnosticStatus[] status
""",
)
