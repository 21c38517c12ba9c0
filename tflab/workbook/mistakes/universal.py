"""Which mistakes can any answer have?  A sign, a unit, an order of numbers: known once, for all tasks.

    answer (0.707, 0, 0, 0.707)   undo "w first"   (0, 0, 0.707, 0.707)   == expected: so w came first
    answer 57.3                   undo "degrees"   1.0                     == expected: so it is in degrees

Each is undone, and what is left is compared with what was expected, or with what a
slip of the task would give.
Such rules are the *mal-rules* of a *bug library* (Brown and Burton's BUGGY): not
what is wrong, but what was done.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from itertools import permutations, product
from typing import NamedTuple

from tflab.core import Transform

from ...text import Texts
from ..answers.form import inside, numbers_of, pose_of
from ..answers.forms import Angle, Form, Name, Number, Pose, Quaternion, Set, Tree, Vector
from ..answers.values import Plain, to_plain
from .by_place import letters_told
from .names import renamed
from .units import OTHER_UNITS, unit_of

__all__ = ["OF_FORM", "PLAIN_TO_SEE", "TEXTS", "UNIVERSAL", "undone"]

TEXTS = Texts(__file__)
Row = tuple[float, ...]
NOTHING = 10.0  # tolerances: a number below is as good as zero, whatever its unit


class Universal(NamedTuple):
    """A mistake that any answer of some form can have.

    Attributes:
        undo: what the answer would have been without it; several where it can be undone in several ways.
    """

    undo: Callable[[Row], Iterator[Row]]
    misconception: str = ""


class Undone(NamedTuple):
    """An answer without one universal mistake: its name, the unit or the numbers it is told of, and what is left."""

    name: str
    unit: str
    left: Plain


def _no_numbers(row: Row) -> Iterator[Row]:
    yield from ()


def _negated(row: Row) -> Iterator[Row]:
    yield tuple(-number for number in row)


def _reciprocal(row: Row) -> Iterator[Row]:
    if row[0]:
        yield (1.0 / row[0],)


def _half(row: Row) -> Iterator[Row]:
    yield tuple(number / 2.0 for number in row)


def _double(row: Row) -> Iterator[Row]:
    yield tuple(number * 2.0 for number in row)


def _root(row: Row) -> Iterator[Row]:
    if row[0] > 0.0:
        yield (math.sqrt(row[0]),)


def _square(row: Row) -> Iterator[Row]:
    yield (row[0] ** 2,)


def _powers_of_ten(row: Row) -> Iterator[Row]:
    yield from (tuple(number * 10.0**power for number in row) for power in range(-9, 10) if power)


def _half_a_turn(row: Row) -> Iterator[Row]:
    yield (row[0] + math.pi,)


def _angle_of_z(row: Row) -> Iterator[Row]:
    """The sine of half the angle, as it stands in a quaternion's z, was taken for the angle."""
    if abs(row[0]) <= 1.0:
        yield (2.0 * math.asin(row[0]),)


def _exchanged(row: Row) -> Iterator[Row]:
    if len(row) > 4:
        return
    yield from (order for order in permutations(row) if order != row)


def _places_and_signs(row: Row) -> Iterator[Row]:
    if len(row) > 3:
        return
    for order in permutations(row):
        yield from (
            tuple(sign * number for sign, number in zip(signs, order, strict=True))
            for signs in product((1.0, -1.0), repeat=len(row))
        )


def _one_sign(row: Row) -> Iterator[Row]:
    for place, number in enumerate(row):
        if number:
            yield (*row[:place], -number, *row[place + 1 :])


def _w_first(row: Row) -> Iterator[Row]:
    yield (*row[1:], row[0])


def _w_taken_first(row: Row) -> Iterator[Row]:
    """What came as (x, y, z, w) was written to (w, x, y, z)."""
    yield (row[3], *row[:3])


def _conjugate(row: Row) -> Iterator[Row]:
    yield (-row[0], -row[1], -row[2], row[3])


def _scaled(row: Row) -> Iterator[Row]:
    length = math.hypot(*row)
    if length > 1e-9 and abs(length - 1.0) > 1e-3:
        yield tuple(number / length for number in row)


def _halved(row: Row) -> Iterator[Row]:
    """Turn half as far: (x, y, z, w) of the angle a becomes that of a/2, either way round."""
    x, y, z, w = row
    sine = math.hypot(x, y, z)
    if abs(math.hypot(*row) - 1.0) < 1e-3 and sine > 1e-6:
        for half in (math.atan2(sine, w) / 2.0, (math.atan2(sine, w) - math.pi) / 2.0):
            yield (*(part * math.sin(half) / sine for part in (x, y, z)), math.cos(half))


