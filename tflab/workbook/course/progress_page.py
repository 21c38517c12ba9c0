"""Show what a learner has passed: `tflab progress` in a terminal, `show_progress()` in a notebook.

    03  Target and source        ■ ■ ■ □ ◧ □ □   3/7
    to come: 01, 04

An objective or an item of the checklist is in one of three states:

    passed      every task of it has been passed
    open        its tasks are here; some are not passed yet
    later       a task of it is in a chapter that this workbook does not have

Only a passed check changes a state.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from tflab.views.report_page import render

from ...text import Text, Texts
from ..inventory.participation import RevealedForms, pending_notice, revealed_forms
from ..paths import (
    COPY,
    MARK,
    NO_COPY,
    WorkbookError,
    chapters,
    copy_at_hand,
    exercise_file,
    read_workbook,
    workbook_data,
    workbook_root,
)
from ..progress import Attempts, read_progress
from ..tasks.catalog import task_ids, tasks_of
from ..tasks.task import TaskError
from .course import Chapter, Goal, read_course

__all__ = [
    "ChapterProgress",
    "CourseProgress",
    "GoalProgress",
    "ProgressPage",
    "TaskProgress",
    "course_progress",
    "progress",
    "show_progress",
]


class TaskProgress(NamedTuple):
    """One task, and what was done with it."""

    id: str
    title: Text
    points: float
    attempts: Attempts


class ChapterProgress(NamedTuple):
    """A chapter, and its tasks if the workbook has them."""

    chapter: Chapter
    tasks: tuple[TaskProgress, ...]

    @property
    def passed(self) -> int:
        """Return how many tasks are passed."""
        return sum(task.attempts.passed for task in self.tasks)


class GoalProgress(NamedTuple):
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
class CourseProgress:
    """All of it, in the course's order."""

    language: str
    chapters: tuple[ChapterProgress, ...]
    objectives: tuple[GoalProgress, ...]
    checklist: tuple[GoalProgress, ...]

    @property
    def tasks(self) -> list[TaskProgress]:
        """Return the tasks of all chapters."""
        return [task for chapter in self.chapters for task in chapter.tasks]


def course_progress(root: Path | None = None) -> CourseProgress:
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
        tuple(GoalProgress(goal, {task: passed.get(task) for task in goal.tasks}) for goal in goals)
        for goals in (course.objectives, course.checklist)
    )
    return CourseProgress(
        language,
        tuple(ChapterProgress(chapter, here.get(chapter.stem, ())) for chapter in course.chapters),
        objectives,
        checklist,
    )


def _tasks(root: Path, stem: str, attempts: dict[str, Attempts]) -> tuple[TaskProgress, ...]:
    try:
        found = tasks_of(workbook_data(), stem)
    except TaskError:
        return ()
    return tuple(
        TaskProgress(name, found[name].title, found[name].points, attempts.get(name, Attempts()))
        for name in task_ids(workbook_data(), stem, read_workbook(root))
    )


TEXTS = Texts(__file__)
PASSED, TRIED, UNTRIED = "■", "◧", "□"
STATES = {"passed": "✓", "open": "○"}


