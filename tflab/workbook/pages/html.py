"""Write notebooks as HTML that needs no Python: `tflab build --html PAGE`, `tflab export NOTEBOOK`.

    notebook  --run in a kernel, pictures filmed-->  executed  --export-->  page.html + assets/

Each notebook is run in a folder of its own, so nothing is written beside the
source; then `tflab.views.export` makes a page of it that works from a disk, with
no kernel and no network: 3D turns, and every view keeps one scrubber.  The page has the
frame of the web book: its sections, light or dark.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import sys
from collections.abc import Mapping, Sequence, Set
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from ..book.pages import STATIC, BookPage, framed
from ..book.search_index import sections_of
from ..paths import Workbook, stems_called, workbook_data, write_workbook
from .execute import merged_streams, running_kernel, wait_for

__all__ = ["PageRunError", "html_from_notebook", "main", "notebooks_called", "run_with_films", "write_html"]

SECONDS_FOR_A_CELL = 120
LINK = re.compile(r'<a href="(?:[\w.-]+/)*(?P<page>[\w-]+)\.ipynb(?P<place>#[^"]*)?"[^>]*>(?P<said>.*?)</a>', re.DOTALL)


def write_html(names: Sequence[str], out_dir: Path, language: str = "en") -> int:
    """Write notebooks as HTML, the built pages if none is named; return 0, 1 if one failed, 2 if there is nothing.

    Args:
        names: paths of notebooks, or stems and numbers of built pages.
    """
    built = workbook_data() / "notebooks" / language
    try:
        notebooks = notebooks_called(names, built) if names else sorted(built.glob("*.ipynb"))
    except LookupError as nothing:
        print(f"tflab build: {nothing}", file=sys.stderr)
        return 2
    if not notebooks:
        print(f"tflab build: there is no notebook in {built}", file=sys.stderr)
        return 2
    failed = 0
    for number, notebook in enumerate(notebooks, start=1):
        print(f"[{number}/{len(notebooks)}] {notebook.name}", end=" ", flush=True)
        try:
            print(html_from_notebook(notebook, out_dir, {other.stem for other in notebooks}))
        except PageRunError as failure:
            print(f"failed\n{failure}", file=sys.stderr)
            failed += 1
    return 1 if failed else 0


def notebooks_called(words: Sequence[str], folder: Path) -> list[Path]:
    """Return the notebooks that words name: by path, or those in `folder` by stem or number.

    Raises:
        LookupError: a word names none.
    """
    there = sorted(path.stem for path in folder.glob("*.ipynb"))
    called: list[Path] = []
    for word in words:
        is_path = Path(word).is_file()
        called += [Path(word)] if is_path else [folder / f"{stem}.ipynb" for stem in stems_called([word], there)]
    return called


class PageRunError(Exception):
    """A file is no notebook, or one of its cells raised an error; the text says which, and what."""


def html_from_notebook(notebook: Path, out_dir: Path, beside: Set[str] = frozenset()) -> Path:
    """Run a copy of `notebook` and write it as HTML into `out_dir`; return the page's path.

    Its links to notebooks lead to those `beside` it, by their stems, and to pages that are there; others are text.

    Raises:
        PageRunError: it is no notebook, or a cell raised an error.
    """
    with TemporaryDirectory() as folder:
        return _write_page(run_with_films(notebook, Path(folder)), out_dir, beside)


def main(words: Sequence[str]) -> int:
    """Run `tflab export NOTEBOOK`: write an executed notebook as HTML; return the exit code."""
    from tflab.views.export import NotANotebook
    from tflab.views.export_widgets import NOT_STORED, STANDS_STILL

    parser = argparse.ArgumentParser(prog="tflab export", description="Write an executed notebook as HTML.")
    parser.add_argument(
        "notebook", type=Path, metavar="NOTEBOOK", help="a notebook that has been run, with its widgets' state"
    )
    parser.add_argument("--out", type=Path, default="html", metavar="DIR", help="where to; %(default)s if left out")
    parser.add_argument("--single-file", action="store_true", help="put everything into one file that can be mailed")
    asked = parser.parse_args(words)
    try:
        page = _write_page(asked.notebook, asked.out, single_file=asked.single_file)
    except FileNotFoundError:
        print(f'tflab export: there is no notebook "{asked.notebook}"', file=sys.stderr)
        return 2
    except NotANotebook as fault:
        print(f"tflab export: {fault}", file=sys.stderr)
        return 2
    print(page)
    text = page.read_text(encoding="utf-8")
    lost, fixed = (sum(map(text.count, texts.values())) for texts in (NOT_STORED, STANDS_STILL))
    for count, what in ((lost, "live views that the notebook does not store"), (fixed, "panels without a slider")):
        if count:
            remedy = f'To run a copy of the notebook and keep them: tflab build --html "{asked.notebook}"'
            print(f"tflab export: {what}: {count}. {remedy}", file=sys.stderr)
    return 0


def _write_page(notebook: Path, out_dir: Path, beside: Set[str] = frozenset(), *, single_file: bool = False) -> Path:
    """Write an executed notebook as a page in the frame of the book; return the page's path.

    Raises:
        FileNotFoundError: there is no such notebook.
        NotANotebook: the file is something else.
    """
    from tflab.views.export import export_html, page_language, page_title, read_notebook

    executed = read_notebook(notebook)
    path = export_html(notebook, out_dir, single_file)
    there = beside | {page.stem for page in out_dir.glob("*.html")}
    text = LINK.sub(lambda link: _linked(link, there), path.read_text(encoding="utf-8"))
    page = BookPage(path.name, page_title(executed) or path.stem, text, sections_of(text), is_chapter=False)
    text = framed(page, [page], page_language(executed), assets="assets")
    for name in ("book.css", "book.js"):
        if single_file:
            text = _with_file_inside(text, STATIC / name)
        else:
            shutil.copyfile(STATIC / name, out_dir / "assets" / name)
    path.write_text(text, encoding="utf-8")
    return path


def _with_file_inside(page: str, path: Path) -> str:
    """Return a page with a style or script of the book in the place of the link to it."""
    content = path.read_text(encoding="utf-8")
    if path.suffix == ".css":
        return page.replace(f'<link rel="stylesheet" href="assets/{path.name}">', f"<style>{content}</style>")
    tag = re.search(rf'<script defer src="[^"]*{path.name}"([^>]*)></script>', page)
    page = page.replace(tag[0], "")
    before, end, rest = page.rpartition("</body>")
    return f"{before}<script{tag[1]}>{content}</script>\n{end}{rest}"


def _linked(link: re.Match[str], there: Set[str]) -> str:
    if link["page"] not in there:
        return link["said"]
    return f'<a href="{link["page"]}.html{link["place"] or ""}">{link["said"]}</a>'


async def _run(client: Any, env: Mapping[str, str]) -> None:
    """Run all cells of a client's notebook, and keep the state of its widgets."""
    async with running_kernel(client, env):
        for number, cell in enumerate(client.nb.cells):
            await client.async_execute_cell(cell, number)
        client.set_widgets_metadata()


