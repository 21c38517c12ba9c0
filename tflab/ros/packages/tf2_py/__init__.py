"""tf2_py: the engine for Python.  See tflab.ros.tf2.core."""

from tflab.core import (
    ConnectivityException as ConnectivityException,
    ExtrapolationException as ExtrapolationException,
    InvalidArgumentException as InvalidArgumentException,
    LookupException as LookupException,
    TimeoutException as TimeoutException,
    TransformException as TransformException,
)
from tflab.ros.tf2.core import BufferCore as BufferCore
