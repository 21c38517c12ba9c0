"""Where is it now, if I saw it then?  One object that rests, and a robot that does not.

    base_link, 7.4 s                base_link, 8.4 s
         [>- - - - - - - - -             o
                     |                   |        what is beside the robot's way forward,
                     o                  [>- - -   on which side, and by how much

The object stays where it is in the fixed frame.  What changes is the robot, and so
its answer to "ahead, and to the left or the right?".  A lookup with two moments
(`lookup_transform_full`) leads from one picture to the other.

Everything is seen from above, in the fixed frame, x to the right.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from tflab.core import Transform

from . import style
from .bodies import OUTLINE, PostArtists, RobotArtists
from .eye import FROM_ABOVE
from .frames import clear_paper, draw_ground, show_all
from .picture import Picture

__all__ = ["beside", "describe_moments", "draw_moments"]

DASHES = (0, (3.0, 2.0))
ROBOT_SCALE = 1.8
CAPTION_PX, TALL_PX, EDGE_PX, GAP_PX = 58, 190, 16, 18


def beside(point: Sequence[float]) -> str:
    """Return where a point is as the robot sees it: beside((4.64, -1.64)) == "4.64 m ahead, 1.64 m to the right"."""
    x, y = round(float(point[0]), 2), round(float(point[1]), 2)
    ahead = f"{style.fmt(abs(x), 'm', 2)} {'ahead' if x >= 0 else 'behind'}"
    return ahead if y == 0.0 else f"{ahead}, {style.fmt(abs(y), 'm', 2)} to the {'left' if y > 0 else 'right'}"


def describe_moments(poses: Mapping[str, Transform], point: Sequence[float]) -> str:
    """Return the same in words: at each moment, where the robot has the object."""
    width = max(map(len, poses))
    return "\n".join(f"{name:<{width}}  {beside(pose.inverse().apply(point))}" for name, pose in poses.items())


def draw_moments(poses: Mapping[str, Transform], point: Sequence[float], name: str = "object") -> Picture:
    """Draw one resting object beside a robot at several moments, each in its own panel.

    Args:
        poses: where the robot was, `fixed_T_base_link`, by the name of the moment.
        point: where the object is (x, y, z) [m] in the fixed frame.
        name: of the object.
    """
    width_px = style.WIDE[0] * style.SCREEN_DPI
    height_px = CAPTION_PX + TALL_PX + EDGE_PX
    panel_px = (width_px - 2 * EDGE_PX - GAP_PX * (len(poses) - 1)) / len(poses)
    picture = Picture((style.WIDE[0], height_px / style.SCREEN_DPI))
    point = tuple(float(each) for each in point)
    shown = np.array([point, *(pose.translation for pose in poses.values())])[:, :2]
    with style.our_settings():
        for i, (moment, pose) in enumerate(poses.items()):
            left_px = EDGE_PX + i * (panel_px + GAP_PX)
            box = (left_px / width_px, EDGE_PX / height_px, panel_px / width_px, TALL_PX / height_px)
            ax = clear_paper(picture.figure.add_axes(box))
            show_all(ax, shown, margin_m=0.8)
            draw_ground(ax, FROM_ABOVE, ax.get_xlim(), ax.get_ylim())
            _draw_moment(ax, pose, point, name)
            top = picture.figure.text
            top(left_px / width_px, 1 - 14 / height_px, moment, va="top", fontsize=style.TITLE_PT)
            said = beside(pose.inverse().apply(point))
            top(left_px / width_px, 1 - 36 / height_px, said, va="top", color=style.ACCENT, fontsize=style.SMALL_PT)
        grid = {"ha": "right", "va": "top", "color": style.GREY, "fontsize": style.SMALL_PT}
        picture.figure.text(1 - EDGE_PX / width_px, 1 - 14 / height_px, "grid of 1 m", **grid)
    picture.text = describe_moments(poses, point)
    return picture


def _draw_moment(ax, pose: Transform, point: tuple[float, ...], name: str) -> None:
    """Draw the robot, its way forward, and how far beside it the object is."""
    ahead_m = float(pose.inverse().apply(point)[0])
    foot = pose.apply((ahead_m, 0.0, 0.0))
    far = pose.apply((ahead_m + 0.6, 0.0, 0.0))
    nose = pose.apply((ROBOT_SCALE * float(OUTLINE[:, 0].max()), 0.0, 0.0))
    ax.plot([nose[0], far[0]], [nose[1], far[1]], color=style.GREY, linewidth=1.2, linestyle=DASHES, zorder=3)
    ax.plot([foot[0], point[0]], [foot[1], point[1]], color=style.ACCENT, linewidth=2.0, zorder=4)
    RobotArtists(ax, FROM_ABOVE, style.INK, scale=ROBOT_SCALE).move(pose)
    PostArtists(ax, FROM_ABOVE, style.INK, height_m=0.0).move(point)
    above = 1 if point[1] >= foot[1] else -1
    ax.annotate(name, point[:2], (0, 13 * above), textcoords="offset points", ha="center", va="center", zorder=30)
