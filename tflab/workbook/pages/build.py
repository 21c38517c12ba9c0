"""Build the notebooks of the workbook: `tflab build`.

    tflab build            everything, two pages at a time
    tflab build 03         what has this number, or stem
    tflab build --check    write nothing; print what is stale, and why
    tflab build --html     the pages as a book (`site.py`); named pages, each by itself (`html.py`)

    notebooks/src/03_x.py                --run-->  notebooks/{en,ko}/03_x.ipynb
    solutions/src/03_x.py                --run-->  solutions/{en,ko}/03_x.ipynb
        + solutions/tasks/03_x/e3_1.py  -------->  exercises/{en,ko}/E03_x.ipynb

A solution runs beside its tasks, so its checks compute their cases from the source that is being built.  An
exercise runs unanswered: it must reach its end and pass nothing.  The result depends on the sources and on tflab
alone.  A page with a fault is not written, and all faults are printed at once.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import sys
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass, field
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

from ...text import LANGUAGES
from ..atomic_files import write_whole
from ..course.glossary import read_glossary
from ..paths import MARK, Workbook, chapter_of, exercise_file, stems_called, workbook_data
from ..tasks.case_types import TaskCases
from ..tasks.generate_cases import outline_of
from ..tasks.reference import in_process_ros
from ..tasks.strip_solution import BlankError
from ..tasks.task import TaskError, read_tasks
from .editions import exercise_notebook, lecture_notebook, text_of
from .execute import Outputs, run_page, wait_for
from .exercise_rules import exercise_faults, form_faults, score_faults, untouched, untouched_faults
from .html import write_html
from .rules import page_faults
from .site import write_book
from .source import Page, PageError, PageFault, read_page
from .stale import stale

__all__ = ["BuildResult", "PageFiles", "build", "build_pages", "make_page", "sources", "write_files"]


class PageFiles(NamedTuple):
    """What comes of a source: the text of each file by its path, and what is wrong."""

    files: dict[str, str]
    faults: list[PageFault]


async def make_page(path: Path) -> PageFiles:
    """Make everything that comes of the source at `path`; a faulty one as far as it goes."""
    try:
        page = read_page(path)
        faults = page_faults(page, read_glossary())
        if path.parents[1].name == "solutions":
            return await _solution(page, faults)
        outputs, more = await run_page(page, f"notebooks/{LANGUAGES[0]}")
        translated, wrong = await _translated(page, outputs)
        return PageFiles(_in_each_language(page, "notebooks", outputs, translated=translated), faults + more + wrong)
    except PageError as error:
        return PageFiles({}, list(error.faults))


async def _translated(page: Page, outputs: Outputs) -> tuple[Outputs, list[PageFault]]:
    """Run a page as a Korean reader does, if a cell prints in the reader's language; return what such cells store."""
    marked = {cell.name for cell in page.code if "translated" in cell.tags and cell.name in outputs}
    if not marked:
        return {}, []
    language = LANGUAGES[1]
    mark = json.dumps(asdict(Workbook(language=language))).encode()
    theirs, _ = await run_page(page, f"notebooks/{language}", {MARK: mark})
    remedy = 'tag what prints in the reader\'s language "translated", and nothing else'
    faults = []
    for cell in (cell for cell in page.code if cell.name in outputs):
        if (theirs[cell.name] == outputs[cell.name]) is (cell.name in marked):
            wrong = "prints the same in each language" if cell.name in marked else "prints in the reader's language"
            faults.append(page.fault(cell, wrong, remedy))
    return {name: theirs[name] for name in marked}, faults


async def _solution(page: Page, faults: list[PageFault]) -> PageFiles:
    folder = page.path.parents[1] / "tasks" / page.stem
    try:
        with in_process_ros():
            tasks = read_tasks(folder)
    except TaskError as error:
        return PageFiles({}, [*faults, page.fault(None, str(error), "fix the chapter's tasks")])
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
    return PageFiles(files, faults)


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


FOLDERS = ("notebooks", "solutions")
Progress = Callable[[str], None]


@dataclass
class BuildResult:
    """What came of a build.

    Attributes:
        files: the text of each file, by its path in the workbook.
        faults: what is wrong with the sources.
        faulty: the files of pages with faults, where there is enough of them to look at.
    """

    files: dict[str, str] = field(default_factory=dict)
    faults: list[PageFault] = field(default_factory=list)
    faulty: dict[str, str] = field(default_factory=dict)


def build(words: Sequence[str]) -> int:
    """Build pages; return 0, 1 if a page has a fault or is stale, 2 if there is nothing to build."""
    options = _options(words)
    if options.html:
        return _write_html(options)
    root = Path(options.root) if options.root else workbook_data()
    if find_spec("jupytext") is None:
        print("tflab build: sources are read with jupytext; run: pip install 'tflab[dev]'", file=sys.stderr)
        return 2
    try:
        chosen = sources(root, options.pages)
    except LookupError as nothing:
        print(f"tflab build: {nothing}", file=sys.stderr)
        return 2
    built = build_pages(chosen, jobs=options.jobs, progress=_shown_progress(len(chosen)))
    for fault in built.faults:
        print(fault, file=sys.stderr)
    if options.check:
        return _say_what_is_stale(root, built, all_of_them=not options.pages)
    return _write_what_was_built(root, built, options.draft)


