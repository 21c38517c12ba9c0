"""E3.3: The inverse."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Draws, define_task

from .draws import (
    PLANAR,
    WRONG_TERMS,
    draw_planar_pose,
    rotate_by_formula,
)


def draw_poses(rng: Draws) -> list[tuple]:
    quarters = [draw_planar_pose(rng) | {"yaw": round(float(way * rng.uniform(low, low + 1.0)), 4)}
                for way in (1, -1) for low in (0.4, 1.9)]  # fmt: skip
    straight = {"x": 2.0, "y": 1.0, "yaw": 0.0}
    on_the_spot = {"x": 0.0, "y": 0.0, "yaw": round(float(rng.uniform(0.4, 1.2)), 4)}
    in_another_order = dict(reversed(draw_planar_pose(rng).items()))
    return [*((pose,) for pose in quarters), (straight,), (on_the_spot,), (in_another_order,)]


def wrong_yaws(yaw: float) -> dict[str, float]:
    """Return wrong values for the yaw of the inverse."""
    return {
        "back": -yaw,
        "kept": yaw,
        "behind": yaw + math.pi,
        "zero": 0.0,
        "rest of a half": math.pi - yaw,
        "rest of a quarter": math.pi / 2 - yaw,
        "modulo pi": -yaw % math.pi,
        "one over": 1.0 / yaw if yaw else 0.0,
        "converted": -math.radians(yaw),
        "always positive": abs(yaw),
        "always negative": -abs(yaw),
        "asin": -math.asin(math.sin(yaw)),
        "atan": -math.atan(math.tan(yaw)),
    }


def invert_pose(
    a_pose_b, *, unit="radians", turn="back", step="off", angle="back", y="old", sine="sin"
) -> dict[str, float]:
    """Return b_pose_a, step by step; other arguments are mistakes."""
    yaw = a_pose_b["yaw"]
    angles = {"back": -yaw, "on": yaw, "none": 0.0, "half": -yaw / 2, "twice": -2 * yaw,
              "asin": -math.asin(math.sin(yaw))}  # fmt: skip
    by = math.radians(angles[angle]) if unit == "degrees" else angles[angle]
    signs = {"off": (-1.0, -1.0), "on": (1.0, 1.0), "x alone": (-1.0, 1.0), "y alone": (1.0, -1.0)}.get(
        step, (1.0, 1.0)
    )
    u, v = signs[0] * a_pose_b["x"], signs[1] * a_pose_b["y"]
    c, s = math.cos(by), math.sin(by)
    c, s = (s, c) if sine == "cos" else (c, s)
    x = c * u - s * v
    x = x if sine != "one sign" else c * u + s * v
    to_y = -s if sine == "sign in y" else s
    by_hand = sine in WRONG_TERMS
    if step == "a quarter":
        return {"x": -a_pose_b["y"], "y": a_pose_b["x"], "yaw": wrong_yaws(yaw)[turn]}
    if step == "one over":
        u, v = (1.0 / number if number else 0.0 for number in (a_pose_b["x"], a_pose_b["y"]))
    if by_hand or step == "one over":
        x, straight_y = rotate_by_formula(u, v, by, sine) if by_hand else (u, v)
        return {"x": x, "y": straight_y, "yaw": wrong_yaws(yaw)[turn]}
    return {
        "x": x,
        "y": to_y * {"old": u, "new": x, "new, taken off": -x}[y] + c * v,
        "yaw": wrong_yaws(yaw)[turn],
    }


ANSWERS = {
    "sine for cosine, by hand": lambda pose: {
        "x": -math.sin(pose["yaw"]) * pose["x"] - math.cos(pose["yaw"]) * pose["y"],
        "y": math.cos(pose["yaw"]) * pose["x"] - math.sin(pose["yaw"]) * pose["y"],
        "yaw": -pose["yaw"],
    },
}

TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="invert",
    form=PLANAR,
    inputs=draw_poses,
    variants=3,
    model=invert_pose,
    answers=ANSWERS,
)
