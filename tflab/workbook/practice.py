"""Ask the course's tasks again in a notebook, with new numbers.

    from tflab.workbook import practice
    practice.ask()             show a task from the chapters so far, and put a cell for its answer below
    practice.ask(3, 8)         show a task from chapter 3 or 8
    practice.check(corner)     reply as `check` does in an exercise
    practice.hint()  practice.solution()  practice.given()

The numbers come from the generators of the exercises, the correct answer from the same solution.
Nothing is written: practice changes neither marks nor progress. Tasks whose cases take minutes to
compute, and the test at the beginning and the end of the course, are not asked.
"""

from __future__ import annotations

import ast
import json
import random
import re
from collections import Counter
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from ..text import Texts
from .answers.showing import show_all
from .answers.values import from_plain
from .assigned_task import AssignedTask
from .checks import TRIES_BEFORE_SOLUTION, solution_text
from .diagnosis.failure import Failure
from .judge_answer import judge_answer, show_hint, show_verdict
from .paths import WorkbookError, chapters, exercise_file, read_workbook, stems_called, workbook_data, workbook_root
from .progress import mark_of, read_progress
from .reply_card import in_notebook, shell, show_reply
from .tasks.case_types import TaskCases
from .tasks.catalog import solution_of, tasks_of
from .tasks.generate_cases import PUBLIC_SEED, CasesError, task_cases
from .tasks.reference import given_name, in_process_ros
from .tasks.task import Task, TaskError, slug

__all__ = ["DrawnQuestion", "ask", "check", "draw_question", "given", "hint", "practice_tasks", "solution"]

TEXTS = Texts(__file__)
POINTS = re.compile(r" \(\d+ points?\)| \(\d+점\)")
MAX_DRAWS = 5  # before the numbers of the exercise are taken
MAX_NUMBER = 1_000_000


@dataclass
class DrawnQuestion:
    """A task with drawn numbers, and what the learner has done with it.

    Attributes:
        assigned: the task as `judge_answer` takes it.
        text: the exercise's text, in Markdown.
        imports: the chapter's import lines, if the answer may need them.
        starter: the exercise's answer cell, with `practice.given()` in place of `task(...)`.
        wrong: hashes of the wrong answers.
    """

    assigned: AssignedTask
    text: str
    imports: str
    starter: str
    wrong: set[str] = field(default_factory=set)
    hints: int = 0

    @property
    def given(self) -> dict[str, Any]:
        """Return the task's input values."""
        return {name: from_plain(value) for name, value in (self.assigned.variant.given or {}).items()}

    @property
    def answer_cell(self) -> str:
        """Return the cell in which the question is answered."""
        return "\n\n".join(filter(None, [self.imports, self.starter, f"practice.check({self.assigned.cases.answer})"]))


_question: DrawnQuestion | None = None
_asked: Counter[str] = Counter()  # how often each task was asked in this kernel
_rng = random.Random()


def ask(*chapter_numbers: str | int) -> None:
    """Show a task with new numbers, and put a cell for its answer below.

    Args:
        chapter_numbers: of the chapters to choose from; by default, those up to the last with a checked answer.
    """
    global _question
    root = workbook_root()
    try:
        workbook = read_workbook(root)
        tasks = practice_tasks(_chosen_stems(root, chapter_numbers))
        least = min((_asked[task_id] for task_id in tasks), default=0)
        task_id = _rng.choice([task_id for task_id in tasks if _asked[task_id] == least])
        _question = draw_question(tasks[task_id], task_id, _rng.randrange(MAX_NUMBER), root)
    except (WorkbookError, TaskError, LookupError) as error:
        show_reply("practice", str(error))
        return
    _asked[task_id] += 1
    show_reply(TEXTS["answer_below"].say(workbook.language), more=[TEXTS["help"].say(workbook.language)])
    _show(_question)
    if in_notebook():
        shell().set_next_input(_question.answer_cell)
    else:
        print(_question.answer_cell)


def check(answer: Any = ...) -> None:
    """Print what is right or wrong about an answer to the question."""
    if (question := _asked_question()) is None:
        return
    verdict, outcomes = judge_answer(question.assigned, answer)
    if verdict.failure not in (None, Failure.UNANSWERED, Failure.MISSING_PARTS, Failure.OPTION):
        question.wrong.add(mark_of(outcomes or [str(verdict.failure)]))
    more = TEXTS["help" if verdict.failure else "next"].say(question.assigned.workbook.language)
    show_verdict(question.assigned, verdict, outcomes, [more], draws=False)


def hint() -> None:
    """Print the next of the question's three hints."""
    if (question := _asked_question()) is not None:
        question.hints += 1
        show_hint(question.assigned, question.hints)