def _say_what_is_stale(root: Path, built: BuildResult, all_of_them: bool) -> int:
    lines = [*stale(root, built.files), *(_without_source(root) if all_of_them else ())]
    for line in lines:
        print(line)
    if lines:
        print(_count(len(lines), "file is stale", "files are stale"))
    elif not built.faults:
        print("nothing is stale")
    if built.faults:
        found = _count(len(built.faults), "fault", "faults")
        print(f"{found}; the pages that have them were not compared", file=sys.stderr)
    return 1 if lines or built.faults else 0


def _write_what_was_built(root: Path, built: BuildResult, is_draft: bool) -> int:
    files = built.files | (built.faulty if is_draft else {})
    written = write_files(root, files)
    print(f"{_count(len(written), 'file', 'files')} written, {len(files) - len(written)} as they were")
    for line in _without_source(root):
        print(line)
    if built.faults:
        left = "written all the same" if is_draft else "not written; --draft writes them all the same"
        print(f"{_count(len(built.faults), 'fault', 'faults')}; the pages that have them are {left}", file=sys.stderr)
    return 1 if built.faults else 0


def _write_html(options: argparse.Namespace) -> int:
    out = Path(options.out)
    if options.pages:
        return write_html(options.pages, out, options.lang or LANGUAGES[0])
    return write_book(out, [options.lang] if options.lang else LANGUAGES, reference=options.reference)


def sources(root: Path, wanted: Iterable[str] = ()) -> list[Path]:
    """Return the sources below `root` with these stems or numbers, all if there are none.

    Raises:
        LookupError: there are none.
    """
    there = [path for folder in FOLDERS for path in sorted((root / folder / "src").glob("*.py"))]
    if not there:
        raise LookupError(f"there are no pages in {root / 'notebooks' / 'src'}; a wheel holds only what was built")
    called = stems_called(wanted, sorted({path.stem for path in there}))
    return [path for stem in called for path in there if path.stem == stem] or there


def build_pages(chosen: Sequence[Path], *, jobs: int = 2, progress: Progress = lambda line: None) -> BuildResult:
    """Build these sources in memory, `jobs` kernels at a time; nothing is written."""
    return wait_for(_build_all(chosen, jobs, progress))


def write_files(root: Path, files: dict[str, str]) -> list[str]:
    """Write what is different, each file whole or not at all; return what was written."""
    written = []
    for name, text in sorted(files.items()):
        path = root / name
        data = text.encode("utf-8")
        if path.is_file() and path.read_bytes() == data:
            continue
        write_whole(path, data)
        written.append(name)
    return written


async def _build_all(chosen: Sequence[Path], jobs: int, progress: Progress) -> BuildResult:
    turn = asyncio.Semaphore(max(1, jobs))

    async def build_one(path: Path) -> PageFiles:
        async with turn:
            made = await make_page(path)
        name = f"{path.parents[1].name}/{path.stem}"
        progress(f"{name}: {_count(len(made.faults), 'fault', 'faults')}" if made.faults else name)
        return made

    longest_first = sorted(chosen, key=lambda path: path.parents[1].name != "solutions")
    pages = dict(zip(longest_first, await asyncio.gather(*map(build_one, longest_first)), strict=True))
    built = BuildResult()
    for path in chosen:
        made = pages[path]
        (built.faulty if made.faults else built.files).update(made.files)
        built.faults += made.faults
    return built


def _without_source(root: Path) -> list[str]:
    """Return a line for each built file that nothing builds any more."""
    lines = []
    for folder, source in (("notebooks", "notebooks"), ("solutions", "solutions"), ("exercises", "solutions")):
        stems = {path.stem for path in (root / source / "src").glob("*.py")}
        for path in sorted((root / folder).glob("*/*.ipynb")):
            if chapter_of(path) not in stems:
                lines.append(f"{path.relative_to(root).as_posix()}: has no source any more; delete it")
    return lines


def _options(words: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="tflab build", description="Run the pages, and write their notebooks.")
    parser.add_argument("pages", nargs="*", metavar="STEM", help="such as 03; every page if left out")
    parser.add_argument("--check", action="store_true", help="write nothing: say what is stale, and why")
    parser.add_argument("--draft", action="store_true", help="write pages that have faults, too")
    parser.add_argument("--jobs", type=int, default=2, metavar="N", help="kernels at a time (%(default)s)")
    parser.add_argument("--root", metavar="DIR", help="the folder with notebooks/src, instead of tflab's own")
    parser.add_argument("--html", action="store_true", help="write the book, or these notebooks, as HTML for a disk")
    parser.add_argument("--out", default="html", metavar="DIR", help="where --html writes (%(default)s)")
    parser.add_argument("--lang", choices=LANGUAGES, help="of the pages that --html writes; both if left out")
    parser.add_argument("--reference", action="store_true", help="with --html: what the docstrings say, too")
    return parser.parse_args(list(words))


def _shown_progress(total: int) -> Progress:
    done = 0

    def show(line: str) -> None:
        nonlocal done
        done += 1
        print(f"[{done}/{total}] {line}", file=sys.stderr, flush=True)

    return show


def _count(number: int, one: str, many: str) -> str:
    return f"{number} {one if number == 1 else many}"
