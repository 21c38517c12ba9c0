"""Let parameters override policies of a publisher or subscription, as far as its node allows.

create_publisher(..., qos_overriding_options=QoSOverridingOptions.with_default_policies())
--ros-args -p qos_overrides./chatter.publisher.reliability:=best_effort
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import KW_ONLY, dataclass
from enum import IntEnum
from typing import Any

from .exceptions import ParameterAlreadyDeclaredException
from .messages.rcl_interfaces import ParameterDescriptor
from .qos import QoSProfile
from .qos_compatibility import QoSPolicyKind
from .time import Duration

__all__ = ["InvalidQosOverridesError", "QoSOverridingOptions", "override_policies"]


class InvalidQosOverridesError(Exception):
    """The callback of the options rejects the policies that result."""

    __module__ = "rclpy.qos_overriding_options"


@dataclass(frozen=True)
class QoSOverridingOptions:
    """Which policies parameters may override; `callback(profile)` judges the result by a SetParametersResult."""

    policy_kinds: Iterable[QoSPolicyKind]
    _: KW_ONLY
    callback: Callable[[QoSProfile], Any] | None = None
    entity_id: str | None = None

    @classmethod
    def with_default_policies(cls, **options: Any) -> QoSOverridingOptions:
        """Return the options for history, depth and reliability."""
        return cls((QoSPolicyKind.HISTORY, QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY), **options)


def override_policies(node: Any, side: str, topic: str, qos: QoSProfile, options: QoSOverridingOptions | None) -> None:
    """Declare a parameter for each policy that `options` allow, and change `qos` to their values.

    Args:
        side: "publisher" or "subscription".

    Raises:
        RuntimeError: a policy has no such value.
        InvalidQosOverridesError: the callback rejects the result.
    """
    if options is None:
        return
    entity = side if options.entity_id is None else f"{side}_{options.entity_id}"
    description = f"for {side} `{topic}` with id `{options.entity_id}`"
    for kind in options.policy_kinds:
        policy = kind.name.lower()
        if (side, policy) == ("subscription", "lifespan"):
            continue
        value, name = getattr(qos, policy), f"qos_overrides.{topic}.{entity}.{policy}"
        try:
            descriptor = ParameterDescriptor(description=f"{policy} {description}", read_only=True)
            parameter = node.declare_parameter(name, _plain(value), descriptor)
        except ParameterAlreadyDeclaredException:
            parameter = node.get_parameter(name)
        setattr(qos, policy, _policy(value, parameter.value, policy))
    result = options.callback and options.callback(qos)
    if result and not result.successful:
        raise InvalidQosOverridesError(f"Provided QoS overrides {description}, are not valid: {result.reason}")


def _plain(value: Any) -> Any:
    """Return a policy's value as a parameter has it."""
    if isinstance(value, IntEnum):
        if value.name == "UNKNOWN":
            raise ValueError("User provided QoS profile is invalid")
        return value.name.lower()
    return value.nanoseconds if isinstance(value, Duration) else value


def _policy(before: Any, value: Any, policy: str) -> Any:
    """Return a policy's value as a profile has it."""
    if isinstance(before, Duration):
        return Duration(nanoseconds=value)
    if not isinstance(before, IntEnum):
        return value
    try:
        return type(before)[value.upper()]
    except KeyError:
        raise RuntimeError(f"Unexpected QoS override for policy `{policy}`: `{value}`") from None
