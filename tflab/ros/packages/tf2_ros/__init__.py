"""tf2_ros: buffers, listeners and broadcasters.  See tflab.ros.tf2.buffer."""

from tf2_py import (
    BufferCore as BufferCore,
    ConnectivityException as ConnectivityException,
    ExtrapolationException as ExtrapolationException,
    InvalidArgumentException as InvalidArgumentException,
    LookupException as LookupException,
    TimeoutException as TimeoutException,
    TransformException as TransformException,
)

from .buffer import Buffer as Buffer
from .buffer_client import BufferClient as BufferClient
from .buffer_interface import (
    BufferInterface as BufferInterface,
    ConvertRegistration as ConvertRegistration,
    NotImplementedException as NotImplementedException,
    Stamped as Stamped,
    TransformRegistration as TransformRegistration,
    TypeException as TypeException,
    convert as convert,
)
from .static_transform_broadcaster import StaticTransformBroadcaster as StaticTransformBroadcaster
from .static_transform_listener import StaticTransformListener as StaticTransformListener
from .transform_broadcaster import TransformBroadcaster as TransformBroadcaster
from .transform_listener import (
    DEFAULT_STATIC_TF_TOPIC as DEFAULT_STATIC_TF_TOPIC,
    DEFAULT_TF_TOPIC as DEFAULT_TF_TOPIC,
    TransformListener as TransformListener,
)
