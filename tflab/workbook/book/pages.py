"""Lay out the pages of the web book: the frame around each page, the first page, the gallery.

    +---------------------------------------------+
    | tflab   [search]            한국어   theme   |
    +----------+----------------------------------+
    | chapters | page, at most 75 characters wide |
    | sections |                                  |
    |          | <- 02 before          after 08 ->|
    +----------+----------------------------------+

The frame is ordinary HTML (`pages.jinja`) and works without a script.  Search, theme, and the change of
language at the same place are `static/book.js`.  A figure is one file in `assets`, named after its content.
"""

from __future__ import annotations

import ast
import base64
import hashlib
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

from tflab.views.report_page import render

from ...text import LANGUAGES, Texts
from ..course.course import read_course
from ..paths import exercise_file
from .search_index import Section

__all__ = ["STATIC", "TEXTS", "BookPage", "ShownFigure", "conventions_text", "framed", "front_page", "gallery_page",
           "language_choice_page", "last_line", "pictures_of", "shell"]  # fmt: skip

TEXTS = Texts(__file__)
STATIC = Path(__file__).parent / "static"
NAMES = dict(zip(LANGUAGES, ("English", "한국어"), strict=True))
KINDS = {"image/png": "png", "image/svg+xml": "svg"}
COMMANDS = 'pip install "tflab[all]"\ntflab lab'
FRAME = (
    "skip", "contents", "on_this_page", "search", "nothing", "theme", "before", "after", "answers", "way", "read_only",
)  # fmt: skip
FRONT = ("title", "lead", "chapters", "exercise", "look_up", "reference", "run", "how")

fill = partial(render, __file__)


@dataclass(frozen=True)
class BookPage:
    """One page of a book: its file, its title, its HTML, and its sections.

    Attributes:
        is_chapter: whether the links to the previous and the next page include it.
    """

    file: str
    title: str
    html: str
    sections: list[Section] = field(default_factory=list)
    is_chapter: bool = True


def framed(page: BookPage, book: Sequence[BookPage], language: str, assets: str = "../assets") -> str:
    """Return a page with its frame; `assets` is the path from the page to the folder of style and script."""
    (other,) = (code for code in LANGUAGES if code != language)
    chapters = [each for each in book if each.is_chapter]
    at = chapters.index(page) if page in chapters else len(book) + 1
    values: dict[str, Any] = {
        "page": page,
        "book": book,
        "language": language,
        "assets": assets,
        "other": (other, NAMES[other]),
        "previous": chapters[at - 1] if 0 < at < len(chapters) else None,
        "next": chapters[at + 1] if at + 1 < len(chapters) else None,
        "label": _labels(FRAME, language),
    }
    text = re.sub(r"<title>.*?</title>", "", page.html, count=1, flags=re.DOTALL)
    text = text.replace("</head>", fill("head.jinja", **values) + "</head>", 1)
    before = fill("before.jinja", **values)
    body = re.compile(r'<body class="([^"]*)"([^>]*)>')
    text = body.sub(lambda found: f'<body class="{found[1]} book"{found[2]}>\n{before}', text, count=1)
    note = f'<p class="book-note">{values["label"]["read_only"]}</p>\n' if page.is_chapter else ""
    text = text.replace("<main>", f'<main id="content" tabindex="-1">\n{note}', 1)
    box = '<input class="task-list-item-checkbox"'
    text = text.replace(box, box.replace("<input", '<input aria-hidden="true"'))
    before_end, end, rest = text.rpartition("</main>")
    return before_end + end + fill("after.jinja", **values) + rest


def shell(body: str, language: str) -> str:
    """Return a page that is no notebook, such as a gallery, as `framed` takes it."""
    return fill("shell.jinja", body=body, language=language)


def front_page(book: Sequence[BookPage], language: str, *, has_reference: bool) -> str:
    """Return the first page's text as HTML; the chapters are those of `book`."""
    files = {page.file for page in book}
    here = [chapter for chapter in read_course().chapters if f"{chapter.stem}.html" in files]
    exercises = {chapter.stem: exercise_file(chapter.stem).replace(".ipynb", ".html") for chapter in here}
    return fill(
        "front.jinja",
        language=language,
        label=_labels(FRONT, language),
        chapters=[
            (chapter, TEXTS["minutes"].say(language, n=chapter.minutes), exercises[chapter.stem]) for chapter in here
        ],
        files=files,
        others=[page for page in book if not page.is_chapter and page.file not in exercises.values()],
        has_reference=has_reference,
        commands=COMMANDS + (" --lang ko" if language == "ko" else ""),
    )


def conventions_text(language: str) -> str:
    """Return the conventions as Markdown."""
    return (STATIC / f"conventions_{language}.md").read_text(encoding="utf-8")


def language_choice_page() -> str:
    """Return the page above the languages: it leads to the browser's own, and lists both without a script."""
    return fill("door.jinja", names=NAMES)


@dataclass(frozen=True)
class ShownFigure:
    """A figure: its file's name and content, what it shows in words, the line that draws it, and where it stands."""

    file: str
    data: bytes
    words: str
    line: str
    place: str
    page: str


def pictures_of(notebook: Mapping[str, Any], file: str, title: str) -> list[ShownFigure]:
    """Return the pictures that an executed notebook shows, in order."""
    found = []
    for cell in notebook["cells"]:
        for output in cell.get("outputs", ()):
            data = output.get("data", {})
            kind = next((kind for kind in KINDS if kind in data), None)
            if kind is None:
                continue
            raw = "".join(data[kind])
            content = base64.b64decode(raw) if kind == "image/png" else raw.encode()
            name = f"figure-{hashlib.sha256(content).hexdigest()[:12]}.{KINDS[kind]}"
            words = "".join(data.get("text/plain", ""))
            place = f"{file}#cell-id={cell['id']}"
            found.append(ShownFigure(name, content, words, last_line("".join(cell["source"])), place, title))
    return found


def last_line(source: str) -> str:
    """Return the last statement of a cell, which is what shows something; its last line, where it is no Python."""
    try:
        statements = ast.parse(source).body
    except SyntaxError:
        statements = []
    if statements:
        return ast.get_source_segment(source, statements[-1]) or ""
    return next((line for line in reversed(source.splitlines()) if line.strip()), "")


def gallery_page(pictures: Iterable[ShownFigure], language: str) -> str:
    """Return the gallery's text as HTML."""
    labels = _labels(("gallery", "gallery_lead"), language)
    return fill("gallery.jinja", pictures=list(pictures), label=labels)


def _labels(keys: Iterable[str], language: str) -> dict[str, str]:
    return {key: TEXTS[key].say(language) for key in keys}
