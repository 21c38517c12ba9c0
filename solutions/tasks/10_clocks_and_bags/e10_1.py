"""E10.1: Four set-ups."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Sequence, define_task

KINDS = ("works", "just short", "years off", "silently latest", "never")
LETTERS = "abcd"
ORDERS = {
    "timer second": (0, 2, 1),
    "timer first": (2, 0, 1),
    "now first": (1, 0, 2),
    "now, timer, stamp": (1, 2, 0),
    "backwards": (2, 1, 0),
}


def draw_setups(rng):
    """Draw the four ways to set use_sim_time and --clock, in any order."""
    ways = [(sim, clock) for sim in (False, True) for clock in (False, True)]
    order = rng.permutation(len(ways))
    chosen = [ways[i] for i in order]
    return {
        "setups": {
            letter: {"use_sim_time": sim, "--clock": clock}
            for letter, (sim, clock) in zip(LETTERS, chosen, strict=True)
        }
    }


def judge_setups(
    g, who="the parameter", stamp="the bag's", machine="years off", stopped="silently latest", running="just short",
    stopped_timer="never", machine_timer="works", order="as asked",
):  # fmt: skip
    """Return the three outcomes of each setup, step by step; other arguments are mistakes."""
    answers = {}
    for letter, way in g.setups.items():
        sim, clock = way["use_sim_time"], way["--clock"]
        if who == "the player":
            sim = clock
        elif who == "either":
            sim = sim or clock
        elif who == "the parameter alone":
            clock = True
        if not sim:
            answers[letter] = _on_the_machines_time(stamp, clock, machine, machine_timer, stopped_timer)
        elif not clock:
            at_stamp = {"the bag's": "works", "needs sim": "works", "needs time": "never", "needs both": "never"}
            answers[letter] = [at_stamp.get(stamp, "years off"), stopped, stopped_timer.split(",")[0]]
        else:
            answers[letter] = ["works", running, "works"]
        answers[letter] = [answers[letter][place] for place in ORDERS.get(order, (0, 1, 2))]
    return answers


def _on_the_machines_time(stamp, clock, machine, timer, stopped_timer):
    if stamp == "needs --clock":
        at_stamp = "works" if clock else "years off"
    else:
        at_stamp = "years off" if stamp in ("needs sim", "needs both") else "works"
    now = ("works" if clock else "years off") if machine == "helped by --clock" else machine
    return [at_stamp, now, "never" if "nor" in stopped_timer and not clock else timer]


TASK = define_task(
    __file__,
    kind="M",
    points=4,
    answer="outcomes",
    form=Parts({letter: Sequence(Choice(KINDS)) for letter in LETTERS}),
    given=draw_setups,
    variants=8,
    model=judge_setups,
)
