"""The verdict on a whole answer, as a learner writes it or as Python has it."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from types import SimpleNamespace
from typing import Any

from tflab.workbook.answers.values import from_plain, outcome_of
from tflab.workbook.diagnosis.verdict import Verdict, judge_outcomes
from tflab.workbook.paths import chapters, stems_called, workbook_data
from tflab.workbook.tasks.case_types import TaskCases
from tflab.workbook.tasks.catalog import solution_of, tasks_of
from tflab.workbook.tasks.generate_cases import PUBLIC_SEED, make_variant, outline_of
from tflab.workbook.tasks.reference import in_process_ros

IMPORTS = """
import math, re
from types import SimpleNamespace
from rclpy.time import Time
from tf2_ros import ConnectivityException, ExtrapolationException, InvalidArgumentException, LookupException
"""


@cache
def task_of(task_id: str, variant: int = 0) -> TaskCases:
    """Return a task with one of its public variants."""
    data = workbook_data()
    (stem,) = stems_called([task_id.partition(".")[0]], chapters())
    task = tasks_of(data, stem)[task_id]
    with in_process_ros():
        return outline_of(task)._replace(variants=(make_variant(task, PUBLIC_SEED, variant, solution_of(data, stem)),))


def verdict_on(task_id: str, answer: str | Callable[..., Any], variant: int = 0) -> Verdict:
    """Return the verdict on an answer's cell, in which what is given is `given`; or on a function, or what it makes
    of what is given.
    """
    task = task_of(task_id, variant)
    (drawn,) = task.variants
    given = SimpleNamespace(**{name: from_plain(value) for name, value in (drawn.given or {}).items()})
    with in_process_ros():
        if isinstance(answer, str):
            names = {"given": given}
            exec(IMPORTS + answer, names)
            answer = names[task.answer]
        elif not task.is_function:
            answer = answer(given)
        outcomes = [
            outcome_of(answer, case.args) if task.is_function else outcome_of(lambda: answer, ())
            for case in drawn.cases
        ]
    return judge_outcomes(task, drawn, outcomes)
