"""E6.3: One message for all mounts."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.ros.messages import builtin_interfaces, geometry_msgs
from tflab.workbook.tasks import Message, Sequence, define_task

NAMES = ("camera_left", "camera_right", "laser_frame", "imu_link", "sonar_link", "gps_link")


def draw_mount_lists(rng):
    """Draw one to four mounts of several parents, rotated about all axes, with fractional stamps."""
    return [(_mounts(rng, count), _stamp(rng)) for count in (4, 1, 3, 2, 3)]


def _mounts(rng, count):
    names = [str(name) for name in rng.choice(NAMES, count, replace=False)]
    rows = []
    for place, child in enumerate(names):
        way = [float(rng.choice([-1.0, 1.0])) for _ in range(3)]
        rpy = [round(w * float(rng.uniform(0.3, 1.1)), 2) for w in way]
        xyz = [round(w * float(rng.uniform(0.05, 0.6)), 2) for w in reversed(way)]
        parent = "left/mast" if place == (count + 1) % 3 else "base_link"
        row = {"parent": parent, "child": child, "xyz": xyz, "rpy": rpy}
        rows.append(dict(reversed(row.items())) if place % 2 else row)  # a dict is read by its keys
    return rows


def _stamp(rng):
    return builtin_interfaces.Time(sec=int(rng.integers(20, 90)), nanosec=int(rng.integers(1, 999)) * 1_000_000)


def message(mount, stamp, ends, moment, place, order, angle, quaternion):
    t = geometry_msgs.TransformStamped()
    t.header.stamp = builtin_interfaces.Time() if moment == "zero" else stamp
    parent, child = mount["parent"], mount["child"]
    names = {"child first": (child, parent), "base_link": ("base_link", child), "no child": (parent, "")}
    t.header.frame_id, t.child_frame_id = names.get(ends, (parent, child))
    step = t.transform.translation
    step.x, step.y, step.z = (0.0, 0.0, 0.0) if place == "none" else mount["xyz"]
    angles = [math.radians(a) if angle == "degrees" else a for a in mount["rpy"]]
    angles = angles[::-1] if order == "yaw first" else angles
    roll, pitch, yaw = (angles[1], angles[0], angles[2]) if order == "pitch first" else angles
    pitch, yaw = (yaw, pitch) if order == "yaw second" else (pitch, yaw)
    x, y, z, w = Transform.from_rpy(roll=roll, pitch=pitch, yaw=yaw).rotation
    only_yaw = (0.0, 0.0, math.sin(angles[2] / 2), math.cos(angles[2] / 2))
    ways = {
        "xyzw": (x, y, z, w),
        "w first": (w, x, y, z),
        "taken for w first": (y, z, w, x),
        "none": (0.0, 0.0, 0.0, 1.0),
        "angles": (*angles, 1.0),
        "w left out": (x, y, z, 1.0),
        "w for z": (x, y, w, 1.0),
        "z left out": (x, y, 0.0, w),
        "half angles": (*(math.sin(a / 2) for a in angles), 1.0),
        "yaw alone": only_yaw,
        "inverse": (-x, -y, -z, w),
    }
    turn = t.transform.rotation
    turn.x, turn.y, turn.z, turn.w = ways[quaternion]
    return t


def make_transforms(mounts, stamp, *, which="all", objects="each its own", ends="parent first", moment="given",
            place="given", order="roll first", angle="radians", quaternion="xyzw"):  # fmt: skip
    """Return the list for one sendTransform, step by step; other arguments are mistakes."""
    rows = {
        "all": mounts,
        "last": mounts[-1:],
        "first": mounts[:1],
        "reversed": mounts[::-1],
        "by name": sorted(mounts, key=lambda mount: mount["child"]),
    }[which]
    rows = [rows[-1]] * len(rows) if objects == "one" else rows
    moments = ["zero" if moment == "first alone" and number else moment for number in range(len(rows))]
    return [
        message(row, stamp, ends, each, place, order, angle, quaternion)
        for row, each in zip(rows, moments, strict=True)
    ]


TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="letter",
    form=Sequence(
        Message(
            "geometry_msgs/msg/TransformStamped",
            ("header.stamp", "header.frame_id", "child_frame_id", "transform.translation", "transform.rotation"),
        )
    ),
    inputs=draw_mount_lists,
    variants=3,
    model=make_transforms,
)
