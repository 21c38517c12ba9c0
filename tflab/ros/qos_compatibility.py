"""Check whether the QoS of a publisher satisfies a subscription, and report where it does not.

    create_subscription(..., event_callbacks=SubscriptionEventCallbacks(incompatible_qos=callback))

If the offer is less than the request, the two are not connected. Each side then calls
its event callback from the executor, or logs a warning if it has none. The other
events of ROS 2 (a missed deadline, a lost message) never occur here, so requests for
them are refused.
"""

from __future__ import annotations

import warnings
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum
from typing import Any

from . import distro
from .entity import Entity, Kind
from .exceptions import RCLError
from .qos import DurabilityPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from .time import Duration

__all__ = [
    "EventHandler",
    "PublisherEventCallbacks",
    "QoSCompatibility",
    "QoSPolicyKind",
    "QoSRequestedIncompatibleQoSInfo",
    "SubscriptionEventCallbacks",
    "UnsupportedEventTypeError",
    "incompatible_policy",
    "qos_check_compatible",
    "qos_policy_name_from_kind",
    "reporter",
    "warn_of_qos_event",
]


OPEN = ("SYSTEM_DEFAULT", "UNKNOWN")  # a value that leaves the decision to others
ZERO = Duration()  # a span of zero means: no limit


class QoSCompatibility(IntEnum):
    """Whether a publisher and a subscription are connected."""

    OK = 0
    WARNING = 1
    ERROR = 2


class QoSPolicyKind(IntEnum):
    """Which policy an event is about."""

    INVALID = 1
    DURABILITY = 2
    DEADLINE = 4
    LIVELINESS = 8
    RELIABILITY = 16
    HISTORY = 32
    LIFESPAN = 64


def qos_policy_name_from_kind(policy_kind: QoSPolicyKind | int) -> str:
    """Return what a policy is called in logs, in this distribution."""
    return f"{QoSPolicyKind(policy_kind).name}{distro.current().policy_suffix}"


def incompatible_policy(offered: QoSProfile, requested: QoSProfile) -> str | None:
    """Return the last policy for which less is offered than requested, or None if the two fit."""
    last = None
    if requested.is_latched and not offered.is_latched:
        last = "DURABILITY"
    if requested.deadline != ZERO and not ZERO < offered.deadline <= requested.deadline:
        last = "DEADLINE"
    if requested.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC != offered.liveliness or (
        requested.liveliness_lease_duration != ZERO
        and not ZERO < offered.liveliness_lease_duration <= requested.liveliness_lease_duration
    ):
        last = "LIVELINESS"
    if (
        requested.reliability in (ReliabilityPolicy.RELIABLE, ReliabilityPolicy.SYSTEM_DEFAULT)
        and offered.reliability == ReliabilityPolicy.BEST_EFFORT
    ):
        last = "RELIABILITY"
    return last


def qos_check_compatible(publisher_qos: QoSProfile, subscription_qos: QoSProfile) -> tuple[QoSCompatibility, str]:
    """Return whether the two fit, and why not; a policy that is left open gives a warning."""
    reasons = _errors(publisher_qos, subscription_qos)
    if reasons:
        return QoSCompatibility.ERROR, "".join(f"ERROR: {reason};" for reason in reasons)
    reasons = _warnings(publisher_qos, subscription_qos)
    if reasons:
        return QoSCompatibility.WARNING, "".join(f"WARNING: {reason};" for reason in reasons)
    return QoSCompatibility.OK, ""


def _errors(offered: QoSProfile, requested: QoSProfile) -> list[str]:
    reasons = []
    if offered.reliability == ReliabilityPolicy.BEST_EFFORT and requested.reliability == ReliabilityPolicy.RELIABLE:
        reasons.append("Best effort publisher and reliable subscription")
    if offered.durability == DurabilityPolicy.VOLATILE and requested.is_latched:
        reasons.append("Volatile publisher and transient local subscription")
    if requested.deadline != ZERO:
        if offered.deadline == ZERO:
            reasons.append("Subscription has a deadline, but publisher does not")
        elif offered.deadline > requested.deadline:
            reasons.append("Subscription deadline is less than publisher deadline")
    if offered.liveliness == LivelinessPolicy.AUTOMATIC and requested.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC:
        reasons.append("Publisher's liveliness is automatic and subscription's is manual by topic")
    if requested.liveliness_lease_duration != ZERO:
        if offered.liveliness_lease_duration == ZERO:
            reasons.append("Subscription has a liveliness lease duration, but publisher does not")
        elif offered.liveliness_lease_duration > requested.liveliness_lease_duration:
            reasons.append("Subscription liveliness lease duration is less than publisher")
    return reasons


