"""Did a function stop in some calls, and is it wrong in others?  Each is told apart: what stops hides no other mistake.

    asked for   1.0   2.0   3.0          returned   -1.0   -2.0   TypeError
                                         -> in 1 of 3 calls it stops; where it does not, the sign is wrong

Read `changes.py` next.
"""

from __future__ import annotations

from collections.abc import Sequence

from ..answers.values import Plain, is_raised
from ..mistakes.fitting import ANY_BUG, alike
from ..mistakes.stumbles import tip_for
from ..tasks.case import Case, TaskCases
from ..words import Words
from .explanation import Explains, Explanation, and_then

__all__ = ["of_stops"]

FEWEST = 3  # calls that have to go on, for what is wrong in them to be no chance
STOPS = Words(
    en="in {stopped} of the {of} calls your function stops with {error}. {tip}",
    ko="호출 {of}번 가운데 {stopped}번에서 함수가 {error} 예외를 내고 멈춥니다. {tip}",
)


def of_stops(
    task: TaskCases,
    cases: Sequence[Case],
    outcomes: Sequence[Plain],
    explained: Explains,
) -> Explanation | None:
    """Return what `explained` says of the calls that go on, and then that others stop; None if either is missing."""
    pairs = list(zip(cases, outcomes, strict=True))
    stopped = [outcome for case, outcome in pairs if is_raised(outcome) and not is_raised(case.expected)]
    rest = [(case, outcome) for case, outcome in pairs if not is_raised(outcome) or is_raised(case.expected)]
    if not stopped or len(rest) < FEWEST or stopped[0]["raises"] not in ANY_BUG | {"AssertionError"}:
        return None
    if all(alike(task.form, outcome, case.expected) for case, outcome in rest):  # any slip fits that shows in none
        return None
    first = explained(task, *zip(*rest, strict=True))
    if first is None:
        return None
    error, tip = stopped[0]["raises"], tip_for(stopped[0]["raises"], stopped[0].get("text", ""))
    filled = {"stopped": len(stopped), "of": len(pairs), "error": error}
    said = Words(*map(str.rstrip, STOPS.filled(**filled, tip=tip)))
    return and_then(first, Explanation.of(f"stops: {error}", said))
