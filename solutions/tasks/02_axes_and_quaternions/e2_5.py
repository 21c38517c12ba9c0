"""E2.5: First the yaw, then the pitch."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.core.quaternions import wxyz_from_xyzw
from tflab.workbook.tasks import Draws, Quaternion, define_task


def two_turns(rng: Draws) -> dict:
    """Draw a yaw and a pitch, both large enough for their order to be seen."""
    yaw = rng.choice((-1, 1)) * rng.uniform(0.5, 2.0)
    if abs(abs(yaw) - math.pi / 2) < 0.1:  # a quarter turn makes a roll of a pitch, whichever came first
        yaw *= 0.85
    pitch = rng.choice((-1, 1)) * rng.uniform(0.4, 1.2)
    return {"first_yaw_rad": round(float(yaw), 2), "then_pitch_rad": round(float(pitch), 2)}


def turned(given, unit: float = 1.0) -> Transform:
    """Return first the yaw, then the pitch, about the fixed axes."""
    return Transform.from_rpy(pitch=unit * given.then_pitch_rad) @ Transform.from_rpy(yaw=unit * given.first_yaw_rad)


def turned_twice(
    given, *, angles="in place", order="yaw first", unit="radians", yaw="left", pitch="down", result="as it is"
):
    """Return the rotation, step by step; other steps are the slips."""
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


def of_length_one(row):
    return [number / math.hypot(*row) for number in row]


def slanted(given):
    """Return one turn whose axis and angle are those of the two angles taken for the sides of an arrow."""
    angle = math.hypot(given.first_yaw_rad, given.then_pitch_rad)
    share = math.sin(angle / 2) / angle
    return [0.0, share * given.then_pitch_rad, share * given.first_yaw_rad, math.cos(angle / 2)]


def rows(given):
    """Return the quaternions of the two turns, each on its own."""
    return [
        list(Transform.from_rpy(yaw=given.first_yaw_rad).rotation),
        list(Transform.from_rpy(pitch=given.then_pitch_rad).rotation),
    ]


def halves(given) -> tuple[float, float, float, float]:
    """Return the sine and cosine of half the yaw, and of half the pitch."""
    yaw, pitch = given.first_yaw_rad / 2, given.then_pitch_rad / 2
    return math.sin(yaw), math.cos(yaw), math.sin(pitch), math.cos(pitch)


def joined(pitch: tuple, yaw: tuple) -> tuple[float, ...]:
    """Return the product of two quaternions of length one, the yaw first."""
    return (Transform(rotation=pitch) @ Transform(rotation=yaw)).rotation


def with_the_yaw_exchanged(given):
    ys, yc, ps, pc = halves(given)
    return joined((0.0, ps, 0.0, pc), (0.0, 0.0, yc, ys))


def with_the_pitch_exchanged(given):
    ys, yc, ps, pc = halves(given)
    return joined((0.0, pc, 0.0, ps), (0.0, 0.0, ys, yc))


def with_both_exchanged(given):
    ys, yc, ps, pc = halves(given)
    return joined((0.0, pc, 0.0, ps), (0.0, 0.0, yc, ys))


def with_w_first_inside(given):
    ys, yc, ps, pc = halves(given)
    return joined((pc, 0.0, ps, 0.0), (yc, 0.0, 0.0, ys))


def without_x(given):
    ys, yc, ps, pc = halves(given)
    return 0.0, ps * yc, pc * ys, pc * yc


def beside_half_the_sum(given):
    ys, _, ps, _ = halves(given)
    return 0.0, ps, ys, math.cos((given.first_yaw_rad + given.then_pitch_rad) / 2)


def pitch_undone(given):
    yaw, pitch = (Transform(rotation=tuple(row)) for row in rows(given))
    return (pitch @ yaw @ pitch.inverse()).rotation


ANSWERS = {
    "w first": lambda given: wxyz_from_xyzw(turned(given).rotation),
    "added": lambda given: [a + b for a, b in zip(*rows(given), strict=True)],
    "sum as one yaw": lambda given: Transform.from_rpy(yaw=given.first_yaw_rad + given.then_pitch_rad).rotation,
    "averaged": lambda given: [(a + b) / 2 for a, b in zip(*rows(given), strict=True)],
    "number by number": lambda given: [a * b for a, b in zip(*rows(given), strict=True)],
    "angles as numbers": lambda given: [0.0, given.then_pitch_rad, given.first_yaw_rad, 1.0],
    "halves side by side": lambda given: [
        0.0,
        math.sin(given.then_pitch_rad / 2),
        math.sin(given.first_yaw_rad / 2),
        math.cos(given.then_pitch_rad / 2) * math.cos(given.first_yaw_rad / 2),
    ],
    "averaged to length one": lambda given: of_length_one([a + b for a, b in zip(*rows(given), strict=True)]),
    "one turn about a slanted axis": slanted,
    "no turn": (0.0, 0.0, 0.0, 1.0),
    "pitch undone": pitch_undone,
    "sine in the yaw's w": with_the_yaw_exchanged,
    "sine in the pitch's w": with_the_pitch_exchanged,
    "sine in both w": with_both_exchanged,
    "w first inside": with_w_first_inside,
    "x left out": without_x,
    "halves beside half the sum": beside_half_the_sum,
    "sum as one pitch": lambda given: Transform.from_rpy(pitch=given.first_yaw_rad + given.then_pitch_rad).rotation,
}

TASK = define_task(
    __file__,
    kind="N",
    points=3,
    answer="robot_q_sensor",
    form=Quaternion(tolerance=2e-3),
    given=two_turns,
    variants=5,
    model=turned_twice,
    answers=ANSWERS,
)
