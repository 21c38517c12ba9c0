"""Messages of rcl_interfaces, in process."""

from tflab.ros.messages.rcl_interfaces import (
    FloatingPointRange as FloatingPointRange,
    IntegerRange as IntegerRange,
    ListParametersResult as ListParametersResult,
    Log as Log,
    LoggerLevel as LoggerLevel,
    Parameter as Parameter,
    ParameterDescriptor as ParameterDescriptor,
    ParameterEvent as ParameterEvent,
    ParameterType as ParameterType,
    ParameterValue as ParameterValue,
    SetLoggerLevelsResult as SetLoggerLevelsResult,
    SetParametersResult as SetParametersResult,
)
