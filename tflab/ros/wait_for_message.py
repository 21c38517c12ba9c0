"""Wait for one message, as rclpy.wait_for_message does.

    found, scan = wait_for_message(LaserScan, node, "scan", time_to_wait=1.0)

It blocks, and needs nobody to spin: the message is taken where it arrives.  What
was published before is missed, unless both sides are transient local.
"""

from __future__ import annotations

from typing import Any

from tflab.core import NSEC_PER_SEC

from .messages import copy_message
from .messages.base import Message
from .network import Envelope
from .qos import QoSProfile
from .topic_endpoints import Subscription

__all__ = ["wait_for_message"]


class _FirstOnly(Subscription):
    """Keeps the first envelope, and wakes whoever waits for it."""

    first: Envelope | None = None
    waiter: Any = None

    def put(self, envelope: Envelope) -> None:
        if self.first is None:
            self.first = envelope
        if self.waiter is not None:
            self.waiter.wake()


def wait_for_message(
    msg_type: type[Message],
    node: Any,
    topic: str,
    *,
    qos_profile: QoSProfile | int = 1,
    time_to_wait: float = -1,
) -> tuple[bool, Message | None]:
    """Block until a message comes; return (True, the message), or (False, None) after `time_to_wait` [s].

    A negative time is for ever.
    """
    process = node.context.process
    subscription = node.create_subscription(
        msg_type, topic, lambda message: None, qos_profile, subscription_class=_FirstOnly
    )
    subscription.waiter = process.driver.new_waiter()
    limit_ns = None if time_to_wait < 0 else round(time_to_wait * NSEC_PER_SEC)
    try:
        process.wait_until(
            lambda: subscription.first is not None or not node.context.ok(), subscription.waiter, limit_ns
        )
    finally:
        node.destroy_subscription(subscription)
    if subscription.first is None:
        return False, None
    return True, copy_message(subscription.first.message)
