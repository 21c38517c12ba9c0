"""E9.7: The smallest wait that always succeeds."""

from __future__ import annotations

import math
from functools import partial
from itertools import pairwise
from statistics import mean
from types import SimpleNamespace

from tflab.workbook.tasks import Draws, Number, WrongStep, define_task

TOLERANCE_S = 0.0005


def draw_edges(rng: Draws) -> dict:
    """Draw until no two mistakes give the same wait; a common pair of mistakes counts as one more."""
    together = partial(compute_wait, periods=0.0, scan=-1.0)
    while True:
        given = _draw_edges(rng)
        held = SimpleNamespace(**given)
        mistakes = [
            partial(compute_wait, **each.at) if isinstance(each, WrongStep) else each.answer for each in TASK.mistakes
        ]
        waits_s = sorted(
            mistake(held) if callable(mistake) else mistake for mistake in (compute_wait, together, *mistakes)
        )
        if min(later - sooner for sooner, later in pairwise(waits_s)) > TOLERANCE_S + 1e-9:
            return given


def _draw_edges(rng: Draws) -> dict:
    """Draw two edges of which the slow one decides, with distinct tenths of a millisecond, and an older scan."""

    def drawn(low_s: float, high_s: float, rest_ms: float) -> float:
        return round(round(float(rng.uniform(low_s, high_s)), 3) + rest_ms / 1000.0, 4)

    return {
        "localization": {
            "rate_hz": float(rng.choice((6.0, 7.0, 7.5, 9.0))),
            "delay_s": drawn(0.070, 0.089, 0.3),
            "jitter_s": drawn(0.020, 0.039, 0.4),
        },
        "wheel_odometry": {
            "rate_hz": float(rng.choice((22.0, 24.0, 26.0))),
            "delay_s": drawn(0.004, 0.014, 0.6),
            "jitter_s": drawn(0.045, 0.059, 0.7),
        },
        "scan_delay_s": drawn(0.010, 0.021, 0.9),
    }


COMBINE = {"max": max, "min": min, "sum": sum, "mean": mean}


def compute_wait(
    given, *, periods=1.0, delay=1.0, jitter=1.0, scan=1.0, combine="max", rate="one over it", edges="by edge"
) -> float:
    """Return the wait [s], step by step; other arguments are mistakes."""
    sources = (given.localization, given.wheel_odometry)
    every = {name: [one[name] for one in sources] for name in ("rate_hz", "delay_s", "jitter_s")}
    period_of = {
        "one over it": lambda hz: 1.0 / hz,
        "as it is": lambda hz: hz,
        "milliseconds": lambda hz: 1000.0 / hz,
        "radians": lambda hz: 1.0 / (math.tau * hz),
    }[rate]
    if edges in ("periods added", "rates added"):
        rates = every["rate_hz"]
        period = sum(1.0 / hz for hz in rates) if edges == "periods added" else 1.0 / sum(rates)
        late = max(delay * one["delay_s"] + jitter * one["jitter_s"] for one in sources)
        return periods * period + late - scan * given.scan_delay_s
    if edges == "the worst of each":
        worst = 1.0 / min(every["rate_hz"]) + max(every["delay_s"]) + max(every["jitter_s"])
        return worst - scan * given.scan_delay_s
    slow = min(sources, key=lambda one: one["rate_hz"])
    if edges == "delays added":
        late = sum(every["delay_s"]) + sum(every["jitter_s"])
        return 1.0 / slow["rate_hz"] + late - scan * given.scan_delay_s
    if edges == "the period alone":
        return 1.0 / slow["rate_hz"]
    if isinstance(edges, tuple):  # whose period, whose delay, whose jitter
        of_period, of_delay, of_jitter = (getattr(given, name) for name in edges)
        mixed = 1.0 / of_period["rate_hz"] + of_delay["delay_s"] + of_jitter["jitter_s"]
        return mixed - scan * given.scan_delay_s
    parts = [(periods * period_of(one["rate_hz"]), delay * one["delay_s"], jitter * one["jitter_s"]) for one in sources]
    each = [math.hypot(*row) if edges == "root of squares" else sum(row) for row in parts]
    return COMBINE[combine](each) - scan * given.scan_delay_s


def subtract_delay(given) -> float:
    """Return the wait for the deciding edge with its delay subtracted."""
    later = max((given.localization, given.wheel_odometry), key=lambda one: 1.0 / one["rate_hz"] + one["delay_s"])
    return 1.0 / later["rate_hz"] - later["delay_s"] + later["jitter_s"] - given.scan_delay_s


ANSWERS = {
    "delay taken off": subtract_delay,
}

TASK = define_task(
    __file__,
    kind="N",
    points=2,
    answer="wait_s",
    form=Number("s", tolerance=TOLERANCE_S),
    given=draw_edges,
    variants=5,
    model=compute_wait,
    answers=ANSWERS,
)
