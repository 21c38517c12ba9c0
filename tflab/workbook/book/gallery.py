"""What figures are there, and which line draws each?  A page of them all, each with a link to its place.

    executed page --cells that show a picture--> [picture] draw_frames(poses)   03 · Target and source

A picture is one file in `assets`, named after its content.
"""

from __future__ import annotations

import ast
import base64
import hashlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any

from ...text import Text

__all__ = ["GALLERY", "ShownFigure", "gallery_page", "last_line", "pictures_of"]

KINDS = {"image/png": "png", "image/svg+xml": "svg"}
GALLERY = Text(en="Gallery", ko="그림 모음")
LEAD = Text(
    en="Every figure of the pages, and the line that draws it. The link leads to the place where it is explained.",
    ko="본문에 나오는 모든 그림과, 그 그림을 그리는 줄입니다. 링크를 따라가면 설명이 있는 곳이 나옵니다.",
)


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
    figures = [
        f'<figure id="{Path(picture.file).stem}-{number}">\n<a href="{escape(picture.place)}">'
        f'<img loading="lazy" src="../assets/{picture.file}" alt="{escape(picture.words)}"></a>\n'
        f"<figcaption><pre><code>{escape(picture.line)}</code></pre>"
        f'<a href="{escape(picture.place)}">{escape(picture.page)}</a></figcaption>\n</figure>\n'
        for number, picture in enumerate(pictures)
    ]
    return (
        f'<h1 id="gallery">{GALLERY.say(language)}</h1>\n<p>{LEAD.say(language)}</p>\n'
        f'<div class="book-gallery">\n{"".join(figures)}</div>'
    )
