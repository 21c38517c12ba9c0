"""E5.6: The correction, through TF."""

from __future__ import annotations

from tflab.core import LATEST, BufferCore, StampedTransform, Transform, TransformException, seconds
from tflab.workbook.tasks import Pose, define_task

from .draws import draw_planar_pose, draw_sloped_pose, invert, subtract_by_component

STEP_S = 0.2  # between two poses of the wheels
HAIR_NS = 400_000  # less than half a millisecond


def draw_scans(rng):
    """Draw scans between two odometry poses, after the last map edge, too new, too old, and at the bounds."""
    rows = []
    for share in (0.15, 0.35, 0.55, 0.95, 1.25, -0.25):
        buffer, start_s, newest_s = fill_buffer(rng)
        stamp_s = start_s + share * (newest_s - start_s)
        found = draw_sloped_pose(rng) if share == 0.55 else draw_planar_pose(rng)
        rows.append((buffer, found, seconds(round(stamp_s, 3))))
    for end, beyond_ns in (("newest", 0), ("newest", HAIR_NS), ("oldest", 0), ("oldest", -HAIR_NS)):
        buffer, start_s, newest_s = fill_buffer(rng)
        stamp_s = newest_s if end == "newest" else start_s
        rows.append((buffer, draw_planar_pose(rng), seconds(stamp_s) + beyond_ns))
    return rows


def fill_buffer(rng):
    """Return a buffer of a robot that drives a curve, and the first and newest stamp of its odometry [s]."""
    buffer = BufferCore()
    start_s = float(rng.integers(5, 40))
    here = draw_planar_pose(rng)
    speed_mps, yaw_rate_radps = (
        float(rng.uniform(0.4, 0.8)),
        float(rng.choice([-1.0, 1.0])) * float(rng.uniform(0.5, 0.9)),
    )
    step = Transform.from_rpy(yaw=yaw_rate_radps * STEP_S, translation=(speed_mps * STEP_S, 0.0, 0.0))
    edge = draw_planar_pose(rng, 2.0)
    for tick in range(11):
        stamp_ns = seconds(start_s + STEP_S * tick)
        buffer.set_transform(StampedTransform("odom", "base_footprint", stamp_ns, here), "/wheel_odometry")
        if tick <= 7:
            buffer.set_transform(StampedTransform("map", "odom", stamp_ns, edge), "/localization")
        here = here @ step
    return buffer, start_s, start_s + 10 * STEP_S


def correct_odometry(buffer, map_T_base, stamp_ns, *, moment="stamp", asked="odom", refusal="let through",
              wheels="turned round", found="as given", order="found first", way="as asked"):  # fmt: skip
    """Return map_T_odom, step by step; other arguments are mistakes."""
    asked_ns = {
        "stamp": stamp_ns,
        "latest": LATEST,
        "seconds": seconds(stamp_ns),
        "milliseconds": round(stamp_ns / 1e6) * 10**6,
        "whole seconds": stamp_ns // 10**9 * 10**9,
    }[moment]
    try:
        odom_T_base = buffer.lookup_transform(asked, "base_footprint", asked_ns).transform
    except TransformException:
        if refusal == "let through":
            raise
        if refusal == "None":
            return None
        if refusal == "old edge":
            return buffer.lookup_transform("map", "odom", LATEST).transform
        odom_T_base = buffer.lookup_transform(asked, "base_footprint", LATEST).transform
    if wheels == "parts":
        return subtract_by_component(map_T_base, odom_T_base)
    right = invert(odom_T_base, wheels)
    left = map_T_base.inverse() if found == "turned round" else map_T_base
    edge = left @ right if order == "found first" else right @ left
    return edge.inverse() if way == "turned round" else edge


ANSWERS = {
    "what the wheels say": lambda buffer, map_T_base, stamp_ns: (
        buffer.lookup_transform("odom", "base_footprint", stamp_ns).transform
    ),
    "where the robot is": lambda buffer, map_T_base, stamp_ns: map_T_base,
    "the old edge": lambda buffer, map_T_base, stamp_ns: buffer.lookup_transform("map", "odom", stamp_ns).transform,
    "against the old edge": lambda buffer, map_T_base, stamp_ns: (
        map_T_base @ buffer.lookup_transform("map", "odom", stamp_ns).transform.inverse()
    ),
}

TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="correction",
    form=Pose(),
    inputs=draw_scans,
    variants=3,
    model=correct_odometry,
    answers=ANSWERS,
)
