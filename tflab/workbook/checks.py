"""What does one call in an exercise?  `task`, `check`, `hint`, `solution`.

    e3_2 = task("E3.2")              prints what is given, and returns it
    check("E3.2", base_p_corner)     E3.2 ✓ 1/1, or what is wrong with it
    hint("E3.2")                     three, coarse to fine
    solution("E3.2")                 after a pass or three tries, for self-study

They work offline, on the public cases that came with the exercises.  `check`
never raises: it is there for wrong answers.  What it says of a right one is that
it is right on these cases, and what grading will add.

    cases (cases.py)  +  answer  -->  outcomes  -->  verdict (verdict.py)  -->  words (mistake.py)

Read `reply.py` next.
"""

from __future__ import annotations

import difflib
import json
import os
from contextlib import redirect_stdout
from functools import lru_cache
from io import StringIO
from pathlib import Path
from types import SimpleNamespace
from typing import Any, NamedTuple

from . import progress
from .answers.forms import Sequence
from .answers.showing import show_all, show_in_a_line
from .answers.values import Plain, from_plain, is_raised, is_unanswered, outcome_of
from .places import CASES, Workbook, WorkbookError, read_workbook, workbook_data, workbook_root
from .reply import show_reply
from .tasks.blank import without_marks
from .tasks.case import ChapterCases, TaskCases, Variant
from .tasks.cases import CasesError, read_chapter
from .tasks.mistake import REPLIES, Mistake
from .tasks.reference import answer_cell_name
from .tasks.replies import LATER, PHRASES
from .tasks.task import TaskError, chapter_of, variant_of
from .tasks.verdict import Verdict, judge_outcomes, kind_of
from .words import Words

__all__ = ["check", "hint", "solution", "task"]

NOTHING = object()
POINT, POINTS = Words(en="{points} point", ko="{points}점"), Words(en="{points} points", ko="{points}점")
TRIES_BEFORE_SOLUTION = 3
_hints_seen: dict[str, int] = {}  # where no progress is kept


class _AssignedTask(NamedTuple):
    """A task as this learner has it: with their variant of it."""

    id: str
    stem: str
    cases: TaskCases
    variant: Variant
    root: Path
    workbook: Workbook

    def phrase(self, name: str, **names: object) -> str:
        """Return one of the phrases in the learner's language."""
        return self.words(PHRASES[name], id=self.id, answer=self.cases.answer, **names)

    def words(self, words: Words, **names: object) -> str:
        """Return a text in the learner's language."""
        return words.say(self.workbook.language, **names)


def task(task_id: str) -> SimpleNamespace | None:
    """Print what a task gives, and return it: `e3_2.laser_p_corner`; None if nothing varies.

    Raises:
        WorkbookError: there is no such task.
    """
    assigned = _find(task_id)
    given = assigned.variant.given
    points = assigned.cases.points
    print(f"{assigned.id} · {assigned.words(POINT if points == 1 else POINTS, points=points)}")
    if given is None:
        return None
    values = {name: from_plain(value) for name, value in given.items()}
    print(show_all(values))
    return SimpleNamespace(**values)


def check(task_id: str, answer: Any = NOTHING) -> float | None:
    """Say what is right or wrong about an answer; it never raises.

    Returns:
        None; under nbgrader (NBGRADER_EXECUTION) the points, as it takes them for partial credit.
    """
    try:
        assigned = _find(task_id)
    except (WorkbookError, TaskError) as error:
        show_reply(task_id, str(error))
        return 0.0 if os.environ.get("NBGRADER_EXECUTION") else None
    if answer is NOTHING:
        show_reply(assigned.id, assigned.phrase("no_answer_given"))
        verdict = Verdict(0, 1, Mistake.UNANSWERED)
    else:
        verdict, outcomes = _tried(assigned, answer)
        if verdict.mistake is not Mistake.UNANSWERED:
            progress.record_try(assigned.root, assigned.id, verdict.passed, verdict.of, next(iter(verdict.slips), None))
        _say_verdict(assigned, verdict, outcomes)
    if os.environ.get("NBGRADER_EXECUTION"):
        return round(assigned.cases.points * verdict.passed / verdict.of, 4)
    return None


