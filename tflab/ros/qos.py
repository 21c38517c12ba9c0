"""Define quality-of-service profiles and policies.

    publisher offers      subscription requests
    RELIABLE              RELIABLE, BEST_EFFORT       what is offered may be more,
    BEST_EFFORT           BEST_EFFORT                 but never less, than what
    TRANSIENT_LOCAL       TRANSIENT_LOCAL, VOLATILE   is requested
    VOLATILE              VOLATILE

TRANSIENT_LOCAL is why a late subscriber still receives /tf_static.
"""

from __future__ import annotations

import warnings
from enum import Enum, IntEnum
from typing import Any

from .time import Duration

__all__ = [
    "DurabilityPolicy",
    "HistoryPolicy",
    "InvalidQoSProfileException",
    "LivelinessPolicy",
    "QoSDurabilityPolicy",
    "QoSHistoryPolicy",
    "QoSLivelinessPolicy",
    "QoSPresetProfiles",
    "QoSProfile",
    "QoSReliabilityPolicy",
    "ReliabilityPolicy",
    "profile_from",
    "qos_profile_action_status_default",
    "qos_profile_best_available",
    "qos_profile_default",
    "qos_profile_parameter_events",
    "qos_profile_parameters",
    "qos_profile_rosout_default",
    "qos_profile_sensor_data",
    "qos_profile_services_default",
    "qos_profile_system_default",
    "qos_profile_unknown",
]


ZERO_DEPTH = (
    "A zero depth with KEEP_LAST doesn't make sense; no data could be stored. "
    "This will be interpreted as SYSTEM_DEFAULT"
)


class InvalidQoSProfileException(Exception):
    """A QoSProfile lacks something."""

    __module__ = "rclpy.qos"

    def __init__(self, *args: object) -> None:
        super().__init__("Invalid QoSProfile", *args)


class _Policy(IntEnum):
    @property
    def short_key(self) -> str:
        """The policy's name as the command line tools write it."""
        return self.name.lower()

    @classmethod
    def short_keys(cls) -> list[str]:
        """Return every name that the command line tools accept."""
        return [policy.short_key for policy in cls]

    @classmethod
    def get_from_short_key(cls, name: str) -> int:
        """Return the policy of such a name."""
        return cls[name.upper()].value


class HistoryPolicy(_Policy):
    """How many samples wait in a queue."""

    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3


class ReliabilityPolicy(_Policy):
    """Whether a lost sample is sent again."""

    SYSTEM_DEFAULT = 0
    RELIABLE = 1
    BEST_EFFORT = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class DurabilityPolicy(_Policy):
    """Whether those who come late get what was sent before."""

    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class LivelinessPolicy(_Policy):
    """Who says that a publisher is alive."""

    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5


class _OldName:
    """A policy under an older name, such as ReliabilityPolicy.RMW_QOS_POLICY_RELIABILITY_RELIABLE."""

    def __init__(self, old: str, new: str) -> None:
        self.old, self.new = old, new

    def __get__(self, _: Any, cls: type[_Policy]) -> _Policy:
        warnings.warn(f"{cls.__name__}.{self.old} is deprecated. Use {cls.__name__}.{self.new} instead.", stacklevel=2)
        return cls[self.new]


for _each in (*HistoryPolicy, *ReliabilityPolicy, *DurabilityPolicy, *LivelinessPolicy):
    _old = f"RMW_QOS_POLICY_{type(_each).__name__.removesuffix('Policy').upper()}_{_each.name}"
    setattr(type(_each), _old, _OldName(_old, _each.name))

QoSHistoryPolicy = HistoryPolicy
QoSReliabilityPolicy = ReliabilityPolicy
QoSDurabilityPolicy = DurabilityPolicy
QoSLivelinessPolicy = LivelinessPolicy


_ZERO = Duration()
_DEFAULTS = {
    "history": HistoryPolicy.SYSTEM_DEFAULT,
    "depth": 0,
    "reliability": ReliabilityPolicy.RELIABLE,
    "durability": DurabilityPolicy.VOLATILE,
    "lifespan": _ZERO,
    "deadline": _ZERO,
    "liveliness": LivelinessPolicy.SYSTEM_DEFAULT,
    "liveliness_lease_duration": _ZERO,
    "avoid_ros_namespace_conventions": False,
}


