"""Write all pages as one web book: `tflab build --html`.

    site/index.html              asks the browser for its language
    site/en/03_x.html            a page;  E03_x.html, its exercise, to read
    site/en/gallery.html         every figure, with its line
    site/assets/                 scripts, styles, pictures, the index of the search: once for all pages
    site/reference/              what the docstrings say, with --reference

Everything is a file: the book works from a disk, and wherever files are served.
"""

from __future__ import annotations

import json
import re
import shutil
import sys
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from ...text import Text
from ..book.pages import (
    STATIC,
    TEXTS,
    BookPage,
    ShownFigure,
    conventions_text,
    framed,
    front_page,
    gallery_page,
    language_choice_page,
    pictures_of,
    shell,
)
from ..book.reference import write_reference
from ..book.search_index import search_index, sections_of
from ..course.course import read_course
from ..paths import chapter_of, workbook_data
from .html import PageRunError, run_with_films

__all__ = ["write_book"]

KERNELS = 2
CONVENTIONS = Text(en="Cheat sheet", ko="한 장 요약")
EXERCISE = Text(en="Exercise {number}", ko="연습 문제 {number}")
BESIDE_THE_CHAPTERS = {
    "90_glossary": Text(en="Glossary", ko="용어집"),
    "91_practice": Text(en="Practice", ko="연습"),
    "92_to_a_robot": Text(en="To a robot", ko="로봇으로"),
}
LINK = re.compile(r'href="(?:\.\./\.\./(?:exercises|notebooks)/\w+/)?(?P<page>\w+)\.ipynb(?P<place>#[^"]*)?"')


@dataclass(frozen=True)
class _Ran:
    """A notebook that was run, or is only to be read: its page, and the pictures on it."""

    page: BookPage
    pictures: list[ShownFigure]


def write_book(out_dir: Path, languages: Sequence[str], *, reference: bool = False) -> int:
    """Write the book into a folder; return 0, or 1 if a page failed, which is said and left out."""
    assets = out_dir / "assets"
    assets.mkdir(parents=True, exist_ok=True)
    for name in ("book.css", "book.js"):
        shutil.copyfile(STATIC / name, assets / name)
    (out_dir / "index.html").write_text(language_choice_page(), encoding="utf-8")
    failed = 0
    for language in languages:
        made, faults = _ran_pages(language, assets)
        failed += faults
        _write_language(out_dir, language, made, has_reference=reference)
    if reference:
        print(write_reference(out_dir / "reference"))
    print(out_dir / "index.html")
    return 1 if failed else 0


def _write_language(out_dir: Path, language: str, made: Sequence[_Ran], *, has_reference: bool) -> None:
    """Write the pages of one language, each in its frame, and what belongs to them all."""
    folder = out_dir / language
    folder.mkdir(exist_ok=True)
    pictures = [picture for one in made for picture in one.pictures]
    for picture in pictures:
        (out_dir / "assets" / picture.file).write_bytes(picture.data)
    book = [one.page for one in made]
    book += [
        _plain("gallery.html", TEXTS["gallery"].say(language), gallery_page(pictures, language), language),
        _plain("conventions.html", CONVENTIONS.say(language), _html(conventions_text(language)), language),
    ]
    front = _plain("index.html", "tflab", front_page(book, language, has_reference=has_reference), language)
    for page in (front, *book):
        (folder / page.file).write_text(framed(page, book, language), encoding="utf-8")
    index = search_index((page.file, page.title, page.sections) for page in book)
    (out_dir / "assets" / f"search-{language}.js").write_text(index, encoding="utf-8")


def _ran_pages(language: str, assets: Path) -> tuple[list[_Ran], int]:
    """Return the pages of a language in the order of the book, and how many failed."""
    root = workbook_data()
    notebooks = sorted((root / "notebooks" / language).glob("*.ipynb"))
    exercises = sorted((root / "exercises" / language).glob("*.ipynb"))
    wanted = sorted([*notebooks, *exercises], key=lambda path: (chapter_of(path), path in exercises))
    made, failed = [], 0

    def make(path: Path) -> _Ran | PageRunError:
        try:
            return _exercise(path, language, assets) if path in exercises else _lecture(path, language, assets)
        except PageRunError as failure:
            return failure

    with ThreadPoolExecutor(KERNELS) as threads:
        for number, (path, one) in enumerate(zip(wanted, threads.map(make, wanted), strict=True), start=1):
            print(f"[{number}/{len(wanted)}] {language}/{path.name}", flush=True)
            if isinstance(one, PageRunError):
                print(f"failed\n{one}", file=sys.stderr)
                failed += 1
            else:
                made.append(one)
    return made, failed


def _lecture(notebook: Path, language: str, assets: Path) -> _Ran:
    with TemporaryDirectory() as folder:
        executed = run_with_films(notebook, Path(folder))
        title, file = _title(notebook.stem, language), f"{notebook.stem}.html"
        ran = json.loads(executed.read_text(encoding="utf-8"))
        pictures = pictures_of(ran, file, title)
        text = _exported(executed, Path(folder) / "pages", assets)
        return _Ran(BookPage(file, title, text, sections_of(text)), pictures)


def _exercise(notebook: Path, language: str, assets: Path) -> _Ran:
    """Return an exercise as a page to read: nobody has answered it."""
    with TemporaryDirectory() as folder:
        title = EXERCISE.say(language, number=chapter_of(notebook)[:2])
        text = _exported(notebook, Path(folder), assets)
        return _Ran(BookPage(f"{notebook.stem}.html", title, text, sections_of(text), is_chapter=False), [])


def _exported(notebook: Path, folder: Path, assets: Path) -> str:
    """Return a notebook's HTML, its links leading to pages of the book and its assets where all pages have them."""
    from tflab.views.export import export_html

    exported = export_html(notebook, folder)
    if (folder / "assets").is_dir():
        shutil.copytree(folder / "assets", assets, dirs_exist_ok=True)
    text = exported.read_text(encoding="utf-8")
    return LINK.sub(r'href="\g<page>.html\g<place>"', text).replace('"assets/', '"../assets/')


def _title(stem: str, language: str) -> str:
    chapter = next((one for one in read_course().chapters if one.stem == stem), None)
    if chapter is not None:
        return f"{chapter.number:02} · {chapter.title.say(language)}"
    return BESIDE_THE_CHAPTERS[stem].say(language) if stem in BESIDE_THE_CHAPTERS else stem


def _plain(file: str, title: str, body: str, language: str) -> BookPage:
    return BookPage(file, title, shell(body, language), sections_of(body), is_chapter=False)


def _html(markdown: str) -> str:
    from nbconvert.filters import markdown2html

    return str(markdown2html(markdown))
