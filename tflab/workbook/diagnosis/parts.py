"""Explain the wrong parts of an answer, each part of a dict and each field of a message by itself.

    {"base_link": right, "map": wrong}     a mistake of the task that shows in "map" alone
                                           a mistake that any answer can have, in that part
                                           the answer of another part, or what was given

A value has one case, a function several: a part is explained where it is in all of
them.  What only follows from an earlier mistake costs nothing: *error carried forward*.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from ...text import Text, Texts
from ..answers.form import Form, inside
from ..answers.forms import Choice, Message, Parts
from ..answers.forms import Sequence as ListForm
from ..answers.structures import named_beside
from ..answers.values import Plain, is_raised
from ..tasks.case_types import Case, Feedback, TaskCases
from .coding_patterns import constant_of, find_coding_pattern, find_input
from .explanation import Explanation, PartFound, describe, merge_found, without_overlaps
from .generic import TOLD
from .matching import (
    alike,
    all_alike,
    expand_lists,
    feedback_of,
    in_some,
    matches_closely,
    matching_corrections,
)
from .options import confused, explain_orders, seen_of, word_of
from .part_mistakes import Table, consequence_of, followers, is_something, mistakes_in_parts, only_follows
from .precision import stamp_of, time_of
from .question import Question
from .wrong_types import describe_types

__all__ = ["explain_exchanged_parts", "explain_list_members", "explain_obvious_part", "explain_parts"]

TEXTS = Texts(__file__)


def explain_parts(question: Question) -> Explanation | None:
    """Return how the wrong parts of an answer came about, or None if nothing explains any of them."""
    task, form, given = question.task, question.form, dict(question.inputs)
    every = list(zip(question.cases, question.outcomes, strict=True))
    if not all(alike(form, outcome, case.expected) for case, outcome in every if is_raised(case.expected)):
        return None
    asked = [pair for pair in every if not is_raised(pair[0].expected)]
    stopped, going = ([pair for pair in asked if is_raised(pair[1]) is stops] for stops in (True, False))
    if not going or len(going) < len(stopped) or any(form.read(outcome) is None for _, outcome in going):
        return None
    of_going, came = map(list, zip(*going, strict=True))
    return _beside_stops(task, stopped, of_going, came) if stopped else _explain_table(task, of_going, came, given)


def _beside_stops(
    task: TaskCases, stopped: Sequence[tuple[Case, Plain]], going: Sequence[Case], outcomes: Sequence[Plain]
) -> Explanation | None:
    """Return which of the task's mistakes explains the calls that go on, if it stops in the others just as this did."""
    names = {name for name in going[0].wrong if all(alike(task.form, was, case.wrong[name]) for case, was in stopped)}
    only = [case._replace(wrong={name: case.wrong[name] for name in case.wrong if name in names}) for case in going]
    found = _explain_table(task._replace(pairs=None), only, outcomes, None) if names else None
    return found if found and found.mistakes.keys() <= task.feedback.keys() else None


def _explain_table(
    task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], given: dict[str, Plain] | None
) -> Explanation | None:
    """Return the same where each case asks for a value, and each outcome can be read."""
    table = _table(task.form, cases, outcomes)
    names, wrong = list(table.forms), set(_wrong_in(table))
    several, follow = _explain_several_and_what_follows(task, table, cases, wrong, given)
    wrong -= follow.keys()
    found = without_overlaps(several, wrong)
    left = wrong.difference(*(cause.parts for cause in found))
    for name in names:
        if name in left:
            found += (
                _by_itself(task, table, name, given, cases[0].wrong, wrong - left)
                or _as_it_came(task.form, table, name, cases)
                or _after_a_mistake(task, table, name, cases, found)
                or _mistake_and_then(task, table, name, cases)
            )
    left -= {name for cause in found for name in cause.parts}
    found += [only_follows(*pair) for pair in follow.items()] if found else []
    return merge_found(found, {name: _certain(table, name) for name in names if name in left}, names) if found else None


def _explain_several_and_what_follows(
    task: TaskCases, table: Table, cases: Sequence[Case], wrong: set[str], given: dict[str, Plain] | None
) -> tuple[list[PartFound], dict[str, str]]:
    """Return what explains parts together, and beside it, unless one cause explains all, which parts only follow."""
    several = _explain_several(task, table, cases, wrong, given)
    is_of_all = any(wrong <= cause.parts for cause in several)
    follow = {} if is_of_all else followers(table.forms, table.given, table.wanted, wrong)
    return (_explain_several(task, table, cases, wrong - follow.keys(), given) if follow else several), follow


