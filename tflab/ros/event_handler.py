"""Report incompatible QoS of endpoints, as rclpy.event_handler does.

    create_subscription(..., event_callbacks=SubscriptionEventCallbacks(incompatible_qos=callback))

    publisher offers too little  -->  callback(info), when the executor comes to it    instead of the warning in the log

What else ROS 2 reports (a missed deadline, a lost message ...) is refused: here nobody would ever report it.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from .entity import Entity, Kind
from .exceptions import RCLError
from .qos_compatibility import QoSPolicyKind

__all__ = [
    "EventHandler",
    "PublisherEventCallbacks",
    "QoSRequestedIncompatibleQoSInfo",
    "SubscriptionEventCallbacks",
    "UnsupportedEventTypeError",
    "reporter",
]

Callback = Callable[[Any], Any] | None


class UnsupportedEventTypeError(RCLError):
    """Nobody reports such an event here."""


@dataclass(frozen=True, slots=True)
class QoSRequestedIncompatibleQoSInfo:
    """What a callback is told: how often so far, how many of them new, and which policy did not fit the last time."""

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
    """Return who is to be told that a policy does not fit: a callback of the user's, `warn`, or nobody."""
    if callbacks is not None and callbacks.incompatible_qos is not None:
        return EventHandler(node, callbacks.incompatible_qos, group).report
    if callbacks is not None and not callbacks.use_default_callbacks:
        return lambda policy: None
    return warn


def _refuse_others(callbacks: Any, events: tuple[str, ...]) -> None:
    for event in events:
        if getattr(callbacks, event) is not None:
            raise UnsupportedEventTypeError(
                f"nobody reports the event '{event}' in the in-process ROS 2; what can be reported is incompatible_qos"
            )
