"""Messages of example_interfaces, in process."""

from tflab.ros.messages.example_interfaces import (
    Bool as Bool,
    Float64 as Float64,
    Int64 as Int64,
    String as String,
)
