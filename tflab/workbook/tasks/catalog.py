"""Read tasks and compute a learner's cases on demand, from the task files and the solution.

    task_ids(data, stem)                            ["E3.1", ...], from the names of the files
    outlines(data, stem)                            texts and forms, without cases
    assigned_cases(data, stem, "E3.2", workbook)    one task, with the learner's variant

Results are cached until a task file or the solution changes.
"""

from __future__ import annotations

import hashlib
import json
import re
from contextlib import redirect_stdout, suppress
from functools import lru_cache
from io import StringIO
from pathlib import Path

from tflab import __version__

from ...text import Text
from ..answers.values import Plain
from ..paths import Workbook, chapters, workbook_data
from .case_types import TaskCases, Variant, rounded
from .generate_cases import PUBLIC_SEED, CasesError, make_variant, outline_of
from .pairs import PairSearch
from .reference import Solution, in_process_ros, solution_in_notebook
from .task import Task, TaskError, read_task, read_tasks, variant_of

__all__ = [
    "OtherQuestionError", "assigned_cases", "outlines", "pair_search", "question_digest", "seed_of", "solution_of",
    "task_ids", "task_in", "tasks_of",
]  # fmt: skip

OTHER_QUESTION = Text(
    en="your class got {id} from another version of tflab. In tflab {here}, which is installed here, the task asks "
    "about other values. Install the version that your instructor names, or ask for an update.",
    ko="수업에서 받은 {id} 과제는 다른 버전의 tflab으로 만든 것입니다. "
    "여기에 설치된 tflab {here}에서는 다른 값을 묻습니다. "
    "강사가 알려 준 버전을 설치하거나 강사에게 업데이트를 요청하십시오.",
)
QUESTION_DIGITS = 9  # fewer than of a case: a digest must not depend on the last digit of a machine's sine


class OtherQuestionError(TaskError):
    """A task that asks about other values than when it was handed out to a class."""


def task_ids(data: Path, stem: str, workbook: Workbook | None = None) -> list[str]:
    """Return the ids of a chapter's tasks, in order, by the names of their files; of a class, those handed out."""
    names = (re.fullmatch(r"e(\d+)_(\d+)", path.stem) for path in (data / "solutions" / "tasks" / stem).glob("e*.py"))
    numbers = sorted((int(name[1]), int(name[2])) for name in names if name)
    released = workbook.questions if workbook is not None else {}
    ids = [f"E{chapter}.{number}" for chapter, number in numbers]
    return [task_id for task_id in ids if not released or task_id in released]


def tasks_of(data: Path, stem: str) -> dict[str, Task]:
    """Return a chapter's tasks, by id.

    Raises:
        TaskError: there are none, or one cannot be read.
    """
    return _tasks(data, stem, _stamp(data, stem))


def task_in(data: Path, stem: str, task_id: str) -> Task:
    """Return one task of a chapter; the files of the other tasks are not read.

    Raises:
        TaskError: it is not there, or cannot be read.
    """
    return _task(data, stem, task_id, _stamp(data, stem))


def solution_of(data: Path, stem: str) -> Solution:
    """Return a chapter's solution.

    Raises:
        TaskError: it is not there.
    """
    return _solution(data, stem, _stamp(data, stem))


def outlines(data: Path, stem: str) -> dict[str, TaskCases]:
    """Return a chapter's tasks without variants, by id.

    Raises:
        TaskError: there are none, or one cannot be read.
    """
    return {name: outline_of(task) for name, task in tasks_of(data, stem).items()}


def assigned_cases(data: Path, stem: str, task_id: str, workbook: Workbook) -> TaskCases:
    """Return a task with the one variant of a learner: by the seed of their class and their id, else the first.

    Raises:
        TaskError: the task or the solution cannot be read.
        CasesError: no inputs tell its mistakes apart.
        OtherQuestionError: it asks about other values than when it was handed out.
    """
    task = task_in(data, stem, task_id)
    number = variant_of(workbook.learner, task_id, task.variants)
    cases = _assigned(data, stem, task_id, seed_of(task, workbook.seed), number, _stamp(data, stem))
    if workbook.questions and question_digest(cases, cases.variants[0]) != workbook.questions[task_id]:
        text = OTHER_QUESTION.say(workbook.language, id=task_id, here=__version__)
        raise OtherQuestionError(text)
    return cases


def seed_of(task: Task, class_seed: str) -> str:
    """Return what a task's numbers are drawn from: a class has its own only where learners are shown them.

    The inputs with which `check` tries a function are the same everywhere; those of grading are hidden.
    """
    return class_seed if class_seed and task.given is not None else PUBLIC_SEED


def question_digest(task: TaskCases, variant: Variant) -> str:
    """Return a digest of what a variant asks: what is given, the arguments, the form of the answer, the points.

    Texts and tolerances are left out, so that they can be fixed after a release.
    """
    answer = [task.answer, task.points, task.counts, _without_tolerance(task.form.plain())]
    asked: Plain = [variant.given, [case.args for case in variant.cases], answer]
    return hashlib.sha256(json.dumps(rounded(asked, QUESTION_DIGITS), sort_keys=True).encode()).hexdigest()[:16]


def _without_tolerance(form: Plain) -> Plain:
    if isinstance(form, dict):
        return {name: _without_tolerance(part) for name, part in form.items() if "tolerance" not in name}
    return form


def pair_search(task_id: str) -> PairSearch:
    """Return the search for pairs of a task's mistakes; it finds none where the task is not here."""

    def load() -> Task | None:
        number = int(task_id.partition(".")[0].removeprefix("E"))
        stem = next((stem for stem in chapters() if int(stem[:2]) == number), "")
        with suppress(TaskError):
            return task_in(workbook_data(), stem, task_id)
        return None

    return PairSearch(load)


def _stamp(data: Path, stem: str) -> int:
    """Return the time of the last change of a chapter's files [ns]."""
    files = [*(data / "solutions" / "tasks" / stem).glob("*.*"), data / "solutions" / "en" / f"{stem}.ipynb"]
    return max((path.stat().st_mtime_ns for path in files if path.exists()), default=0)


@lru_cache(maxsize=16)
def _tasks(data: Path, stem: str, _stamp: int) -> dict[str, Task]:
    with in_process_ros(), redirect_stdout(StringIO()):
        return {task.id: task for task in read_tasks(data / "solutions" / "tasks" / stem)}


@lru_cache(maxsize=128)
def _task(data: Path, stem: str, task_id: str, _stamp: int) -> Task:
    with in_process_ros(), redirect_stdout(StringIO()):
        return read_task(data / "solutions" / "tasks" / stem, task_id)


@lru_cache(maxsize=16)
def _solution(data: Path, stem: str, _stamp: int) -> Solution:
    return solution_in_notebook(data / "solutions" / "en" / f"{stem}.ipynb")


@lru_cache(maxsize=64)
def _assigned(data: Path, stem: str, task_id: str, seed: str, number: int, _stamp: int) -> TaskCases:
    task = task_in(data, stem, task_id)
    with in_process_ros(), redirect_stdout(StringIO()):
        try:
            variant = make_variant(task, seed, number, solution_of(data, stem))
        except TaskError:
            raise
        except Exception as error:  # of a task's own code, or of a damaged solution
            raise CasesError(f"{task_id}: {type(error).__name__}: {error}") from error
    return outline_of(task)._replace(variants=(variant,))
