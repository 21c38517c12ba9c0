"""E3.6: Mount the camera."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.ros.messages import geometry_msgs
from tflab.workbook.tasks import Draws, Message, define_task

from .draws import draw_yaw_degrees


def draw_mounts(rng: Draws) -> list[tuple]:
    cases = [(int(rng.integers(5, 40)) / 100, int(rng.integers(20, 60)) / 100, draw_yaw_degrees(rng)) for _ in range(4)]
    cases += [
        (0.10, 0.30, 0),
        (0.10, 0.30, 90),
        (2, 1, 30),
        (0.125, 0.405, 22.5),
        (0.45, 0.15, -178),
        (0.25, 0.35, 250),
        (-0.20, -0.15, 45),  # behind and below
    ]
    return [(float(ahead_m), float(up_m), yaw_deg) for ahead_m, up_m, yaw_deg in cases]


def camera_message(parent: str, child: str, ahead_m: float, up_m: float, xyzw) -> geometry_msgs.TransformStamped:
    t = geometry_msgs.TransformStamped()
    t.header.frame_id, t.child_frame_id = parent, child
    t.transform.translation.x, t.transform.translation.z = float(ahead_m), float(up_m)
    q = t.transform.rotation
    q.x, q.y, q.z, q.w = map(float, xyzw)
    return t


OPTICAL = Transform.from_rpy(roll=-math.pi / 2, yaw=-math.pi / 2)


def half_turn(yaw: float) -> tuple[float, float]:
    return math.sin(yaw / 2), math.cos(yaw / 2)


def mount_camera(ahead_m, up_m, yaw_deg, *, ends="parent first", numbers="as given", axes="x and z", length="m",
            angle="radians", side="left", half="halved", quaternion="sine", stamp="kept"):  # fmt: skip
    """Return the message, step by step; other arguments are mistakes."""
    parent, child = ("camera_link", "base_link") if ends == "child first" else ("base_link", "camera_link")
    child = "camera_optical_frame" if ends == "optical" else child
    child = {"camera": "camera", "laser": "laser_frame"}.get(ends, child)
    parent = {"map": "map", "odom": "odom", "base": "base", "footprint": "base_footprint",
              "laser below": "laser_frame"}.get(ends, parent)  # fmt: skip
    yaw = {"degrees": yaw_deg, "radians": math.radians(yaw_deg), "to degrees": math.degrees(yaw_deg),
           "whole degrees": math.radians(int(yaw_deg)),
           "half cut off": math.radians(2 * (yaw_deg // 2)), "no pi": yaw_deg / 180,
           "twice": math.radians(math.radians(yaw_deg)),
           "halved": math.radians(yaw_deg) / 2}[angle]  # fmt: skip
    yaw = -yaw if side == "right" else yaw
    z, w = half_turn(2 * yaw if half == "whole" else yaw)
    ways = {
        "sine": (0, 0, z, w),
        "w first": (w, 0, 0, z),
        "none": (0, 0, 0, 1),
        "roll": (z, 0, 0, w),
        "pitch": (0, z, 0, w),
        "angle": (0, 0, yaw, 1),
        "degrees": (0, 0, yaw_deg, 1),
        "half in z": (0, 0, z, math.cos(yaw)),
        "half in w": (0, 0, math.sin(yaw), w),
        "w lost": (0, 0, z, 0),
        "w one": (0, 0, z, 1),
        "zero": (0, 0, 0, 0),
        "exchanged": (0, 0, w, z),
        "optical": (Transform(rotation=(0, 0, z, w)) @ OPTICAL).rotation,
    }
    x, y, up = {"x and z": (ahead_m, 0.0, up_m), "exchanged": (up_m, 0.0, ahead_m), "y": (ahead_m, up_m, 0.0),
                "optical": (0.0, -up_m, ahead_m), "minus y": (ahead_m, -up_m, 0.0), "y ahead": (0.0, ahead_m, up_m),
                "y up, z ahead": (0.0, up_m, ahead_m), "ahead twice": (ahead_m, 0.0, ahead_m),
                "up twice": (up_m, 0.0, up_m), "ahead in y too": (ahead_m, ahead_m, up_m),
                "up in y too": (ahead_m, up_m, up_m)}[axes]  # fmt: skip
    if numbers == "inverse":
        back = Transform(rotation=(0, 0, *half_turn(yaw)), translation=(x, y, up)).inverse()
        (x, y, up), ways["sine"] = back.translation, back.rotation
    if numbers == "turned":
        x, y, up = Transform(rotation=(0, 0, *half_turn(yaw))).apply((x, y, up))
    if numbers == "turned back":
        x, y, up = Transform(rotation=(0, 0, *half_turn(-yaw))).apply((x, y, up))
    if numbers == "negative":
        x, y, up = -x, -y, -up
    scale = 1000.0 if length == "mm" else 1.0
    t = camera_message(parent, child, scale * x, scale * up, ways[quaternion])
    t.transform.translation.y = scale * y
    t.header.stamp.sec = 1 if stamp == "set" else 0
    return t


TASK = define_task(
    __file__,
    kind="C",
    points=4,
    answer="camera_mount",
    form=Message(
        "geometry_msgs/msg/TransformStamped",
        ("header.frame_id", "child_frame_id", "transform.translation", "transform.rotation", "header.stamp"),
    ),
    inputs=draw_mounts,
    variants=3,
    model=mount_camera,
)
