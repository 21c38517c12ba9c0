"""Define rcl_interfaces: parameters and logs."""

from .base import message, service

ParameterType = message(
    "rcl_interfaces/msg/ParameterType",
    """
    uint8 PARAMETER_NOT_SET=0
    uint8 PARAMETER_BOOL=1
    uint8 PARAMETER_INTEGER=2
    uint8 PARAMETER_DOUBLE=3
    uint8 PARAMETER_STRING=4
    uint8 PARAMETER_BYTE_ARRAY=5
    uint8 PARAMETER_BOOL_ARRAY=6
    uint8 PARAMETER_INTEGER_ARRAY=7
    uint8 PARAMETER_DOUBLE_ARRAY=8
    uint8 PARAMETER_STRING_ARRAY=9
""",
)

ParameterValue = message(
    "rcl_interfaces/msg/ParameterValue",
    """
    uint8 type
    bool bool_value
    int64 integer_value
    float64 double_value
    string string_value
    byte[] byte_array_value
    bool[] bool_array_value
    int64[] integer_array_value
    float64[] double_array_value
    string[] string_array_value
""",
)

Parameter = message(
    "rcl_interfaces/msg/Parameter",
    """
    string name
    ParameterValue value
""",
)

FloatingPointRange = message(
    "rcl_interfaces/msg/FloatingPointRange",
    """
    float64 from_value
    float64 to_value
    float64 step
""",
)

IntegerRange = message(
    "rcl_interfaces/msg/IntegerRange",
    """
    int64 from_value
    int64 to_value
    uint64 step
""",
)

ParameterDescriptor = message(
    "rcl_interfaces/msg/ParameterDescriptor",
    """
    string name
    uint8 type
    string description
    string additional_constraints
    bool read_only
    bool dynamic_typing
    FloatingPointRange[<=1] floating_point_range
    IntegerRange[<=1] integer_range
""",
)

ParameterEvent = message(
    "rcl_interfaces/msg/ParameterEvent",
    """
    builtin_interfaces/Time stamp
    string node
    Parameter[] new_parameters
    Parameter[] changed_parameters
    Parameter[] deleted_parameters
""",
)

ListParametersResult = message(
    "rcl_interfaces/msg/ListParametersResult",
    """
    string[] names
    string[] prefixes
""",
)

SetParametersResult = message(
    "rcl_interfaces/msg/SetParametersResult",
    """
    bool successful
    string reason
""",
)

Log = message(
    "rcl_interfaces/msg/Log",
    """
    uint8 DEBUG=10
    uint8 INFO=20
    uint8 WARN=30
    uint8 ERROR=40
    uint8 FATAL=50
    builtin_interfaces/Time stamp
    uint8 level
    string name
    string msg
    string file
    string function
    uint32 line
""",
)

LoggerLevel = message(
    "rcl_interfaces/msg/LoggerLevel",
    """
    uint8 LOG_LEVEL_UNKNOWN=0
    uint8 LOG_LEVEL_DEBUG=10
    uint8 LOG_LEVEL_INFO=20
    uint8 LOG_LEVEL_WARN=30
    uint8 LOG_LEVEL_ERROR=40
    uint8 LOG_LEVEL_FATAL=50
    string name
    uint32 level
""",
)

SetLoggerLevelsResult = message(
    "rcl_interfaces/msg/SetLoggerLevelsResult",
    """
    bool successful
    string reason
""",
)

DescribeParameters = service(
    "rcl_interfaces/srv/DescribeParameters",
    request="string[] names",
    response="ParameterDescriptor[] descriptors",
)

GetParameterTypes = service(
    "rcl_interfaces/srv/GetParameterTypes",
    request="string[] names",
    response="uint8[] types",
)

GetParameters = service(
    "rcl_interfaces/srv/GetParameters",
    request="string[] names",
    response="ParameterValue[] values",
)

ListParameters = service(
    "rcl_interfaces/srv/ListParameters",
    request="""
        uint64 DEPTH_RECURSIVE=0
        string[] prefixes
        uint64 depth
    """,
    response="ListParametersResult result",
)

SetParameters = service(
    "rcl_interfaces/srv/SetParameters",
    request="Parameter[] parameters",
    response="SetParametersResult[] results",
)

SetParametersAtomically = service(
    "rcl_interfaces/srv/SetParametersAtomically",
    request="Parameter[] parameters",
    response="SetParametersResult result",
)

GetLoggerLevels = service(
    "rcl_interfaces/srv/GetLoggerLevels",
    request="string[] names",
    response="LoggerLevel[] levels",
)

SetLoggerLevels = service(
    "rcl_interfaces/srv/SetLoggerLevels",
    request="LoggerLevel[] levels",
    response="SetLoggerLevelsResult[] results",
)
