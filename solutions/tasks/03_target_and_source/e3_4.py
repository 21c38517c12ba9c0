"""E3.4: Two dominoes into one."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Draws, define_task

from .draws import (
    PLANAR,
    WRONG_TERMS,
    draw_planar_pose,
    rotate_by_formula,
    rotate_pose,
)


def draw_pose_pairs(rng: Draws) -> list[tuple]:
    """Draw pairs of poses, in some of which the sum or the difference of the yaws passes half a turn."""
    nothing = {"x": 0.0, "y": 0.0, "yaw": 0.0}
    sums = differences = [0.0]
    while max(sums) <= math.pi or max(differences) <= math.pi:
        pairs = [(draw_planar_pose(rng), draw_planar_pose(rng)) for _ in range(4)]
        sums = [abs(one["yaw"] + two["yaw"]) for one, two in pairs]
        differences = [abs(one["yaw"] - two["yaw"]) for one, two in pairs]
    straight = {"x": 1.5, "y": -2.0, "yaw": 0.0}  # not turned, and not at the origin either
    return [
        *pairs,
        (draw_planar_pose(rng), nothing),
        (nothing, draw_planar_pose(rng)),
        (straight, draw_planar_pose(rng)),
        (draw_planar_pose(rng), nothing | {"yaw": 1.2}),  # rotated on the spot
        tuple(dict(reversed(draw_planar_pose(rng).items())) for _ in range(2)),  # keys in another order
    ]


def invert(pose):
    """Return the pose of a in b from that of b in a."""
    return rotate_pose({"yaw": -pose["yaw"]}, -pose["x"], -pose["y"], -pose["yaw"])


def compose(
    a_pose_b,
    b_pose_c,
    *,
    first="as it is",
    second="as it is",
    order="as given",
    unit="radians",
    turned="second",
    by="first",
    step="added",
    yaw="sum",
    end="as it is",
):
    """Return a_pose_c, step by step; other arguments are mistakes."""
    a_pose_b = invert(a_pose_b) if first == "inverted" else a_pose_b
    b_pose_c = invert(b_pose_c) if second == "inverted" else b_pose_c
    outer, inner = (b_pose_c, a_pose_b) if order == "exchanged" else (a_pose_b, b_pose_c)
    one, two = outer["yaw"], inner["yaw"]
    angle = {"first": one, "back": -one, "second": two, "both": one + two, "none": 0.0,
             "half": one / 2, "difference": one - two}[by]  # fmt: skip
    angle = math.radians(angle) if unit == "degrees" else angle
    if turned == "first":  # and the second added as it is
        angle, step = one, "as it is"
    x, y = (outer["x"], outer["y"]) if turned == "first" else (inner["x"], inner["y"])
    if turned == "sum":
        x, y = x + outer["x"], y + outer["y"]
    if turned == "difference":
        x, y = x - outer["x"], y - outer["y"]
    pose = rotate_pose(inner, x, y, angle)
    if step == "x alone turned":
        pose |= {"y": y}
    if step in ("one sign in x", "one sign in y"):
        c, s = math.cos(angle), math.sin(angle)
        pose |= {"x": c * x + s * y} if step == "one sign in x" else {"y": c * y - s * x}
    if step in WRONG_TERMS:
        pose |= dict(zip("xy", rotate_by_formula(x, y, angle, step), strict=True))
    if step == "exchanged":
        pose |= {"x": math.sin(angle) * x - math.cos(angle) * y, "y": math.cos(angle) * x + math.sin(angle) * y}
    if step == "new x":
        pose |= {"y": math.sin(angle) * pose["x"] + math.cos(angle) * y}
    if step == "new x, added":
        pose |= {"y": math.sin(angle) * (pose["x"] + outer["x"]) + math.cos(angle) * y}
    if step == "second lost":
        pose |= {"x": 0.0, "y": 0.0}
    if step == "first twice":
        pose |= {"x": pose["x"] + outer["x"], "y": pose["y"] + outer["y"]}
    if turned == "first":
        pose |= {"x": pose["x"] + inner["x"], "y": pose["y"] + inner["y"]}
    if turned == "second" and step != "lost":
        sign = -1.0 if step == "subtracted" else 1.0
        pose |= {"x": -pose["x"], "y": -pose["y"]} if step == "second subtracted" else {}
        pose |= {"x": pose["x"] + sign * outer["x"], "y": pose["y"] + sign * outer["y"]}
    pose |= {
        "yaw": {
            "sum": one + two,
            "second": two,
            "first": one,
            "difference": two - one,
            "first minus second": one - two,
            "mean": (one + two) / 2,
            "product": one * two,
            "sizes": abs(one) + abs(two),
            "first twice": 2 * one,
            "asin": math.asin(math.sin(one + two)),
            "atan": math.atan(math.tan(one + two)),
            "atan2 exchanged": math.atan2(math.cos(one + two), math.sin(one + two)),
            "mean of directions": math.atan2(math.sin(one) + math.sin(two), math.cos(one) + math.cos(two)),
            "half turns off": one + two - math.copysign(math.pi, one + two) * (abs(one + two) > math.pi),
            "half a turn more": one + two + math.pi,
            "modulo pi": (one + two) % math.pi,
            "clamped": max(-math.pi, min(math.pi, one + two)),
        }[yaw]
    }
    return invert(pose) if end == "inverted" else pose


ANSWERS = {
    "each by its own yaw": lambda one, two: {
        **{
            name: sum(rotate_pose(pose, pose["x"], pose["y"], pose["yaw"])[name] for pose in (one, two))
            for name in ("x", "y")
        },
        "yaw": one["yaw"] + two["yaw"],
    },
}

TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="compose",
    form=PLANAR,
    inputs=draw_pose_pairs,
    variants=3,
    model=compose,
    answers=ANSWERS,
)
