"""E2.5: First the yaw, then the pitch."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.core.quaternions import wxyz_from_xyzw
from tflab.workbook.tasks import Draws, Quaternion, define_task


def draw_yaw_and_pitch(rng: Draws) -> dict:
    """Draw a yaw and a pitch that are large enough for their order to matter."""
    yaw = rng.choice((-1, 1)) * rng.uniform(0.5, 2.0)
    if abs(abs(yaw) - math.pi / 2) < 0.1:  # a quarter turn makes a roll of a pitch, whichever came first
        yaw *= 0.85
    pitch = rng.choice((-1, 1)) * rng.uniform(0.4, 1.2)
    return {"first_yaw_rad": round(float(yaw), 2), "then_pitch_rad": round(float(pitch), 2)}


def rotate(given, unit: float = 1.0) -> Transform:
    """Return the yaw followed by the pitch, about fixed axes."""
    return Transform.from_rpy(pitch=unit * given.then_pitch_rad) @ Transform.from_rpy(yaw=unit * given.first_yaw_rad)


def combine_rotations(
    given, *, angles="in place", order="yaw first", unit="radians", yaw="left", pitch="down", result="as it is"
):
    """Return the rotation, step by step; other arguments are mistakes."""
    factor = {"radians": 1.0, "degrees": math.radians(1.0), "to degrees": math.degrees(1.0)}[unit]
    yaw_rad, pitch_rad = given.first_yaw_rad, given.then_pitch_rad
    yaw_rad, pitch_rad = {
        "exchanged": (pitch_rad, yaw_rad),
        "yaw in both": (yaw_rad, yaw_rad),
        "pitch in both": (pitch_rad, pitch_rad),
    }.get(angles, (yaw_rad, pitch_rad))
    ways = {
        "twice": 2.0,
        "half": 0.5,
        "about x": 1.0,
        "left": 1.0,
        "down": 1.0,
        "right": -1.0,
        "up": -1.0,
        "left out": 0.0,
        "roll": 1.0,
        "to degrees": math.degrees(1.0),
    }
    turn = ways[yaw] * factor * yaw_rad
    first = Transform.from_rpy(roll=turn) if yaw == "about x" else Transform.from_rpy(yaw=turn)
    second = ways[pitch] * factor * pitch_rad
    then = Transform.from_rpy(roll=second) if pitch == "roll" else Transform.from_rpy(pitch=second)
    both = first @ then if order == "pitch first" else then @ first
    both = {
        "sandwiched": first.inverse() @ then @ first,
        "sandwiched the other way": first @ then @ first.inverse(),
        "yaw twice": first @ then @ first,
        "pitch twice": then @ first @ then,
    }.get(order, both)
    return both.inverse().rotation if result == "inverse" else both.rotation


def normalize(row):
    return [number / math.hypot(*row) for number in row]


def rotate_about_slanted_axis(given):
    """Return one rotation about an axis with the two angles as components."""
    angle = math.hypot(given.first_yaw_rad, given.then_pitch_rad)
    share = math.sin(angle / 2) / angle
    return [0.0, share * given.then_pitch_rad, share * given.first_yaw_rad, math.cos(angle / 2)]


def quaternions_of(given):
    """Return the quaternions of the two rotations."""
    return [
        list(Transform.from_rpy(yaw=given.first_yaw_rad).rotation),
        list(Transform.from_rpy(pitch=given.then_pitch_rad).rotation),
    ]


def half_angles(given) -> tuple[float, float, float, float]:
    """Return the sine and cosine of half the yaw, and of half the pitch."""
    yaw, pitch = given.first_yaw_rad / 2, given.then_pitch_rad / 2
    return math.sin(yaw), math.cos(yaw), math.sin(pitch), math.cos(pitch)


def multiply(pitch: tuple, yaw: tuple) -> tuple[float, ...]:
    """Return the product of two unit quaternions, the yaw first."""
    return (Transform(rotation=pitch) @ Transform(rotation=yaw)).rotation


def exchange_yaw(given):
    ys, yc, ps, pc = half_angles(given)
    return multiply((0.0, ps, 0.0, pc), (0.0, 0.0, yc, ys))


def exchange_pitch(given):
    ys, yc, ps, pc = half_angles(given)
    return multiply((0.0, pc, 0.0, ps), (0.0, 0.0, ys, yc))


def exchange_both(given):
    ys, yc, ps, pc = half_angles(given)
    return multiply((0.0, pc, 0.0, ps), (0.0, 0.0, yc, ys))


def put_w_first(given):
    ys, yc, ps, pc = half_angles(given)
    return multiply((pc, 0.0, ps, 0.0), (yc, 0.0, 0.0, ys))


def leave_x_out(given):
    ys, yc, ps, pc = half_angles(given)
    return 0.0, ps * yc, pc * ys, pc * yc


def use_half_sum(given):
    ys, _, ps, _ = half_angles(given)
    return 0.0, ps, ys, math.cos((given.first_yaw_rad + given.then_pitch_rad) / 2)


def undo_pitch(given):
    yaw, pitch = (Transform(rotation=tuple(row)) for row in quaternions_of(given))
    return (pitch @ yaw @ pitch.inverse()).rotation


ANSWERS = {
    "w first": lambda given: wxyz_from_xyzw(rotate(given).rotation),
    "added": lambda given: [a + b for a, b in zip(*quaternions_of(given), strict=True)],
    "sum as one yaw": lambda given: Transform.from_rpy(yaw=given.first_yaw_rad + given.then_pitch_rad).rotation,
    "averaged": lambda given: [(a + b) / 2 for a, b in zip(*quaternions_of(given), strict=True)],
    "number by number": lambda given: [a * b for a, b in zip(*quaternions_of(given), strict=True)],
    "angles as numbers": lambda given: [0.0, given.then_pitch_rad, given.first_yaw_rad, 1.0],
    "halves side by side": lambda given: [
        0.0,
        math.sin(given.then_pitch_rad / 2),
        math.sin(given.first_yaw_rad / 2),
        math.cos(given.then_pitch_rad / 2) * math.cos(given.first_yaw_rad / 2),
    ],
    "averaged to length one": lambda given: normalize([a + b for a, b in zip(*quaternions_of(given), strict=True)]),
    "one turn about a slanted axis": rotate_about_slanted_axis,
    "no turn": (0.0, 0.0, 0.0, 1.0),
    "pitch undone": undo_pitch,
    "sine in the yaw's w": exchange_yaw,
    "sine in the pitch's w": exchange_pitch,
    "sine in both w": exchange_both,
    "w first inside": put_w_first,
    "x left out": leave_x_out,
    "halves beside half the sum": use_half_sum,
    "sum as one pitch": lambda given: Transform.from_rpy(pitch=given.first_yaw_rad + given.then_pitch_rad).rotation,
}

TASK = define_task(
    __file__,
    kind="N",
    points=3,
    answer="robot_q_sensor",
    form=Quaternion(tolerance=2e-3),
    given=draw_yaw_and_pitch,
    variants=5,
    model=combine_rotations,
    answers=ANSWERS,
)
