"""Define AssignedTask: a task with one learner's variant and language."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from ..text import Text
from .paths import Workbook
from .phrases import PHRASES, show_points
from .tasks.case_types import TaskCases, Variant

__all__ = ["AssignedTask"]


class AssignedTask(NamedTuple):
    """A task as this learner has it: with their variant of it."""

    id: str
    stem: str
    cases: TaskCases
    variant: Variant
    root: Path
    workbook: Workbook

    def score(self, passed: int, of: int) -> str:
        """Return the points that `passed` right parts `of` all earn, as grading counts them: "1.57/3 points"."""
        return show_points(self.cases.points * passed / of, self.cases.points).say(self.workbook.language)

    def phrase(self, name: str, **names: object) -> str:
        """Return one of the phrases in the learner's language."""
        return self.words(PHRASES[name], id=self.id, answer=self.cases.answer, **names)

    def words(self, words: Text, **names: object) -> str:
        """Return a text in the learner's language."""
        return words.say(self.workbook.language, **names)
