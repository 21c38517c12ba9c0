"""The engine: where is A as seen from B, at t?  A textbook of short pages.

    stamps       when: time is a whole number of nanoseconds
    builds       as it stands, or compiled
    quaternions  which way round: (x, y, z, w), and REP-103's axes
    poses        seven numbers: how two transforms make one
    transforms   where: a turn and a step
    errors       what can go wrong: tf2's family of exceptions
    plain        the whole rule on one page; the pages after it are fast
    segments     between two samples, worked out once
    cache        one edge of the tree, through time
    tree         who is whose child
    walk         from one frame to another
    failures     why there is no answer, in tf2's words
    routes       the same way again; what is remembered, and when it is forgotten
    buffer       BufferCore: publish, and ask
    checks       what may come in, and what is refused
    requests     call me when you can
    velocity     how fast does it move
    describe     the tree in tf2's words
    columns      the arithmetic for many moments at once
    batch        a hundred thousand questions at once
    inspection   what is in there: names, parents, histories
    snapshot     what there is to draw
    records      what was heard, before anybody judged it

Behaviour, order of checks and texts are those of ROS 2's tf2 (geometry2 0.39.1).
It needs nothing but numpy.  Start with `stamps.py`.
"""

from . import builds, quaternions
from .batch import Batch, Failures
from .buffer import DEFAULT_CACHE_TIME_NS, BufferCore
from .errors import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)
from .inspection import History, Memory
from .requests import NEVER, POSSIBLE_NOW
from .snapshot import FrameSnapshot, Snapshot
from .stamps import (
    LATEST,
    NSEC_PER_SEC,
    format_stamp,
    sec_nanosec_from_stamp,
    seconds,
    stamp_from_sec_nanosec,
)
from .transforms import StampedTransform, Transform
from .velocity import Velocity

BUILD = builds.BUILD  # "pure" or "compiled"

__all__ = [
    "BUILD",
    "DEFAULT_CACHE_TIME_NS",
    "LATEST",
    "NEVER",
    "NSEC_PER_SEC",
    "POSSIBLE_NOW",
    "Batch",
    "BufferCore",
    "ConnectivityException",
    "ExtrapolationException",
    "Failures",
    "FrameSnapshot",
    "History",
    "InvalidArgumentException",
    "LookupException",
    "Memory",
    "Snapshot",
    "StampedTransform",
    "TimeoutException",
    "Transform",
    "TransformException",
    "Velocity",
    "format_stamp",
    "quaternions",
    "sec_nanosec_from_stamp",
    "seconds",
    "stamp_from_sec_nanosec",
]
