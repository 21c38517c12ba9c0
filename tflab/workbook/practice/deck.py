"""What can be asked?  The course's tasks, as far as a learner has come, each drawn anew from a number.

    items(root)            tasks of the chapters up to the furthest in which something was checked
    drawn(item, 18)        the task with numbers of its own: question 18 is the same everywhere

The numbers come from the same generators as a class's, with a seed that is no
secret; the right answer and what each mistake gives come from the same solution.
What takes minutes to draw is left out, patients without end are in chapter 12; and so
is the test of before and after, which is asked twice and no more.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from ..mistakes.fitting import words_of
from ..places import chapters, workbook_data
from ..progress import Attempts, read_progress
from ..tasks.case_types import TaskCases
from ..tasks.catalog import outlines, solution_of, tasks_of
from ..tasks.generate_cases import PUBLIC_SEED, CasesError, task_cases
from ..tasks.reference import in_process_ros
from ..tasks.task import Task, TaskError

__all__ = ["Askable", "drawn", "items", "reached", "shown_in_exercises"]

SEED = "practice"
MOST_DRAWS = 5  # before one that came with the exercises is taken


class Askable(NamedTuple):
    """A task that can be asked, and the ideas that it looks for, those first that it is there for."""

    stem: str
    task: Task
    ideas: tuple[str, ...]


def items(stems: Sequence[str]) -> dict[str, Askable]:
    """Return what can be asked in these chapters, by the task's id."""
    found = [Askable(stem, task, _ideas(task)) for stem in stems for task in tasks_of(workbook_data(), stem).values()]
    return {item.task.id: item for item in found if not item.task.is_costly and not item.task.counts}


def reached(root: Path) -> list[str]:
    """Return the chapters up to the furthest in which an answer was checked; the first one if none was."""
    tried = {task.partition(".")[0] for task, attempts in read_progress(root).items() if attempts.tries}
    there = [stem for stem in chapters(root) if items([stem])]
    far = max((number for number, stem in enumerate(there) if f"E{int(stem[:2])}" in tried), default=0)
    return there[: far + 1]


def shown_in_exercises(root: Path) -> dict[str, int]:
    """Return how often each misconception was named by `check`."""
    counts: dict[str, int] = {}
    progress = read_progress(root)
    for stem in chapters(root):
        named = {task: tried for task, tried in progress.items() if tried.twins and _is_of(task, stem)}
        with suppress(TaskError):
            tasks = outlines(workbook_data(), stem) if named else {}
            for task, tried in named.items():
                for misconception, count in _misconceptions(tasks.get(task), tried):
                    counts[misconception] = counts.get(misconception, 0) + count
    return counts


def drawn(stem: str, task_id: str, number: int) -> TaskCases:
    """Return a task with the one variant that belongs to a question's number."""
    return _drawn(workbook_data(), stem, task_id, number)


@lru_cache(maxsize=8)
def _drawn(data: Path, stem: str, task_id: str, number: int) -> TaskCases:
    task, solution = tasks_of(data, stem)[task_id], solution_of(data, stem)
    with in_process_ros():
        for draw in range(MOST_DRAWS):
            with suppress(CasesError):  # numbers that do not tell two mistakes apart: others, then
                return task_cases(task, f"{SEED}/{number}/{draw}", solution, variants=1)
        return task_cases(task, PUBLIC_SEED, solution, variants=1)


def _misconceptions(task: TaskCases | None, tried: Attempts) -> list[tuple[str, int]]:
    found = []
    for twin, count in tried.twins.items():
        with suppress(KeyError):  # a mistake that this version does not know
            misconception = words_of(task, twin).misconception if task else ""
            found += [(misconception, count)] if misconception else []
    return found


def _is_of(task_id: str, stem: str) -> bool:
    return task_id.partition(".")[0] == f"E{int(stem[:2])}"


def _ideas(task: Task) -> tuple[str, ...]:
    named = [*task.misconceptions, *(twin.misconception for twin in task.mistakes if twin.misconception)]
    return tuple(dict.fromkeys(named)) or (task.id,)
