"""What several tasks of chapter 03 draw, and what they share."""

from __future__ import annotations

import math

import numpy as np

from tflab.core import Transform
from tflab.workbook.tasks import Angle, Number, Parts, Slip, Words

PLANAR = Parts({"x": Number("m"), "y": Number("m"), "yaw": Angle()})


def some_yaw_degrees(rng: np.random.Generator) -> int:
    """Return a turn that nobody can overlook: 20 to 70 or 110 to 160 degrees, to either side."""
    size = rng.choice([rng.integers(20, 71), rng.integers(110, 161)])
    return int(size * rng.choice([-1, 1]))


def some_mount(rng: np.random.Generator) -> Transform:
    """Return where a sensor is bolted on: ahead, aside, above, and turned."""
    ahead, aside, above = rng.integers(15, 60) / 100, rng.choice([-1, 1]) * rng.integers(8, 30) / 100, 0.15
    return Transform.from_rpy(yaw=math.radians(some_yaw_degrees(rng)), translation=(ahead, aside, above))


def some_planar(rng: np.random.Generator) -> dict[str, float]:
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
        "cosine's sign in x": (-c * x - s * y, right[1]),
        "cosine's sign in y": (right[0], s * x - c * y),
        "exchanged in x": (s * x - c * y, right[1]),
        "exchanged in y": (right[0], c * x + s * y),
        "places in x": (c * y - s * x, right[1]),
    }[way]


WRONG_TERMS = {
    "cosine's sign in x": Words(
        en="one cosine in your x has the wrong sign: look at the formula once more, u·cos α − v·sin α.",
        ko="x를 구하는 식에서 cos 앞의 부호 하나가 틀렸습니다. u·cos α − v·sin α를 다시 확인하십시오.",
    ),
    "cosine's sign in y": Words(
        en="one cosine in your y has the wrong sign: look at the formula once more, u·sin α + v·cos α.",
        ko="y를 구하는 식에서 cos 앞의 부호 하나가 틀렸습니다. u·sin α + v·cos α를 다시 확인하십시오.",
    ),
    "exchanged in x": Words(
        en="in your x alone, sine and cosine have changed places: it is u·cos α − v·sin α.",
        ko="x를 구하는 식에서만 sin과 cos의 자리가 바뀌었습니다. u·cos α − v·sin α입니다.",
    ),
    "exchanged in y": Words(
        en="in your y alone, sine and cosine (or u and v) have changed places: it is u·sin α + v·cos α.",
        ko="y를 구하는 식에서만 sin과 cos(또는 u와 v)의 자리가 바뀌었습니다. u·sin α + v·cos α입니다.",
    ),
    "places in x": Words(
        en="in your x alone, u and v have changed places: it is u·cos α − v·sin α.",
        ko="x를 구하는 식에서만 u와 v의 자리가 바뀌었습니다. u·cos α − v·sin α입니다.",
    ),
}


def wrong_terms(step: str) -> tuple[Slip, ...]:
    """Return a slip for each term of the formula that may be wrong, at the step of a task that has `by_formula`."""
    return tuple(Slip(way, {step: way}, words) for way, words in WRONG_TERMS.items())
