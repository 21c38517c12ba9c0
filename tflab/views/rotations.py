"""Draw which way a robot turns, and that the order of two rotations matters.

Each rotation here is about a *fixed* axis, as in URDF's rpy: the axes stay where they are and only
the robot turns, so "first a, then b" is `b @ a`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from tflab.core import Transform, seconds

from . import style
from .axes import TURNS, draw_frustum
from .frames import clear_paper, draw_frames, write_caption
from .motion_error import drive
from .picture import Picture
from .projection import FROM_ABOVE, SLANTING, RobotArtists

NOSE = (1.0, 0.0, 0.0)
WAYS = ((NOSE, "forward"), ((-1, 0, 0), "backward"), ((0, 1, 0), "left"), ((0, -1, 0), "right"), ((0, 0, 1), "up"),
        ((0, 0, -1), "down"))  # fmt: skip


def turn(name: str, angle_rad: float) -> Transform:
    """Return the turn called "roll", "pitch" or "yaw", by this angle [rad], about its fixed axis."""
    if name not in TURNS:
        raise ValueError(f"no turn is called {name!r}; there are {', '.join(TURNS)}")
    return Transform.from_rpy(**{name: angle_rad})


def describe_drives(yaw_rates_radps: Mapping[str, float], speed_mps: float, duration_s: float) -> str:
    """Return in words where each drive ends."""
    lines = [f"From above, x up the page, {style.fmt(speed_mps, 'm/s')} for {style.fmt(duration_s, 's')}:"]
    for name, yaw_rate in yaw_rates_radps.items():
        end = drive(speed_mps, yaw_rate, seconds(duration_s))
        side = "straight on" if yaw_rate == 0.0 else "to its left" if yaw_rate > 0.0 else "to its right"
        lines.append(
            f"  {name}: {side}, ends at {style.fmt_all(end.translation[:2])}, yaw {style.fmt(end.rpy()[2], 'rad')}"
        )
    return "\n".join(lines)


def draw_drives(yaw_rates_radps: Mapping[str, float], speed_mps: float = 0.5, duration_s: float = 3.0) -> Picture:
    """Draw from above, x up the page, where a robot gets to with each of these yaw rates [rad/s]."""
    picture = Picture(style.WIDE)
    page_T_start = turn("yaw", math.pi / 2)  # forward is up the page, as on a steering wheel
    with style.our_settings():
        ax = clear_paper(picture.figure.add_axes((0.02, 0.03, 0.96, 0.94)))
        times = np.linspace(0.0, duration_s, 40)
        for name, yaw_rate in yaw_rates_radps.items():
            poses = [page_T_start @ drive(speed_mps, yaw_rate, seconds(t)) for t in times]
            ax.plot(*zip(*(pose.translation[:2] for pose in poses), strict=True), color=style.ACCENT, linewidth=1.6)
            RobotArtists(ax, FROM_ABOVE, style.INK, scale=0.7).move(poses[-1])
            ahead = poses[-1].apply((0.34, 0.0, 0.0))
            x, y, _ = poses[-1].translation
            side = 0 if abs(x) < 0.2 else math.copysign(1.0, x)
            ax.text(x + 0.32 * side, max(y, ahead[1]) + (0.08 if side == 0 else 0.0), name, color=style.INK,
                    ha={0: "center", 1: "left", -1: "right"}[side], va="bottom" if side == 0 else "center")  # fmt: skip
        RobotArtists(ax, FROM_ABOVE, style.FAINT, scale=0.7).move(page_T_start)
        draw_frames(ax, {"": page_T_start}, FROM_ABOVE, length_m=0.55)
        ax.set_xlim(-2.6, 2.6)
        ax.set_ylim(-0.55, speed_mps * duration_s + 0.5)
    picture.text = describe_drives(yaw_rates_radps, speed_mps, duration_s)
    return picture


def describe_orders(first: tuple[str, float], second: tuple[str, float]) -> str:
    """Return in words where the nose and the top end, for both orders of two turns (name, angle [rad])."""
    lines = ["Two rotations about the fixed axes, in two orders (fixed x forward, y left, z up):"]
    for turns in ((first, second), (second, first)):
        after = _after(turns)[-1]
        name = ", then ".join(f"{name} {style.fmt(angle, 'rad')}" for name, angle in turns)
        lines.append(f"  {name}: nose {_way(after, NOSE)}, top {_way(after, (0.0, 0.0, 1.0))}")
    return "\n".join(lines)


def draw_orders(first: tuple[str, float], second: tuple[str, float]) -> Picture:
    """Draw a robot turned twice, (name, angle [rad]) each, in one order above and in the other below."""
    picture = Picture(style.TALL)
    with style.our_settings():
        for row, turns in enumerate(((first, second), (second, first))):
            names = [name for name, _ in turns]
            captions = ("start", f"first {names[0]}", f"first {names[0]}, then {names[1]}")
            for column, (pose, caption) in enumerate(zip(_after(turns), captions, strict=True)):
                ax = clear_paper(picture.figure.add_axes((0.02 + 0.325 * column, 0.51 - 0.48 * row, 0.31, 0.46)))
                RobotArtists(ax, SLANTING, style.ACCENT if column == 2 else style.GREY, scale=1.6).move(pose)
                draw_frames(ax, {"": pose}, SLANTING, length_m=0.85)
                ax.set_xlim(-1.15, 1.15)
                ax.set_ylim(-0.95, 1.15)
                write_caption(ax, caption)
    picture.text = describe_orders(first, second)
    return picture


def describe_turns(*turns: tuple[str, float]) -> str:
    """Return in words where x, y and z point at the start and after each turn (name, angle [rad])."""
    lines = ["A frame on a camera, turned about the fixed axes:"]
    for caption, pose in zip(_captions(turns), _after(turns), strict=True):
        ways = (f"{axis} {_way(pose, way)}" for axis, way in zip(style.AXES, np.eye(3), strict=True))
        lines.append(f"  {caption}: {', '.join(ways)}")
    return "\n".join(lines)


def draw_turns(*turns: tuple[str, float]) -> Picture:
    """Draw a frame on a camera that stands still: at the start, and after each turn (name, angle [rad])."""
    picture = Picture((style.WIDE[0], 2.6))
    columns = len(turns) + 1
    with style.our_settings():
        for column, (caption, pose) in enumerate(zip(_captions(turns), _after(turns), strict=True)):
            ax = clear_paper(picture.figure.add_axes((0.02 + 0.96 / columns * column, 0.03, 0.93 / columns, 0.94)))
            draw_frustum(ax)
            draw_frames(ax, {"": pose}, SLANTING, length_m=0.75)
            ax.set_xlim(-1.0, 1.35)
            ax.set_ylim(-1.05, 1.3)
            write_caption(ax, caption)
    picture.text = describe_turns(*turns)
    return picture


def _captions(turns: tuple[tuple[str, float], ...]) -> list[str]:
    """Return what has just happened, at the start and after each turn."""
    words = ("first", *("then" for _ in turns[1:]))
    said = (f"{word} {name} {style.fmt(angle, 'rad')}" for word, (name, angle) in zip(words, turns, strict=True))
    return ["start", *said]


def _after(turns: tuple[tuple[str, float], ...]) -> list[Transform]:
    """Return the pose at the start and after each turn, all about the fixed axes."""
    poses = [Transform()]
    for name, angle_rad in turns:
        poses.append(turn(name, angle_rad) @ poses[-1])
    return poses


def _way(pose: Transform, direction: tuple[float, float, float]) -> str:
    """Return which way a direction of the robot points now, in words if there is one."""
    now = pose.apply(direction)
    for way, word in WAYS:
        if math.dist(now, way) < 1e-6:
            return word
    return style.fmt_all(now, "")
