"""Draw the errors that a moving robot makes: by latency, and by a low transform rate.

                        o  where it is drawn, with the pose of now
                      / |
            error   /   |  range x yaw rate x delay    (sideways, as the robot turned)
                  /     |
    where it is  *------+  speed x delay               (forwards, as the robot drove)

Both parts are approximations for a small rotation during the delay; `exact_m` is the distance.
Everything is in base_link at the stamp: x forward, y left.

Between two samples tf2 interpolates along a straight line, the chord, while the robot drives an
arc. The largest gap between them is (v/w)(1 - cos(w / 2f)), the sagitta.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tflab.core import NSEC_PER_SEC, Transform, seconds
from tflab.core.quaternions import Vector3

from . import style
from .frames import clear_paper, draw_ground, show_all, write_caption
from .labels import FloatingLabel, place_labels
from .picture import Picture
from .projection import FROM_ABOVE, OUTLINE, Eye, PostArtists, RobotArtists, eye_at

DASHES = (0, (3.0, 2.0))
TRANSFORM_TRAVELS_S, SCAN_TRAVELS_S = 0.004, 0.105
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
    """Return the figure's text."""
    error = latency_error(sight)
    return "\n".join(
        (
            f"A robot drives {style.fmt(sight.speed_mps, 'm/s')} and turns {style.fmt(sight.yaw_rate_radps, 'rad/s')}.",
            f"It sees an object {style.fmt(sight.range_m)} ahead and uses the detection "
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
        """Move everything to this error, and scale it to the axes."""
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


NEARLY_STRAIGHT = 1e-9  # [rad/s]
POINTS = 60
CHORD_PX, LEGEND_PX, RIM_PX, LEAST_PX = 380, 34, 26, 160  # a chord, what stands above and below, a card's height


class Bend(NamedTuple):
    """A robot in a bend, and how often it says where it is.

    Attributes:
        speed_mps: how fast it drives [m/s].
        yaw_rate_radps: how fast it turns, positive to the left [rad/s].
        rate_hz: how often the transform comes [Hz].
    """

    speed_mps: float = 0.5
    yaw_rate_radps: float = 1.0
    rate_hz: float = 2.0


def gap_m(bend: Bend) -> float:
    """Return how far the chord is from the arc at worst [m]."""
    speed, turn, rate = bend
    if abs(turn) < NEARLY_STRAIGHT:
        return 0.0
    return abs(speed / turn) * (1.0 - math.cos(turn / (2.0 * rate)))


def wait_s(bend: Bend) -> float:
    """Return how long a scan that has arrived has to wait for the next transform, at worst [s]."""
    return max(0.0, 1.0 / bend.rate_hz + TRANSFORM_TRAVELS_S - SCAN_TRAVELS_S)


def describe_bend(bend: Bend) -> str:
    """Return the figure's text: what happens between two samples, the gap, and the wait."""
    between = f"{style.fmt(bend.speed_mps / bend.rate_hz)} driven, {bend.yaw_rate_radps / bend.rate_hz:.3f} rad turned"
    return "\n".join(
        (
            f"between two samples {between}",
            f"gap between arc and chord {style.fmt(1000 * gap_m(bend), 'mm', 2)} at worst",
            f"wait {style.fmt(wait_s(bend), 's')} at worst",
        )
    )


class BendPicture(Picture):
    """Arc and chord between two samples, as large as the paper; the three numbers beside them."""

    def __init__(self, lowest: float, highest: float) -> None:
        """Choose limits for arcs that reach from `lowest` to `highest`, in chords, 0 being the chord itself."""
        arc_px = CHORD_PX * (highest - lowest)
        height_px = max(LEGEND_PX + arc_px + 2 * RIM_PX, LEAST_PX)
        super().__init__(style.wide(height_px))
        width_px = self.size_px[0]
        middle, half = (lowest + highest) / 2, (height_px - LEGEND_PX) / CHORD_PX / 2
        box = (0.04, 0.0, 1.24 * CHORD_PX / width_px, 1.0 - LEGEND_PX / height_px)
        with style.our_settings():
            self.ax = self.figure.add_axes(box)
            self.ax.set_axis_off()
            self.ax.set_xlim(-0.62, 0.62)
            self.ax.set_ylim(middle - half, middle + half)
            (self._arc,) = self.ax.plot([], [], color=style.INK, linewidth=2.2, label="arc")
            dashes = (0, (4.0, 1.6))
            (self._chord,) = self.ax.plot([], [], color=style.ACCENT, linewidth=1.8, linestyle=dashes, label="chord")
            (self._gap,) = self.ax.plot([], [], color=style.AXIS_COLOURS["x"], linewidth=2.6, label="gap")
            (self._samples,) = self.ax.plot([], [], "o", color=style.INK, markersize=7, label="samples")
            self.figure.legend(loc="upper left", bbox_to_anchor=(0.03, 1.0 - 10 / height_px), ncols=4, frameon=False,
                               fontsize=style.SMALL_PT, borderaxespad=0.0)  # fmt: skip
            self._numbers = self.figure.text(0.70, 0.5, "", va="center", linespacing=1.9)
        self.moving = [self._arc, self._chord, self._gap, self._samples, self._numbers]

    def show(self, bend: Bend) -> None:
        """Draw one period of this bend, enlarged so that the chord fills the paper."""
        arc = _arc_of(bend)
        middle, chord = len(arc) // 2, arc[-1] - arc[0]
        self._arc.set_data(*arc.T)
        self._chord.set_data(*arc[[0, -1]].T)
        self._gap.set_data(*np.array([arc[middle], arc[0] + chord / 2]).T)
        self._samples.set_data(*arc[[0, -1]].T)
        self._numbers.set_text(
            f"v/f    {style.fmt(bend.speed_mps / bend.rate_hz)}\n"
            f"gap    {style.fmt(1000 * gap_m(bend), 'mm', 2)}\n"
            f"wait   {style.fmt(wait_s(bend), 's')}"
        )
        self.text = describe_bend(bend)


def draw_bend(bend: Bend) -> BendPicture:
    """Draw what TF knows of a bend between two samples."""
    heights = _arc_of(bend)[:, 1]
    picture = BendPicture(float(heights.min()), float(heights.max()))
    picture.show(bend)
    return picture


def largest_chord_gap(turn_rad: float) -> float:
    """Return how far the arc of a period in which the robot turns so far [rad] is from its chord, in chords."""
    return math.tan(abs(turn_rad) / 4.0) / 2.0


def _arc_of(bend: Bend) -> np.ndarray:
    """Return the arc of one period, its chord from (-0.5, 0) to (0.5, 0), shape (POINTS + 1, 2)."""
    turn = bend.yaw_rate_radps / bend.rate_hz
    share = np.linspace(0.0, 1.0, POINTS + 1)
    if abs(turn) < NEARLY_STRAIGHT:
        return np.column_stack([share - 0.5, np.zeros(POINTS + 1)])
    angle = turn * (share - 0.5)  # of the way's direction against the chord
    scale = 0.5 / math.sin(turn / 2.0)
    return np.column_stack([np.sin(angle) * scale, (math.cos(turn / 2.0) - np.cos(angle)) * scale])
