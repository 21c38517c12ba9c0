"""E6.6: How far does a mount on /tf fall behind?"""

from __future__ import annotations

from itertools import combinations, pairwise
from types import SimpleNamespace

from tflab.workbook.tasks import Number, define_task

COMMON = (
    {"period": "half"}, {"period": "none"}, {"period": "rate"}, {"delay": "none"}, {"delay": "ms"}, {"delay": "twice"},
    {"together": "subtracted"}, {"speed": "none"}, {"speed": "divided"}, {"speed": "zero"},
)  # fmt: skip  # the common mistakes


def draw_mount(rng):
    """Draw a mount that is sent on /tf, until no two mistakes give the same length."""
    while True:
        drawn = {
            "rate_hz": float(rng.choice([2.0, 3.0, 4.0, 5.0, 8.0, 10.0])),
            "delay_ms": float(rng.choice([30.0, 50.0, 70.0, 110.0, 130.0, 160.0])),
            "speed_mps": float(rng.choice([0.4, 0.6, 0.8, 1.2, 1.5])),
        }
        given = SimpleNamespace(**drawn)
        lengths = sorted(worst_error(given, **at) for at in ({}, *COMMON))
        apart = min(after - before for before, after in pairwise(lengths))
        if apart > 0.008 and not _another_unit(given) and not _meets_another(given):
            return drawn


def _meets_another(given):
    """Return whether two mistakes, or a mistake and one of the inputs, give nearly the same number."""
    lengths = [worst_error(given, **at) for at in ({}, *(mistake.at for mistake in TASK.mistakes))]
    lengths = sorted([*lengths, given.delay_ms / 1000.0, 1.0 / given.rate_hz])
    return min(after - before for before, after in pairwise(lengths)) < 0.004


def _another_unit(given):
    """Return whether two mistakes together give the right number in cm or mm."""
    pairs = ((one, other) for one, other in combinations(COMMON, 2) if not one.keys() & other.keys())
    wrong = [worst_error(given, **one, **other) for one, other in pairs]
    return any(abs(length / unit - worst_error(given)) < 0.005 for length in wrong for unit in (100.0, 1000.0))


def worst_error(g, *, period="whole", delay="as seconds", together="added", speed="times"):
    """Return the largest error of the latest transform [m], step by step; other arguments are mistakes."""
    between = {
        "whole": 1.0 / g.rate_hz,
        "half": 0.5 / g.rate_hz,
        "twice": 2.0 / g.rate_hz,
        "none": 0.0,
        "rate": g.rate_hz,
    }[period]
    on_its_way = {
        "as seconds": g.delay_ms / 1000.0,
        "none": 0.0,
        "ms": g.delay_ms,
        "twice": g.delay_ms / 500.0,
        "half": g.delay_ms / 2000.0,
        "hundredths": g.delay_ms / 100.0,
    }[delay]
    age = {"added": between + on_its_way, "subtracted": between - on_its_way, "multiplied": between * on_its_way}
    return {
        "times": g.speed_mps * age[together],
        "period alone": g.speed_mps * between + on_its_way,
        "delay alone": g.speed_mps * on_its_way + between,
        "divided": age[together] / g.speed_mps,
        "none": age[together],
        "zero": 0.0,
    }[speed]


TASK = define_task(
    __file__,
    kind="N",
    points=2,
    answer="worst_error_m",
    form=Number(unit="m", tolerance=0.002),
    given=draw_mount,
    variants=6,
    model=worst_error,
)
