"""E7.5: How is this IMU mounted?"""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.workbook.tasks import Choice, Number, Parts, define_task

MOUNTS = {
    "as drawn": {},
    "left": {"yaw": math.pi / 2},
    "right": {"yaw": -math.pi / 2},
    "backwards": {"yaw": math.pi},
    "rolled over": {"roll": math.pi},
    "pitched over": {"pitch": math.pi},
    "pitched over, left": {"pitch": math.pi, "yaw": math.pi / 2},
    "pitched over, right": {"pitch": math.pi, "yaw": -math.pi / 2},
}
FIXES = ("rpy in the joint", "rpy in the visual", "minus in my node", "leave it")


def draw_imu(rng):
    """Draw means over some seconds with the sensor's noise."""
    mount = str(rng.choice([name for name in MOUNTS if name != "as drawn"]))
    speed, rate = round(float(rng.uniform(0.5, 1.0)), 2), round(float(rng.uniform(0.5, 0.9)), 2)
    imu_R_base = Transform.from_rpy(**MOUNTS[mount]).inverse()
    readings = [imu_R_base.apply((0.0, pull, 9.81)) for pull in (0.0, speed * rate)]
    at_rest, in_bend = ([round(float(each + 0.01 * rng.standard_normal()), 3) for each in read] for read in readings)
    return {"at_rest": at_rest, "in_left_bend": in_bend, "speed_mps": speed, "yaw_rate_radps": rate}


def exchange_x_and_y(given) -> dict:
    """Return the answers for an accelerometer that is read as (y, x, z)."""
    x, y, z = given.in_left_bend
    pull = (0.0, given.speed_mps * given.yaw_rate_radps, 9.81)
    mount = min(MOUNTS, key=lambda each: math.dist((y, x, z), Transform.from_rpy(**MOUNTS[each]).inverse().apply(pull)))
    rate = given.yaw_rate_radps
    return {"mount": mount, "gyro_z": rate if z > 0 else -rate, "fix": FIXES[3 if mount == "as drawn" else 0]}


ANSWERS = {
    "x and y exchanged": exchange_x_and_y,
}

TASK = define_task(
    __file__,
    kind="D",
    points=4,
    answer="imu",
    form=Parts({"mount": Choice(tuple(MOUNTS)), "gyro_z": Number("rad/s", 0.02), "fix": Choice(FIXES)}),
    given=draw_imu,
    variants=8,
    answers=ANSWERS,
)
