"""The functions that an exercise calls: `task`, `check`, `call`, `hint`, `solution`.

    e3_2 = task("E3.2")              prints what is given, and returns it
    check("E3.2", base_p_corner)     E3.2 ✓ 2/2 points, or what is wrong with it
    call("E4.3")                     the arguments of the call that went wrong
    hint("E3.2")                     three, coarse to fine
    solution("E3.2")                 after a pass or three tries, for self-study

They work offline.  What an answer is compared with is computed when a task is first
asked for.  `check` never raises: it is there for wrong answers.
"""

from __future__ import annotations

import difflib
import json
import os
import re
from collections.abc import Sequence
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

from . import progress
from .answers.forms import Parts
from .answers.numeric import NumberForm
from .answers.showing import show_all
from .answers.values import Plain, from_plain
from .assigned_task import AssignedTask
from .cell_errors import source_of
from .diagnosis.explain import list_asked, read_conditions
from .diagnosis.failure import Failure
from .diagnosis.lint import describe_cell_text
from .diagnosis.question import Question
from .diagnosis.verdict import Verdict
from .inventory.participation import NO_HELP, report_participation
from .judge_answer import judge_answer, show_hint, show_verdict
from .paths import TASKS, Workbook, WorkbookError, chapters, read_workbook, workbook_data, workbook_root
from .phrases import PHRASES
from .replay import shown_arguments
from .reply_card import show_reply
from .tasks.catalog import OtherQuestionError, assigned_cases, task_ids
from .tasks.credit import beyond_one_word
from .tasks.reference import answer_cell_name, given_name
from .tasks.strip_solution import without_marks
from .tasks.task import TaskError

__all__ = ["TRIES_BEFORE_SOLUTION", "call", "check", "hint", "solution", "solution_text", "task"]


class _Nothing:
    """What stands for an answer that was not handed over; its name is what an editor shows of `check`."""

    def __repr__(self) -> str:
        return "NOTHING"


NOTHING = _Nothing()
LIKE_A_TASK = re.compile(r"[eE]?(?P<chapter>\d{1,2})(?:[.\-_](?P<task>\d{1,2}))?")  # E3.2, e3.2, 3.2, e3-2; E3
UNFINISHED = (Failure.UNANSWERED, Failure.MISSING_PARTS, Failure.OPTION)  # which is no try yet
TRIES_BEFORE_SOLUTION = 3
WHICH = "E?"  # what a reply is about where no task is named
_hints_seen: dict[str, int] = {}  # where no progress is kept


def task(task_id: str) -> SimpleNamespace | None:
    """Print what a task gives, and return it: `e3_2.laser_p_corner`; None if nothing varies.

    Raises:
        WorkbookError: there is no such task.
    """
    assigned = _find(task_id)
    given = assigned.variant.given
    points = assigned.cases.points
    print(f"{assigned.id} · {assigned.phrase('point' if points == 1 else 'points', points=points)}")
    if given is None:
        return None
    values = {name: from_plain(value) for name, value in given.items()}
    print(show_all({f"{given_name(assigned.id)}.{name}": value for name, value in values.items()}))
    return SimpleNamespace(**values)


def check(task_id: str, answer: Any = NOTHING, why: bool = False) -> float | None:
    """Say what is right or wrong about an answer; it never raises.  The two may be exchanged where that is plain.

    Args:
        why: also print which explanations were asked about a wrong answer, and which one answered.

    Returns:
        None; under nbgrader (NBGRADER_EXECUTION) the points, as it takes them for partial credit.
    """
    if not isinstance(task_id, str) and isinstance(answer, str) and LIKE_A_TASK.fullmatch(answer.strip()):
        task_id, answer = answer, task_id
    try:
        assigned = _find(task_id)
    except WorkbookError as error:
        _say_not_found(task_id, error)
        return 0.0 if os.environ.get("NBGRADER_EXECUTION") else None
    if answer is NOTHING:
        show_reply(assigned.id, assigned.phrase("no_answer_given"))
        verdict = Verdict(0, 1, Failure.UNANSWERED)
    else:
        verdict, outcomes = judge_answer(assigned, answer)
        if verdict.failure not in UNFINISHED:
            named = next(iter(verdict.mistakes), None)
            came = outcomes or [str(verdict.failure)]  # what could not be tried on all cases
            progress.record_try(assigned.root, assigned.id, verdict.passed, verdict.of, named, came)
        if assigned.cases.counts and verdict.failure is not Failure.UNANSWERED:
            language, form = assigned.workbook.language, assigned.cases.form
            report_participation(assigned.id, assigned.root, language, form, verdict, outcomes[0])
        else:
            _say(assigned, _with_slip_in_cell(assigned, verdict), outcomes)
        if why and verdict.failure and len(outcomes) == len(assigned.variant.cases):
            _print_asked(assigned, outcomes)
    if os.environ.get("NBGRADER_EXECUTION"):
        return round(assigned.cases.points * verdict.passed / verdict.of, 4)
    return None


