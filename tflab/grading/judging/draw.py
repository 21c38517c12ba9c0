"""Draw the hidden cases of one learner and their order, from the pack's secret seed.

    pool of E2.4     ok ok zero nan ok not-unit w-first ok ...        the same for all who have this variant
    s101 is asked    w-first ok nan ok zero ok w-first(again) ...     a choice, an order and repeats of their own
    s102 is asked    ok not-unit ok ok(again) zero nan ...

All is drawn from the secret seed, the learner and the task: the same submission is
always asked the same, and nobody can know by its number what a call will ask.  How
many there are of each kind varies; there is one at least of each, and enough to tell
every known mistake from what is right (stratified sampling).
"""

from __future__ import annotations

import hashlib
import json
import random
from collections.abc import Collection, Mapping, Sequence
from typing import Any

from tflab.workbook.answers.forms import form_from_plain
from tflab.workbook.answers.values import Plain, is_raised

__all__ = ["POOL", "asks_of", "digest_of", "drawn", "pool_of"]

POOL = 24  # at least, of inputs that are made for each function
FEWEST, MOST = 10, 14  # of which one learner is asked
MOST_AGAIN = 3

PooledCase = Mapping[str, Any]  # as in the cases, with what it "tells" and whether it was "shown"


def digest_of(args: Sequence[Plain]) -> str:
    """Return a name for the arguments of a call."""
    return hashlib.sha256(json.dumps(args, sort_keys=True).encode()).hexdigest()


def pool_of(task: Mapping[str, Any], cases: Sequence[Mapping[str, Any]], shown: Collection[str]) -> list[PooledCase]:
    """Return the cases that can be asked, each once, with the mistakes that each tells from what is right.

    Args:
        shown: the arguments in the public cases, by `digest_of`.
    """
    form = form_from_plain(task["form"])
    once = {digest_of(case["args"]): case for case in cases}
    pool = []
    for name, case in once.items():
        tells = sorted(mistake for mistake, wrong in case["wrong"].items() if not form.alike(wrong, case["expected"]))
        pool.append(dict(case) | {"tells": tells, "shown": name in shown})
    return pool


def drawn(pool: Sequence[PooledCase], key: bytes) -> dict[str, Any]:
    """Return what one learner is asked: the cases, the order of asking (by their numbers), and which were shown."""
    dice = random.Random(key)
    shuffled = dice.sample(pool, len(pool))
    shuffled.sort(key=lambda case: case["shown"])  # what is public only where there is nothing else
    count = dice.randint(FEWEST, MOST)
    cases = _completed(shuffled[:count], shuffled[count:])
    dice.shuffle(cases)
    return {"cases": cases, "asks": _asks(len(cases), dice), "known": [case["shown"] for case in cases]}


def asks_of(task: Mapping[str, Any]) -> Sequence[int]:
    """Return in which order the cases of a task are asked; where nothing was drawn, the first once more at the end."""
    if "asks" in task:
        return task["asks"]
    count = len(task["cases"])
    return [*range(count), 0] if task["is_function"] else [0]


def _completed(taken: Sequence[PooledCase], rest: Sequence[PooledCase]) -> list[PooledCase]:
    """Return the cases with those of the rest that bring in another kind, or tell another mistake."""
    completed = list(taken)
    kinds = {_kind(case) for case in completed}
    told = {name for case in completed for name in case["tells"]}
    for case in rest:
        if _kind(case) not in kinds or not told.issuperset(case["tells"]):
            completed.append(case)
            kinds.add(_kind(case))
            told.update(case["tells"])
    return completed


def _kind(case: PooledCase) -> str:
    """Return of which kind a case is: the exception or the word that is expected; all other values are of one kind."""
    expected = case["expected"]
    if is_raised(expected):
        return f"raises {expected['raises']}"
    return expected if isinstance(expected, str) else ""


def _asks(count: int, dice: random.Random) -> list[int]:
    """Return the numbers of the cases in order, with some once more, far behind their first time."""
    asks = list(range(count))
    for number in dice.sample(range((count + 1) // 2), min(dice.randint(1, MOST_AGAIN), (count + 1) // 2)):
        asks.insert(dice.randint(asks.index(number) + (count + 1) // 2, len(asks)), number)
    return asks