def _explain_several(
    task: TaskCases, table: Table, cases: Sequence[Case], wrong: set[str], given: dict[str, Plain] | None
) -> list[PartFound]:
    """Return what explains parts together: two that changed places, mistakes, an order."""
    mistakes = mistakes_in_parts(task, table, cases, wrong, given)
    pairs = [
        pair for pair in _changed_places(table, wrong) if not any(pair.parts <= mistake.parts for mistake in mistakes)
    ]
    rows = (table.forms, table.given, table.wanted)
    orders = explain_orders(*rows, task.means)
    is_one_mistake = any(wrong <= mistake.parts for mistake in mistakes)
    return [*pairs, *mistakes, *orders] if is_one_mistake else [*pairs, *orders, *mistakes]


def explain_exchanged_parts(question: Question) -> Explanation | None:
    """Return that two parts hold each other's answer, if that is all that is wrong."""
    if not isinstance(question.form, Parts) or any(question.calls_that_raise()):
        return None
    table = _table(question.form, question.cases, question.outcomes)
    names = list(table.forms)
    wrong = set(_wrong_in(table))
    found = next((pair for pair in _changed_places(table, wrong) if pair.parts == wrong), None)
    return merge_found([found], {}, names) if found else None


def explain_obvious_part(question: Question) -> Explanation | None:
    """Return what is plain to see in the only part that is wrong: no two mistakes have to meet for a sign alone."""
    task, cases, outcomes = question.task, question.cases, question.outcomes
    if not isinstance(task.form, Parts) or any(map(is_raised, (*outcomes, *(case.expected for case in cases)))):
        return None
    if any(task.form.read(outcome) is None for outcome in outcomes):
        return None
    table = _table(task.form, cases, outcomes)
    wrong = _wrong_in(table)
    if len(wrong) != 1:
        return None
    (name,) = wrong
    fix = next(
        matching_corrections(table.forms[name], table.given[name], table.wanted[name], only_plain_to_see=True), None
    )
    if fix is None:
        return None
    words = feedback_of(task, fix)
    found = PartFound({fix: words}, _shown_too(task, name, words.reply), {name})
    return merge_found([found], {}, list(table.forms))


def _table(form: Form, cases: Sequence[Case], outcomes: Sequence[Plain]) -> Table:
    forms = expand_lists(form, form.forms_of_parts(cases[0].expected), [*outcomes, *(case.expected for case in cases)])
    given = {name: [form.part_of(plain, name) for plain in outcomes] for name in forms}
    wanted = {name: [form.part_of(case.expected, name) for case in cases] for name in forms}
    return Table(forms, given, wanted, [case.args or [] for case in cases])


def _wrong_in(table: Table) -> list[str]:
    return [name for name, part in table.forms.items() if not all_alike(part, table.given[name], table.wanted[name])]


# -- what explains a part ------------------------------------------------------------------


def _changed_places(table: Table, wrong: set[str]) -> Iterator[PartFound]:
    """Yield two parts of which each holds the other's answer."""
    names = [name for name in table.forms if name in wrong and not isinstance(table.forms[name], Choice | ListForm)]
    for one, other in combinations(names, 2):
        is_alike = type(table.forms[one]) is type(table.forms[other])
        if is_alike and _holds(table, one, other) and _holds(table, other, one):
            key = f"{one} and {other} changed places"
            yield PartFound({key: Feedback(TEXTS["changed_places"], "")}, TEXTS["changed_places"], {one, other})


def _holds(table: Table, one: str, other: str) -> bool:
    return all_alike(table.forms[other], table.given[one], table.wanted[other])


def _by_itself(
    task: TaskCases,
    table: Table,
    name: str,
    given: dict[str, Plain] | None,
    wrong_answers: dict[str, Plain],
    known: set[str],
) -> list[PartFound]:
    """Return what explains one part alone: its option, what any answer can have, another's answer, what was given."""
    form, outcomes, wanted = table.forms[name], table.given[name], table.wanted[name]
    hint = _choice(task, name, form, outcomes[0], wanted[0]) if len(outcomes) == 1 else None
    if hint is not None and isinstance(form, Choice):
        hint = Text.joined(hint, form.remark(outcomes[0], {}))
        return [PartFound({f"{name}: {outcomes[0]}": Feedback(hint, "")}, hint, {name})]
    if found := _explain_kinds(table, name) or _remarked(table, name) or _explain_any(task, table, name):
        return found
    if len(outcomes) > 1:
        return _explain_words(task, table, name)
    found = _explain_the_given(task, name, form, outcomes[0], wanted[0], given) or _as_another_is(
        task, table, name, wrong_answers, known
    )
    return found or ([PartFound.of(f"{name}: another", hint, name)] if hint else [])


