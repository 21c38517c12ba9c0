"""Explain the wrong parts of an answer, each part of a dict and each field of a message by itself.

    {"base_link": right, "map": wrong}     a mistake of the task that shows in "map" alone
                                           a mistake that any answer can have, in that part
                                           the answer of another part, or what was given

What explains several parts together comes first (`_explain_several`).  Each part that is left is explained by the
first row of `PARTS` that can.  A value has one case, a function several: a part is explained where it is in all of
them.  What only follows from an earlier mistake costs nothing: *error carried forward*.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain, combinations

from ...text import Text, Texts
from ..answers.form import inside
from ..answers.forms import Choice, Message
from ..answers.forms import Sequence as ListForm
from ..answers.structures import named_beside
from ..answers.values import is_raised
from ..tasks.case_types import Case
from .constants_and_inputs import constant_of, find_input
from .explanation import Explanation, PartFound, merge_found, without_overlaps
from .matching import alike, all_alike, in_some, matches_closely, matching_corrections
from .options import confused, seen_of, word_of
from .part_mistakes import AnswerPart, Table, consequence_of, is_something, mistakes_in_parts
from .question import Explainer, Question
from .wrong_types import describe_types

__all__ = ["PARTS", "explain_list_members", "explain_obvious_part", "explain_parts"]

TEXTS = Texts(__file__)


def explain_parts(question: Question) -> Explanation | None:
    """Return how the wrong parts of an answer came about, or None if nothing explains any of them."""
    raises = question.calls_that_raise()
    if not all(question.calls(raises).is_right):
        return None
    asked = question.calls(not each for each in raises)
    stops = [is_raised(outcome) for outcome in asked.outcomes]
    stopped, going = asked.calls(stops), asked.calls(not each for each in stops)
    if not going.cases or len(going.cases) < len(stopped.cases):
        return None
    if any(question.form.read(outcome) is None for outcome in going.outcomes):
        return None
    return _beside_stops(stopped, going) if stopped.cases else _explain_table(Table.of(going))


def _beside_stops(stopped: Question, going: Question) -> Explanation | None:
    """Return which of the task's mistakes explains the calls that go on, if it stops in the others just as this did."""
    rows = stopped.single_mistakes.items()
    names = [name for name, row in rows if all_alike(stopped.form, stopped.outcomes, row)]
    only = [case._replace(wrong={name: case.wrong[name] for name in names}) for case in going.cases]
    table = Table.of(Question(going.task._replace(pairs=None), only, going.outcomes))
    found = _explain_table(table) if names else None
    return found if found and found.mistakes.keys() <= going.task.feedback.keys() else None


def _explain_table(table: Table) -> Explanation | None:
    """Return the same where each case asks for a value, and each outcome can be read."""
    wrong = table.wrong
    several = _explain_several(table, wrong)
    found = without_overlaps(list(chain(*several.values())), wrong)
    asked = [("", name, any(cause in found for cause in causes)) for name, causes in several.items()]
    left = [name for name in table.forms if name in wrong.difference(*(cause.parts for cause in found))]
    for name in left:
        part = table.part(name, found)
        for row, cause in _answers(part):
            asked.append((name, row, cause is not None))
            found += [cause] if cause else []
    if not found:
        return None
    explained = set().union(*(cause.parts for cause in found))
    certain = {name: _certain(table, name) for name in left if name not in explained}
    return merge_found(found, certain, list(table.forms))._replace(asked=tuple(asked))


def _answers(part: AnswerPart) -> Iterator[tuple[str, PartFound | None]]:
    """Yield the rows that are asked about a part, up to the first that explains it, and the explanation."""
    for row in (row for row in PARTS if row.applies(part)):
        cause = row.explain(part)
        yield row.name, cause
        if cause is not None:
            return


# -- several parts together ----------------------------------------------------------------


def _explain_several(table: Table, wrong: set[str]) -> dict[str, list[PartFound]]:
    """Return what explains parts together: two that changed places, and mistakes."""
    mistakes = mistakes_in_parts(table, wrong)
    pairs = [pair for pair in _changed_places(table, wrong) if not any(pair.parts <= each.parts for each in mistakes)]
    return {"parts that changed places": pairs, "mistakes in parts": mistakes}


