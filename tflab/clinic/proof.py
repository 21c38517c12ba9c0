"""Decide whether the chosen checks prove a diagnosis: they must exclude every other possible cause.

    suspect   delay /scan      rivals left
    ahead     ahead
    late      as on the card   struck       one question, two rivals ruled out: a proof in one minute
    slow      as on the card   struck

A guess is no proof, even a right one; nor is a list that asks for everything, for
what comes after the last rival is struck tells nothing.  In the field this is
*sequential diagnosis*: the cheapest tests that isolate a fault.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Sequence
from itertools import permutations
from typing import NamedTuple

from .checks import BUDGET_MIN, CHECKS
from .table import COMPLAINTS, SUSPECTS, expected_kind

__all__ = [
    "NOTHING_IS_WRONG",
    "Flaw",
    "best_check",
    "bits_per_minute",
    "check_steps",
    "consistent_suspects",
    "find_flaw",
    "minutes_of",
    "rivals_left",
    "rivals_of",
    "shortest_proof",
]

NOTHING_IS_WRONG = "nothing is wrong"


class Flaw(NamedTuple):
    """What keeps a list of checks from being a proof.

    Attributes:
        kind: "unproved", "idle", "late" or "all healthy".
        rival: of an unproved one, whom the checks do not tell apart.
        count, minutes: of an idle one, how many checks were enough, and how long the rest takes [min];
            of a late one, how long all of it takes.
    """

    kind: str
    rival: str = ""
    count: int = 0
    minutes: float = 0.0


def rivals_of(suspect: str, whole: bool = False) -> tuple[str, ...]:
    """Return the other suspects of the same complaint; with `whole`, all other seventeen."""
    others = SUSPECTS if whole else next(each.suspects for each in COMPLAINTS.values() if suspect in each.suspects)
    return tuple(other for other in others if other != suspect)


def minutes_of(checks: Iterable[str]) -> float:
    """Return how long some checks take [min]."""
    return sum(CHECKS[check].minutes for check in checks)


def rivals_left(suspect: str, rivals: Sequence[str], checks: Sequence[str]) -> list[tuple[str, ...]]:
    """Return which rivals are left after each check, were it this suspect."""
    left, rows = tuple(rivals), []
    for check in checks:
        kind = expected_kind(suspect, check)
        left = tuple(rival for rival in left if expected_kind(rival, check) == kind)
        rows.append(left)
    return rows


def find_flaw(checks: Sequence[str], suspect: str, whole: bool = False, budget_min: float = BUDGET_MIN) -> Flaw | None:
    """Return what keeps `checks`, keys of `CHECKS` in their order, from proving a suspect; None if they do."""
    rows = rivals_left(suspect, rivals_of(suspect, whole), checks)
    if not rows or rows[-1]:
        return Flaw("unproved", (rows[-1] if rows else rivals_of(suspect, whole))[0])
    sick = [expected_kind(suspect, check) != CHECKS[check].usual for check in checks]
    if not any(sick) and suspect != NOTHING_IS_WRONG:
        return Flaw("all healthy")
    enough = 1 + next(
        number
        for number, left in enumerate(rows)
        if not left and (any(sick[: number + 1]) or suspect == NOTHING_IS_WRONG)
    )
    if enough < len(checks):
        return Flaw("idle", count=enough, minutes=minutes_of(checks[enough:]))
    return Flaw("late", minutes=minutes_of(checks)) if minutes_of(checks) > budget_min else None


def consistent_suspects(found: dict[str, str], suspects: Iterable[str] = SUSPECTS) -> tuple[str, ...]:
    """Return the suspects that would have given just these findings: of each check its kind."""
    return tuple(
        suspect for suspect in suspects if all(expected_kind(suspect, check) == kind for check, kind in found.items())
    )


def check_steps(cause: str, checks: Sequence[str]) -> list[tuple[str, float, int]]:
    """Return a way of asking as `draw_order` takes it: of each check its minutes, and how many suspects were left."""
    left = rivals_left(cause, rivals_of(cause), checks)
    return [(check, CHECKS[check].minutes, 1 + len(rivals)) for check, rivals in zip(checks, left, strict=True)]


def shortest_proof(suspect: str) -> list[str]:
    """Return the cheapest one or two checks that prove a suspect of a complaint."""
    lists = (list(checks) for count in (1, 2) for checks in permutations(CHECKS, count))
    return min((checks for checks in lists if find_flaw(checks, suspect) is None), key=minutes_of)


def bits_per_minute(check: str, suspects: Sequence[str]) -> float:
    """Return how much a check is expected to tell about suspects that are equally likely [bit/min]."""
    sizes = Counter(expected_kind(suspect, check) for suspect in suspects).values()
    told = math.log2(len(suspects)) - sum(size * math.log2(size) for size in sizes) / len(suspects)
    return told / CHECKS[check].minutes


def best_check(suspects: Sequence[str]) -> str:
    """Return the check that tells most about suspects for a minute; the first of them where several do."""
    return max(CHECKS, key=lambda check: bits_per_minute(check, suspects))
