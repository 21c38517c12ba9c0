"""Read the course: chapters, objectives, checklist and practice questions.

    chapters        stem, title, the one question, what it builds on
    objectives      each with the tasks that show it
    checklist       each with the tasks that tick it, and what to type on a robot
    questions       the practice questions at the chapters' ends

All of it is in `course.yaml`.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import NamedTuple

from ...text import Text, load_yaml

__all__ = ["COURSE", "Chapter", "Course", "Goal", "read_course"]

COURSE = Path(__file__).with_name("course.yaml")


class Chapter(NamedTuple):
    """One chapter; `builds_on` holds chapter numbers, the rest counts as the lecture does.

    `minutes` is for whoever reads it alone; in a class it is talked about for `talk` minutes, and
    worked at for `lab` minutes.
    """

    stem: str
    title: Text
    question: Text
    minutes: int
    builds_on: tuple[int, ...]
    sections: tuple[int, ...]
    objectives: tuple[int, ...]
    practice: tuple[int, ...]
    talk: int
    lab: int

    @property
    def number(self) -> int:
        """Return 3 of "03_target_and_source"."""
        return int(self.stem[:2])


class Goal(NamedTuple):
    """An objective or an item of the checklist: what it says, what shows it, what to type on a robot."""

    words: Text
    tasks: tuple[str, ...]
    robot: tuple[str, ...] = ()


class Course(NamedTuple):
    """The whole course, in order."""

    chapters: tuple[Chapter, ...]
    objectives: tuple[Goal, ...]
    checklist: tuple[Goal, ...]
    questions: tuple[Text, ...]


@cache
def read_course() -> Course:
    """Return the course as `course.yaml` has it."""
    found = load_yaml(COURSE.read_text(encoding="utf-8"))
    return Course(
        tuple(_chapter(line) for line in found["chapters"]),
        tuple(_goal(line) for line in found["objectives"]),
        tuple(_goal(line) for line in found["checklist"]),
        tuple(Text(line["en"], line["ko"]) for line in found["practice"]),
    )


def _chapter(line: dict) -> Chapter:
    numbers = [tuple(line[name]) for name in ("builds_on", "sections", "objectives", "practice")]
    words = Text(**line["title"]), Text(**line["question"])
    return Chapter(line["stem"], *words, line["minutes"], *numbers, *line["taught"])


def _goal(line: dict) -> Goal:
    return Goal(Text(line["en"], line["ko"]), tuple(line["tasks"]), tuple(line.get("robot", ())))