def _warnings(offered: QoSProfile, requested: QoSProfile) -> list[str]:
    """Return what may go wrong because a side leaves a policy open; rmw's words, its slip included."""
    return [
        *_warnings_of(
            (offered.reliability, requested.reliability),
            ("BEST_EFFORT", "Best effort publisher, but subscription is"),
            ("RELIABLE", "Reliable subscription, but publisher is"),
            "Publisher reliability is {} and subscription reliability is {}",
        ),
        *_warnings_of(
            (offered.durability, requested.durability),
            ("VOLATILE", "Volatile publisher, but subscription is"),
            ("TRANSIENT_LOCAL", "Transient local subscription, but publisher is"),
            "Publisher durabilty is {} and subscription durability is {}",
        ),
        *_warnings_of(
            (offered.liveliness, requested.liveliness),
            ("AUTOMATIC", "Publisher's liveliness is automatic, but subscription's is"),
            ("MANUAL_BY_TOPIC", "Subscription's liveliness is manual by topic, but publisher's is"),
            "Publisher liveliness is {} and subscription liveliness is {}",
        ),
    ]


def _warnings_of(
    sides: tuple[IntEnum, IntEnum], least_offer: tuple[str, str], highest_request: tuple[str, str], both: str
) -> list[str]:
    """Return the warning of one policy; a pair is a value, and what to say if the other side is open."""
    offered, requested = (side.name for side in sides)
    if offered in OPEN and requested in OPEN:
        return [both.format(offered.lower(), requested.lower())]
    if offered in OPEN and requested == highest_request[0]:
        return [f"{highest_request[1]} {offered.lower()}"]
    if offered == least_offer[0] and requested in OPEN:
        return [f"{least_offer[1]} {requested.lower()}"]
    return []


Callback = Callable[[Any], Any] | None


class UnsupportedEventTypeError(RCLError):
    """Nobody reports such an event here."""


@dataclass(frozen=True, slots=True)
class QoSRequestedIncompatibleQoSInfo:
    """What an event callback receives: the total count, the new ones, and the last incompatible policy."""

    total_count: int
    total_count_change: int
    last_policy_kind: int


@dataclass(kw_only=True)
class PublisherEventCallbacks:
    """`incompatible_qos(info)` is called when a subscription requests more than is offered.

    Raises:
        UnsupportedEventTypeError: a callback for anything else.
    """

    deadline: Callback = None
    liveliness: Callback = None
    incompatible_qos: Callback = None
    incompatible_type: Callback = None
    matched: Callback = None
    use_default_callbacks: bool = True

    def __post_init__(self) -> None:
        _refuse_others(self, ("deadline", "liveliness", "incompatible_type", "matched"))


@dataclass(kw_only=True)
class SubscriptionEventCallbacks:
    """`incompatible_qos(info)` is called when a publisher offers less than is requested.

    Raises:
        UnsupportedEventTypeError: a callback for anything else.
    """

    deadline: Callback = None
    incompatible_qos: Callback = None
    liveliness: Callback = None
    message_lost: Callback = None
    incompatible_type: Callback = None
    matched: Callback = None
    use_default_callbacks: bool = True

    def __post_init__(self) -> None:
        _refuse_others(self, ("deadline", "liveliness", "message_lost", "incompatible_type", "matched"))


class EventHandler(Entity):
    """Calls back with each event of one endpoint, in its turn among the callbacks of the node."""

    kind = Kind.WAITABLE

    def __init__(self, node: Any, callback: Callable[[Any], Any], callback_group: Any) -> None:
        super().__init__(node, callback_group)
        self.callback = callback
        self._infos: deque[QoSRequestedIncompatibleQoSInfo] = deque()
        self._count = 0

    def report(self, policy: str) -> None:
        """Note that another endpoint does not fit."""
        self._count += 1
        self._infos.append(QoSRequestedIncompatibleQoSInfo(self._count, 1, int(QoSPolicyKind[policy])))
        self.mark_ready()

    def is_pending(self) -> bool:
        return bool(self._infos)

    def take(self) -> Callable[[], Any]:
        info = self._infos.popleft()
        return lambda: self.callback(info)


def reporter(
    node: Any, callbacks: PublisherEventCallbacks | SubscriptionEventCallbacks | None, group: Any, warn: Callable
) -> Callable[[str], Any]:
    """Return the callback for incompatible policies: the user's, `warn`, or None."""
    if callbacks is not None and callbacks.incompatible_qos is not None:
        return EventHandler(node, callbacks.incompatible_qos, group).report
    if callbacks is not None and not callbacks.use_default_callbacks:
        return lambda policy: None
    return warn


def warn_of_qos_event() -> None:
    """Warn of the import of `rclpy.qos_event`, unless the release has no other module of the events."""
    if distro.has_name("rclpy.event_handler"):
        warnings.warn("importing 'qos_event' is deprecated; import 'event_handler' instead", stacklevel=2)


def _refuse_others(callbacks: Any, events: tuple[str, ...]) -> None:
    for event in events:
        if getattr(callbacks, event) is not None:
            raise UnsupportedEventTypeError(
                f"nobody reports the event '{event}' in the in-process ROS 2; what can be reported is incompatible_qos"
            )
