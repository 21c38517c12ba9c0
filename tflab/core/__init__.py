"""Look up transforms between frames at any time: the engine.

    stamps       time as whole nanoseconds
    builds       the pure or the compiled build
    quaternions  rotations (x, y, z, w), and the axes of REP-103
    poses        composition and inversion of seven numbers
    transforms   Transform, StampedTransform, TransformRecord
    errors       tf2's exceptions
    plain        the reference implementation; the modules below are fast
    segments     interpolation between two samples
    cache        the samples of one edge
    tree         frames, their caches, and the path from one to another
    failures     tf2's text for a failed lookup
    routes       cached paths, and when they are forgotten
    buffer       BufferCore: publish and look up
    validation   which transforms and names are accepted
    requests     callbacks when a transform becomes available
    velocity     linear and angular velocity of a frame
    describe     the tree in tf2's texts
    columns      the same arithmetic for many stamps at once
    batch        lookups at many stamps at once
    inspection   names, parents, histories, and a snapshot to draw

Behaviour, order of checks and texts are those of ROS 2's tf2 (geometry2 0.39.1).
It needs nothing but numpy. The list is the reading order.
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
from .inspection import FrameSnapshot, History, Memory, Snapshot
from .requests import NEVER, POSSIBLE_NOW
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