class QoSProfile:
    """One side's policies.  Give at least `depth`, or `history`.

    Attributes:
        history, depth: how many samples wait in a queue, and how many with KEEP_LAST.
        reliability: whether a lost sample is sent again.
        durability: whether those who come late get what was sent before.
        lifespan: how old a sample may get before it is dropped; zero for no limit.
        deadline: how long there may be between samples; zero for no limit.
        liveliness: who says that the publisher is alive.
        liveliness_lease_duration: how often it must be said; zero for no limit.
        avoid_ros_namespace_conventions: whether the name is used below ROS 2 without a prefix.
    """

    history: HistoryPolicy
    depth: int
    reliability: ReliabilityPolicy
    durability: DurabilityPolicy
    lifespan: Duration
    deadline: Duration
    liveliness: LivelinessPolicy
    liveliness_lease_duration: Duration
    avoid_ros_namespace_conventions: bool
    __slots__ = tuple(_DEFAULTS)
    __hash__ = None

    def __init__(self, **policies: object) -> None:
        unknown = sorted(set(policies) - set(_DEFAULTS))
        assert not unknown, f"Invalid arguments passed to constructor: {', '.join(unknown)}"
        if "history" not in policies:
            if "depth" not in policies:
                raise InvalidQoSProfileException("History and/or depth settings are required.")
            policies["history"] = HistoryPolicy.KEEP_LAST
        elif policies["history"] == HistoryPolicy.KEEP_LAST and "depth" not in policies:
            raise InvalidQoSProfileException("History set to KEEP_LAST without a depth setting.")
        for name in reversed(_DEFAULTS):  # the history last: a depth of 0 is judged here, once
            setattr(self, name, policies.get(name, _DEFAULTS[name]))
        if self.history == HistoryPolicy.KEEP_LAST and self.depth == 0 and "depth" in policies:
            warnings.warn(ZERO_DEPTH, stacklevel=2)

    def __setattr__(self, name: str, value: object) -> None:
        kind = type(_DEFAULTS.get(name, value))
        assert isinstance(value, (kind, int) if issubclass(kind, _Policy) else kind)
        if name == "depth" and value == 0 and getattr(self, "history", None) == HistoryPolicy.KEEP_LAST:
            warnings.warn(ZERO_DEPTH, stacklevel=2)
        object.__setattr__(self, name, kind(value) if issubclass(kind, _Policy) else value)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, QoSProfile):
            return False
        return all(getattr(self, name) == getattr(other, name) for name in self.__slots__)

    def __str__(self) -> str:
        values = {name: getattr(self, name) for name in _DEFAULTS}.items()
        shown = ", ".join(f"{name}={getattr(value, 'name', value)}" for name, value in values)
        return f"QoSProfile({shown})"

    __repr__ = __str__

    @property
    def is_latched(self) -> bool:
        """Whether it offers, or requests, what was sent before."""
        return self.durability == DurabilityPolicy.TRANSIENT_LOCAL

    @property
    def capacity(self) -> int | None:
        """How many samples a queue holds; None without a limit."""
        if self.history == HistoryPolicy.KEEP_ALL:
            return None
        return self.depth or SYSTEM_DEPTH


SYSTEM_DEPTH = 1


def profile_from(qos: QoSProfile | int) -> QoSProfile:
    """Return the profile that create_publisher or create_subscription was given.

    Raises:
        ValueError: a negative depth.
        TypeError: neither a profile nor a depth.
    """
    if isinstance(qos, QoSProfile):
        return qos
    if isinstance(qos, int):
        if qos < 0:
            raise ValueError("history depth must be greater than or equal to zero")
        return QoSProfile(depth=qos)
    raise TypeError(f"Expected QoSProfile or int, but received {type(qos)!r}")


# -- presets --------------------------------------------------------------------


def _preset(
    depth: int,
    reliability: ReliabilityPolicy = ReliabilityPolicy.RELIABLE,
    durability: DurabilityPolicy = DurabilityPolicy.VOLATILE,
    history: HistoryPolicy = HistoryPolicy.KEEP_LAST,
    lifespan: Duration = _ZERO,
) -> QoSProfile:
    return QoSProfile(history=history, depth=depth, reliability=reliability, durability=durability, lifespan=lifespan)


qos_profile_default = _preset(10)
qos_profile_sensor_data = _preset(5, ReliabilityPolicy.BEST_EFFORT)
qos_profile_services_default = _preset(10)
qos_profile_parameters = _preset(1000)
qos_profile_parameter_events = _preset(1000)
qos_profile_action_status_default = _preset(1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
qos_profile_rosout_default = _preset(1000, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=Duration(seconds=10))
qos_profile_system_default = _preset(
    0, ReliabilityPolicy.SYSTEM_DEFAULT, DurabilityPolicy.SYSTEM_DEFAULT, HistoryPolicy.SYSTEM_DEFAULT
)
qos_profile_unknown = _preset(0, ReliabilityPolicy.UNKNOWN, DurabilityPolicy.UNKNOWN, HistoryPolicy.UNKNOWN)
qos_profile_best_available = _preset(10, ReliabilityPolicy.BEST_AVAILABLE, DurabilityPolicy.BEST_AVAILABLE)


class QoSPresetProfiles(Enum):
    """Every preset, by name."""

    UNKNOWN = qos_profile_unknown
    DEFAULT = qos_profile_default
    SYSTEM_DEFAULT = qos_profile_system_default
    SENSOR_DATA = qos_profile_sensor_data
    SERVICES_DEFAULT = qos_profile_services_default
    PARAMETERS = qos_profile_parameters
    PARAMETER_EVENTS = qos_profile_parameter_events
    ACTION_STATUS_DEFAULT = qos_profile_action_status_default
    BEST_AVAILABLE = qos_profile_best_available
    ROSOUT_DEFAULT = qos_profile_rosout_default

    @classmethod
    def short_keys(cls) -> list[str]:
        """Return every name that the command line tools accept."""
        return [preset.name.lower() for preset in cls]

    @classmethod
    def get_from_short_key(cls, name: str) -> QoSProfile:
        """Return the profile of such a name."""
        return cls[name.upper()].value
