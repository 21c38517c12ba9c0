"""E1.4: How far ahead is it now?"""

from __future__ import annotations

from tflab.workbook.tasks import Number, Parts, define_task


def draw_late_message(rng):
    """Draw a message that arrives in the next second, with a nanosec below 0.1 s."""
    sec = int(rng.integers(11, 95))
    stamp_ms = int(rng.integers(560, 880))
    arrived_ms = 1000 + int(rng.integers(12, 96)) + (1000 if rng.random() < 0.3 else 0)
    return {
        "stamp": [sec, stamp_ms * 1_000_000],
        "arrived": [sec + arrived_ms // 1000, arrived_ms % 1000 * 1_000_000],
        "speed_mps": round(float(rng.uniform(0.6, 0.9)) + 0.3 * float(rng.choice([0.0, 2.0])), 2),
        "ahead_m": round(float(rng.uniform(3.0, 7.0)), 2),
    }


def seconds_of(stamp):
    return stamp[0] + stamp[1] / 1e9


def as_digits(stamp):
    return float(f"{stamp[0]}.{stamp[1]}")


def age_and_distance(given, *, age="all", way="arrival minus stamp", unit="s", drive="closer", written="s"):
    """Return age and distance, step by step; other arguments are mistakes."""
    (sec, nanosec), (arrived_sec, arrived_nanosec) = given.stamp, given.arrived
    age_s = {
        "all": seconds_of(given.arrived) - seconds_of(given.stamp),
        "digits": as_digits(given.arrived) - as_digits(given.stamp),
        "sec alone": float(arrived_sec - sec),
        "nanosec alone": (arrived_nanosec - nanosec) / 1e9,
        "nanosec alone, without sign": abs(arrived_nanosec - nanosec) / 1e9,
        "stamp cut": seconds_of(given.arrived) - sec,
        "arrival cut": arrived_sec - seconds_of(given.stamp),
        "a zero too few": arrived_sec - sec + (arrived_nanosec - nanosec) / 1e8,
        "a zero too many": arrived_sec - sec + (arrived_nanosec - nanosec) / 1e10,
        "by a million": arrived_sec - sec + (arrived_nanosec - nanosec) / 1e6,
        "by a thousand": arrived_sec - sec + (arrived_nanosec - nanosec) / 1e3,
        "three zeros too many": arrived_sec - sec + (arrived_nanosec - nanosec) / 1e12,
        "added": arrived_sec - sec + (arrived_nanosec + nanosec) / 1e9,
        "as they are": float(arrived_sec - sec + arrived_nanosec - nanosec),
        "sum": seconds_of(given.arrived) + seconds_of(given.stamp),
        "to tenths": round(seconds_of(given.arrived) - seconds_of(given.stamp), 1),
        "to hundredths": round(seconds_of(given.arrived) - seconds_of(given.stamp), 2),
        "none": 0.0,
        "arrival": seconds_of(given.arrived),
        "stamp": seconds_of(given.stamp),
        "without borrowing": arrived_sec - sec + abs(arrived_nanosec - nanosec) / 1e9,
    }[age]
    age_s *= (-1.0 if way == "stamp minus arrival" else 1.0) * {"ms": 1e3, "ns": 1e9}.get(unit, 1.0)
    ahead_m, driven_m = given.ahead_m, given.speed_mps * age_s
    left = {
        "closer": ahead_m - driven_m,
        "away": ahead_m + driven_m,
        "left out": ahead_m,
        "until the arrival": ahead_m - given.speed_mps * seconds_of(given.arrived),
        "in km/h": ahead_m - given.speed_mps / 3.6 * age_s,
        "faster in km/h": ahead_m - given.speed_mps * 3.6 * age_s,
        "difference first": (ahead_m - given.speed_mps) * age_s,
        "speed minus age": ahead_m - (given.speed_mps - age_s),
        "speed plus age": ahead_m - (given.speed_mps + age_s),
        "the way driven": driven_m,
        "age alone": ahead_m - age_s,
        "age added": ahead_m + age_s,
        "divided": ahead_m - given.speed_mps / age_s if age_s else ahead_m,
        "age over speed": ahead_m - age_s / given.speed_mps,
        "way minus distance": driven_m - ahead_m,
        "time to the post": ahead_m / given.speed_mps,
    }[drive]
    return {"age_s": age_s * (1000.0 if written == "ms" else 1.0), "ahead_m": left}


TASK = define_task(
    __file__,
    kind="N",
    points=3,
    answer="on_arrival",
    form=Parts({"age_s": Number(unit="s", tolerance=0.0005), "ahead_m": Number(unit="m", tolerance=0.003)}),
    given=draw_late_message,
    variants=6,
    model=age_and_distance,
)
