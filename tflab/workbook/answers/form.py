"""Describe what an answer looks like, and when two of them are the same.

    Vector(3, unit="m", tolerance=0.005)       (2.2, 0.0, 0.15) == array([2.2001, 0, 0.15])
    Quaternion()                               q == -q
    Parts({"a": Choice(("map", "odom")), ...})    judged part by part

A form reads an answer, as plain JSON, into *probes*: what earns credit on its own.
A probe is a row of marks, numbers with a tolerance or words.  Where an answer can
be written in several equal ways (a quaternion and its negative) there are several
rows, and one that fits is enough.  Nothing here runs a stranger's code.

    answer --probes--> [[row, row'], [row]]   against   expected --probes--> ...

This module holds what all forms share.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any, ClassVar, NamedTuple

from tflab.core import Transform

from ...text import Text
from .values import Plain, from_plain, is_raised

__all__ = [
    "Form",
    "Mark",
    "Probe",
    "Row",
    "inside",
    "is_given",
    "is_number",
    "matched",
    "member",
    "numbers_of",
    "pose_of",
]


class Mark(NamedTuple):
    """One thing to compare: a number within a tolerance, or a word."""

    value: float | str
    tolerance: float = 0.0

    def same(self, other: Mark) -> bool:
        """Return whether two marks are the same, within the larger tolerance."""
        if isinstance(self.value, str) or isinstance(other.value, str):
            return type(self.value) is type(other.value) and self.value == other.value
        return abs(self.value - other.value) <= max(self.tolerance, other.tolerance) + 1e-12 * abs(other.value)


Names = tuple[str, str]  # parent and child
Row = tuple[Mark, ...]
Probe = list[Row]  # equal ways to write the same


@dataclass(frozen=True)
class Form:
    """What all forms share.

    Attributes:
        in_any_order: whether a probe may stand anywhere among the others, as in a set.
        is_measured: whether it holds numbers: two answers are alike by chance less often than words and lists are.
        mistakes: which ones of any task it recognises, the surest first (see `diagnosis/matching.py`).
        unit: of its numbers, or "".
    """

    in_any_order: ClassVar[bool] = False
    is_measured: ClassVar[bool] = False
    mistakes: ClassVar[tuple[str, ...]] = ()
    unit = ""  # no annotation: a ClassVar would come first among the fields of a form that has one

    def probes(self, plain: Plain) -> list[Probe] | None:
        """Return what earns credit in an answer, or None if it is not of this form at all."""
        raise NotImplementedError

    def wanted(self) -> Text:
        """Return in words what is wanted."""
        raise NotImplementedError

    def read(self, answer: Plain) -> list[Probe] | None:
        """Return the probes of an answer that may be anything at all, even JSON that somebody made up."""
        try:
            return self.probes(answer)
        except Exception:  # whatever it is, it is not of this form
            return None

    def judge(self, answer: Plain, expected: Plain) -> list[bool]:
        """Return for each probe of `expected` whether `answer` has it."""
        if is_raised(expected):
            return [isinstance(answer, dict) and answer.get("raises") == expected["raises"]]
        if (wanted := self.probes(expected)) is None:
            raise ValueError(f"the expected value is not a {type(self).__name__}: {expected!r}")
        return self.has(answer, wanted)

    def has(self, answer: Plain, wanted: list[Probe]) -> list[bool]:
        """Return for each of these probes whether `answer` has it."""
        return matched(self.read(answer), wanted, is_given, self.in_any_order)

    def same(self, answer: Plain, expected: Plain) -> bool:
        """Return whether `answer` has every probe of `expected`."""
        return all(self.judge(answer, expected))

    def alike(self, answer: Plain, other: Plain) -> bool:
        """Return whether two answers are the same; neither need be of this form."""
        return self.comparing()(answer, other)

    def comparing(self, read: Callable[[Plain], list[Probe] | None] | None = None) -> Callable[[Plain, Plain], bool]:
        """Return `alike` for many answers that are compared with one another, with what reads each of them."""
        read = read or self.reading()

        def is_alike(answer: Plain, other: Plain) -> bool:
            if is_raised(other):
                return self.same(answer, other)
            wanted = read(other)
            if wanted is None or not all(wanted):  # or a part of it is of another kind
                return answer == other
            given = read(answer)
            if given is None or len(given) != len(wanted):
                return False
            if not self.in_any_order:
                return all(map(is_given, given, wanted))  # up to the first that differs
            is_there = (any(is_given(probe, right) for probe in given) for right in wanted)
            return given == wanted or (all(is_there) and all(matched(given, wanted, is_given, True)))

        return is_alike

    def reading(self) -> Callable[[Plain], list[Probe] | None]:
        """Return `read` for many answers, of which each is read once."""
        held: dict[int, tuple[Plain, list[Probe] | None]] = {}  # the answer, too: while it lives, its id is its own

        def read(plain: Plain) -> list[Probe] | None:
            if id(plain) not in held:
                held[id(plain)] = (plain, self.read(plain))
            return held[id(plain)][1]

        return read

    def remark(self, answer: Plain, neighbours: Mapping[str, Plain]) -> Text | None:
        """Return what can be said of a wrong answer by itself, beside the other parts of a dict; None if nothing."""
        return None

    def beside(self, answer: Plain, neighbours: Mapping[str, Plain]) -> Plain:
        """Return an answer as it is meant beside the other parts of a dict that speak of the same one."""
        return answer

    def numbers(self, plain: Plain) -> tuple[float, ...] | None:
        """Return the numbers of an answer that is one number or a row of numbers; None of any other."""
        return numbers_of(plain, None)

    def is_short(self, plain: Plain) -> bool:
        """Return whether an answer has too few digits for more than an exact match to say something."""
        return False

    def names(self) -> tuple[str, ...]:
        """Return the names of what earns credit on its own; none where that has no names."""
        return ()

    def forms_of_parts(self, like: Plain) -> dict[str, Form]:
        """Return the parts of an answer that are compared each on its own, as `like` has them."""
        return {}

    def part_of(self, plain: Plain, name: str) -> Plain:
        """Return one of an answer's parts; of something that has no such part, None."""
        return member(plain, *name.split("."))

    def describe_difference(self, answer: Plain, expected: Plain) -> Text | None:
        """Return what is certain about a wrong answer, without giving the right one away; None if nothing is."""
        return None

    def plain(self) -> dict[str, Any]:
        """Return the form as JSON has it: its class and its fields."""
        row = {field.name: getattr(self, field.name) for field in fields(self)}
        return {"form": type(self).__name__, **{name: _plain_field(value) for name, value in row.items()}}


