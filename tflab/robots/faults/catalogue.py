"""List the faults of a recording, with one name for each cause.

    clean records --- inject(records, Fault.GAP, seed) ---> broken records + Diagnosis
                                                                  |
    tflab doctor  -------------- what it found  ----------------- ?

The names here are what the injectors and the doctor have in common: a fault is
put in under a name, and must be found under the same.  A Diagnosis is the truth
about one injection: which fault, in which frames, and when.
"""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple

__all__ = ["Diagnosis", "Fault"]


class Fault(str, Enum):
    """The cause, as one searchable word."""

    REPARENTED = "reparented"  # a frame is published under another parent than before
    SECOND_OWNER = "second-owner"  # two nodes publish the same edge
    DUPLICATE_STAMPS = "duplicate-stamps"  # a publisher sends again, or stamps two samples alike
    OUT_OF_ORDER = "out-of-order"  # samples overtake each other on the way
    ZERO_QUATERNION = "zero-quaternion"  # a rotation was never filled in
    NAN = "nan"  # a computation went wrong before publishing
    NON_UNIT_QUATERNION = "non-unit-quaternion"  # a quaternion was put together by hand, or its order mixed up
    MISSING_EDGE = "missing-edge"  # a broadcaster does not run, or was not recorded
    LOOP = "loop"  # somebody publishes an edge backwards
    LEADING_SLASH = "leading-slash"  # a frame name from ROS 1 days
    CLOCK_JUMPED_BACK = "clock-jumped-back"  # a bag looped, a simulation was reset, or a clock was set
    CLOCK_OFFSET = "clock-offset"  # the clock of one computer is wrong
    STATIC_ON_TF = "static-on-tf"  # fixed mounts are sent again and again as if they moved
    MOVING_ON_TF_STATIC = "moving-on-tf-static"  # a moving edge is sent on /tf_static
    NO_TF_STATIC = "no-tf-static"  # /tf_static was not recorded, or with the wrong QoS
    GAP = "gap"  # a broadcaster, or the network, paused
    WRONG_NAME = "wrong-name"  # a frame name with wrong case, spelling or prefix in one place
    OPTICAL_IDENTITY = "optical-identity"  # the turn from camera_link to its optical frame was left out
    LATE_STAMPS = "late-stamps"  # slow processing or a slow network
    EARLY_STAMPS = "early-stamps"  # a publisher stamps its transforms ahead

    __str__ = str.__str__  # StrEnum does the same, from Python 3.11 on

    @classmethod
    def _missing_(cls, value: object) -> None:
        raise ValueError(f"{value!r} is not a valid Fault; there is {', '.join(cls)}")


class Diagnosis(NamedTuple):
    """The truth about one injected fault.

    Attributes:
        fault: the cause.
        frames: the children of the edges at fault, by their names in the clean stream.
        since_ns: when it begins to show [ns], by the listener's clock.
        detail: what was done, in one sentence with numbers.
    """

    fault: Fault
    frames: tuple[str, ...]
    since_ns: int
    detail: str
