"""Services of rcl_interfaces, in process."""

from tflab.ros.messages.rcl_interfaces import (
    DescribeParameters,
    GetLoggerLevels,
    GetParameters,
    GetParameterTypes,
    ListParameters,
    SetLoggerLevels,
    SetParameters,
    SetParametersAtomically,
)

__all__ = [
    "DescribeParameters",
    "GetLoggerLevels",
    "GetParameterTypes",
    "GetParameters",
    "ListParameters",
    "SetLoggerLevels",
    "SetParameters",
    "SetParametersAtomically",
]