def solution() -> None:
    """Print the solution after three different wrong answers; in a class, the instructor has it."""
    if (question := _asked_question()) is None:
        return
    task = question.assigned
    if task.workbook.edition == "class":
        show_reply(task.id, task.phrase("solution_of_class"))
    elif len(question.wrong) < TRIES_BEFORE_SOLUTION:
        show_reply(task.id, task.phrase("solution_later", tries=len(question.wrong)))
    else:
        print(solution_text(task))


def given() -> SimpleNamespace:
    """Return the question's input values: `e3_2 = practice.given()`, then `e3_2.laser_p_corner`."""
    question = _asked_question()
    return SimpleNamespace(**question.given) if question else SimpleNamespace()


def practice_tasks(stems: Sequence[str]) -> dict[str, str]:
    """Return the stem of each task that can be asked, by the task's id."""
    tasks = [(stem, task) for stem in stems for task in tasks_of(workbook_data(), stem).values()]
    return {task.id: stem for stem, task in tasks if not task.is_costly and not task.counts}


def draw_question(stem: str, task_id: str, number: int, root: Path) -> DrawnQuestion:
    """Return a task with the numbers that belong to `number`; the same number gives the same question."""
    data, workbook = workbook_data(), read_workbook(root)
    task = tasks_of(data, stem)[task_id]
    cases = _draw_cases(task, stem, number)
    assigned = AssignedTask(task_id, stem, cases, cases.variants[0], root, workbook)
    cells = _cells(data, stem, workbook.language)
    name = slug(task_id)
    text = POINTS.sub("", cells.get(name, f"## {task_id} · {task.title.say(workbook.language)}"), count=1)
    inputs = cells.get(f"{name}-given", "").replace(f'task("{task_id}")', "practice.given()")
    starter = "\n".join(filter(None, [inputs, cells.get(f"{name}-answer", f"{task.answer} = ...")]))
    imports = _import_lines(cells) if cases.is_function or task.given is not None else ""
    return DrawnQuestion(assigned, text, imports, starter)


def _asked_question() -> DrawnQuestion | None:
    """Return the question that was asked last. If there is none, say how to get one."""
    if _question is None:
        show_reply("practice", TEXTS["next"].say(read_workbook(workbook_root()).language))
    return _question


def _chosen_stems(root: Path, chapter_numbers: Sequence[str | int]) -> list[str]:
    """Return the named chapters, or those up to the last in which an answer was checked."""
    stems = [stem for stem in chapters(root) if practice_tasks([stem])]
    if chapter_numbers:
        return stems_called(map(str, chapter_numbers), stems, what="chapter")
    tried = {task_id.partition(".")[0] for task_id, attempts in read_progress(root).items() if attempts.tries}
    last = max((index for index, stem in enumerate(stems) if f"E{int(stem[:2])}" in tried), default=0)
    return stems[: last + 1]


def _draw_cases(task: Task, stem: str, number: int) -> TaskCases:
    """Return a task with one variant."""
    solution = solution_of(workbook_data(), stem)
    with in_process_ros():
        for draw in range(MAX_DRAWS):
            with suppress(CasesError):  # these numbers do not tell two mistakes apart
                return task_cases(task, f"practice/{number}/{draw}", solution, variants=1)
        return task_cases(task, PUBLIC_SEED, solution, variants=1)


@lru_cache
def _cells(data: Path, stem: str, language: str) -> dict[str, str]:
    """Return the source of each cell of a chapter's exercises, by the cell's id."""
    path = data / "exercises" / language / exercise_file(stem)
    return {cell["id"]: "".join(cell["source"]) for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]}


def _import_lines(cells: dict[str, str]) -> str:
    """Return the import lines at the top of a chapter's exercises, of `tflab.workbook` only `lesson`."""
    lines = []
    for source in (cells.get("load", ""), cells.get("imports", "")):
        code = "\n".join(line for line in source.splitlines() if not line.lstrip().startswith("%"))
        for node in ast.parse(code).body:
            if isinstance(node, ast.ImportFrom) and node.module == "tflab.workbook":
                node.names = [name for name in node.names if name.name == "lesson"]
            if isinstance(node, ast.Import | ast.ImportFrom) and node.names:
                lines.append(ast.unparse(node))
    return "\n".join(lines)


def _show(question: DrawnQuestion) -> None:
    if in_notebook():
        from IPython.display import Markdown, display

        display(Markdown(question.text))
    else:
        print(question.text)
    if question.given:
        print(f"{given_name(question.assigned.id)}\n{show_all(question.given)}")
