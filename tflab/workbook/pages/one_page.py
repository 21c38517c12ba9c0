"""Make every edition of one page: read its source, check it, run it once, write the notebooks.

    notebooks/src/03_x.py                --run-->  notebooks/{en,ko}/03_x.ipynb
    solutions/src/03_x.py                --run-->  solutions/{en,ko}/03_x.ipynb
        + solutions/tasks/03_x/e3_1.py  -------->  exercises/{en,ko}/E03_x.ipynb

A solution is run beside its tasks, so its checks compute their cases from the source that
is being built.  An exercise is run, too, untouched: it must reach its end and pass nothing.
"""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import NamedTuple

from ...text import LANGUAGES
from ..course.glossary import read_glossary
from ..paths import MARK, Workbook, exercise_file
from ..tasks.case_types import TaskCases
from ..tasks.generate_cases import outline_of
from ..tasks.reference import in_process_ros
from ..tasks.strip_solution import BlankError
from ..tasks.task import TaskError, read_tasks
from .editions import exercise_notebook, lecture_notebook, text_of
from .execute import Outputs, run_page
from .exercise_rules import exercise_faults, form_faults, score_faults, untouched, untouched_faults
from .rules import page_faults
from .source import Page, PageError, PageFault, read_page

__all__ = ["Made", "make_page"]


class Made(NamedTuple):
    """What comes of a source: the text of each file by its path, and what is wrong."""

    files: dict[str, str]
    faults: list[PageFault]


async def make_page(path: Path) -> Made:
    """Make everything that comes of the source at `path`; a faulty one as far as it goes."""
    try:
        page = read_page(path)
        faults = page_faults(page, read_glossary())
        if path.parents[1].name == "solutions":
            return await _solution(page, faults)
        outputs, more = await run_page(page, f"notebooks/{LANGUAGES[0]}")
        translated, wrong = await _translated(page, outputs)
        return Made(_in_each_language(page, "notebooks", outputs, translated=translated), faults + more + wrong)
    except PageError as error:
        return Made({}, list(error.faults))


async def _translated(page: Page, outputs: Outputs) -> tuple[Outputs, list[PageFault]]:
    """Run a page as a Korean reader does, if a cell prints in the reader's language; return what such cells store."""
    marked = {cell.name for cell in page.code if "translated" in cell.tags}
    if not marked:
        return {}, []
    language = LANGUAGES[1]
    mark = json.dumps(asdict(Workbook(language=language))).encode()
    theirs, _ = await run_page(page, f"notebooks/{language}", {MARK: mark})
    remedy = 'tag what prints in the reader\'s language "translated", and nothing else'
    faults = []
    for cell in page.code:
        if (theirs[cell.name] == outputs[cell.name]) is (cell.name in marked):
            wrong = "prints the same in each language" if cell.name in marked else "prints in the reader's language"
            faults.append(page.fault(cell, wrong, remedy))
    return {name: theirs[name] for name in marked}, faults


async def _solution(page: Page, faults: list[PageFault]) -> Made:
    folder = page.path.parents[1] / "tasks" / page.stem
    try:
        with in_process_ros():
            tasks = read_tasks(folder)
    except TaskError as error:
        return Made({}, [*faults, page.fault(None, str(error), "fix the chapter's tasks")])
    faults += exercise_faults(page, tasks) + form_faults(page, tasks)
    outlines = {task.id: outline_of(task) for task in tasks}
    files_of_tasks = (path for path in sorted(folder.glob("*")) if path.is_file())
    beside = {path.relative_to(folder.parents[2]).as_posix(): path.read_bytes() for path in files_of_tasks}
    beside[f"solutions/en/{page.stem}.ipynb"] = text_of(lecture_notebook(page, "en", {}, outlines)).encode()
    outputs, more = await run_page(page, f"solutions/{LANGUAGES[0]}", beside)
    faults += more + score_faults(page, outlines, outputs)
    if not faults:
        blanked, _ = await run_page(untouched(page), f"exercises/{LANGUAGES[0]}", beside)
        faults += untouched_faults(page, blanked)
    files = _in_each_language(page, "solutions", outputs, outlines)
    for language in LANGUAGES:
        try:
            exercise = text_of(exercise_notebook(page, language, outlines))
            files[f"exercises/{language}/{exercise_file(page.stem)}"] = exercise
        except BlankError:  # which is a fault already
            assert faults
    return Made(files, faults)


def _in_each_language(
    page: Page,
    room: str,
    outputs: Outputs,
    tasks: dict[str, TaskCases] | None = None,
    translated: Outputs | None = None,
) -> dict[str, str]:
    """Return the notebook of each language; the English outputs stand in all, but for those that were translated."""
    each = {language: outputs if language == LANGUAGES[0] else outputs | (translated or {}) for language in LANGUAGES}
    return {
        f"{room}/{language}/{page.stem}.ipynb": text_of(lecture_notebook(page, language, printed, tasks))
        for language, printed in each.items()
    }
