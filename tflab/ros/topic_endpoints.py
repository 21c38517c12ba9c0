"""Provide publishers, and subscriptions with a bounded queue."""

from __future__ import annotations

import inspect
from collections import deque
from collections.abc import Callable
from typing import Any

from .entity import Entity, Kind
from .exceptions import InvalidHandle, RCLError
from .messages import copy_message, tf2_msgs
from .messages.values import deserialize_message, serialize_message
from .network import PUBLISHER_KIND, SUBSCRIPTION_KIND, Envelope
from .qos import QoSProfile
from .qos_compatibility import matched_reporter, reporter

__all__ = ["Publisher", "RawSubscription", "Subscription"]


class Publisher:
    """Sends messages of one type to one topic.

    Attributes:
        gid: its identity in the graph, 16 bytes.
        matched: the subscriptions that hear it.
        edges: (parent, child) -> how often; of the transforms it has sent, if that is what it sends.
    """

    endpoint_type = "PUBLISHER"

    def __init__(
        self, node: Any, msg_type: type, topic: str, qos_profile: QoSProfile, event_callbacks: Any, callback_group: Any
    ) -> None:
        self.node = node
        self.msg_type = msg_type
        self.topic_name = topic
        self.topic = topic
        self.qos_profile = qos_profile
        self.callback_group = callback_group
        self.gid = node.network.new_gid(node.context, PUBLISHER_KIND)
        self.matched: list[Any] = []
        self.edges: dict[tuple[str, str], int] = {}
        self._sends_transforms = msg_type is tf2_msgs.TFMessage
        self.on_incompatible_qos = reporter(node, event_callbacks, callback_group, self._warn_of)
        self.on_matched = matched_reporter(node, event_callbacks, callback_group)
        self._driver = node.context.process.driver
        self._stored: deque[Envelope] | None = deque(maxlen=qos_profile.capacity) if qos_profile.is_latched else None
        self._count = 0
        self._is_destroyed = False
        self._topic = node.network.topic(topic)
        self._topic.add_publisher(self)

    def publish(self, msg: Any) -> None:
        """Send a copy of a message, or one that is serialized; the caller may change it afterwards.

        Raises:
            TypeError: not a message of the topic's type.
            AssertionError: a field holds what cannot be sent.
            RCLError: its context has ended, as after Ctrl-C.
        """
        if self._is_destroyed:
            raise InvalidHandle("cannot use Destroyable because destruction was requested")
        if not self.node.context.ok():
            raise RCLError("Failed to publish: publisher's context is invalid, at ./src/rcl/publisher.c:389")
        if isinstance(msg, bytes):
            msg = deserialize_message(msg, self.msg_type)
        if not isinstance(msg, self.msg_type):
            raise TypeError(f"Expected {self.msg_type}, got {type(msg)}")
        self._count += 1
        envelope = Envelope(msg, self, self._driver.now_ns(), self._count)
        if self._sends_transforms:
            for stamped in envelope.stampeds:
                edge = (stamped.frame_id, stamped.child_frame_id)
                self.edges[edge] = self.edges.get(edge, 0) + 1
        if self._stored is not None:
            self._stored.append(envelope)
        deliver, driver = self._topic.deliver, self._driver
        for subscription in tuple(self.matched):
            deliver(envelope, subscription, driver)

    def stored_envelopes(self) -> list[Envelope]:
        """Return what a latecomer gets."""
        if not self._stored:
            return []
        lifespan_ns = self.qos_profile.lifespan.nanoseconds
        now_ns = self._driver.now_ns()
        return [envelope for envelope in self._stored if not lifespan_ns or now_ns - envelope.sent_ns <= lifespan_ns]

    def get_subscription_count(self) -> int:
        """Return how many subscriptions it is connected to."""
        return len(self.matched)

    def wait_for_all_acked(self, timeout: Any = None) -> bool:
        """Return True: what was published has arrived, or is lost."""
        return True

    def assert_liveliness(self) -> None:
        """Say that it is alive; nobody doubts it here."""

    def _warn_of(self, policy: str) -> None:
        self.node.get_logger().warning(
            f"New subscription discovered on topic '{self.topic_name}', requesting incompatible QoS. No messages will "
            f"be sent to it. Last incompatible policy: {self.node.policy_name(policy)}"
        )

    def destroy(self) -> None:
        """Leave the topic; what was stored for latecomers is gone."""
        if not self._is_destroyed:
            self._is_destroyed = True
            self._topic.remove_publisher(self)

    def __enter__(self) -> Publisher:
        return self

    def __exit__(self, *exc: object) -> None:
        self.destroy()


