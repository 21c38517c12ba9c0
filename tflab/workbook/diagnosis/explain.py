"""Explain a wrong answer: one ordered table, of which the first row that can explain the answer counts.

    explain(question)       Explanation({"swapped": ...}, Text("You swapped ..."))
    list_asked(question)    [("", "an obvious generic mistake", False), ..., ("", "two mistakes", True)]

The order is that of certainty: what is seen in the answer itself, one mistake, two mistakes, what the calls
of a function have in common. A name is given only where the whole of an answer, or of a part, is what that
mistake gives. The field calls such a table a *bug library* (BUGGY, DEBUGGY), searched by model tracing.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from ...text import Text, Texts, capitalized, load_yaml
from ..answers.forms import Angle, Choice, Command, Message, Number, Parts, Pose, Tree, Urdf, Vector
from ..answers.forms import Sequence as ListForm
from ..answers.values import Plain, is_raised
from ..tasks.case_types import AND
from ..tasks.credit import trivial_pattern
from .calls import (
    changes_an_argument,
    explain_changed_arguments,
    explain_raises,
    explain_swallowed_exceptions,
)
from .constants_and_inputs import find_input
from .explanation import Explanation, combine_explanations, describe
from .generic import TOLD, describe_names
from .links import explain_links
from .matching import (
    A_HAIR,
    ONE,
    TWO,
    alike,
    all_alike,
    feedback_of,
    in_some,
    matches_closely,
    matching_corrections,
)
from .options import confused, confused_in_lists, seen_of, word_of
from .parts import explain_list_members, explain_obvious_part, explain_parts
from .question import Explainer, PartialExplanation, Question
from .wrong_types import explain_other_types

__all__ = ["TABLE", "explain", "list_asked", "read_conditions"]

TEXTS = Texts(__file__)


def explain(question: Question) -> Explanation | None:
    """Return the first explanation of the table, or None if there is none."""
    return next((found for _, found in _answers(question) if found is not None), None)


def read_conditions() -> dict[str, str]:
    """Return for each explanation, and for each mistake that a form recognises, when it is true, by name."""
    return load_yaml(Path(__file__).with_name("conditions.yaml").read_text(encoding="utf-8"))


def list_asked(question: Question) -> list[tuple[str, str, bool]]:
    """Return the rows that were asked, in order: of which part or "", the row's name, and whether it explained."""
    rows: list[tuple[str, str, bool]] = []
    for row, found in _answers(question):
        rows.append(("", row.name, found is not None))
        if found is not None:
            return [*rows, *found.asked]
    return rows


def _answers(question: Question) -> Iterator[tuple[Explainer, Explanation | None]]:
    for row in TABLE:
        if row.applies(question):
            found = row.explain(question)
            yield row, _with_the_rest(found) if isinstance(found, PartialExplanation) else found
            if row.is_last:
                return


def _with_the_rest(found: PartialExplanation) -> Explanation | None:
    first = explain(found.question) if found.question else None
    if first is None:
        return found.then if found.is_enough else None
    return combine_explanations(first, found.then)


# -- one mistake, or two ---------------------------------------------------------------------


def _explain_value_of_parts(question: Question) -> Explanation | None:
    """Explain each part; several mistakes only where there is nothing simpler, and no two give all of it."""
    found = explain_parts(question)
    if found is None or len(found.mistakes) < 2:
        return found
    if simpler := explain_obvious_part(question):
        return simpler
    pair = next(_pairs(question, ONE), None) if len(found.mistakes) > 2 else None
    return _explained_by(question, *pair) if pair else found


def _explain_one_mistake(question: Question) -> Explanation | None:
    """Name the mistake of the task that gives the answer; before one that is only near to it, two that are exact."""
    near = _single(question, ONE)
    if near and not question.is_function and question.form.is_measured and not _single(question, A_HAIR):
        pair = next(_pairs(question, A_HAIR), None)
        if pair:
            return _explained_by(question, *pair)
    return _explained_by(question, near[0]) if near else None


