"""Where was I when I saw it?  What it costs to use the robot's pose of now for a sight of then.

                        o  where it is drawn, with the pose of now
                      / |
            error   /   |  range x yaw rate x delay    (sideways, as the robot turned)
                  /     |
    where it is  *------+  speed x delay               (forwards, as the robot drove)

The object stands still; the robot sees it straight ahead, at `range_m`, and only
`delay_ns` later somebody moves the sight into the map.  At the message's stamp
the answer is right.  With the pose of now it is off by the two pieces above.

Both pieces are approximations, good while the robot turns little during the
delay; `exact_m` is the truth.  Everything is written in the robot's own
base_link at the stamp: x forward, y left.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tflab.core import NSEC_PER_SEC, Transform, seconds
from tflab.core.quaternions import Vector3

from . import style
from .bodies import OUTLINE, PostArtists, RobotArtists
from .eye import FROM_ABOVE, Eye, eye_at
from .frames import clear_paper, draw_ground, show_all, write_caption
from .labels import FloatingLabel, place_labels
from .picture import Picture

DASHES = (0, (3.0, 2.0))
ASIDE = eye_at(math.radians(-70.0), math.radians(30.0))  # from the robot's right-hand side
ROBOT_SCALE = 1.6  # a little larger than life, to be seen from so far


@dataclass(frozen=True, slots=True)
class Sight:
    """A robot on the move that sees something, and uses it later.

    Attributes:
        speed_mps: forwards [m/s].
        yaw_rate_radps: to the left [rad/s].
        range_m: how far ahead the object is [m].
        delay_ns: from the stamp until the sight is used [ns].
    """

    speed_mps: float = 1.0
    yaw_rate_radps: float = 0.5
    range_m: float = 5.0
    delay_ns: int = seconds(0.2)

    @property
    def delay_s(self) -> float:
        return self.delay_ns / NSEC_PER_SEC


class LatencyError(NamedTuple):
    """How far off the object is drawn.

    Attributes:
        forwards_m: speed x delay, about the part along x [m].
        sideways_m: range x yaw rate x delay, about the part along y [m].
        approximate_m: both together, at right angles [m].
        exact_m: the distance itself [m].
        drawn_at: where the object is drawn, in base_link at the stamp (x, y, z) [m].
        exact: from where the object is to where it is drawn (x, y, z) [m].
    """

    forwards_m: float
    sideways_m: float
    approximate_m: float
    exact_m: float
    drawn_at: Vector3
    exact: Vector3


def drive(speed_mps: float, yaw_rate_radps: float, duration_ns: int) -> Transform:
    """Return `then_T_now` of a robot that kept its speed and its yaw rate: an arc of a circle, or a straight line."""
    duration_s = duration_ns / NSEC_PER_SEC
    angle_rad = yaw_rate_radps * duration_s
    chord_m = speed_mps * duration_s * np.sinc(angle_rad / (2 * math.pi))  # sinc(u) is sin(pi u) / (pi u)
    x_m, y_m = chord_m * math.cos(angle_rad / 2), chord_m * math.sin(angle_rad / 2)
    return Transform.from_rpy(yaw=angle_rad, translation=(x_m, y_m, 0.0))


def latency_error(sight: Sight) -> LatencyError:
    """Return how far off an object is drawn if its sight is moved with the pose of now."""
    then_T_now = drive(sight.speed_mps, sight.yaw_rate_radps, sight.delay_ns)
    drawn_at = then_T_now.apply((sight.range_m, 0.0, 0.0))
    exact = (drawn_at[0] - sight.range_m, drawn_at[1], drawn_at[2])
    forwards_m = sight.speed_mps * sight.delay_s
    sideways_m = sight.range_m * sight.yaw_rate_radps * sight.delay_s
    return LatencyError(
        forwards_m=forwards_m,
        sideways_m=sideways_m,
        approximate_m=math.hypot(forwards_m, sideways_m),
        exact_m=math.hypot(*exact),
        drawn_at=drawn_at,
        exact=exact,
    )


def describe_latency(sight: Sight) -> str:
    """Return the same in words."""
    error = latency_error(sight)
    return "\n".join(
        (
            f"A robot drives {style.fmt(sight.speed_mps, 'm/s')} and turns {style.fmt(sight.yaw_rate_radps, 'rad/s')}.",
            f"It sees an object {style.fmt(sight.range_m)} ahead and uses the sight "
            f"{style.fmt_stamp(sight.delay_ns)} after its stamp.",
            f"  at the stamp, the truth      {style.fmt_all((sight.range_m, 0.0))}",
            f"  at now, the wrong answer     {style.fmt_all(error.drawn_at[:2])}",
            f"  error, exactly               {style.fmt(error.exact_m)}",
            f"  speed x delay                {style.fmt(error.forwards_m)}  forwards, approximately",
            f"  range x yaw rate x delay     {style.fmt(error.sideways_m)}  to the left, approximately",
            f"  both together                {style.fmt(error.approximate_m)}  approximately",
        )
    )


class LatencyPicture(Picture):
    """The object at the stamp and at now: from above, at a slant, and the error enlarged."""

    def __init__(self) -> None:
        super().__init__(style.TALL)
        with style.our_settings():
            above = self.figure.add_axes((0.02, 0.47, 0.96, 0.49))
            slant = self.figure.add_axes((0.02, 0.03, 0.5, 0.42))
            close = self.figure.add_axes((0.55, 0.05, 0.42, 0.4))
            self._views = [_Field(above, FROM_ABOVE, has_names=True), _Field(slant, ASIDE, has_names=False)]
            self._close = _Triangle(close)
            for ax, caption in ((above, "from above, grid of 1 m"), (slant, "in 3D"), (close, "the error, enlarged")):
                write_caption(ax, caption)
        self.moving = [artist for part in (*self._views, self._close) for artist in part.artists]
        self._extent = ()

    def show(self, sight: Sight) -> LatencyPicture:
        """Draw this sight, and return the picture."""
        error = latency_error(sight)
        # whole metres, so that the ground stays where it is while a slider moves a little
        extent = (math.ceil(max(sight.range_m, error.drawn_at[0], 7.0)), max(math.ceil(abs(error.drawn_at[1])), 1))
        if extent != self._extent:
            self._extent = extent
            self.redraw_all()
        with style.our_settings():
            for view in self._views:
                view.look_at(*extent)
                view.show(sight, error)
            self._close.show(error)
        self.text = describe_latency(sight)
        return self


def draw_latency(sight: Sight) -> LatencyPicture:
    """Draw where the object is and where it is drawn with the pose of now, and the error in its pieces."""
    return LatencyPicture().show(sight)


class _Field:
    """The ground with the robot and the object, then and now, from one eye."""

    def __init__(self, ax, eye: Eye, has_names: bool) -> None:
        self.ax, self.eye = clear_paper(ax), eye
        draw_ground(ax, eye, (-2.0, 16.0), (-9.0, 9.0))
        self.robot_then = RobotArtists(ax, eye, style.INK, scale=ROBOT_SCALE)
        self.robot_now = RobotArtists(ax, eye, style.GREY, DASHES, scale=ROBOT_SCALE)
        (self.sight_then,) = ax.plot([], [], color=style.INK, linewidth=1.0, zorder=3)
        (self.sight_now,) = ax.plot([], [], color=style.GREY, linewidth=1.0, linestyle=DASHES, zorder=3)
        height = 0.0 if eye is FROM_ABOVE else 0.8
        self.truth = PostArtists(ax, eye, style.INK, height_m=height)
        self.wrong = PostArtists(ax, eye, style.ACCENT, is_ghost=True, height_m=height)
        names = {
            "robot at the stamp": style.INK,
            "robot now": style.GREY,
            "object": style.INK,
            "drawn with the pose of now": style.ACCENT,
        }
        self.labels = [FloatingLabel(ax, name, colour) for name, colour in names.items()] if has_names else []

    @property
    def artists(self) -> list:
        """Everything that moves."""
        bodies = (self.robot_then, self.robot_now, self.truth, self.wrong)
        parts = [artist for body in bodies for artist in body.artists]
        return [*parts, self.sight_then, self.sight_now, *(artist for label in self.labels for artist in label.artists)]

    def look_at(self, ahead_m: float, aside_m: float) -> None:
        """Choose the limits: `ahead_m` forwards, and `aside_m` to either side [m]."""
        corners = [(x, y, 0.0) for x in (-1.0, ahead_m) for y in (-aside_m, aside_m)]
        show_all(self.ax, self.eye.on_paper(corners), margin_m=0.5)

    def show(self, sight: Sight, error: LatencyError) -> None:
        """Move everything to this sight."""
        then_T_now = drive(sight.speed_mps, sight.yaw_rate_radps, sight.delay_ns)
        start, goal = (0.0, 0.0, 0.0), (sight.range_m, 0.0, 0.0)
        self.robot_then.move(Transform())
        self.robot_now.move(then_T_now)
        self.truth.move(goal)
        self.wrong.move(error.drawn_at)
        places = self.eye.on_paper((start, then_T_now.translation, goal, error.drawn_at))
        self.sight_then.set_data(*places[[0, 2]].T)
        self.sight_now.set_data(*places[[1, 3]].T)
        if self.labels:
            self._place_names(then_T_now, places)

    def _place_names(self, then_T_now: Transform, places: np.ndarray) -> None:
        """Write the names beside their things: the robots' tail and nose, and the two places of the object."""
        tail, _, nose, *_ = ROBOT_SCALE * OUTLINE
        anchors = (tail, then_T_now.apply((*nose, 0.0))[:2], *places[2:])
        for label, anchor in zip(self.labels, anchors, strict=True):
            label.follow(anchor)
        lines = [places[[0, 2]], places[[1, 3]], *self._outline(Transform()), *self._outline(then_T_now)]
        self.labels[0].keep_off = [tuple(map(tuple, line)) for line in lines]
        place_labels(self.labels)

    def _outline(self, pose: Transform) -> list[np.ndarray]:
        """Return the sides of a robot on paper, which no name may cover."""
        floor = np.column_stack((ROBOT_SCALE * OUTLINE, np.zeros(len(OUTLINE))))
        corners = self.eye.on_paper(pose.apply(floor))
        return [corners[[i - 1, i]] for i in range(len(corners))]