def run_with_films(notebook: Path, folder: Path) -> Path:
    """Run a copy of `notebook` in `folder`, with its sliders filmed; return the copy's path.

    Raises:
        PageRunError: it is no notebook, or a cell raised an error.
    """
    import nbformat
    from nbclient import NotebookClient
    from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError

    from tflab.views.export import NotANotebook, page_language, read_notebook

    try:
        page = read_notebook(notebook)
    except NotANotebook as fault:
        raise PageRunError(f"{fault}") from None
    _as_a_copy(folder, page_language(page))
    client = NotebookClient(page, timeout=SECONDS_FOR_A_CELL, resources={"metadata": {"path": str(folder)}})
    try:
        wait_for(_run(client, {**os.environ, "TFLAB_FILMS": "1"}))
    except (CellExecutionError, CellTimeoutError, DeadKernelError) as error:
        raise PageRunError(f"{notebook.name}: {error}") from None
    for cell in page.cells:
        if cell.cell_type == "code":  # a stream comes in pieces, cut somewhere else every time
            cell.outputs = [nbformat.from_dict(output) for output in merged_streams(cell.outputs)]
        for output in cell.get("outputs", ()):
            if output.output_type == "error":  # one that is meant: a reader needs its text, not where Python was
                output.traceback = [f"{output.ename}: {output.evalue}"]
    executed = folder / notebook.name
    nbformat.write(page, executed)
    return executed


def _as_a_copy(folder: Path, language: str) -> None:
    """Let a page find what it finds in a learner's copy: its language."""
    write_workbook(folder, Workbook(language=language))
