"""E6.4: A circle that drives forward."""

from __future__ import annotations

import math

from tflab.ros.messages import geometry_msgs
from tflab.workbook.tasks import Message, define_task


def draw_circles(rng):
    """Draw circles in both directions with radii other than 1, their starts, and names of several robots."""
    rows = []
    for place, is_left in enumerate((True, False, True, False, True, False)):
        radius = float(rng.choice([0.5, 0.8, 1.5, 2.0, 2.5]))
        speed = float(rng.choice([0.3, 0.4, 0.6, 0.7]))
        angle = float(rng.uniform(0.4, 1.2)) if place % 3 else float(rng.uniform(1.8, 2.6)) + place  # 3: most of a lap
        names = (("odom", "base_link"), ("robot1/odom", "robot1/base_link"), ("fleet/odom", "base_footprint"))[
            place % 3
        ]
        rows.append((round(angle * radius / speed, 3), radius, speed, is_left, *names))
    start = (0.0, 1.5, 0.4)
    return [*rows, (*start, True, "odom", "base_link"), (*start, False, "odom", "base_link")]


def message(odom, base, x, y, xyzw):
    t = geometry_msgs.TransformStamped()
    t.header.frame_id, t.child_frame_id = odom, base
    t.transform.translation.x, t.transform.translation.y = float(x), float(y)
    turn = t.transform.rotation
    turn.x, turn.y, turn.z, turn.w = map(float, xyzw)
    return t


def drive_circle(elapsed_s, radius_m, speed_mps, is_left, odom, base, *, ends="parent first", rate="by radius",
           side="as asked", circle="by radius", heading="forward", angle="radians", half="halved",
           quaternion="z and w", stamp="kept"):  # fmt: skip
    """Return odom -> base on the circle, step by step; other arguments are mistakes."""
    theta = (
        elapsed_s
        * {
            "by radius": speed_mps / radius_m,
            "speed": speed_mps,
            "times": speed_mps * radius_m,
            "over time": speed_mps / radius_m / elapsed_s**2 if elapsed_s else 0.0,
            "to degrees": math.degrees(speed_mps / radius_m),
            "circles": math.tau * speed_mps / radius_m,
            "by diameter": speed_mps / radius_m / 2,
            "time alone": 1.0,
            "turned over": radius_m / speed_mps,
            "in rounds": speed_mps / radius_m / math.tau,
        }[rate]
    )
    left = {"always left": True, "other way": not is_left}.get(side, is_left)
    theta = theta if left or side == "place always left" else -theta
    ahead = math.pi / 2 if left else -math.pi / 2
    turn = {"forward": ahead, "crab": 0.0, "backwards": -ahead, "left's": math.pi / 2, "inwards": math.pi}.get(
        heading, ahead
    )
    yaw = math.degrees(theta + turn) if angle == "degrees" else theta + turn
    yaw = theta + math.degrees(turn) if angle == "quarter in degrees" else yaw
    size = 1.0 if circle == "of one metre" else radius_m
    x, y = size * math.cos(theta), size * math.sin(theta)
    y = -y if side == "heading alone" and not left else y
    x = x - size if circle == "from zero" else x
    x, y = (
        (size * math.cos(math.degrees(theta)), size * math.sin(math.degrees(theta))) if circle == "degrees" else (x, y)
    )
    x, y = (y, x) if circle == "sine first" else (x, y)
    x, y = (
        (size * math.sin(abs(theta)), (1 if left else -1) * size * (1 - math.cos(theta)))
        if circle == "ahead of zero"
        else (x, y)
    )
    yaw = turn if heading == "at the start" else yaw
    z, w = (math.sin(yaw), math.cos(yaw)) if half == "whole" else (math.sin(yaw / 2), math.cos(yaw / 2))
    ways = {"z and w": (0, 0, z, w), "w first": (w, 0, 0, z), "angle": (0, 0, yaw, 1), "none": (0, 0, 0, 1)}
    names = {"child first": (base, odom), "fixed": ("odom", "base_link")}
    parent, child = names.get(ends, (odom, base))
    t = message(parent, child, x, y, ways[quaternion])
    t.header.stamp.sec = int(elapsed_s) + 1 if stamp == "set" else 0
    return t


ANSWERS = {
    "as in the lecture": lambda elapsed_s, radius_m, speed_mps, is_left, odom, base: drive_circle(
        elapsed_s, radius_m, speed_mps, True, "odom", "base_link", rate="speed", circle="of one metre", heading="crab"
    ),
}

TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="on_circle",
    form=Message(
        "geometry_msgs/msg/TransformStamped",
        ("header.frame_id", "child_frame_id", "transform.translation", "transform.rotation", "header.stamp"),
    ),
    inputs=draw_circles,
    variants=3,
    model=drive_circle,
    answers=ANSWERS,
)