class _Triangle:
    """The error enlarged: two pieces at right angles, and the way straight across."""

    def __init__(self, ax) -> None:
        self.ax = clear_paper(ax)
        self.legs = [ax.plot([], [], color=style.GREY, linewidth=1.8, linestyle=DASHES)[0] for _ in range(2)]
        (self.across,) = ax.plot([], [], color=style.ACCENT, linewidth=2.4)
        (self.truth,) = ax.plot([], [], "o", color=style.INK, markersize=9)
        (self.wrong,) = ax.plot([], [], "o", color=style.ACCENT, markersize=9, markerfacecolor=style.PAPER,
                                markeredgewidth=1.6)  # fmt: skip
        self.names = [
            ax.annotate("", (0, 0), (0, 0), textcoords="offset points", color=colour, ha=ha, linespacing=1.3)
            for colour, ha in ((style.GREY, "center"), (style.GREY, "left"), (style.ACCENT, "right"))
        ]

    @property
    def artists(self) -> list:
        """Everything that moves."""
        return [*self.legs, self.across, self.truth, self.wrong, *self.names]

    def show(self, error: LatencyError) -> None:
        """Move everything to this error, and enlarge it to the room there is."""
        corner, top = (error.forwards_m, 0.0), (error.forwards_m, error.sideways_m)
        truth, drawn = (0.0, 0.0), error.exact[:2]
        for leg, ends in zip(self.legs, ((truth, corner), (corner, top)), strict=True):
            leg.set_data(*zip(*ends, strict=True))
        self.across.set_data(*zip(truth, drawn, strict=True))
        self.truth.set_data([0.0], [0.0])
        self.wrong.set_data([drawn[0]], [drawn[1]])
        span_m = max(abs(error.forwards_m) / 0.3, abs(error.sideways_m) / 0.42, 0.05)
        middle_x, middle_y = 0.5 * error.forwards_m, 0.5 * error.sideways_m
        self.ax.set_xlim(middle_x - span_m * 0.55, middle_x + span_m * 1.05)
        self.ax.set_ylim(middle_y - 0.45 * span_m, middle_y + 0.55 * span_m)
        up = 1 if error.sideways_m >= 0.0 else -1  # the triangle hangs down if the robot turned right
        self._write(0, f"speed × delay\n≈ {style.fmt(error.forwards_m)}", (middle_x, 0.0), (0, -10 * up), up)
        self._write(1, f"range × yaw rate × delay\n≈ {style.fmt(error.sideways_m)}", (top[0], middle_y), (10, 0), 0)
        self._write(2, f"exactly\n{style.fmt(error.exact_m)}", (drawn[0] / 2, drawn[1] / 2), (-12, 6 * up), -up)

    def _write(self, i: int, text: str, anchor: tuple[float, float], place: tuple[float, float], above: int) -> None:
        """Write a name; it stands above its place (-1), below it (1) or beside it (0)."""
        self.names[i].set_text(text)
        self.names[i].xy = anchor
        self.names[i].set_position(place)
        self.names[i].set_verticalalignment({-1: "bottom", 0: "center", 1: "top"}[above])
