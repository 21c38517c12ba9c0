"""Grade a learner's own notebook on the public cases: `tflab check NOTEBOOK`, or one task: `tflab check E3.2`.

    E3.1  ✓ 3/3 points
    E3.2  ✗ 0/2 points   You swapped target and source.
    E3.4  – not answered

It goes the way that grading goes: only the answers are taken, they run in a fresh
kernel from the top, and what grading would ignore is said.  Its cases are the public
ones.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from tflab import __version__
from tflab.text import Text, Texts
from tflab.workbook import paths
from tflab.workbook.copy.lay_out import read_pristine
from tflab.workbook.paths import Workbook, WorkbookError, read_workbook, workbook_data, workbook_root
from tflab.workbook.phrases import points, show_points
from tflab.workbook.tasks.catalog import assigned_cases, task_ids
from tflab.workbook.tasks.task import TaskError

from .judging.cells import master_of
from .judging.job import HandedIn, Job, RunCells
from .judging.pack import MALFORMED
from .judging.submission import grade_submission
from .kernels.limits import Limits
from .reports.feedback import SIGNS
from .reports.feedback import TEXTS as FEEDBACK
from .submissions.reader import Unreadable, read_bytes, read_notebook
from .submissions.remarks import Remark

__all__ = ["Checked", "check_notebook", "main"]

PLAIN_LIMITS = Limits(cell_s=20.0, notebook_s=120.0)  # a kernel may be the first of the day on a slow disk
MENDS = "`tflab lab --update` brings it"
TEXTS = Texts(__file__)
SYSTEMS = {"win32": "Windows", "darwin": "macOS"}


class Checked(NamedTuple):
    """What a check found: the record of a submission, its chapter, and what ran it."""

    record: dict[str, Any]
    stem: str
    tasks: Mapping[str, Any]
    language: str
    note: str
    in_class: bool


def main(words: Sequence[str]) -> int:
    """Check a notebook; return 0 if all of it is right, 1 if something is not, 2 if it cannot be checked."""
    parser = argparse.ArgumentParser(prog="tflab check", description="See your notebook as grading will.")
    parser.add_argument(
        "notebook",
        metavar="NOTEBOOK",
        help="an exercise that you have answered, its number (03), or one of its tasks (E3.2)",
    )
    parser.add_argument("--plain", action="store_true", help="in an ordinary kernel, without a sandbox")
    options = parser.parse_args(list(words))
    notebook = Path(options.notebook)
    chapter, task = re.fullmatch(r"(E\d+)(\.\d+)|.*", options.notebook).groups()
    try:
        notebook = _called(chapter or options.notebook)
        checked = check_notebook(notebook, plainly=options.plain)
    except (Unreadable, WorkbookError, TaskError) as error:
        said = error.remark.say(_language_at(notebook)) if isinstance(error, Unreadable) else error
        print(f"tflab check: {notebook}: {said}", file=sys.stderr)
        return 2
    if task:
        rows = checked.record["chapters"][checked.stem]["tasks"]
        if chapter + task not in rows:
            print(f"tflab check: unknown task {chapter + task}; available: {', '.join(rows)}", file=sys.stderr)
            return 2
        print(_line(chapter + task, rows[chapter + task], checked.tasks[chapter + task], checked.language))
        return 0 if rows[chapter + task]["status"] == "right" else 1
    lines, all_right = report(checked)
    print("\n".join(lines))
    return 0 if all_right else 1


def _called(word: str) -> Path:
    """Return the notebook that a word means: its path, else the stem or number of an exercise in the copy at hand."""
    root = paths.copy_at_hand()
    if Path(word).exists() or len(Path(word).parts) > 1 or Path(word).suffix:
        return Path(word)
    if root is None:
        raise WorkbookError(paths.NO_COPY.format(folder="here"))
    try:
        (stem,) = paths.stems_called([word], paths.chapters(root), what="exercise")
    except LookupError as nothing:
        raise WorkbookError(str(nothing)) from None
    called = root / "exercises" / read_workbook(root).language / paths.exercise_file(stem)
    if not called.exists():
        there = ", ".join(sorted(path.name for path in called.parent.glob("*.ipynb"))) or "no notebook"
        raise WorkbookError(
            f"is not there; the folder has {there}. "
            "Renamed? Type `tflab check` with its path. Lost? `tflab lab` lays out a new one"
        )
    return called


def _language_at(path: Path) -> str:
    """Return the language of the workbook that a file is in; English if there is none."""
    try:
        return read_workbook(workbook_root(path.resolve().parent)).language
    except WorkbookError:
        return "en"


def check_notebook(path: Path, *, plainly: bool = False) -> Checked:
    """Return what grading would make of a notebook, with the public cases.

    Raises:
        Unreadable: not a notebook, or of no chapter that is here.
        WorkbookError: the copy of the workbook that it is in is damaged, or a task asks something else than when it
            was handed out.
        TaskError: its tasks cannot be computed.
    """
    data = read_bytes(path.resolve())
    stamp = read_notebook(data).stamp
    root = workbook_root(path.resolve().parent)
    workbook = read_workbook(root)
    run_cells, limits, note = _runner(plainly, workbook.language)
    there = paths.chapters(root)
    called = [stem for stem in there if stem in path.name or stem == stamp.get("chapter")]
    job = Job(
        learner=workbook.learner or path.stem,
        name="",
        language=workbook.language,
        release=stamp.get("release", ""),
        version=__version__,
        files=(HandedIn(path.name, data),),
        chapters={},
        limits=limits,
        has_roster=workbook.learner is not None,
    )
    for stems in (called, there):  # all, if it was renamed, or is of another chapter than its name tells
        chapters = {stem: _chapter(root, workbook, stem) for stem in stems}
        record = grade_submission(replace(job, chapters=chapters), run_cells)  # without a second, longer run
        found = [stem for stem, chapter in record["chapters"].items() if chapter["file"]]
        if found:
            tasks = chapters[found[0]]["tasks"]
            return Checked(record, found[0], tasks, workbook.language, note, workbook.edition == "class")
    raise Unreadable("no chapter", root=root, there=", ".join(there) or "-")


def report(checked: Checked) -> tuple[list[str], bool]:
    """Return what to print, and whether all is right and nothing will be ignored."""
    language, chapter = checked.language, checked.record["chapters"][checked.stem]
    lines = [checked.note] if checked.note else []
    rows = chapter["tasks"]
    for task_id, row in rows.items():
        lines.append(_line(task_id, row, checked.tasks[task_id], language))
    remarks = [Remark.from_plain(remark).say(language) for remark in (*checked.record["remarks"], *chapter["remarks"])]
    remarks = list(dict.fromkeys(remarks))
    if remarks:
        lines += ["", TEXTS["ignored"].say(language), *(f"  {line}" for line in remarks)]
    got, most = (sum(row[name] for row in rows.values()) for name in ("points", "most"))
    total = TEXTS["sum"].say(language, points=points(got), most=points(most))
    lines += ["", total + " " + TEXTS["later"].say(language) if checked.in_class else total]
    if any(row["status"] == "unanswered" for row in rows.values()):
        lines.append(TEXTS["as_saved"].say(language))
    return lines, got == most and not remarks


def _line(task_id: str, row: Mapping[str, Any], task: Mapping[str, Any], language: str) -> str:
    sign, status = SIGNS[row["status"]], FEEDBACK[row["status"]]
    if task.get("counts") and row["passed"]:
        counted = TEXTS["answered"].say(language, passed=row["passed"], of=row["of"])
        return f"{task_id}  {sign} {counted}"
    if row["status"] == "right":
        return f"{task_id}  ✓ {_score(row, language)}"
    said = [Text(**row["said"]).say(language)] if row["said"] else []
    said += [Remark.from_plain(remark).say(language, with_task=False) for remark in row["remarks"]]
    said = said or [FEEDBACK["not_right"].say(language)]
    count = status.say(language) if row["status"] == "unanswered" else _score(row, language)
    return f"{task_id}  {sign} {count}" + ("" if row["status"] == "unanswered" else f"   {' '.join(said)}")


def _score(row: Mapping[str, Any], language: str) -> str:
    return show_points(row["points"], row["most"]).say(language)


def _chapter(root: Path, workbook: Workbook, stem: str) -> dict[str, Any]:
    """Return a chapter as it is graded, from what a learner has: the public cases, and the exercise as it came."""
    data, tasks = workbook_data(), {}
    for task_id in task_ids(data, stem, workbook):
        held = assigned_cases(data, stem, task_id, workbook).plain()
        tasks[task_id] = {name: part for name, part in held.items() if name != "variants"} | held["variants"][0]
    name = f"exercises/{workbook.language}/{paths.exercise_file(stem)}"
    pristine = read_pristine(root).get(name)
    try:
        handed_out = pristine if pristine is not None else (data / name).read_bytes()
        master = master_of(json.loads(handed_out), stem, tasks)
    except OSError:
        raise WorkbookError(f"the exercise {stem} as it was handed out is not there; {MENDS}") from None
    except MALFORMED as error:
        raise WorkbookError(f"{name} as it was handed out is damaged ({type(error).__name__}); {MENDS}") from None
    return {"master": [[cell.name, cell.source, cell.task, cell.role] for cell in master.cells], "tasks": tasks}


def _runner(plainly: bool, language: str) -> tuple[RunCells, Limits, str]:
    """Return what runs cells here, its limits, and a line about it if it is not what grading uses."""
    why = "--plain" if plainly else TEXTS["not_linux"].say(language, platform=SYSTEMS.get(sys.platform, sys.platform))
    if not plainly and sys.platform == "linux":
        from .judging.nbval_run import run_cells
        from .kernels.kernel_pool import KernelError, choose_sandbox

        try:
            return partial(run_cells, sandbox=choose_sandbox()), Limits(), ""
        except (KernelError, OSError) as error:
            why = str(error)
    from .judging.plain_kernel import run_plainly

    return run_plainly, PLAIN_LIMITS, TEXTS["plain"].say(language, why=why)
