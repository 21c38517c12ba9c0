"""Recognise how a point was computed: the terms of a 2D rotation, or given numbers in other places."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np

from ...text import Text, Texts
from ..answers.form import Form, inside, numbers_of, pose_of
from ..answers.forms import Number, Vector
from ..answers.values import Plain
from .coding_patterns import leaves
from .generic import LETTERS

__all__ = ["FEWEST_CALLS", "poses_among", "put_together", "turned_in_all"]

TEXTS = Texts(__file__)

FEWEST_CALLS = 4  # more than there are terms: so many numbers are no luck
MOST_POSES = 2
CLOSE = 1e-6
PLANAR = ("x", "y", "yaw")
UNLIKE = {" * ": "angle_itself", " / cos": "divided", " * tan": "tangent"}  # what is done with an angle, not a rotation
TIMES = re.compile(" [*/] ")
Sum = dict[str, float]  # terms, as they are written, each with its sign


def turned_in_all(
    form: Form, args: Sequence[list[Plain]], answers: Sequence[Plain], wanted: Sequence[Plain]
) -> tuple[str, Text] | None:
    """Return which terms a function's number has in every call, and what to say; None if no few terms give it."""
    rows = [[numbers_of(plain, None) for plain in plains] if isinstance(form, Number) else []
            for plains in (answers, wanted)]  # fmt: skip
    terms = list(_terms(args)) if rows[0] and None not in rows[0] and len(rows[0]) >= FEWEST_CALLS else []
    if not terms or np.ptp(numbers := np.array([row[0] for row in rows[0]])) <= CLOSE:
        return None
    found = _sum_of(terms, numbers)
    if not found:
        return None
    right = _sum_of(terms, np.array([row[0] for row in rows[1]])) if None not in rows[1] else {}
    seen = _seen(found, right)
    return ("rotation terms", TEXTS["said"].filled(seen=seen)) if seen else None


def _seen(found: Sum, right: Sum) -> Text | None:
    """Return where a sum differs from the one that is asked for; None if that cannot be said."""
    of_found, of_right = _by_number(found), _by_number(right)
    if distance := next((name for name in of_found if name.startswith("hypot")), ""):
        return TEXTS["distance"].filled(what=distance)
    if not right:
        return None
    said = [(TEXTS["missing"], name) for name in of_right if name not in of_found]
    for name, terms in of_found.items():
        if name not in of_right:
            said.append((TEXTS["too_much"], name))
        else:
            said += _differences(name, terms, of_right[name])
    return Text.joined(*(words.filled(what=what) for words, what in dict.fromkeys(said))) if said else None


def _by_number(terms: Sum) -> dict[str, Sum]:
    """Return the terms of each number that goes in, with what it is multiplied by and the sign."""
    by_number: dict[str, Sum] = {}
    for text, sign in terms.items():
        number = TIMES.split(text, maxsplit=1)[0]
        by_number.setdefault(number, {})[text.removeprefix(number)] = sign
    return by_number


def _differences(name: str, terms: Sum, right: Sum) -> Iterator[tuple[Text, str]]:
    """Yield in what the terms of one number differ from those that are asked for, and of what that is said."""
    if len(terms) > 1 or len(right) > 1:
        yield from ((TEXTS["too_much"], name + factor) for factor in terms if factor not in right)
        return
    ((factor, sign),), ((other, wanted),) = terms.items(), right.items()
    (function, angle), (others, another) = _parts(factor), _parts(other)
    if factor == other:
        yield from ((TEXTS["other_sign"], name + factor),) if sign != wanted else ()
    elif not factor or not other:
        yield (TEXTS["turned_too"] if factor else TEXTS["not_turned"]), name
    elif function in UNLIKE:
        yield TEXTS[UNLIKE[function]], name
    else:
        yield from ((TEXTS["other_of_two"], name),) if function != others else ()
        yield from ((TEXTS["other_angle"], name),) if angle != another else ()


