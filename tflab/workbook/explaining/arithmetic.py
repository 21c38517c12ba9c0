"""What was computed of what was given?  Where no known mistake fits, the sum itself can often be found and said.

    given   speed_mps 0.73, yaw_rate_radps 0.9, range_m 5.0
    answer  0.657      -->  `speed_mps * yaw_rate_radps`, m/s times rad/s
    answer  (1, 2, 0)  -->  `map_p_base - base_p_laser`

Numbers: one of them, or two joined by + - * /.  Points: up to three, added or
subtracted, or one moved by a pose or two.  Poses: one, two or three, turned round or not.
Of a function: what it computes of its arguments in every call.  Only what fits to the
last digit, and has digits enough not to be luck.
The field calls it symbolic regression.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import reduce
from itertools import combinations, permutations, product
from typing import NamedTuple

from tflab.core import Transform

from ...text import Text
from ..answers.form import Form, inside, numbers_of, pose_of
from ..answers.forms import Angle, Number, Pose, Vector
from ..answers.values import Plain

__all__ = ["as_written", "computed", "computed_in_all", "leaves"]

Row = tuple[float, ...]
MOST_LEAVES = 12  # numbers among the givens; with more of them, luck would find a sum
FEWEST_DIGITS = 3  # that an answer needs so as not to be one by luck
CLOSE = 1e-6  # as a share of the answer
UNITS = {  # by how a given's name ends
    "mps": "m/s", "radps": "rad/s", "degps": "deg/s", "hz": "1/s", "m": "m", "cm": "cm", "mm": "mm", "s": "s",
    "ms": "ms", "rad": "rad", "deg": "deg",
}  # fmt: skip
SAID = Text(
    en="this is what `{sum}` gives{units}. Asked for: {wanted}.",
    ko="`{sum}`의 값입니다{units}. 필요한 것: {wanted}.",
)
IN_ALL = Text(
    en="wherever there is an answer, this is what `{sum}` gives{units}. Asked for: {wanted}.",
    ko="답이 있는 호출에서는 언제나 `{sum}`의 값입니다{units}. 필요한 것: {wanted}.",
)
MOST_POSES = 3  # that are joined
FEWEST_CALLS = 3  # with results of their own, for a sum to be no luck
JOINED: tuple[tuple[str, str, str, Callable[[float, float], float]], ...] = (
    ("+", "and", "와(과)", lambda a, b: a + b),
    ("-", "and", "와(과)", lambda a, b: a - b),
    ("*", "times", "×", lambda a, b: a * b),
    ("/", "by", "÷", lambda a, b: a / b if b else math.nan),
)


class _Sum(NamedTuple):
    """How something was computed, the units that went in (in both languages), and what it gives."""

    text: str
    units: Text
    value: Row


def computed(form: Form, answer: Plain, given: dict[str, Plain] | None) -> tuple[str, Text] | None:
    """Return what an answer was computed by, and what to say of it; None if no sum of what was given gives it."""
    row = _row(form, answer)
    if row is None or max(map(_digits, row)) < FEWEST_DIGITS - 1:
        return None
    ways = list(_sums(form, given or {}))
    found = next((way for way in ways if _is_same(form, row, way.value)), None)
    if found is None and isinstance(form, Number | Angle):
        ways = [_Sum(f"-({way.text})", way.units, (-way.value[0],)) for way in ways]
        found = next((way for way in ways if _is_same(form, row, way.value)), None)
    if found is None or (" " in found.text and max(map(_digits, row)) < FEWEST_DIGITS):
        return None
    return f"computed: {found.text}", _said(SAID, found, form)


def computed_in_all(form: Form, args: Sequence[list[Plain]], answers: Sequence[Plain]) -> tuple[str, Text] | None:
    """Return what a function computes of its arguments in every call, and what to say of it; None if no sum does."""
    rows = [_row(form, answer) for answer in answers]
    if len(rows) < FEWEST_CALLS or None in rows or len({str(row) for row in rows}) < FEWEST_CALLS:
        return None
    left: dict[str, _Sum] | None = None
    for row, call in zip(rows, args, strict=True):
        given = {f"argument {number}": plain for number, plain in enumerate(call, start=1)}
        fits = {way.text: way for way in _sums(form, given, zeros=True) if _is_same(form, row, way.value)}
        left = {text: way for text, way in (fits if left is None else left).items() if text in fits}
        if not left:
            return None
    found = min((left or {}).values(), key=lambda way: len(way.text))
    return f"computed: {found.text}", _said(IN_ALL, found, form)


def _said(words: Text, found: _Sum, form: Form) -> Text:
    return words.filled(sum=found.text, units=found.units, wanted=form.wanted())


def _row(form: Form, answer: Plain) -> Row | None:
    """Return an answer's numbers, None if it has none of this form; of a pose those of its matrix."""
    if form.read(answer) is None:  # of another shape, or in another frame: that says more
        return None
    if isinstance(form, Pose):
        parts = pose_of(answer)
        return None if parts is None or not any(parts[3]) else _matrix(Transform(parts[2], parts[3]))
    return numbers_of(answer, form.size if isinstance(form, Vector) else None)


