"""Read the headings of an HTML page and the text below each, and write the search index.

    <h2 id="Predict">Predict</h2>         Section("Predict", level 2, "cell-id=predict", "Predict",
    <p>The laser is bolted on ...                 "The laser is bolted on ...")

A full-text index, as small as the book: a browser reads it as a script, so searching
needs no server and works from a disk.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from html.parser import HTMLParser

__all__ = ["Section", "search_index", "sections_of"]

SILENT = ("script", "style", "svg", "math")
HEADINGS = ("h1", "h2", "h3")
SPACE_AFTER = ("p", "li", "td", "th", "div", "pre", "summary", *HEADINGS)


@dataclass
class Section:
    """A heading and what stands below it.

    Attributes:
        place: the id to jump to.
        level: 1 for the page's own title.
        cell: the id of the cell it stands in, the same in every language.
        title: its words.
        text: the words up to the next heading.
    """

    place: str
    level: int
    cell: str
    title: str = ""
    text: str = ""


class _SectionReader(HTMLParser):
    """Collects the sections of a page."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.sections: list[Section] = []
        self._cell = ""
        self._silent = 0
        self._in_heading = False
        self._in_mark = False  # the sign beside a heading that links to it

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        named = dict(attrs)
        cell = named.get("data-cell") or named.get("id") or ""  # the heading of a folded section stands before its cell
        if cell.startswith("cell-id="):
            self._cell = cell
        if tag in SILENT:
            self._silent += 1
        if tag in HEADINGS and named.get("id"):
            self.sections.append(Section(named["id"] or "", int(tag[1]), self._cell))
            self._in_heading = True
        self._in_mark = self._in_mark or "anchor-link" in (named.get("class") or "")

    def handle_endtag(self, tag: str) -> None:
        if tag in SILENT:
            self._silent -= 1
        if tag in HEADINGS:
            self._in_heading = False
        if tag == "a":
            self._in_mark = False
        if tag in SPACE_AFTER:
            self.handle_data(" ")

    def handle_data(self, data: str) -> None:
        if self._silent or self._in_mark or not self.sections:
            return
        if self._in_heading:
            self.sections[-1].title += data
        else:
            self.sections[-1].text += data


def sections_of(page: str) -> list[Section]:
    """Return the sections of a page, in order; what stands before the first heading belongs to none."""
    reader = _SectionReader()
    reader.feed(page)
    for section in reader.sections:
        section.title = " ".join(section.title.split())
        section.text = " ".join(section.text.split())
    return reader.sections


def search_index(pages: Iterable[tuple[str, str, list[Section]]]) -> str:
    """Return the index of these pages (file, title, sections) as a script that a page loads when one searches."""
    rows = [
        [file, page, section.place, section.title, section.text] for file, page, of_page in pages for section in of_page
    ]
    return f"globalThis.tflabIndex = {json.dumps(rows, ensure_ascii=False)};\n"
