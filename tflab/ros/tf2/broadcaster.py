"""Publish transforms: tf2_ros.TransformBroadcaster and StaticTransformBroadcaster.

    TransformBroadcaster         /tf          whatever it is given, again and again
    StaticTransformBroadcaster   /tf_static   once; latecomers get the last message of each broadcaster

Because only the last message is kept, a static broadcaster repeats in it what it
sent before; how well, depends on the distribution (distro.py).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from .. import distro
from ..messages import geometry_msgs, tf2_msgs
from ..qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from .listener import DEFAULT_STATIC_TF_TOPIC, DEFAULT_TF_TOPIC

__all__ = ["StaticTransformBroadcaster", "TransformBroadcaster"]

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

    def sendTransform(self, transform: TransformStamped | Iterable[TransformStamped]) -> None:
        """Publish one transform, or several, together with what was sent before."""
        resend = distro.current().static_resend
        sent = [] if resend == "forgets" else self.net_message.transforms
        place = {each.child_frame_id: index for index, each in enumerate(sent)}
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
