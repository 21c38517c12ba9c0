"""How did this wrong answer come about?  The simplest slips that give just it: one, or two, in the order of the work.

    answer --> one slip of the task?  one that any answer can have?  two slips?  a slip, and then a universal one?
           --> what was given?  a slip in some calls, not in all?  words that are confused?
    parts  --> each by itself (members.py)

Pairs of slips are searched for, and only where nothing simpler gives the answer
(`tasks/pairs.py`).  The field calls this a *bug library* whose bugs compose (BUGGY,
DEBUGGY), searched by model tracing.
A name is given only where the whole of the answer, or of a part, is what that slip
gives.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...text import Text, Texts, begun
from ..answers.form import numbers_of
from ..answers.forms import Angle, Choice, Command, Form, Message, Number, Parts, Pose, Urdf, Vector
from ..answers.forms import Sequence as ListForm
from ..answers.values import Plain, is_raised
from ..tasks.case_types import AND, Case, TaskCases
from ..tasks.credit import habit
from .calls import gave, of_changes, of_refusals, of_stops, of_words_apart, side_by_side
from .coding_patterns import given_to, habit_of
from .explanation import Explanation, said_of
from .generic import of_names, unfilled
from .links import of_robots
from .lookup_time import of_requests
from .matching import MEASURED, ONE, TWO, alike, all_alike, in_some, is_just, sections, undone_to, words_of
from .options import confused, confused_in_lists, seen_of, word_of
from .parts import changed_places, of_lists, of_members, plain_in_one
from .precision import TOLD, by_comparison
from .vector_terms import put_together
from .wrong_types import of_times

__all__ = ["explained"]

TEXTS = Texts(__file__)

FEWEST_DIGITS = 3  # of a number for two slips that are near to it to be no chance
A_HAIR = 1e-6  # how far, at most, a number that was not rounded is from what gives it


def explained(
    task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], given: dict[str, Plain] | None = None
) -> Explanation | None:
    """Return how an answer came about, or None if nothing that is known gives it.

    Args:
        given: what the learner was shown, where that varies.
    """
    if isinstance(task.form, Parts) and not task.is_function:
        return _of_parts(task, cases, outcomes, given)
    if words := unfilled(task.form, outcomes):
        return Explanation.of("nothing filled in", words)
    if found := _of_moments(task, cases, outcomes, given):
        return found
    if task.is_function and any(gave(outcome) is not outcome for outcome in outcomes):
        return of_changes(task, cases, outcomes, explained)
    names = next(_ways(task, cases, outcomes, given), None)
    if not _is_simple(names) and (found := _more_simply(task, cases, outcomes, given)):
        return found
    if names:
        return _by_name(task, cases, outcomes, names)
    if task.is_function and habit(task.form, cases, outcomes):  # a constant, or what came in: that says it all
        return None
    return (
        of_stops(task, cases, outcomes, explained)
        or of_refusals(task, cases, outcomes, explained)
        or _of_the_form(task, cases, outcomes, given)
    )


def _of_moments(
    task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], given: dict[str, Plain] | None
) -> Explanation | None:
    """Return that a time stands where a number is asked for, or for which moment a buffer was asked that refuses."""
    return of_times(task, cases, outcomes, lambda *rest: explained(*rest, given)) or of_requests(cases, outcomes)


def _of_parts(
    task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], given: dict[str, Plain] | None
) -> Explanation | None:
    """Return how a value of several parts came about: several slips only where nothing simpler is to be seen."""
    found = of_members(task, cases, outcomes, given)
    if found is None or len(found.slips) < 2:
        return found
    if simpler := plain_in_one(task, cases, outcomes):
        return simpler
    pair = next(_two(task, cases, outcomes, given, ONE), None) if len(found.slips) > 2 else None
    return _by_name(task, cases, outcomes, pair) if pair else found


def _is_simple(names: tuple[str, ...] | None) -> bool:
    """Return whether this is one mistake, and says more than that places, or places and signs, are others."""
    return names is not None and len(names) == 1 and not names[0].startswith(("places and signs", "exchanged"))


def _more_simply(
    task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], given: dict[str, Plain] | None
) -> Explanation | None:
    """Return what is more certain than two slips that meet: two parts exchanged, a sign, numbers in other places."""
    found = changed_places(task, cases, outcomes, given) or plain_in_one(task, cases, outcomes)
    put = None if found or task.is_function else put_together(task.form, outcomes[0], cases[0].expected, given)
    return Explanation.of(*put) if put else found


def _by_name(task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], names: tuple[str, ...]) -> Explanation:
    """Return what is said of slips that give an answer; a habit says more than that a list is too long."""
    if (
        [name.partition(TOLD)[0] for name in names] == ["members too many"]
        and task.is_function
        and (found := _of_a_habit(task, cases, outcomes))
    ):
        return found
    slips = {name.partition(TOLD)[0]: words_of(task, name) for name in names}
    said = said_of(task, names)
    if len(names) == 1 and _is_only_near(task, cases, outcomes, names[0]):
        said = TEXTS["only_near"].filled(said=Text(begun(said.en), said.ko))
    return Explanation(slips, said)


def _is_only_near(task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], name: str) -> bool:
    """Return whether a number is what a slip of the task gives to some digits alone: two others may come to it, too."""
    if task.is_function or name not in cases[0].wrong or not isinstance(task.form, Number | Angle | Vector):
        return False
    return not is_just(task.form, outcomes, [cases[0].wrong[name]], A_HAIR)


def _of_the_form(
    task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], given: dict[str, Plain] | None
) -> Explanation | None:
    """Return what explains an answer of this form: its members, the words that it confuses, how it was computed."""
    is_split = isinstance(task.form, Command | Pose) and sections(task.form, outcomes[0])
    if isinstance(task.form, Parts | Message) or is_split:
        return of_members(task, cases, outcomes, given)
    if isinstance(task.form, Urdf):
        return of_robots(task, outcomes[0], cases[0].expected)
    if task.is_function:
        return _of_calls(task, cases, outcomes)
    return of_lists(task, cases, outcomes)


def _of_calls(task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain]) -> Explanation | None:
    """Return what all calls together show: a habit, what the members of lists have wrong, words that are confused."""
    found = _of_a_habit(task, cases, outcomes) or of_lists(task, cases, outcomes) or _of_words(task, cases, outcomes)
    words = None if found else of_names(task.form, outcomes, [case.expected for case in cases])
    return Explanation.of("names", words) if words else found


def _of_a_habit(task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain]) -> Explanation | None:
    found = habit_of(task.form, [case.args or [] for case in cases], outcomes, [case.expected for case in cases])
    return Explanation.of(*found) if found else None


def _of_words(task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain]) -> Explanation | None:
    """Return which words a function confuses, alone or in the lists that it gives, and in which calls."""
    wanted, form = [case.expected for case in cases], task.form
    if not isinstance(form, Choice | ListForm):
        return None
    found = confused(form, outcomes, wanted) if isinstance(form, Choice) else confused_in_lists(form, outcomes, wanted)
    if found is None or not found.word:
        return Explanation.of(found.name, found.said) if found else None
    if (apart := of_words_apart(task, cases, outcomes)) is not None:
        return apart
    explanation = Explanation.of(
        found.name, Text.joined(found.said, task.means.get(found.word), seen_of(found, task.seen))
    )
    if isinstance(form, Choice):
        pairs = [(word_of(form, want), word_of(form, outcome)) for want, outcome in zip(wanted, outcomes, strict=True)]
        explanation = explanation._replace(shows=pairs.index((found.wanted, found.word)))
    return explanation


def _ways(
    task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], given: dict[str, Plain] | None
) -> Iterator[tuple[str, ...]]:
    """Yield the combinations that give these outcomes, the simplest first."""
    form, expected = task.form, [case.expected for case in cases]
    single = {name: [case.wrong.get(name) for case in cases] for name in cases[0].wrong}
    yield from _ones(task, cases, outcomes, single, given)
    yield from ((name,) for name in undone_to(form, outcomes, expected, only_plain_to_see=True))
    if task.is_function and habit(form, cases, outcomes):
        return
    if not task.is_function and (held := given_to(form, outcomes[0], expected[0], given)):
        yield (f"given {held}",)
    if not _is_short(task, outcomes, expected):
        yield from _two(task, cases, outcomes, given, TWO)
    if task.is_function and not isinstance(getattr(form, "of", form), Choice):  # words fit by chance: see apart.py
        yield from side_by_side(form, outcomes, expected, single)
    yield from _further_ways(task, single, outcomes, expected)


def _is_short(task: TaskCases, outcomes: Sequence[Plain], expected: Sequence[Plain]) -> bool:
    """Return whether a value is a number of few digits, or the right one rounded: two slips fit it by chance."""
    row = numbers_of(outcomes[0], None) if isinstance(task.form, Number) and not task.is_function else None
    if row is None:
        return False
    digits = len(f"{abs(row[0]):.9f}".replace(".", "").strip("0"))
    return digits < FEWEST_DIGITS or "rounded" in by_comparison(task.form, list(outcomes), list(expected))


def _ones(
    task: TaskCases,
    cases: Sequence[Case],
    outcomes: Sequence[Plain],
    single: dict[str, list[Plain]],
    given: dict[str, Plain] | None,
) -> Iterator[tuple[str, ...]]:
    """Yield the single slips that give a number; before one that it is only near to, the two that give it to a hair."""
    ones = list(_just(task.form, outcomes, single, ONE))
    is_number = not task.is_function and isinstance(task.form, MEASURED)
    if ones and is_number and not any(_just(task.form, outcomes, single, A_HAIR)):
        yield from _two(task, cases, outcomes, given, A_HAIR)
    yield from ones


def _two(
    task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], given: dict[str, Plain] | None, share: float
) -> Iterator[tuple[str, ...]]:
    """Yield the pairs of slips that give just these outcomes; they are searched for."""
    if task.pairs is None:
        return
    is_right = [alike(task.form, outcome, case.expected) for case, outcome in zip(cases, outcomes, strict=True)]
    found = task.pairs.fitting(
        cases,
        sorted(range(len(cases)), key=is_right.__getitem__),
        lambda number, value: ["whole"] * is_just(task.form, [outcomes[number]], [value], share),
        given,
    )
    yield from (tuple(name.split(AND)) for name in found)


def _just(
    form: Form, outcomes: Sequence[Plain], gives: dict[str, list[Plain]], share: float
) -> Iterator[tuple[str, ...]]:
    """Yield the names of those that give just these outcomes."""
    yield from ((name,) for name, row in gives.items() if is_just(form, outcomes, row, share))


def _further_ways(
    task: TaskCases, single: dict[str, list[Plain]], outcomes: Sequence[Plain], expected: Sequence[Plain]
) -> Iterator[tuple[str, ...]]:
    """Yield a slip and then a universal one, universal ones that are harder to see, and what shows in some calls."""
    for first, row in single.items():
        yield from ((first, then) for then in undone_to(task.form, outcomes, row, only_plain_to_see=True))
    yield from ((name,) for name in undone_to(task.form, outcomes, expected))
    if task.is_function and isinstance(task.form, MEASURED):
        answered = [row for row in zip(outcomes, expected, strict=True) if not is_raised(row[1])]
        if len(answered) > 1 and not any(alike(task.form, *row) for row in answered):
            yield from ((name,) for name, row in single.items() if _is_all_that_is_wrong(task, outcomes, expected, row))
        yield from ((name,) for name in in_some(task.form, outcomes, expected))


def _is_all_that_is_wrong(
    task: TaskCases, outcomes: Sequence[Plain], expected: Sequence[Plain], twin: Sequence[Plain]
) -> bool:
    """Return whether all that is wrong is what a slip gives, though the slip would give more."""
    wrong = [
        place
        for place, (outcome, want) in enumerate(zip(outcomes, expected, strict=True))
        if not all_alike(task.form, [outcome], [want])
    ]
    if any(is_raised(twin[place]) or is_raised(outcomes[place]) or twin[place] is None for place in wrong):
        return False
    return all_alike(task.form, [outcomes[place] for place in wrong], [twin[place] for place in wrong])
