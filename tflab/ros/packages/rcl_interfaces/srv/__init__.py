"""Services of rcl_interfaces, in process."""

from tflab.ros.messages.rcl_interfaces import (
    DescribeParameters as DescribeParameters,
    GetLoggerLevels as GetLoggerLevels,
    GetParameters as GetParameters,
    GetParameterTypes as GetParameterTypes,
    ListParameters as ListParameters,
    SetLoggerLevels as SetLoggerLevels,
    SetParameters as SetParameters,
    SetParametersAtomically as SetParametersAtomically,
)
