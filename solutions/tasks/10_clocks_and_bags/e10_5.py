"""E10.5: How wrong is the sensor's clock?"""

from __future__ import annotations

import statistics
from itertools import pairwise

from tflab.workbook.tasks import Number, define_task

PICKS = {
    "smallest": min,
    "mean": statistics.fmean,
    "middle": statistics.median,
    "largest": max,
    "first": lambda gaps: gaps[0],
    "last": lambda gaps: gaps[-1],
    "both ends": lambda gaps: (gaps[0] + gaps[-1]) / 2,
    "halfway": lambda gaps: (min(gaps) + max(gaps)) / 2,
}


def draw_log(rng):
    """Draw messages whose first, last, middle, mean, largest and smallest delay differ."""
    while True:
        given = _draw_log(rng)
        gaps = [heard - stamp for stamp, heard in given["log"]]
        told = sorted(pick(gaps) + k * given["shortest_delay_s"] for pick in PICKS.values() for k in (-1, -0.5, 0, 1))
        if min(after - before for before, after in pairwise(told)) > 0.004:
            return given


def _draw_log(rng):
    """Draw thirteen messages with delays of at least the smallest one, and a clock offset."""
    shortest_s = round(float(rng.uniform(0.03, 0.12)), 3)
    behind_s = round(float(rng.choice([-1.0, 1.0])) * float(rng.uniform(0.25, 0.9)), 3)
    begin_s = round(float(rng.uniform(20.0, 60.0)), 1)
    late_s = [round(float(late), 3) for late in rng.uniform(0.02, 0.25, 13)]  # an odd number: one is in the middle
    late_s[int(rng.integers(3, 9))] = 0.0
    log = []
    for number, extra_s in enumerate(late_s):
        true_s = begin_s + 0.1 * number
        log.append((round(true_s - behind_s, 3), round(true_s + shortest_s + extra_s, 3)))
    return {"log": log, "shortest_delay_s": shortest_s}


def clock_offset(g, pick="smallest", delay="taken off", way="heard - stamp", sign="behind"):
    """Return how far the sensor's clock is behind, step by step; other arguments are mistakes."""
    gaps = [heard - stamp if way == "heard - stamp" else stamp - heard for stamp, heard in g.log]
    healthy = {"taken off": -1, "taken off twice": -2, "halved": -0.5, "forgotten": 0, "added": 1}[delay]
    found = PICKS[pick](gaps) + healthy * g.shortest_delay_s
    return -found if sign == "ahead" else found


ANSWERS = {
    "how long the log is": lambda g: g.log[-1][1] - g.log[0][0],
    "spread": lambda g: max(h - s for s, h in g.log) - min(h - s for s, h in g.log),
    "spread turned round": lambda g: min(h - s for s, h in g.log) - max(h - s for s, h in g.log),
    "two messages": lambda g: g.log[0][1] - g.log[-1][0] - g.shortest_delay_s,
    "gained": lambda g: (g.log[-1][1] - g.log[0][1]) - (g.log[-1][0] - g.log[0][0]),
}

TASK = define_task(
    __file__,
    kind="N",
    points=3,
    answer="behind_s",
    form=Number(unit="s", tolerance=0.002),
    given=draw_log,
    variants=8,
    model=clock_offset,
    answers=ANSWERS,
)
