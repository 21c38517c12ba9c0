"""E2.3: The quaternion of a yaw."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Draws, Quaternion, define_task


def draw_yaws(rng: Draws) -> list[tuple[float]]:
    """Draw left and right rotations, small and large, and two that are easy to get right by chance."""
    drawn = (rng.uniform(0.3, 1.4), -rng.uniform(0.3, 1.4), rng.uniform(1.8, 2.9), -rng.uniform(1.8, 2.9))
    return [(0.0,), (math.pi / 2,), (4.0,), (-5.5,), *((round(float(yaw), 3),) for yaw in drawn)]


def quaternion_from_yaw(yaw, *, unit="radians", half="inside", z="sine", way="left", axis="z", order="w last"):
    """Return the quaternion, step by step; other arguments are mistakes."""
    yaw = {"radians": yaw, "degrees": math.radians(yaw), "to degrees": math.degrees(yaw)}[unit]
    angle = {
        "inside": yaw / 2,
        "none": yaw,
        "outside": yaw,
        "sine outside": yaw,
        "cosine outside": yaw,
        "double": 2 * yaw,
        "whole number": yaw // 2,
        "quarter": yaw / 4,
        "of the sine alone": yaw / 2,
        "of the cosine alone": yaw,
        "modulo pi": yaw % math.pi / 2,
    }[half]
    sine, cosine = math.sin(angle), math.cos(yaw if half == "of the sine alone" else angle)
    cosine = math.cos(yaw / 2) if half == "of the cosine alone" else cosine
    if half in ("outside", "sine outside"):
        sine, cosine = sine / 2, math.cos(yaw / 2) if half == "sine outside" else cosine / 2
    if half == "cosine outside":
        sine, cosine = math.sin(yaw / 2), cosine / 2
    sine, cosine = {
        "sine": (sine, cosine),
        "cosine": (cosine, sine),
        "squares": (sine**2, cosine**2),
        "angle": (yaw, 1.0),
        "half of it": (yaw / 2, 1.0),
        "angle beside the cosine": (yaw, cosine),
        "half of it beside the cosine": (yaw / 2, cosine),
        "angle alone": (yaw, 0.0),
        "tangent": (math.tan(yaw / 2), 1.0),
        "positive": (abs(sine), cosine),
        "w positive": (sine, abs(cosine)),
        "both positive": (abs(sine), abs(cosine)),
        "all three": (sine, cosine),
        "diagonal": (sine, cosine),
        "sine alone": (sine, 0.0),
        "sine beside one": (sine, 1.0),
        "half of it beside its root": (yaw / 2, math.sqrt(max(0.0, 1.0 - (yaw / 2) ** 2))),
        "sine beside the rest": (sine, 1.0 - sine),
        "sine beside the rest of its size": (sine, 1.0 - abs(sine)),
        "sine beside the square": (sine, 1.0 - sine**2),
        "angle to length one": (yaw / math.hypot(yaw, 1.0), 1.0 / math.hypot(yaw, 1.0)),
        "half of it to length one": (yaw / math.hypot(yaw, 2.0), 2.0 / math.hypot(yaw, 2.0)),
    }[z]
    sine = -sine if way == "right" else sine
    sine = sine / math.sqrt(3.0) if z == "diagonal" else sine
    row = [sine if z in ("all three", "diagonal") or name == axis else 0.0 for name in "xyz"]
    return (cosine, *row) if order == "w first" else (*row, cosine)


def quaternion_of_clamped_yaw(yaw: float, bound: float) -> tuple[float, float, float, float]:
    """Return the quaternion of a yaw that is clamped to a bound on either side."""
    return quaternion_from_yaw(max(-bound, min(bound, yaw)))


ANSWERS = {
    "axis and angle": lambda yaw: (0.0, 0.0, 1.0, yaw),
    "angle in w": lambda yaw: (0.0, 0.0, math.sin(yaw / 2), yaw),
    "half the angle in w": lambda yaw: (0.0, 0.0, math.sin(yaw / 2), yaw / 2),
    "one in z": lambda yaw: (0.0, 0.0, 1.0, math.cos(yaw / 2)),
    "a direction": lambda yaw: (math.cos(yaw), math.sin(yaw), 0.0, 0.0),
    "a direction and a one": lambda yaw: (math.cos(yaw), math.sin(yaw), 0.0, 1.0),
    "halves in x and y": lambda yaw: (math.cos(yaw / 2), math.sin(yaw / 2), 0.0, 1.0),
    "zeros for no turn": lambda yaw: quaternion_from_yaw(yaw) if yaw else (0.0, 0.0, 0.0, 0.0),
    "by atan": lambda yaw: quaternion_from_yaw(math.atan(math.tan(yaw))),
    "by asin": lambda yaw: quaternion_from_yaw(math.asin(math.sin(yaw))),
    "times pi": lambda yaw: quaternion_from_yaw(math.pi * yaw),
    "no more than half a turn": lambda yaw: quaternion_of_clamped_yaw(yaw, math.pi),
    "no more than a quarter turn": lambda yaw: quaternion_of_clamped_yaw(yaw, math.pi / 2),
}

TASK = define_task(
    __file__,
    kind="F",
    points=3,
    answer="quaternion_from_yaw",
    form=Quaternion(tolerance=1e-3),
    inputs=draw_yaws,
    variants=3,
    model=quaternion_from_yaw,
    answers=ANSWERS,
)
