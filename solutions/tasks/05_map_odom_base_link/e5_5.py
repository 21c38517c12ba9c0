"""E5.5: The projection onto the floor."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.workbook.tasks import Angle, Number, Parts, define_task


def draw_tilted_bodies(rng):
    """Draw bodies 0.3 to 0.8 m high with roll and pitch, in all directions."""
    rows = []
    for way in (1, -1, 1, -1, 1):
        x, y = (float(rng.choice([-1.0, 1.0])) * float(rng.uniform(0.5, 4.0)) for _ in range(2))
        pitch, roll = (float(rng.choice([-1.0, 1.0])) * float(rng.uniform(0.15, 0.35)) for _ in range(2))
        yaw = way * float(rng.uniform(0.6, 2.4))
        height = float(rng.uniform(0.3, 0.8))
        rows.append((Transform.from_rpy(roll=roll, pitch=pitch, yaw=yaw, translation=(x, y, height)),))
    return rows


def project_footprint(odom_T_base, *, foot="straight down", yaw="rpy"):
    """Return the footprint, step by step; other arguments are mistakes."""
    x, y, height = odom_T_base.translation
    roll, pitch, right = odom_T_base.rpy()
    back = odom_T_base.inverse()
    feet = {
        "straight down": (x, y),
        "its own z": odom_T_base.apply((0.0, 0.0, -height))[:2],
        "inverse": back.translation[:2],
        "origin": (0.0, 0.0),
        "y and z": (x, height),
        "through the floor": odom_T_base.apply((0.0, 0.0, -height / math.cos(pitch) / math.cos(roll)))[:2],
        "shortened": (x * math.cos(pitch), y * math.cos(roll)),
        "up its own z": odom_T_base.apply((0.0, 0.0, height))[:2],
        "by the sine": (x - height * math.sin(pitch), y + height * math.sin(roll)),
        "by the tangent": (x - height * math.tan(pitch), y + height * math.tan(roll)),
        "turned": (x * math.cos(right) - y * math.sin(right), x * math.sin(right) + y * math.cos(right)),
    }
    q_x, q_y, z, w = odom_T_base.rotation
    yaws = {
        "rpy": right,
        "twice atan": 2.0 * math.atan2(z, w),
        "inverse": back.rpy()[2],
        "inverse pitch": back.rpy()[1],
        "negated": -right,
        "roll": roll,
        "pitch": pitch,
        "level": 0.0,
        "twice asin": 2.0 * math.asin(z),
        "twice acos": 2.0 * math.acos(w),
        "z": z,
        "once atan": math.atan2(z, w),
        "degrees": math.degrees(right),
        "roll in degrees": math.degrees(roll),
        "height": height,
        "size": abs(right),
        "x": q_x,
        "w": w,
        "signed acos": math.copysign(2.0 * math.acos(w), z),
        "asin": math.asin(max(-1.0, min(1.0, 2.0 * (w * z + q_x * q_y)))),
        "acos": math.acos(max(-1.0, min(1.0, 1.0 - 2.0 * (q_y * q_y + z * z)))),
        "formula without y": math.atan2(2.0 * (w * z + q_x * q_y), 1.0 - 2.0 * z * z),
        "bearing": math.atan2(y, x),
        "cotangent": 2.0 * math.atan2(w, z),
        "w taken first": 2.0 * math.atan2(w, q_x),
        "formula, w taken first": math.atan2(2.0 * (q_x * w + q_y * z), 1.0 - 2.0 * (z * z + w * w)),
        "formula of x": math.atan2(2.0 * (w * z + q_x * q_y), 1.0 - 2.0 * (q_x * q_x + q_y * q_y)),
    }
    return {"x": feet[foot][0], "y": feet[foot][1], "yaw": yaws[yaw]}


TASK = define_task(
    __file__,
    kind="F",
    points=3,
    answer="footprint",
    form=Parts({"x": Number(unit="m"), "y": Number(unit="m"), "yaw": Angle()}, alone=True),
    inputs=draw_tilted_bodies,
    variants=3,
    model=project_footprint,
)