def _explain_kinds(table: Table, name: str) -> list[PartFound]:
    """Return whether what is no word at all stands where one is asked for, in some calls of a function."""
    said = describe_types(table.forms[name], table.given[name])[:2]
    texts = (". ".join(row) + "." for row in zip(*said, strict=True))
    return [PartFound.of(f"{name}: no word", Text(*texts), name)] if said else []


def _after_a_mistake(
    task: TaskCases, table: Table, name: str, cases: Sequence[Case], found: Sequence[PartFound]
) -> list[PartFound]:
    """Return what a part is beside the mistakes of the task that were found in others."""
    known = {part for cause in found for part in cause.parts} - {name}
    for mistake, part in ((mistake, words.part) for mistake, words in task.feedback.items() if words.part in known):
        rows = {one: [task.form.part_of(case.wrong[mistake], one) for case in cases] for one in (part, name)}
        more = consequence_of(task, name, table.forms[name], table.given[name], part, rows[name])
        if more and matches_closely(table.forms[part], table.given[part], rows[part]):
            return more
    return []


def _mistake_and_then(task: TaskCases, table: Table, name: str, cases: Sequence[Case]) -> list[PartFound]:
    """Return a mistake of the task and what is plain to see on top of it, if both give one part."""
    form = table.forms[name]
    for mistake in task.feedback if form.is_measured else ():
        row = [task.form.part_of(twin, name) for twin in (case.wrong.get(mistake) for case in cases)]
        if any(value is None or is_raised(value) for value in row) or all_alike(form, row, table.wanted[name]):
            continue
        for fix in matching_corrections(form, table.given[name], row, only_plain_to_see=True):
            return [
                PartFound(
                    {each: feedback_of(task, each) for each in (mistake, fix)}, describe(task, [mistake, fix]), {name}
                )
            ]
    return []


def _remarked(table: Table, name: str) -> list[PartFound]:
    """Return what a form itself says of a wrong answer, beside the other parts that speak of the same one."""
    form, outcomes = table.forms[name], table.given[name]
    beside = named_beside(name, table.given)
    wrong = [n for n, pair in enumerate(zip(outcomes, table.wanted[name], strict=True)) if not alike(form, *pair)]
    remarks = (form.remark(outcomes[n], {part: table.given[part][n] for part in beside}) for n in wrong)
    words = next(filter(None, remarks), None)
    return [PartFound.of(f"{name}: no proof", words, name)] if words else []


def _explain_any(task: TaskCases, table: Table, name: str) -> list[PartFound]:
    """Return what any answer can have: a habit, something universal, another part's answer."""
    form, outcomes, wanted = table.forms[name], table.given[name], table.wanted[name]
    if len(outcomes) > 1 and (pattern := find_coding_pattern(form, table.args, outcomes, wanted)):
        return [PartFound.of(f"{name}: {pattern[0]}", pattern[1], name)]
    if same := constant_of(form, outcomes, wanted):
        return [PartFound.of(f"{name}: {same[0]}", same[1], name)]
    for fix in [*matching_corrections(form, outcomes, wanted), *in_some(form, outcomes, wanted)][:1]:
        words = feedback_of(task, fix)
        return [PartFound({fix.partition(TOLD)[0]: words}, _shown_too(task, name, words.reply), {name})]
    if (other := _anothers(table, name)) is not None:
        return [PartFound.of(f"{other} under {name}", TEXTS["anothers"].filled(other=other), name)]
    return []


def _explain_words(task: TaskCases, table: Table, name: str) -> list[PartFound]:
    """Return which words a function confuses in one part of what it gives, and in which calls."""
    form = table.forms[name]
    confusion = confused(form, table.given[name], table.wanted[name]) if isinstance(form, Choice) else None
    if confusion is None:
        return []
    said = Text.joined(confusion.said, seen_of(confusion, task.seen))
    return [PartFound.of(f"{name}: {confusion.name}", said, name)._replace(is_of_words=True)]


def _anothers(table: Table, name: str) -> str | None:
    """Return the part whose answer stands here, if it is that of one other part: what several have is chance."""
    found = []
    form = table.forms[name]
    for other, part in table.forms.items():
        is_like = other != name and type(part) is type(form) and not isinstance(part, Choice | ListForm)
        is_more = is_like and any(is_something(part, value) for value in table.given[name])
        if is_more and matches_closely(part, table.given[name], table.wanted[other]):  # near to it may be chance
            found.append(other)
    return found[0] if len(found) == 1 else None


