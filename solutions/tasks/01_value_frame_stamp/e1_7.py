"""E1.7: Four detectors, one correct."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

NAMES = ("red", "green", "blue", "grey")
HONEST, ARRIVAL, NONE, LABEL = "honest", "stamp is the arrival", "no stamp", "wrong label"
FINDINGS = (HONEST, ARRIVAL, NONE, LABEL)
THINKING_S = 0.2


def draw_logs(rng):
    speed = round(float(rng.uniform(0.4, 1.2)), 2)
    ball_m = round(float(rng.uniform(7.0, 9.0)), 2)
    start_m = round(float(rng.uniform(0.5, 2.0)), 2)
    of = dict(zip(NAMES, (FINDINGS[i] for i in rng.permutation(4)), strict=True))
    heard = {}
    for i, (name, finding) in enumerate(of.items()):
        lines = []
        for n in range(5):
            stamp = round(5.0 + 0.5 * n + 0.07 * i, 2)
            arrival = round(stamp + THINKING_S, 2)
            ahead = round(ball_m - start_m - speed * stamp, 2)
            lines.append({
                HONEST: [arrival, stamp, "map", ball_m],
                ARRIVAL: [arrival, arrival, "map", round(ball_m + speed * THINKING_S, 2)],
                NONE: [arrival, 0.0, "base_link", ahead],
                LABEL: [arrival, stamp, "map", ahead],
            }[finding])  # fmt: skip
        heard[name] = lines
    return {"speed_mps": speed, "heard": heard}


def find_faults(given):
    """Return the right findings for the clues."""
    return {name: _finding(lines) for name, lines in given.heard.items()}


def _finding(lines):
    (arrival, stamp, frame, first), last = lines[0], lines[-1][3]
    if stamp == 0.0:
        return NONE
    if stamp == arrival:
        return ARRIVAL
    return LABEL if frame == "map" and first - last > 0.1 else HONEST


def findings_with(**said):
    """Return the findings with other values for some kinds of clues."""
    swaps = {ARRIVAL: said.get("arrival", ARRIVAL), LABEL: said.get("label", LABEL), HONEST: said.get("honest", HONEST)}
    swaps[NONE] = said.get("none", NONE)
    return lambda given: {name: swaps[finding] for name, finding in find_faults(given).items()}


ANSWERS = {
    "fast is honest": findings_with(arrival=HONEST),
    "fast is the honest one": findings_with(arrival=HONEST, honest=ARRIVAL),
    "a known frame is honest": findings_with(label=HONEST),
    "shrinking is a lie": findings_with(none=LABEL),
    "zero is fine": findings_with(none=HONEST),
    "late is a fault": findings_with(honest=LABEL, label=HONEST),
}

TASK = define_task(
    __file__,
    kind="D",
    points=3,
    answer="findings",
    form=Parts({name: Choice(FINDINGS) for name in NAMES}),
    given=draw_logs,
    variants=6,
    answers=ANSWERS,
)
