"""Write answers as plain JSON and read them back: numbers, arrays, transforms, messages, buffers.

    Transform((1, 0, 0), (0, 0, 0, 1))   --to_plain-->    {"Transform": [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]]}
                                         <-from_plain--

Cases are kept in this form, answers travel in it, and forms compare it: whoever
judges an answer never touches an object that a stranger made.  What JSON has is
itself; everything else is an object with one key, its kind.

    (1, 2)              {"tuple": [1, 2]}             nan          {"float": "nan"}
    {"map": "odom"}     {"dict": {"map": "odom"}}     `...`        {"unanswered": true}
    an array            {"array": [[...], ...]}       a message    {"message": ["geometry_msgs/msg/Point", {...}]}
    {"odom", "map"}     {"set": ["map", "odom"]}     an exception {"raises": "LookupException", "text": "..."}

What says the same is the same: a dataclass is a dict of its fields, a range or an
iterator a list.  Anything else is {"object": its class}: it can be named, not judged.
"""

from __future__ import annotations

import dataclasses
import json
import math
from array import array
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set, ValuesView
from decimal import Decimal
from fractions import Fraction
from itertools import islice
from types import SimpleNamespace
from typing import Any

import numpy as np

from tflab.clinic.patient import FaultyRobot
from tflab.core import BufferCore, StampedTransform, Transform, errors
from tflab.ros.messages.base import Message, type_named
from tflab.ros.tf2 import buffer as tf2_buffer
from tflab.ros.time import ClockType, Duration, Time

__all__ = ["Plain", "from_plain", "is_raised", "is_unanswered", "outcome_of", "outcomes_of", "raised", "to_plain"]

Plain = Any  # what json.loads may return
MAX_DEPTH = 30
MAX_MEMBERS = 200_000
UNANSWERED = {"unanswered": True}


def to_plain(value: object) -> Plain:
    """Return `value` as JSON has it.

    Raises:
        ValueError: it is nested too deep, or has too many members.
    """
    return _Writer().plain(value, 0)


def from_plain(plain: Plain) -> Any:
    """Return the value that `to_plain` wrote; what was a message or a buffer is a new one each time.

    Raises:
        ValueError: not what `to_plain` writes.
    """
    if isinstance(plain, list):
        return [from_plain(member) for member in plain]
    if not isinstance(plain, dict):
        return plain
    kind = next(iter(plain), None)
    if kind not in _READERS:
        raise ValueError(f"a value of unknown kind: {kind!r}")
    return _READERS[kind](plain[kind])


def raised(error: BaseException) -> Plain:
    """Return an exception as the outcome of a call: by its class, tf2's for a subclass of it, the text beside it.

    A class that only has the name of one of tf2's is another one: nobody's `except` catches it.
    """
    known = next((each for each in type(error).__mro__ if each.__module__ == "tf2"), type(error))
    name = known.__name__
    if known.__module__ != "tf2" and isinstance(getattr(errors, name, None), type):
        name = f"{known.__module__}.{name}"
    return {"raises": name, "text": str(error)[:500]}


def outcome_of(function: Callable[..., Any], args: Sequence[Plain]) -> Plain:
    """Return what a function gives for fresh copies of its arguments: a value, what it raises, or which it changed."""
    return next(outcomes_of([function], args))


def outcomes_of(functions: Iterable[Callable[..., Any]], args: Sequence[Plain]) -> Iterator[Plain]:
    """Yield `outcome_of` for each function; what the last one left as it was is handed to the next."""
    remembers = any(isinstance(arg, dict) and "Patient" in arg for arg in args)  # what it was asked
    before = held = None
    for function in functions:
        held = [from_plain(arg) for arg in args] if remembers or held is None else held
        before = before or [to_plain(arg) for arg in held]
        try:
            given = function(*held)
        except (Exception, SystemExit) as error:
            held = None
            yield raised(error)
            continue
        try:
            changed = [number for number, arg in enumerate(held) if to_plain(arg) != before[number]]
        except Exception:  # an argument without end, by now
            changed = [0]
        result = _result(given)
        if changed:
            held, result = None, {"changed": changed[0] + 1, "gave": result}
        yield result


def _result(given: object) -> Plain:
    """Return what a function gave."""
    if callable(given) and not isinstance(given, type):
        return {"object": "function"}
    try:
        plain = to_plain(given)
        json.dumps(plain, allow_nan=False)
    except Exception as error:  # an object with surprises in it, or one without end
        return raised(error)
    return plain


def is_raised(plain: Plain) -> bool:
    """Return whether this is what `raised` writes: an exception, as the outcome of a call."""
    return isinstance(plain, dict) and "raises" in plain


def is_unanswered(plain: Plain) -> bool:
    """Return whether this is `...`, a dict of nothing else, or a call that raised NotImplementedError("your turn")."""
    if not isinstance(plain, dict):
        return False
    parts = plain.get("dict")
    if isinstance(parts, dict) and parts:
        return all(part == UNANSWERED for part in parts.values())
    return plain == UNANSWERED or (plain.get("raises") == "NotImplementedError" and plain.get("text") == "your turn")


