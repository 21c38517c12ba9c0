"""E7.6: Find the tool's tip by touching."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.ros.messages import geometry_msgs
from tflab.workbook.tasks import Message, define_task

from .draws import draw_sign, draw_tool_pose


def draw_touches(rng):
    """Draw tips in front of and next to the flange; most flanges are rotated, one is not."""
    cases = []
    for way in (1.0, 1.0, -1.0, 1.0):
        base_T_tool0 = draw_tool_pose(rng)
        tip = [
            round(float(each), 3)
            for each in (rng.uniform(-0.05, 0.05), way * rng.uniform(0.02, 0.06), rng.uniform(0.08, 0.25))
        ]
        cases.append((base_T_tool0, base_T_tool0.apply(tip)))
    cases.append((Transform(translation=(0.4, 0.1, 0.3)), (0.4, 0.15, 0.45)))
    rows = []
    for base_T_tool0, base_p_tip in cases:
        x, y, yaw = (draw_sign(rng) * float(rng.uniform(0.5, 2.5)) for _ in range(3))
        slope = 0.1 * (len(rows) == 2)  # one robot stands on a ramp
        map_T_base = Transform.from_rpy(roll=slope, pitch=2.0 * slope, yaw=yaw, translation=(x, y, slope))
        rows.append((map_T_base, base_T_tool0, tuple(round(each, 4) for each in map_T_base.apply(base_p_tip))))
    return rows


def make_message(
    map_T_base,
    base_T_tool0,
    map_p_tip,
    *,
    base="turned round",
    inverse="turned round",
    axes="tool",
    sign="plus",
    ends="parent first",
    parent="tool0",
    rotation="none",
    stamp="kept",
):
    """Return the message, step by step; other arguments are mistakes."""
    to_base = {"turned round": map_T_base.inverse(), "as it is": map_T_base}.get(base, Transform())
    base_p_tip = to_base.apply(map_p_tip)
    pose = base_T_tool0.inverse() if inverse == "turned round" else base_T_tool0
    place = pose.apply(base_p_tip)
    if inverse in ("translation negated", "step not turned back"):
        back = tuple(-each for each in base_T_tool0.translation)
        turn = base_T_tool0 if inverse == "translation negated" else base_T_tool0.inverse()
        place = Transform(back, turn.rotation).apply(base_p_tip)
    if inverse == "as it is":
        place = base_p_tip
    if axes != "tool":
        place = [tip - origin for tip, origin in zip(base_p_tip, base_T_tool0.translation, strict=True)]
    if axes == "turned on":
        place = Transform(rotation=base_T_tool0.rotation).apply(place)
    if axes == "step added":
        place = [a + b for a, b in zip(base_p_tip, base_T_tool0.inverse().translation, strict=True)]
    if axes == "flange":
        place = base_T_tool0.translation
    if axes == "length":
        place = (0.0, 0.0, math.dist(base_p_tip, base_T_tool0.translation))
    chains = {"chain as it is": map_T_base @ base_T_tool0, "other order": (base_T_tool0 @ map_T_base).inverse()}
    if axes in chains:
        place = chains[axes].apply(map_p_tip)
    if axes == "map":
        place = [tip - origin for tip, origin in zip(map_p_tip, (map_T_base @ base_T_tool0).translation, strict=True)]
    place = [-each for each in place] if sign == "minus" else list(place)
    names = {"tool0": ("tool0", "tcp"), "base": ("base_link", "tcp"), "tip": ("tool0", "tip")}[parent]
    names = names[::-1] if ends == "child first" else names
    turn = {"none": (0.0, 0.0, 0.0, 1.0), "zeros": (0.0, 0.0, 0.0, 0.0), "tool's": base_T_tool0.rotation,
            "back": base_T_tool0.inverse().rotation}[rotation]  # fmt: skip
    message = geometry_msgs.TransformStamped()
    message.header.frame_id, message.child_frame_id = names
    t, r = message.transform.translation, message.transform.rotation
    t.x, t.y, t.z = map(float, place)
    r.x, r.y, r.z, r.w = map(float, turn)
    message.header.stamp.sec = 1 if stamp == "set" else 0
    return message


TASK = define_task(
    __file__,
    kind="C",
    points=4,
    answer="tcp_mount",
    form=Message(
        "geometry_msgs/msg/TransformStamped",
        ("header.frame_id", "child_frame_id", "transform.translation", "transform.rotation", "header.stamp"),
    ),
    inputs=draw_touches,
    variants=3,
    model=make_message,
)
