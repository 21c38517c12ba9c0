"""Messages of builtin_interfaces, in process."""

from tflab.ros.messages.builtin_interfaces import (
    Duration,
    Time,
)

__all__ = [
    "Duration",
    "Time",
]
