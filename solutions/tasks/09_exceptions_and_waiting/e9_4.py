"""E9.4: Late, or wrong?"""

from __future__ import annotations

import numpy as np

from tflab.workbook.tasks import Choice, Draws, Parts, define_task

CAUSES = ("transforms arrive late", "laser clock is fast", "cannot be told from this")

REMEDIES = ("wait a little", "set the laser's clock", "ask chrony on both computers")

LATE, FAST, UNKNOWN = CAUSES


def draw_arrivals(rng: Draws) -> dict:
    """Draw six seconds of three robots, each with another fault; rows are (stamp, received) [s]."""
    troubles = [CAUSES[i] for i in rng.permutation(3)]
    return {f"robot_{name}": draw_robot(rng, trouble) for name, trouble in zip("abc", troubles, strict=True)}


def draw_robot(rng: Draws, trouble: str) -> dict:
    stamps = round(float(rng.uniform(20.0, 60.0)), 1) + np.arange(6.0)
    scan = 0.105 + rng.uniform(0.0, 0.004, 6)
    odom = 0.004 + rng.uniform(0.0, 0.002, 6)
    if trouble == LATE:
        odom = odom + rng.uniform(0.18, 0.24) + rng.permutation(np.linspace(0.0, 0.25, 6))
    elif trouble == FAST:
        scan = scan - rng.uniform(0.32, 0.48)
    else:
        odom = odom + rng.uniform(0.28, 0.42)
    rows = {"scan": np.column_stack([stamps, stamps + scan]), "odom": np.column_stack([stamps, stamps + odom])}
    return {name: np.round(row, 3) for name, row in rows.items()}


def answers_by(given, cause_of) -> dict:
    """Return an answer in which each robot's cause is `cause_of(scan delays, odom delays)`."""
    answer = {}
    for name in "abc":
        heard = getattr(given, f"robot_{name}")
        scan, odom = (np.asarray(heard[topic])[:, 1] - np.asarray(heard[topic])[:, 0] for topic in ("scan", "odom"))
        cause = cause_of(scan, odom)
        answer[name], answer[f"{name} do"] = cause, REMEDIES[CAUSES.index(cause)]
    return answer


def always_late(given) -> dict:
    return answers_by(given, lambda scan, odom: LATE)


def always_fast(given) -> dict:
    return answers_by(given, lambda scan, odom: FAST)


def no_tremble(given) -> dict:
    return answers_by(given, lambda scan, odom: FAST if scan.min() < 0 else LATE)


def smooth_is_laser(given) -> dict:
    return answers_by(given, lambda scan, odom: LATE if np.ptp(odom) > 0.1 else FAST)


def no_sign(given) -> dict:
    return answers_by(given, lambda scan, odom: LATE if np.ptp(odom) > 0.1 else UNKNOWN)


def tremble_not_trusted(given) -> dict:
    return answers_by(given, lambda scan, odom: FAST if scan.min() < 0 else UNKNOWN)


def always_open(given) -> dict:
    return answers_by(given, lambda scan, odom: UNKNOWN)


def smooth_and_trembling_exchanged(given) -> dict:
    return answers_by(given, lambda scan, odom: FAST if scan.min() < 0 else UNKNOWN if np.ptp(odom) > 0.1 else LATE)


def long_timeout(given) -> dict:
    def cause_of(scan, odom) -> str:
        return FAST if scan.min() < 0 else LATE if np.ptp(odom) > 0.1 else UNKNOWN

    answer = answers_by(given, cause_of)
    late = next(name for name in "abc" if answer[name] == LATE)
    return {**answer, f"{late} do": "set a timeout of 10 s"}


def subtract_the_other_way(fast: str):
    """Return the answers for delays with the wrong sign."""

    def answer(given) -> dict:
        def cause_of(scan, odom) -> str:
            return FAST if max(scan) > 0 else fast

        return answers_by(given, cause_of)

    return answer


ANSWERS = {
    "always late": always_late,
    "ten seconds for the late one": long_timeout,
    "tremble overlooked": no_tremble,
    "smooth means laser": smooth_is_laser,
    "always a clock": always_fast,
    "sign overlooked": no_sign,
    "tremble not trusted": tremble_not_trusted,
    "always open": always_open,
    "smooth and trembling exchanged": smooth_and_trembling_exchanged,
    "stamp minus heard": subtract_the_other_way(UNKNOWN),
    "stamp minus heard, and late": subtract_the_other_way(LATE),
}

TASK = define_task(
    __file__,
    kind="D",
    points=3,
    answer="causes",
    form=Parts(
        {
            **{name: Choice(CAUSES) for name in "abc"},
            **{f"{name} do": Choice((*REMEDIES, "set a timeout of 10 s")) for name in "abc"},
        }
    ),
    given=draw_arrivals,
    variants=6,
    answers=ANSWERS,
)
