"""Messages of builtin_interfaces, in process."""

from tflab.ros.messages.builtin_interfaces import (
    Duration as Duration,
    Time as Time,
)
