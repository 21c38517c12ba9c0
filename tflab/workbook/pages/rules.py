"""Check what every page must keep to, before anything is run.

    notebooks/src/03_target_and_source.py:41: cell "why-frames": there is no Korean text; write it next to the English

All faults of a page are found at once, each with its place and its remedy.
What only shows when a page runs is in `execute.py`; what an exercise needs beyond
this is in `exercise_rules.py`.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from pathlib import Path
from posixpath import normpath

from ...text import LANGUAGES
from ..paths import chapter_of
from .source import Page, PageFault, SourceCell, code_lines

__all__ = ["MOST_LINES", "SLIDES", "TAGS", "page_faults"]

MOST_LINES = 15
LONGEST_NAME = 64
NAME = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")
SLIDES = ("slide", "subslide", "fragment", "notes", "skip", "-")
TAGS = ("answer", "check", "collapsed", "interactive", "predicted", "raises-exception", "static", "translated")
CALLED = {"en": "English", "ko": "Korean"}
HEADING = re.compile(r"(#{1,6})\s+\S")
IMAGE = re.compile(r"!\[([^\]]*)\]\(|<img\b([^>]*)>")
TERM = re.compile(r"\[\[([^\[\]|]+)(?:\|[^\[\]]*)?\]\]")
LINK = re.compile(r"(?<!\])\]\(([^)\s]+)")  # but a term in brackets before a bracket is none
ELSEWHERE = re.compile(r"[a-z]+:|#")
PAGE = re.compile(r"(notebooks|solutions|exercises(?=/../E))/(en|ko)/([^/]+)\.ipynb")


def page_faults(page: Page, terms: Collection[str] | None = None) -> list[PageFault]:
    """Return what is wrong with a page as it is written; `terms` are the glossary's keys, None if there is none."""
    found = [*_cells(page), *_pairs(page), *_headings(page), *_pictures(page), *_interactive(page), *_links(page)]
    if terms is not None:
        found += _terms(page, terms)
    return sorted(set(found), key=lambda fault: (fault.line, fault.wrong))


def _cells(page: Page) -> Iterator[PageFault]:
    """Find cells without a proper name, with options that mean nothing, of no kind, or too long."""
    for cell in page.cells:
        yield from _marker(page, cell)
        if cell.kind == "code":
            yield from _code(page, cell)
        elif cell.kind != "markdown":
            yield page.fault(cell, f"there is no cell of kind {cell.kind}", "a cell is code, or [markdown]")
        elif cell.lang not in LANGUAGES:
            yield page.fault(cell, f"this text is in no language ({cell.lang})", 'add lang="en" or lang="ko"')


def _marker(page: Page, cell: SourceCell) -> Iterator[PageFault]:
    """Find what is wrong in the line that a cell begins with: its name and its options."""
    if not cell.name:
        yield page.fault(cell, "this cell has no name", 'add name="..." to its "# %%" line')
    elif not NAME.fullmatch(cell.name) or len(cell.name) > LONGEST_NAME:
        remedy = f"use small letters, digits and single hyphens, at most {LONGEST_NAME}"
        yield page.fault(cell, "this is no name for a cell", remedy)
    if cell.unknown:
        yield page.fault(cell, f"there is no option {', '.join(cell.unknown)}", "there is lang, name, slide, tags")
    if cell.slide not in SLIDES:
        yield page.fault(cell, f'there is no slide type "{cell.slide}"', f"there is {', '.join(SLIDES)}")
    for tag in sorted(set(cell.tags) - set(TAGS)):
        yield page.fault(cell, f'there is no tag "{tag}"', f"there is {', '.join(TAGS)}")


def _code(page: Page, cell: SourceCell) -> Iterator[PageFault]:
    """Find code that is too long, or marked as only prose may be."""
    lines = len(cell.source.splitlines())
    if lines > MOST_LINES:
        remedy = f"at most {MOST_LINES}: split it, or move a helper into tflab"
        yield page.fault(cell, f"{lines} lines of code", remedy)
    if cell.lang is not None:
        yield page.fault(cell, "code has a language", "remove lang: code is the same for both")
    if cell.slide == "notes":
        yield page.fault(cell, "notes are code", 'speaker\'s notes are prose: "# %% [markdown]"')


def _pairs(page: Page) -> Iterator[PageFault]:
    """Find names that stand for two cells, and texts without the other language next to them."""
    yield from _names_given_twice(page)
    cells = page.cells
    texts = [cell for cell in cells if cell.kind == "markdown" and cell.lang in LANGUAGES and cell.name]
    for ko in texts:
        if ko.lang == "ko" and _named(texts, ko.name, "en") is None:
            yield page.fault(ko, "there is no English text", "write it next to the Korean")
    for en, following in zip(cells, (*cells[1:], None), strict=True):
        if en.kind != "markdown" or en.lang != "en" or not en.name:
            continue
        ko = _named(texts, en.name, "ko")
        if ko is None:
            yield page.fault(en, "there is no Korean text", "write it next to the English")
        elif following is None or (following.name, following.lang) != (en.name, "ko"):
            yield page.fault(en, "the Korean text stands elsewhere", "put it right after the English")
        else:
            yield from _pair(page, en, ko)


def _names_given_twice(page: Page) -> Iterator[PageFault]:
    for name, times in Counter((cell.name, cell.lang) for cell in page.cells if cell.name).items():
        if times > 1:
            again = [cell for cell in page.cells if (cell.name, cell.lang) == name][1]
            yield page.fault(again, "there is another cell of this name", "each cell of a page has a name of its own")
    codes = {cell.name for cell in page.code}
    for cell in page.cells:
        if cell.kind == "markdown" and cell.lang in LANGUAGES and cell.name in codes - {""}:
            yield page.fault(cell, "a code cell has this name, too", "give the text a name of its own")


