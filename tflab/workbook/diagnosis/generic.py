"""Recognise mistakes that any answer can have (sign, unit, order): undo each one and compare.

A form names the mistakes that it recognises (`Form.mistakes`). What cannot be undone is in `precision.py`,
answers of another type in `wrong_types.py`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import permutations, product
from typing import NamedTuple

from tflab.core import Transform

from ...core.quaternions import to_rpy
from ...text import Text, Texts
from ..answers.form import Form, inside, numbers_of, pose_of
from ..answers.forms import Name, Number, Pose
from ..answers.values import Plain, is_raised, to_plain

__all__ = ["TEXTS", "TOLD", "UNDONE", "Recogniser", "describe_letters", "describe_names", "holds_angles"]

TEXTS = Texts(__file__)

Row = tuple[float, ...]
NOTHING = 10.0  # tolerances: a number below is as good as zero, whatever its unit
TOLD = " | "  # between the name of a mistake and what is told of it, which stands in the answer


class Recogniser(NamedTuple):
    """How a mistake is recognised that an answer of some forms can have.

    Attributes:
        undo: yields what the answer would be without the mistake, each after what is told of it.
        misconception: what is behind it.
        find: yields its name, and what is told of it, where all answers beside the right ones show it.
        is_plain: whether it is seen at once, and so may stand behind another mistake.
        is_exact: whether a number of one or two digits can show it.
    """

    undo: Callable[[Form, Plain], Iterator[tuple[str, Plain]]] | None = None
    misconception: str = ""
    find: Callable[[Form, list[Plain], list[Plain]], Iterator[str]] | None = None
    is_plain: bool = False
    is_exact: bool = False


def _times(*factors: float) -> Callable[[Row], list[Row]]:
    """Return what takes all numbers times each of these factors."""
    return lambda row: [tuple(factor * number for number in row) for factor in factors]


def _taken(*places: int) -> Callable[[Row], list[Row]]:
    """Return what takes the numbers of these places, in this order."""
    return lambda row: [tuple(row[place] for place in places)]


def _reciprocal(row: Row) -> Iterator[Row]:
    if row[0]:
        yield (1.0 / row[0],)


def _double_angle(row: Row) -> Iterator[Row]:
    angle = math.remainder(row[0], math.tau)
    if abs(angle) <= math.pi / 2:  # twice as much as another is the right one but for a full turn
        yield (2.0 * angle,)


def _root(row: Row) -> Iterator[Row]:
    if row[0] > 0.0:
        yield (math.sqrt(row[0]),)


def _square(row: Row) -> Iterator[Row]:
    if row[0] > 0.0:
        yield (row[0] ** 2,)


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
    for place, number in enumerate(row[:3]):  # of a quaternion, w turned round is the inverse
        if number:
            yield (*row[:place], -number, *row[place + 1 :])


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


def _turned_on(row: Row) -> Iterator[Row]:
    """Turn twice as far: the square of a quaternion."""
    x, y, z, w = row
    yield 2.0 * w * x, 2.0 * w * y, 2.0 * w * z, w * w - x * x - y * y - z * z


def _conjugate(row: Row) -> list[Row]:
    return [(-row[0], -row[1], -row[2], row[3])]


NEGATED = _times(-1.0)
POWERS = [10.0**power for power in range(-9, 10) if power]

# -- in which forms -------------------------------------------------------------------------


def _numbers(undo: Callable[[Row], Iterable[Row]], name: str = "", least: float = 0.0) -> Callable:
    """Return how a mistake is undone in the numbers of an answer; of a pose, in those of its rotation."""

    def undone(form: Form, answer: Plain) -> Iterator[tuple[str, Plain]]:
        pose = pose_of(answer) if isinstance(form, Pose) else None
        row = pose[3] if pose else form.numbers(answer)
        is_a_count = isinstance(form, Number) and not form.unit and undo is not NEGATED
        if row is None or is_a_count or form.read(answer) is None:  # or, say, a message in another frame
            return
        if pose:
            lefts = undo(row) if math.hypot(*row) > TINY else ()
            yield from (("", {"Transform": [list(pose[2]), list(left)]}) for left in lefts)
            return
        lefts = [left for left in undo(row) if not least or max(map(abs, left)) > least * form.tolerance]
        told = [(letters_changed(name, row, left), _plain(left)) for left in lefts]
        yield from ((TOLD + letters, left) for letters, left in told if letters)  # what is sure comes first
        yield from (("", left) for _, left in told)

    return undone


def _units(form: Form, answer: Plain) -> Iterator[tuple[str, Plain]]:
    row = form.numbers(answer) if form.read(answer) is not None else None
    for unit, factor in OTHER_UNITS.get(form.unit, {}).items() if row else ():
        left = tuple(number / factor for number in row)
        if max(map(abs, left)) > NOTHING * form.tolerance:
            yield f" {unit}", _plain(left)


def _pose(undo: Callable[[Row, Row], Transform]) -> Callable:
    def undone(_form: Form, answer: Plain) -> Iterator[tuple[str, Plain]]:
        parts = pose_of(answer)
        if parts is not None and math.hypot(*parts[3]) > TINY:
            yield "", to_plain(undo(parts[2], parts[3]))

    return undone


def _transposed(_form: Form, answer: Plain) -> Iterator[tuple[str, Plain]]:
    if pose_of(answer) is None and isinstance(rows := inside(answer), list) and all(numbers_of(r, 4) for r in rows):
        yield "", [list(column) for column in zip(*map(inside, rows), strict=True)]


def _renamed(change: Callable[[str], str]) -> Callable:
    """Return how a name, a set of names or a tree is written otherwise."""

    def undone(form: Form, answer: Plain) -> Iterator[tuple[str, Plain]]:
        left = _changed(answer, change)
        if left != answer and isinstance(getattr(form, "of", Name()), Name):
            yield "", left

    return undone


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


def _back(step: Row, turn: Row) -> Transform:
    return Transform(tuple(-number for number in step), turn)


UNDONE = {
    "unit": Recogniser(_units, is_plain=True, is_exact=True),
    "sign": Recogniser(_numbers(NEGATED), is_plain=True, is_exact=True),
    "one over it": Recogniser(_numbers(_reciprocal)),
    "twice": Recogniser(_numbers(_times(0.5))),
    "half": Recogniser(_numbers(_times(2.0))),
    "half the angle": Recogniser(_numbers(_double_angle)),
    "squared": Recogniser(_numbers(_root)),
    "root": Recogniser(_numbers(_square)),
    "half a turn": Recogniser(_numbers(lambda row: [(row[0] + math.pi,)])),
    "z for the angle": Recogniser(_numbers(_angle_of_z), "M5"),
    "all signs": Recogniser(_numbers(NEGATED), is_plain=True),
    "one sign": Recogniser(_numbers(_one_sign, "one sign")),
    "exchanged": Recogniser(_numbers(_exchanged, "exchanged")),
    "places and signs": Recogniser(_numbers(_places_and_signs, "places and signs")),
    "w first": Recogniser(_numbers(_taken(1, 2, 3, 0)), "M5", is_plain=True),
    "w taken first": Recogniser(_numbers(_taken(3, 0, 1, 2)), "M5", is_plain=True),
    "inverse rotation": Recogniser(_numbers(_conjugate), "M1", is_plain=True),
    "not normalised": Recogniser(_numbers(_scaled), "M5", is_plain=True),
    "whole angle": Recogniser(_numbers(_halved), "M5"),
    "half angle": Recogniser(_numbers(_turned_on), "M5"),
    "other case": Recogniser(_renamed(str.lower), "M14"),
    "slash in front": Recogniser(_renamed(lambda name: name.removeprefix("/")), "M14"),
    "no slash in front": Recogniser(_renamed(lambda name: f"/{name.removeprefix('/')}"), "M14"),
    "space around": Recogniser(_renamed(str.strip), "M14"),
    "other separator": Recogniser(_renamed(lambda n: n if "/" in n else re.sub(r"[_.:-]+", "/", n, count=1)), "M14"),
    "inverse transform": Recogniser(_pose(lambda step, turn: Transform(step, turn).inverse()), "M1", is_plain=True),
    "not turned back": Recogniser(_pose(lambda step, turn: _back(step, turn).inverse()), "M1", is_plain=True),
    "translation taken away": Recogniser(_pose(lambda step, turn: _back(step, turn)), "M3"),
    "transposed": Recogniser(_transposed),
    "power of ten": Recogniser(_numbers(_times(*POWERS), least=NOTHING), is_exact=True),
}


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


LETTERS = "xyzw"
BY_LETTER = {"one sign": "which sign", "exchanged": "which exchanged", "places and signs": "which is right"}  # texts


def letters_changed(name: str, given: Sequence[float], left: Sequence[float]) -> str:
    """Return which numbers of a point a mistake is about that leaves `left`; nothing where that is not sure."""
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


FACTS: dict[str, Callable[[str, str], bool]] = {  # of a name and of the one that is asked for
    "nothing": lambda one, want: not one and bool(want),
    "slash in front of a name": lambda one, want: one.startswith("/") and not want.startswith("/"),
    "slashes in a row": lambda one, want: "//" in one.lstrip("/") and "//" not in want,
    "slash behind": lambda one, want: len(one) > 1 and one.endswith("/") and not want.endswith("/"),
    "too little in front": lambda one, want: bool(one.strip("/")) and want.endswith("/" + one.strip("/")),
    "too much in front": lambda one, want: bool(want) and one.strip("/").endswith("/" + want),
    "other letters": lambda one, want: one != want and one.lower() == want.lower(),
}


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