def _parts(factor: str) -> tuple[str, str]:
    """Return what is done with an angle, and the angle: " * cos", "argument 1: yaw"."""
    function, bracket, angle = factor.partition("(")
    return (function, angle[:-1]) if bracket else (factor[: len(" * ")], factor[len(" * ") :])


def _terms(args: Sequence[list[Plain]]) -> Iterator[tuple[str, np.ndarray]]:
    """Yield what may stand in the formula, with what it is in each call."""
    poses = poses_among(args)
    if not 0 < len(poses) <= MOST_POSES:
        return
    yaws = {f"argument {at + 1}: yaw": pose["yaw"] for at, pose in poses.items()}
    angles = yaws | {f"{name} / 2": yaw / 2 for name, yaw in yaws.items()}
    angles |= {f"{of.__name__}({name})": of(yaw) for name, yaw in yaws.items() for of in (np.degrees, np.radians)}
    if len(yaws) == MOST_POSES:
        (one, a), (other, b) = yaws.items()
        angles |= {f"{one} + {other}": a + b, f"{one} - {other}": a - b, f"{one} + {other} / 2": a + b / 2}
    for at, pose in poses.items():
        x, y = (f"argument {at + 1}: {name}" for name in PLANAR[:2])
        for text, number in ((x, pose["x"]), (y, pose["y"]), (f"hypot({x}, {y})", np.hypot(pose["x"], pose["y"]))):
            yield text, number
            for angle, value in angles.items():
                yield f"{text} * cos({angle})", number * np.cos(value)
                yield f"{text} * sin({angle})", number * np.sin(value)
            for angle, value in yaws.items():
                yield f"{text} * {angle}", number * value
                yield f"{text} / cos({angle})", number / np.cos(value)
                yield f"{text} * tan({angle})", number * np.tan(value)


def poses_among(args: Sequence[list[Plain]]) -> dict[int, dict[str, np.ndarray]]:
    """Return the arguments that are poses in the plane, by their place: x, y and yaw, call by call."""
    rows = ((at, _poses([call[at] for call in args])) for at in range(min(map(len, args), default=0)))
    return {at: held for at, held in rows if held is not None}


def _poses(plains: Sequence[Plain]) -> dict[str, np.ndarray] | None:
    """Return x, y and yaw of an argument, call by call; None if it is no pose in the plane."""
    held = [inside(plain) for plain in plains]
    if not all(isinstance(pose, dict) and set(PLANAR) <= pose.keys() for pose in held):
        return None
    rows = {name: [numbers_of(pose[name], None) for pose in held] for name in PLANAR}
    if any(None in row for row in rows.values()):
        return None
    return {name: np.array([number[0] for number in row]) for name, row in rows.items()}


def _sum_of(terms: Sequence[tuple[str, np.ndarray]], wanted: np.ndarray, before: int = 2, close: float = CLOSE) -> Sum:
    values = np.array([value for _, value in terms])
    signed = np.concatenate([values, -values])
    for count in range(before + 1):
        sums, members = _sums(signed, len(terms), count)
        if found := min(_fitting(signed, len(terms), wanted, sums, members, close), default=None):
            return {terms[at % len(terms)][0]: 1.0 if at < len(terms) else -1.0 for at in found}
    return {}


