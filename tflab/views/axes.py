"""Draw body axes, camera axes and rotations, and the printable card of conventions.

    body (REP-103)                    optical (REP-103, suffix _optical_frame)

      z up                                  z forward, into the picture
      |   x forward                        (x)-----> x right
      |  /                                  |
      +------ (y left, to the other side)   v  y down

Both are right-handed. A camera has two frames at one position: the body frame is where the camera
is mounted, the optical frame is what its image is written in. The rotation between them is
roll -pi/2, then yaw -pi/2; as a quaternion (x, y, z, w) it is (-0.5, 0.5, -0.5, 0.5).
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tflab.core import Transform
from tflab.core.quaternions import Vector3

from . import style
from .frames import FrameArtists, clear_paper, draw_frames, draw_ground, write_caption
from .picture import Picture
from .projection import SLANTING, Eye, RobotArtists, eye_at

BODY_T_OPTICAL = Transform.from_rpy(-math.pi / 2, 0.0, -math.pi / 2)
FROM_BEHIND = Eye(right=(0.0, -1.0, 0.0), up=(0.0, 0.0, 1.0), towards=(-1.0, 0.0, 0.0))
FROM_FRONT = eye_at(math.radians(35.0), math.radians(25.0))

BODY_WORDS = {"x": "forward", "y": "left", "z": "up"}
OPTICAL_WORDS = {"x": "right", "y": "down", "z": "forward"}
TURNS = {"roll": "x", "pitch": "y", "yaw": "z"}  # each about its fixed axis

HALF_WIDTH, HALF_HEIGHT = 0.6, 0.45  # of the picture, one metre in front of the camera [m]


def optical_from_body(body_p: Sequence[float]) -> Vector3:
    """Return a point of camera_link, (x, y, z) [m], in camera_optical_frame: (-y, -z, x)."""
    return BODY_T_OPTICAL.inverse().apply(tuple(body_p))


def pixel_from_optical(optical_p: Sequence[float]) -> tuple[float, float] | None:
    """Return where a point of the optical frame [m] is seen: (right, down) per metre of depth; None if it is not."""
    x, y, z = optical_p
    if z <= 0.0 or abs(x / z) > HALF_WIDTH or abs(y / z) > HALF_HEIGHT:
        return None
    return (x / z, y / z)


def draw_body_axes() -> Picture:
    """Draw a robot with REP-103's body axes: x forward, y left, z up."""
    picture = Picture((5.4, 3.6))
    with style.our_settings():
        ax = clear_paper(picture.figure.add_axes((0.03, 0.03, 0.94, 0.94)))
        draw_ground(ax, SLANTING, (-1.0, 1.5), (-1.0, 1.5), 0.5)
        _draw_robot_axes(ax)
        ax.set_xlim(-1.75, 1.75)
        ax.set_ylim(-0.8, 1.5)
    picture.text = "base_link, body axes (REP-103): x forward, y left, z up"
    return picture


def draw_right_hand() -> Picture:
    """Draw the positive turn about each axis: roll about x, pitch about y, yaw about z."""
    picture = Picture((style.WIDE[0], 2.6))
    with style.our_settings():
        _draw_turns(picture, 0.325, (0.03, 0.91))
    picture.text = "\n".join(
        (
            "Right hand: thumb along the axis, and the fingers curl the positive way.",
            "  roll  about x: y turns to z, the left side goes up",
            "  pitch about y: z turns to x, the nose goes down",
            "  yaw   about z: x turns to y, the nose goes left",
        )
    )
    return picture


def _draw_robot_axes(ax) -> None:
    """Draw a robot and its axes, with what each of them means."""
    RobotArtists(ax, SLANTING, style.GREY, scale=1.3).move(Transform())
    frame = draw_frames(ax, {"base_link": Transform()}, SLANTING, length_m=0.9)["base_link"]
    frame.label.stand((0.0, -44.0))
    _write_words(ax, frame, BODY_WORDS)