def hint(task_id: str) -> None:
    """Print the next of a task's three hints."""
    try:
        assigned = _find(task_id)
    except (WorkbookError, TaskError) as error:
        show_reply(task_id, str(error))
        return
    number = progress.record_hint(assigned.root, assigned.id) or _hints_seen.get(assigned.id, 0) + 1
    _hints_seen[assigned.id] = number
    hints = assigned.cases.hints
    head = assigned.phrase("hint_number", number=number) if number <= len(hints) else assigned.phrase("last_hint")
    show_reply(f"{assigned.id} · {head}", assigned.words(hints[min(number, len(hints)) - 1]))


def solution(task_id: str) -> None:
    """Print the solution's answer cell, after a pass or three tries; a class's solutions are with its instructor."""
    try:
        assigned = _find(task_id)
    except (WorkbookError, TaskError) as error:
        show_reply(task_id, str(error))
        return
    if assigned.workbook.edition == "class":
        show_reply(assigned.id, assigned.phrase("solution_of_class"))
        return
    tried = progress.attempts(assigned.root, assigned.id)
    is_copy = assigned.root != workbook_data()
    if is_copy and not tried.passed and tried.tries < TRIES_BEFORE_SOLUTION:
        show_reply(assigned.id, assigned.phrase("solution_later", tries=tried.tries))
        return
    path = workbook_data() / "solutions" / assigned.workbook.language / f"{assigned.stem}.ipynb"
    try:
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    except OSError as error:
        show_reply(assigned.id, assigned.phrase("no_cases", why=error))
        return
    answers = [cell["source"] for cell in cells if cell["id"] == answer_cell_name(assigned.id)]
    print(without_marks("".join(line for lines in answers for line in lines)).rstrip())


# -- trying ---------------------------------------------------------------------------


def _tried(assigned: _AssignedTask, answer: Any) -> tuple[Verdict, list[Plain]]:
    """Return the verdict, and what came out of each case."""
    cases = assigned.variant.cases
    if not assigned.cases.is_function:
        outcomes = [outcome_of(lambda: answer, ())]
        return judge_outcomes(assigned.cases, assigned.variant, outcomes), outcomes
    if not callable(answer):
        mistake = Mistake.UNANSWERED if answer is ... else Mistake.NOT_A_FUNCTION
        verdict = Verdict(0, len(cases), mistake, detail={"got": kind_of(outcome_of(lambda: answer, ()))})
        return verdict, []
    outcomes = []
    for number, case in enumerate(cases):
        try:
            first = outcome_of(answer, case.args)
            with redirect_stdout(StringIO()):  # what it prints has been read once
                again = outcome_of(answer, case.args)
        except KeyboardInterrupt:
            return Verdict(0, len(cases), Mistake.INTERRUPTED, case=number), []
        if first != again:
            return Verdict(0, len(cases), Mistake.UNSTEADY, case=number), []
        outcomes.append(first)
        if number == 0 and is_unanswered(first):
            return Verdict(0, len(cases), Mistake.UNANSWERED), []
    return judge_outcomes(assigned.cases, assigned.variant, outcomes), outcomes


# -- saying ---------------------------------------------------------------------------


def _say_verdict(assigned: _AssignedTask, verdict: Verdict, outcomes: list[Plain]) -> None:
    score = f"{assigned.id} {'✗' if verdict.mistake else '✓'} {verdict.passed}/{verdict.of}"
    if verdict.mistake is None:
        _say_passed(assigned, score, verdict.of)
        return
    if verdict.mistake is Mistake.UNANSWERED:
        show_reply(assigned.id, assigned.words(REPLIES[verdict.mistake]))
        return
    more = []
    if assigned.cases.is_function and outcomes:
        more.append(assigned.phrase("case", call=_call(assigned, verdict.case), got=_shown(outcomes[verdict.case])))
    tried = progress.attempts(assigned.root, assigned.id)
    if assigned.workbook.edition == "self-study" and tried.tries >= TRIES_BEFORE_SOLUTION:
        more.append(assigned.phrase("solution"))
    elif verdict.mistake in (Mistake.VALUE, Mistake.SLIP, Mistake.PARTS):
        more.append(assigned.phrase("hint"))
    show_reply(score, _reply(assigned, verdict), more, "wrong")
    _show_both(assigned, verdict, outcomes)


def _say_passed(assigned: _AssignedTask, score: str, of: int) -> None:
    if assigned.root == workbook_data():  # a solution that is being built: the same in both languages, and plain
        print(score)
        return
    show_reply(score, more=[assigned.words(LATER[_what_was_tried(assigned)], of=of)], kind="passed")


