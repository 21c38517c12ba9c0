"""Draw one point in the coordinates of several frames, or of a robot at several times.

      map                   +---------------------------+   x leg
      (8.40, -1.70, 0.25)   |                      []   o   y leg, to the thing

      base_link             |                      +----o
      (2.20, 0.00, 0.15)

      laser_frame           |                       +---o
      (2.00, 0.00, 0.00)

One map for each frame or time, all seen from above, in the fixed frame, and at one scale. Only the
origin and the direction of the axes differ. Physics calls this a passive transformation.
Given a point for each frame, the maps show where the same coordinates lead in each.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from tflab.core import Transform
from tflab.core.quaternions import Vector3

from . import style
from .frames import clear_paper, draw_ground, show_all
from .picture import Picture
from .projection import FROM_ABOVE, OUTLINE, PostArtists, RobotArtists

if TYPE_CHECKING:
    from matplotlib.axes import Axes

ROBOT = "base_link"
ROBOT_SCALE = 2.4  # larger than life: what lies on its tray must not cover it
WIDTH_PX = 490  # of a figure: its letters can be read on a phone
CAPTION_PX, TALL_PX, EDGE_PX, GAP_PX, SCALE_PX = 150, 112, 14, 8, 14  # beside a map, its height, margins
SAME_M = 0.0005  # what prints alike is called the same
MARGIN_M = 1.0  # around what is shown, at the least
ROOM_FOR_LABELS = 0.22  # part of its width
LABEL_REACH_PT = 46.0  # from the middle of a leg to the far end of its number, where that stands aside
SHORT_PT = 20.0  # a leg that is shorter leaves no room for a number on its other side, where the other leg is
SHORT_M = 0.25  # a leg shorter than this has no number beside it


Points = Sequence[float] | Mapping[str, Sequence[float]]  # one for all frames, or one for each by its name


def readings_of(poses: Mapping[str, Transform], point: Points) -> dict[str, Vector3]:
    """Return the thing at `point` in each frame's own coordinates (x, y, z) [m].

    Args:
        poses: where each frame is, `fixed_T_frame`, by its name.
        point: where the thing is (x, y, z) [m], in the same fixed frame; or where each frame's own thing is.
    """
    return {name: poses[name].inverse().apply(each) for name, each in _for_each(poses, point).items()}


def _for_each(poses: Mapping[str, Transform], point: Points) -> dict[str, Sequence[float]]:
    return dict(point) if isinstance(point, Mapping) else dict.fromkeys(poses, point)


def describe_rulers(
    poses: Mapping[str, Transform],
    point: Points,
    name: str = "thing",
    before: Mapping[str, Sequence[float]] | None = None,
) -> str:
    """Return the figure's text: a line for each frame; with `before`, whether its numbers are still the same."""
    width = max(map(len, poses))
    lines = [f"{name}, measured from each frame:"]
    for frame, reading in readings_of(poses, point).items():
        lines.append(
            f"  {frame:<{width}}  {style.fmt_all(reading, digits=2)}  {_change(reading, frame, before)}".rstrip()
        )
    return "\n".join(lines)


