"""What surrounds a page of a book?  Its title, the contents, the way back and on, the other language.

    +---------------------------------------------+
    | tflab   [search]            한국어   theme   |
    +----------+----------------------------------+
    | chapters | page, at most 75 characters wide |
    | sections |                                  |
    |          | <- 02 before          after 08 ->|
    +----------+----------------------------------+

The frame is ordinary HTML and works without a script; search, theme and staying on
the place while changing the language are `static/book.js`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from html import escape
from pathlib import Path

from ...text import Text
from .reading import Section

__all__ = ["STATIC", "BookPage", "framed", "shell"]

STATIC = Path(__file__).parent / "static"
OTHER = {"en": ("ko", "한국어"), "ko": ("en", "English")}

SAYS = {
    "skip": Text(en="To the text", ko="본문으로 가기"),
    "chapters": Text(en="Contents", ko="차례"),
    "here": Text(en="On this page", ko="이 쪽에서"),
    "search": Text(en="Search", ko="찾기"),
    "nothing": Text(en="Nothing found.", ko="찾은 것이 없습니다."),
    "theme": Text(en="Light or dark", ko="밝게 또는 어둡게"),
    "before": Text(en="Before", ko="이전"),
    "after": Text(en="Next", ko="다음"),
    "answers": Text(en="Folded answers of this page", ko="이 쪽의 접힌 답"),
    "way": Text(en="Before and next page", ko="이전 쪽과 다음 쪽"),
    "run": Text(
        en="To read: views turn, sliders move, nothing runs. "
        "To run the code and have your answers checked, <a href='index.html#run'>get the workbook</a>.",
        ko="읽기용 쪽입니다. 3D는 돌아가고 슬라이더는 움직이지만 코드는 실행되지 않습니다. "
        "코드를 실행하고 답을 확인받으려면 <a href='index.html#run'>워크북을 받으십시오</a>.",
    ),
}


@dataclass(frozen=True)
class BookPage:
    """One page of a book: its file, what it is called, its HTML, and what stands on it.

    Attributes:
        is_chapter: whether it counts in the way back and on.
    """

    file: str
    title: str
    html: str
    sections: list[Section] = field(default_factory=list)
    is_chapter: bool = True


def framed(page: BookPage, book: Sequence[BookPage], language: str) -> str:
    """Return a page with its frame."""
    head = _head(page.title, language)
    text = re.sub(r"<title>.*?</title>", "", page.html, count=1, flags=re.DOTALL)
    text = text.replace("</head>", head + "</head>", 1)
    text = re.sub(
        r'<body class="([^"]*)"([^>]*)>',
        lambda body: f'<body class="{body[1]} book"{body[2]}>\n{_before(page, book, language)}',
        text,
        count=1,
    )
    note = f'<p class="book-note">{SAYS["run"].say(language)}</p>\n' if page.is_chapter else ""
    text = text.replace("<main>", f'<main id="content" tabindex="-1">\n{note}', 1)
    text = text.replace(
        '<input class="task-list-item-checkbox"', '<input aria-hidden="true" class="task-list-item-checkbox"'
    )
    before, end, after = text.rpartition("</main>")
    return before + end + _after(page, book, language) + after


def shell(body: str, language: str) -> str:
    """Return a page that is no notebook, such as a gallery, as `framed` takes it."""
    return (
        f'<!DOCTYPE html>\n<html lang="{language}">\n<head><meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1.0">\n</head>\n'
        f'<body class="book-plain" data-jp-theme-light="true">\n<main>\n{body}\n</main>\n</body>\n</html>\n'
    )


def _head(title: str, language: str) -> str:
    name = title if title == "tflab" else f"{title} · tflab"
    return (
        f"<title>{escape(name)}</title>\n"
        '<link rel="stylesheet" href="../assets/book.css">\n'
        "<script>document.documentElement.dataset.theme = localStorage.getItem('tflab-theme') ?? "
        "(matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');</script>\n"
        f'<script defer src="../assets/book.js" data-index="../assets/search-{language}.js" '
        f'data-nothing="{escape(SAYS["nothing"].say(language))}" '
        f'data-answers="{escape(SAYS["answers"].say(language))}"></script>\n'
    )


def _before(page: BookPage, book: Sequence[BookPage], language: str) -> str:
    code, name = OTHER[language]
    search, theme = SAYS["search"].say(language), SAYS["theme"].say(language)
    return (
        f'<a class="book-skip" href="#content">{SAYS["skip"].say(language)}</a>\n'
        '<header class="book-head">\n<a class="book-name" href="index.html">tflab</a>\n'
        f'<div class="book-search" role="search"><input type="search" placeholder="{search}" aria-label="{search}">'
        '<div class="book-found" role="status" hidden></div></div>\n'
        f'<a class="book-language" lang="{code}" hreflang="{code}" href="../{code}/{page.file}">{name}</a>\n'
        f'<button type="button" class="book-theme" title="{theme}" aria-label="{theme}">◐</button>\n</header>\n'
        f'<nav class="book-contents" aria-label="{SAYS["chapters"].say(language)}">\n'
        f"<details open><summary>{SAYS['chapters'].say(language)}</summary>\n"
        f"{_contents(page, book, language)}</details>\n</nav>\n"
    )


def _contents(page: BookPage, book: Sequence[BookPage], language: str) -> str:
    rows = []
    for other in book:
        here = other.file == page.file
        rows.append(
            f'<li><a href="{other.file}"{" aria-current=page" if here else ""}>{escape(other.title)}</a>'
            f"{_sections(page, language) if here else ''}</li>\n"
        )
    return f"<ul>\n{''.join(rows)}</ul>\n"


def _sections(page: BookPage, language: str) -> str:
    rows = [
        f'<li><a href="#{escape(section.place)}">{escape(section.title)}</a></li>'
        for section in page.sections
        if section.level == 2
    ]
    return f'\n<ul aria-label="{SAYS["here"].say(language)}">{"".join(rows)}</ul>' if rows else ""


def _after(page: BookPage, book: Sequence[BookPage], language: str) -> str:
    chapters = [other for other in book if other.is_chapter]
    if page not in chapters:
        return ""
    at = chapters.index(page)
    links = []
    for name, there, arrow in (("before", at - 1, "← {}"), ("after", at + 1, "{} →")):
        if 0 <= there < len(chapters):
            label = arrow.format(escape(chapters[there].title))
            links.append(
                f'<a rel="{"prev" if name == "before" else "next"}" href="{chapters[there].file}">'
                f"<small>{SAYS[name].say(language)}</small>{label}</a>"
            )
    return f'\n<nav class="book-way" aria-label="{SAYS["way"].say(language)}">{"".join(links)}</nav>\n'
