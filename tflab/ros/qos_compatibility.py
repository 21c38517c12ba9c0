"""Do the two sides fit?  What a publisher offers must not be less than what a subscription requests.

If it is less, the two are not connected, and both say so in their logs.

Read `network.py` next.
"""

from __future__ import annotations

from enum import IntEnum

from .duration import Duration
from .qos import DurabilityPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy

__all__ = ["QoSCompatibility", "incompatible_policy", "qos_check_compatible"]

ZERO = Duration()  # a span of zero means: no limit


class QoSCompatibility(IntEnum):
    """Whether a publisher and a subscription are connected."""

    OK = 0
    WARNING = 1
    ERROR = 2


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
    reasons = []
    for policy in ("reliability", "durability", "liveliness"):
        sides = getattr(offered, policy), getattr(requested, policy)
        if any(side.name in ("SYSTEM_DEFAULT", "UNKNOWN") for side in sides) and sides[0] != sides[1]:
            reasons.append(f"Publisher {policy} is {sides[0].name} and subscription {policy} is {sides[1].name}")
    return reasons
