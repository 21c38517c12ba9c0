"""E8.4: How far off?"""

from __future__ import annotations

import math
from itertools import combinations

from tflab.workbook.tasks import Number, Parts, define_task


def draw_motion(rng):
    """Draw until no two mistakes give the same lengths."""
    while True:
        given = _draw_motion(rng)
        delay_s, range_m = given["delay_ms"] / 1000.0, given["range_m"]
        angle = math.radians(abs(given["yaw_rate_degps"])) * delay_s
        ahead, aside = given["speed_mps"] * delay_s, range_m * math.radians(given["yaw_rate_degps"]) * delay_s
        of_the_way, of_the_ray = ahead * angle, range_m * (1.0 - math.cos(angle))
        arcs = (angle, given["speed_mps"] * angle, range_m * angle / math.tau)
        means = ((ahead + aside) / 2.0, math.hypot(ahead, aside) / math.sqrt(2.0))
        is_told_apart = all(abs(one - other) > 0.004 for one, other in (*combinations(arcs, 2), means))
        if of_the_way > 0.008 and abs(of_the_way - of_the_ray) > 0.007 and is_told_apart:
            return given


def _draw_motion(rng):
    way = float(rng.choice([-1.0, 1.0]))
    speed_mps = float(rng.uniform(0.6, 1.8))
    yaw_rate_degps = way * float(rng.uniform(15.0, 40.0))
    range_m = float(rng.uniform(3.0, 8.0))
    if abs(speed_mps - range_m * math.radians(abs(yaw_rate_degps))) < 0.15:  # the two pieces must not look alike
        speed_mps += 0.3
    return {
        "speed_mps": round(speed_mps, 2),
        "yaw_rate_degps": round(yaw_rate_degps, 1),
        "range_m": round(range_m, 1),
        "delay_ms": float(rng.integers(8, 25) * 10),
    }


def estimate(
    given,
    *,
    delay=1e-3,
    forwards=1.0,
    angle="radians",
    arc="range",
    side=1.0,
    places="kept",
    together="hypot",
    way="speed",
):
    """Return the estimate, step by step; other arguments are mistakes."""
    delay_s = given.delay_ms * delay if delay else 1.0
    yaw_rate = given.yaw_rate_degps if angle == "degrees" else math.radians(given.yaw_rate_degps)
    yaw_rate = {
        "to degrees": math.degrees(given.yaw_rate_degps),
        "turns": given.yaw_rate_degps / 360.0,
        "twice": 2.0 * yaw_rate,
    }.get(angle, yaw_rate)
    ahead, aside = forwards * given.speed_mps * delay_s, side * yaw_rate * delay_s
    aside *= {"speed": given.speed_mps, "range": given.range_m, "none": 1.0, "forgotten": 0.0}.get(arc, given.range_m)
    aside = {
        "the way": ahead * yaw_rate * delay_s,
        "range left over": (given.range_m - ahead) * side * yaw_rate * delay_s,
        "no delay": given.range_m * side * yaw_rate,
    }.get(arc, aside)
    ahead = {
        "times range": ahead * given.range_m,
        "range minus": given.range_m - ahead,
        "range plus": given.range_m + ahead,
        "no delay": given.speed_mps,
    }.get(way, ahead)
    aside = {
        "speed times range": ahead * given.range_m,
        "sine of degrees": given.range_m * math.sin(given.yaw_rate_degps * delay_s),
        "one minus cosine": given.range_m * (1 - math.cos(aside / given.range_m)),
    }.get(arc, aside)
    ahead, aside = (aside, ahead) if places == "exchanged" else (ahead, aside)
    lengths = {
        "hypot": math.hypot(ahead, aside),
        "added": abs(ahead) + abs(aside),
        "forwards": abs(ahead),
        "left": abs(aside),
        "mean": (ahead + aside) / 2,
        "sizes taken off": abs(ahead) - abs(aside),
        "squares": ahead**2 + aside**2,
        "rms": math.hypot(ahead, aside) / math.sqrt(2.0),
        "direction": math.atan2(aside, ahead),
    }
    return {"forwards_m": ahead, "left_m": aside, "together_m": lengths[together]}


TASK = define_task(
    __file__,
    kind="N",
    points=3,
    answer="late_error",
    form=Parts(
        {name: Number(unit="m", tolerance=0.003) for name in ("forwards_m", "left_m", "together_m")},
    ),
    given=draw_motion,
    variants=6,
    model=estimate,
)