class Subscription(Entity):
    """Calls back with each message of one type from one topic."""

    kind = Kind.SUBSCRIPTION
    endpoint_type = "SUBSCRIPTION"

    def __init__(
        self,
        node: Any,
        msg_type: type,
        topic: str,
        callback: Callable[..., Any],
        qos_profile: QoSProfile,
        event_callbacks: Any,
        callback_group: Any,
    ) -> None:
        super().__init__(node, callback_group)
        self.msg_type = msg_type
        self.topic_name = topic
        self.qos_profile = qos_profile
        self.gid = node.network.new_gid(node.context, SUBSCRIPTION_KIND)
        self.matched_count = 0
        self.callback = callback
        self._wants_info = _wants_info(callback)
        self.on_incompatible_qos = reporter(node, event_callbacks, callback_group, self._warn_of)
        self.on_matched = matched_reporter(node, event_callbacks, callback_group)
        self._driver = node.context.process.driver
        self._queue: deque[tuple[Envelope, int]] = deque(maxlen=qos_profile.capacity)
        self._received = 0
        self._topic = node.network.topic(topic)
        self._topic.add_subscription(self)

    def put(self, envelope: Envelope) -> None:
        """Receive an envelope; the oldest one is forgotten if the queue is full."""
        if not self.is_destroyed:
            self._queue.append((envelope, self._driver.now_ns()))
            self.mark_ready()

    def is_pending(self) -> bool:
        return bool(self._queue)

    def take(self) -> Callable[[], Any]:
        envelope, received_ns = self._queue.popleft()
        self._received += 1
        return lambda: self.call(envelope, received_ns)

    def call(self, envelope: Envelope, received_ns: int) -> Any:
        """Call back with a message of the receiver's own."""
        message = self._message_of(envelope)
        if not self._wants_info:
            return self.callback(message)
        info = {
            "source_timestamp": envelope.sent_ns,
            "received_timestamp": received_ns,
            "publication_sequence_number": envelope.number,
            "reception_sequence_number": self._received,
            "publisher_gid": envelope.publisher.gid,
        }
        return self.callback(message, info)

    def _message_of(self, envelope: Envelope) -> Any:
        return copy_message(envelope.message)

    def get_publisher_count(self) -> int:
        """Return how many publishers it is connected to."""
        return self.matched_count

    def _warn_of(self, policy: str) -> None:
        self.node.get_logger().warning(
            f"New publisher discovered on topic '{self.topic_name}', offering incompatible QoS. No messages will be "
            f"received from it. Last incompatible policy: {self.node.policy_name(policy)}"
        )

    def destroy(self) -> None:
        """Leave the topic."""
        if not self.is_destroyed:
            self._topic.remove_subscription(self)
            self._queue.clear()
        super().destroy()


class RawSubscription(Subscription):
    """Calls back with bytes, as they are on the wire."""

    def _message_of(self, envelope: Envelope) -> bytes:
        return serialize_message(envelope.message)


def _wants_info(callback: Callable[..., Any]) -> bool:
    """Return whether a callback takes (message, info); else it takes (message)."""
    try:
        signature = inspect.signature(callback)
    except (TypeError, ValueError):
        return False
    for count in (1, 2):
        try:
            signature.bind(*[None] * count)
        except TypeError:
            continue
        return count == 2
    raise RuntimeError(
        "Subscription.__init__(): callback should be either be callable with one argument (to get only the message) "
        "or two arguments (to get message and message info)"
    )