class RulersPicture(Picture):
    """The maps, one for each frame; `show` moves what is in them."""

    def __init__(self, frames: Sequence[str], name: str = "thing", keep: np.ndarray | None = None) -> None:
        """Make the maps.

        Args:
            frames: their names, in the order in which they stand.
            name: of the thing.
            keep: places that are always in sight, shape (n, 2) [m], fixed frame; None to follow what is shown.
        """
        row_px = TALL_PX + GAP_PX
        height_px = EDGE_PX + row_px * len(frames) + SCALE_PX
        super().__init__((WIDTH_PX / style.SCREEN_DPI, height_px / style.SCREEN_DPI))
        self._name, self._keep = name, keep
        self._maps: dict[str, _Map] = {}
        with style.our_settings():
            for i, frame in enumerate(frames):
                bottom_px = height_px - EDGE_PX - i * row_px - TALL_PX
                box = (EDGE_PX + CAPTION_PX, bottom_px, WIDTH_PX - CAPTION_PX - 2 * EDGE_PX, TALL_PX)
                self._maps[frame] = _Map(self, clear_paper(self.add_axes_px(*box)), frame)
            _write_grid(self, height_px)
        self.moving = [artist for each in self._maps.values() for artist in each.artists]

    def show(
        self,
        poses: Mapping[str, Transform],
        point: Points,
        before: Mapping[str, Sequence[float]] | None = None,
    ) -> None:
        """Show the thing at `point` (x, y, z) [m], and each of `poses`, both in the fixed frame.

        Args:
            point: where it is; or, by the name of the frame, where each map's own thing is.
            before: the readings of another moment, to say which are the same.
        """
        points = _for_each(poses, point)
        places = np.array([*points.values(), *(pose.translation for pose in poses.values())])[:, :2]
        for frame, reading in readings_of(poses, points).items():
            self._maps[frame].look_at(places if self._keep is None else self._keep)
            self._maps[frame].move(poses, points[frame], reading, _change(reading, frame, before))
        self.text = describe_rulers(poses, point, self._name, before)


class _Map:
    """One frame's map: the robot, the frame's ruler, and the thing."""

    def __init__(self, picture: Picture, ax: Axes, frame: str) -> None:
        left, height_px = EDGE_PX / WIDTH_PX, picture.size_px[1]
        middle = sum(ax.get_position(original=True).intervaly) / 2

        def write(up_px: float, text: str, **how):
            return picture.figure.text(left, middle + up_px / height_px, text, va="center", **how)

        write(22, frame, fontsize=style.TITLE_PT, family="monospace")
        self.numbers = write(0, "", color=style.ACCENT, fontsize=style.TEXT_PT)
        self.change = write(-20, "", color=style.GREY, fontsize=style.SMALL_PT)
        self._frame, self._ax = frame, ax
        self._seen: tuple[float, ...] = ()
        self.robot = RobotArtists(ax, FROM_ABOVE, style.GREY, scale=ROBOT_SCALE)
        self.legs = {axis: _Leg(ax, axis) for axis in ("x", "y")}
        (self.origin,) = ax.plot([], [], linestyle="none", marker="o", markersize=5, color=style.INK, zorder=40)
        (self.thing,) = ax.plot([], [], linestyle="none", marker="o", markersize=7, color=style.ACCENT, zorder=41)
        legs = [artist for leg in self.legs.values() for artist in leg.artists]
        self.artists = [*self.robot.artists, *legs, self.origin, self.thing, self.numbers, self.change]

    def look_at(self, places: np.ndarray) -> None:
        """Choose the limits, and draw the ground in them, if they are others than before."""
        seen = tuple(np.concatenate((places.min(axis=0), places.max(axis=0))))
        if seen == self._seen:
            return
        self._seen = seen
        for ground in list(self._ax.collections)[1:]:  # the first is the robot
            ground.remove()
        show_all(self._ax, places, margin_m=max(MARGIN_M, ROOM_FOR_LABELS * float(np.ptp(places[:, 0]))))
        draw_ground(self._ax, FROM_ABOVE, self._ax.get_xlim(), self._ax.get_ylim())

    def move(self, poses: Mapping[str, Transform], point: Sequence[float], reading: Vector3, change: str) -> None:
        """Draw the frame's ruler to the thing."""
        pose = poses[self._frame]
        start, foot, end = ((0.0, 0.0, 0.0), (reading[0], 0.0, 0.0), (reading[0], reading[1], 0.0))
        start, foot, end = (np.array(pose.apply(place))[:2] for place in (start, foot, end))
        self.legs["x"].move(start, foot, reading[0], end)
        self.legs["y"].move(foot, end, reading[1], start)
        self.robot.faces.set_visible(ROBOT in poses)
        if ROBOT in poses:
            self.robot.move(poses[ROBOT])
        self.origin.set_data([start[0]], [start[1]])
        self.thing.set_data([point[0]], [point[1]])
        self.numbers.set_text(style.fmt_all(reading, digits=2))
        self.change.set_text(change)
        self.change.set_fontweight("bold" if change == "changed" else "normal")