def _draw_turns(picture: Picture, column_width: float, bottom_and_height: tuple[float, float]) -> None:
    """Draw a frame for each positive turn, side by side, in parts of the card's width and height."""
    bottom, height = bottom_and_height
    for column, (turn, axis) in enumerate(TURNS.items()):
        box = (0.02 + column_width * column, bottom, 0.95 * column_width, height)
        ax = clear_paper(picture.figure.add_axes(box))
        draw_frames(ax, {"": Transform()}, FROM_FRONT, length_m=1.0)
        draw_turn(ax, axis)
        write_caption(ax, f"{turn}: about {axis}")
        ax.set_xlim(-1.25, 1.25)
        ax.set_ylim(-0.9, 1.6)


def draw_turn(ax, axis: str) -> None:
    """Draw the quarter of a circle by which the next axis turns to the one after."""
    from matplotlib.patches import FancyArrowPatch
    from matplotlib.path import Path

    i = style.AXES.index(axis)
    first, second = np.eye(3)[(i + 1) % 3], np.eye(3)[(i + 2) % 3]
    angles = np.radians(np.linspace(8.0, 82.0, 24))[:, None]
    arc = FROM_FRONT.on_paper(0.62 * (np.cos(angles) * first + np.sin(angles) * second))
    ax.add_patch(FancyArrowPatch(path=Path(arc), arrowstyle="-|>,head_length=0.6,head_width=0.3", mutation_scale=14,
                                 color=style.ACCENT, linewidth=2.0, zorder=40))  # fmt: skip


def describe_rotation(roll_rad: float, pitch_rad: float, yaw_rad: float) -> str:
    """Return a rotation in words: the three angles, the quaternion, the matrix."""
    turn = Transform.from_rpy(roll_rad, pitch_rad, yaw_rad)
    lines = [
        f"roll, pitch, yaw {style.fmt_all((roll_rad, pitch_rad, yaw_rad), 'rad')}",
        f"quaternion (x, y, z, w) {style.fmt_all(turn.rotation, '')}",
        "matrix",
    ]
    return "\n".join((*lines, *_matrix_rows(turn)))


class RotationPicture(Picture):
    """A robot turned by roll, pitch and yaw about the fixed axes, with the same as numbers."""

    def __init__(self) -> None:
        super().__init__(style.WIDE)
        with style.our_settings():
            ax = clear_paper(self.figure.add_axes((0.02, 0.03, 0.5, 0.94)))
            draw_ground(ax, SLANTING, (-1.0, 1.0), (-1.0, 1.0), 0.5)
            draw_frames(ax, {"": Transform()}, SLANTING, length_m=1.0, is_ghost=True)
            self.robot = RobotArtists(ax, SLANTING, style.GREY, scale=1.2)
            self.frame = FrameArtists("", ax, SLANTING, 0.9, is_ghost=False)
            ax.set_xlim(-1.4, 1.4)
            ax.set_ylim(-1.1, 1.5)
            write_caption(ax, "grey: fixed axes")
            self.numbers = self.add_number_table(0.56, 0.92)
        self.moving = [*self.robot.artists, *self.frame.artists, self.numbers]

    def show(self, roll_rad: float, pitch_rad: float, yaw_rad: float) -> RotationPicture:
        """Turn by these angles [rad] about the fixed x, then y, then z, and return the picture."""
        turn = Transform.from_rpy(roll_rad, pitch_rad, yaw_rad)
        with style.our_settings():
            self.robot.move(turn)
            self.frame.move(turn)
            self.numbers.write("\n".join(_number_lines(roll_rad, pitch_rad, yaw_rad)))
        self.text = describe_rotation(roll_rad, pitch_rad, yaw_rad)
        return self


def draw_rotation(roll_rad: float = 0.0, pitch_rad: float = 0.0, yaw_rad: float = 0.0) -> RotationPicture:
    """Draw a robot turned by these angles [rad], with its quaternion and its matrix."""
    return RotationPicture().show(roll_rad, pitch_rad, yaw_rad)


def _number_lines(roll_rad: float, pitch_rad: float, yaw_rad: float) -> list[str]:
    turn = Transform.from_rpy(roll_rad, pitch_rad, yaw_rad)
    angles = zip(TURNS, (roll_rad, pitch_rad, yaw_rad), strict=True)
    parts = zip("xyzw", turn.rotation, strict=True)
    return [
        *(f"{name:<5} {style.fmt(angle, ''):>7} rad" for name, angle in angles),
        "",
        "quaternion",
        *(f"  {name}  {style.fmt(part, ''):>7}" for name, part in parts),
        "",
        "matrix",
        *_matrix_rows(turn),
    ]