def _matrix(pose: Transform) -> Row:
    return tuple(float(number) for line in pose.matrix() for number in line)


def _sums(form: Form, given: dict[str, Plain], *, zeros: bool = False) -> Iterator[_Sum]:
    """Yield what may be computed of what was given, for an answer of this form, the plainest first."""
    if isinstance(form, Vector):
        yield from _of_points(form.size, given, zeros)
        yield from _of_moved(given) if form.size == 3 else ()
    elif isinstance(form, Number | Angle):
        yield from _of_numbers(given)
    elif isinstance(form, Pose):
        yield from (_Sum(text, Text("", ""), _matrix(pose)) for text, pose in _products(given))


def _poses(given: dict[str, Plain]) -> list[tuple[str, Transform]]:
    """Return the poses among the givens and their inverses, by how they are written."""
    parts = [(name, pose_of(leaf)) for name, leaf in leaves(given)]
    held = [(name, Transform(each[2], each[3])) for name, each in parts if each is not None and any(each[3])]
    return [row for name, pose in held[:MOST_POSES] for row in ((name, pose), (f"{name}.inverse()", pose.inverse()))]


def _products(given: dict[str, Plain]) -> Iterator[tuple[str, Transform]]:
    """Yield the poses among the givens, what two of them give, and three."""
    held = _poses(given)
    yield from held
    for count in (2, 3):
        for chosen in product(held, repeat=count):
            text = " @ ".join(name for name, _ in chosen)
            yield text, reduce(lambda left, right: left @ right, (pose for _, pose in chosen))


def _of_moved(given: dict[str, Plain]) -> Iterator[_Sum]:
    """Yield each point among the givens moved by a pose, or by two."""
    points = [(name, row) for name, leaf in leaves(given) if (row := numbers_of(leaf, 3)) is not None]
    held = _poses(given)
    for name, row in points[:MOST_POSES]:
        for text, pose in [*held, *((f"({a} @ {b})", one @ other) for (a, one), (b, other) in permutations(held, 2))]:
            yield _Sum(f"{text}.apply({name})", Text("", ""), tuple(pose.apply(row)))


def leaves(given: dict[str, Plain], before: str = "") -> Iterator[tuple[str, Plain]]:
    """Yield what was given, by name; of a dict its members, too."""
    for name, held in given.items():
        yield before + name, held
        if isinstance(inner := inside(held), dict) and "Transform" not in inner:
            yield from leaves(inner, f"{before}{name}: ")


def _of_numbers(given: dict[str, Plain]) -> Iterator[_Sum]:
    held = _held(given)
    for name, value in held:
        yield _Sum(name, _units(_unit(name)), (value,))
        for text, changed in _changed(value):
            yield _Sum(text.format(name), Text("", ""), (changed,))
    for (one, a), (other, b) in permutations(held, 2):
        for sign, en, ko, join in JOINED:
            if sign in "+*" and one > other:
                continue  # the same as the other way round
            units = _units_of(_unit(one), _unit(other), en, ko) if not _is_plain_sum(sign, one, other) else _units("")
            yield _Sum(f"{one} {sign} {other}", units, (join(a, b),))