def call(task_id: str = "") -> SimpleNamespace | None:
    """Print and return the arguments of the call that the last reply showed: `call("E4.3").source`.

    They have the names of your function's parameters. None for a task that is no function.
    """
    try:
        assigned = _find(task_id)
    except WorkbookError as error:
        _say_not_found(task_id, error)
        return None
    if not assigned.cases.is_function:
        show_reply(assigned.id, assigned.phrase("no_call"))
        return None
    arguments = shown_arguments(assigned)
    print(assigned.phrase("arguments"))
    print(show_all(vars(arguments)))
    return arguments


def hint(task_id: str = "") -> None:
    """Print the next of a task's three hints; without a task, which there are."""
    try:
        assigned = _find(task_id)
    except WorkbookError as error:
        _say_not_found(task_id, error)
        return
    if assigned.cases.counts:
        show_reply(assigned.id, assigned.words(NO_HELP))
        return
    number = progress.record_hint(assigned.root, assigned.id) or _hints_seen.get(assigned.id, 0) + 1
    _hints_seen[assigned.id] = number
    show_hint(assigned, number)


def solution(task_id: str = "") -> None:
    """Print the solution's answer cell, after a pass or three tries; a class's solutions are with its instructor.

    Without a task, say which there are.
    """
    try:
        assigned = _find(task_id)
    except WorkbookError as error:
        _say_not_found(task_id, error)
        return
    if assigned.cases.counts or assigned.workbook.edition == "class":
        show_reply(assigned.id, assigned.words(NO_HELP if assigned.cases.counts else PHRASES["solution_of_class"]))
        return
    tried = progress.attempts(assigned.root, assigned.id)
    is_copy = assigned.root != workbook_data()
    if is_copy and not tried.passed and tried.tries < TRIES_BEFORE_SOLUTION:
        show_reply(assigned.id, assigned.phrase("solution_later", tries=tried.tries))
        return
    try:
        print(solution_text(assigned))
    except OSError as error:
        show_reply(assigned.id, assigned.phrase("no_cases", why=error))


def solution_text(assigned: AssignedTask) -> str:
    """Return the solution's answer cell of a task.

    Raises:
        OSError: the solution is not here.
    """
    path = workbook_data() / "solutions" / "en" / f"{assigned.stem}.ipynb"  # the code is the same in each language
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    answers = [cell["source"] for cell in cells if cell["id"] == answer_cell_name(assigned.id)]
    return without_marks("".join(line for lines in answers for line in lines)).rstrip()


def _with_slip_in_cell(assigned: AssignedTask, verdict: Verdict) -> Verdict:
    """Return a verdict on a wrong value, with what is plain to see in the text of its cell."""
    source = "" if assigned.cases.is_function or verdict.failure is None else source_of(assigned.cases.answer)
    forms = getattr(assigned.cases.form, "parts", {"": assigned.cases.form}).values()
    is_of_numbers = assigned.variant.given and all(isinstance(form, NumberForm) for form in forms)
    given = given_name(assigned.id) if is_of_numbers else ""
    place = describe_cell_text(source, given) if source else None
    return replace(verdict, detail=verdict.detail | {"place": place}) if place else verdict


def _say(assigned: AssignedTask, verdict: Verdict, outcomes: list[Plain]) -> None:
    if verdict.failure is None and assigned.root == workbook_data():
        print(f"{assigned.id} ✓ {assigned.score(verdict.passed, verdict.of)}")  # a solution that is built: plain
        return
    tries = progress.attempts(assigned.root, assigned.id).tries
    more = []
    if names := _said_too_often(assigned, outcomes):
        more.append(assigned.phrase("one word", names=", ".join(f'"{name}"' for name in names)))
    if verdict.failure is None:
        more.append(_passed(assigned))
    elif assigned.workbook.edition == "self-study" and tries >= TRIES_BEFORE_SOLUTION:
        more.append(assigned.phrase("solution"))
    elif verdict.failure in (Failure.VALUE, Failure.KNOWN, Failure.PARTS):
        more.append(assigned.phrase("hint"))
    show_verdict(assigned, verdict, outcomes, more, draws=tries >= TRIES_BEFORE_SOLUTION)


