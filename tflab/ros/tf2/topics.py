"""Publish transforms and store received transforms: tf2_ros's broadcasters and listeners.

    TransformBroadcaster         -->  /tf         reliable, depth 100
    StaticTransformBroadcaster   -->  /tf_static  reliable, transient local
    /tf          -->  TransformListener  -->  set_transform          as "default_authority"
    /tf_static   -->  TransformListener  -->  set_transform_static

A late listener receives the last message of each static broadcaster, so a static
broadcaster repeats in it what it sent before. How completely depends on the
distribution (distro.py). The publisher of a transform is not part of the message, so
the authority is always the same, "Authority undetectable" in a program in C++.
"""

from __future__ import annotations

import threading
import weakref
from collections.abc import Iterable
from typing import Any

from .. import distro
from ..entity import ReentrantCallbackGroup
from ..executors import ExternalShutdownException, SingleThreadedExecutor
from ..messages import copy_message, geometry_msgs, tf2_msgs
from ..network import Envelope
from ..qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from ..topic_endpoints import Subscription
from .buffer import Buffer

__all__ = [
    "DEFAULT_STATIC_TF_TOPIC",
    "DEFAULT_TF_TOPIC",
    "StaticTransformBroadcaster",
    "StaticTransformListener",
    "TransformBroadcaster",
    "TransformListener",
]


DEFAULT_TF_TOPIC = "/tf"
DEFAULT_STATIC_TF_TOPIC = "/tf_static"


class _TFSubscription(Subscription):
    """Hands an envelope over as it is: listeners read one decoded message together."""

    def call(self, envelope: Envelope, received_ns: int) -> None:
        self.callback(envelope)


class TransformListener:
    """Fills a buffer with what is published.

    Args:
        spin_thread: whether a thread of its own runs the callbacks of the *whole* node.
        qos, static_qos: profiles, or depths, instead of those above.
    """

    authority = "default_authority"

    def __init__(
        self,
        buffer: Buffer,
        node: Any,
        *,
        spin_thread: bool = False,
        qos: QoSProfile | int | None = None,
        static_qos: QoSProfile | int | None = None,
        tf_topic: str | None = None,
        tf_static_topic: str | None = None,
    ) -> None:
        if tf_topic is not None or tf_static_topic is not None:
            refused = "tf_static_topic" if tf_topic is None else "tf_topic"
            text = f"TransformListener.__init__() got an unexpected keyword argument '{refused}'"
            distro.require("listener_takes_topics", TypeError, text)
        self._begin(buffer, node)
        self.tf_sub = self._subscribe(tf_topic or DEFAULT_TF_TOPIC, _profile() if qos is None else qos, is_static=False)
        self._subscribe_static(tf_static_topic or DEFAULT_STATIC_TF_TOPIC, static_qos)
        if spin_thread:
            self._spin_in_thread()

    def _begin(self, buffer: Buffer, node: Any) -> None:
        self.buffer = buffer
        self.node = node
        # Reentrant, so that transforms arrive while a callback of the node waits for one.
        self.group = ReentrantCallbackGroup()
        self.executor: SingleThreadedExecutor | None = None
        self.tf_sub: Subscription | None = None

    def _subscribe_static(self, topic: str, qos: QoSProfile | int | None) -> None:
        latched = _profile(DurabilityPolicy.TRANSIENT_LOCAL)
        self.tf_static_sub = self._subscribe(topic, latched if qos is None else qos, is_static=True)

    def _subscribe(self, topic: str, qos: QoSProfile | int, is_static: bool) -> Subscription:
        # The node must not keep a listener alive that nobody holds any more.
        reference = weakref.ref(self)

        def take(envelope: Envelope) -> None:
            listener = reference()
            if listener is not None:
                listener._take(envelope, is_static)

        return self.node.create_subscription(
            tf2_msgs.TFMessage, topic, take, qos, callback_group=self.group, subscription_class=_TFSubscription
        )

    def _take(self, envelope: Envelope, is_static: bool) -> None:
        buffer = self.buffer
        if _is_plain(self, buffer) and not buffer.has_waiting():
            store = buffer.core.set_transform
            for stamped in envelope.stampeds:
                store(stamped, self.authority, is_static)
        elif is_static:
            self.static_callback(copy_message(envelope.message))
        else:
            self.callback(copy_message(envelope.message))

    def callback(self, data: tf2_msgs.TFMessage) -> None:
        """Store what came on /tf."""
        for transform in data.transforms:
            self.buffer.set_transform(transform, self.authority)

    def static_callback(self, data: tf2_msgs.TFMessage) -> None:
        """Store what came on /tf_static."""
        for transform in data.transforms:
            self.buffer.set_transform_static(transform, self.authority)

    def unregister(self) -> None:
        """Listen no more."""
        if self.tf_sub is not None:
            self.node.destroy_subscription(self.tf_sub)
        self.node.destroy_subscription(self.tf_static_sub)

    def __del__(self) -> None:
        if not hasattr(self, "tf_static_sub"):
            return  # it was never complete
        if self.executor is not None:
            self.executor.shutdown()
        self.unregister()

    def _spin_in_thread(self) -> None:
        self.executor = SingleThreadedExecutor(context=self.node.context)
        self.dedicated_listener_thread = threading.Thread(
            target=_spin, args=(self.executor, self.node), name="tf_listener", daemon=True
        )
        self.dedicated_listener_thread.start()