def _held(given: dict[str, Plain]) -> list[tuple[str, float]]:
    """Return the numbers among the givens, and the members of lists where there are few; none where there are many."""
    single = [(name, row[0]) for name, leaf in leaves(given) if (row := numbers_of(leaf, None)) is not None]
    lists = [(name, inside(leaf)) for name, leaf in leaves(given) if isinstance(inside(leaf), list)]
    members = [(f"{name}[{place}]", member) for name, held in lists for place, member in enumerate(held)]
    listed = [(name, row[0]) for name, member in members if (row := numbers_of(member, None)) is not None]
    if len(single) + len(listed) <= MOST_LEAVES:
        return single + listed
    return single if len(single) <= MOST_LEAVES else []


def _changed(value: float) -> Iterator[tuple[str, float]]:
    """Yield what one may make of a single number, and how it is written."""
    yield "math.radians({})", math.radians(value)
    yield "math.degrees({})", math.degrees(value)
    yield from (("1 / {}", 1.0 / value),) if value else ()
    for angle, of in ((value, "{}"), (math.radians(value), "math.radians({})")):
        for function in (math.sin, math.cos, math.tan):
            yield f"math.{function.__name__}({of})", function(angle)


def _of_points(size: int, given: dict[str, Plain], zeros: bool) -> Iterator[_Sum]:
    held = []
    for name, leaf in leaves(given):
        parts = pose_of(leaf)
        row = numbers_of(leaf, size) if parts is None else parts[2][:size]
        if row is not None and (zeros or any(row)):
            held.append((name if parts is None else f"{name}.translation", row))
    for count in (2, 3):
        for chosen in combinations(held[:MOST_LEAVES], count):
            for signs in product((1.0, -1.0), repeat=count):
                yield _signed_sum(chosen, signs)


def _signed_sum(chosen: tuple[tuple[str, Row], ...], signs: tuple[float, ...]) -> _Sum:
    text = as_written((sign, name) for sign, (name, _) in zip(signs, chosen, strict=True))
    rows = [[sign * number for number in row] for sign, (_, row) in zip(signs, chosen, strict=True)]
    return _Sum(text, Text("", ""), tuple(map(sum, zip(*rows, strict=True))))


def as_written(terms: Iterable[tuple[float, str]]) -> str:
    """Return a sum as one writes it, of its terms with their signs: what is added first, then what is taken off."""
    order = sorted(terms, key=lambda term: term[0] < 0)
    return " ".join(f"{'-' if sign < 0 else '+'} {text}" for sign, text in order).removeprefix("+ ")


def _unit(name: str) -> str:
    return UNITS.get(name.rpartition("_")[2], "")


def _units(unit: str) -> Text:
    return Text(f" ({unit})", f"({unit})") if unit else Text("", "")


def _units_of(one: str, other: str, en: str, ko: str) -> Text:
    return Text(f" ({one} {en} {other})", f"({one} {ko} {other})") if one and other else Text("", "")


def _is_plain_sum(sign: str, one: str, other: str) -> bool:
    return sign in "+-" and _unit(one) == _unit(other)


def _is_same(form: Form, row: Row, value: Row) -> bool:
    is_near = all(math.isfinite(number) for number in value) and math.dist(row, value) <= CLOSE * math.hypot(*row)
    if not is_near and isinstance(form, Angle):  # a whole turn more or less is the same
        return all(map(math.isfinite, value)) and abs(math.remainder(row[0] - value[0], math.tau)) <= CLOSE
    return is_near


def _digits(number: float) -> int:
    """Return how many digits a number has, without the zeros around them."""
    return len(f"{abs(number):.9f}".replace(".", "").strip("0"))