class ProgressPage:
    """A learner's progress, to be shown as HTML in a notebook and as text in a terminal.

    Before the first try it is one line, and the task to start with.

    Args:
        shown: what was passed.
        kept: whether progress is stored here.
        forms: the inventory's results, or a line about it.
    """

    def __init__(self, shown: CourseProgress, kept: bool = True, forms: RevealedForms | str = "") -> None:
        self._shown, self._kept, self._forms = shown, kept, forms
        self._language = shown.language

    def _repr_mimebundle_(self, include=None, exclude=None) -> dict[str, str]:
        return {"text/html": self.html, "text/plain": self.text}

    @property
    def text(self) -> str:
        """Return it as a terminal shows it."""
        label = self._labels()
        lines = [f"{label['title']}: {self._sum()}", self._note()]
        if not self._started:
            return "\n".join(lines)
        lines += ["", f"{label['chapters']} ({label['squares']})"]
        for chapter in self._here:
            marks = " ".join(_mark(task) for task in chapter.tasks)
            count = f"{chapter.passed}/{len(chapter.tasks)}"
            title = chapter.chapter.title.say(self._language)
            lines.append(f"  {chapter.chapter.stem[:2]}  {marks}   {count}   {title}")
        lines += [f"  {line}" for line in self._to_come()]
        forms = self._forms if isinstance(self._forms, str) else self._forms.summary
        lines += ["", forms] if forms else []
        for title, goals in self._goals():
            lines += ["", f"{title} ({label['ticks']})"]
            for name, goal in goals:
                lines.append(f"  {STATES[goal.state]} {name:>3}  {goal.goal.words.say(self._language)}")
                lines += [f"        {line}" for line in self._details(goal)]
        return "\n".join(lines)

    @property
    def html(self) -> str:
        """Return it as a notebook shows it, in the notebook's own colours."""
        return render(
            __file__,
            label=self._labels(),
            language=self._language,
            sum=self._sum(),
            note=self._note(),
            started=self._started,
            chapters=self._here,
            mark=_mark,
            describe_task=self._describe_task,
            to_come=list(self._to_come()),
            forms=self._forms,
            goals=self._goals(),
            signs=STATES,
            details=self._details,
        )

    def _labels(self) -> dict[str, str]:
        return {key: self._say(key) for key in ("title", "chapters", "squares", "ticks")}

    def _goals(self) -> list[tuple[str, list[tuple[str, GoalProgress]]]]:
        """Return the objectives, 1 to 8, and the checklist, C1 to C14, without goals whose tasks are not here."""
        both = (("objectives", "", self._shown.objectives), ("checklist", "C", self._shown.checklist))
        return [
            (self._say(title), [(f"{c}{n}", goal) for n, goal in enumerate(goals, start=1) if goal.state != "later"])
            for title, c, goals in both
        ]

    def _details(self, goal: GoalProgress) -> Iterator[str]:
        """Yield what is left to pass, and what to type on a robot."""
        absent = len(goal.tasks) - len(goal.here)
        if goal.state == "open":
            left = [name for name in goal.here if not goal.tasks[name]]
            rest = self._say("rest_later", count=absent)
            passed = self._say("passed_of", passed=goal.passed, of=len(goal.tasks))
            to_pass = self._say("to_pass")
            yield f"{passed} · {to_pass}: {' '.join(left)}{f' ({rest})' if absent else ''}"
        if goal.goal.robot:
            yield self._say("on_a_robot" if goal.state == "passed" else "will_robot") + ":"
            yield from (f"$ {command}" for command in goal.goal.robot)

    def _describe_task(self, task: TaskProgress) -> str:
        title = f"{task.id} · {task.title.say(self._language)}"
        if task.attempts.tries or task.attempts.hints:
            title += " · " + self._say("tries", tries=task.attempts.tries, hints=task.attempts.hints)
        return title

    @property
    def _here(self) -> list[ChapterProgress]:
        """Return the chapters that have tasks."""
        return [chapter for chapter in self._shown.chapters if chapter.tasks]

    def _to_come(self) -> Iterator[str]:
        """Yield the chapters that are not here yet, in one line, if there are any."""
        absent = [each.chapter.stem[:2] for each in self._shown.chapters if each.chapter.number and not each.tasks]
        if absent:
            yield self._say("later") + ": " + ", ".join(absent)

    def _sum(self) -> str:
        tasks = self._shown.tasks
        return self._say("tasks_passed", passed=sum(task.attempts.passed for task in tasks), of=len(tasks))

    @property
    def _started(self) -> bool:
        return any(task.attempts.tries for task in self._shown.tasks)

    def _note(self) -> str:
        """Return which task comes next, or that this is no copy; nothing if all tasks are passed."""
        if not self._kept:
            return self._say("no_copy")
        tasks = ((each, task) for each in self._here if each.chapter.number for task in each.tasks)
        for each, task in tasks:
            if not task.attempts.passed:
                title, file = task.title.say(self._language), exercise_file(each.chapter.stem)
                return self._say("next", task=task.id, title=title, file=f"exercises/{self._language}/{file}")
        return ""

    def _say(self, key: str, **names: object) -> str:
        return TEXTS[key].say(self._language, **names)


def show_progress() -> ProgressPage:
    """Return where you stand in the nearest workbook, to be shown as the last value of a cell."""
    return _page(workbook_root())


def progress(words: Sequence[str]) -> int:
    """Print where one stands, and return 0; 2 if the workbook cannot be read."""
    parser = argparse.ArgumentParser(
        prog="tflab progress", description="Show what you have passed and what comes next."
    )
    parser.add_argument("folder", nargs="?", metavar="DIR", help=f"your copy (default: the nearest one, or ./{COPY})")
    folder = parser.parse_args(list(words)).folder
    root = Path(folder) if folder else copy_at_hand()
    if root is None or not (root / MARK).is_file():
        print(f"tflab progress: {NO_COPY.format(folder=folder or 'here')}", file=sys.stderr)
        return 2
    try:
        print(_page(root).text)
    except WorkbookError as error:
        print(f"tflab progress: {error}", file=sys.stderr)
        return 2
    return 0


def _page(root: Path) -> ProgressPage:
    shown = course_progress(root)
    forms = revealed_forms(root, shown.language) or pending_notice(root, shown.language)
    return ProgressPage(shown, kept=(root / MARK).is_file(), forms=forms)


def _mark(task: TaskProgress) -> str:
    return PASSED if task.attempts.passed else TRIED if task.attempts.tries else UNTRIED