class StaticTransformListener(TransformListener):
    """Fills a buffer with what is published on /tf_static only."""

    def __init__(
        self,
        buffer: Buffer,
        node: Any,
        *,
        spin_thread: bool = False,
        static_qos: QoSProfile | int | None = None,
        tf_static_topic: str = DEFAULT_STATIC_TF_TOPIC,
    ) -> None:
        self._begin(buffer, node)
        self._subscribe_static(tf_static_topic, static_qos)
        if spin_thread:
            self._spin_in_thread()


_PLAIN = (
    TransformListener.callback,
    TransformListener.static_callback,
    Buffer.set_transform,
    Buffer.set_transform_static,
)


def _is_plain(listener: TransformListener, buffer: Any) -> bool:
    """Return whether nobody has overridden, or replaced, what stores a transform."""
    if type(buffer) is not Buffer:
        return False
    methods = (listener.callback, listener.static_callback, buffer.set_transform, buffer.set_transform_static)
    return tuple(getattr(method, "__func__", None) for method in methods) == _PLAIN


def _profile(durability: DurabilityPolicy = DurabilityPolicy.VOLATILE) -> QoSProfile:
    return QoSProfile(depth=100, durability=durability, history=HistoryPolicy.KEEP_LAST)


def _spin(executor: SingleThreadedExecutor, node: Any) -> None:
    executor.add_node(node)
    try:
        executor.spin()
    except ExternalShutdownException:
        pass
    finally:
        executor.remove_node(node)


TransformStamped = geometry_msgs.TransformStamped


class TransformBroadcaster:
    """Publishes transforms that change."""

    def __init__(self, node: Any, qos: QoSProfile | int | None = None) -> None:
        self.pub_tf = node.create_publisher(
            tf2_msgs.TFMessage, DEFAULT_TF_TOPIC, QoSProfile(depth=100) if qos is None else qos
        )

    def sendTransform(self, transform: TransformStamped | Iterable[TransformStamped]) -> None:
        """Publish one transform, or several in one message."""
        self.pub_tf.publish(tf2_msgs.TFMessage(transforms=_listed(transform)))


class StaticTransformBroadcaster:
    """Publishes transforms that never change."""

    def __init__(self, node: Any, qos: QoSProfile | int | None = None) -> None:
        if qos is None:
            qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, history=HistoryPolicy.KEEP_LAST)
        self.pub_tf = node.create_publisher(tf2_msgs.TFMessage, DEFAULT_STATIC_TF_TOPIC, qos)
        self.net_message = tf2_msgs.TFMessage()
        self._places: dict[str, int] = {}

    def sendTransform(self, transform: TransformStamped | Iterable[TransformStamped]) -> None:
        """Publish one transform, or several, together with what was sent before."""
        resend = distro.current().static_resend
        sent, place = ([], {}) if resend == "forgets" else (self.net_message.transforms, self._places)
        for each in _listed(transform):
            if resend == "forgets" or each.child_frame_id not in place:
                place[each.child_frame_id] = len(sent)
                sent.append(each)
            elif resend == "replaces":
                sent[place[each.child_frame_id]] = each
        self.net_message = tf2_msgs.TFMessage(transforms=sent)
        self.pub_tf.publish(self.net_message)


def _listed(transform: TransformStamped | Iterable[TransformStamped]) -> list[TransformStamped]:
    return list(transform) if hasattr(transform, "__iter__") else [transform]
