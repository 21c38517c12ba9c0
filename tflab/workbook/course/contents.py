"""Write the parts of the pages that are made from files, such as the table of chapters.

    course.yaml     ->  notebooks/src/00_start.py     the cells "chapters-table", with the sums of all minutes
                        README.md, README.ko.md       the table of chapters
    glossary.yaml   ->  notebooks/src/90_glossary.py  the whole page
    inventory.yaml  ->  solutions/src/00_start.py     the questions of form A, and at the end of 12 those of form B

`python -m tflab.workbook.course.contents` writes them; a test holds them in step.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable
from pathlib import Path

from ...text import LANGUAGES, Text, Texts
from ..atomic_files import write_whole
from ..inventory.items import SOURCES as FORM_PAGES
from ..inventory.items import read_inventory, with_questions
from ..paths import exercise_file, workbook_data
from .course import Chapter, read_course
from .glossary import Term, read_glossary

__all__ = [
    "EVENING",
    "GLOSSARY_PAGE",
    "READMES",
    "START_PAGE",
    "chapter_table",
    "exercise_minutes",
    "form_pages",
    "glossary_page",
    "readme",
    "start_page",
    "write_contents",
]

SOURCES = Path("notebooks", "src")
START_PAGE = SOURCES / "00_start.py"
GLOSSARY_PAGE = SOURCES / "90_glossary.py"
READMES = {"en": Path("README.md"), "ko": Path("README.ko.md")}
EVENING = (0, 1, 3, 8)  # the chapters of the core path
MINUTES = re.compile(r"about (\d+) minutes")
README_ROWS = re.compile(r"(?<=\n\|--:\|:--\|:--\|--:\|\n)(?:\|.*\n)*")

TEXTS = Texts(__file__)


def chapter_table(language: str, root: Path) -> str:
    """Return the chapters that have a page as a markdown table with links."""
    lines = [TEXTS["head"].say(language), "|--:|:--|:--|--:|:--|:--|"]
    for chapter in (chapter for chapter in _chapters_with_a_page(root) if chapter.number):
        exercise = ""
        minutes = exercise_minutes(chapter.stem, root)
        if minutes is not None:
            exercise = f"[E{chapter.number}](../../exercises/{language}/{exercise_file(chapter.stem)}), {minutes}"
        before = ", ".join(str(number) for number in chapter.builds_on)
        cells = (
            str(chapter.number),
            f"**[{chapter.title.say(language)}]({chapter.stem}.ipynb)**",
            chapter.question.say(language),
            str(chapter.minutes),
            before,
            exercise,
        )
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def exercise_minutes(stem: str, root: Path) -> int | None:
    """Return the minutes that an exercise states in its title; None if the chapter has no exercise."""
    source = root / "solutions" / "src" / f"{stem}.py"
    if not source.is_file():
        return None
    found = MINUTES.search(source.read_text(encoding="utf-8"))
    if found is None:
        raise LookupError(f'{source} does not state "about … minutes"')
    return int(found[1])


def totals(language: str, root: Path) -> str:
    """Return how long all pages, all exercises and the core path take."""
    pages = _chapters_with_a_page(root)
    return TEXTS["totals"].say(
        language,
        pages=round(sum(chapter.minutes for chapter in pages) / 60),
        exercises=round(sum(exercise_minutes(chapter.stem, root) or 0 for chapter in pages if chapter.number) / 60),
        evening=sum(chapter.minutes for chapter in pages if chapter.number in EVENING),
    )


def _chapters_with_a_page(root: Path) -> list[Chapter]:
    return [chapter for chapter in read_course().chapters if (root / SOURCES / f"{chapter.stem}.py").is_file()]


def start_page(root: Path) -> str:
    """Return the source of the start page with its table of chapters as it should be."""
    text = (root / START_PAGE).read_text(encoding="utf-8")
    for language in LANGUAGES:
        cell = re.compile(rf'(?m)^# %% \[markdown\] lang="{language}" name="chapters-table".*\n(?:#.*\n)+')
        found = cell.search(text)
        if found is None:
            raise LookupError(f'{START_PAGE} has no cell "chapters-table" in {language}')
        first = found[0].splitlines()[0]
        made = f"{chapter_table(language, root)}\n\n{totals(language, root)}"
        text = text.replace(found[0], f"{first}\n{_commented(made)}\n")
    return text


def glossary_page() -> str:
    """Return the source of the glossary as a page."""
    terms = read_glossary().values()
    index = Text(*(_index(terms, language) for language in LANGUAGES))
    cells = [_cells("title", TEXTS["glossary_title"], "slide"), _cells("index", index, "skip")]
    for chapter in read_course().chapters:
        own = [term for term in terms if term.chapter == chapter.stem]
        if own:
            text = Text(*(_terms(chapter, own, language) for language in LANGUAGES))
            cells.append(_cells(f"chapter-{chapter.number}", text, "skip"))
    return "\n".join(cells)


def readme(language: str, root: Path) -> str:
    """Return the README in a language with its table of chapters as it should be."""
    rows = [
        f"| {chapter.number:02} | [{chapter.title.say(language)}](notebooks/{language}/{chapter.stem}.ipynb) | "
        f"{chapter.question.say(language)} | {chapter.minutes} |\n"
        for chapter in _chapters_with_a_page(root)
    ]
    text = (root / READMES[language]).read_text(encoding="utf-8")
    return README_ROWS.sub(lambda found: "".join(rows), text)


def write_contents(root: Path) -> list[Path]:
    """Write the texts that are made from files; return the pages that changed."""
    changed = []
    texts = {START_PAGE: start_page(root), GLOSSARY_PAGE: glossary_page()}
    texts |= form_pages(root)
    texts |= {path: readme(language, root) for language, path in READMES.items() if (root / path).is_file()}
    for page, text in texts.items():
        path = root / page
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            write_whole(path, text)
            changed.append(page)
    return changed


def form_pages(root: Path) -> dict[Path, str]:
    """Return the sources of the two forms of the test with their questions as they should be."""
    items = read_inventory()
    pages = {form: Path(name) for form, name in FORM_PAGES.items() if (root / name).is_file()}
    return {
        path: with_questions((root / path).read_text(encoding="utf-8"), items, form) for form, path in pages.items()
    }


def _terms(chapter: Chapter, terms: list[Term], language: str) -> str:
    head = TEXTS["glossary_chapter"].say(language, number=chapter.number, title=chapter.title.say(language))
    lines = [f"- **{_shown(term, language)}**: {term.definition.say(language)}" for term in terms]
    return "\n".join([head, "", *lines])


def _index(terms: Iterable[Term], language: str) -> str:
    numbers = {chapter.stem: chapter.number for chapter in read_course().chapters}
    words = [(term.word.en if term.code else term.word.say(language), numbers[term.chapter]) for term in terms]
    words.sort(key=lambda row: (language == "ko" and row[0][0].isascii(), row[0].lower()))  # Latin letters last
    index = " · ".join(f"{word} {number}" for word, number in words)
    return "\n\n".join([TEXTS["glossary_index"].say(language), index])


def _shown(term: Term, language: str) -> str:
    if term.word.ko == term.word.en:
        return term.word.en
    return f"{term.word.en} ({term.word.ko})" if language == "en" else f"{term.word.ko} ({term.word.en})"


def _cells(name: str, text: Text, slide: str) -> str:
    return "\n".join(
        f'# %% [markdown] lang="{language}" name="{name}" slide="{slide}"\n{_commented(text.say(language))}\n'
        for language in LANGUAGES
    )


def _commented(text: str) -> str:
    return "\n".join(f"# {line}".rstrip() for line in text.splitlines())


if __name__ == "__main__":
    for page in write_contents(workbook_data()):
        print(page, file=sys.stdout)
