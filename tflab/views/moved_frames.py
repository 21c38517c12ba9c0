"""Draw from where to where frames move, from above.

    odom                        base_footprint
    |      y                    |
    |     /   y'                |      >            grey: before; ink: after
    |    o --> o'               |     / 0.24 m      the arrow: the move, with its length
    +--------------- x [m]      +--------------- x [m]

All panels have one scale, so that their moves can be compared.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import numpy as np

from tflab.core import Transform

from . import style
from .frames import draw_arrow, draw_frames, show_all
from .labels import place_labels
from .picture import Picture
from .projection import FROM_ABOVE, OUTLINE, RobotArtists

Move = tuple[Transform, Transform]

WIDTH_PX, LEFT_PX, BELOW_PX, ABOVE_PX, GAP_PX = 540, 68, 48, 32, 50
REACH = 1.3  # of an axis: with its letter
HEIGHT_PX = 330
TICKS = 5  # at most, along an axis


def draw_moves(
    moves: Mapping[str, Move],
    fixed_frame: str = "map",
    bodies: Collection[str] = (),
    path: Sequence[Sequence[float]] = (),
    length_m: float = 0.2,
    before: str = "before",
) -> Picture:
    """Draw each frame before and after its move, in a panel of its own, and the move as an arrow.

    Args:
        moves: by the frame's name, `fixed_frame`_T_frame before and after.
        bodies: the frames that are drawn as a robot, its pointed end along x, and not as axes.
        path: points (x, y) [m] of a line to be seen below them.
        length_m: how long an axis or a robot is drawn [m].
        before: what the grey pose is called.
    """
    from matplotlib.ticker import MaxNLocator

    picture = Picture((WIDTH_PX / style.SCREEN_DPI, HEIGHT_PX / style.SCREEN_DPI))
    panel_px = (WIDTH_PX - LEFT_PX - 14 - GAP_PX * (len(moves) - 1)) / len(moves)
    span_m = max(float(np.ptp(_corners(move, length_m), axis=0).max()) for move in moves.values())
    with style.our_settings():
        for i, (name, move) in enumerate(moves.items()):
            left = LEFT_PX + i * (panel_px + GAP_PX)
            ax = picture.add_axes_px(left, BELOW_PX, panel_px, HEIGHT_PX - BELOW_PX - ABOVE_PX)
            middle = _corners(move, length_m).mean(axis=0)
            show_all(ax, np.array((middle - span_m / 2, middle + span_m / 2)), margin_m=0.0)
            style.name_plane(ax, fixed_frame)
            if i:
                ax.set_ylabel("")
            for axis in (ax.xaxis, ax.yaxis):
                axis.set_major_locator(MaxNLocator(TICKS, steps=(1, 2, 5, 10)))
            ax.grid(color=style.HAIR)
            ax.set_title(name, loc="left", fontsize=style.TEXT_PT)
            ax.set_title(f"grey: {before}", loc="right", fontsize=style.SMALL_PT, color=style.GREY)
            if len(path):
                ax.plot(*np.asarray(path, dtype=float)[:, :2].T, color=style.FAINT, linewidth=1.2)
            _draw_move(ax, move, name in bodies, length_m)
    picture.text = describe_moves(moves, fixed_frame)
    return picture


def describe_moves(moves: Mapping[str, Move], fixed_frame: str) -> str:
    """Return the figure's text: where each frame is before and after, and how far it moved and turned."""
    lines = [f"Seen from above, in {fixed_frame}:"]
    for name, (before, after) in moves.items():
        ends = " to ".join(style.fmt_all(pose.translation[:2], digits=2) for pose in (before, after))
        yaw = style.fmt((before.inverse() @ after).rpy()[2], "rad", 2)
        lines.append(f"  {name} moves {_length_of((before, after))}, from {ends}, and rotates by {yaw}")
    return "\n".join(lines)


def _draw_move(ax, move: Move, is_body: bool, length_m: float) -> None:
    """Draw a frame, or a robot, at both poses and the arrow between them."""
    arrow = draw_arrow(ax, move[0].translation, move[1].translation, _length_of(move), FROM_ABOVE)
    arrow.arrow.shrinkA = arrow.arrow.shrinkB = 0
    labels = [arrow.label]
    for pose, is_ghost in zip(move, (True, False), strict=True):
        if is_body:
            scale = length_m / float(np.ptp(OUTLINE[:, 0]))
            RobotArtists(ax, FROM_ABOVE, style.GREY if is_ghost else style.INK, scale=scale).move(pose)
            edge = pose.apply(scale * np.column_stack((OUTLINE, np.zeros(len(OUTLINE)))))[:, :2]
            arrow.label.keep_off += [(tuple(edge[i - 1]), tuple(edge[i])) for i in range(len(edge))]
        else:
            (frame,) = draw_frames(ax, {"": pose}, FROM_ABOVE, length_m, is_ghost=is_ghost).values()
            frame.axes["z"].letter.set_visible(False)
            labels.append(frame.label)
    place_labels(labels)


def _corners(move: Move, length_m: float) -> np.ndarray:
    """Return the lower left and the upper right corner of what is drawn of a move [m]."""
    places = np.array([pose.translation[:2] for pose in move])
    return np.array((places.min(axis=0), places.max(axis=0))) + np.array(((-1,), (1,))) * REACH * length_m


def _length_of(move: Move) -> str:
    """Return how far a frame moves, as it is written at its arrow."""
    return style.fmt(float(np.hypot(*np.subtract(move[1].translation, move[0].translation)[:2])), digits=2)
