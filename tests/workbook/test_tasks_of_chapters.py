"""The tasks of all chapters are complete, in two languages, and have distinct mistakes for any seed."""

from __future__ import annotations

import re

import pytest

from tflab.workbook.answers.forms import form_from_plain
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.tasks.generate_cases import PUBLIC_SEED, task_cases
from tflab.workbook.tasks.reference import in_process_ros
from tflab.workbook.tasks.task import read_tasks

from .each_task import READS, SOLUTIONS, STEMS, cases_of, each_task, solution_of, task_in

SEEDS, SEEDS_OF_PAIRS, SEEDS_OF_MANY = 200, 20, 6  # fewer for a task with a model, and for one with many mistakes
MANY = 40


def _seeds(task):
    """Return up to 200 seeds; one for a task whose cases take minutes."""
    if task.is_costly:
        return [PUBLIC_SEED]
    count = SEEDS if task.model is None else SEEDS_OF_PAIRS if len(task.mistakes) < MANY else SEEDS_OF_MANY
    return [f"seed {number}" for number in range(count)]


@pytest.mark.proof(reads=READS)
@each_task
def test_mistakes_give_different_answers_for_any_seed(stem, file, sample):
    task = task_in(stem, file)
    with in_process_ros():
        for seed in sample(_seeds(task), 1):
            task_cases(task, seed, solution_of(stem), variants=1)  # raises where two are alike


@pytest.mark.proof(reads=READS)
@each_task
def test_a_function_that_ignores_its_input_earns_nothing(stem, file):
    task = task_in(stem, file)
    if task.inputs is None:
        return
    with in_process_ros():
        made = task_cases(task, PUBLIC_SEED if task.is_costly else "habits", solution_of(stem), variants=1)
    cases = made.variants[0].cases
    constants = [[case.expected] * len(cases) for case in cases]
    echoes = [[case.args[place] for case in cases] for place in range(min(len(case.args) for case in cases))]
    for outcomes in constants + echoes:
        assert judge_outcomes(made, made.variants[0], outcomes).passed == 0


@each_task
def test_a_task_has_variants_and_mistakes_and_texts_in_english_and_korean(stem, file):
    task = task_in(stem, file)
    for text in [task.title, *task.hints, *(mistake.reply for mistake in task.mistakes)]:
        assert re.search("[가-힣]", text.ko), f"not in Korean: {text.ko}"
        assert not re.search("[가-힣]", text.en), f"not in English: {text.en}"
    assert len({text.en for text in task.hints}) == (0 if task.counts else 3)
    if task.kind in "NFT":
        assert task.variants >= 3 or task.inputs is not None
        assert task.mistakes
    assert form_from_plain(task.form.plain()) == task.form


@pytest.mark.parametrize("stem", STEMS)
def test_a_chapter_has_five_to_eight_graded_tasks_in_order(stem):
    tasks = read_tasks(SOLUTIONS / "tasks" / stem)
    ids = [task.id for task in tasks]
    assert stem == "00_start" or 5 <= sum(not task.counts for task in tasks) <= 8
    assert ids == [f"E{int(stem[:2])}.{number}" for number in range(1, len(ids) + 1)]


@pytest.mark.proof(reads=READS)
@each_task
def test_a_secret_seed_makes_other_cases(stem, file):
    task = task_in(stem, file)
    if task.inputs is None or task.is_costly:
        return  # only a function has cases that nobody sees
    with in_process_ros():
        secret = task_cases(task, "x", solution_of(stem), variants=1)
    hidden = [case.args for case in secret.variants[0].cases]
    assert any(case.args not in hidden for case in cases_of(stem, file, 1).variants[0].cases)
