"""A chapter of four tasks for tests, one of them with a YAML file, and its solution."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
from making_pages import write_tasks

from tflab.workbook.answers.forms import Form
from tflab.workbook.paths import Workbook, write_workbook
from tflab.workbook.tasks import Text, generate_cases
from tflab.workbook.tasks.case_types import Case, TaskCases, Variant
from tflab.workbook.tasks.catalog import assigned_cases, question_digest, task_ids
from tflab.workbook.tasks.reference import in_process_ros, solution_in_notebook
from tflab.workbook.tasks.task import read_tasks

STEM = "03_small"
TASKS = """
# -- draws.py
import math
from tflab.core import Transform
from tflab.workbook.tasks import Choice, Number, Parts, Pose, Task, WrongAnswer, Vector, Text, define_task

HINTS = tuple(Text(en=f"hint {n}", ko=f"힌트 {n}") for n in (1, 2, 3))


def mount(rng):
    mounted = Transform.from_rpy(yaw=round(float(rng.uniform(0.5, 2.6)), 2), translation=(0.2, 0.0, 0.15))
    return {"base_T_laser": mounted, "laser_p_corner": (2.0, 0.5, 0.0)}


def transforms(rng):
    return [(Transform.from_rpy(*rng.uniform(0.3, 1.2, 3), translation=rng.uniform(1, 2, 3)),) for _ in range(4)]


def swapped(given):
    return given.base_T_laser.inverse().apply(given.laser_p_corner)


def minus(T):
    return Transform([-x for x in T.translation], T.rotation)


def both(en):
    return Text(en=en, ko="한국어: " + en)


FRAME = Choice(("map", "laser"))
# -- e3_1.py
from .draws import *

TASK = Task("E3.1", "N", 3, both("corner"), "base_p_corner", Vector(3, "m", "base_link", 0.005), HINTS,
         given=mount, variants=3, mistakes=(WrongAnswer("swapped", swapped, both("that is the inverse"), "M1"),))
# -- e3_2.py
from .draws import *

TASK = Task("E3.2", "F", 2, both("invert"), "invert", Pose(), HINTS,
         inputs=transforms, mistakes=(WrongAnswer("minus", minus, both("only the sign"), "M3"),))
# -- e3_3.py
from .draws import *

TASK = define_task(
    __file__, kind="M", points=2, answer="roles", form=Parts({"target": FRAME, "source": FRAME})
)
# -- e3_3.yaml
title: {en: roles, ko: "한국어: roles"}
hints: [{en: hint 1, ko: 힌트 1}, {en: hint 2, ko: 힌트 2}, {en: hint 3, ko: 힌트 3}]
mistakes:
  - name: swapped
    answer: {target: laser, source: map}
    misconception: M1
    partly: true
    en: turned round
    ko: "한국어: turned round"
# -- e3_4.py
from .draws import *

TASK = Task("E3.4", "N", 1, both("angle"), "angle_rad", Number("rad", 0.01), HINTS)
"""
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
