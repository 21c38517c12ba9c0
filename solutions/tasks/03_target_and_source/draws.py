"""What several tasks of chapter 03 draw, and what they share."""

from __future__ import annotations

import math
from itertools import combinations

from tflab.core import Transform
from tflab.workbook.tasks import Angle, Draws, Number, Parts

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
    """Return a point rotated in the plane by the formula, or by one of the wrong formulas `BY_HAND`."""
    return _by_formulas(x, y, angle)[way]


def _by_formulas(x: float, y: float, angle: float) -> dict[str, tuple[float, float]]:
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
    }


BY_HAND = tuple(_by_formulas(1.0, 0.0, 0.0))[1:]  # the wrong formulas


def tells_ways_apart(x: float, y: float, angle: float, *others: tuple[float, float]) -> bool:
    """Return whether a rotated point, what each way in `BY_HAND` gives, and `others` lie 8 mm from one another."""
    places = [*others, *(by_formula(x, y, angle, way) for way in ("right", *BY_HAND))]
    return all(math.dist(one, other) > 0.008 for one, other in combinations(places, 2))


WRONG_TERMS = (
    "cosine's sign in x", "cosine's sign in y", "exchanged in x", "exchanged in y", "places in x", "x's line for y",
)  # fmt: skip
