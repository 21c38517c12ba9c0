"""Messages of rcl_interfaces, in process."""

from tflab.ros.messages.rcl_interfaces import (
    FloatingPointRange,
    IntegerRange,
    ListParametersResult,
    Log,
    LoggerLevel,
    Parameter,
    ParameterDescriptor,
    ParameterEvent,
    ParameterType,
    ParameterValue,
    SetLoggerLevelsResult,
    SetParametersResult,
)

__all__ = [
    "FloatingPointRange",
    "IntegerRange",
    "ListParametersResult",
    "Log",
    "LoggerLevel",
    "Parameter",
    "ParameterDescriptor",
    "ParameterEvent",
    "ParameterType",
    "ParameterValue",
    "SetLoggerLevelsResult",
    "SetParametersResult",
]
