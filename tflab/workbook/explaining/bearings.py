"""Was the direction in which something lies taken for how far it is turned?  Of a function of poses (x, y, yaw).

    invert({x: 2.4, y: -3.9, yaw: 1.1})   gives x, y, and for the yaw   atan2(y, x) of what it gives

A bearing is looked for in what came in, from one pose to the other, and in what was given beside it; alone,
and with a yaw added or taken off.  Only what fits in every call in which the place is none.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import permutations, product

import numpy as np

from ...text import Text
from ..answers.form import Form, numbers_of
from ..answers.forms import Angle
from ..answers.values import Plain
from .turning import FEWEST_CALLS, poses_among

__all__ = ["bearing_in_all"]

CLOSE = 1e-6
SAID = Text(
    en="in every call this is what `{sum}` gives: `atan2` of a place is the direction in which it lies. Asked for is "
    "how far something is turned, and where it lies says nothing of that.",
    ko="어느 호출에서나 `{sum}`의 값입니다. 위치를 `atan2`에 넣으면 그 위치가 놓인 방향이 나옵니다. 구할 것은 돌아간 "
    "각도이고, 위치로는 그것을 알 수 없습니다.",
)
Place = tuple[str, str, np.ndarray, np.ndarray]  # how its x and its y are written, and what they are in each call


def bearing_in_all(
    form: Form, args: Sequence[list[Plain]], answers: Sequence[Plain], beside: Mapping[str, Sequence[Plain]]
) -> tuple[str, Text] | None:
    """Return of which place a function's angle is the bearing in every call, and what to say; None if of none.

    Args:
        beside: all that the function gives, by name.
    """
    rows = [numbers_of(answer, None) for answer in answers]
    if not isinstance(form, Angle) or None in rows:
        return None
    given = np.array([row[0] for row in rows])
    poses = poses_among(args)
    yaws = {f"argument {at + 1}: yaw": pose["yaw"] for at, pose in poses.items()}
    for place in _places(poses, beside):
        is_somewhere = np.hypot(*place[2:]) > CLOSE
        ways = _directions(*place, yaws) if sum(is_somewhere) >= FEWEST_CALLS else ()
        text = next((text for text, angle in ways if _is_same(given[is_somewhere], angle[is_somewhere])), "")
        if text:
            return f"bearing: {text}", SAID.filled(sum=text)
    return None


def _is_same(angles: np.ndarray, others: np.ndarray) -> bool:
    """Return whether angles are the same, but for whole turns."""
    return bool(np.all(np.abs(np.angle(np.exp(1j * (angles - others)))) <= CLOSE))


def _places(poses: Mapping[int, Mapping[str, np.ndarray]], beside: Mapping[str, Sequence[Plain]]) -> Iterator[Place]:
    """Yield where something lies: what is given beside the angle, each pose, and one seen from the other."""
    rows = [[numbers_of(plain, None) for plain in beside.get(name, ())] for name in "xy"]
    if all(held and None not in held for held in rows):
        x, y = (np.array([number[0] for number in held]) for held in rows)
        yield "your x", "your y", x, y
    named = [(f"argument {at + 1}: x", f"argument {at + 1}: y", pose["x"], pose["y"]) for at, pose in poses.items()]
    yield from named
    for one, other in permutations(named, 2):
        yield f"{one[0]} - {other[0]}", f"{one[1]} - {other[1]}", one[2] - other[2], one[3] - other[3]


def _directions(
    x: str, y: str, along: np.ndarray, aside: np.ndarray, yaws: Mapping[str, np.ndarray]
) -> Iterator[tuple[str, np.ndarray]]:
    """Yield the bearings of a place, alone and with each yaw."""
    bearings = {
        f"atan2({y}, {x})": np.arctan2(aside, along),
        f"atan2(-({y}), -({x}))": np.arctan2(-aside, -along),
        f"-atan2({y}, {x})": -np.arctan2(aside, along),
        f"atan2({x}, {y})": np.arctan2(along, aside),
    }
    yield from bearings.items()
    for (text, bearing), (name, yaw) in product(bearings.items(), yaws.items()):
        yield from ((f"{name} + {text}", yaw + bearing), (f"{name} - {text}", yaw - bearing))
        yield f"{text} - {name}", bearing - yaw
