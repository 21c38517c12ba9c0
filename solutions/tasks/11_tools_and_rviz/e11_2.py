"""E11.2: Two readings of tf2_echo."""

from __future__ import annotations

import math
import re
from typing import NamedTuple

from tflab.core import StampedTransform, Transform, seconds
from tflab.tools.tf2_echo import echo_text
from tflab.workbook.tasks import Number, Parts, define_task

NUMBER = re.compile(r"-?\d+\.\d+")


def draw_readings(rng):
    """Draw two poses in a curve; the second stamp lost a zero."""
    sec = int(rng.integers(20, 60))
    first_s = sec + round(float(rng.uniform(0.80, 0.95)), 2)
    second_s = sec + 2 + round(float(rng.uniform(0.02, 0.09)), 2)
    speed, way = float(rng.uniform(0.4, 0.9)), float(rng.choice([-1.0, 1.0]))
    rate, yaw = way * float(rng.uniform(0.3, 0.7)), float(rng.uniform(0.7, 1.0)) * float(rng.choice([-1.0, 1.0]))
    x, y, t = float(rng.uniform(1.0, 3.0)), float(rng.uniform(-2.0, 2.0)), second_s - first_s
    step = Transform.from_rpy(
        yaw=rate * t, translation=(speed / rate * math.sin(rate * t), speed / rate * (1 - math.cos(rate * t)), 0.0)
    )
    start = Transform.from_rpy(yaw=yaw, translation=(x, y, 0.0))
    return {
        name: echo_text(StampedTransform("map", "base_link", seconds(at_s), pose))
        for name, at_s, pose in (("first", first_s, start), ("second", second_s, start @ step))
    }


class Reading(NamedTuple):
    """One printed block: the stamp's two texts, the position, the rotation in three forms."""

    sec: str
    nanosec: str
    x: float
    y: float
    radians: float
    degrees: float
    z: float
    w: float


def parts_of(block):
    rows = block.splitlines()
    sec, nanosec = rows[0].removeprefix("At time ").split(".")
    (x, y, _), (*_, z, w), (*_, radians), (*_, degrees) = (map(float, NUMBER.findall(rows[i])) for i in (1, 2, 3, 4))
    return Reading(sec, nanosec, x, y, radians, degrees, z, w)


def stamp_of(block):
    one = parts_of(block)
    return int(one.sec) + int(one.nanosec) / 1e9


def compute_numbers(
    given,
    *,
    zeros="nanoseconds",
    period="of the stamps",
    time="divided",
    which="distance",
    angle="radians",
    turned="later",
):
    """Return the three numbers, step by step; other arguments are mistakes."""
    a, b = parts_of(given.first), parts_of(given.second)

    def stamp(one):
        if zeros == "decimals":
            return float(f"{one.sec}.{one.nanosec}")
        return int(one.sec) + int(one.nanosec) / (1e6 if zeros == "millionths" else 1e9)

    dt = {
        "of the stamps": stamp(b) - stamp(a),
        "a second": 1.0,
        "two seconds": float(int(b.sec) - int(a.sec)),
        "nanoseconds alone": (int(b.nanosec) - int(a.nanosec)) / 1e9,
        "the second stamp": stamp(b),
    }[period]
    x, y = abs(b.x - a.x), abs(b.y - a.y)
    way = {
        "distance": math.hypot(x, y), "x": x, "y": y, "sum": x + y, "no root": x * x + y * y,
        "from the origin": math.hypot(b.x, b.y), "of the distances": math.hypot(b.x, b.y) - math.hypot(a.x, a.y),
    }[which]  # fmt: skip
    one, other = ({
        "radians": each.radians, "degrees": each.degrees, "z": each.z, "twice z": 2 * each.z, "w": each.w,
    }[angle] for each in (a, b))  # fmt: skip
    turn = {
        "later": other - one, "earlier": one - other, "second": other, "first": one, "added": one + other,
        "course": math.atan2(b.y - a.y, b.x - a.x), "wrapped": math.remainder(other - one, math.tau),
    }[turned]  # fmt: skip
    per = dt if time == "multiplied" else 1 / dt
    return {"speed_mps": way * per, "yaw_rate_radps": turn * per, "stamp_s": stamp(b)}


ANSWERS = {
    "time between for the stamp": lambda g: {**compute_numbers(g), "stamp_s": stamp_of(g.second) - stamp_of(g.first)},
    "yaw itself": lambda g: {**compute_numbers(g), "yaw_rate_radps": parts_of(g.second).radians},
    "stamp as decimals": lambda g: {**compute_numbers(g), "stamp_s": float(".".join(parts_of(g.second)[:2]))},
    "stamp of the first": lambda g: {**compute_numbers(g), "stamp_s": stamp_of(g.first)},
}

TASK = define_task(
    __file__,
    kind="N",
    points=3,
    answer="motion",
    form=Parts(
        {
            "speed_mps": Number("m/s", tolerance=0.004),
            "yaw_rate_radps": Number("rad/s", tolerance=0.004),
            "stamp_s": Number("s", tolerance=0.0005),
        }
    ),
    given=draw_readings,
    variants=6,
    model=compute_numbers,
    answers=ANSWERS,
)