def _passed(assigned: AssignedTask) -> str:
    """Return what was tried, what grading does if this is a class, and which task comes next."""
    kind = _what_was_tried(assigned)
    said = [assigned.phrase(f"passed, {kind}", calls=len(assigned.variant.cases))]
    if assigned.workbook.edition == "class":
        said.append(assigned.phrase(f"graded, {kind}"))
    tasks = task_ids(workbook_data(), assigned.stem, assigned.workbook)
    rest = tasks[tasks.index(assigned.id) + 1 :]
    said.append(assigned.phrase("next task", task=rest[0]) if rest else assigned.phrase("last task"))
    return " ".join(said)


def _print_asked(assigned: AssignedTask, outcomes: list[Plain]) -> None:
    """Print the explanations that were asked, in order, of which part, and when each is true."""
    variant, conditions = assigned.variant, read_conditions()
    for part, name, is_answer in list_asked(Question(assigned.cases, variant.cases, outcomes, variant.given or {})):
        where = f'"{part}": ' if part else ""
        print(f"  {'✓' if is_answer else '·'} {where}{name}: {conditions[name]}")


def _said_too_often(assigned: AssignedTask, outcomes: list[Plain]) -> list[str]:
    """Return the parts that are right and count nothing, for their word was said too often."""
    form, cases = assigned.cases.form, assigned.variant.cases
    if assigned.cases.is_function or not isinstance(form, Parts) or not outcomes:
        return []
    right = form.judge(outcomes[0], cases[0].expected)
    counts = beyond_one_word(form, outcomes[0], cases[0].expected, right)
    return [name for name, *earned in zip(form.parts, right, counts, strict=True) if earned == [True, False]]


def _what_was_tried(assigned: AssignedTask) -> str:
    if assigned.cases.is_function:
        return "function"
    return "value" if assigned.variant.given else "same for all"


# -- finding --------------------------------------------------------------------------


def _say_not_found(task_id: object, error: Exception) -> None:
    show_reply(str(task_id).strip() or WHICH, str(error))


def _find(task_id: str) -> AssignedTask:
    """Return a task of this workbook, as this learner has it.

    Raises:
        WorkbookError: there is no such task, or it asks something else than when it was handed out,
            or its cases cannot be computed.
    """
    root, data = workbook_root(), workbook_data()
    workbook = read_workbook(root)
    stems = chapters(root)
    meant = LIKE_A_TASK.fullmatch(str(task_id).strip())
    stem = next((stem for stem in stems if meant and int(stem[:2]) == int(meant["chapter"])), "")
    known = task_ids(data, stem, workbook)
    asked = f"E{int(meant['chapter'])}.{int(meant['task'])}" if meant and meant["task"] else ""
    if asked not in known:
        raise WorkbookError(_unknown(workbook, asked or task_id, [stem] if stem else stems))
    try:
        cases = assigned_cases(data, stem, asked, workbook)
    except OtherQuestionError as error:
        raise WorkbookError(f"{error}") from None
    except TaskError as error:
        raise WorkbookError(PHRASES["no_cases"].say(workbook.language, why=error)) from None
    return AssignedTask(asked, stem, cases, cases.variants[0], root, workbook)


def _unknown(workbook: Workbook, task_id: str, stems: Sequence[str]) -> str:
    """Return which tasks there are: of one chapter each, of several the first and the last."""
    tasks_there = [task_ids(workbook_data(), stem, workbook) for stem in stems]
    known = [task for chapter in tasks_there for task in chapter]
    undotted = [task for task in known if task.replace(".", "") == str(task_id).upper()]  # E12 is E1.2
    is_chapter = len(stems) == 1 and "." not in str(task_id)  # all of them are named
    close = undotted or ([] if is_chapter else difflib.get_close_matches(str(task_id), known, n=1, cutoff=0.7))
    suggestion = PHRASES["did_you_mean"].say(workbook.language, name=close[0]) if close else ""
    if len(stems) > 1:
        known = [_from_to(chapter) for chapter in tasks_there]
    phrase = PHRASES["unknown_task" if str(task_id).strip() else "no_task"]
    return phrase.say(workbook.language, known=", ".join(known) or str(workbook_data() / TASKS), close=suggestion)


def _from_to(tasks: list[str]) -> str:
    """Return the tasks of a chapter in a word: "E3.1–7"."""
    first, last = tasks[0], tasks[-1].partition(".")[2]
    return first if len(tasks) == 1 else f"{first}–{last}"