UNIVERSAL = {
    "sign": Universal(_negated),
    "one over it": Universal(_reciprocal),
    "twice": Universal(_half),
    "half": Universal(_double),
    "squared": Universal(_root),
    "root": Universal(_square),
    "half a turn": Universal(_half_a_turn),
    "z for the angle": Universal(_angle_of_z, "M5"),
    "all signs": Universal(_negated),
    "one sign": Universal(_one_sign),
    "exchanged": Universal(_exchanged),
    "places and signs": Universal(_places_and_signs),
    "w first": Universal(_w_first, "M5"),
    "w taken first": Universal(_w_taken_first, "M5"),
    "inverse rotation": Universal(_conjugate, "M1"),
    "not normalised": Universal(_scaled, "M5"),
    "whole angle": Universal(_halved, "M5"),
    "other case": Universal(_no_numbers, "M14"),
    "slash in front": Universal(_no_numbers, "M14"),
    "space around": Universal(_no_numbers, "M14"),
    "no slash in front": Universal(_no_numbers, "M14"),
    "other separator": Universal(_no_numbers, "M14"),
    "inverse transform": Universal(_no_numbers, "M1"),
    "not turned back": Universal(_no_numbers, "M1"),
    "translation taken away": Universal(_negated, "M3"),
    "transposed": Universal(_no_numbers),
    "power of ten": Universal(_powers_of_ten),
}
OF_FORM = {
    Number: ("sign", "one over it", "twice", "half", "squared", "root", "power of ten"),
    Angle: ("sign", "half a turn", "z for the angle", "twice", "half"),
    Vector: ("all signs", "exchanged", "one sign", "places and signs", "twice", "half", "power of ten"),
    Quaternion: ("w first", "w taken first", "inverse rotation", "not normalised", "whole angle", "exchanged"),
}
# What is seen at once, and so may stand behind another slip; of the others nobody could say that it was just that.
PLAIN_TO_SEE = {
    *("unit", "sign", "all signs", "w first", "w taken first", "not normalised"),
    *("inverse rotation", "inverse transform", "not turned back"),
}


def undone(form: Form, answer: Plain) -> Iterator[Undone]:
    """Yield what an answer would be without each of the mistakes that an answer of its form can have."""
    if isinstance(form, Pose):
        yield from _undone_pose(answer)
    elif isinstance(form, Name | Tree) or (isinstance(form, Set) and isinstance(form.of, Name)):
        yield from _undone_names(answer)
    elif type(form) in OF_FORM and form.read(answer) is not None:  # not, say, a message in another frame
        yield from _undone_numbers(form, answer)


def _undone_numbers(form: Form, answer: Plain) -> Iterator[Undone]:
    size = form.size if isinstance(form, Vector) else 4 if isinstance(form, Quaternion) else None
    row = numbers_of(answer, size)
    for unit, factor in OTHER_UNITS.get(unit_of(form), {}).items():
        left = tuple(number / factor for number in row)
        if max(map(abs, left)) > NOTHING * form.tolerance:
            yield Undone("unit", unit, _plain(left, size))
    is_a_count = isinstance(form, Number) and not form.unit
    for name in ("sign",) if is_a_count else OF_FORM[type(form)]:
        lefts = list(UNIVERSAL[name].undo(row))
        if isinstance(form, Vector):  # what is sure of a number by its name comes first
            yield from (Undone(name, f"| {told}", _plain(left, size)) for left in lefts
                        if (told := letters_told(name, row, left)))  # fmt: skip
        yield from (Undone(name, "", _plain(left, size)) for left in lefts
                    if name != "power of ten" or max(map(abs, left)) > NOTHING * form.tolerance)  # fmt: skip


def _undone_pose(answer: Plain) -> Iterator[Undone]:
    parts = pose_of(answer)
    if parts is None and isinstance(rows := inside(answer), list) and all(numbers_of(row, 4) for row in rows):
        yield Undone("transposed", "", [list(column) for column in zip(*map(inside, rows), strict=True)])
    if parts is None or math.hypot(*parts[3]) < 1e-9:
        return
    yield Undone("inverse transform", "", to_plain(Transform(parts[2], parts[3]).inverse()))
    step_back = tuple(-number for number in parts[2])
    yield Undone("not turned back", "", to_plain(Transform(step_back, parts[3]).inverse()))
    yield Undone("translation taken away", "", {"Transform": [list(step_back), list(parts[3])]})
    for name in OF_FORM[Quaternion]:
        for left in UNIVERSAL[name].undo(parts[3]):
            yield Undone(name, "", {"Transform": [list(parts[2]), list(left)]})


def _undone_names(answer: Plain) -> Iterator[Undone]:
    """Yield a name, a set of names or a tree as it would be if each of its names were written otherwise."""
    yield from (Undone(name, "", left) for name, left in renamed(answer))


def _plain(row: Row, size: int | None) -> Plain:
    return row[0] if size is None else list(row)
