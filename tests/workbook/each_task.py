"""Run a test with every task: ids come from file names, tasks are read in the test.

@pytest.mark.proof(reads=READS)
@each_task
def test_x(stem, file, sample):
    task = task_in(stem, file)
"""

from __future__ import annotations

from functools import lru_cache

import pytest

from tflab.workbook.paths import workbook_data
from tflab.workbook.tasks.case_types import TaskCases
from tflab.workbook.tasks.generate_cases import PUBLIC_SEED, task_cases
from tflab.workbook.tasks.reference import Solution, in_process_ros, solution_in_notebook
from tflab.workbook.tasks.task import Task, read_tasks

SOLUTIONS = workbook_data() / "solutions"
STEMS = sorted(path.name for path in (SOLUTIONS / "tasks").glob("[0-9]*"))
FILES = [
    (stem, path.stem)
    for stem in STEMS
    for path in sorted((SOLUTIONS / "tasks" / stem).glob("e*_*.py"), key=lambda path: (len(path.stem), path.stem))
]
each_task = pytest.mark.parametrize(("stem", "file"), FILES, ids=[file.replace("_", ".").upper() for _, file in FILES])

# What a test of one task reads: its file, what the files of a chapter share, and the worked solution.
READS = (
    "solutions/tasks/{stem}/{file}.*",
    "solutions/tasks/{stem}/[!e]*",
    "solutions/en/{stem}.ipynb",
    "solutions/inventory.yaml",
)


def task_in(stem: str, file: str) -> Task:
    (task,) = (task for task in _tasks(stem) if task.id == file.replace("_", ".").upper())
    return task


@lru_cache(maxsize=1)
def _tasks(stem: str) -> list[Task]:
    return list(read_tasks(SOLUTIONS / "tasks" / stem))


@lru_cache(maxsize=1)
def solution_of(stem: str) -> Solution:
    return solution_in_notebook(SOLUTIONS / "en" / f"{stem}.ipynb")


@lru_cache(maxsize=1)
def cases_of(stem: str, file: str, variants: int | None = None) -> TaskCases:
    """Return the public cases of a task, as a learner's `check` sees them."""
    with in_process_ros():
        return task_cases(task_in(stem, file), PUBLIC_SEED, solution_of(stem), variants)
