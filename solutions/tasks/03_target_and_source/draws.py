"""Draw what several tasks of chapter 03 need, and rotate points in right and wrong ways."""

from __future__ import annotations

import math
from itertools import combinations

from tflab.core import Transform
from tflab.workbook.tasks import Angle, Draws, Number, Parts

PLANAR = Parts({"x": Number("m"), "y": Number("m"), "yaw": Angle()})


def draw_yaw_degrees(rng: Draws) -> int:
    """Draw a yaw of 20 to 70 or 110 to 160 degrees, to either side."""
    size = rng.choice([rng.integers(20, 71), rng.integers(110, 161)])
    return int(size * rng.choice([-1, 1]))


def draw_mount(rng: Draws) -> Transform:
    """Draw the pose of a sensor on the robot."""
    ahead, aside, above = rng.integers(15, 60) / 100, rng.choice([-1, 1]) * rng.integers(8, 30) / 100, 0.15
    return Transform.from_rpy(yaw=math.radians(draw_yaw_degrees(rng)), translation=(ahead, aside, above))


def draw_planar_pose(rng: Draws) -> dict[str, float]:
    """Draw a pose in the plane."""
    x, y = (float(rng.choice([-1, 1]) * rng.integers(50, 400) / 100) for _ in range(2))
    return {"x": x, "y": y, "yaw": round(math.radians(draw_yaw_degrees(rng)), 4)}


def rotate(transform: Transform, point) -> tuple[float, ...]:
    """Return a point rotated by a transform's rotation, without its translation."""
    return Transform(rotation=transform.rotation).apply(point)


def rotate_pose(pose: dict, x: float, y: float, yaw: float) -> dict[str, float]:
    """Return a pose after a rotation about the origin; its own yaw stays."""
    c, s = math.cos(yaw), math.sin(yaw)
    return {"x": c * x - s * y, "y": s * x + c * y, "yaw": pose["yaw"]}


def rotate_by_formula(x: float, y: float, angle: float, way: str) -> tuple[float, float]:
    """Return a point rotated in the plane by the formula, or by one of the wrong formulas `WRONG_FORMULAS`."""
    return _rotate_by_formulas(x, y, angle)[way]


def _rotate_by_formulas(x: float, y: float, angle: float) -> dict[str, tuple[float, float]]:
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


WRONG_FORMULAS = tuple(_rotate_by_formulas(1.0, 0.0, 0.0))[1:]  # the wrong formulas


def are_distinct(x: float, y: float, angle: float, *others: tuple[float, float]) -> bool:
    """Return whether the right point, each of `WRONG_FORMULAS` and `others` are 8 mm or more from one another."""
    places = [*others, *(rotate_by_formula(x, y, angle, way) for way in ("right", *WRONG_FORMULAS))]
    return all(math.dist(one, other) > 0.008 for one, other in combinations(places, 2))


WRONG_TERMS = (
    "cosine's sign in x", "cosine's sign in y", "exchanged in x", "exchanged in y", "places in x", "x's line for y",
)  # fmt: skip
