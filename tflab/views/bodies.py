"""What do a robot and a post look like on paper?  As little as shows which way they face.

      ___________                 |  o
     |           \\                |  |     a post: where it stands,
     |  base_link  >   forward    |  |     and how high
     |___________/                |__|

A robot is a prism with a nose; from above one sees its outline.  What it was
(solid line) and what it is now (dashed line) can be told apart without colour.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from tflab.core import Transform

from . import style
from .eye import Eye

if TYPE_CHECKING:
    from matplotlib.axes import Axes

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
