"""How far off does a map put what was seen?  The same sights, placed in several ways, side by side.

    at the stamp               with the newest pose
    +------------------+       +------------------+
    |        wall      |       |  : : wall . :    |      dots: where the sights were put
    |   o              |       |   o  . .. .      |      lines and rings: what is really there
    +------------------+       +------------------+
    off by 0.004 m on average  off by 0.210 m on average
    0.012 m at worst           0.455 m at worst

A sight that was moved with the right pose lies on the thing that was seen, each
time.  Moved with the pose of another moment it lies elsewhere, each time somewhere
else: one ball becomes many, and a thin wall becomes a thick one.

Everything is seen from above, in the fixed frame.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from . import style
from .picture import Picture

__all__ = ["Offs", "describe_placed", "distances_to", "draw_placed", "offs"]

Point2 = tuple[float, float]
Wall = tuple[Point2, Point2]

CAPTION_PX, TITLE_PX, GAP_PX, EDGE_PX = 46, 34, 18, 16
LOWEST_PX, HIGHEST_PX = 130, 360
MARGIN_M = 0.3
RING_PT = 11.0
SCALES_M = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0)
SCALE_PART, SCALE_PT = 0.2, 8.0  # of a panel, at most; how far below it


class Offs(NamedTuple):
    """How far a group of points lies from what is really there [m]."""

    count: int
    mean_m: float
    worst_m: float


def distances_to(points: np.ndarray, walls: Sequence[Wall] = (), things: Sequence[Sequence[float]] = ()) -> np.ndarray:
    """Return how far each point is from the nearest wall or thing [m].

    Args:
        points: shape (n, 2) or (n, 3); only x and y count [m].
        walls: each from a point (x, y) to another [m].
        things: (x, y) or (x, y, z) of each [m].

    Raises:
        ValueError: there is neither a wall nor a thing.
    """
    if not len(walls) and not len(things):
        raise ValueError("nothing is really there: give walls, things or both, and points are measured from them")
    points = _flat(points)
    each = [np.linalg.norm(points - thing, axis=1) for thing in _flat(things)] if len(things) else []
    for begin, end in np.asarray(walls, dtype=float).reshape(-1, 2, 2):
        along = end - begin
        share = np.clip((points - begin) @ along / max(along @ along, 1e-12), 0.0, 1.0)
        each.append(np.linalg.norm(points - (begin + share[:, None] * along), axis=1))
    return np.min(each, axis=0)


def offs(points: np.ndarray, walls: Sequence[Wall] = (), things: Sequence[Sequence[float]] = ()) -> Offs:
    """Return how far points lie from the nearest wall or thing, on average and at worst; NaN rows are left out."""
    points = _seen(points)
    if not len(points):
        return Offs(0, 0.0, 0.0)
    distances = distances_to(points, walls, things)
    return Offs(len(points), float(distances.mean()), float(distances.max()))


def describe_placed(
    placed: Mapping[str, np.ndarray], walls: Sequence[Wall] = (), things: Sequence[Sequence[float]] = ()
) -> str:
    """Return the same in words: for each way, how many points, and how far off they are."""
    width = max(map(len, placed))
    lines = []
    for name, points in placed.items():
        off = offs(points, walls, things)
        lines.append(
            f"{name:<{width}}  {off.count:>5} points, off by {style.fmt(off.mean_m)} on average, "
            f"{style.fmt(off.worst_m)} at worst"
        )
    return "\n".join(lines)


def draw_placed(
    placed: Mapping[str, np.ndarray],
    walls: Sequence[Wall] = (),
    things: Sequence[Sequence[float]] = (),
    shown_m: tuple[float, float, float, float] | None = None,
) -> Picture:
    """Draw points as each way puts them, in panels side by side, from above.

    Args:
        placed: by the name of the way, shape (n, 2) or (n, 3) [m] in the fixed frame.
        walls, things: what is really there.
        shown_m: x from, y from, x to, y to [m]; all there is if None.
    """
    x_low, y_low, x_high, y_high = shown_m or _everything(placed, walls, things)
    width_px = round(style.WIDE[0] * style.SCREEN_DPI)
    panel_px = (width_px - 2 * EDGE_PX - GAP_PX * (len(placed) - 1)) / len(placed)
    tall_px = round(np.clip(panel_px * (y_high - y_low) / (x_high - x_low), LOWEST_PX, HIGHEST_PX))
    height_px = TITLE_PX + tall_px + CAPTION_PX
    picture = Picture((style.WIDE[0], height_px / style.SCREEN_DPI))
    with style.our_settings():
        for i, (name, points) in enumerate(placed.items()):
            left = EDGE_PX + i * (panel_px + GAP_PX)
            box = (left / width_px, CAPTION_PX / height_px, panel_px / width_px, tall_px / height_px)
            ax = picture.figure.add_axes(box)
            _draw_panel(ax, _seen(points), walls, things)
            _show_box(ax, (x_low, y_low, x_high, y_high), panel_px / tall_px)
            ax.set_title(name, loc="left", pad=7)
            _draw_scale(ax)
            off = offs(points, walls, things)
            ax.set_xlabel(f"off by {style.fmt(off.mean_m)} on average\n{style.fmt(off.worst_m)} at worst", loc="left")
    picture.text = describe_placed(placed, walls, things)
    return picture


def _draw_panel(ax, points: np.ndarray, walls: Sequence[Wall], things: Sequence[Sequence[float]]) -> None:
    ax.set_xticks([])
    ax.set_yticks([])
    for spine in ax.spines.values():
        spine.set_color(style.HAIR)
    for wall in np.asarray(walls, dtype=float).reshape(-1, 2, 2):
        ax.plot(*wall.T, color=style.FAINT, linewidth=2.0, zorder=1, solid_capstyle="round")
    size = 5.0 if len(points) < 200 else 1.4
    ax.plot(*points.T, "o", color=style.ACCENT, markersize=size, markeredgewidth=0.0, alpha=0.75, zorder=2)
    for thing in things:
        ax.plot(*thing[:2], "o", color=style.INK, markersize=RING_PT, markerfacecolor="none", markeredgewidth=1.6)


def _show_box(ax, shown_m: tuple[float, float, float, float], width_per_height: float) -> None:
    """Choose the limits so that the box is in full sight and a metre is as long upwards as sideways."""
    x_low, y_low, x_high, y_high = shown_m
    half_y = max(y_high - y_low, (x_high - x_low) / width_per_height) / 2
    half_x = half_y * width_per_height
    middle_x, middle_y = (x_low + x_high) / 2, (y_low + y_high) / 2
    ax.set_xlim(middle_x - half_x, middle_x + half_x)
    ax.set_ylim(middle_y - half_y, middle_y + half_y)


def _draw_scale(ax) -> None:
    """Draw how long a metre is, or what is near it: a bar below the lower right corner, with its length."""
    from matplotlib.transforms import ScaledTranslation

    left, right = ax.get_xlim()
    length_m = max(length for length in SCALES_M if length <= max(SCALE_PART * (right - left), SCALES_M[0]))
    below = ax.get_xaxis_transform() + ScaledTranslation(0.0, -SCALE_PT / 72.0, ax.figure.dpi_scale_trans)
    ax.plot([right - length_m, right], [0.0, 0.0], color=style.GREY, linewidth=2.0, solid_capstyle="butt",
            transform=below, clip_on=False)  # fmt: skip
    ax.annotate(f"{length_m:g} m", (right - length_m / 2, 0.0), (0, -3), xycoords=below, textcoords="offset points",
                ha="center", va="top", color=style.GREY, fontsize=style.SMALL_PT)  # fmt: skip


def _everything(
    placed: Mapping[str, np.ndarray], walls: Sequence[Wall], things: Sequence[Sequence[float]]
) -> tuple[float, float, float, float]:
    """Return the corners of a box around everything, with a margin [m]."""
    groups = [*(_seen(points) for points in placed.values()), np.asarray(walls, dtype=float).reshape(-1, 2)]
    if len(things):
        groups.append(_flat(things))
    both = np.vstack(groups)
    (x_low, y_low), (x_high, y_high) = both.min(axis=0) - MARGIN_M, both.max(axis=0) + MARGIN_M
    return x_low, y_low, x_high, y_high


def _flat(points: Sequence[Sequence[float]] | np.ndarray) -> np.ndarray:
    return np.asarray(points, dtype=float)[:, :2]


def _seen(points: np.ndarray) -> np.ndarray:
    """Return the points that are any, x and y only: a ray that hit nothing has NaN."""
    points = np.asarray(points, dtype=float).reshape(len(points), -1)[:, :2]
    return points[np.isfinite(points).all(axis=1)]