def _explain_obvious_mistake(question: Question) -> Explanation | None:
    """Name a mistake that any answer can have, and that is plain to see."""
    names = matching_corrections(question.form, question.outcomes, question.expected, only_plain_to_see=True)
    return _explained_by_first(question, ((name,) for name in names))


def _explain_input_as_it_came(question: Question) -> Explanation | None:
    name = find_input(question.form, question.outcomes[0], question.expected[0], question.inputs)
    return _explained_by(question, name) if name else None


def _explain_mistake_and_generic(question: Question) -> Explanation | None:
    """Name a mistake of the task and an obvious one that any answer can have, made after it."""
    rows = question.single_mistakes.items()
    return _explained_by_first(question, (
        (first, then)
        for first, row in rows
        for then in matching_corrections(question.form, question.outcomes, row, only_plain_to_see=True)
    ))  # fmt: skip


def _explain_generic_mistake(question: Question) -> Explanation | None:
    names = next(((name,) for name in matching_corrections(question.form, question.outcomes, question.expected)), None)
    return _explained_by(question, *names) if names else None


def _explain_mistake_in_each_answer(question: Question) -> Explanation | None:
    """Name the mistake that gives each answer, where it would not raise as the function does."""
    answered = [is_right for is_right, raises in zip(question.is_right, question.calls_that_raise(), strict=True)
                if not raises]  # fmt: skip
    if len(answered) < 2 or any(answered):
        return None
    rows = question.single_mistakes.items()
    return _explained_by_first(question, ((name,) for name, row in rows if _is_all_that_is_wrong(question, row)))


def _explain_generic_mistake_in_some_calls(question: Question) -> Explanation | None:
    found = in_some(question.form, question.outcomes, question.expected)
    return _explained_by_first(question, ((name,) for name in found))


# -- what all calls show ---------------------------------------------------------------------


def _explain_nothing(question: Question) -> None:
    """Leave a constant, or what came in, to the verdict: that says it all."""


def _explain_confused_options(question: Question) -> Explanation | None:
    """Say which option stands for which, alone or in lists, and in which call it shows."""
    task, form, wanted, outcomes = question.task, question.form, question.expected, question.outcomes
    found = confused(form, outcomes, wanted) if isinstance(form, Choice) else confused_in_lists(form, outcomes, wanted)
    if found is None or not found.word:
        return Explanation.of(found.name, found.said) if found else None
    explanation = Explanation.of(
        found.name, Text.joined(found.said, task.means.get(found.word), seen_of(found, task.seen))
    )
    if isinstance(form, Choice):
        pairs = [(word_of(form, want), word_of(form, outcome)) for want, outcome in zip(wanted, outcomes, strict=True)]
        explanation = explanation._replace(shows=pairs.index((found.wanted, found.word)))
    return explanation


def _explain_names(question: Question) -> Explanation | None:
    words = describe_names(question.form, question.outcomes, question.expected)
    return Explanation.of("names", words) if words else None


def _is_not_short(question: Question) -> bool:
    """Return whether a number has digits enough for two mistakes to be no chance, and is not the right one rounded."""
    form, outcomes = question.form, list(question.outcomes)
    if question.task.is_function or not isinstance(form, Number):
        return True
    return not form.is_short(outcomes[0]) and "rounded" not in matching_corrections(form, outcomes, question.expected)


