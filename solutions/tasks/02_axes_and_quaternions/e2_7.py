"""E2.7: Too few digits."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Draws, Number, define_task


def draw_truncated_pi(rng: Draws) -> dict:
    """Draw the digits of pi/2 in a URDF and a distance at which rounding differs from other mistakes."""
    while True:
        written, range_m = float(rng.choice((1.54, 1.55, 1.61, 1.62))), round(float(rng.uniform(8.0, 30.0)), 1)
        quarters = (math.pi / 2, 11 / 7, 1.571, 3.141 / 2)
        off_m = [reach_m * abs(quarter - written) for reach_m in (range_m, 10.0) for quarter in quarters]
        if all(abs(one - round(off_m[0], 2)) > 6e-4 for one in off_m) and abs(range_m - 10.0) > 0.4:
            return {"written_yaw_rad": written, "range_m": range_m}


def lateral_error_mm(
    given, *, quarter="pi / 2", unit="radians", part="whole", reach="range", length="aside", sign="dropped"
):
    """Return the lateral error [mm], step by step; other arguments are mistakes."""
    quarters = {
        "pi / 2": math.pi / 2,
        "3.14 / 2": 3.14 / 2,
        "22/7": 11 / 7,
        "three digits": 1.571,
        "3.141 / 2": 3.141 / 2,
        "pi": math.pi,
        "an eighth": math.pi / 4,
        "90": 90.0,
        "floor": 1.0,
        "none": 0.0,
    }
    missing = quarters[quarter] - given.written_yaw_rad
    missing = {"degrees": math.degrees(missing), "converted": math.radians(missing)}.get(unit, missing)
    missing *= {
        "whole": 1.0,
        "half": 0.5,
        "of a quarter turn": 2 / math.pi,
        "of a whole turn": 0.5 / math.pi,
        "twice": 2.0,
        "times pi": math.pi,
        "times 2 pi": 2 * math.pi,
    }[part]
    reach_m = {"range": given.range_m, "left out": 1.0, "squared": given.range_m**2, "10 m": 10.0,
               "root": math.sqrt(given.range_m)}[reach]  # fmt: skip
    off_m = {
        "aside": reach_m * missing,
        "range": reach_m,
        "quarter": reach_m * math.pi / 2,
        "angle in degrees": math.degrees(missing) / 1000.0,
        "shorter": reach_m * (1 - math.cos(missing)),
        "sine of degrees": reach_m * math.sin(math.degrees(missing)),
        "sine of the written": reach_m * math.sin(given.written_yaw_rad),
        "tangent of the written": reach_m * math.tan(given.written_yaw_rad),
        "cosine, converted": reach_m * math.cos(math.radians(given.written_yaw_rad)),
        "sine, converted": reach_m * math.sin(math.radians(given.written_yaw_rad)),
        "cosine, in degrees": reach_m * math.cos(math.degrees(given.written_yaw_rad)),
        "sine, in degrees": reach_m * math.sin(math.degrees(given.written_yaw_rad)),
        "both angles": reach_m * (math.pi / 2 + given.written_yaw_rad),
        "arc tangent": math.atan(reach_m * missing),
        "of the written": reach_m * missing / given.written_yaw_rad,
        "to metres": round(abs(reach_m * missing)),
        "range and angle": reach_m + abs(missing),
        "bracket missing": reach_m * quarters[quarter] - given.written_yaw_rad / 1000.0,
        "bracket missing, in metres": reach_m * quarters[quarter] - given.written_yaw_rad,
        "to centimetres": round(reach_m * missing, 2),
    }
    return 1000.0 * (abs(off_m[length]) if sign == "dropped" else -abs(off_m[length]))


TASK = define_task(
    __file__,
    kind="N",
    points=2,
    answer="off_mm",
    form=Number(unit="mm", tolerance=0.5),
    given=draw_truncated_pi,
    variants=5,
    model=lateral_error_mm,
)
