"""Messages of std_msgs, in process."""

from tflab.ros.messages.std_msgs import (
    Bool as Bool,
    Byte as Byte,
    Char as Char,
    ColorRGBA as ColorRGBA,
    Empty as Empty,
    Float32 as Float32,
    Float64 as Float64,
    Header as Header,
    Int8 as Int8,
    Int16 as Int16,
    Int32 as Int32,
    Int64 as Int64,
    String as String,
    UInt8 as UInt8,
    UInt16 as UInt16,
    UInt32 as UInt32,
    UInt64 as UInt64,
)