def _sums(signed: np.ndarray, size: int, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the sums of none, one or two terms with their signs, and which terms those are."""
    every = np.arange(len(signed))
    if count == 0:
        return np.zeros((1, signed.shape[1])), np.zeros((1, 0), dtype=int)
    if count == 1:
        return signed, every[:, None]
    one, other = np.meshgrid(every, every, indexing="ij")
    pairs = np.stack([one, other], axis=-1)[one % size < other % size]
    return signed[pairs[:, 0]] + signed[pairs[:, 1]], pairs


def _fitting(
    signed: np.ndarray, size: int, wanted: np.ndarray, sums: np.ndarray, members: np.ndarray, close: float
) -> Iterator[tuple[int, ...]]:
    """Yield the terms that give the wanted numbers together with one of these sums, in their order."""
    order = np.argsort(sums[:, 0])
    first = sums[order, 0]
    rests = wanted - signed
    starts, ends = (
        np.searchsorted(first, rests[:, 0] + off, side) for off, side in ((-close, "left"), (close, "right"))
    )
    for last in np.flatnonzero(starts < ends):
        for row in order[starts[last] : ends[last]]:
            places = [int(at) for at in (*members[row], last)]
            if len({at % size for at in places}) == len(places) and np.max(np.abs(sums[row] - rests[last])) <= close:
                yield tuple(sorted(places, key=lambda at: at % size))


CLOSE = 1e-6


def put_together(form: Form, answer: Plain, expected: Plain, given: dict[str, Plain] | None) -> tuple[str, Text] | None:
    """Return in which places and with which signs the numbers of a point that was given stand in an answer; else None.

    Only where no two of them are alike in size, and none is 0: then it is no chance.
    """
    have = numbers_of(answer, form.size) if isinstance(form, Vector) and form.size == len(LETTERS) else None
    for name, row in _points(len(LETTERS), given or {}) if have else ():
        if _are_distinct(row, form.tolerance) and (places := _order(have, row)):
            want = numbers_of(expected, form.size)
            judged = _judged(have, want, form.tolerance) if want else TEXTS["asked"]
            said = TEXTS["put"].filled(name=name, places=places, judged=judged)
            return f"put together: {places}", Text.joined(said, _stands_twice(places))
    return None


def _stands_twice(places: str) -> Text | None:
    """Return that a letter stands in two places, whatever its sign; None if none does."""
    letters = places.replace("-", "").split(", ")
    letter = next((one for one in letters if letters.count(one) == 2), None)
    return TEXTS["twice"].filled(letter=letter) if letter else None


def _judged(have: Sequence[float], want: Sequence[float], tolerance: float) -> Text:
    """Return which numbers are right, which have only the wrong sign, and which stand where another belongs."""
    found: dict[Text, list[str]] = {TEXTS["right"]: [], TEXTS["components_other_sign"]: [], TEXTS["other_number"]: []}
    for letter, number, wanted in zip(LETTERS, have, want, strict=True):
        is_right, is_turned = abs(number - wanted) <= tolerance, abs(number + wanted) <= tolerance
        words = TEXTS["right"] if is_right else TEXTS["components_other_sign"] if is_turned else TEXTS["other_number"]
        found[words].append(letter)
    said = (words.filled(names=", ".join(letters)) for words, letters in found.items() if letters)
    return Text(*(f"{text}." for text in Text.joined(*said, between="; ")))


def _are_distinct(row: Sequence[float], tolerance: float) -> bool:
    sizes = [0.0, *map(abs, row)]
    return min(abs(a - b) for a, b in combinations(sizes, 2)) > 2 * tolerance


def _order(have: Sequence[float], row: Sequence[float]) -> str:
    """Return the letters of a point's numbers as they stand, with their signs, some perhaps twice; "" if not all do."""
    places = [_place(number, row) for number in have]
    return ", ".join(places) if all(places) else ""


def _place(number: float, row: Sequence[float]) -> str:
    """Return the letter, and the sign, of the number of a point that this is; "" if it is none of them."""
    found = (letter for letter, one in zip(LETTERS, row, strict=True) if abs(abs(number) - abs(one)) <= CLOSE)
    letter = next(found, "")
    return f"-{letter}" if letter and number * row[LETTERS.index(letter)] < 0 else letter


def _points(size: int, given: dict[str, Plain]) -> Iterator[tuple[str, tuple[float, ...]]]:
    for name, leaf in leaves(given):
        parts = pose_of(leaf)
        row = numbers_of(leaf, size) if parts is None else parts[2][:size]
        if row is not None:
            yield (name if parts is None else f"{name}.translation"), tuple(row)
