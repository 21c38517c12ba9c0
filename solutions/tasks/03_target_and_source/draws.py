"""What several tasks of chapter 03 draw, and what they share."""

from __future__ import annotations

import math
from itertools import combinations

from tflab.core import Transform
from tflab.workbook.tasks import Angle, Draws, Number, Parts, Text, WrongStep

PLANAR = Parts({"x": Number("m"), "y": Number("m"), "yaw": Angle()})


def some_yaw_degrees(rng: Draws) -> int:
    """Return a turn that nobody can overlook: 20 to 70 or 110 to 160 degrees, to either side."""
    size = rng.choice([rng.integers(20, 71), rng.integers(110, 161)])
    return int(size * rng.choice([-1, 1]))


def some_mount(rng: Draws) -> Transform:
    """Return where a sensor is bolted on: ahead, aside, above, and turned."""
    ahead, aside, above = rng.integers(15, 60) / 100, rng.choice([-1, 1]) * rng.integers(8, 30) / 100, 0.15
    return Transform.from_rpy(yaw=math.radians(some_yaw_degrees(rng)), translation=(ahead, aside, above))


def some_planar(rng: Draws) -> dict[str, float]:
    """Return a pose in the plane."""
    x, y = (float(rng.choice([-1, 1]) * rng.integers(50, 400) / 100) for _ in range(2))
    return {"x": x, "y": y, "yaw": round(math.radians(some_yaw_degrees(rng)), 4)}


def turned(transform: Transform, point) -> tuple[float, ...]:
    """Return a point turned by a transform's rotation alone."""
    return Transform(rotation=transform.rotation).apply(point)


def moved(pose: dict, x: float, y: float, yaw: float) -> dict[str, float]:
    """Return where a pose lies after a turn about the origin by its yaw."""
    c, s = math.cos(yaw), math.sin(yaw)
    return {"x": c * x - s * y, "y": s * x + c * y, "yaw": pose["yaw"]}


def by_formula(x: float, y: float, angle: float, way: str) -> tuple[float, float]:
    """Return a point turned in the plane by the formula, or with one of its terms written wrongly."""
    c, s = math.cos(angle), math.sin(angle)
    right = (c * x - s * y, s * x + c * y)
    return {
        "right": right,
        "sine's sign in x": (c * x + s * y, right[1]),
        "sine's sign in y": (right[0], c * y - s * x),
        "cosine's sign in x": (-c * x - s * y, right[1]),
        "cosine's sign in y": (right[0], s * x - c * y),
        "exchanged in x": (s * x - c * y, right[1]),
        "exchanged in y": (right[0], c * x + s * y),
        "exchanged in both": (s * x - c * y, c * x + s * y),
        "places in x": (c * y - s * x, right[1]),
        "x's line for y": (right[0], right[0]),
        "both second terms": (c * x + s * y, s * x - c * y),
        "new x": (right[0], s * right[0] + c * y),
        "y not turned": (right[0], y),
        "x not turned": (x, right[1]),
        "one term each": (c * x, s * y),
        "cosines alone": (c * x, c * y),
        "first term alone": (c * x, s * x),
    }[way]


def tells_ways_apart(x: float, y: float, angle: float, *others: tuple[float, float]) -> bool:
    """Return whether a rotated point, what each way in `BY_HAND` gives, and `others` lie 8 mm from one another."""
    places = [*others, *(by_formula(x, y, angle, way) for way in ("right", *BY_HAND))]
    return all(math.dist(one, other) > 0.008 for one, other in combinations(places, 2))