def numbers_of(plain: Plain, size: int | None) -> tuple[float, ...] | None:
    """Return `size` finite numbers, or one if `size` is None; None if there are not exactly these.

    An array may have any shape that holds them: a column, a row, one number in brackets.
    """
    if isinstance(plain, dict) and "array" in plain:
        plain = _flat(plain["array"])
        plain = plain[0] if size is None and len(plain) == 1 else plain
    plain = inside(plain)
    if size is None:
        return (plain,) if is_number(plain) else None
    if isinstance(plain, dict):  # a message, or a dict, of x, y, z (and w)
        plain = [plain.get(name) for name in ("x", "y", "z", "w")[:size]] if len(plain) == size else None
    if isinstance(plain, list) and len(plain) == size and all(map(is_number, plain)):
        return tuple(plain)
    return None


def member(plain: Plain, *names: str) -> Plain:
    """Return what a message holds under these names, one inside the other; None if it has no such field."""
    for name in names:
        fields_of = plain.get("message") if isinstance(plain, dict) else None
        if not (isinstance(fields_of, list) and len(fields_of) == 2 and isinstance(fields_of[1], dict)):
            return None
        plain = fields_of[1].get(name)
    return plain


def matched(
    given: list[Probe] | None, wanted: Sequence[Any], fits: Callable[[Probe, Any], bool], in_any_order: bool
) -> list[bool]:
    """Return for each probe that is wanted whether it is given.

    In any order, more probes than are wanted take back as many that fit: to name everything is to name nothing.
    """
    if given is None or (len(given) != len(wanted) and not in_any_order):
        return [False] * len(wanted)
    if not in_any_order:
        return [fits(probe, right) for probe, right in zip(given, wanted, strict=True)]
    left, found = list(given), []
    for right in wanted:
        place = next((place for place, probe in enumerate(left) if fits(probe, right)), None)
        found.append(place is not None)
        if place is not None:
            del left[place]
    too_many = max(0, len(given) - len(wanted))
    right_ones = [place for place, is_found in enumerate(found) if is_found]
    for place in right_ones[max(0, len(right_ones) - too_many) :]:
        found[place] = False
    return found