def _what_was_tried(assigned: _AssignedTask) -> str:
    if assigned.cases.is_function:
        return "function"
    return "value" if assigned.variant.given else "same for all"


def _reply(assigned: _AssignedTask, verdict: Verdict) -> str:
    if verdict.said is not None and verdict.mistake is Mistake.SLIP:
        return assigned.words(verdict.said)
    names = {name: _listed(held) if isinstance(held, list) else held for name, held in verdict.detail.items()}
    bounds = names.get("certain")
    names["certain"] = f" ({assigned.words(bounds)})" if bounds else ""
    names = {"answer": assigned.cases.answer, "wanted": _wanted(assigned, verdict)} | names
    text = assigned.words(REPLIES[verdict.mistake], **names)
    return f'"{names["part"]}": {text}' if "part" in names else text


def _listed(names: list[str]) -> str:
    return ", ".join(f'"{name}"' for name in names)


def _wanted(assigned: _AssignedTask, verdict: Verdict) -> str:
    form = assigned.cases.form
    part = verdict.detail.get("part")
    form = form.parts[part] if part else form
    if verdict.mistake is Mistake.OPTION and isinstance(form, Sequence):
        form = form.of
    return form.wanted().say(assigned.workbook.language)


def _call(assigned: _AssignedTask, case: int) -> str:
    """Return the call as it was made, short enough to read."""
    arguments = ", ".join(show_in_a_line(from_plain(arg)) for arg in assigned.variant.cases[case].args)
    return f"{assigned.cases.answer}({arguments})"


def _shown(outcome: Plain) -> str:
    if is_raised(outcome):
        return outcome["raises"]
    try:
        return show_in_a_line(from_plain(outcome))
    except ValueError:
        return kind_of(outcome)


def _show_both(assigned: _AssignedTask, verdict: Verdict, outcomes: list[Plain]) -> None:
    """Draw the answer beside the right one, where both are in space: a function's, or a value after three tries."""
    from .tasks.comparison import picture_of

    tries = progress.attempts(assigned.root, assigned.id).tries
    if not outcomes or verdict.mistake not in (Mistake.SLIP, Mistake.VALUE, Mistake.UNIT):
        return
    if not assigned.cases.is_function and tries < TRIES_BEFORE_SOLUTION:
        return  # the picture would tell the number
    picture = picture_of(assigned.cases.form, outcomes[verdict.case], assigned.variant.cases[verdict.case].expected)
    if picture is None:
        return
    from IPython import get_ipython
    from IPython.display import display

    if get_ipython() is not None:
        display(picture)


# -- finding --------------------------------------------------------------------------


def _find(task_id: str) -> _AssignedTask:
    """Return a task of this workbook, as this learner has it.

    Raises:
        WorkbookError: there is no such task, or its cases cannot be read.
    """
    root = workbook_root()
    workbook = read_workbook(root)
    try:
        number = chapter_of(task_id)
    except TaskError:
        raise WorkbookError(_unknown(root, workbook, str(task_id), sorted((root / CASES).glob("*.json")))) from None
    paths = sorted((root / CASES).glob(f"{number:02d}_*.json"))
    if not paths:
        raise WorkbookError(_unknown(root, workbook, task_id, sorted((root / CASES).glob("*.json"))))
    try:
        cases = _read(paths[0], paths[0].stat().st_mtime_ns)
    except CasesError as error:
        raise WorkbookError(PHRASES["no_cases"].say(workbook.language, why=error)) from None
    if task_id not in cases.tasks:
        raise WorkbookError(_unknown(root, workbook, task_id, paths))
    held = cases.tasks[task_id]
    variant = held.variants[variant_of(workbook.learner, task_id, len(held.variants))]
    return _AssignedTask(task_id, paths[0].stem, held, variant, root, workbook)


@lru_cache(maxsize=4)
def _read(path: Path, _mtime_ns: int) -> ChapterCases:
    return read_chapter(path)


def _unknown(root: Path, workbook: Workbook, task_id: str, paths: list[Path]) -> str:
    known: list[str] = []
    for path in paths:
        try:
            known += read_chapter(path).tasks
        except CasesError:
            continue
    close = difflib.get_close_matches(task_id, known, n=1, cutoff=0.5)
    suggestion = PHRASES["did_you_mean"].say(workbook.language, name=close[0]) if close else ""
    return PHRASES["unknown_task"].say(workbook.language, known=", ".join(known) or str(root / CASES), close=suggestion)
