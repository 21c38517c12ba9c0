"""Explain what a function does in some of its calls: raise, swallow an exception, change an argument."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import combinations
from typing import NamedTuple

from ...text import Text, Texts
from ..answers.form import Form, inside
from ..answers.forms import Choice
from ..answers.forms import Sequence as ListForm
from ..answers.values import Plain, is_raised
from ..tasks.case_types import Case
from .explanation import Explanation, describe
from .matching import ANY_BUG, alike, all_alike, feedback_of, matches_closely
from .python_errors import tip_for
from .question import Question, Rest

__all__ = [
    "explain_changed_arguments",
    "explain_options_one_by_one",
    "explain_raises",
    "explain_swallowed_exceptions",
    "mistakes_by_call",
    "return_value",
]  # fmt: skip

TEXTS = Texts(__file__)


def return_value(outcome: Plain) -> Plain:
    """Return what a function return_value, whether or not it changed an argument."""
    return outcome["gave"] if isinstance(outcome, dict) and "gave" in outcome else outcome


def explain_changed_arguments(question: Question) -> Rest | None:
    """Return that an argument was changed, and the results to explain; None if these are right."""
    number = next(outcome["changed"] for outcome in question.outcomes if return_value(outcome) is not outcome)
    rest = question.with_outcomes([return_value(outcome) for outcome in question.outcomes])
    if all_alike(rest.form, rest.outcomes, rest.expected):
        return None
    return Rest(Explanation.of("input changed", TEXTS["changed"].filled(number=number)), rest)


def explain_swallowed_exceptions(question: Question) -> Rest | None:
    """Return what became of the exceptions that a function has to raise, and the other calls to explain."""
    raises = question.calls_that_raise()
    refused, rest = question.calls(raises), question.calls(not each for each in raises)
    is_another = all(map(is_raised, refused.outcomes)) and not any(refused.is_right)
    if not refused.cases or not rest.cases or (any(map(is_raised, refused.outcomes)) and not is_another):
        return None
    found = _another(refused.outcomes) if is_another else _swallowed(refused.outcomes)
    if not all(rest.is_right):
        return Rest(found, rest)
    is_said_by_the_verdict = is_another or found.said is TEXTS["something"]
    return None if is_said_by_the_verdict else Rest(found, None, is_enough=True)


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


def explain_raises(question: Question) -> Rest | None:
    """Return that some calls raise where an answer is expected, and the other calls to explain."""
    pairs = list(zip(question.outcomes, question.calls_that_raise(), strict=True))
    goes_on = [not is_raised(outcome) or is_expected for outcome, is_expected in pairs]
    rest, stopped = question.calls(goes_on), question.calls(not goes for goes in goes_on)
    if not stopped.cases:
        return None
    left = None if all(rest.is_right) else rest  # any mistake fits that shows in none of them
    if (uncaught := _uncaught(question, stopped.outcomes)) is not None:
        return Rest(uncaught, left, is_enough=True)
    error, text = stopped.outcomes[0]["raises"], stopped.outcomes[0].get("text", "")
    if left is None or len(rest.cases) < FEWEST or error not in BUGS:
        return None
    counts = {"stopped": len(stopped.cases), "of": len(question.cases), "error": error}
    said = Text(*map(str.rstrip, TEXTS["stops"].filled(**counts, tip=tip_for(error, text))))
    return Rest(Explanation.of(f"stops: {error}", said), left)


def _uncaught(question: Question, stopped: Sequence[Plain]) -> Explanation | None:
    """Return that tf2's own exceptions go through a function which has to return an option for each of them."""
    errors = sorted({str(outcome["raises"]) for outcome in stopped})
    is_of_options = isinstance(question.form, Choice) and not any(question.calls_that_raise())
    if not is_of_options or not OF_TF2.issuperset(errors):
        return None
    counts = {"stopped": len(stopped), "of": len(question.cases), "errors": ", ".join(errors)}
    return Explanation.of("uncaught", TEXTS["uncaught"].filled(**counts))


MOST = 3  # that are looked for


