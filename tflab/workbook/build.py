"""How do pages become notebooks?  `tflab build`: read, look for faults, run once, write every edition.

    notebooks/src/03_x.py                     --run-->  notebooks/{en,ko}/03_x.ipynb
    solutions/src/03_x.py                     --run-->  solutions/{en,ko}/03_x.ipynb
        + solutions/tasks/03_x.py             -------->  exercises/{en,ko}/03_x.ipynb, exercises/cases/03_x.json

    tflab build            everything
    tflab build 03         what has this number, or stem
    tflab build --check    write nothing; say what is stale, and why
    tflab build --html     the built notebooks as HTML (`html.py`)

The result depends on the sources and on tflab, and on nothing else: two builds are
the same bytes.  A page with a fault is not written, and all faults are said at once.

Read `html.py` next.
"""

from __future__ import annotations

import argparse
import asyncio
import re
import sys
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from .editions import exercise_notebook, lecture_notebook, text_of
from .execute import Outputs, run_page
from .exercise_rules import exercise_faults, score_faults, untouched, untouched_faults
from .places import workbook_data
from .rules import page_faults
from .source import LANGUAGES, Fault, Page, PageError, read_page
from .stale import stale
from .whole_files import write_whole

__all__ = ["Built", "build", "build_pages", "sources", "write_files"]

FOLDERS = ("notebooks", "solutions")
Progress = Callable[[str], None]


@dataclass
class Built:
    """What came of a build.

    Attributes:
        files: the text of each file, by its path in the workbook.
        faults: what is wrong with the sources.
        faulty: the files of pages with faults, where there is enough of them to look at.
    """

    files: dict[str, str] = field(default_factory=dict)
    faults: list[Fault] = field(default_factory=list)
    faulty: dict[str, str] = field(default_factory=dict)


def build(words: Sequence[str]) -> int:
    """Build pages; return 0, 1 if a page has a fault or is stale, 2 if there is nothing to build."""
    options = _options(words)
    if options.html:
        from .html import write_html

        return write_html(options.pages, Path(options.out), options.lang)
    root = Path(options.root) if options.root else workbook_data()
    try:
        chosen = sources(root, options.pages)
    except LookupError as nothing:
        print(f"tflab build: {nothing}", file=sys.stderr)
        return 2
    built = build_pages(root, chosen, jobs=options.jobs, progress=_shown_progress(len(chosen)))
    for fault in built.faults:
        print(fault, file=sys.stderr)
    if options.check:
        lines = [*stale(root, built.files), *(_without_source(root) if not options.pages else ())]
        for line in lines:
            print(line)
        print(_count(len(lines), "file is stale", "files are stale") if lines else "nothing is stale")
        return 1 if lines or built.faults else 0
    files = built.files | (built.faulty if options.draft else {})
    written = write_files(root, files)
    print(f"{_count(len(written), 'file', 'files')} written, {len(files) - len(written)} as they were")
    for line in _without_source(root):
        print(line)
    if built.faults:
        left = "written all the same" if options.draft else "not written; --draft writes them all the same"
        print(f"{_count(len(built.faults), 'fault', 'faults')}; the pages that have them are {left}", file=sys.stderr)
    return 1 if built.faults else 0


def sources(root: Path, wanted: Iterable[str] = ()) -> list[Path]:
    """Return the sources below `root` with these stems or numbers, all if there are none.

    Raises:
        LookupError: there are none.
    """
    there = [path for folder in FOLDERS for path in sorted((root / folder / "src").glob("*.py"))]
    if not there:
        raise LookupError(f"there are no pages in {root / 'notebooks' / 'src'}; a wheel holds only what was built")
    chosen: list[Path] = []
    for word in wanted:
        found = [path for path in there if word in (path.stem, path.stem.partition("_")[0])]
        if not found:
            stems = sorted({path.stem for path in there})
            raise LookupError(f'there is no page "{word}"; there is {", ".join(stems)}')
        chosen += [path for path in found if path not in chosen]
    return chosen or there


def build_pages(root: Path, chosen: Sequence[Path], *, jobs: int = 2, progress: Progress = lambda line: None) -> Built:
    """Build these sources in memory, `jobs` kernels at a time; nothing is written."""
    work = _build_all(root, chosen, jobs, progress)
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return asyncio.run(work)
    with ThreadPoolExecutor(1) as thread:  # somebody else's loop runs here: Jupyter's, or a browser's
        return thread.submit(asyncio.run, work).result()


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


async def _build_all(root: Path, chosen: Sequence[Path], jobs: int, progress: Progress) -> Built:
    terms = _terms()
    turn, cases_turn = asyncio.Semaphore(max(1, jobs)), asyncio.Lock()
    tasks = []
    async with asyncio.TaskGroup() as group:
        for path in chosen:
            tasks.append(group.create_task(_build_page(root, path, terms, turn, cases_turn, progress)))
    built = Built()
    for task in tasks:
        files, faults = task.result()
        (built.faulty if faults else built.files).update(files)
        built.faults += faults
    return built


