"""E7.2: Where the beam meets the floor."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Number, Parts, define_task

BASE_UP_M = 0.10


def draw_tilt(rng):
    """Draw a tilt at which the beam meets the wall before the floor."""
    while True:
        tilt_deg = round(float(rng.uniform(8.0, 14.0)), 1)
        up = int(rng.integers(20, 60)) / 100
        wall = round(float(rng.uniform(0.8, 2.2)), 2)
        left = up + BASE_UP_M - wall * math.tan(math.radians(tilt_deg))
        apart = abs(left - up) > 0.01 and abs(left - (up - BASE_UP_M)) > 0.02  # heights that mistakes give
        if left > 0.12 and apart and abs(up + BASE_UP_M - 2 * left) > 0.02:
            return {
                "tilt_deg": tilt_deg,
                "laser_above_base_link_m": up,
                "base_link_above_floor_m": BASE_UP_M,
                "wall_m": wall,
            }


def intersect_wall(
    g, *, height="both", angle="rad", way="down", ratio="tan", floor="along the floor", wall="what is left"
):
    """Return both points, step by step; other arguments are mistakes."""
    up = {
        "both": g.laser_above_base_link_m + g.base_link_above_floor_m,
        "laser": g.laser_above_base_link_m,
        "base": g.base_link_above_floor_m,
        "minus": g.laser_above_base_link_m - g.base_link_above_floor_m,
    }[height]
    turn = g.tilt_deg if angle == "deg" else math.radians(g.tilt_deg)
    slope = {
        "tan": math.tan(turn),
        "cot": 1.0 / math.tan(turn),
        "sin": math.sin(turn),
        "cos": math.cos(turn),
        "angle": turn,
    }[ratio]
    slope = -slope if way == "up" else slope
    floor_m = {"along the floor": up / slope, "along the beam": math.hypot(up / slope, up),
               "from the wall": up / slope - g.wall_m}[floor]  # fmt: skip
    drop = g.wall_m * slope
    wall_m = {
        "what is left": up - drop,
        "drop": drop,
        "level": up,
        "from the laser": -drop,
        "nothing": 0.0,
        "ahead of it": up / slope - g.wall_m,
        "by the sine": up - g.wall_m * math.sin(turn),
        "over the slope": (up / slope - g.wall_m) / slope,
    }[wall]
    return {"floor_m": floor_m, "wall_up_m": wall_m}


TASK = define_task(
    __file__,
    kind="N",
    points=3,
    answer="beam",
    form=Parts({"floor_m": Number("m", 0.0006), "wall_up_m": Number("m", 0.0006)}),
    given=draw_tilt,
    variants=6,
    model=intersect_wall,
)
