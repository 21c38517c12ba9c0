"""What can go wrong with TF, so that a recording shows it?  A catalogue, with one name for each cause.

    clean records --- inject(records, Fault.GAP, seed) ---> broken records + Diagnosis
                                                                  |
    tflab doctor  -------------- what it found  ----------------- ?

The names here are what the injectors and the doctor have in common: a fault is
put in under a name, and must be found under the same.  A Diagnosis is the truth
about one injection: which fault, in which frames, and when.

Read `streams.py` next; faults are put in by `injectors.py`, at the end of the row.
"""

from __future__ import annotations

from enum import StrEnum
from typing import NamedTuple

__all__ = ["CATALOGUE", "Diagnosis", "Fault", "FaultKind"]


class Fault(StrEnum):
    """The cause, as one searchable word."""

    REPARENTED = "reparented"
    SECOND_OWNER = "second-owner"
    DUPLICATE_STAMPS = "duplicate-stamps"
    OUT_OF_ORDER = "out-of-order"
    ZERO_QUATERNION = "zero-quaternion"
    NAN = "nan"
    NON_UNIT_QUATERNION = "non-unit-quaternion"
    MISSING_EDGE = "missing-edge"
    LOOP = "loop"
    LEADING_SLASH = "leading-slash"
    CLOCK_JUMPED_BACK = "clock-jumped-back"
    CLOCK_OFFSET = "clock-offset"
    STATIC_ON_TF = "static-on-tf"
    MOVING_ON_TF_STATIC = "moving-on-tf-static"
    NO_TF_STATIC = "no-tf-static"
    GAP = "gap"
    WRONG_NAME = "wrong-name"
    OPTICAL_IDENTITY = "optical-identity"
    LATE_STAMPS = "late-stamps"
    EARLY_STAMPS = "early-stamps"

    @classmethod
    def _missing_(cls, value: object) -> None:
        raise ValueError(f"{value!r} is not a valid Fault; there is {', '.join(cls)}")


class FaultKind(NamedTuple):
    """What a fault is, what it looks like in a recording, and what a robot does about it.

    Attributes:
        cause: what somebody did wrong.
        evidence: what the recording shows.
        symptom: what people complain about.
    """

    cause: str
    evidence: str
    symptom: str


CATALOGUE: dict[Fault, FaultKind] = {
    Fault.REPARENTED: FaultKind(
        "a frame is published under another parent than before",
        "one child with two parents, one after the other or in turns",
        "lookups take another way from one moment to the next",
    ),
    Fault.SECOND_OWNER: FaultKind(
        "two nodes publish the same edge",
        "interleaved samples of one edge that contradict each other",
        "the robot trembles between two places",
    ),
    Fault.DUPLICATE_STAMPS: FaultKind(
        "a publisher sends again, or stamps two samples alike",
        "several samples of one edge with one stamp",
        "TF_REPEATED_DATA on Humble; later, the last one wins",
    ),
    Fault.OUT_OF_ORDER: FaultKind(
        "samples overtake each other on the way",
        "stamps of one edge that step back by a sample or two",
        "the newest transform is not the last one that came",
    ),
    Fault.ZERO_QUATERNION: FaultKind(
        "a rotation was never filled in",
        "quaternions (0, 0, 0, 0)",
        "TF_DENORMALIZED_QUATERNION in every listener; the frame does not exist",
    ),
    Fault.NAN: FaultKind(
        "a computation went wrong before publishing",
        "NaN among the numbers",
        "TF_NAN_INPUT in every listener; the frame is missing or stands still",
    ),
    Fault.NON_UNIT_QUATERNION: FaultKind(
        "a quaternion was put together by hand, or its order mixed up",
        "quaternions whose length is not one",
        "tf2 scales it in silence; other libraries do not",
    ),
    Fault.MISSING_EDGE: FaultKind(
        "a broadcaster does not run, or was not recorded",
        "two trees where there should be one",
        "ConnectivityException: not part of the same tree",
    ),
    Fault.LOOP: FaultKind(
        "somebody publishes an edge backwards",
        "a frame that is its own ancestor",
        "LookupException: the tf tree contains a loop",
    ),
    Fault.LEADING_SLASH: FaultKind(
        "a frame name from ROS 1 days",
        "names that begin with /",
        "InvalidArgumentException in whoever asks with that name",
    ),
    Fault.CLOCK_JUMPED_BACK: FaultKind(
        "a bag looped, a simulation was reset, or a clock was set",
        "the stamps of every moving edge step back together, and go on from there",
        "TF_OLD_DATA, or a buffer that mixes two times",
    ),
    Fault.CLOCK_OFFSET: FaultKind(
        "the clock of one computer is wrong",
        "all edges of one publisher are off by the same time, from beginning to end",
        "extrapolation errors that no timeout cures",
    ),
    Fault.STATIC_ON_TF: FaultKind(
        "fixed mounts are sent again and again as if they moved",
        "edges on /tf that never change",
        "needless traffic; frames go stale when the sender stops",
    ),
    Fault.MOVING_ON_TF_STATIC: FaultKind(
        "a moving edge is sent on /tf_static",
        "one child on /tf_static with many different values",
        "no history: every question about the past is answered with the present",
    ),
    Fault.NO_TF_STATIC: FaultKind(
        "/tf_static was not recorded, or was recorded with the wrong QoS",
        "no static transform at all; sensor frames are missing or cut off",
        "the bag works on the robot and nowhere else",
    ),
    Fault.GAP: FaultKind(
        "a broadcaster, or the network, paused",
        "a silence much longer than the usual period",
        "extrapolation errors, and interpolation across what was not seen",
    ),
    Fault.WRONG_NAME: FaultKind(
        "a frame name with wrong case, spelling or prefix in one place",
        "two trees, and two frame names that are nearly the same",
        "frame does not exist, or two trees",
    ),
    Fault.OPTICAL_IDENTITY: FaultKind(
        "the turn from camera_link to its optical frame was left out",
        "an optical frame whose axes are those of its parent",
        "point clouds that look up into the sky",
    ),
    Fault.LATE_STAMPS: FaultKind(
        "slow processing or a slow network",
        "an edge whose samples begin to arrive long after their stamps",
        "extrapolation into the future that waiting would cure",
    ),
    Fault.EARLY_STAMPS: FaultKind(
        "a publisher stamps its transforms ahead",
        "an edge whose stamps begin to lie in the future when they arrive",
        "lookups answer with guesses about what has not happened yet",
    ),
}


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
