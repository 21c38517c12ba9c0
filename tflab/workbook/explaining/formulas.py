"""By which formula was an answer computed?  Of angles, ranges, points and poses that were given, if no slip gives it.

    given       range_m 19.8, written_yaw_rad 1.55         answer  14.2
                -->  `1000 * range_m * (1 - cos(pi / 2 - written_yaw_rad))`
    a quaternion of two angles, or of a function's one     -->  each of its four numbers
    a point that was turned by hand                        -->  each number that is wrong, term by term

Only what fits to the ninth digit: an answer with fewer was rounded, and many formulas would come to it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import product

import numpy as np

from tflab.core import Transform

from ...text import Text
from ..answers.form import Form, numbers_of, pose_of
from ..answers.forms import Number, Quaternion, Vector
from ..answers.values import Plain
from .arithmetic import leaves
from .components import place_by_place
from .turning import sum_of

__all__ = ["is_moved_from", "of_formula", "of_formula_in_all"]

CLOSE = 1e-9
FEWEST_CALLS = 4
MOST_ANGLES = 2
MOST_POSES = 2
MOST_POINTS = 3
NUMBERS = "xyzw"
SAID = Text(
    en="this is what `{sum}` gives. Compare it, factor by factor, with what has to be computed.",
    ko="`{sum}`의 값입니다. 구해야 할 식과 하나씩 비교하십시오.",
)
FOUR = Text(
    en="the four numbers are `({sum})`. Compare each with what belongs in its place.",
    ko="숫자 네 개는 `({sum})`의 값입니다. 하나씩 그 자리에 올 것과 비교하십시오.",
)
NO_ROTATION = Text(
    en="The squares of the four do not add up to 1, as those of any rotation do.",
    ko="숫자 네 개의 제곱을 더하면 1이 되지 않습니다. 회전이라면 언제나 1입니다.",
)
Terms = list[tuple[str, np.ndarray]]

OF_AN_ANGLE: tuple[tuple[str, Callable[[float], float]], ...] = (
    ("{}", float),
    ("sin({})", math.sin),
    ("cos({})", math.cos),
    ("tan({})", math.tan),
    ("atan({})", math.atan),
    ("(1 - cos({}))", lambda angle: 1.0 - math.cos(angle)),
    ("(1 - sin({}))", lambda angle: 1.0 - math.sin(angle)),
    ("sqrt(1 - cos({}))", lambda angle: math.sqrt(1.0 - math.cos(angle))),
    ("(1 / cos({}) - 1)", lambda angle: 1.0 / math.cos(angle) - 1.0),
    ("({}) / (pi / 2)", lambda angle: angle / (math.pi / 2)),
    ("degrees({})", math.degrees),
    ("radians({})", math.radians),
    *(
        (f"{name}({unit}({{}}))", lambda angle, of=of, to=to: of(to(angle)))
        for name, of in (("sin", math.sin), ("cos", math.cos), ("tan", math.tan))
        for unit, to in (("degrees", math.degrees), ("radians", math.radians))
    ),
)
OF_A_NUMBER: tuple[tuple[str, Callable[[float], float]], ...] = (
    ("{} * ", float),
    ("{} / 2 * ", lambda number: number / 2.0),
    ("2 * {} * ", lambda number: 2.0 * number),
    ("{} ** 2 * ", lambda number: number**2),
    ("{} ** 2 / 2 * ", lambda number: number**2 / 2.0),
    ("1 / {} * ", lambda number: 1.0 / number),
    ("int({}) * ", lambda number: float(int(number))),
    ("round({}) * ", lambda number: float(round(number))),
)
PARTS_OF_AN_ANGLE = (
    ("{}", 1.0),
    ("{} / 2", 0.5),
    ("2 * {}", 2.0),
    ("{} / 4", 0.25),
    ("radians({} / 2)", math.radians(0.5)),
    ("radians({})", math.radians(1.0)),
    ("degrees({} / 2)", math.degrees(0.5)),
)
SCALES = (("", 1.0), ("100 * ", 100.0), ("1000 * ", 1000.0))


def of_formula(form: Form, answer: Plain, expected: Plain, given: dict[str, Plain] | None) -> tuple[str, Text] | None:
    """Return by which formula a value was computed, and what to say; None if none of those that are tried gives it."""
    if isinstance(form, Number):
        return _of_a_number(answer, given or {})
    if isinstance(form, Quaternion):
        angles = [(name, np.array([value])) for name, value in _angles(given or {})]
        return _of_halves([answer], angles)
    if isinstance(form, Vector) and form.size == 3:
        return place_by_place(form, answer, expected, lambda number, place: _turned(number, place, given or {}))
    return None


def of_formula_in_all(form: Form, args: Sequence[list[Plain]], answers: Sequence[Plain]) -> tuple[str, Text] | None:
    """Return by which formula a function computes a quaternion of an angle in every call; None if by none of these."""
    if not isinstance(form, Quaternion) or len(args) < FEWEST_CALLS:
        return None
    columns = ([numbers_of(call[at], None) for call in args] for at in range(min(map(len, args))))
    angles = [(f"argument {at}", np.array([row[0] for row in rows if row]))
              for at, rows in enumerate(columns, start=1) if None not in rows]  # fmt: skip
    return next(filter(None, (_of_halves(answers, [angle]) for angle in angles)), None)


def _angles(given: dict[str, Plain]) -> list[tuple[str, float]]:
    held = [(name, numbers_of(leaf, None)) for name, leaf in leaves(given) if name.endswith("_rad")]
    return [(name, row[0]) for name, row in held if row is not None][:MOST_ANGLES]


# -- a number ------------------------------------------------------------------------------


def _of_a_number(answer: Plain, given: dict[str, Plain]) -> tuple[str, Text] | None:
    row = numbers_of(answer, None)
    if row is None or not row[0]:
        return None
    angles = _angles(given)
    held = [(name, numbers_of(leaf, None)) for name, leaf in leaves(given)]
    others = [(name, one[0]) for name, one in held if one is not None and one[0] and name not in dict(angles)]
    for text, value in _products(angles, others[:MOST_POINTS]):
        if abs(abs(row[0]) - abs(value)) <= CLOSE * abs(row[0]):
            return f"computed: {text}", SAID.filled(sum=text if row[0] * value > 0 else f"-({text})")
    return None


def _products(angles: Sequence[tuple[str, float]], others: Sequence[tuple[str, float]]) -> Iterator[tuple[str, float]]:
    """Yield what may be made of an angle, times a number or nothing, in metres or what is smaller."""
    factors = [("", 1.0), *((text.format(name), of(value)) for name, value in others for text, of in OF_A_NUMBER)]
    for name, value in angles:
        missing = ((name, value), (f"pi / 2 - {name}", math.pi / 2 - value), (f"pi - {name}", math.pi - value),
                   (f"2 * pi - {name}", math.tau - value), (f"1.5 - {name}", 1.5 - value),
                   (f"1.6 - {name}", 1.6 - value))  # fmt: skip
        for (angle, radians), (text, of) in product(missing, OF_AN_ANGLE):
            made = f"({angle})" if text == "{}" and " " in angle else text.format(angle)
            for (factor, by), (scale, times) in product(factors, SCALES):
                yield f"{scale}{factor}{made}", times * by * of(radians)


# -- a quaternion --------------------------------------------------------------------------


def _of_halves(answers: Sequence[Plain], angles: Terms) -> tuple[str, Text] | None:
    """Return of what each of the four numbers was made, in all answers; None if one is of nothing that is known."""
    rows = [numbers_of(answer, len(NUMBERS)) for answer in answers]
    if not angles or None in rows or len(angles) > MOST_ANGLES:
        return None
    columns = np.array(rows, dtype=float).T
    terms = [("1", np.ones(len(rows))), *_of_angles(angles)]
    found = [sum_of(terms, column, 1, CLOSE) if np.any(column) else "0" for column in columns]
    if not all(found) or len(set(found)) < 2:
        return None
    text = ", ".join(found)
    is_rotation = np.allclose(np.sum(columns**2, axis=0), 1.0, atol=1e-3)
    return f"computed: {text}", Text.joined(FOUR.filled(sum=text), None if is_rotation else NO_ROTATION)


def _of_angles(angles: Terms) -> Iterator[tuple[str, np.ndarray]]:
    for name, value in angles:
        yield from ((name, value), (f"{name} / 2", value / 2), (f"radians({name})", np.radians(value)))
        for (part, by), of in product(PARTS_OF_AN_ANGLE, (np.sin, np.cos)):
            yield f"{of.__name__}({part.format(name)})", of(by * value)
        yield f"tan({name} / 2)", np.tan(value / 2)
        yield from ((f"{of.__name__}({name} / 2) ** 2", of(value / 2) ** 2) for of in (np.sin, np.cos))
    if len(angles) == MOST_ANGLES:
        (one, a), (other, b) = angles
        for (part, by), of, and_of in product((("{} / 2", 0.5), ("{}", 1.0)), (np.sin, np.cos), (np.sin, np.cos)):
            text = f"{of.__name__}({part.format(one)}) * {and_of.__name__}({part.format(other)})"
            yield text, of(by * a) * and_of(by * b)
        for sign, joined in (("+", a + b), ("-", a - b)):
            yield from ((f"{of.__name__}(({one} {sign} {other}) / 2)", of(joined / 2)) for of in (np.sin, np.cos))


def is_moved_from(answers: tuple[Plain, Plain], right: tuple[Plain, Plain], given: dict[str, Plain]) -> bool:
    """Return whether a pose that was given takes the first point to the second, in the answers as in what is right."""
    pairs = [[numbers_of(plain, 3) for plain in both] for both in (answers, right)]
    if any(row is None for both in pairs for row in both):
        return False
    return any(
        all(math.dist(pose.apply(first), second) <= 1e-6 for first, second in pairs) for _, pose in _poses(given)
    )


def _poses(given: dict[str, Plain]) -> list[tuple[str, Transform]]:
    parts = [(name, pose_of(leaf)) for name, leaf in leaves(given)]
    return [(name, Transform(each[2], each[3])) for name, each in parts if each is not None and any(each[3])]


# -- a point -------------------------------------------------------------------------------


def _turned(number: float, place: int, given: dict[str, Plain]) -> str:
    """Return how a number of a point came of another one and a pose, term by term; "" if few terms do not give it."""
    poses = _poses(given)
    points = [(name, row) for name, leaf in leaves(given) if (row := numbers_of(leaf, 3)) is not None]
    for (pose, held), (point, row) in product(poses[:MOST_POSES], points[:MOST_POINTS]):
        if found := sum_of(list(_terms(pose, held, point, row, place)), np.array([number]), 2, CLOSE):
            return found
    return ""


def _terms(pose: str, held: Transform, point: str, row: Sequence[float], at: int) -> Iterator[tuple[str, np.ndarray]]:
    """Yield what may stand in a place's sum; what was not turned only of that place, for few digits fit by luck."""
    yaw = held.rpy()[2]
    yield f"{point}[{at}]", np.array([row[at]])
    yield f"{pose}.translation[{at}]", np.array([held.translation[at]])
    for (place, one), (text, of) in product(enumerate(row[:2]), (("cos", math.cos), ("sin", math.sin))):
        yield f"{point}[{place}] * {text}(yaw of {pose})", np.array([one * of(yaw)])