def _named(cells: Sequence[SourceCell], name: str, language: str) -> SourceCell | None:
    return next((cell for cell in cells if (cell.name, cell.lang) == (name, language)), None)


def _pair(page: Page, en: SourceCell, ko: SourceCell) -> Iterator[PageFault]:
    """Find where two texts of one cell are not of one shape."""
    depths = [[depth for _, depth in _depths(cell)] for cell in (en, ko)]
    if depths[0] != depths[1]:
        wrong = f"its headings have depths {depths[1]}, those of the English {depths[0]}"
        yield page.fault(ko, wrong, "let both have the same")
    if (en.slide, en.tags) != (ko.slide, ko.tags):
        yield page.fault(ko, "its slide or tags differ from the English", "let both have the same")
    if not ko.source.strip() or not en.source.strip():
        yield page.fault(en if not en.source.strip() else ko, "there is no text", "write it")


def _depths(cell: SourceCell) -> list[tuple[int, int]]:
    """Return the headings of a text: line from 0, and depth."""
    code = code_lines(cell.source)
    lines = enumerate(cell.source.splitlines())
    return [(n, len(found[1])) for n, line in lines if n not in code and (found := HEADING.match(line))]


def _headings(page: Page) -> Iterator[PageFault]:
    """Find headings that leave a depth out, and a page with no title or two."""
    for language in LANGUAGES:
        before, titles = 0, 0
        for cell in page.in_language(language):
            if cell.kind != "markdown" or cell.slide == "notes":
                continue
            for _, depth in _depths(cell):
                if depth > before + 1:
                    wrong = f"a heading of depth {depth} comes after one of depth {before}"
                    yield page.fault(cell, wrong, "go down one depth at a time")
                titles += depth == 1
                if depth == 1 and titles == 2:
                    yield page.fault(cell, "this is a second title", 'a page has one "#"; use "##"')
                before = depth
        if not titles:
            yield page.fault(None, f"there is no title in {CALLED[language]}", 'begin with a heading "# ..."')


def _pictures(page: Page) -> Iterator[PageFault]:
    for cell, text in _prose(page):
        for found in IMAGE.finditer(text):
            alt = found[1] if found[2] is None else "".join(re.findall(r'alt="([^"]*)"', found[2]))
            if not alt.strip():
                yield page.fault(cell, "an image has no alt text", "say in words what it shows")
        if re.search(r"!\[[^\]]*\]\(\s*https?:|<img\b[^>]*https?:", text):
            yield page.fault(cell, "an image comes from the network", "draw it: nothing leaves a learner's machine")


def _terms(page: Page, terms: Collection[str]) -> Iterator[PageFault]:
    marked: dict[tuple[str, str | None], Counter] = {}
    for cell, text in _prose(page):
        found = [key.strip() for key in TERM.findall(text)]
        marked[cell.name, cell.lang] = Counter(found)
        for key in sorted(set(found) - set(terms)):
            yield page.fault(cell, f'"{key}" is not in the glossary', "add it to glossary.yaml, or take the marks off")
    for (name, lang), found in marked.items():
        english = marked.get((name, "en"))
        if lang == "ko" and english is not None and set(found) != set(english):
            different = ", ".join(sorted(set(found) ^ set(english)))
            cell = next(c for c in page.cells if (c.name, c.lang) == (name, lang))
            yield page.fault(cell, f"only one language marks {different}", "mark the same terms in both")


def _interactive(page: Page) -> Iterator[PageFault]:
    """Find live views without a figure, and static figures that do not stand right after a live view."""
    for cell, following in zip(page.code, (*page.code[1:], None), strict=False):
        if "interactive" in cell.tags and (following is None or "interactive" in following.tags):
            remedy = "let the next code cell draw the same as a static figure"
            yield page.fault(cell, "no figure follows this interactive cell", remedy)
    for before, cell in zip((None, *page.cells), page.cells, strict=False):
        if "static" in cell.tags and (before is None or "interactive" not in before.tags):
            yield page.fault(cell, "no live view stands before this static figure", "put it right after its live view")


def _links(page: Page) -> Iterator[PageFault]:
    """Find links to what is not in a learner's copy, or is in the other language."""
    root, room = page.path.parents[2], page.path.parents[1].name
    for cell, text in _prose(page):
        for target in LINK.findall(text):
            if ELSEWHERE.match(target):
                continue
            path = normpath(f"{room}/{cell.lang}/{target.partition('#')[0]}")
            found = PAGE.fullmatch(path)
            source = "notebooks" if found and found[1] == "notebooks" else "solutions"
            if not found or not (root / source / "src" / f"{chapter_of(Path(found[3]))}.py").is_file():
                remedy = "link to a page that has a source, as ../../exercises/en/E03_....ipynb"
                yield page.fault(cell, f"links to {target}, which will not be there", remedy)
            elif found[2] != cell.lang:
                yield page.fault(cell, f"{target} is in the other language", f"link to the one below {cell.lang}/")


def _prose(page: Page) -> Iterator[tuple[SourceCell, str]]:
    """Yield each text with its code taken out."""
    for cell in page.cells:
        if cell.kind == "markdown" and cell.lang in LANGUAGES:
            code = code_lines(cell.source)
            lines = [line for n, line in enumerate(cell.source.splitlines()) if n not in code]
            yield cell, re.sub(r"`[^`\n]*`", "", "\n".join(lines))
