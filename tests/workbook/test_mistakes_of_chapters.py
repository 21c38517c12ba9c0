"""The known mistakes of every task: each answer gets its own reply, alone and combined, and no other answer gets it."""

from __future__ import annotations

from functools import partial

import pytest

from tflab.workbook.answers.forms import Angle, Choice, Form, Name, Number, Parts, Pose, Quaternion, Vector
from tflab.workbook.answers.values import from_plain, is_raised
from tflab.workbook.diagnosis.failure import Failure
from tflab.workbook.diagnosis.precision import LISTS
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.tasks.case_types import AND, TaskCases, values_of
from tflab.workbook.tasks.pairs import combinable
from tflab.workbook.tasks.reference import in_process_ros
from tflab.workbook.tasks.task import Task

from .each_task import READS, cases_of, each_task, task_in

OF_NUMBERS = (Number, Angle, Vector, Quaternion, Pose)
MOST_PAIRS = 40  # of a task: each takes a tenth of a second to two seconds, and some tasks have fifteen hundred
SIMPLER = {Failure.ECHO, Failure.CONSTANT, Failure.NOTHING_RETURNED, Failure.RAISES}  # what a pair may also be


def changed(plain):
    """Return JSON in which every number is another one, by more than any tolerance and no known share."""
    if isinstance(plain, bool) or plain is None or isinstance(plain, str):
        return plain
    if isinstance(plain, int | float):
        return 1.317 * plain + 0.0713
    if isinstance(plain, list):
        return [changed(member) for member in plain]
    return {key: changed(value) if key != "raises" else value for key, value in plain.items()}


def has_few_digits(task: TaskCases, outcomes: list) -> bool:
    """Return whether the answer is one short number, such as 0.55: several pairs of mistakes could give that."""
    return not task.is_function and task.form.is_short(outcomes[0])


def is_of_numbers(form: Form) -> bool:
    return isinstance(form, OF_NUMBERS) or (isinstance(form, Parts) and all(map(is_of_numbers, form.parts.values())))


def without_its_part(form: Form, text: str) -> str:
    """Return a reply without the name of the part at its beginning."""
    named = (f"{part}: " for part in getattr(form, "parts", {}))
    return next((text.removeprefix(name) for name in named if text.startswith(name)), text)


@pytest.mark.proof(reads=READS)
@each_task
def test_each_mistake_gets_its_own_reply_and_the_solution_full_marks(stem: str, file: str, sample) -> None:
    task = cases_of(stem, file, len(sample(range(task_in(stem, file).variants), 1)))
    for variant in task.variants:
        verdict = judge_outcomes(task, variant, [case.expected for case in variant.cases])
        assert (verdict.failure, verdict.mistakes) == (None, {})
        for name in variant.cases[0].wrong:
            assert_own_reply(task, variant, name)


def assert_own_reply(task: TaskCases, variant, name: str) -> None:
    verdict = judge_outcomes(task, variant, [case.wrong[name] for case in variant.cases])
    assert verdict.failure is Failure.KNOWN and list(verdict.mistakes) == [name]
    reply = task.feedback[name].reply
    assert without_its_part(task.form, reply.en) in verdict.said.en
    assert without_its_part(task.form, reply.ko) in verdict.said.ko


@pytest.mark.proof(reads=READS)
@each_task
def test_other_answers_do_not_get_the_reply_to_a_mistake(stem: str, file: str, sample) -> None:
    task = cases_of(stem, file, 1)
    (variant,) = task.variants
    for name in sample(list(variant.cases[0].wrong)[:MOST_PAIRS], 3):
        outcomes = [case.wrong[name] for case in variant.cases]
        if name in LISTS:  # which any list can show, in some calls or in all
            continue
        if is_of_numbers(task.form):
            assert_other_numbers_do_not_get_it(task, name, outcomes)
        if task.is_function and not isinstance(task.form, Choice | Name):  # of words, one call may show all
            assert_a_function_that_is_right_in_one_call_does_not_get_it(task, name, outcomes)


def assert_other_numbers_do_not_get_it(task: TaskCases, name: str, outcomes: list) -> None:
    (variant,) = task.variants
    others = [  # where an exception is expected, one number is as wrong as another
        outcome if is_raised(case.expected) else changed(outcome)
        for case, outcome in zip(variant.cases, outcomes, strict=True)
    ]
    assert others == outcomes or name not in judge_outcomes(task, variant, others).mistakes


def assert_a_function_that_is_right_in_one_call_does_not_get_it(task: TaskCases, name: str, outcomes: list) -> None:
    (variant,) = task.variants
    right = [case.expected for case in variant.cases]
    wrong = [place for place, row in enumerate(outcomes) if not task.form.alike(row, right[place])]
    if len(wrong) > 1:
        fixed = [right[place] if place == wrong[0] else outcome for place, outcome in enumerate(outcomes)]
        assert list(judge_outcomes(task, variant, fixed).mistakes) != [name]


@pytest.mark.proof(reads=READS)
@each_task
def test_two_mistakes_made_together_are_explained_by_two_or_by_a_simpler_one(stem: str, file: str, sample) -> None:
    task = task_in(stem, file)
    if task.is_costly:
        return
    pairs = combinable(task)
    some = sample(pairs[:: -(-len(pairs) // MOST_PAIRS) or 1], 3)
    answers = {first.name + AND + then.name: partial(task.model, **first.at, **then.at) for first, then in some}
    made = cases_of(stem, file, 1)
    (variant,) = made.variants
    given = {name: from_plain(value) for name, value in (variant.given or {}).items()}
    with in_process_ros():
        rows = [values_of(answers, case, given) for case in variant.cases]
    for pair in answers:
        outcomes = [row[pair] for row in rows]
        verdict = judge_outcomes(made, variant, outcomes)
        is_explained = verdict.failure in {Failure.KNOWN, None, *SIMPLER} and len(verdict.mistakes) <= 2
        assert is_explained or has_few_digits(made, outcomes) or is_given_by_others(task, made, pair, outcomes), pair


def is_given_by_others(task: Task, made: TaskCases, pair: str, outcomes: list) -> bool:
    """Return whether a mistake alone, or other two, give the same: then nobody knows which it was."""
    (variant,) = made.variants
    others = {first.name + AND + then.name: partial(task.model, **first.at, **then.at)
              for first, then in combinable(task)}  # fmt: skip
    given = {name: from_plain(value) for name, value in (variant.given or {}).items()}
    with in_process_ros():
        rows = [values_of(others, case, given) | case.wrong for case in variant.cases]
    names = rows[0].keys() - {pair}
    return any(all(map(made.form.alike, (row[name] for row in rows), outcomes)) for name in names)
