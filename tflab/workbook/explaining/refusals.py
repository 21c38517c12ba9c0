"""Was an error swallowed?  Where an exception is asked for, and something comes back instead.

    asked for   2.0   ExtrapolationException      returned   2.0   None             an `except` that says nothing
                                                  returned   2.0   (0.0, 0.0)       the same each time: no answer
                                                  returned   2.0   the exception    `return`, and not `raise`
                                                  raised     2.0   ValueError       another one than is asked for

What else is wrong is explained beside it.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...text import Texts
from ..answers.values import Plain, is_raised
from ..mistakes.fitting import alike
from ..tasks.case_types import Case, TaskCases
from .explanation import Explains, Explanation, and_then

__all__ = ["of_refusals"]

TEXTS = Texts(__file__)


def of_refusals(
    task: TaskCases,
    cases: Sequence[Case],
    outcomes: Sequence[Plain],
    explained: Explains,
) -> Explanation | None:
    """Return what became of the exceptions that a function has to raise, and of the rest what `explained` says."""
    pairs = list(zip(cases, outcomes, strict=True))
    refused = [outcome for case, outcome in pairs if is_raised(case.expected)]
    rest = [(case, outcome) for case, outcome in pairs if not is_raised(case.expected)]
    is_another = _are_others(task, pairs)
    if not refused or not rest or (any(map(is_raised, refused)) and not is_another):
        return None
    slip = _another(refused) if is_another else _swallowed(refused)
    if all(alike(task.form, outcome, case.expected) for case, outcome in rest):  # the verdict says the rest by itself
        return slip if not is_another and slip.said is not TEXTS["something"] else None
    first = explained(task, *zip(*rest, strict=True))
    return and_then(first, slip) if first else None


def _swallowed(refused: Sequence[Plain]) -> Explanation:
    if all(outcome is None for outcome in refused):
        return Explanation.of("error swallowed", TEXTS["nothing"])
    if all(isinstance(one, dict) and "returned and not raised" in str(one.get("object")) for one in refused):
        return Explanation.of("exception returned", TEXTS["returned"])
    if len(refused) > 1 and all(outcome == refused[0] for outcome in refused):
        return Explanation.of("error swallowed", TEXTS["the_same"])
    return Explanation.of("no refusal", TEXTS["something"])


def _are_others(task: TaskCases, pairs: Sequence[tuple[Case, Plain]]) -> bool:
    """Return whether an exception is raised wherever one is asked for, and never that one."""
    refused = [(case, outcome) for case, outcome in pairs if is_raised(case.expected)]
    return all(is_raised(outcome) and not alike(task.form, outcome, case.expected) for case, outcome in refused)


def _another(refused: Sequence[Plain]) -> Explanation:
    errors = " / ".join(sorted({str(outcome["raises"]) for outcome in refused if isinstance(outcome, dict)}))
    return Explanation.of("another exception", TEXTS["another"].filled(error=errors))
