"""What several tasks of chapter 03 draw, and what they share."""

from __future__ import annotations

import math

import numpy as np

from tflab.core import Transform
from tflab.workbook.tasks import Angle, Number, Parts

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
