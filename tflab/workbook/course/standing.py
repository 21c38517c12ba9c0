"""What has a learner shown?  Passed checks, laid over the course: chapters, objectives, checklist.

    passed      every task of it has been passed
    open        its tasks are here; some are not passed yet
    later       a task of it is in a chapter that this workbook does not have

Nothing is ticked by reading, by trying, or by hand.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from ...text import Text
from ..paths import chapters, read_workbook, workbook_data, workbook_root
from ..progress import Attempts, read_progress
from ..tasks.catalog import task_ids, tasks_of
from ..tasks.task import TaskError
from .course import Chapter, Goal, read_course

__all__ = ["ChapterStanding", "GoalStanding", "Standing", "TaskStanding", "standing"]


class TaskStanding(NamedTuple):
    """One task, and what was done with it."""

    id: str
    title: Text
    points: float
    attempts: Attempts


class ChapterStanding(NamedTuple):
    """A chapter, and its tasks if the workbook has them."""

    chapter: Chapter
    tasks: tuple[TaskStanding, ...]

    @property
    def passed(self) -> int:
        """Return how many tasks are passed."""
        return sum(task.attempts.passed for task in self.tasks)


class GoalStanding(NamedTuple):
    """An objective or an item of the checklist; each task is passed, not passed, or None where it is not here."""

    goal: Goal
    tasks: dict[str, bool | None]

    @property
    def state(self) -> str:
        """Return "passed", "open" or "later"."""
        if all(self.tasks.values()):
            return "passed"
        return "open" if any(passed is False for passed in self.tasks.values()) else "later"

    @property
    def here(self) -> list[str]:
        """Return the tasks that this workbook has."""
        return [name for name, passed in self.tasks.items() if passed is not None]

    @property
    def passed(self) -> int:
        """Return how many tasks are passed."""
        return sum(bool(passed) for passed in self.tasks.values())


@dataclass(frozen=True)
class Standing:
    """All of it, in the course's order."""

    language: str
    chapters: tuple[ChapterStanding, ...]
    objectives: tuple[GoalStanding, ...]
    checklist: tuple[GoalStanding, ...]

    @property
    def tasks(self) -> list[TaskStanding]:
        """Return the tasks of all chapters."""
        return [task for chapter in self.chapters for task in chapter.tasks]


def standing(root: Path | None = None) -> Standing:
    """Return what was shown in the workbook at `root`, the nearest if left out.

    Raises:
        WorkbookError: its `workbook.json` cannot be read.
    """
    root = root or workbook_root()
    language = read_workbook(root).language
    course = read_course()
    attempts = read_progress(root)
    here = {stem: _tasks(root, stem, attempts) for stem in chapters(root)}
    passed = {task.id: task.attempts.passed for tasks in here.values() for task in tasks}
    objectives, checklist = (
        tuple(GoalStanding(goal, {task: passed.get(task) for task in goal.tasks}) for goal in goals)
        for goals in (course.objectives, course.checklist)
    )
    return Standing(
        language,
        tuple(ChapterStanding(chapter, here.get(chapter.stem, ())) for chapter in course.chapters),
        objectives,
        checklist,
    )


def _tasks(root: Path, stem: str, attempts: dict[str, Attempts]) -> tuple[TaskStanding, ...]:
    try:
        found = tasks_of(workbook_data(), stem)
    except TaskError:
        return ()
    return tuple(
        TaskStanding(name, found[name].title, found[name].points, attempts.get(name, Attempts()))
        for name in task_ids(workbook_data(), stem, read_workbook(root))
    )
