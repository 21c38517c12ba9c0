"""E10.7: When must a buffer be cleared?"""

from __future__ import annotations

from itertools import pairwise

from tflab.workbook.tasks import Number, Sequence, define_task


def draw_clocks(rng):
    """Draw values of /clock: jumps back by about 1 s, jumps ahead, loops, and no value."""
    t = float(rng.integers(20, 60))
    lap = [t + 0.25 * step for step in range(int(rng.integers(6, 10)))]
    end = lap[-1]
    return [
        ([*lap, *lap, *lap],),
        (lap,),
        ([*lap, end - 1.0, end - 0.75, end],),
        ([*lap, end - 0.9995, end - 0.5, end + 0.25],),
        ([*lap, end - 1.0005, end + 0.5],),
        ([*lap, end + 30.0, end + 30.25],),
        ([*lap, end - 0.25, end, end - 0.5],),
        ([*lap, end + 0.25, t],),
        ([*lap, end + 30.0, end + 30.25, t, t + 0.25, t - 5.0, t - 4.75, t + 0.5],),
        ([*lap, end - 0.4, end - 0.8, end - 1.2, end + 0.25],),
        ([t + later for later in (9.0, 2.0, 6.0, 1.0, 8.0, 5.0, 7.0, 6.0)],),  # at once, and in no order
        ([t],),
        ([],),
    ]


def find_resets(
    clock_s, back="a second", against="the one before", which="all", tell="after", ahead=False, upto="the end"
):
    """Return when to clear the buffer, step by step; other arguments are mistakes."""
    found = []
    highest = clock_s[0] if clock_s else 0.0
    if tell == "after" and which == "and the first":
        found = list(clock_s[:1])
    for place, (before, after) in enumerate(pairwise(clock_s[:-1] if upto == "the last but one" else clock_s)):
        highest = max(highest, before)
        step = {"the one before": before, "the highest": highest, "the first": clock_s[0]}[against] - after
        is_back = {
            "a second": step >= 1.0, "any": step > 0.0, "more": step > 1.0, "ahead": step <= -1.0,
            "whole seconds": int(before) - int(after) >= 1 and against == "the one before",
            "small": 0.0 < step < 1.0, "almost": step >= 0.9, "turned round": step >= -1.0,
        }[back]  # fmt: skip
        if is_back and against == "the highest" and which == "begun anew":
            highest = after
        if is_back or (ahead and -step >= 1.0):
            found.append(
                {"after": after, "before": before, "step": step, "place": place + 1, "place before": place}[tell]
            )
    return {"first": found[:1], "last": found[-1:]}.get(which, found)


ANSWERS = {
    "two before": lambda clock_s: [
        after for before, after in zip(clock_s, clock_s[2:], strict=False) if before - after >= 1.0
    ],
    "every other pair": lambda clock_s: [b for a, b in zip(clock_s[::2], clock_s[1::2], strict=False) if a - b >= 1.0],
}

TASK = define_task(
    __file__,
    kind="F",
    points=3,
    answer="jumps",
    form=Sequence(Number(unit="s")),
    inputs=draw_clocks,
    variants=3,
    model=find_resets,
    answers=ANSWERS,
)