def _matrix_rows(turn: Transform) -> list[str]:
    return ["  " + " ".join(f"{style.fmt(cell, ''):>7}" for cell in row) for row in turn.matrix()[:3, :3]]


def describe_cameras(body_p: Sequence[float]) -> str:
    """Return in words where a point of camera_link, (x, y, z) [m], is in both frames and in the picture."""
    optical_p = optical_from_body(body_p)
    pixel = pixel_from_optical(optical_p)
    seen = "not in the picture" if pixel is None else f"seen {_place(*pixel)}"
    return "\n".join(
        (
            "One point, one camera, two frames:",
            f"  in camera_link           {style.fmt_all(body_p)}  x forward, y left, z up",
            f"  in camera_optical_frame  {style.fmt_all(optical_p)}  x right, y down, z forward",
            f"  it is {seen}",
        )
    )


def _place(right: float, down: float) -> str:
    """Return a place in the picture in words, the amounts being per metre of depth."""
    ways = ((right, "right of" if right > 0 else "left of"), (down, "below" if down > 0 else "above"))
    words = [style.fmt(abs(amount), way) for amount, way in ways if round(amount, 3)]
    if not words:
        return "in the middle of the picture"
    return f"{' and '.join(words)} the middle of the picture, per metre of depth"


class CamerasPicture(Picture):
    """One camera drawn twice, with body axes and with optical axes, and below each what it sees."""

    def __init__(self) -> None:
        super().__init__(style.TALL)
        poses = {"camera_link": Transform(), "camera_optical_frame": BODY_T_OPTICAL}
        with style.our_settings():
            self.sides = [_CameraSide(self.figure, 0.5 * i, *pose) for i, pose in enumerate(poses.items())]
        self.moving = [artist for side in self.sides for artist in side.artists]

    def show(self, body_p: Sequence[float] = (2.0, 0.0, 0.0)) -> CamerasPicture:
        """Put the point at (x, y, z) [m] of camera_link, and return the picture."""
        with style.our_settings():
            for side in self.sides:
                side.show(tuple(body_p))
        self.text = describe_cameras(body_p)
        return self


class _CameraSide:
    """One half: the camera in space with one of its frames, and its picture with the same frame."""

    def __init__(self, figure, left: float, name: str, pose: Transform) -> None:
        self._pose = pose
        space = clear_paper(figure.add_axes((left + 0.02, 0.42, 0.46, 0.55)))
        words = BODY_WORDS if pose == Transform() else OPTICAL_WORDS
        write_caption(space, f"{name}: {', '.join(' '.join(pair) for pair in words.items())}")
        draw_frustum(space)
        draw_frames(space, {"": pose}, SLANTING, length_m=0.75)
        (self.sight,) = space.plot([], [], color=style.ACCENT, linewidth=1.2, zorder=30, marker="o", markersize=5,
                                   markerfacecolor=style.PAPER, markevery=[0])  # fmt: skip
        (self.point,) = space.plot([], [], "o", color=style.ACCENT, markersize=9, zorder=31)
        space.set_xlim(-1.1, 2.0)
        space.set_ylim(-0.95, 1.55)

        image = clear_paper(figure.add_axes((left + 0.1, 0.12, 0.3, 0.3)))
        corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)]) * (HALF_WIDTH, HALF_HEIGHT)
        image.fill(*corners.T, facecolor=style.SHADE, edgecolor=style.FAINT, linewidth=1.0, zorder=-10)
        draw_frames(image, {"": pose}, FROM_BEHIND, length_m=0.3)
        (self.dot,) = image.plot([], [], "o", color=style.ACCENT, markersize=16, markerfacecolor="none",
                                 markeredgewidth=2.0, zorder=60)  # fmt: skip
        image.set_xlim(-0.62, 0.62)
        image.set_ylim(-0.47, 0.47)
        self.numbers = figure.text(left + 0.25, 0.075, "", ha="center", va="center", color=style.ACCENT,
                                   fontsize=style.TITLE_PT)  # fmt: skip
        self.artists = [self.sight, self.point, self.dot, self.numbers]

    def show(self, body_p: Vector3) -> None:
        forward = body_p[0]
        pierced = tuple(part / forward for part in body_p) if forward > 0.0 else body_p  # the picture, one metre ahead
        places = SLANTING.on_paper((pierced, body_p))
        self.sight.set_data(*places.T)
        self.point.set_data(*places[1:].T)
        self.numbers.set_text(style.fmt_all(self._pose.inverse().apply(body_p)))
        pixel = pixel_from_optical(optical_from_body(body_p))
        self.dot.set_visible(pixel is not None)
        if pixel is not None:
            self.dot.set_data([pixel[0]], [-pixel[1]])