TABLE: tuple[Explainer, ...] = (
    Explainer("parts of a value", _explain_value_of_parts, of="value", forms=(Parts,), is_last=True),
    Explainer("a time for seconds, or pairs for a dict", explain_other_types, forms=(Number, Tree)),
    Explainer(
        "a changed argument", explain_changed_arguments, of="function", condition=changes_an_argument, is_last=True
    ),
    Explainer("one mistake of the task", _explain_one_mistake),
    Explainer("an obvious generic mistake", _explain_obvious_mistake),
    Explainer("an obvious mistake in one part", explain_obvious_part, forms=(Parts,)),
    Explainer(
        "a constant, or the input",
        _explain_nothing,
        of="function",
        condition=lambda each: bool(trivial_pattern(each.form, each.cases, each.outcomes)),
        is_last=True,
    ),
    Explainer("an input as it came, or a factor reversed", _explain_input_as_it_came, of="value"),
    Explainer("two mistakes", lambda each: _explained_by_first(each, _pairs(each, TWO)), condition=_is_not_short),
    Explainer("a mistake and a generic one", _explain_mistake_and_generic, condition=_is_not_short),
    Explainer("a generic mistake", _explain_generic_mistake),
    Explainer("one mistake in each answer", _explain_mistake_in_each_answer, of="function", is_measured=True),
    Explainer(
        "a generic mistake in some calls", _explain_generic_mistake_in_some_calls, of="function", is_measured=True
    ),
    Explainer("calls that raise", explain_raises, of="function"),
    Explainer("swallowed exceptions", explain_swallowed_exceptions, of="function"),
    Explainer(
        "parts",
        explain_parts,
        forms=(Parts, Message, Command, Pose),
        condition=lambda each: bool(each.form.forms_of_parts(each.outcomes[0])),
        is_last=True,
    ),
    Explainer("links of a robot", explain_links, forms=(Urdf,), is_last=True),
    Explainer("members of lists", explain_list_members, forms=(ListForm,)),
    Explainer("confused options", _explain_confused_options, of="function", forms=(Choice, ListForm)),
    Explainer("names", _explain_names, of="function"),
)


# -- matching --------------------------------------------------------------------------------


def _explained_by_first(question: Question, combinations: Iterator[tuple[str, ...]]) -> Explanation | None:
    names = next(combinations, None)
    return _explained_by(question, *names) if names else None


def _explained_by(question: Question, *names: str) -> Explanation:
    """Return what is said of mistakes that give an answer."""
    said = describe(question.task, names)
    if len(names) == 1 and _is_only_near(question, names[0]):
        said = TEXTS["only_near"].filled(said=Text(capitalized(said.en), said.ko))
    return Explanation({name.partition(TOLD)[0]: feedback_of(question.task, name) for name in names}, said)


def _is_only_near(question: Question, name: str) -> bool:
    """Return whether a number is what a mistake gives to some digits alone: two others may come to it, too."""
    if question.task.is_function or not isinstance(question.form, Number | Angle | Vector):
        return False
    row = question.single_mistakes.get(name)
    return row is not None and not matches_closely(question.form, question.outcomes, row, A_HAIR)


def _single(question: Question, share: float) -> list[str]:
    """Return the mistakes that give just these outcomes."""
    rows = question.single_mistakes.items()
    return [name for name, row in rows if matches_closely(question.form, question.outcomes, row, share)]


def _pairs(question: Question, share: float) -> Iterator[tuple[str, ...]]:
    """Yield the pairs of mistakes that give just these outcomes; they are searched for."""
    if question.task.pairs is None:
        return
    found = question.task.pairs.matching(
        question.cases,
        sorted(range(len(question.cases)), key=question.is_right.__getitem__),
        lambda number, value: ["whole"] * matches_closely(question.form, [question.outcomes[number]], [value], share),
        dict(question.inputs),
    )
    yield from (tuple(name.split(AND)) for name in found)


def _is_all_that_is_wrong(question: Question, row: list[Plain]) -> bool:
    """Return whether all that is wrong is what a mistake gives, though the mistake would give more."""
    triples = zip(question.outcomes, question.expected, row, strict=True)
    wrong = [(outcome, given) for outcome, want, given in triples if not all_alike(question.form, [outcome], [want])]
    if any(is_raised(given) or is_raised(outcome) or given is None for outcome, given in wrong):
        return False
    return all(alike(question.form, *pair) for pair in wrong)
