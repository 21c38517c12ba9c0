"""Who listens?  A subscription, with a queue that forgets its oldest when it is full."""

from __future__ import annotations

import inspect
from collections import deque
from collections.abc import Callable
from typing import Any

from .entity import Entity, Kind
from .event_handler import reporter
from .messages import copy_message
from .network import SUBSCRIPTION_KIND, Envelope
from .qos import QoSProfile
from .serialization import serialize_message

__all__ = ["RawSubscription", "Subscription"]


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
