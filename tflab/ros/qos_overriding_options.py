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

__all__ = ["InvalidQosOverridesError", "QoSOverridingOptions", "override_policies", "policy_parameter"]


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


def override_policies(
    entity_type: Any, node: Any, topic_name: str, qos: QoSProfile, options: QoSOverridingOptions | None
) -> None:
    """Declare a parameter for each policy that `options` allow, and change `qos` to their values.

    Args:
        entity_type: the class Publisher or Subscription.

    Raises:
        RuntimeError: a policy has no such value.
        InvalidQosOverridesError: the callback rejects the result.
    """
    if options is None:
        return
    side = entity_type.endpoint_type.lower()
    entity = side if options.entity_id is None else f"{side}_{options.entity_id}"
    description = f"for {side} `{topic_name}` with id `{options.entity_id}`"
    for kind in options.policy_kinds:
        policy = kind.name.lower()
        if (side, policy) == ("subscription", "lifespan"):
            continue
        name, value = f"qos_overrides.{topic_name}.{entity}.{policy}", policy_parameter(qos, kind)
        try:
            descriptor = ParameterDescriptor(description=f"{policy} {description}", read_only=True)
            parameter = node.declare_parameter(name, value, descriptor)
        except ParameterAlreadyDeclaredException:
            parameter = node.get_parameter(name)
        setattr(qos, policy, _policy(getattr(qos, policy), parameter.value, policy))
    result = options.callback and options.callback(qos)
    if result and not result.successful:
        raise InvalidQosOverridesError(f"Provided QoS overrides {description}, are not valid: {result.reason}")


def policy_parameter(qos: QoSProfile, policy: QoSPolicyKind) -> Any:
    """Return the value of a policy as a parameter has it.

    Raises:
        ValueError: the profile does not say.
    """
    value = getattr(qos, policy.name.lower())
    if not isinstance(value, IntEnum):
        return value.nanoseconds if isinstance(value, Duration) else value
    if value.name == "UNKNOWN":
        raise ValueError("User provided QoS profile is invalid")
    return value.name.lower()


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
