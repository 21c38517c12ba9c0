"""Write notebooks as HTML that needs no Python: `tflab build --html PAGE`.

    notebook  --run in a kernel, pictures filmed-->  executed  --export-->  page.html + assets/

Each notebook is run in a folder of its own, so nothing is written beside the
source; then `tflab.views.export` makes a page of it that works from a disk, with
no kernel and no network: 3D turns, and every view keeps one scrubber.
"""

from __future__ import annotations

import os
import re
import shutil
import sys
from collections.abc import Mapping, Sequence, Set
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from ..paths import Workbook, stems_called, workbook_data, write_workbook
from .execute import merged_streams, running_kernel, wait_for

__all__ = ["PageRunError", "html_from_notebook", "notebooks_called", "run_with_films", "write_html"]

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

    Its links to notebooks lead to those `beside` it, by their stems, and to pages that are there; others are words.

    Raises:
        PageRunError: it is no notebook, or a cell raised an error.
    """
    from tflab.views.export import export_html

    with TemporaryDirectory() as folder:
        executed = run_with_films(notebook, Path(folder))
        exported = export_html(executed, Path(folder) / "pages")
        text = exported.read_text(encoding="utf-8")
        there = beside | {path.stem for path in out_dir.glob("*.html")}
        exported.write_text(LINK.sub(lambda link: _linked(link, there), text), encoding="utf-8")
        shutil.copytree(exported.parent, out_dir, dirs_exist_ok=True)
        return out_dir / exported.name


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