def _explain_the_given(
    task: TaskCases, name: str, form: Form, outcome: Plain, wanted: Plain, given: dict[str, Plain] | None
) -> list[PartFound]:
    """Return that a part is what was given, or has a factor reversed."""
    fix = find_input(form, outcome, wanted, given)
    if not fix:
        return []
    return [PartFound({fix: feedback_of(task, fix)}, _shown_too(task, name, feedback_of(task, fix).reply), {name})]


def _as_another_is(
    task: TaskCases, table: Table, name: str, wrong_answers: dict[str, Plain], known: set[str]
) -> list[PartFound]:
    """Return the mistake that writes another part's right answer here, where that one, wrong as is `known`, stands."""
    form = table.forms[name]
    for other, part in table.forms.items():
        is_like = other in known and type(part) is type(form) and form.is_measured
        is_more = is_something(form, table.given[name][0])  # zeros are alike by chance
        if not is_like or not is_more or not alike(form, table.given[name][0], table.given[other][0]):
            continue
        for key, answer in wrong_answers.items():
            is_made_here = feedback_of(task, key).part == name
            if is_made_here and alike(form, task.form.part_of(answer, name), table.wanted[other][0]):
                return [PartFound({key: feedback_of(task, key)}, feedback_of(task, key).reply, {name})]
    return []


def _as_it_came(form: Form, table: Table, name: str, cases: Sequence[Case]) -> list[PartFound]:
    """Return whether a part of what a function gives is that part of an argument, in every case."""
    for place in range(len(cases[0].args or ())):
        came = [form.part_of(case.args[place], name) for case in cases]
        if all(part is not None for part in came) and all_alike(table.forms[name], table.given[name], came):
            return [PartFound({f"{name} as it came": Feedback(TEXTS["as_it_came"], "")}, TEXTS["as_it_came"], {name})]
        times = [time_of(case.args[place]) for case in cases]
        if None not in times and times == [stamp_of(value) for value in table.given[name]]:
            said = TEXTS["time_of"].filled(number=place + 1)
            return [PartFound({f"{name}: a time": Feedback(said, "")}, said, {name})]
    return []


def _choice(task: TaskCases, part: str, form: Form, answer: Plain, wanted: Plain) -> Text | None:
    """Return what an option would mean, and what the part shows: why one is not the other."""
    option = (
        form.option(answer) if isinstance(form, Choice) else str(answer) if isinstance(answer, str | bool) else None
    )
    means = task.means.get(option or "")
    right = word_of(form, wanted) if isinstance(form, Choice) else None
    shows = _shows(task, part) or task.seen.get(right or "")
    if means is None and shows is None:
        return None
    return Text.joined(means, shows)


def _shows(task: TaskCases, part: str) -> Text | None:
    """Return what there is to see in a part: of "c[0]", what was written for it, for c, or for each list's first."""
    name, bracket, place = part.partition("[")
    return task.shows.get(part) or task.shows.get(name) or task.shows.get(bracket + place)


def _shown_too(task: TaskCases, part: str, said: Text) -> Text:
    """Return what is said of a part that is no choice, and what there is to see in it, if that was written."""
    return Text.joined(said, task.shows.get(part))


def _certain(table: Table, name: str) -> Text | None:
    """Return what is certain of a part that nothing explains, where it goes wrong first."""
    pairs = zip(table.given[name], table.wanted[name], strict=True)
    wrong = next((pair for pair in pairs if not alike(table.forms[name], *pair)), None)
    return table.forms[name].describe_difference(*wrong) if wrong else None


def explain_list_members(question: Question) -> Explanation | None:
    """Return what all members of lists of messages have wrong; None if nothing explains it."""
    task, form, cases, outcomes = question.task, question.form, question.cases, question.outcomes
    if not isinstance(form, ListForm) or not isinstance(form.of, Message):
        return None
    wanted = [None if is_raised(case.expected) else inside(case.expected) for case in cases]
    given = [inside(outcome) for outcome in outcomes]
    for members in (*wanted, *given):
        if not isinstance(members, list):
            return None
    if list(map(len, wanted)) != list(map(len, given)):
        return None
    flat = [Case([], member, {}) for members in wanted for member in members]
    answers = [member for members in given for member in members]
    if not flat:
        return None
    return explain_parts(Question(task._replace(form=form.of, feedback={}), flat, answers))
