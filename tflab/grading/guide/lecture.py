"""Read a built page for lecturing: slides, notes, options with replies, rubrics, exit ticket.

    cell "checkpoint"     1. Replace the laser.                  Choice("1", "Replace the laser.", "A laser that ...")
                          <details><summary>I chose 1</summary>
    cell "practice"       - [ ] `view_frames` draws ...          an idea of the rubric
    cell "exit-ticket"    the question, and behind a fold what to compare it with

The notebook is read as it was built and committed; nothing runs.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

from tflab.workbook.pages.slides import Slide, slides_of
from tflab.workbook.paths import workbook_data

__all__ = ["LecturedPage", "PageChoice", "Ticket", "lectured_page"]

FOLD = re.compile(r"<details>\s*<summary>(.*?)</summary>(.*?)</details>", re.DOTALL)
NUMBERED = re.compile(r"^(\d+)\.\s+(.*(?:\n(?!\s*\n|\d+\.\s|<details).+)*)", re.MULTILINE)
CHOSEN = re.compile(r"I chose (\d+)|(\d+)번을 골랐습니다")
LABELLED = re.compile(r"^\s*(\w)\.\s+(.*)$", re.DOTALL)
BULLET = re.compile(r"^(?:- \[ \]|-|\d+\.)\s+(.*)$", re.MULTILINE)
HEADING = re.compile(r"^#+\s+.*$", re.MULTILINE)
NEXT = re.compile(r"^\*\*(?:Next|다음)", re.MULTILINE)
SECTION = re.compile(r"^\*\*", re.MULTILINE)


class PageChoice(NamedTuple):
    """One option of a question on the page: its label, its text, and what the page replies; both may be Markdown."""

    label: str
    text: str
    reply: str


class Ticket(NamedTuple):
    """What is asked at the end, and what to compare the answers with."""

    asked: str
    compare: str


@dataclass(frozen=True)
class LecturedPage:
    """A built page, in one language."""

    stem: str
    language: str
    notebook: Mapping[str, Any]

    @cached_property
    def cells(self) -> dict[str, str]:
        """Return what stands in each cell."""
        return {cell["id"]: "".join(cell["source"]) for cell in self.notebook["cells"]}

    @cached_property
    def notes(self) -> dict[str, str]:
        """Return what is said to the speaker, by cell."""
        said = {cell["id"]: cell["metadata"].get("tflab", {}).get("notes", "") for cell in self.notebook["cells"]}
        return {name: notes for name, notes in said.items() if notes}

    @cached_property
    def slides(self) -> list[Slide]:
        """Return the slides, as the deck has them."""
        return slides_of(dict(self.notebook), notes=False)

    @cached_property
    def shown(self) -> dict[str, int]:
        """Return on which slide each cell that is shown stands, counted from 0."""
        return {name: number for number, slide in enumerate(self.slides) for step in slide.steps for name in step}

    def objectives(self) -> list[str]:
        """Return what one can do after the chapter."""
        return BULLET.findall(self.cells.get("title", ""))

    def recap(self) -> str:
        """Return what is to be kept, without its heading."""
        return HEADING.sub("", self.cells.get("recap", "")).strip()

    def text(self, cell: str) -> str:
        """Return a text without its heading, its options and its folds."""
        bare = HEADING.sub("", FOLD.sub("", self.cells[cell]))
        return (NUMBERED.sub("", bare) if self.choices(cell) else bare).strip()

    def item(self, cell: str, number: int) -> str | None:
        """Return a numbered question of a cell; None if it has none of this number."""
        return next((text for at, text in NUMBERED.findall(self.cells.get(cell, "")) if int(at) == number), None)

    def choices(self, cell: str) -> list[PageChoice]:
        """Return the options of a cell that replies to each."""
        source = self.cells.get(cell, "")
        texts = dict(NUMBERED.findall(FOLD.sub("", source)))
        found = []
        for summary, reply in FOLD.findall(source):
            chosen, labelled = CHOSEN.search(summary), LABELLED.match(summary)
            if chosen is not None:
                label = chosen[1] or chosen[2]
                found.append(PageChoice(label, texts.get(label, ""), reply.strip()))
            elif labelled is not None:
                found.append(PageChoice(labelled[1], labelled[2].strip(), reply.strip()))
            else:
                found.append(PageChoice(str(len(found) + 1), summary.strip(), reply.strip()))
        return found

    def rubrics(self) -> list[list[str]]:
        """Return the ideas of each practice question, in the order of the questions."""
        return [BULLET.findall(SECTION.split(body)[0]) for _, body in FOLD.findall(self.cells.get("practice", ""))]

    def ticket(self) -> Ticket | None:
        """Return the exit ticket; None if the page has none."""
        source = self.cells.get("exit-ticket", self.cells.get("exit"))
        if source is None:
            return None
        fold = FOLD.search(source)
        before = source[: fold.start()] if fold else NEXT.split(source)[0]
        asked = HEADING.sub("", before).strip()
        return Ticket(asked, fold[2].strip() if fold else "")

    def screen(self, begin: str, end: str | None) -> Sequence[Slide]:
        """Return the slides from one cell's up to before another's; to the last one if there is no other."""
        stop = len(self.slides) if end is None else max(self.shown[end], self.shown[begin] + 1)
        return self.slides[self.shown[begin] : stop]

    def notes_of(self, slide: Slide) -> list[str]:
        """Return what is said to the speaker on a slide."""
        return [self.notes[name] for step in slide.steps for name in step if name in self.notes]


def lectured_page(stem: str, language: str, data: Path | None = None) -> LecturedPage:
    """Return a chapter's page.

    Raises:
        FileNotFoundError: it is not built.
    """
    path = (data or workbook_data()) / "notebooks" / language / f"{stem}.ipynb"
    return LecturedPage(stem, language, json.loads(path.read_text(encoding="utf-8")))