def _changed_places(table: Table, wrong: set[str]) -> Iterator[PartFound]:
    """Yield two parts of which each holds the other's answer."""
    names = [name for name in table.forms if name in wrong and not isinstance(table.forms[name], Choice | ListForm)]
    for one, other in combinations(names, 2):
        is_alike = type(table.forms[one]) is type(table.forms[other])
        if is_alike and _holds(table, one, other) and _holds(table, other, one):
            yield PartFound.of(f"{one} and {other} changed places", TEXTS["changed_places"], one, other)


def _holds(table: Table, one: str, other: str) -> bool:
    return all_alike(table.forms[other], table.given[one], table.wanted[other])


def explain_obvious_part(question: Question) -> Explanation | None:
    """Return what is plain to see in the only part that is wrong: no two mistakes have to meet for a sign alone."""
    if any(map(is_raised, (*question.outcomes, *question.expected))):
        return None
    if any(question.form.read(outcome) is None for outcome in question.outcomes):
        return None
    table = Table.of(question)
    if len(table.wrong) != 1:
        return None
    part = table.part(*table.wrong)
    fix = next(matching_corrections(part.form, part.outcomes, part.expected, only_plain_to_see=True), None)
    return merge_found([_shown_too(part, fix)], {}, list(table.forms)) if fix else None


# -- one part ------------------------------------------------------------------------------


def _explain_option(part: AnswerPart) -> PartFound | None:
    """Return what the option that was chosen would mean, and what the part shows instead."""
    outcome, hint = part.outcomes[0], _hint(part)
    if hint is None:
        return None
    return part.explained(f"{part.name}: {outcome}", Text.joined(hint, part.form.remark(outcome, {})))


def _explain_word(part: AnswerPart) -> PartFound | None:
    """Return the same of a word or a bool that is no option, where nothing else explains it."""
    hint = _hint(part)
    return part.explained(f"{part.name}: another", hint) if hint else None


def _hint(part: AnswerPart) -> Text | None:
    """Return what an option would mean, and what the part shows: why one is not the other."""
    task, form, answer = part.table.task, part.form, part.outcomes[0]
    is_choice = isinstance(form, Choice)
    option = form.option(answer) if is_choice else str(answer) if isinstance(answer, str | bool) else None
    right = word_of(form, part.expected[0]) if is_choice else None
    name, bracket, place = part.name.partition("[")  # of "c[0]", what is for it, for c, or for each list's first
    shows = task.shows.get(part.name) or task.shows.get(name) or task.shows.get(bracket + place)
    said = [task.means.get(option or ""), shows or task.seen.get(right or "")]
    return Text.joined(*said) if any(said) else None


def _explain_kinds(part: AnswerPart) -> PartFound | None:
    """Return whether what is no word at all stands where one is asked for, in some calls of a function."""
    said = describe_types(part.form, part.outcomes)[:2]
    texts = (". ".join(row) + "." for row in zip(*said, strict=True))
    return part.explained(f"{part.name}: no word", Text(*texts)) if said else None


def _remarked(part: AnswerPart) -> PartFound | None:
    """Return what a form itself says of a wrong answer, beside the other parts that speak of the same one."""
    given = part.table.given
    beside = named_beside(part.name, given)
    pairs = enumerate(zip(part.outcomes, part.expected, strict=True))
    wrong = [(n, pair[0]) for n, pair in pairs if not alike(part.form, *pair)]
    remarks = (part.form.remark(outcome, {other: given[other][n] for other in beside}) for n, outcome in wrong)
    words = next(filter(None, remarks), None)
    return part.explained(f"{part.name}: no proof", words) if words else None


def _explain_constant(part: AnswerPart) -> PartFound | None:
    found = constant_of(part.form, part.outcomes, part.expected)
    return part.explained(f"{part.name}: {found[0]}", found[1]) if found else None


def _explain_generic_mistake(part: AnswerPart) -> PartFound | None:
    row = (part.form, part.outcomes, part.expected)
    fix = next((fix for find in (matching_corrections, in_some) for fix in find(*row)), None)
    return _shown_too(part, fix) if fix else None


