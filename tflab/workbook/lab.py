"""How is the workbook opened?  `tflab lab [DIR]`: a JupyterLab that talks to nobody but the browser.

    tflab lab          the pages that come with tflab (installed: a copy of them, in ./tflab_workbook)
    tflab lab DIR      a folder of yours
    tflab lab -- ...   what stands after -- goes to JupyterLab itself: --no-browser, --port 9000

JupyterLab would look for news, for updates and for extensions on the network;
here it does none of that.
"""

from __future__ import annotations

import argparse
import os
import shutil
import sys
from collections.abc import Sequence
from pathlib import Path

__all__ = ["FIRST_PAGE", "QUIET_OPTIONS", "lab", "own_copy", "pages_folder"]

QUIET_OPTIONS = (
    "--LabApp.news_url=None",
    "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate",
    "--LabApp.extension_manager=readonly",
)
FIRST_PAGE = "00_start.ipynb"
COPY = "tflab_workbook"


def pages_folder() -> Path:
    """Return the folder of the pages that come with tflab: the wheel's, or in an editable install the repository's."""
    package = Path(__file__).resolve().parents[1]
    in_the_wheel = package / "_workbook"
    root = in_the_wheel if in_the_wheel.is_dir() else package.parent
    return root / "notebooks" / "en"


def own_copy(pages: Path) -> Path:
    """Return where to work on the pages: the repository's as they are, a wheel's in a copy below this folder.

    What is already in the copy is never touched: it may have been written on.
    """
    if "_workbook" not in pages.parts:
        return pages
    copy = Path.cwd() / COPY
    for page in sorted(pages.glob("*.ipynb")):
        if not (copy / page.name).exists():
            copy.mkdir(exist_ok=True)
            shutil.copyfile(page, copy / page.name)
    return copy


def lab(words: Sequence[str]) -> int:
    """Open JupyterLab on a folder; return when it has ended."""
    words, own_options = _split(words)
    parser = argparse.ArgumentParser(prog="tflab lab", description="Open the workbook in JupyterLab, offline.")
    parser.add_argument("folder", nargs="?", metavar="DIR", help="a folder of yours, instead of tflab's pages")
    folder = Path(parser.parse_args(words).folder or own_copy(pages_folder())).resolve()
    if not folder.is_dir():
        print(f"tflab lab: there is no folder {folder}", file=sys.stderr)
        return 2
    first_page = [f"--LabApp.default_url=/lab/tree/{FIRST_PAGE}"] if (folder / FIRST_PAGE).exists() else []
    os.chdir(folder)
    start_jupyterlab([*QUIET_OPTIONS, *first_page, *own_options])
    return 0


def start_jupyterlab(options: Sequence[str]) -> None:
    """Run JupyterLab in this very process, so that whatever ends this one ends it too."""
    from jupyterlab.labapp import main

    main(list(options))


def _split(words: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return the words before the first `--`, and those after it."""
    words = list(words)
    if "--" not in words:
        return words, []
    return words[: words.index("--")], words[words.index("--") + 1 :]
