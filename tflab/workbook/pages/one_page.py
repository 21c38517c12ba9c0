"""What comes of one source?  It is read, looked over for faults, run once, and made into every edition.

    notebooks/src/03_x.py                --run-->  notebooks/{en,ko}/03_x.ipynb
    solutions/src/03_x.py                --run-->  solutions/{en,ko}/03_x.ipynb
        + solutions/tasks/03_x/e3_1.py  -------->  exercises/{en,ko}/E03_x.ipynb, exercises/cases/03_x.json

The public cases are made before the solution is run, because its checks ask for
them.  An exercise is run, too, untouched: it must reach its end and pass nothing.

Read `stale.py` next.
"""

from __future__ import annotations

import asyncio
import re
from collections.abc import Iterable
from concurrent.futures import Executor
from pathlib import Path
from typing import NamedTuple

from ..course.glossary import read_glossary
from ..places import exercise_file
from ..tasks.blank import BlankError
from ..tasks.case import ChapterCases, TaskCases
from ..tasks.cases import PUBLIC_SEED, CasesError, cases_json, task_cases
from ..tasks.mutants import Tested, refuse_survivors, tested
from ..tasks.reference import CodeCell, Solution, answer_cell_name, in_process_ros
from ..tasks.task import TaskError, read_tasks, task_file
from ..words import LANGUAGES
from .editions import exercise_notebook, lecture_notebook, text_of
from .execute import Outputs, run_page
from .exercise_rules import exercise_faults, form_faults, score_faults, untouched, untouched_faults
from .rules import page_faults
from .source import Page, PageError, PageFault, read_page

__all__ = ["Made", "make_page"]


class Made(NamedTuple):
    """What comes of a source: the text of each file by its path, what is wrong, and how its tasks were tested."""

    files: dict[str, str]
    faults: list[PageFault]
    tests: tuple[Tested, ...] = ()


async def make_page(path: Path, processes: Executor) -> Made:
    """Make everything that comes of the source at `path`; a faulty one as far as it goes.

    Args:
        processes: where cases are made, each chapter's in one: it puts tflab's rclpy in place for that time.
    """
    try:
        page = read_page(path)
        faults = page_faults(page, read_glossary())
        if path.parents[1].name == "solutions":
            return await _solution(page, faults, processes)
        outputs, more = await run_page(page, f"notebooks/{LANGUAGES[0]}", {})
        return Made(_in_each_language(page, "notebooks", outputs), faults + more)
    except PageError as error:
        return Made({}, list(error.faults))


async def _solution(page: Page, faults: list[PageFault], processes: Executor) -> Made:
    tasks, tests, more = await asyncio.get_running_loop().run_in_executor(processes, _cases, page)
    faults += more
    public = {page.stem: cases_json(ChapterCases(page.stem, tasks))}
    outputs, more = await run_page(page, f"solutions/{LANGUAGES[0]}", public)
    faults += more + score_faults(page, tasks, outputs)
    if not faults:
        blanked, _ = await run_page(untouched(page), f"exercises/{LANGUAGES[0]}", public)
        faults += untouched_faults(page, blanked)
    faults += _survivor_faults(page, tests)
    files = {f"exercises/cases/{page.stem}.json": public[page.stem]}
    files |= _in_each_language(page, "solutions", outputs, tasks)
    for language in LANGUAGES:
        try:
            exercise = text_of(exercise_notebook(page, language, tasks))
            files[f"exercises/{language}/{exercise_file(page.stem)}"] = exercise
        except BlankError:  # which is a fault already
            assert faults
    return Made(files, faults, tuple(tests))


def _in_each_language(
    page: Page, room: str, outputs: Outputs, tasks: dict[str, TaskCases] | None = None
) -> dict[str, str]:
    return {
        f"{room}/{language}/{page.stem}.ipynb": text_of(lecture_notebook(page, language, outputs, tasks))
        for language in LANGUAGES
    }


def _cases(page: Page) -> tuple[dict[str, TaskCases], list[Tested], list[PageFault]]:
    """Return the public cases of a solution's tasks, by id, how they stood their tests, and what is wrong."""
    folder = page.path.parents[1] / "tasks" / page.stem
    try:
        tasks = read_tasks(folder)
    except TaskError as error:
        return {}, [], [page.fault(None, str(error), "mend the chapter's tasks")]
    faults = exercise_faults(page, tasks) + form_faults(page, tasks)
    solution = Solution(page.stem, [CodeCell(cell.name, cell.source) for cell in page.code])
    made, tests = {}, []
    with in_process_ros():
        for task in tasks:
            try:
                made[task.id] = task_cases(task, PUBLIC_SEED, solution)
                tests.append(tested(task, made[task.id], solution))
            except Exception as error:  # a generator or a twin may fail in any way
                faults.append(_task_fault(page, task_file(folder, task.id), task.id, error))
    return made, tests, faults


def _survivor_faults(page: Page, tests: Iterable[Tested]) -> list[PageFault]:
    """Return a fault for each task of which a spoilt solution passes."""
    faults, folder = [], page.path.parents[1] / "tasks" / page.stem
    for test in tests:
        try:
            refuse_survivors(test)
        except CasesError as error:
            faults.append(_task_fault(page, task_file(folder, test.task), test.task, error))
    return faults


def _task_fault(page: Page, path: Path, task: str, error: Exception) -> PageFault:
    """Return what is wrong with a task: at its answer's cell if that fails, else in its own file."""
    if isinstance(error, TaskError) and not isinstance(error, CasesError):
        cell = next((cell for cell in page.code if cell.name == answer_cell_name(task)), None)
        return page.fault(cell, str(error), "mend the answer, or what is given")
    lines = path.read_text(encoding="utf-8").splitlines()
    line = next((n for n, text in enumerate(lines, start=1) if re.search(rf"\bid\s*=\s*[\"']{task}[\"']", text)), 1)
    wrong = str(error) if isinstance(error, TaskError) else f"{task}: {type(error).__name__}: {error}"
    return PageFault("/".join(path.parts[-4:]), line, "", wrong, f"mend {task}")
