"""A reply is given to the answer that it means, and not to its neighbours: for every task, in its public cases."""

from __future__ import annotations

import pytest

from tflab.workbook.answers.forms import Angle, Choice, Form, Name, Number, Parts, Pose, Quaternion, Vector
from tflab.workbook.answers.values import is_raised
from tflab.workbook.tasks.case_types import TaskCases
from tflab.workbook.verdicts.mistake import Mistake
from tflab.workbook.verdicts.verdict import judge_outcomes

from .each_task import READS, cases_of, each_task, singles_of, task_in

OF_NUMBERS = (Number, Angle, Vector, Quaternion, Pose)
MOST_NEIGHBOURS = 40  # of a task; where there are more slips, each is still looked at beside the right answer


def nudged(plain):
    """Return JSON in which every number is another one, by more than any tolerance and no known share."""
    if isinstance(plain, bool) or plain is None or isinstance(plain, str):
        return plain
    if isinstance(plain, int | float):
        return 1.317 * plain + 0.0713
    if isinstance(plain, list):
        return [nudged(member) for member in plain]
    return {key: nudged(held) if key != "raises" else held for key, held in plain.items()}


def is_of_numbers(form: Form) -> bool:
    return isinstance(form, OF_NUMBERS) or (isinstance(form, Parts) and all(map(is_of_numbers, form.parts.values())))


def without_its_part(form: Form, text: str) -> str:
    """Return a reply without the name of a part that it begins with: that is said once, in front."""
    named = (f"{part}: " for part in getattr(form, "parts", {}))
    return next((text.removeprefix(name) for name in named if text.startswith(name)), text)


@pytest.mark.proof(reads=READS)
@each_task
def test_a_reply_is_given_to_its_answer_and_not_to_the_neighbours_of_it(stem: str, file: str, sample) -> None:
    task = cases_of(stem, file, len(sample(range(task_in(stem, file).variants), 1)))
    for variant in task.variants:
        verdict = judge_outcomes(task, variant, [case.expected for case in variant.cases])
        assert (verdict.mistake, verdict.slips) == (None, {})
    for name, outcomes in sample(list(singles_of(task.variants[0]).items())[:MOST_NEIGHBOURS], 8):
        assert_a_slips_answer_hears_its_own_reply(task, name, outcomes)
        if is_of_numbers(task.form):  # words have no neighbours of this kind
            assert_a_number_beside_it_does_not_hear_its_reply(task, name, outcomes)
        if task.is_function and not isinstance(task.form, Choice | Name):  # of words, one call may say all
            assert_one_call_alone_is_not_called_the_whole_slip(task, name, outcomes)


def assert_a_slips_answer_hears_its_own_reply(task: TaskCases, name: str, outcomes: list) -> None:
    verdict = judge_outcomes(task, task.variants[0], outcomes)
    assert verdict.mistake is Mistake.SLIP and list(verdict.slips) == [name]
    reply = task.feedback[name].reply
    assert without_its_part(task.form, reply.en) in verdict.said.en
    assert without_its_part(task.form, reply.ko) in verdict.said.ko


def assert_a_number_beside_it_does_not_hear_its_reply(task: TaskCases, name: str, outcomes: list) -> None:
    variant = task.variants[0]
    beside = [  # where an exception is asked for, one number is as wrong as another
        outcome if is_raised(case.expected) else nudged(outcome)
        for case, outcome in zip(variant.cases, outcomes, strict=True)
    ]
    assert beside == outcomes or name not in judge_outcomes(task, variant, beside).slips


def assert_one_call_alone_is_not_called_the_whole_slip(task: TaskCases, name: str, outcomes: list) -> None:
    variant = task.variants[0]
    right = [case.expected for case in variant.cases]
    shows = [place for place, row in enumerate(outcomes) if not task.form.alike(row, right[place])]
    if len(shows) < 2:
        return
    mended = [right[place] if place == shows[0] else outcome for place, outcome in enumerate(outcomes)]
    assert list(judge_outcomes(task, variant, mended).slips) != [name]
