"""List the differences between ROS 2 distributions that a learner meets.

    TFLAB_ROS_DISTRO=humble | jazzy | rolling        (jazzy if unset)

The rest of the surface is that of geometry2 0.39.1 and rclpy 8.0, whatever the
distribution.
"""

from __future__ import annotations

import os
from dataclasses import dataclass

__all__ = ["DEFAULT", "Distro", "checks_fields", "current"]

VARIABLE = "TFLAB_ROS_DISTRO"
DEFAULT = "jazzy"


@dataclass(frozen=True, slots=True)
class Distro:
    """What differs.

    Attributes:
        name: of the distribution.
        static_resend: what StaticTransformBroadcaster (Python) publishes when it is called again:
            "forgets"   only what it was given last; late joiners miss the earlier ones
            "keeps"     all so far, but the first value of each child
            "replaces"  all so far, with the newest value of each child
        always_checks_fields: messages refuse values of a wrong type without being asked to.
        policy_suffix: ends the policy's name in the warning about incompatible QoS.
        has_type_hash: `ros2 topic info --verbose` prints a line "Topic type hash".
        has_type_description: every node serves `~/get_type_description`.
        names_quaternion_order: tf2_echo prints "in Quaternion (xyzw)".
        default_bag_storage: of `ros2 bag record`.
    """

    name: str
    static_resend: str
    always_checks_fields: bool
    policy_suffix: str
    has_type_hash: bool
    has_type_description: bool
    names_quaternion_order: bool
    default_bag_storage: str


_TABLE = {
    "humble": Distro("humble", "forgets", True, "_QOS_POLICY", False, False, False, "sqlite3"),
    "jazzy": Distro("jazzy", "keeps", False, "", True, True, False, "mcap"),
    "rolling": Distro("rolling", "replaces", False, "", True, True, True, "mcap"),
}


def current() -> Distro:
    """Return the distribution that TFLAB_ROS_DISTRO names.

    Raises:
        ValueError: the variable names another one.
    """
    name = os.environ.get(VARIABLE) or DEFAULT
    if name not in _TABLE:
        raise ValueError(f"{VARIABLE}={name!r} is not known: it is one of {', '.join(_TABLE)}.")
    return _TABLE[name]


def checks_fields() -> bool:
    """Return whether messages check the types of their fields in this distribution and environment."""
    return current().always_checks_fields or os.environ.get("ROS_PYTHON_CHECK_FIELDS") == "1"