WRONG_TERMS = (
    "cosine's sign in x", "cosine's sign in y", "exchanged in x", "exchanged in y", "places in x", "x's line for y",
)  # fmt: skip
BY_HAND = {  # what to say of each of these ways
    "sine's sign in x": Text(
        en="one sine in your x has the wrong sign: look at the formula once more, u·cos α − v·sin α.",
        ko="x의 sin 하나의 부호가 틀렸습니다. 공식을 다시 보십시오: u·cos α − v·sin α.",
    ),
    "sine's sign in y": Text(
        en="one sine in your y has the wrong sign: look at the formula once more, u·sin α + v·cos α.",
        ko="y의 sin 하나의 부호가 틀렸습니다. 공식을 다시 보십시오: u·sin α + v·cos α.",
    ),
    "cosine's sign in x": Text(
        en="one cosine in your x has the wrong sign: look at the formula once more, u·cos α − v·sin α.",
        ko="x를 구하는 식에서 cos 앞의 부호 하나가 틀렸습니다. u·cos α − v·sin α를 다시 확인하십시오.",
    ),
    "cosine's sign in y": Text(
        en="one cosine in your y has the wrong sign: look at the formula once more, u·sin α + v·cos α.",
        ko="y를 구하는 식에서 cos 앞의 부호 하나가 틀렸습니다. u·sin α + v·cos α를 다시 확인하십시오.",
    ),
    "exchanged in x": Text(
        en="in your x alone, sine and cosine have changed places: it is u·cos α − v·sin α.",
        ko="x를 구하는 식에서만 sin과 cos의 자리가 바뀌었습니다. u·cos α − v·sin α입니다.",
    ),
    "exchanged in y": Text(
        en="in your y alone, sine and cosine (or u and v) have changed places: it is u·sin α + v·cos α.",
        ko="y를 구하는 식에서만 sin과 cos(또는 u와 v)의 자리가 바뀌었습니다. u·sin α + v·cos α입니다.",
    ),
    "places in x": Text(
        en="in your x alone, u and v have changed places: it is u·cos α − v·sin α.",
        ko="x를 구하는 식에서만 u와 v의 자리가 바뀌었습니다. u·cos α − v·sin α입니다.",
    ),
    "x's line for y": Text(
        en="your y is computed as x is: a copied line that was not changed? It is u·sin α + v·cos α.",
        ko="y도 x의 식으로 구했습니다. 복사한 줄을 고치지 않았습니까? y는 u·sin α + v·cos α입니다.",
    ),
    "exchanged in both": Text(
        en="sine and cosine have changed places in the turn.",
        ko="회전 공식에서 sin과 cos의 자리가 바뀌었습니다.",
    ),
    "both second terms": Text(
        en="the second terms of your x and your y have the wrong sign: it is u·cos α − v·sin α, and u·sin α + v·cos α.",
        ko="x와 y 두 식의 둘째 항 부호가 틀렸습니다. u·cos α − v·sin α와 u·sin α + v·cos α입니다.",
    ),
    "new x": Text(
        en="y was computed from the x that had been turned already. Both take the old u and v: give the results other "
        "names.",
        ko="y를 구할 때 이미 돌린 x를 썼습니다. 둘 다 돌리기 전의 u와 v로 계산합니다. 결과에는 다른 이름을 붙이십시오.",
    ),
    "y not turned": Text(
        en="x is turned, and y is not: both take a part of u and a part of v.",
        ko="x만 돌리고 y는 돌리지 않았습니다. 두 식 모두에 u와 v가 함께 들어갑니다.",
    ),
    "x not turned": Text(
        en="y is turned, and x is not: both take a part of u and a part of v.",
        ko="y만 돌리고 x는 돌리지 않았습니다. 두 식 모두에 u와 v가 함께 들어갑니다.",
    ),
    "one term each": Text(
        en="x has u·cos α alone, and y has v·sin α alone: each is a sum of two terms, one of u and one of v.",
        ko="x에는 u·cos α만, y에는 v·sin α만 있습니다. 두 식 모두 u의 항과 v의 항을 더한 것입니다.",
    ),
    "cosines alone": Text(
        en="both have only their cosine: the sine terms, in which the other number comes in, are missing.",
        ko="두 식에 cos 항만 있습니다. 다른 쪽 숫자가 들어가는 sin 항이 빠졌습니다.",
    ),
    "first term alone": Text(
        en="x is u·cos α and y is u·sin α: v has not come in at all.",
        ko="x는 u·cos α, y는 u·sin α입니다. v가 전혀 들어가지 않았습니다.",
    ),
}


def wrong_terms(step: str) -> tuple[WrongStep, ...]:
    """Return a slip for each term of the formula that may be wrong, at the step of a task that has `by_formula`."""
    return tuple(WrongStep(way, {step: way}, BY_HAND[way]) for way in WRONG_TERMS)