class _Writer:
    """Counts what it writes, so that an endless answer ends."""

    def __init__(self) -> None:
        self.members = 0

    def plain(self, value: object, depth: int) -> Plain:
        self.members += 1
        if depth > MAX_DEPTH or self.members > MAX_MEMBERS:
            raise ValueError("too deep or too long to be an answer")
        if value is None or isinstance(value, bool):
            return value
        if isinstance(value, str):
            return _text(value)
        if isinstance(value, np.bool_):
            return bool(value)
        if isinstance(value, int | np.integer):
            return int(value)
        if isinstance(value, float | np.floating | Decimal | Fraction):
            return _plain_float(float(value))
        if isinstance(value, list | tuple):
            members = [self.plain(member, depth + 1) for member in value]
            return members if isinstance(value, list) else {"tuple": members}
        if isinstance(value, Mapping | SimpleNamespace):
            items = dict(value if isinstance(value, Mapping) else vars(value)).items()
            return {"dict": {_text(key): self.plain(member, depth + 1) for key, member in items}}
        return self._special(value, depth)

    def _special(self, value: object, depth: int) -> Plain:
        if value is ...:
            return dict(UNANSWERED)
        if isinstance(value, np.ndarray) and value.dtype.kind in "bifu":
            return {"array": self.plain(value.tolist(), depth + 1)}
        if isinstance(value, np.ndarray) and value.dtype.kind in "UO":
            return self.plain(value.tolist(), depth + 1)
        if isinstance(value, Set):
            return {"set": sorted((self.plain(member, depth + 1) for member in value), key=json.dumps)}
        if isinstance(value, array | bytes | deque | range | ValuesView | Iterator):
            return self.plain(list(islice(value, MAX_MEMBERS + 1)), depth)
        return self._of_space_and_time(value, depth)

    def _of_space_and_time(self, value: object, depth: int) -> Plain:
        if isinstance(value, Transform):
            return {"Transform": _rows(value)}
        if isinstance(value, StampedTransform):
            row = [value.frame_id, value.child_frame_id, value.stamp_ns]
            return {"StampedTransform": [*row, *_rows(value.transform)]}
        if isinstance(value, Message):
            fields = {name: self.plain(getattr(value, name), depth + 1) for name in value.get_fields_and_field_types()}
            return {"message": [value.ROS_TYPE, fields]}
        if isinstance(value, Time):
            return {"Time": [value.nanoseconds, int(value.clock_type.value)]}
        if isinstance(value, Duration):
            return {"Duration": value.nanoseconds}
        if isinstance(value, FaultyRobot):
            return {"Patient": value.packed()}
        if isinstance(value, BufferCore):
            return {"BufferCore": _plain_buffer(value)}
        if isinstance(value, tf2_buffer.BufferCore):
            return {"Buffer": _plain_buffer(value.core)}
        return self._other(value, depth)

    def _other(self, value: object, depth: int) -> Plain:
        if isinstance(value, BaseException):
            return {"object": f"{type(value).__name__}, returned and not raised"}
        if dataclasses.is_dataclass(value) and not isinstance(value, type):
            items = {field.name: getattr(value, field.name) for field in dataclasses.fields(value)}
            return self.plain(items, depth)
        return {"object": type(value).__name__}


def _text(value: object) -> str:
    """Return a text as it is, whatever its class prints: a member of an Enum of texts prints its name."""
    return str.__str__(value) if isinstance(value, str) else str(value)


def _plain_float(value: float) -> Plain:
    return value if math.isfinite(value) else {"float": str(value)}


def _rows(transform: Transform) -> list[list[Plain]]:
    return [[_plain_float(number) for number in row] for row in (transform.translation, transform.rotation)]


def _plain_buffer(buffer: BufferCore) -> Plain:
    edges = [buffer.history(frame) for frame in buffer.frame_names()]
    samples = [
        [history.is_static, authority, parent, history.frame, stamp_ns, *_rows(transform)]
        for history in edges
        for stamp_ns, parent, authority, transform in zip(
            history.stamps_ns, history.parents, history.authorities, history.transforms, strict=True
        )
    ]
    return {"cache_time_ns": buffer.cache_time_ns, "samples": samples}


def _transform(rows: list) -> Transform:
    translation, rotation = from_plain(rows)
    return Transform(tuple(translation), tuple(rotation))


def _stamped(row: list) -> StampedTransform:
    frame_id, child_frame_id, stamp_ns, *rows = row
    return StampedTransform(frame_id, child_frame_id, stamp_ns, _transform(rows))


def _message(named: list) -> Message:
    ros_type, fields = named
    cls = type_named(ros_type)
    return cls(**{name: from_plain(value) for name, value in fields.items()})


def _buffer_core(plain: dict) -> BufferCore:
    buffer = BufferCore(plain["cache_time_ns"])
    for is_static, authority, *row in plain["samples"]:
        buffer.set_transform(_stamped(row), authority, is_static=is_static)
    return buffer


def _buffer(plain: dict) -> tf2_buffer.Buffer:
    buffer = tf2_buffer.Buffer(Duration(nanoseconds=plain["cache_time_ns"]))
    for is_static, authority, *row in plain["samples"]:
        buffer.core.set_transform(_stamped(row), authority, is_static=is_static)  # nobody waits for it yet
    return buffer


_READERS: dict[str, Callable[[Any], Any]] = {
    "float": float,
    "tuple": lambda members: tuple(map(from_plain, members)),
    "set": lambda members: set(map(from_plain, members)),
    "dict": lambda items: {key: from_plain(value) for key, value in items.items()},
    "array": lambda rows: np.array(from_plain(rows)),
    "unanswered": lambda _: ...,
    "Transform": _transform,
    "StampedTransform": _stamped,
    "message": _message,
    "Time": lambda pair: Time(nanoseconds=pair[0], clock_type=ClockType(pair[1])),
    "Duration": lambda nanoseconds: Duration(nanoseconds=nanoseconds),
    "Patient": FaultyRobot.unpacked,
    "BufferCore": _buffer_core,
    "Buffer": _buffer,
}
