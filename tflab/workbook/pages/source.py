"""Read the source of a page: prose in two languages, code once, a name on every cell.

    # %% [markdown] lang="en" name="why-frames" slide="slide"     prose, English first
    # %% [markdown] lang="ko" name="why-frames" slide="slide"     the same cell in Korean
    # %% name="load"                                              code, for both
    # %% [markdown] lang="en" name="why-notes" slide="notes"        what the speaker says

The format is jupytext's percent format.  This module reads it and says nothing about
what is right: a page's faults are looked for in `rules.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

__all__ = ["Page", "PageError", "PageFault", "SourceCell", "code_lines", "read_page"]

MARKER = re.compile(r"#\s*%%%*(\s.*)?$")
OPTIONS = {"lang", "name", "slide", "tags"}


@dataclass(frozen=True, slots=True)
class SourceCell:
    """One cell as it was written.

    Attributes:
        name: its name, "" if it has none; the id in the notebook.
        kind: "markdown" or "code".
        lang: "en" or "ko" for prose, None for code.
        slide: what it is in a deck: "slide", "subslide", "fragment", "notes", "skip" or "-".
        line: where its `# %%` stands, from 1.
        unknown: options that mean nothing here.
    """

    name: str
    kind: str
    lang: str | None
    tags: tuple[str, ...]
    slide: str
    source: str
    line: int
    unknown: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class PageFault:
    """What is wrong with a page, where, and what to do about it."""

    path: str
    line: int
    cell: str
    wrong: str
    remedy: str

    def __str__(self) -> str:
        where = f'cell "{self.cell}": ' if self.cell else ""
        return f"{self.path}:{self.line}: {where}{self.wrong}; {self.remedy}"


class PageError(Exception):
    """Pages that cannot be built as they are; `faults` says why, each with its place."""

    def __init__(self, *faults: PageFault) -> None:
        super().__init__("\n".join(str(fault) for fault in faults))
        self.faults = faults


@dataclass(frozen=True, slots=True)
class Page:
    """A page as it was written: its cells in order, both languages."""

    path: Path
    cells: tuple[SourceCell, ...]

    @property
    def stem(self) -> str:
        """Return the name that the page has in every folder, such as "03_target_and_source"."""
        return self.path.stem

    @property
    def shown_path(self) -> str:
        """Return the path as messages say it: from the workbook's folder on."""
        return "/".join(self.path.parts[-3:])

    @property
    def code(self) -> tuple[SourceCell, ...]:
        """Return the code cells."""
        return tuple(cell for cell in self.cells if cell.kind == "code")

    def in_language(self, language: str) -> Iterator[SourceCell]:
        """Yield the cells that a reader of `language` sees, and the speaker's notes among them."""
        return (cell for cell in self.cells if cell.lang in (None, language))

    def fault(self, cell: SourceCell | None, wrong: str, remedy: str) -> PageFault:
        """Return a fault of this page, at `cell` or at its top."""
        if cell is None:
            return PageFault(self.shown_path, 1, "", wrong, remedy)
        return PageFault(self.shown_path, cell.line, cell.name, wrong, remedy)


def read_page(path: str | Path) -> Page:
    """Read a page's source.

    Raises:
        FileNotFoundError: there is none at `path`.
        PageError: it is not in the percent format.
    """
    import jupytext  # which only whoever builds pages has

    path = Path(path)
    text = path.read_text(encoding="utf-8")
    lines = [number for number, line in enumerate(text.splitlines(), start=1) if MARKER.match(line)]
    read = jupytext.reads(text, fmt="py:percent").cells
    page = Page(path, ())
    if len(read) != len(lines):
        wrong = f"{len(lines)} cells are marked and {len(read)} are there"
        remedy = 'begin the file with "# %%", and begin no other line like that'
        raise PageError(page.fault(None, wrong, remedy))
    return Page(path, tuple(_cell(cell, line) for cell, line in zip(read, lines, strict=True)))


def code_lines(text: str) -> set[int]:
    """Return which lines of a markdown text, from 0, stand inside fenced code."""
    inside: set[int] = set()
    fence = ""
    for number, line in enumerate(text.splitlines()):
        mark = re.match(r"\s*(```+|~~~+)", line)
        if fence:
            inside.add(number)
            if mark and mark[1].startswith(fence):
                fence = ""
        elif mark:
            fence = mark[1]
            inside.add(number)
    return inside


def _cell(read, line: int) -> SourceCell:
    options = dict(read.metadata)
    options.pop("lines_to_next_cell", None)
    options.pop("lines_to_end_of_cell_marker", None)
    tags = options.get("tags", [])
    return SourceCell(
        name=str(options.get("name", "")),
        kind=read.cell_type,
        lang=options.get("lang"),
        tags=tuple(tags) if isinstance(tags, list) else (str(tags),),
        slide=str(options.get("slide", "-")),
        source=read.source,
        line=line,
        unknown=tuple(sorted(set(options) - OPTIONS)),
    )
