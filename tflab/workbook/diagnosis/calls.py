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
from ..tasks.case_types import Case, TaskCases
from .explanation import Explains, Explanation, and_then, said_of
from .matching import ANY_BUG, alike, all_alike, is_just, words_of
from .python_errors import tip_for

__all__ = ["gave", "of_changes", "of_refusals", "of_stops", "of_words_apart", "side_by_side"]

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


OF_TF2 = {"ConnectivityException", "ExtrapolationException", "InvalidArgumentException", "LookupException"}
BUGS = ANY_BUG | {"AssertionError", "ZeroDivisionError"}
FEWEST = 3  # calls that have to go on, for what is wrong in them to be no chance


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
    if not stopped:
        return None
    is_rest_right = all(alike(task.form, outcome, case.expected) for case, outcome in rest)
    first = None if is_rest_right else explained(task, *zip(*rest, strict=True))  # any slip fits that shows in none
    if (uncaught := _uncaught(task, pairs, stopped)) is not None:
        return and_then(first, uncaught) if first else uncaught
    if first is None or len(rest) < FEWEST or stopped[0]["raises"] not in BUGS:
        return None
    error, tip = stopped[0]["raises"], tip_for(stopped[0]["raises"], stopped[0].get("text", ""))
    filled = {"stopped": len(stopped), "of": len(pairs), "error": error}
    said = Text(*map(str.rstrip, TEXTS["stops"].filled(**filled, tip=tip)))
    return and_then(first, Explanation.of(f"stops: {error}", said))


def _uncaught(task: TaskCases, pairs: Sequence[tuple[Case, Plain]], stopped: Sequence[Plain]) -> Explanation | None:
    """Return that tf2's own exceptions go through a function which is to put each of them into a word."""
    errors = sorted({str(outcome["raises"]) for outcome in stopped})
    is_of_words = isinstance(task.form, Choice) and not any(is_raised(case.expected) for case, _ in pairs)
    if not errors or not is_of_words or not all(error in OF_TF2 for error in errors):
        return None
    names = ", ".join(errors)
    return Explanation.of("uncaught", TEXTS["uncaught"].filled(stopped=len(stopped), of=len(pairs), errors=names))


MOST = 3  # that are looked for


def side_by_side(
    form: Form, outcomes: Sequence[Plain], expected: Sequence[Plain], gives: dict[str, list[Plain]]
) -> Iterator[tuple[str, ...]]:
    """Yield two or three slips of which each shows alone in some call, and that give together what came out.

    Args:
        gives: what each slip gives, call by call.
    """
    wrong = _calls(not alike(form, *pair) for pair in zip(outcomes, expected, strict=True))
    shown = partial(_shown, form.comparing(), expected)
    shows = {name: shown(row) for name, row in gives.items()}
    within = [name for name, seen in shows.items() if seen and not seen & ~wrong]
    for chosen in (slips for count in range(2, MOST + 1) for slips in combinations(within, count)):
        if _covers(shows, chosen, wrong) and _fit(form, outcomes, gives, shows, chosen):
            yield chosen


def _calls(marks: Iterator[bool]) -> int:
    """Return the calls that are marked, as the bits of a number."""
    return sum(1 << number for number, mark in enumerate(marks) if mark)


def _shown(is_alike: Callable[[Plain, Plain], bool], expected: Sequence[Plain], row: Sequence[Plain]) -> int:
    """Return the calls in which what a slip gives is not what is right."""
    return _calls(not is_alike(*pair) for pair in zip(row, expected, strict=True))


def _covers(shows: dict[str, int], chosen: tuple[str, ...], wrong: int) -> bool:
    """Return whether the slips show in just the calls that are wrong, and each alone in one of them."""
    seen = once = 0
    for name in chosen:
        once = (once & ~shows[name]) | (shows[name] & ~seen)
        seen |= shows[name]
    return seen == wrong and all(shows[name] & once for name in chosen)


def _fit(
    form: Form, outcomes: Sequence[Plain], gives: dict[str, list[Plain]], shows: dict[str, int], chosen: Sequence[str]
) -> bool:
    """Return whether each call that is wrong gives what one of the slips gives that show in it."""
    for number, outcome in enumerate(outcomes):
        seen = [name for name in chosen if shows[name] >> number & 1]
        if seen and not any(is_just(form, [outcome], [gives[name][number]]) for name in seen):
            return False
    return True


class _Word(NamedTuple):
    """One word: what was said, what is asked for, and what each mistake gives."""

    said: Plain
    wanted: Plain
    wrong: dict[str, Plain]


def of_words_apart(task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain]) -> Explanation | None:
    """Return which slips give the words in a function's lists; None if no few of them do."""
    places = _places(cases, outcomes) if isinstance(task.form, ListForm) else []
    if not places or not isinstance(task.form.of, Choice):
        return None
    sure, is_all = _sure(task.form.of, places)
    if not sure:
        return None
    told, slips = said_of(task, sure), {name: words_of(task, name) for name in sure}
    return Explanation(slips, told if is_all else Text.joined(told, TEXTS["and_more"]))


def _sure(form: Choice, places: Sequence[_Word]) -> tuple[list[str], bool]:
    """Return the slips that all the simplest explanations have in common, and whether there is but one."""
    gives = {name: [place.wrong[name] for place in places] for name in places[0].wrong}
    found = list(side_by_side(form, [place.said for place in places], [place.wanted for place in places], gives))
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
