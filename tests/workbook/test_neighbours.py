"""A reply is given to the answer that it means, and not to its neighbours: for every task, in its public cases."""

from __future__ import annotations

import pytest

from tflab.workbook.answers.forms import Angle, Choice, Form, Name, Number, Parts, Pose, Quaternion, Vector
from tflab.workbook.answers.values import is_raised
from tflab.workbook.places import CASES, workbook_data
from tflab.workbook.tasks.case import AND, TaskCases, Variant
from tflab.workbook.tasks.cases import read_chapter
from tflab.workbook.verdicts.mistake import Mistake
from tflab.workbook.verdicts.verdict import judge_outcomes

OF_NUMBERS = (Number, Angle, Vector, Quaternion, Pose)
MOST_NEIGHBOURS = 40  # of a task; where there are more slips, each is still looked at beside the right answer
CHAPTERS = [read_chapter(path) for path in sorted((workbook_data() / CASES).glob("[0-9]*.json"))]
TASKS = [(task_id, task) for chapter in CHAPTERS for task_id, task in chapter.tasks.items()]
each_task = pytest.mark.parametrize(("task_id", "task"), TASKS, ids=[task_id for task_id, _ in TASKS])


def singles(variant: Variant) -> dict[str, list]:
    """Return what each single slip gives, case by case."""
    cases = variant.cases
    return {name: [case.twins[name] for case in cases] for name in cases[0].twins if AND not in name}


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


@each_task
def test_a_slips_answer_hears_its_own_reply_first_and_nobody_elses(task_id: str, task: TaskCases) -> None:
    variant = task.variants[0]
    for name, outcomes in list(singles(variant).items())[:MOST_NEIGHBOURS]:
        verdict = judge_outcomes(task, variant, outcomes)
        assert verdict.mistake is Mistake.SLIP and list(verdict.slips) == [name]
        reply = task.twins[name].reply
        assert without_its_part(task.form, reply.en) in verdict.said.en
        assert without_its_part(task.form, reply.ko) in verdict.said.ko


@each_task
def test_the_right_answer_hears_no_slip(task_id: str, task: TaskCases) -> None:
    for variant in task.variants:
        verdict = judge_outcomes(task, variant, [case.expected for case in variant.cases])
        assert (verdict.mistake, verdict.slips) == (None, {})


@each_task
def test_a_number_beside_that_of_a_slip_does_not_hear_its_reply(task_id: str, task: TaskCases) -> None:
    if not is_of_numbers(task.form):
        pytest.skip("words have no neighbours of this kind")
    variant = task.variants[0]
    for name, outcomes in list(singles(variant).items())[:MOST_NEIGHBOURS]:
        beside = [  # where an exception is asked for, one number is as wrong as another
            outcome if is_raised(case.expected) else nudged(outcome)
            for case, outcome in zip(variant.cases, outcomes, strict=True)
        ]
        assert beside == outcomes or name not in judge_outcomes(task, variant, beside).slips


@each_task
def test_a_slip_that_is_made_in_one_call_alone_is_not_called_the_whole_slip(task_id: str, task: TaskCases) -> None:
    if not task.is_function or isinstance(task.form, Choice | Name):
        pytest.skip("one answer, or words, of which one call may say all")
    variant = task.variants[0]
    right = [case.expected for case in variant.cases]
    for name, outcomes in list(singles(variant).items())[:MOST_NEIGHBOURS]:
        shows = [place for place, row in enumerate(outcomes) if not task.form.alike(row, right[place])]
        if len(shows) < 2:
            continue
        mended = [right[place] if place == shows[0] else outcome for place, outcome in enumerate(outcomes)]
        assert list(judge_outcomes(task, variant, mended).slips) != [name]
