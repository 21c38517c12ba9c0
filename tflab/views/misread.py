"""What does a wrong frame_id do to a cloud?  The same numbers, read in the right frame and in a wrong one.

      o o o o                     the numbers (right, down, forward)
      o o o o   wall              read as (forward, left, up):
      o o o o                         the wall is a ceiling, the floor is a wall

Nothing fails: to the mathematics, one frame is as good as another.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from tflab.core import Transform

from . import style
from .bodies import RobotArtists
from .eye import Eye, eye_at
from .frames import clear_paper, draw_frames, draw_ground, show_all, write_caption
from .picture import Picture

__all__ = ["describe_extent", "draw_misread"]

FROM_THE_SIDE: Eye = eye_at(-2.1, 0.3)
MARKS = ("o", "s", "^", "D")
REACH_M = 0.35  # around what is drawn


def describe_extent(clouds: Mapping[str, np.ndarray], frame: str = "base_link") -> str:
    """Return in words from where to where each cloud, shape (n, 3) [m], reaches along x, y, z of `frame`."""
    lines = [f"In {frame}:"]
    for name, points in clouds.items():
        low, high = np.asarray(points).min(axis=0), np.asarray(points).max(axis=0)
        spans = (f"{axis} {_span(a, b)}" for axis, a, b in zip(style.AXES, low, high, strict=True))
        lines.append(f"  {name}: {', '.join(spans)}")
    return "\n".join(lines)


def draw_misread(
    right: Mapping[str, np.ndarray], wrong: Mapping[str, np.ndarray], titles: Sequence[str] = ("right", "wrong")
) -> Picture:
    """Draw named clouds around a robot, each shape (n, 3) [m] in base_link: as they are, and as they are misread."""
    picture = Picture((style.WIDE[0], 4.0))
    everything = np.vstack([*right.values(), *wrong.values(), np.zeros((1, 3))])
    with style.our_settings():
        for column, (clouds, title) in enumerate(zip((right, wrong), titles, strict=True)):
            ax = clear_paper(picture.figure.add_axes((0.02 + 0.49 * column, 0.03, 0.47, 0.94)))
            colour = style.INK if column == 0 else style.ACCENT
            _draw_side(ax, clouds, colour, everything)
            write_caption(ax, title)
    parts = zip(titles, (right, wrong), strict=True)
    picture.text = "\n".join(f"{title}. {describe_extent(clouds)}" for title, clouds in parts)
    return picture


def _draw_side(ax, clouds: Mapping[str, np.ndarray], colour: str, everything: np.ndarray) -> None:
    """Draw a robot, the ground, and the clouds with their names, with room for `everything`."""
    eye = FROM_THE_SIDE
    low, high = everything.min(axis=0) - REACH_M, everything.max(axis=0) + REACH_M
    draw_ground(ax, eye, (low[0], high[0]), (low[1], high[1]), 0.5)
    RobotArtists(ax, eye, style.GREY).move(Transform())
    draw_frames(ax, {"": Transform()}, eye, length_m=0.6)
    for (name, points), mark in zip(clouds.items(), MARKS, strict=False):
        on_paper = eye.on_paper(points)
        ax.plot(*on_paper.T, linestyle="none", marker=mark, markersize=2.6, color=colour, zorder=5)
        ax.text(*on_paper.mean(axis=0), name, ha="center", va="center", color=colour, zorder=70,
                bbox={"facecolor": style.PAPER, "edgecolor": "none", "pad": 1.5})  # fmt: skip
    show_all(ax, eye.on_paper(everything), margin_m=0.5 * REACH_M)


def _span(low: float, high: float) -> str:
    """Return "2.000" or "-1.000 to 1.000", in metres."""
    one, other = style.fmt(float(low), ""), style.fmt(float(high), "")
    return f"{one} m".replace("  ", " ") if one == other else f"{one.strip()} to {other.strip()} m"
