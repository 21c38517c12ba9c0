"""tf2_ros.buffer_interface"""

from tflab.ros.tf2.interface import (
    BufferInterface as BufferInterface,
    ConvertRegistration as ConvertRegistration,
    NotImplementedException as NotImplementedException,
    Stamped as Stamped,
    TransformRegistration as TransformRegistration,
    TypeException as TypeException,
    convert as convert,
)
