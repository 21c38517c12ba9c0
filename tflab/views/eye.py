"""From where do we look?  Three directions turn a point in space into a point on paper.

              up                          right . p  = how far to the right on paper
               |   towards                   up . p  = how high on paper
               |  /  (to your nose)     towards . p  = how near: what is nearer covers
               | /
               +--------- right

All eyes look from infinitely far, so parallel lines stay parallel and lengths
can be compared (an orthographic view).  Straight from above x points right and
y up, as on a map; a slanting eye shows all three axes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tflab.core.quaternions import Vector3


@dataclass(frozen=True, slots=True)
class Eye:
    """Where one looks from: three directions of length one, at right angles to each other."""

    right: Vector3
    up: Vector3
    towards: Vector3

    def on_paper(self, points: Sequence[float] | np.ndarray) -> np.ndarray:
        """Return where points, shape (..., 3) [m], land on paper, shape (..., 2) [m]."""
        return np.asarray(points, dtype=float) @ np.array((self.right, self.up)).T

    def nearness(self, points: Sequence[float] | np.ndarray) -> np.ndarray:
        """Return how near points, shape (..., 3) [m], are to the eye, shape (...) [m]: more is nearer."""
        return np.asarray(points, dtype=float) @ np.array(self.towards)


def eye_at(azimuth_rad: float, elevation_rad: float) -> Eye:
    """Return the eye in this direction: `azimuth_rad` left of x, `elevation_rad` above the ground [rad]."""
    ca, sa = math.cos(azimuth_rad), math.sin(azimuth_rad)
    ce, se = math.cos(elevation_rad), math.sin(elevation_rad)
    return Eye(right=(-sa, ca, 0.0), up=(-se * ca, -se * sa, ce), towards=(ce * ca, ce * sa, se))


FROM_ABOVE = Eye(right=(1.0, 0.0, 0.0), up=(0.0, 1.0, 0.0), towards=(0.0, 0.0, 1.0))
SLANTING = eye_at(math.radians(-125.0), math.radians(28.0))  # from behind, a little to the right
