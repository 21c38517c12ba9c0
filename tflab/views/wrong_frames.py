"""Draw what a wrong frame, a swapped lookup or a forgotten rotation does to measured points.

    base_p = base_T_laser.apply(laser_p)        right
    base_p = laser_T_base.apply(laser_p)        target and source swapped
    base_p = laser_p + translation              rotation forgotten

`seen_from` computes all three. `draw_misread` draws whole clouds: the same numbers, read in the
right frame and in a wrong one. No computation fails with a wrong frame.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from tflab.core import Transform
from tflab.core.quaternions import Vector3

from . import style
from .frames import FrameArtists, PointArtists, clear_paper, draw_frames, draw_ground, show_all, write_caption
from .labels import place_labels
from .picture import Picture
from .projection import FROM_ABOVE, OUTLINE, Eye, RobotArtists, eye_at

LASER_P: Vector3 = (2.0, 0.0, 0.0)  # the corner in laser_frame [m]
LASER_AT: Vector3 = (0.20, 0.0, 0.15)  # of laser_frame in base_link [m]
BODY_SCALE = 1.2
READINGS = ("corner", "swapped", "rotation left out")


def seen_from(base_T_laser: Transform, laser_p: Sequence[float]) -> dict[str, Vector3]:
    """Return where a point of the laser is in base_link [m]: rightly, and by two mistakes."""
    x, y, z = laser_p
    tx, ty, tz = base_T_laser.translation
    return {
        "corner": base_T_laser.apply((x, y, z)),
        "swapped": base_T_laser.inverse().apply((x, y, z)),
        "rotation left out": (x + tx, y + ty, z + tz),
    }


def describe_mount(yaw_rad: float) -> str:
    """Return the figure's text: what the laser measures, and three places in base_link."""
    places = seen_from(Transform.from_rpy(yaw=yaw_rad, translation=LASER_AT), LASER_P)
    truth = np.array(places["corner"])
    lines = [
        f"laser_frame at {style.fmt_all(LASER_AT)} in base_link, yaw {style.fmt(yaw_rad, 'rad', 2)}",
        f"the laser measures {style.fmt_all(LASER_P)}  in laser_frame",
        f"the corner is at   {style.fmt_all(places['corner'])}  in base_link",
    ]
    for name, formula in (("swapped", "laser_T_base.apply(laser_p)"), ("rotation left out", "laser_p + translation")):
        off = style.fmt(float(np.linalg.norm(np.array(places[name]) - truth)))
        lines.append(f"{name + ':':<18} {style.fmt_all(places[name])}  off by {off}  ({formula})")
    return "\n".join(lines)


class MountPicture(Picture):
    """The robot from above, its turned laser, the corner, and the ghosts of two mistakes."""

    def __init__(self) -> None:
        super().__init__((style.WIDE[0], 4.2))
        reach = float(np.linalg.norm(LASER_P)) + float(np.linalg.norm(LASER_AT)) + 0.35
        with style.our_settings():
            ax = clear_paper(self.figure.add_axes((0.01, 0.02, 0.53, 0.96)))
            draw_ground(ax, FROM_ABOVE, (-reach, reach), (-reach, reach), 0.5)
            RobotArtists(ax, FROM_ABOVE, style.GREY, scale=BODY_SCALE).move(Transform())
            self.base = FrameArtists("base_link", ax, FROM_ABOVE, 0.55, is_ghost=False)
            self.base.move(Transform())
            outline = [(x, y) for x, y in BODY_SCALE * OUTLINE]
            self.base.label.keep_off += zip(outline, [*outline[1:], outline[0]], strict=True)
            self.laser = FrameArtists("laser_frame", ax, FROM_ABOVE, 0.55, is_ghost=False)
            self.laser.axes["z"].beside *= (-1.0, 1.0)  # the other side than the z of base_link, which is near
            (self.beam,) = ax.plot([], [], color=style.ACCENT, linewidth=1.2, zorder=8)
            self.points = {name: PointArtists(name, ax, FROM_ABOVE, name != "corner") for name in READINGS}
            for name in READINGS[1:]:  # a ring around the truth, where the mistake hides behind it
                self.points[name].mark.set(markersize=13, zorder=55)
            ax.set_xlim(-reach, reach)
            ax.set_ylim(-reach, reach)
            ax.apply_aspect()  # now, not at the first drawing: names look for their places before
            write_caption(ax, "from above, grid of 0.5 m")
            self.numbers = self.add_number_table(0.565, 0.9)
        parts = [*self.points.values(), self.laser]
        self.moving = [*(artist for part in parts for artist in part.artists), *self.base.label.artists]
        self.moving += [self.beam, self.numbers]

    def show(self, yaw_rad: float) -> MountPicture:
        """Turn the laser to this yaw [rad], and return the picture."""
        base_T_laser = Transform.from_rpy(yaw=yaw_rad, translation=LASER_AT)
        places = seen_from(base_T_laser, LASER_P)
        with style.our_settings():
            self.laser.move(base_T_laser)
            self.beam.set_data(*zip(LASER_AT[:2], places["corner"][:2], strict=True))
            for name, point in self.points.items():
                point.move(places[name])
            labels = [*(point.label for point in self.points.values()), self.base.label, self.laser.label]
            labels[0].keep_off = [(LASER_AT[:2], places["corner"][:2])]
            place_labels(labels)
            self.numbers.write(_numbers(yaw_rad, places))
        self.text = describe_mount(yaw_rad)
        return self


def draw_mount(yaw_rad: float) -> MountPicture:
    """Draw where a laser turned by `yaw_rad` [rad] sees a point, and where two mistakes put it."""
    return MountPicture().show(yaw_rad)


def _numbers(yaw_rad: float, places: dict[str, Vector3]) -> str:
    truth = np.array(places["corner"])
    lines = [f"yaw of the mount {style.fmt(yaw_rad, 'rad', 2)}", "", "laser_p, as measured", _row(LASER_P), ""]
    lines += ["base_p, the corner", _row(places["corner"]), ""]
    for name in READINGS[1:]:
        off = style.fmt(float(np.linalg.norm(np.array(places[name]) - truth)), digits=2)
        lines += [f"{name}, off by {off}", _row(places[name]), ""]
    return "\n".join(lines)


def _row(point: Sequence[float]) -> str:
    return " ".join(f"{style.fmt(value, '', 2):>6}" for value in point) + " m"


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