def _shown_too(part: AnswerPart, fix: str) -> PartFound:
    """Return a mistake that any answer can have, and what there is to see in the part, if that was written."""
    found = part.explained_by(fix)
    return found._replace(said=Text.joined(found.said, part.table.task.shows.get(part.name)))


def _explain_anothers(part: AnswerPart) -> PartFound | None:
    """Return the part whose answer stands here, if it is that of one other part: what several have is chance."""
    found = []
    for other, form in part.table.forms.items():
        is_like = other != part.name and type(form) is type(part.form) and not isinstance(form, Choice | ListForm)
        is_more = is_like and any(is_something(form, value) for value in part.outcomes)
        if is_more and matches_closely(form, part.outcomes, part.table.wanted[other]):  # near to it may be chance
            found.append(other)
    if len(found) != 1:
        return None
    return part.explained(f"{found[0]} under {part.name}", TEXTS["anothers"].filled(other=found[0]))


def _explain_words(part: AnswerPart) -> PartFound | None:
    """Return which words a function confuses in one part of what it gives, and in which calls."""
    confusion = confused(part.form, part.outcomes, part.expected)
    if confusion is None:
        return None
    said = Text.joined(confusion.said, seen_of(confusion, part.table.task.seen))
    return part.explained(f"{part.name}: {confusion.name}", said)._replace(is_of_words=True)


def _explain_the_given(part: AnswerPart) -> PartFound | None:
    """Return that a part is what was given, or has a factor reversed."""
    fix = find_input(part.form, part.outcomes[0], part.expected[0], part.table.question.inputs)
    return _shown_too(part, fix) if fix else None


def _after_a_mistake(part: AnswerPart) -> PartFound | None:
    """Return what a part is beside the mistakes of the task that were found in others."""
    table, known = part.table, {name for cause in part.found for name in cause.parts} - {part.name}
    for mistake, made_in in (
        (name, words.part) for name, words in part.table.task.feedback.items() if words.part in known
    ):
        answers = [case.wrong[mistake] for case in table.question.cases]
        found = consequence_of(part, made_in, table.part_of(answers, part.name))
        if found and matches_closely(table.forms[made_in], table.given[made_in], table.part_of(answers, made_in)):
            return found
    return None


def _mistake_and_then(part: AnswerPart) -> PartFound | None:
    """Return a mistake of the task and what is plain to see on top of it, if both give one part."""
    rows = part.table.question.single_mistakes
    for mistake in (name for name in part.table.task.feedback if name in rows):
        row = part.table.part_of(rows[mistake], part.name)
        if any(value is None or is_raised(value) for value in row) or all_alike(part.form, row, part.expected):
            continue
        for fix in matching_corrections(part.form, part.outcomes, row, only_plain_to_see=True):
            return part.explained_by(mistake, fix)
    return None


PARTS: tuple[Explainer, ...] = (  # of one part; the names of the table in `explain.py` where it is the same
    Explainer("the meaning of an option", _explain_option, of="value", forms=(Choice,)),
    Explainer("an answer of another type", _explain_kinds),
    Explainer("a remark of the form", _remarked),
    Explainer("a part that is always the same", _explain_constant, of="function"),
    Explainer("a generic mistake", _explain_generic_mistake),
    Explainer("the answer of another part", _explain_anothers),
    Explainer("confused options", _explain_words, of="function", forms=(Choice,)),
    Explainer("an input as it came, or a factor reversed", _explain_the_given, of="value"),
    Explainer("the meaning of a word", _explain_word, of="value"),
    Explainer("a consequence of a mistake", _after_a_mistake, is_measured=True),
    Explainer("a mistake and a generic one", _mistake_and_then, is_measured=True),
)


def _certain(table: Table, name: str) -> Text | None:
    """Return what is certain of a part of a value that nothing explains; of calls, one is shown with both values."""
    (given, *more), (wanted, *_) = table.given[name], table.wanted[name]
    return None if more else table.forms[name].describe_difference(given, wanted)


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
