"""Define std_msgs: single values and the header."""

from .base import message

Header = message(
    "std_msgs/msg/Header",
    """
    builtin_interfaces/Time stamp
    string frame_id
""",
)

ColorRGBA = message(
    "std_msgs/msg/ColorRGBA",
    """
    float32 r
    float32 g
    float32 b
    float32 a
""",
)

Empty = message("std_msgs/msg/Empty")
String = message("std_msgs/msg/String", "string data")
Bool = message("std_msgs/msg/Bool", "bool data")
Byte = message("std_msgs/msg/Byte", "byte data")
Char = message("std_msgs/msg/Char", "char data")
Float32 = message("std_msgs/msg/Float32", "float32 data")
Float64 = message("std_msgs/msg/Float64", "float64 data")
Int8 = message("std_msgs/msg/Int8", "int8 data")
Int16 = message("std_msgs/msg/Int16", "int16 data")
Int32 = message("std_msgs/msg/Int32", "int32 data")
Int64 = message("std_msgs/msg/Int64", "int64 data")
UInt8 = message("std_msgs/msg/UInt8", "uint8 data")
UInt16 = message("std_msgs/msg/UInt16", "uint16 data")
UInt32 = message("std_msgs/msg/UInt32", "uint32 data")
UInt64 = message("std_msgs/msg/UInt64", "uint64 data")

MultiArrayDimension = message(
    "std_msgs/msg/MultiArrayDimension",
    """
    string label
    uint32 size
    uint32 stride
""",
)

MultiArrayLayout = message(
    "std_msgs/msg/MultiArrayLayout",
    """
    MultiArrayDimension[] dim
    uint32 data_offset
""",
)

ByteMultiArray = message("std_msgs/msg/ByteMultiArray", "MultiArrayLayout layout\nbyte[] data")
Float32MultiArray = message("std_msgs/msg/Float32MultiArray", "MultiArrayLayout layout\nfloat32[] data")
Float64MultiArray = message("std_msgs/msg/Float64MultiArray", "MultiArrayLayout layout\nfloat64[] data")
Int8MultiArray = message("std_msgs/msg/Int8MultiArray", "MultiArrayLayout layout\nint8[] data")
Int16MultiArray = message("std_msgs/msg/Int16MultiArray", "MultiArrayLayout layout\nint16[] data")
Int32MultiArray = message("std_msgs/msg/Int32MultiArray", "MultiArrayLayout layout\nint32[] data")
Int64MultiArray = message("std_msgs/msg/Int64MultiArray", "MultiArrayLayout layout\nint64[] data")
UInt8MultiArray = message("std_msgs/msg/UInt8MultiArray", "MultiArrayLayout layout\nuint8[] data")
UInt16MultiArray = message("std_msgs/msg/UInt16MultiArray", "MultiArrayLayout layout\nuint16[] data")
UInt32MultiArray = message("std_msgs/msg/UInt32MultiArray", "MultiArrayLayout layout\nuint32[] data")
UInt64MultiArray = message("std_msgs/msg/UInt64MultiArray", "MultiArrayLayout layout\nuint64[] data")
