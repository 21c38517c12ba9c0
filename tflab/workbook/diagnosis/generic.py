"""Undo mistakes that any answer can have: a sign, a unit, an order of numbers."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence
from itertools import permutations, product
from typing import NamedTuple

from tflab.core import Transform

from ...core.quaternions import to_rpy
from ...text import Text, Texts
from ..answers.form import Form, inside, numbers_of, pose_of
from ..answers.forms import Angle, Command, Name, Number, Pose, Quaternion, Set, Tree, Vector
from ..answers.values import Plain, is_raised, to_plain

__all__ = [
    "LETTERS",
    "OF_FORM",
    "OTHER_UNITS",
    "PLAIN_TO_SEE",
    "TEXTS",
    "UNIVERSAL",
    "corrections",
    "describe_letters",
    "describe_names",
    "holds_angles",
    "letters_changed",
    "renamed",
    "unfilled",
]

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
# What is seen at once, and so may stand behind another mistake; of the others nobody could say that it was just that.
PLAIN_TO_SEE = {
    *("unit", "sign", "all signs", "w first", "w taken first", "not normalised"),
    *("inverse rotation", "inverse transform", "not turned back"),
}


def corrections(form: Form, answer: Plain) -> Iterator[Undone]:
    """Yield what an answer would be without each of the mistakes that an answer of its form can have."""
    if isinstance(form, Pose):
        yield from _undone_pose(answer)
    elif isinstance(form, Name | Tree) or (isinstance(form, Set) and isinstance(form.of, Name)):
        yield from _undone_names(answer)
    elif type(form) in OF_FORM and form.read(answer) is not None:  # not, say, a message in another frame
        yield from _undone_numbers(form, answer)


def _undone_numbers(form: Form, answer: Plain) -> Iterator[Undone]:
    row = form.numbers(answer)
    for unit, factor in OTHER_UNITS.get(form.unit, {}).items():
        left = tuple(number / factor for number in row)
        if max(map(abs, left)) > NOTHING * form.tolerance:
            yield Undone("unit", unit, _plain(left))
    is_a_count = isinstance(form, Number) and not form.unit
    for name in ("sign",) if is_a_count else OF_FORM[type(form)]:
        lefts = list(UNIVERSAL[name].undo(row))
        if isinstance(form, Vector):  # what is sure of a number by its name comes first
            yield from (Undone(name, f"| {told}", _plain(left)) for left in lefts
                        if (told := letters_changed(name, row, left)))  # fmt: skip
        yield from (Undone(name, "", _plain(left)) for left in lefts
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


def _plain(row: Row) -> Plain:
    return row[0] if len(row) == 1 else list(row)


OTHER_UNITS = {
    "m": {"mm": 1e3, "cm": 1e2, "km": 1e-3},
    "mm": {"m": 1e-3, "cm": 0.1},
    "rad": {"degrees": math.degrees(1.0)},
    "s": {"ns": 1e9, "ms": 1e3, "us": 1e6},
    "ms": {"s": 1e-3, "ns": 1e6},
    "ns": {"s": 1e-9, "ms": 1e-6},
    "m/s": {"mm/s": 1e3, "km/h": 3.6},
    "rad/s": {"degrees/s": math.degrees(1.0)},
}


LETTERS = "xyz"
BY_LETTER = {"one sign": "which sign", "exchanged": "which exchanged", "places and signs": "which is right"}  # texts


def letters_changed(name: str, given: Sequence[float], left: Sequence[float]) -> str:
    """Return which numbers of a point this mistake is about, as they are named; nothing where that is not sure.

    Args:
        name: of the mistake, as in UNIVERSAL.
        given: the numbers of the answer.
        left: the same without the mistake.
    """
    if name not in BY_LETTER or len(given) > len(LETTERS):
        return ""
    pairs = zip(LETTERS, given, left, strict=False)
    moved, kept = [], []
    for letter, one, other in pairs:
        (kept if one == other else moved).append(letter)
    if name == "places and signs":
        return kept[0] if len(kept) == 1 and len(moved) == 2 else ""
    if name == "one sign":
        return moved[0] if len(moved) == 1 else ""
    return ", ".join(moved) if len(moved) == 2 else ""


def describe_letters(name: str, told: str) -> Text | None:
    """Return what is said of a mistake and of these numbers; None of another mistake."""
    if name not in BY_LETTER or not told:
        return None
    one, _, other = told.partition(", ")
    return TEXTS[BY_LETTER[name]].filled(told=Text(f"{one} and {other}", f"{one}와 {other}") if other else told)


TINY = 1e-6


def holds_angles(given: Sequence[float], wanted: Sequence[float]) -> bool:
    """Return whether the first three numbers are roll, pitch and yaw of the turn that is wanted, and not all 0."""
    angles = to_rpy(wanted)
    return any(angles) and all(abs(one - other) < TINY for one, other in zip(given, angles, strict=False))


RENAMED: dict[str, Callable[[str], str]] = {
    "other case": str.lower,
    "slash in front": lambda name: name.removeprefix("/"),
    "no slash in front": lambda name: name if name.startswith("/") else f"/{name}",
    "space around": str.strip,
    "other separator": lambda name: re.sub(r"[_.:-]+", "/", name, count=1) if "/" not in name else name,
}
BRACES = re.compile(r"(?<!\$)\{[A-Za-z_][^{}:\"\s]*(?:\s[-+*/]\s?[^{}:\"\s]+)*(?::(?:[.\d]*[a-z]|\.\d+))?\}")
FACTS: dict[str, Callable[[str, str], bool]] = {  # of a name and of the one that is asked for
    "nothing": lambda one, want: not one and bool(want),
    "slash in front of a name": lambda one, want: one.startswith("/") and not want.startswith("/"),
    "slashes in a row": lambda one, want: "//" in one.lstrip("/") and "//" not in want,
    "slash behind": lambda one, want: len(one) > 1 and one.endswith("/") and not want.endswith("/"),
    "too little in front": lambda one, want: bool(one.strip("/")) and want.endswith("/" + one.strip("/")),
    "too much in front": lambda one, want: bool(want) and one.strip("/").endswith("/" + want),
    "other letters": lambda one, want: one != want and one.lower() == want.lower(),
}


def unfilled(form: Form, outcomes: Sequence[Plain]) -> Text | None:
    """Return what to say of texts in whose braces nothing was filled in; None if there is none."""
    texts = [outcome for outcome in outcomes if isinstance(outcome, str)]
    if not isinstance(form, Name | Command) or len(texts) < len(outcomes):
        return None
    first = next(filter(None, map(BRACES.search, texts)), None)
    if first is None:
        return None
    return TEXTS["unfilled"].filled(text=first[0])


def describe_names(form: Form, outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> Text | None:
    """Return what can be seen at the names that a function gives; None unless that covers all that are wrong."""
    if not isinstance(form, Name) or any(map(is_raised, wanted)):
        return None
    wrong = _that_differ(outcomes, wanted)
    shows = {name: [pair for pair in wrong if is_shown(*pair)] for name, is_shown in FACTS.items()}
    seen = [pair for pairs in shows.values() for pair in pairs]
    if not wrong or any(pair not in seen for pair in wrong):
        return None
    said = [_filled(TEXTS[name], pairs, wrong) for name, pairs in shows.items() if pairs]
    return Text("; ".join(words.en for words in said) + ".", ". ".join(words.ko for words in said) + ".")


def _that_differ(outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> list[tuple[str, str]]:
    """Return the names that are wrong, each beside the one that is asked for; none if one is no text."""
    wrong = [(given, want) for given, want in zip(outcomes, wanted, strict=True) if given != want]
    return wrong if all(isinstance(word, str) for pair in wrong for word in pair) else []


def _filled(words: Text, pairs: list[tuple[str, str]], wrong: list[tuple[str, str]]) -> Text:
    return TEXTS["in"].filled(count=len(pairs), of=len(wrong), fact=words.filled(one=pairs[0][0]))


def renamed(answer: Plain) -> Iterator[tuple[str, Plain]]:
    """Yield a name, a set of names or a tree as it would be if each of its names were written otherwise."""
    ways = {name: _changed(answer, change) for name, change in RENAMED.items()}
    yield from ((name, left) for name, left in ways.items() if left != answer)


def _changed(plain: Plain, change: Callable[[str], str]) -> Plain:
    if isinstance(plain, str):
        return change(plain)
    if isinstance(plain, list):
        return [_changed(member, change) for member in plain]
    if isinstance(plain, dict) and set(plain) in ({"tuple"}, {"set"}):
        return {kind: _changed(held, change) for kind, held in plain.items()}
    if isinstance(plain, dict) and set(plain) == {"dict"} and isinstance(plain["dict"], dict):
        return {"dict": {change(key): _changed(value, change) for key, value in plain["dict"].items()}}
    return plain
