"""Explain what a function does in some of its calls: raise, swallow an exception, change an argument."""

from __future__ import annotations

from collections.abc import Sequence

from ...text import Text, Texts
from ..answers.forms import Choice
from ..answers.values import Plain, is_raised
from .explanation import Explanation
from .matching import ANY_BUG, all_alike
from .python_errors import python_error_hint
from .question import PartialExplanation, Question

__all__ = [
    "changes_an_argument",
    "explain_changed_arguments",
    "explain_raises",
    "explain_swallowed_exceptions",
    "return_value",
]  # fmt: skip

TEXTS = Texts(__file__)


def return_value(outcome: Plain) -> Plain:
    """Return what a function returned, whether or not it changed an argument."""
    return outcome["gave"] if isinstance(outcome, dict) and "gave" in outcome else outcome


def changes_an_argument(question: Question) -> bool:
    """Return whether some call changed one of its arguments."""
    return any(return_value(outcome) is not outcome for outcome in question.outcomes)


def explain_changed_arguments(question: Question) -> PartialExplanation | None:
    """Return that an argument was changed, and the results to explain; None if these are right."""
    number = next(outcome["changed"] for outcome in question.outcomes if return_value(outcome) is not outcome)
    rest = question.with_outcomes([return_value(outcome) for outcome in question.outcomes])
    if all_alike(rest.form, rest.outcomes, rest.expected):
        return None
    return PartialExplanation(Explanation.of("input changed", TEXTS["changed"].filled(number=number)), rest)


def explain_swallowed_exceptions(question: Question) -> PartialExplanation | None:
    """Return what became of the exceptions that a function has to raise, and the other calls to explain."""
    raises = question.calls_that_raise()
    refused, rest = question.calls(raises), question.calls(not each for each in raises)
    is_another = all(map(is_raised, refused.outcomes)) and not any(refused.is_right)
    if not refused.cases or not rest.cases or (any(map(is_raised, refused.outcomes)) and not is_another):
        return None
    found = _another(refused.outcomes) if is_another else _swallowed(refused.outcomes)
    if not all(rest.is_right):
        return PartialExplanation(found, rest)
    is_said_by_the_verdict = is_another or found.said is TEXTS["something"]
    return None if is_said_by_the_verdict else PartialExplanation(found, None, is_enough=True)


def _swallowed(refused: Sequence[Plain]) -> Explanation:
    if all(outcome is None for outcome in refused):
        return Explanation.of("error swallowed", TEXTS["nothing"])
    if all(isinstance(one, dict) and "returned and not raised" in str(one.get("object")) for one in refused):
        return Explanation.of("exception returned", TEXTS["returned"])
    if len(refused) > 1 and all(outcome == refused[0] for outcome in refused):
        return Explanation.of("error swallowed", TEXTS["the_same"])
    return Explanation.of("no refusal", TEXTS["something"])


def _another(refused: Sequence[Plain]) -> Explanation:
    errors = " / ".join(sorted({str(outcome["raises"]) for outcome in refused if isinstance(outcome, dict)}))
    return Explanation.of("another exception", TEXTS["another"].filled(error=errors))


OF_TF2 = {"ConnectivityException", "ExtrapolationException", "InvalidArgumentException", "LookupException"}
BUGS = ANY_BUG | {"AssertionError", "ZeroDivisionError"}
FEWEST = 3  # calls that have to go on, for what is wrong in them to be no chance


def explain_raises(question: Question) -> PartialExplanation | None:
    """Return that some calls raise where an answer is expected, and the other calls to explain."""
    pairs = list(zip(question.outcomes, question.calls_that_raise(), strict=True))
    goes_on = [not is_raised(outcome) or is_expected for outcome, is_expected in pairs]
    rest, stopped = question.calls(goes_on), question.calls(not goes for goes in goes_on)
    if not stopped.cases:
        return None
    left = None if all(rest.is_right) else rest  # any mistake fits that shows in none of them
    if (uncaught := _uncaught(question, stopped.outcomes)) is not None:
        return PartialExplanation(uncaught, left, is_enough=True)
    error, text = stopped.outcomes[0]["raises"], stopped.outcomes[0].get("text", "")
    if left is None or len(rest.cases) < FEWEST or error not in BUGS:
        return None
    counts = {"stopped": len(stopped.cases), "of": len(question.cases), "error": error}
    said = Text(*map(str.rstrip, TEXTS["stops"].filled(**counts, tip=python_error_hint(error, text))))
    return PartialExplanation(Explanation.of(f"stops: {error}", said), left)


def _uncaught(question: Question, stopped: Sequence[Plain]) -> Explanation | None:
    """Return that tf2's own exceptions go through a function which has to return an option for each of them."""
    errors = sorted({str(outcome["raises"]) for outcome in stopped})
    is_of_options = isinstance(question.form, Choice) and not any(question.calls_that_raise())
    if not is_of_options or not OF_TF2.issuperset(errors):
        return None
    counts = {"stopped": len(stopped), "of": len(question.cases), "errors": ", ".join(errors)}
    return Explanation.of("uncaught", TEXTS["uncaught"].filled(**counts))
