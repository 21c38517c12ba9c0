"""Deliver messages from publishers to subscriptions, with delay, jitter and loss.

    publisher --copy--> [stored samples] --> disturbance: delay, jitter, loss --> subscription's queue

What travels is an *envelope*: a message, who sent it and when (DDS calls it a
sample).  A publisher and a subscription are connected when topic and type agree and the
offered quality of service is not less than the requested one; otherwise both say
so in their logs.  Publishing makes one copy; each receiver's callback gets its
own, except tf2's listeners, which share one decoded message because they only
read it.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import count
from typing import Any
from weakref import WeakKeyDictionary

from tflab.core import StampedTransform

from .convert import msg_from_stamped, stamped_from_msg, stampeds_from_plain_msgs
from .messages import copy_message
from .messages.base import ros_type_of
from .messages.tf2_msgs import TFMessage
from .qos_compatibility import incompatible_policy

__all__ = ["PUBLISHER_KIND", "SUBSCRIPTION_KIND", "Disturbance", "Envelope", "Network", "Topic"]

# An endpoint's identity as Fast DDS makes it: its last byte says which kind it is, writer or reader without a key.
PUBLISHER_KIND, SUBSCRIPTION_KIND = 0x03, 0x04
VENDOR_AND_HOST = bytes([0x01, 0x0F, 0x2A, 0xE5])
FIRST_PROCESS, SCATTERED = 0x57CB, 0x9E37


class Envelope:
    """One published message on its way.

    Attributes:
        publisher: who sent it.
        sent_ns: when [ns].
        number: which one of its publisher, from 1.
    """

    __slots__ = ("_message", "_stampeds", "number", "publisher", "sent_ns")

    def __init__(self, message: Any, publisher: Any, sent_ns: int, number: int) -> None:
        self.publisher = publisher
        self.sent_ns = sent_ns
        self.number = number
        self._stampeds = stampeds_from_plain_msgs(message.transforms) if type(message) is TFMessage else None
        self._message = copy_message(message) if self._stampeds is None else None

    @property
    def message(self) -> Any:
        """The message as it was when it was published; receivers must not change it."""
        if self._message is None:
            self._message = TFMessage(transforms=[msg_from_stamped(stamped) for stamped in self._stampeds])
        return self._message

    @property
    def stampeds(self) -> list[StampedTransform]:
        """Of a tf2_msgs/TFMessage, the engine's values: decoded once for all who listen."""
        if self._stampeds is None:
            self._stampeds = [stamped_from_msg(msg) for msg in self._message.transforms]
        return self._stampeds


@dataclass
class Disturbance:
    """What lies between the publishers and the subscriptions of a topic.

    Attributes:
        delay_ns: every message takes this long [ns] ...
        jitter_ns: ... and up to this much longer, evenly spread [ns]; order is kept.
        loss: the share of messages that never arrive, 0 to 1.
        random: where jitter and loss come from.
    """

    delay_ns: int
    jitter_ns: int
    loss: float
    random: random.Random
    _last_arrival_ns: dict[tuple[int, int], int] = field(default_factory=dict)

    def carry(self, envelope: Envelope, subscription: Any, driver: Any) -> None:
        """Deliver an envelope, late or never."""
        if self.random.random() < self.loss:
            return
        arrival_ns = envelope.sent_ns + self.delay_ns + round(self.random.random() * self.jitter_ns)
        pair = (id(envelope.publisher), id(subscription))
        arrival_ns = max(arrival_ns, self._last_arrival_ns.get(pair, 0))
        self._last_arrival_ns[pair] = arrival_ns
        driver.call_after(arrival_ns - envelope.sent_ns, lambda: subscription.put(envelope))