class _Leg:
    """So far along one axis: a line in the axis's own colour and dashes, and its length."""

    def __init__(self, ax: Axes, axis: str) -> None:
        self._axis = axis
        colour = style.AXIS_COLOURS[axis]
        (self.line,) = ax.plot([], [], color=colour, linewidth=2.4, linestyle=style.AXIS_LINES[axis], zorder=30)
        paper = {"facecolor": style.PAPER, "edgecolor": "none", "pad": 1.0, "alpha": 0.85}
        self.label = ax.annotate("", (0, 0), (0, 0), textcoords="offset points", ha="center", va="center",
                                 color=colour, fontsize=style.SMALL_PT, bbox=paper, zorder=35)  # fmt: skip
        self.artists = [self.line, self.label]

    def move(self, start: np.ndarray, end: np.ndarray, length_m: float, other: np.ndarray) -> None:
        """Draw from `start` to `end` (x, y) [m]; `length_m` is what the axis says, with its sign.

        Its length stands on the side away from `other`, an end of the other leg.
        """
        self.line.set_data(*zip(start, end, strict=True))
        along = end - start
        size = float(np.hypot(*along))
        self.label.set_visible(size >= SHORT_M)
        if size < SHORT_M:
            return
        aside = np.array((along[1], -along[0])) / size
        if aside @ (other - start) > 1e-9:
            aside = -aside
        if not self._has_room(start, end, aside):
            aside = -aside
        self.label.xy = tuple((start + end) / 2)
        self.label.set_position(tuple((11 + 13 * abs(aside[0])) * aside))
        self.label.set_text(f"{self._axis} {length_m:.2f}")

    def _has_room(self, start: np.ndarray, end: np.ndarray, aside: np.ndarray) -> bool:
        """Return whether the length, written on this side, stays on its map; beside a short leg it need not."""
        ax = self.line.axes
        points = ax.transData.transform([start, end]) * 72.0 / ax.figure.dpi
        far = (points.mean(axis=0) + LABEL_REACH_PT * aside) * ax.figure.dpi / 72.0
        return np.hypot(*(points[1] - points[0])) < SHORT_PT or bool(ax.bbox.contains(*far))


def draw_rulers(
    poses: Mapping[str, Transform],
    point: Points,
    name: str = "thing",
    before: Mapping[str, Sequence[float]] | None = None,
) -> RulersPicture:
    """Draw one thing as each frame measures it; see `RulersPicture.show`."""
    picture = RulersPicture(tuple(poses), name)
    picture.show(poses, point, before)
    return picture


def _change(reading: Vector3, frame: str, before: Mapping[str, Sequence[float]] | None) -> str:
    """Return whether a reading is what it was: "same", "changed", or "" if there is nothing to compare with."""
    if before is None:
        return ""
    return "same" if np.allclose(reading, before[frame], rtol=0.0, atol=SAME_M) else "changed"


DASHES = (0, (3.0, 2.0))
POSE_SCALE = 1.8
MOMENTS_PX, HEADING_PX, RIM_PX = 490, 34, 16  # the width of the figure, the line above a panel, the margins
TALLNESS_PX, AROUND_M = (90, 230), 0.8  # of a panel; around what is shown


def beside(point: Sequence[float]) -> str:
    """Return where a point is as the robot sees it: beside((4.64, -1.64)) == "4.64 m ahead, 1.64 m to the right"."""
    x, y = round(float(point[0]), 2), round(float(point[1]), 2)
    ahead = f"{style.fmt(abs(x), 'm', 2)} {'ahead' if x >= 0 else 'behind'}"
    return ahead if y == 0.0 else f"{ahead}, {style.fmt(abs(y), 'm', 2)} to the {'left' if y > 0 else 'right'}"