async def _build_page(
    root: Path,
    path: Path,
    terms: set[str] | None,
    turn: asyncio.Semaphore,
    cases_turn: asyncio.Lock,
    progress: Progress,
) -> tuple[dict[str, str], list[Fault]]:
    """Return the files that come from one source, and its faults."""
    async with turn:
        name = f"{path.parent.parent.name}/{path.stem}"
        try:
            page = read_page(path)
            faults = page_faults(page, terms)
            solved = path.parent.parent.name == "solutions"
            cases: dict[str, Any] | None = None
            if solved:
                async with cases_turn:  # it puts tflab's rclpy in place for its time
                    cases, more = await asyncio.to_thread(_cases, root, page)
                faults += more
            public = {page.stem: _cases_text(cases)} if cases else {}
            outputs, more = await run_page(page, f"{path.parent.parent.name}/{LANGUAGES[0]}", public)
            faults += more
            faults += score_faults(page, cases["tasks"] if cases else (), outputs)
            if solved and not faults:
                blanked, _ = await run_page(untouched(page), f"exercises/{LANGUAGES[0]}", public)
                faults += untouched_faults(page, blanked)
            files = _solution_files(page, outputs, cases, public, faults) if solved else _lecture_files(page, outputs)
        except PageError as error:
            files, faults = {}, list(error.faults)
        progress(f"{name}: {_count(len(faults), 'fault', 'faults')}" if faults else name)
        return files, faults


def _lecture_files(page: Page, outputs: Outputs) -> dict[str, str]:
    return {
        f"notebooks/{language}/{page.stem}.ipynb": text_of(lecture_notebook(page, language, outputs))
        for language in LANGUAGES
    }


def _solution_files(
    page: Page, outputs: Outputs, cases: dict[str, Any] | None, public: dict[str, str], faults: list[Fault]
) -> dict[str, str]:
    from .blank import BlankError

    tasks = cases["tasks"] if cases else {}
    files = {f"exercises/cases/{stem}.json": text for stem, text in public.items()}
    for language in LANGUAGES:
        files[f"solutions/{language}/{page.stem}.ipynb"] = text_of(lecture_notebook(page, language, outputs, tasks))
        try:
            files[f"exercises/{language}/{page.stem}.ipynb"] = text_of(exercise_notebook(page, language, tasks))
        except BlankError:  # which is a fault already
            assert faults
    return files


def _cases(root: Path, page: Page) -> tuple[dict[str, Any] | None, list[Fault]]:
    """Return the public cases of a solution, and what is wrong with its tasks."""
    from .cases import FORMAT, PUBLIC_SEED, task_cases
    from .reference import CodeCell, Solution, in_process_ros
    from .tasks import TaskError, read_tasks

    tasks_file = root / "solutions" / "tasks" / f"{page.stem}.py"
    try:
        tasks = read_tasks(tasks_file)
    except TaskError as error:
        return None, [page.fault(None, str(error), "mend the chapter's tasks")]
    faults = exercise_faults(page, tasks)
    solution = Solution(page.stem, [CodeCell(cell.name, cell.source) for cell in page.code])
    made = {}
    with in_process_ros():
        for task in tasks:
            try:
                made[task.id] = task_cases(task, PUBLIC_SEED, solution)
            except Exception as error:  # a generator or a twin may fail in any way
                faults.append(_task_fault(page, tasks_file, task.id, error))
    return {"format": FORMAT, "chapter": page.stem, "tasks": made}, faults


def _task_fault(page: Page, tasks_file: Path, task: str, error: Exception) -> Fault:
    """Return what is wrong with a task: at its answer's cell if that fails, else in the chapter's tasks."""
    from .cases import CasesError
    from .reference import answer_cell_name
    from .tasks import TaskError

    if isinstance(error, TaskError) and not isinstance(error, CasesError):
        cell = next((cell for cell in page.code if cell.name == answer_cell_name(task)), None)
        return page.fault(cell, str(error), "mend the answer, or what is given")
    lines = tasks_file.read_text(encoding="utf-8").splitlines()
    line = next((n for n, text in enumerate(lines, start=1) if re.search(rf"\bid\s*=\s*[\"']{task}[\"']", text)), 1)
    wrong = str(error) if isinstance(error, TaskError) else f"{task}: {type(error).__name__}: {error}"
    return Fault("/".join(tasks_file.parts[-3:]), line, "", wrong, f"mend {task}")


def _cases_text(cases: dict[str, Any]) -> str:
    from .cases import cases_json

    return cases_json(cases)


def _terms() -> set[str] | None:
    from .glossary import GLOSSARY, read_glossary

    return set(read_glossary()) if GLOSSARY.is_file() else None


def _without_source(root: Path) -> list[str]:
    """Return a line for each built file that nothing builds any more."""
    lines = []
    for folder, source in (("notebooks", "notebooks"), ("solutions", "solutions"), ("exercises", "solutions")):
        stems = {path.stem for path in (root / source / "src").glob("*.py")}
        for path in sorted([*(root / folder).glob("*/*.ipynb"), *(root / folder).glob("cases/*.json")]):
            if path.stem not in stems:
                lines.append(f"{path.relative_to(root).as_posix()}: has no source any more; delete it")
    return lines


def _options(words: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="tflab build", description="Run the pages, and write their notebooks.")
    parser.add_argument("pages", nargs="*", metavar="STEM", help="such as 03; every page if left out")
    parser.add_argument("--check", action="store_true", help="write nothing: say what is stale, and why")
    parser.add_argument("--draft", action="store_true", help="write pages that have faults, too")
    parser.add_argument("--jobs", type=int, default=2, metavar="N", help="kernels at a time (%(default)s)")
    parser.add_argument("--root", metavar="DIR", help="the folder with notebooks/src, instead of tflab's own")
    parser.add_argument("--html", action="store_true", help="write built notebooks as pages that work from a disk")
    parser.add_argument("--out", default="html", metavar="DIR", help="where --html writes (%(default)s)")
    parser.add_argument("--lang", choices=LANGUAGES, default="en", help="of the pages that --html writes (%(default)s)")
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
