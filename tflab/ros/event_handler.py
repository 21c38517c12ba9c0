"""What may an endpoint report besides messages?  That the other side's quality of service does not fit.

Given to create_publisher or create_subscription as `event_callbacks`, in place
of the warning in the log.

Read `names.py` next.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

__all__ = ["PublisherEventCallbacks", "SubscriptionEventCallbacks"]


@dataclass
class PublisherEventCallbacks:
    """`incompatible_qos(policy)` is called when a subscription requests more than is offered."""

    incompatible_qos: Callable[[str], None] | None = None


@dataclass
class SubscriptionEventCallbacks:
    """`incompatible_qos(policy)` is called when a publisher offers less than is requested."""

    incompatible_qos: Callable[[str], None] | None = None