def describe_moments(poses: Mapping[str, Transform], point: Sequence[float]) -> str:
    """Return the figure's text: at each moment, where the robot has the object."""
    width = max(map(len, poses))
    return "\n".join(f"{name:<{width}}  {beside(pose.inverse().apply(point))}" for name, pose in poses.items())


def draw_moments(poses: Mapping[str, Transform], point: Sequence[float], name: str = "object") -> Picture:
    """Draw one resting object beside a robot at several moments, one panel below the other.

    Args:
        poses: where the robot was, `fixed_T_base_link`, by the name of the moment.
        point: where the object is (x, y, z) [m] in the fixed frame.
        name: of the object.
    """
    point = tuple(float(each) for each in point)
    shown = np.array([point, *(pose.translation for pose in poses.values())])[:, :2]
    panel_px = MOMENTS_PX - 2 * RIM_PX
    across_m, up_m = np.ptp(shown, axis=0) + 2 * AROUND_M
    tall_px = round(np.clip(panel_px * up_m / across_m, *TALLNESS_PX))
    row_px = HEADING_PX + tall_px
    height_px = row_px * len(poses) + RIM_PX + SCALE_PX
    picture = Picture((MOMENTS_PX / style.SCREEN_DPI, height_px / style.SCREEN_DPI))
    with style.our_settings():
        for i, (moment, pose) in enumerate(poses.items()):
            top_px = height_px - i * row_px
            ax = clear_paper(picture.add_axes_px(RIM_PX, top_px - row_px, panel_px, tall_px))
            show_all(ax, shown, margin_m=AROUND_M)
            draw_ground(ax, FROM_ABOVE, ax.get_xlim(), ax.get_ylim())
            _draw_moment(ax, pose, point, name)
            write, y = picture.figure.text, (top_px - 0.55 * HEADING_PX) / height_px
            write(RIM_PX / MOMENTS_PX, y, moment, va="center", fontsize=style.TITLE_PT)
            said = beside(pose.inverse().apply(point))
            write(1 - RIM_PX / MOMENTS_PX, y, said, va="center", ha="right", color=style.ACCENT, fontsize=style.TEXT_PT)
        _write_grid(picture, height_px)
    picture.text = describe_moments(poses, point)
    return picture


def _write_grid(picture: Picture, height_px: float) -> None:
    """Write into the lower right corner how wide a cell of the ground is."""
    x, y = 1 - EDGE_PX / picture.size_px[0], 0.9 * SCALE_PX / height_px
    how = {"ha": "right", "va": "center", "color": style.GREY, "fontsize": style.SMALL_PT}
    picture.figure.text(x, y, "from above, grid of 1 m", **how)


def _draw_moment(ax, pose: Transform, point: tuple[float, ...], name: str) -> None:
    """Draw the robot, its way forward, and how far beside it the object is."""
    ahead_m = float(pose.inverse().apply(point)[0])
    foot = pose.apply((ahead_m, 0.0, 0.0))
    far = pose.apply((ahead_m + 0.6, 0.0, 0.0))
    nose = pose.apply((POSE_SCALE * float(OUTLINE[:, 0].max()), 0.0, 0.0))
    ax.plot([nose[0], far[0]], [nose[1], far[1]], color=style.GREY, linewidth=1.2, linestyle=DASHES, zorder=3)
    ax.plot([foot[0], point[0]], [foot[1], point[1]], color=style.ACCENT, linewidth=2.0, zorder=4)
    RobotArtists(ax, FROM_ABOVE, style.INK, scale=POSE_SCALE).move(pose)
    PostArtists(ax, FROM_ABOVE, style.INK, height_m=0.0).move(point)
    above = 1 if point[1] >= foot[1] else -1
    ax.annotate(name, point[:2], (0, 13 * above), textcoords="offset points", ha="center", va="center", zorder=30)
