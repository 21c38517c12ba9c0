"""Create, list and destroy the publishers, subscriptions, timers, services and clients of a node.

One of the three mixins that Node is made of; see node.py for the other two.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from tflab.core import NSEC_PER_SEC

from . import distro
from .clock import Clock
from .context import Context
from .entity import CallbackGroup, GuardCondition, MutuallyExclusiveCallbackGroup
from .exceptions import NoTypeSupportImportedException
from .messages.base import is_message_class, is_service_class
from .qos import QoSProfile, profile_from, qos_profile_services_default
from .service import Client, Service
from .timer import Rate, Timer
from .topic_endpoints import Publisher, RawSubscription, Subscription

__all__ = ["NodeEntities", "check_type"]


class NodeEntities:
    """The part of Node that makes and destroys what can become ready.

    Borrows of Node: `_topic_named(name)`, which completes a name as the node means it; `_clock`, for timers;
    `_context`, for rates; `_default_callback_group`; and `executor`, to be woken.
    """

    _clock: Clock
    _context: Context
    _default_callback_group: CallbackGroup

    def _init_entities(self) -> None:
        self.timer_list: list[Timer] = []
        self._entities: dict[str, list[Any]] = {kind: [] for kind in _KINDS}

    @property
    def publishers(self) -> Iterator[Publisher]:
        """Its publishers."""
        yield from self._entities["publisher"]

    @property
    def subscriptions(self) -> Iterator[Subscription]:
        """Its subscriptions."""
        yield from self._entities["subscription"]

    @property
    def clients(self) -> Iterator[Client]:
        """Its clients."""
        yield from self._entities["client"]

    @property
    def services(self) -> Iterator[Service]:
        """Its services."""
        yield from self._entities["service"]

    @property
    def timers(self) -> Iterator[Timer]:
        """Its timers."""
        yield from self.timer_list

    @property
    def guards(self) -> Iterator[GuardCondition]:
        """Its guard conditions."""
        yield from self._entities["guard"]

    @property
    def waitables(self) -> Iterator[Any]:
        """Nothing: what rclpy keeps here does not exist in one process."""
        yield from ()

    # -- what it makes ------------------------------------------------------------------

    def create_publisher(
        self,
        msg_type: type,
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: Any = None,
        publisher_class: type[Publisher] = Publisher,
    ) -> Publisher:
        """Return a new publisher.

        Raises:
            InvalidTopicNameException: a malformed name.
            NoTypeSupportImportedException: not a message type.
            TypeError, ValueError: not a quality of service.
        """
        qos = profile_from(qos_profile)
        check_type(msg_type, is_message_class, "a message")
        group = callback_group or self._default_callback_group
        publisher = publisher_class(self, msg_type, self._topic_named(topic), qos, event_callbacks, group)
        self._entities["publisher"].append(publisher)
        return publisher

    def create_subscription(
        self,
        msg_type: type,
        topic: str,
        callback: Callable[..., Any],
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: Any = None,
        raw: bool = False,
        subscription_class: type[Subscription] = Subscription,
    ) -> Subscription:
        """Return a new subscription; the callback takes (message) or (message, info), with `raw` bytes for a message.

        Raises:
            as create_publisher.
        """
        qos = profile_from(qos_profile)
        check_type(msg_type, is_message_class, "a message")
        group = callback_group or self._default_callback_group
        name = self._topic_named(topic)
        subscription_class = RawSubscription if raw else subscription_class
        subscription = subscription_class(self, msg_type, name, callback, qos, event_callbacks, group)
        self._entities["subscription"].append(subscription)
        return subscription

    def create_timer(
        self,
        timer_period_sec: float,
        callback: Callable[..., Any] | None,
        callback_group: CallbackGroup | None = None,
        clock: Clock | None = None,
        autostart: bool | None = None,
    ) -> Timer:
        """Return a timer that calls back every `timer_period_sec` [s] of `clock`, the node's own if None."""
        if autostart is not None:
            text = "Node.create_timer() got an unexpected keyword argument 'autostart'"
            distro.require("timer_takes_autostart", TypeError, text)
        period_ns = int(float(timer_period_sec) * NSEC_PER_SEC)
        if period_ns < 0:
            raise ValueError(f"the period of a timer cannot be negative: {timer_period_sec}")
        group = callback_group or self._default_callback_group
        timer = Timer(self, callback, group, period_ns, clock or self._clock, autostart is not False)
        self.timer_list.append(timer)
        self._wake_executor()
        return timer

    def create_service(
        self,
        srv_type: type,
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Service:
        """Return a new service; the callback, plain or async, takes (request, response) and returns the response."""
        check_type(srv_type, is_service_class, "a service")
        name = self._topic_named(srv_name, is_service=True)
        group = callback_group or self._default_callback_group
        service = Service(self, srv_type, name, callback, qos_profile, group)
        self._entities["service"].append(service)
        return service

    def create_client(
        self,
        srv_type: type,
        srv_name: str,
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Client:
        """Return a new client of a service."""
        check_type(srv_type, is_service_class, "a service")
        name = self._topic_named(srv_name, is_service=True)
        client = Client(self, srv_type, name, qos_profile, callback_group or self._default_callback_group)
        self._entities["client"].append(client)
        return client

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Return something that sleeps `frequency` times a second [Hz]; another thread must spin the node.

        Raises:
            ValueError: not a positive frequency.
        """
        if frequency <= 0:
            raise ValueError("frequency must be > 0")
        timer = self.create_timer(1.0 / frequency, None, MutuallyExclusiveCallbackGroup(), clock)
        return Rate(timer, self._context)

    def create_guard_condition(
        self, callback: Callable[[], Any], callback_group: CallbackGroup | None = None
    ) -> GuardCondition:
        """Return something that can be triggered by hand."""
        guard = GuardCondition(self, callback, callback_group or self._default_callback_group)
        self._entities["guard"].append(guard)
        return guard

    # -- what it destroys -----------------------------------------------------------------

    def destroy_publisher(self, publisher: Publisher) -> bool:
        """Destroy a publisher of this node; return whether it was one."""
        return self._destroy(self._entities["publisher"], publisher)

    def destroy_subscription(self, subscription: Subscription) -> bool:
        """Destroy a subscription of this node; return whether it was one."""
        return self._destroy(self._entities["subscription"], subscription)

    def destroy_client(self, client: Client) -> bool:
        """Destroy a client of this node; return whether it was one."""
        return self._destroy(self._entities["client"], client)

    def destroy_service(self, service: Service) -> bool:
        """Destroy a service of this node; return whether it was one."""
        return self._destroy(self._entities["service"], service)

    def destroy_timer(self, timer: Timer) -> bool:
        """Destroy a timer of this node; return whether it was one."""
        return self._destroy(self.timer_list, timer)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """Destroy a guard condition of this node; return whether it was one."""
        return self._destroy(self._entities["guard"], guard)

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a rate of this node; return whether it was one."""
        found = self.destroy_timer(rate._timer)
        rate.destroy()
        return found

    # -- inside -------------------------------------------------------------------------------

    def _destroy(self, entities: list, entity: Any) -> bool:
        if entity not in entities:
            return False
        entities.remove(entity)
        entity.destroy()
        self._wake_executor()
        return True

    def _wake_executor(self) -> None:
        if self.executor is not None:
            self.executor.wake()

    def _destroy_entities(self) -> None:
        for entities in (*self._entities.values(), self.timer_list):
            while entities:
                entities.pop().destroy()


_KINDS = ("publisher", "subscription", "client", "service", "guard")


def check_type(given: object, is_one: Callable[[object], bool], what: str) -> None:
    """Raise NoTypeSupportImportedException unless something is the class of a message, a service or an action."""
    if not is_one(given):
        raise NoTypeSupportImportedException(
            f"Expected {what} type such as {_EXAMPLES[what]}, got {given!r}. Pass the class, not an object or a text"
        )


_EXAMPLES = {
    "a message": "geometry_msgs.msg.PointStamped",
    "a service": "tf2_msgs.srv.FrameGraph",
    "an action": "example_interfaces.action.Fibonacci",
}
