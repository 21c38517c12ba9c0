"""Which right results show that a function works?  Not those that anything would give.

    asked for      3.1   0.0  -2.4   0.0           [True, True]: two different results, and right
    always 0.0     0.0   0.0   0.0   0.0    right in two cases, but for one result only: no credit

Credit for one probe is given where the function is right for two different
results; a clock that stands still is right twice a day.  So a constant earns
nothing, neither does handing back what came in, nor raising whatever is asked.

Read `verdict.py` next.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import combinations

from ..answers.forms import Form
from ..answers.values import Plain, is_raised
from .case import Case

__all__ = ["credited", "habit"]


def credited(
    form: Form, cases: Sequence[Case], outcomes: Sequence[Plain], rights: Sequence[list[bool]]
) -> list[list[bool]]:
    """Return for each case which of its probes earn credit: those of `rights` that show something.

    Args:
        form: of the function's result.
        cases: with their arguments and what is expected.
        outcomes: for each case what came out, as `to_plain` writes it.
        rights: for each case and probe, whether it is right.
    """
    if len(cases) < 2 or all(map(all, rights)):
        return [list(row) for row in rights]
    if habit(form, cases, outcomes):
        return [[False] * len(row) for row in rights]
    kept = [list(row) for row in rights]
    values = [number for number, case in enumerate(cases) if not is_raised(case.expected)]
    for place in range(min((len(rights[number]) for number in values), default=0)):
        expected = [cases[number].expected for number in values]
        right = [cases[number].expected for number in values if rights[number][place]]
        if _differ(form, expected, place) and not _differ(form, right, place):
            for number in values:
                kept[number][place] = False
    return kept


def habit(form: Form, cases: Sequence[Case], outcomes: Sequence[Plain]) -> str:
    """Return what a function does whatever it is asked: "constant", "echo", or "" if neither."""
    expected = [case.expected for case in cases]
    if len(cases) < 2 or all(form.alike(one, expected[0]) for one in expected[1:]):
        return ""
    if all(form.alike(one, outcomes[0]) for one in outcomes[1:]):
        return "constant"
    count = min(len(case.args or ()) for case in cases)
    for place in range(count):
        if all(form.alike(out, case.args[place]) for out, case in zip(outcomes, cases, strict=True)):
            return "echo"
    return ""


def _differ(form: Form, values: Iterable[Plain], place: int) -> bool:
    """Return whether two of these values have different probes at `place`."""
    return any(not form.judge(one, other)[place] for one, other in combinations(values, 2))
