"""Did a function change what it was given?  That is said, and what else is wrong with what it gave.

    def later(message):                       the caller's own message has another stamp now
        message.header.stamp = now            -> and what came of that stamp is explained as ever
        return buffer.transform(message, "map")

The field calls it a side effect.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...text import Texts
from ..answers.values import Plain
from ..mistakes.fitting import all_alike
from ..tasks.case_types import Case, TaskCases
from .explanation import Explains, Explanation, and_then

__all__ = ["gave", "of_changes"]

TEXTS = Texts(__file__)


def gave(outcome: Plain) -> Plain:
    """Return what a function gave, whether or not it changed an argument."""
    return outcome["gave"] if isinstance(outcome, dict) and "gave" in outcome else outcome


def of_changes(
    task: TaskCases,
    cases: Sequence[Case],
    outcomes: Sequence[Plain],
    explained: Explains,
) -> Explanation | None:
    """Return what `explained` says of the results, and that an argument was changed; None if it says nothing."""
    numbers = [outcome["changed"] for outcome in outcomes if isinstance(outcome, dict) and "changed" in outcome]
    results = [gave(outcome) for outcome in outcomes]
    if not numbers or all_alike(task.form, results, [case.expected for case in cases]):
        return None
    first = explained(task, cases, results)
    if first is None:
        return None
    said = TEXTS["changed"].filled(number=numbers[0])
    return and_then(first, Explanation.of("input changed", said))
