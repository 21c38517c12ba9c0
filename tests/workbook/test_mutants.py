"""Solutions spoilt on purpose: which there are, and that none of a chapter's functions passes hidden cases either."""

from __future__ import annotations

import pytest

from tflab.workbook.places import workbook_data
from tflab.workbook.tasks.cases import task_cases
from tflab.workbook.tasks.mutants import mutants_of, survivors
from tflab.workbook.tasks.reference import in_process_ros, solution_in_notebook
from tflab.workbook.tasks.task import read_tasks

SOLUTIONS = workbook_data() / "solutions"
STEMS = sorted(path.name for path in (SOLUTIONS / "tasks").glob("[0-9]*"))
FUNCTIONS = [(stem, task) for stem in STEMS for task in read_tasks(SOLUTIONS / "tasks" / stem) if task.inputs]


@pytest.mark.parametrize(
    ("source", "mutant"),
    [
        ("y = x < 2", "y = x <= 2"),
        ("y = x < 2", "y = x < 3"),
        ("y = a + b", "y = a - b"),
        ("y = -x", "y = x"),
        ("y = a and b", "y = a or b"),
        ("y = sin(x)", "y = cos(x)"),
        ("y = t.inverse()", "y = t"),
        ("y = abs(x)", "y = x"),
        ("y = f(a, b)", "y = f(b, a)"),
        ("y = 0.5", "y = 0.5005"),
        ("if a:\n    b()", "if True:\n    b()"),
    ],
)
def test_a_solution_is_spoilt_in_one_place(source, mutant):
    assert mutant in [one.source for one in mutants_of(source)]


@pytest.mark.parametrize(("stem", "task"), FUNCTIONS, ids=[task.id for _, task in FUNCTIONS])
def test_no_spoilt_function_passes_cases_of_another_seed(stem, task):
    solution = solution_in_notebook(SOLUTIONS / "en" / f"{stem}.ipynb")
    with in_process_ros():
        made = task_cases(task, "hidden from mutants", solution, 1, fewest_inputs=8)
        assert set(survivors(task, made.variants, solution)) <= set(task.equivalent)
