"""E8.6: How long must it remember?"""

from __future__ import annotations

import math
from itertools import pairwise

from tflab.workbook.tasks import Number, define_task

AMOUNTS_S = (0.05, 0.1, 0.2, 0.3, 0.5, 2.0)  # common safety margins besides 1.0
SHARES = (1.1, 1.2, 1.25, 1.3, 1.5)


def draw_detector(rng):
    """Draw until no two of the possible wrong times are close to each other."""
    while True:
        slow, fast = float(rng.choice([0.35, 0.7, 1.4, 3.5])), float(rng.choice([22.0, 24.0, 45.0]))  # no round periods
        thinking_s, period_s, short_s = round(float(rng.uniform(1.5, 6.0)), 2), 1.0 / slow, 1.0 / fast
        sums = [by * thinking_s + times * period_s for by in (0, 1, 2) for times in (-1, 0, 0.5, 1, 2, 3)]
        means = [(period_s + short_s) / 2, period_s + short_s, 1.0 / (slow + fast), 2.0 / (slow + fast), 1.0]
        sums += [
            thinking_s + more for more in (*means, -short_s, short_s, 2 * short_s, 3 * short_s, period_s - short_s)
        ]
        times_s = [*sums, thinking_s * period_s, thinking_s * slow, thinking_s + slow, 10.0, 20.0, 30.0]
        times_s += [by * thinking_s for by in SHARES] + [thinking_s + by for by in AMOUNTS_S]
        times_s += [10.0 + period_s, *map(float, _in_whole(thinking_s, slow, fast)), (thinking_s + 1.0) * period_s]
        times_s = sorted([*times_s, *_in_whole_periods(thinking_s, slow)])
        is_no_rounding = abs(math.ceil(thinking_s) - thinking_s - period_s) > 0.1
        if is_no_rounding and min(b - a for a, b in pairwise(times_s)) > 0.005:
            return {"thinking_s": thinking_s, "rate_hz": {"map -> odom": slow, "odom -> base_link": fast}}


def _in_whole(thinking_s, slow, fast):
    """Return the possible whole numbers: of seconds and of samples."""
    counts = [math.ceil(thinking_s * rate) for rate in (slow, fast)]
    return (math.ceil(thinking_s), math.ceil(thinking_s + 1.0 / slow), *counts, *(count + 1 for count in counts))


def _in_whole_periods(thinking_s, slow):
    count = math.ceil(thinking_s * slow)
    return (count / slow, (count + 1) / slow, math.ceil(thinking_s) + 1.0 / slow)


def cache_time(g, *, thinking=1.0, lane="slow", times=1.0, joined="added"):
    """Return the cache time, step by step; other arguments are mistakes."""
    periods = [1.0 / rate for rate in g.rate_hz.values()]
    more = {"slow": max(periods), "fast": min(periods), "both": sum(periods), "rate": min(g.rate_hz.values())}
    more = (more | {"fast rate": max(g.rate_hz.values())})[lane]
    return thinking * g.thinking_s * times * more if joined == "multiplied" else thinking * g.thinking_s + times * more


ANSWERS = {
    "ten more": lambda g: 10.0 + g.thinking_s,
    "number of samples": lambda g: g.thinking_s * max(g.rate_hz.values()),
    "number of slow samples": lambda g: g.thinking_s * min(g.rate_hz.values()),
    "half as much again": lambda g: 1.5 * (g.thinking_s + 1.0 / min(g.rate_hz.values())),
    "mean period": lambda g: g.thinking_s + sum(1.0 / rate for rate in g.rate_hz.values()) / 2,
    "mean rate": lambda g: g.thinking_s + 2.0 / sum(g.rate_hz.values()),
    "sum of rates": lambda g: g.thinking_s + 1.0 / sum(g.rate_hz.values()),
    "ten and a period": lambda g: 10.0 + 1.0 / min(g.rate_hz.values()),
    "rounded up": lambda g: float(math.ceil(g.thinking_s + 1.0 / min(g.rate_hz.values()))),
    "thinking rounded up": lambda g: float(math.ceil(g.thinking_s)),
    "thinking rounded up, and a period": lambda g: math.ceil(g.thinking_s) + 1.0 / min(g.rate_hz.values()),
    "brackets": lambda g: (g.thinking_s + 1.0) / min(g.rate_hz.values()),
    "difference of periods": lambda g: g.thinking_s + 1.0 / min(g.rate_hz.values()) - 1.0 / max(g.rate_hz.values()),
    "twice all": lambda g: 2.0 * (g.thinking_s + 1.0 / min(g.rate_hz.values())),
    **{f"{share} times the thinking time": lambda g, share=share: share * g.thinking_s for share in SHARES},
    **{f"{amount_s} s more": lambda g, amount_s=amount_s: g.thinking_s + amount_s for amount_s in (*AMOUNTS_S, 1.0)},
    **{
        f"count of {which.__name__} samples, and {more}": lambda g, which=which, more=more: float(
            math.ceil(g.thinking_s * which(g.rate_hz.values())) + more
        )
        for which in (min, max)
        for more in (0, 1)
    },
    **{
        f"whole periods, and {more}": lambda g, more=more: (
            (math.ceil(g.thinking_s * min(g.rate_hz.values())) + more) / min(g.rate_hz.values())
        )
        for more in (0, 1)
    },
}

TASK = define_task(
    __file__,
    kind="N",
    points=2,
    answer="cache_time_s",
    form=Number(unit="s", tolerance=0.002),
    given=draw_detector,
    variants=6,
    model=cache_time,
    answers=ANSWERS,
)
