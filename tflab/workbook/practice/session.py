"""How does one practise?  Ask, answer, hear what it was, and what comes next; all of it in the copy.

    session = Session(root)
    question = session.question()              the open one, or a new one
    result = session.answer(question, corner)  judged as `check` does; a pass, or `leave`, closes it

Nothing here writes `progress.json`: what is practised ticks nothing and costs nothing.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

from ..answers.values import Plain
from ..places import WorkbookError, read_workbook, stems_called, workbook_data
from ..progress import mark_of
from ..trying import AssignedTask, tried_on
from ..verdicts.mistake import Mistake
from ..verdicts.verdict import Verdict
from .deck import Askable, items, reached, shown_in_exercises
from .kept import Kept, Open, Practised, change_kept, read_kept
from .question import DrawnQuestion, question_of
from .spacing import Idea, after, choose

__all__ = ["Result", "Session", "known_of"]

# Not an answer yet, or one of another form: it shows nothing of the idea.
NO_ANSWER = (
    Mistake.UNANSWERED, Mistake.MISSING_PARTS, Mistake.INTERRUPTED, Mistake.NOT_A_FUNCTION, Mistake.A_FUNCTION,
    Mistake.TYPE, Mistake.SHAPE, Mistake.OPTION,
)  # fmt: skip


class Result(NamedTuple):
    """What became of an answer.

    Attributes:
        kept: what is known now.
        is_over: whether the question is closed.
    """

    assigned: AssignedTask
    verdict: Verdict
    outcomes: list[Plain]
    kept: Kept
    is_over: bool


class Session:
    """One learner's practice.

    Args:
        root: of the copy, or of tflab's own workbook.
        chapters: which to ask about, "03"; those that have been reached if empty.

    Raises:
        WorkbookError: there is no such chapter, or none with tasks.
    """

    def __init__(self, root: Path, chapters: Sequence[str] = ()) -> None:
        self.root = Path(root)
        self.workbook = read_workbook(root)
        self._there = sorted(path.name for path in (workbook_data() / "solutions" / "tasks").glob("[0-9]*"))
        try:
            self.stems = stems_called(chapters, self._there, what="chapter") if chapters else reached(self.root)
        except LookupError as nothing:
            raise WorkbookError(str(nothing)) from None
        self._is_chosen = bool(chapters)
        self._items = items(self.stems)
        if not self._items:
            raise WorkbookError("there are no tasks to practise here; `tflab lab --update` brings back what is missing")

    @property
    def kept(self) -> Kept:
        """Return what is known of this learner."""
        return known_of(self.root)

    def question(self) -> DrawnQuestion:
        """Return the open question, or a new one."""
        kept = change_kept(self.root, self._opened)
        assert kept.open is not None
        item = self._item(kept.open.task)
        assert item is not None
        return question_of(kept.open, item, self.workbook.language)

    def answer(self, question: DrawnQuestion, answer: Any) -> Result:
        """Judge an answer, and write down what it shows."""
        assigned = self.assigned(question)
        verdict, outcomes = tried_on(assigned, answer)
        if verdict.mistake in NO_ANSWER:
            return Result(assigned, verdict, outcomes, self.kept, False)
        shown = {words.misconception for words in verdict.slips.values() if words.misconception}
        passed, mark = verdict.mistake is None, mark_of(outcomes or [str(verdict.mistake)])

        def answered(kept: Kept) -> Kept:
            if kept.open is None or kept.open.number != question.open.number:  # another notebook was quicker
                return kept
            if passed:
                return self._closed(kept, question.item, "wrong" if kept.open.tries else "right")
            if mark in kept.open.seen:  # the same answer again is no new try
                return kept
            named, seen = tuple(sorted({*kept.open.shown, *shown})), (*kept.open.seen, mark)
            return replace(kept, open=replace(kept.open, tries=kept.open.tries + 1, shown=named, seen=seen))

        return Result(assigned, verdict, outcomes, change_kept(self.root, answered), passed)

    def assigned(self, question: DrawnQuestion) -> AssignedTask:
        """Return the question as a task that an answer can be tried on."""
        task = question.item.task
        return AssignedTask(task.id, question.item.stem, question.cases, question.variant, self.root, self.workbook)

    def hint(self, question: DrawnQuestion) -> int:
        """Write down that a hint was read, and return how many now were."""

        def hinted(kept: Kept) -> Kept:
            return replace(kept, open=replace(kept.open, hints=kept.open.hints + 1)) if kept.open else kept

        kept = change_kept(self.root, hinted)
        return kept.open.hints if kept.open else 1

    def typed(self, part: str, text: str) -> None:
        """Write down what was typed for a part of the open question, or for all of it if `part` is ""."""

        def written(kept: Kept) -> Kept:
            return replace(kept, open=replace(kept.open, typed={**kept.open.typed, part: text})) if kept.open else kept

        change_kept(self.root, written)

    def leave(self) -> Kept:
        """Close the open question unanswered, if there is one; return what is known then."""
        return change_kept(self.root, self._left)

    def _item(self, task: str) -> Askable | None:
        """Return a task, also of a chapter that is not asked about now."""
        stem = next((stem for stem in self._there if task.startswith(f"E{int(stem[:2])}.")), "")
        return self._items.get(task) or (items([stem]).get(task) if stem else None)

    def _left(self, kept: Kept) -> Kept:
        item = self._item(kept.open.task) if kept.open else None
        if kept.open is None or item is None:
            return replace(kept, open=None)
        return self._closed(kept, item, "wrong" if kept.open.tries else "skipped")

    def _opened(self, kept: Kept) -> Kept:
        kept = _with_exercises(kept, self.root)
        if kept.open is not None:
            is_asked_about = kept.open.task in self._items or not self._is_chosen
            if is_asked_about and self._item(kept.open.task) is not None:
                return kept
            kept = self._left(kept)
        tasks = {name: item.ideas for name, item in self._items.items()}
        choice = choose(tasks, kept.ideas, kept.last_asked, kept.number, _now_s())
        return replace(kept, open=Open(kept.number, *choice))

    def _closed(self, kept: Kept, item: Askable, came: str) -> Kept:
        opened, now_s = kept.open, _now_s()
        assert opened is not None
        ideas = kept.ideas
        if came != "skipped":
            ideas = after(
                ideas, item.ideas, opened.choice, number=opened.number, now_s=now_s,
                right=came == "right", hinted=opened.hints > 0, shown=frozenset(opened.shown),
            )  # fmt: skip
        elif opened.idea in ideas:  # seen, and put off
            ideas = {**ideas, opened.idea: replace(ideas[opened.idea], number=opened.number, asked_s=now_s)}
        line = Practised(opened.number, opened.task, opened.idea, now_s, came, opened.shown)
        return replace(kept, open=None, ideas=ideas, asked=(*kept.asked, line))


def known_of(root: Path) -> Kept:
    """Return what is known of the learner whose copy this is, with what exercises have shown since."""
    return _with_exercises(read_kept(root), root)


def _with_exercises(kept: Kept, root: Path) -> Kept:
    """Return what is known, with the misconceptions that `check` has named since: they are due."""
    counts = shown_in_exercises(root)
    ideas = dict(kept.ideas)
    for name, count in counts.items():
        if (more := count - kept.exercises.get(name, 0)) > 0:
            ideas[name] = Idea(shown=more + (ideas[name].shown if name in ideas else 0))
    return replace(kept, ideas=ideas, exercises=counts)


def _now_s() -> int:
    return int(time.time())
