"""Validate published transforms and the frame names of lookups.

    a published transform     ->  accepted | rejected, with a line in the log
    a frame name of a lookup  ->  its number | an exception with tf2's text

tf2 rejects a transform without an exception, because the publisher may be in another
process. Every fault of a transform is logged, not only the first; the logger is
`tflab.tf2`.

tf2: BufferCore::setTransformImpl, validateFrameId.
"""

from __future__ import annotations

import logging
import math
from operator import index

from . import quaternions
from .errors import InvalidArgumentException, LookupException
from .stamps import format_stamp
from .tree import FrameTree

__all__ = [
    "are_ordinary_names",
    "frame_number_or_raise",
    "is_acceptable",
    "log_old_data",
    "stamp_in_range",
    "unknown_frame",
    "unknown_frame_text",
    "whole_nanoseconds",
    "without_slash",
]

LENGTH_TOLERANCE = 0.01  # of a quaternion's squared length, after it was scaled to one

_log = logging.getLogger("tflab.tf2")


def without_slash(name: str) -> str:
    """Return a published name without its leading slash, if it has one."""
    return name[1:] if name.startswith("/") else name


def are_ordinary_names(parent: str, child: str) -> bool:
    """Return whether the names of an edge need no closer look: different, not empty, without leading slashes."""
    return bool(parent and child) and parent != child and parent[0] != "/" and child[0] != "/"


def is_acceptable(parent: str, child: str, numbers: tuple[float, ...], authority: str) -> bool:
    """Return whether a transform may be stored, and log every reason why not."""
    translation, rotation = numbers[:3], quaternions.canonical(numbers[3:])
    faults = []
    if parent == child:
        faults.append(
            f'TF_SELF_TRANSFORM: Ignoring transform from authority "{authority}" with frame_id and  '
            f'child_frame_id "{child}" because they are the same'
        )
    if not child:
        faults.append(
            f'TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "{authority}" because child_frame_id not set '
        )
    if not parent:
        faults.append(
            f'TF_NO_FRAME_ID: Ignoring transform with child_frame_id "{child}"  from authority "{authority}" '
            "because frame_id not set"
        )
    if any(map(math.isnan, translation + rotation)):
        faults.append(
            f'TF_NAN_INPUT: Ignoring transform for child_frame_id "{child}" from authority "{authority}" '
            f"because of a nan value in the transform ({_six(translation)}) ({_six(rotation)})"
        )
    if not abs(sum(c * c for c in rotation) - 1.0) < LENGTH_TOLERANCE:
        faults.append(
            f'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "{child}" from authority '
            f'"{authority}" because of an invalid quaternion in the transform ({_six(rotation)})'
        )
    for fault in faults:
        _log.error(fault)
    return not faults


def whole_nanoseconds(value: int, what: str = "a stamp") -> int:
    """Return a time as a plain int [ns].

    Raises:
        TypeError: not an integer: seconds, perhaps?
    """
    try:
        return index(value)
    except TypeError:
        raise TypeError(f"{what} is an int of nanoseconds, not {value!r}; seconds(1.5) makes one") from None


def stamp_in_range(stamp_ns: int) -> int:
    """Return a stamp that a history can hold.

    Raises:
        TypeError: not an integer.
        ValueError: not within 64 bits.
    """
    stamp_ns = whole_nanoseconds(stamp_ns)
    if not -(2**63) <= stamp_ns < 2**63:
        raise ValueError(f"a stamp must fit in 64 bits, {stamp_ns} ns does not")
    return stamp_ns


def log_old_data(child: str, stamp_ns: int, authority: str) -> None:
    """Log that a sample came too late to be stored."""
    _log.warning(
        f"TF_OLD_DATA ignoring data from the past for frame {child} at time {format_stamp(stamp_ns)} according to "
        f"authority {authority}\nPossible reasons are listed at http://wiki.ros.org/tf/Errors%20explained"
    )


def frame_number_or_raise(tree: FrameTree, argument: str, frame: str) -> int:
    """Return the number of a frame that somebody asks about; `argument` is tf2's word for its place.

    Raises:
        InvalidArgumentException: the name is empty or begins with a slash.
        LookupException: the name is unknown.
    """
    fault = _fault_in_form(frame)
    if fault:
        raise InvalidArgumentException(f'Invalid argument "{frame}" passed to {argument} - {fault}')
    number = tree.numbers.get(frame, 0)
    if number == 0:
        raise unknown_frame(tree, argument, frame)
    return number


def unknown_frame(tree: FrameTree, argument: str, frame: str) -> LookupException:
    """Return the exception for a name that nobody has published."""
    text = f'"{frame}" passed to {argument} does not exist. '
    return LookupException(text, frame=frame, known_frames=tree.known_names())


def unknown_frame_text(tree: FrameTree, **frames: str) -> str:
    """Return tf2's text for the first bad name of a can_transform; "" if all are known."""
    for argument, frame in frames.items():
        fault = _fault_in_form(frame) or ("" if tree.numbers.get(frame, 0) else "frame does not exist")
        if fault:
            return f'Invalid frame ID "{frame}" passed to canTransform argument {argument} - {fault}'
    return ""


def _fault_in_form(frame: str) -> str:
    if not isinstance(frame, str):
        raise TypeError(f"a frame name is a str, not {type(frame).__name__}: {frame!r}")
    if not frame:
        return "in tf2 frame_ids cannot be empty"
    if frame.startswith("/"):
        return "in tf2 frame_ids cannot start with a '/'"
    return ""


def _six(numbers: tuple[float, ...]) -> str:
    return " ".join(f"{number:f}" for number in numbers)
