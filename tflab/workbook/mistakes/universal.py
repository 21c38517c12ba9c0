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

from ...text import Text
from ..answers.form import inside, numbers_of, pose_of
from ..answers.forms import Angle, Form, Name, Number, Pose, Quaternion, Set, Tree, Vector
from ..answers.values import Plain, to_plain
from .by_place import letters_told
from .names import renamed
from .units import OTHER_UNITS, unit_of

__all__ = ["OF_FORM", "PLAIN_TO_SEE", "UNIVERSAL", "undone"]

Row = tuple[float, ...]
NOTHING = 10.0  # tolerances: a number below is as good as zero, whatever its unit


class Universal(NamedTuple):
    """A mistake that any answer of some form can have.

    Attributes:
        undo: what the answer would have been without it; several where it can be undone in several ways.
    """

    reply: Text
    undo: Callable[[Row], Iterator[Row]]
    misconception: str = ""


class Undone(NamedTuple):
    """An answer without one universal mistake: its name, the unit or the numbers it is told of, and what is left."""

    name: str
    unit: str
    left: Plain


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
    "sign": Universal(
        Text(en="the size is right, the sign is not.", ko="크기는 맞지만 부호가 반대입니다."),
        _negated,
    ),
    "one over it": Universal(
        Text(
            en="this is one over what is asked for: a rate for a period, or the other way round.",
            ko="필요한 값의 역수입니다. 주기 대신 주파수를, 또는 그 반대를 쓰지 않았습니까?",
        ),
        _reciprocal,
    ),
    "twice": Universal(
        Text(en="this is twice what is asked for.", ko="필요한 값의 두 배입니다."),
        _half,
    ),
    "half": Universal(
        Text(en="this is half of what is asked for.", ko="필요한 값의 절반입니다."),
        _double,
    ),
    "squared": Universal(
        Text(
            en="this is the square of what is asked for: is a root missing?",
            ko="필요한 값의 제곱입니다. 제곱근을 빠뜨리지 않았습니까?",
        ),
        _root,
    ),
    "root": Universal(
        Text(en="this is the square root of what is asked for.", ko="필요한 값의 제곱근입니다."),
        _square,
    ),
    "half a turn": Universal(
        Text(
            en="this angle is half a turn off: the opposite direction.",
            ko="각도가 반 바퀴 어긋났습니다. 반대 방향입니다.",
        ),
        _half_a_turn,
    ),
    "z for the angle": Universal(
        Text(
            en="this is the sine of half the angle, the z of a quaternion; asked for is the angle.",
            ko="각도 절반의 sin, 곧 쿼터니언의 z입니다. 필요한 것은 각도입니다.",
        ),
        _angle_of_z,
        "M5",
    ),
    "all signs": Universal(
        Text(
            en="each number has the other sign: the arrow points the opposite way.",
            ko="모든 숫자의 부호가 반대입니다. 화살표가 반대쪽을 가리킵니다.",
        ),
        _negated,
    ),
    "one sign": Universal(
        Text(en="one of the numbers has the wrong sign.", ko="숫자 하나의 부호가 반대입니다."),
        _one_sign,
    ),
    "exchanged": Universal(
        Text(en="these are the right numbers in the wrong places.", ko="숫자는 맞지만 자리가 서로 바뀌었습니다."),
        _exchanged,
    ),
    "places and signs": Universal(
        Text(
            en="the sizes of the numbers are right; their places and signs are not.",
            ko="숫자의 크기는 맞지만 자리와 부호가 다릅니다.",
        ),
        _places_and_signs,
    ),
    "w first": Universal(
        Text(
            en="the rotation is right, the order of its numbers is not: in ROS w comes last, (x, y, z, w).",
            ko="회전은 맞지만 숫자의 순서가 다릅니다. ROS에서는 w가 마지막입니다: (x, y, z, w).",
        ),
        _w_first,
        "M5",
    ),
    "w taken first": Universal(
        Text(
            en="these are the right numbers, each one place off: they came as (x, y, z, w), and were taken for "
            "(w, x, y, z).",
            ko="숫자는 맞지만 모두 한 자리씩 밀렸습니다. (x, y, z, w)로 나온 것을 (w, x, y, z)로 읽었습니다.",
        ),
        _w_taken_first,
        "M5",
    ),
    "inverse rotation": Universal(
        Text(
            en="this is the inverse rotation (its matrix transposed): it turns as far, and the other way.",
            ko="역회전입니다(행렬로는 전치). 도는 크기는 같고 방향이 반대입니다.",
        ),
        _conjugate,
        "M1",
    ),
    "not normalised": Universal(
        Text(
            en="the direction of the quaternion is right, its length is not 1: divide it by its length.",
            ko="쿼터니언의 방향은 맞지만 길이가 1이 아닙니다. 길이로 나누십시오.",
        ),
        _scaled,
        "M5",
    ),
    "whole angle": Universal(
        Text(
            en="this turns twice as far: a quaternion holds the sine and cosine of half the angle.",
            ko="두 배로 돌아갑니다. 쿼터니언에는 각도의 절반에 대한 sin과 cos을 넣습니다.",
        ),
        _halved,
        "M5",
    ),
    "other case": Universal(
        Text(
            en="capitals make it another name: `odom` and `Odom` are two.",
            ko="대문자를 쓰면 다른 이름이 됩니다. `odom`과 `Odom`은 서로 다릅니다.",
        ),
        lambda row: iter(()),
        "M14",
    ),
    "slash in front": Universal(
        Text(
            en="right, but for a slash in front that does not belong there: to TF it is part of the name.",
            ko="앞에 붙인 슬래시만 지우면 맞습니다. TF는 슬래시까지 이름으로 읽습니다.",
        ),
        lambda row: iter(()),
        "M14",
    ),
    "space around": Universal(
        Text(
            en="right, but for a space at its end: it is part of a name.",
            ko="앞뒤의 공백만 빼면 맞습니다. 공백도 이름의 일부입니다.",
        ),
        lambda row: iter(()),
        "M14",
    ),
    "no slash in front": Universal(
        Text(en="right, but for the slash in front, which is missing.", ko="앞의 슬래시가 빠진 것만 빼면 맞습니다."),
        lambda row: iter(()),
        "M14",
    ),
    "other separator": Universal(
        Text(
            en="right, but for what stands between a robot's name and its frame: that is a slash.",
            ko="로봇 이름과 좌표계 이름 사이에 있는 것만 빼면 맞습니다. 그 사이에는 슬래시를 씁니다.",
        ),
        lambda row: iter(()),
        "M14",
    ),
    "inverse transform": Universal(
        Text(
            en="this is the inverse transform: target and source are swapped.",
            ko="역변환입니다. 목표와 원본이 바뀌었습니다.",
        ),
        lambda row: iter(()),
        "M1",
    ),
    "not turned back": Universal(
        Text(
            en="of what has to be inverted only the translation was negated: the rotation was not turned back.",
            ko="뒤집어야 할 변환에서 이동의 부호만 바꾸었습니다. 회전을 되돌리지 않았습니다.",
        ),
        lambda row: iter(()),
        "M1",
    ),
    "translation taken away": Universal(
        Text(
            en="the rotation is right, the translation points the opposite way.",
            ko="회전은 맞지만 이동이 반대쪽을 가리킵니다.",
        ),
        _negated,
        "M3",
    ),
    "transposed": Universal(
        Text(
            en="this matrix is transposed: the translation stands in the last column, not in the last row.",
            ko="행렬이 전치되었습니다. 이동은 마지막 행이 아니라 마지막 열에 있습니다.",
        ),
        lambda row: iter(()),
    ),
    "power of ten": Universal(
        Text(
            en="the digits are right, and the decimal point stands elsewhere: a factor of 10, 100, 1000 … was "
            "forgotten, or is one too many.",
            ko="숫자는 맞지만 소수점의 자리가 다릅니다. 10, 100, 1000 같은 배수가 빠졌거나 더 들어갔습니다.",
        ),
        _powers_of_ten,
    ),
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