class Topic:
    """A name, and who uses it."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.publishers: list[Any] = []
        self.subscriptions: list[Any] = []
        self.disturbance: Disturbance | None = None

    def add_publisher(self, publisher: Any) -> None:
        """Connect a new publisher to whoever is there."""
        self.publishers.append(publisher)
        for subscription in self.subscriptions:
            self._connect(publisher, subscription)

    def add_subscription(self, subscription: Any) -> None:
        """Connect a new subscription to whoever is there, and give it what was stored for latecomers."""
        self.subscriptions.append(subscription)
        for publisher in self.publishers:
            self._connect(publisher, subscription)

    def remove_publisher(self, publisher: Any) -> None:
        """Forget a publisher, and what it had stored."""
        self.publishers.remove(publisher)
        for subscription in publisher.matched:
            subscription.matched_count -= 1
            subscription.on_matched(-1)

    def remove_subscription(self, subscription: Any) -> None:
        """Forget a subscription."""
        self.subscriptions.remove(subscription)
        for publisher in self.publishers:
            if subscription in publisher.matched:
                publisher.matched.remove(subscription)
                publisher.on_matched(-1)

    def deliver(self, envelope: Envelope, subscription: Any, driver: Any) -> None:
        """Send an envelope on its way."""
        if self.disturbance is None:
            subscription.put(envelope)
        else:
            self.disturbance.carry(envelope, subscription, driver)

    def _connect(self, publisher: Any, subscription: Any) -> None:
        if publisher.msg_type is not subscription.msg_type:
            return
        policy = incompatible_policy(publisher.qos_profile, subscription.qos_profile)
        if policy is not None:
            subscription.on_incompatible_qos(policy)
            publisher.on_incompatible_qos(policy)
            return
        publisher.matched.append(subscription)
        subscription.matched_count += 1
        publisher.on_matched(1)
        subscription.on_matched(1)
        if subscription.qos_profile.is_latched:
            stored = publisher.stored_envelopes()
            for envelope in stored[-(subscription.qos_profile.capacity or len(stored)) :]:
                subscription.put(envelope)


class Network:
    """Every topic, service and node of a graph, as discovery would find them."""

    def __init__(self) -> None:
        self.topics: dict[str, Topic] = {}
        self.services: dict[str, list[Any]] = {}
        self.clients: dict[str, list[Any]] = {}
        self.nodes: list[Any] = []
        self._endpoints = 0
        self._processes: WeakKeyDictionary[Any, int] = WeakKeyDictionary()
        self._new_process = count(FIRST_PROCESS, 17)

    def topic(self, name: str) -> Topic:
        """Return the topic of that absolute name, new if need be."""
        if name not in self.topics:
            self.topics[name] = Topic(name)
        return self.topics[name]

    def new_gid(self, context: Any, kind: int) -> bytes:
        """Return the next endpoint's identity: 16 bytes in the form of Fast DDS, counted up so that they repeat.

        Vendor, host, process and its start, participant (one to a context); then the endpoint's number, and its kind.
        """
        if context not in self._processes:
            self._processes[context] = next(self._new_process) % 2**16
        process, start = self._processes[context], self._processes[context] * SCATTERED % 2**16
        self._endpoints += 1
        prefix = VENDOR_AND_HOST + process.to_bytes(2, "big") + start.to_bytes(2, "big") + bytes(4)
        return prefix + self._endpoints.to_bytes(3, "big") + bytes([kind])

    def topic_names_and_types(self, keep: Callable[[Any], bool] = lambda endpoint: True) -> list[tuple[str, list[str]]]:
        """Return (topic, its types) for each topic that has an endpoint, sorted by name."""
        found = []
        for name, topic in sorted(self.topics.items()):
            types = {ros_type_of(end.msg_type) for end in (*topic.publishers, *topic.subscriptions) if keep(end)}
            if types:
                found.append((name, sorted(types)))
        return found

    def service_names_and_types(
        self, keep: Callable[[Any], bool] = lambda service: True, clients: bool = False
    ) -> list[tuple[str, list[str]]]:
        """Return (service, its types) for each service, or each that has a client, sorted by name."""
        found = []
        for name, ends in sorted((self.clients if clients else self.services).items()):
            types = {ros_type_of(end.srv_type) for end in ends if keep(end)}
            if types:
                found.append((name, sorted(types)))
        return found
