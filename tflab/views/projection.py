"""Project 3D points and robots onto a 2D figure (orthographic).

              up                          right . p  = how far to the right on paper
               |   towards                   up . p  = how high on paper
               |  /  (to your nose)     towards . p  = how near: what is nearer covers
               +--------- right

The projection is orthographic: parallel lines stay parallel and lengths can be compared. From
above, x points right and y up, as on a map; a slanting eye shows all three axes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from tflab.core import Transform
from tflab.core.quaternions import Vector3

from . import style

if TYPE_CHECKING:
    from matplotlib.axes import Axes


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


# half a metre long, a little narrower, its nose forward; seen from above, in base_link [m]
OUTLINE = np.array([(-0.25, -0.18), (0.15, -0.18), (0.32, 0.0), (0.15, 0.18), (-0.25, 0.18)])
HEIGHT_M = 0.22


class RobotArtists:
    """A robot on paper: filled faces and their edges."""

    def __init__(self, ax: Axes, eye: Eye, colour: str = style.INK, line="solid", scale: float = 1.0) -> None:
        from matplotlib.collections import PolyCollection

        self._eye = eye
        floor = np.column_stack((OUTLINE, np.zeros(len(OUTLINE))))
        roof = floor + np.array((0.0, 0.0, HEIGHT_M))
        sides = [(floor[i - 1], floor[i], roof[i], roof[i - 1]) for i in range(len(OUTLINE))]
        self._faces = [scale * np.array(face) for face in (*sides, roof)]
        self.faces = PolyCollection([], facecolors=style.PAPER, edgecolors=colour, linestyles=[line], linewidths=1.3)
        self.faces.set_zorder(5)
        ax.add_collection(self.faces, autolim=False)
        self.artists = [self.faces]

    def move(self, pose: Transform) -> None:
        """Draw the robot at `pose`, which is in the drawing's own frame."""
        placed = [pose.apply(face) for face in self._faces]
        placed.sort(key=lambda face: float(self._eye.nearness(face).mean()))  # the far ones first
        self.faces.set_verts([self._eye.on_paper(face) for face in placed])


class PostArtists:
    """A post on paper: a foot on the ground, a pole, and a round top."""

    def __init__(self, ax: Axes, eye: Eye, colour: str, is_ghost: bool = False, height_m: float = 0.8) -> None:
        self._eye, self._height_m = eye, height_m
        line = (0, (3.0, 2.0)) if is_ghost else "solid"
        (self.pole,) = ax.plot([], [], color=colour, linewidth=2.0, linestyle=line, zorder=20)
        (self.top,) = ax.plot([], [], color=colour, linestyle="none", marker="o", markersize=9, markeredgewidth=1.6,
                              markerfacecolor=style.PAPER if is_ghost else colour, zorder=21)  # fmt: skip
        self.artists = [self.pole, self.top]

    def move(self, foot: Sequence[float]) -> None:
        """Draw the post on the ground at `foot` (x, y, z) [m]."""
        x, y, z = foot
        ends = self._eye.on_paper(((x, y, z), (x, y, z + self._height_m)))
        self.pole.set_data(*ends.T)
        self.top.set_data(*ends[1:].T)