def draw_cameras(body_p: Sequence[float] = (2.0, 0.0, 0.0)) -> CamerasPicture:
    """Draw one camera with its two frames, and a point (x, y, z) [m] of camera_link in both."""
    return CamerasPicture().show(body_p)


def draw_frustum(ax) -> None:
    """Draw what a camera sees: the edges of its picture, one metre ahead, and lines to its corners."""
    corners = [(1.0, HALF_WIDTH * y, HALF_HEIGHT * z) for y, z in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    on_paper = SLANTING.on_paper(corners)
    ax.fill(*on_paper.T, facecolor=style.SHADE, edgecolor=style.FAINT, linewidth=1.0, zorder=-20)
    for corner in on_paper:
        ax.plot([0.0, corner[0]], [0.0, corner[1]], color=style.FAINT, linewidth=1.0, zorder=-10)


def _write_words(ax, frame: FrameArtists, words: dict[str, str]) -> None:
    """Write above each letter, or below one that stands low, what its axis means."""
    for axis, word in words.items():
        place = frame.axes[axis].letter_place
        ax.annotate(word, place, (0, math.copysign(16, place[1])), textcoords="offset points", ha="center", va="center",
                    color=style.AXIS_COLOURS[axis])  # fmt: skip


SENTENCES = (
    "right hand",
    "  x to y with the fingers,",
    "  z is the thumb",
    "",
    "positive rotations",
    "  roll   left side up",
    "  pitch  nose down",
    "  yaw    nose left",
    "",
    "(x, y, z, w)",
    "  0 0 0 1   no rotation",
    "  0 0 0 0   not a rotation",
    "  q and -q  the same",
    "  yaw a     (0, 0, sin a/2, cos a/2)",
    "",
    "link to optical",
    "  rpy   (-pi/2, 0, -pi/2)",
    "  xyzw  (-0.5, 0.5, -0.5, 0.5)",
)


def draw_card() -> Picture:
    """Draw the card: both conventions of axes, the positive rotations, and what to know of a quaternion."""
    picture = Picture((style.WIDE[0], 4.3))
    sides = {"base_link, camera_link": BODY_WORDS, "..._optical_frame": OPTICAL_WORDS}
    with style.our_settings():
        body, optical = (
            clear_paper(picture.figure.add_axes((0.02 + 0.305 * column, 0.43, 0.29, 0.54))) for column in range(2)
        )
        _draw_robot_axes(body)
        _write_words(optical, draw_frames(optical, {"": BODY_T_OPTICAL}, SLANTING, length_m=0.9)[""], OPTICAL_WORDS)
        for ax, caption in zip((body, optical), sides, strict=True):
            ax.set(xlim=(-1.4, 1.4), ylim=(-1.15, 1.6))
            write_caption(ax, caption)
        _draw_turns(picture, 0.21, (0.02, 0.38))
        picture.figure.text(0.665, 0.94, "\n".join(SENTENCES), va="top", family="monospace",
                            fontsize=style.SMALL_PT - 0.5, linespacing=1.4)  # fmt: skip
    axes = (f"{name}: {', '.join(' '.join(pair) for pair in words.items())}" for name, words in sides.items())
    picture.text = "\n".join(("The card:", *axes, *SENTENCES))
    return picture
