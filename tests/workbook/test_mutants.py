"""Corrupted and blind solutions: how they are made, and that none passes the hidden cases of a task."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from tflab.workbook.tasks.generate_cases import task_cases
from tflab.workbook.tasks.reference import in_process_ros

from .blind import answers_by_place, blind_survivors
from .each_task import READS, each_task, solution_of, task_in
from .mutants import mutants_of, survivors

MOST = 20  # mutants of a task, while nothing is proved anew
CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))


@pytest.mark.parametrize(("source", "mutant"), CASES["mutants"])
def test_a_mutant_differs_in_one_place(source, mutant):
    assert mutant in [one.source for one in mutants_of(source)]


@pytest.mark.proof(reads=READS)
@each_task
def test_no_mutant_passes_cases_of_another_seed(stem, file, sample):
    task = task_in(stem, file)
    if task.inputs is None:
        return  # only a function has mutants
    with in_process_ros():
        made = task_cases(task, "hidden from mutants", solution_of(stem), 1, fewest_inputs=8)
        passed = survivors(task, made.variants, solution_of(stem), lambda mutants: sample(mutants, MOST))
    assert set(passed) <= set(task.equivalent)


@pytest.mark.proof(reads=READS)
@each_task
def test_no_blind_answer_passes_cases_of_another_seed(stem, file):
    task = task_in(stem, file)
    if task.inputs is None and (task.given is None or task.kind != "N"):
        return  # a choice may be the same for all
    with in_process_ros():
        made = task_cases(task, "hidden from the blind", solution_of(stem), None if task.kind == "N" else 1).variants
        if task.inputs is None:
            passed = answers_by_place(task, [({"dict": each.given}, each.cases[0].expected) for each in made])
        else:
            right = solution_of(stem).answer(task, None)
            passed = blind_survivors(task, right, made[0].cases)
    assert set(passed) <= set(task.equivalent)
