"""A chapter of four tasks for tests, one of them with a YAML file, and its solution."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
import yaml

from tflab.workbook.answers.forms import Form
from tflab.workbook.paths import Workbook, write_workbook
from tflab.workbook.tasks import Text, generate_cases
from tflab.workbook.tasks.case_types import Case, TaskCases, Variant
from tflab.workbook.tasks.catalog import assigned_cases, question_digest, task_ids
from tflab.workbook.tasks.reference import in_process_ros, solution_in_notebook
from tflab.workbook.tasks.task import read_tasks

from .making_pages import write_tasks

STEM = "03_small"
TASKS = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))["tasks"]
CELLS = {
    "load": "%load_ext tflab\nfrom tflab.workbook import check, hint, task",
    "imports": "import math",
    "e3-1-answer": "base_p_corner = e3_1.base_T_laser.apply(e3_1.laser_p_corner)",
    "e3-2-answer": "def invert(transform):\n    return transform.inverse()",
    "e3-3-answer": 'roles = {"target": "map", "source": "laser"}',
    "e3-4-answer": "angle_rad = math.pi / 2",
}


def make_cases(seed, solutions, **options):
    """Return the tasks of the chapter with their cases, by id; `options` as of `task_cases`."""
    solution = solution_in_notebook(solutions / "en" / f"{STEM}.ipynb")
    with in_process_ros():
        tasks = read_tasks(solutions / "tasks" / STEM)
        return {task.id: generate_cases.task_cases(task, seed, solution, **options) for task in tasks}


class StoredPairs:
    """A search for pairs that knows what each pair gives: the mistakes of which a name has " + " in it."""

    def __init__(self, rows):
        self.rows = {name: row for name, row in rows.items() if " + " in name}

    def matching(self, cases, order, reproduced_by, given):
        def common(row):
            return set.intersection(*(set(reproduced_by(number, row[number])) for number in order))

        return {name: row for name, row in self.rows.items() if common(row)}


def bare(form: Form, *cases: Case, is_function: bool = False) -> tuple[TaskCases, Variant]:
    """Return a task that has nothing but a form and these cases, and its only variant."""
    variant = Variant(None, cases)
    none = Text("", "")
    return TaskCases("N", 1, "answer", is_function, none, form, (none,) * 3, (), {}, (variant,)), variant


def lay_out(folder: Path, *, tasks: str = TASKS, cells: dict[str, str] = CELLS) -> Path:
    """Write the task files and the solution into `folder`, which stands for `solutions/`."""
    write_tasks(folder / "tasks" / STEM, tasks)
    (folder / "en").mkdir(parents=True, exist_ok=True)
    notebook = {"cells": [{"cell_type": "code", "id": name, "source": [text]} for name, text in cells.items()]}
    (folder / "en" / f"{STEM}.ipynb").write_text(json.dumps(notebook), encoding="utf-8")
    return folder


def copy_of_workbook(
    folder: Path,
    monkeypatch: pytest.MonkeyPatch,
    *,
    language: str = "en",
    learner: str | None = None,
    edition: str = "self-study",
    seed: str = "",
) -> Path:
    """Make the chapter tflab's own workbook, for as long as the test lasts; return a learner's copy of it."""
    data, root = folder / "workbook", folder / "copy"
    lay_out(data / "solutions")
    monkeypatch.setenv("TFLAB_WORKBOOK", str(data))
    root.mkdir(parents=True)
    workbook = Workbook(edition=edition, language=language, learner=learner, seed=seed)
    if edition == "class":
        assigned = {name: assigned_cases(data, STEM, name, workbook) for name in task_ids(data, STEM)}
        digests = {name: question_digest(task, task.variants[0]) for name, task in assigned.items()}
        workbook = replace(workbook, questions=digests)
    write_workbook(root, workbook)
    return root