def mistakes_by_call(
    form: Form, outcomes: Sequence[Plain], expected: Sequence[Plain], gives: dict[str, list[Plain]]
) -> Iterator[tuple[str, ...]]:
    """Yield two or three mistakes of which each shows alone in some call, and that give together what came out.

    Args:
        gives: what each mistake gives, call by call.
    """
    wrong = _calls(not alike(form, *pair) for pair in zip(outcomes, expected, strict=True))
    shown = partial(_shown, form.comparing(), expected)
    shows = {name: shown(row) for name, row in gives.items()}
    within = [name for name, seen in shows.items() if seen and not seen & ~wrong]
    for chosen in (mistakes for count in range(2, MOST + 1) for mistakes in combinations(within, count)):
        if _covers(shows, chosen, wrong) and _fit(form, outcomes, gives, shows, chosen):
            yield chosen


def _calls(marks: Iterator[bool]) -> int:
    """Return the calls that are marked, as the bits of a number."""
    return sum(1 << number for number, mark in enumerate(marks) if mark)


def _shown(is_alike: Callable[[Plain, Plain], bool], expected: Sequence[Plain], row: Sequence[Plain]) -> int:
    """Return the calls in which what a mistake gives is not what is right."""
    return _calls(not is_alike(*pair) for pair in zip(row, expected, strict=True))


def _covers(shows: dict[str, int], chosen: tuple[str, ...], wrong: int) -> bool:
    """Return whether the mistakes show in just the calls that are wrong, and each alone in one of them."""
    seen = once = 0
    for name in chosen:
        once = (once & ~shows[name]) | (shows[name] & ~seen)
        seen |= shows[name]
    return seen == wrong and all(shows[name] & once for name in chosen)


def _fit(
    form: Form, outcomes: Sequence[Plain], gives: dict[str, list[Plain]], shows: dict[str, int], chosen: Sequence[str]
) -> bool:
    """Return whether each call that is wrong gives what one of the mistakes gives that show in it."""
    for number, outcome in enumerate(outcomes):
        seen = [name for name in chosen if shows[name] >> number & 1]
        if seen and not any(matches_closely(form, [outcome], [gives[name][number]]) for name in seen):
            return False
    return True


class _Word(NamedTuple):
    """One word: what was said, what is asked for, and what each mistake gives."""

    said: Plain
    wanted: Plain
    wrong: dict[str, Plain]


def explain_options_one_by_one(question: Question) -> Explanation | None:
    """Return which mistakes give the words in a function's lists; None if no few of them do."""
    task, form = question.task, question.form
    places = _places(question.cases, question.outcomes) if isinstance(form, ListForm) else []
    if not places or not isinstance(form.of, Choice):
        return None
    sure, is_all = _sure(form.of, places)
    if not sure:
        return None
    told, mistakes = describe(task, sure), {name: feedback_of(task, name) for name in sure}
    return Explanation(mistakes, told if is_all else Text.joined(told, TEXTS["and_more"]))


def _sure(form: Choice, places: Sequence[_Word]) -> tuple[list[str], bool]:
    """Return the mistakes that all the simplest explanations have in common, and whether there is but one."""
    gives = {name: [place.wrong[name] for place in places] for name in places[0].wrong}
    found = list(mistakes_by_call(form, [place.said for place in places], [place.wanted for place in places], gives))
    ways = [way for way in found if len(way) == len(found[0])]
    return [name for name in (ways or [()])[0] if all(name in way for way in ways)], len(ways) == 1


def _places(cases: Sequence[Case], outcomes: Sequence[Plain]) -> list[_Word]:
    """Return each word on its own; nothing if lists differ in length, or something is no answer."""
    if any(is_raised(case.expected) for case in cases):
        return []
    found = []
    for case, outcome in zip(cases, outcomes, strict=True):
        said, wanted = inside(outcome), inside(case.expected)
        wrong = {name: inside(answer) for name, answer in case.wrong.items()}
        if not all(isinstance(held, list) and len(held) == len(wanted) for held in (said, *wrong.values())):
            return []
        found += [_Word(said[place], wanted[place], {name: answer[place] for name, answer in wrong.items()})
                  for place in range(len(wanted))]  # fmt: skip
    return found