def pose_of(plain: Plain) -> tuple[Names | None, int | None, tuple[float, ...], tuple[float, ...]] | None:
    """Return (parent, child), stamp [ns], translation and rotation of anything that is a transform, or None."""
    names, stamp_ns, rows = _parts_of_pose(plain)
    translation, rotation = (numbers_of(rows[0], 3), numbers_of(rows[1], 4)) if rows else (None, None)
    if translation is None or rotation is None:
        return None
    return names, stamp_ns, translation, rotation


def _parts_of_pose(plain: Plain) -> tuple[Names | None, Any, list | None]:
    """Return the frames, the stamp and the rows of what is written as a transform; the rows are not looked at yet."""
    kind, body = next(iter(plain.items())) if isinstance(plain, dict) and len(plain) == 1 else (None, plain)
    if kind == "StampedTransform" and isinstance(body, list) and len(body) == 5:
        parent, child, stamp_ns, *rows = body
        return (str(parent), str(child)), stamp_ns, rows
    if kind == "Transform" and isinstance(body, list) and len(body) == 2:
        return None, None, body
    if kind == "message":
        return _parts_of_message(plain)
    return None, None, _rows_of_matrix(body)


def _parts_of_message(plain: Plain) -> tuple[Names | None, int | None, list]:
    """Return the same of a message: a Transform, or a TransformStamped, which has frames and a stamp."""
    names, stamp_ns = None, None
    if (inner := member(plain, "transform")) is not None:
        names = (str(member(plain, "header", "frame_id")), str(member(plain, "child_frame_id")))
        sec, nanosec = member(plain, "header", "stamp", "sec"), member(plain, "header", "stamp", "nanosec")
        stamp_ns = sec * 1_000_000_000 + nanosec if isinstance(sec, int) and isinstance(nanosec, int) else None
        plain = inner
    return names, stamp_ns, [member(plain, "translation"), member(plain, "rotation")]


def _rows_of_matrix(rows: Plain) -> list | None:
    """Return translation and rotation of a 4x4 matrix."""
    if not (isinstance(rows, list) and len(rows) == 4 and all(numbers_of(row, 4) for row in rows)):
        return None
    try:
        transform = Transform.from_matrix(from_plain([inside(row) for row in rows]))
    except ValueError:
        return None
    return [list(transform.translation), list(transform.rotation)]


def inside(plain: Plain) -> Plain:
    """Return the list or the dict inside {"tuple": ...}, {"array": ...}, {"dict": ...} or a message of x, y, z."""
    if isinstance(plain, dict):
        for kind in ("tuple", "array", "dict"):
            if kind in plain:
                return plain[kind]
        for inner in ("point", "vector", "quaternion"):
            if (held := member(plain, inner)) is not None:
                return inside(held)
        named = plain.get("message")
        if isinstance(named, list) and len(named) == 2 and isinstance(named[1], dict):
            return named[1]
    return plain


def _flat(rows: Plain) -> list[Plain]:
    return [number for row in rows for number in _flat(row)] if isinstance(rows, list) else [rows]


def is_number(plain: Plain) -> bool:
    """Return whether this is one finite number; True and False are none."""
    if isinstance(plain, bool) or not isinstance(plain, int | float):
        return False
    return abs(plain) < 10**30 and math.isfinite(plain)


def is_given(given: Probe, wanted: Probe) -> bool:
    """Return whether one way to write it is what is wanted; what could not be read fits nothing."""
    return bool(wanted) and any(_fits(row, wanted[0]) for row in given)


def _fits(row: Row, other: Row) -> bool:
    return len(row) == len(other) and all(map(Mark.same, row, other))


def _plain_field(value: object) -> object:
    if isinstance(value, Form):
        return value.plain()
    if isinstance(value, dict):
        return {name: _plain_field(inner) for name, inner in value.items()}
    return list(value) if isinstance(value, tuple) else value
