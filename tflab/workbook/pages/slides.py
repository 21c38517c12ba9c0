"""Write a page as slides that need neither kernel nor network: `tflab slides 03`.

    notebook --run, pictures filmed--> page.html --cells grouped by their slide type--> slides/03_x.html
                                                                                        slides/assets/

    slide, subslide   begins a slide             fragment   appears with the next key
    -                 goes on with it            skip       is not shown

What the speaker says stands in the cells' metadata and goes along; `--no-notes`
leaves it out of a deck to hand on.  3D turns and sliders move, as in `html.py`:
nbconvert's own decks fetch reveal.js from the network, so this one has a script of
its own (`static/deck.js`), which moves the cells of the exported page about.
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
import sys
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from html import escape
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from ...text import LANGUAGES, Texts
from ..paths import WorkbookError, read_workbook, workbook_root
from .html import PageRunError, notebooks_called, run_with_films

__all__ = ["Slide", "deck_from_notebook", "main", "slides_of"]

STATIC = Path(__file__).parent / "static"
HEADING = re.compile(r"^#{1,6}\s+(.+?)\s*$", re.MULTILINE)
BEGINS = ("slide", "subslide")

TEXTS = Texts(__file__)
KEYS = {
    "→ Space PgDn": "key_on",
    "← PgUp": "key_back",
    "Home End": "key_ends",
    "o Esc": "key_overview",
    "s": "key_speaker",
    "n": "key_notes",
    "c": "key_code",
    "f": "key_screen",
    "t": "key_theme",
    "p": "key_print",
    "b": "key_black",
    "?": "key_list",
}
BUTTONS = ("back", "on", "overview", "notes", "noNotes", "theme", "help", "next", "end")


@dataclass(frozen=True)
class Slide:
    """One slide.

    Attributes:
        name: that of its first cell.
        title: the first heading on it, else that of the slide before.
        steps: the cells that appear together, by name; the first ones at once.
        notes: what the speaker says, as HTML.
    """

    name: str
    title: str
    steps: tuple[tuple[str, ...], ...]
    notes: str = ""


def main(words: Sequence[str]) -> int:
    """Write decks; return 0, 1 if one failed, 2 if there is no such page."""
    options = _options(words)
    root = workbook_root()
    try:
        language = options.lang or read_workbook(root).language
        chosen = notebooks_called(options.pages, root / "notebooks" / language)
    except (WorkbookError, LookupError) as error:
        print(f"tflab slides: {error}", file=sys.stderr)
        return 2
    failed = 0
    for page in chosen:
        try:
            print(
                deck_from_notebook(page, Path(options.out), notes=not options.no_notes, single_file=options.single_file)
            )
        except PageRunError as failure:
            print(failure, file=sys.stderr)
            failed += 1
    return 1 if failed else 0


def deck_from_notebook(notebook: Path, out_dir: Path, *, notes: bool = True, single_file: bool = False) -> Path:
    """Run a copy of `notebook` and write it as a deck into `out_dir`; return the deck's path.

    Raises:
        PageRunError: it is no notebook, a cell raised an error, or there is nothing on it to show.
    """
    from tflab.views.export import export_html, page_language

    with TemporaryDirectory() as folder:
        executed = run_with_films(notebook, Path(folder))
        ran = json.loads(executed.read_text(encoding="utf-8"))
        language, slides = page_language(ran), slides_of(ran, notes=notes)
        if not slides:
            raise PageRunError(f"{notebook.name}: no cell of it is shown on a slide")
        page = export_html(executed, Path(folder) / "deck", single_file, folded=False)
        page.write_text(_as_deck(page.read_text(encoding="utf-8"), slides, language), encoding="utf-8")
        shutil.copytree(page.parent, out_dir, dirs_exist_ok=True)
        return out_dir / page.name


def slides_of(notebook: dict[str, Any], *, notes: bool = True) -> list[Slide]:
    """Return a notebook's cells, grouped into slides by their slide types."""
    slides: list[Slide] = []
    for cells in _groups(notebook["cells"]):
        steps = _steps(cells)
        if steps:
            title = next(filter(None, (_title(cell) for step in steps for cell in step)), "")
            said = [cell["metadata"].get("tflab", {}).get("notes", "") for cell in cells] if notes else []
            names = tuple(tuple(cell["id"] for cell in step) for step in steps)
            title_before = slides[-1].title if slides else ""
            slides.append(Slide(names[0][0], title or title_before, names, _html("\n\n".join(filter(None, said)))))
    return slides


def _kind(cell: dict) -> str:
    return cell["metadata"].get("slideshow", {}).get("slide_type", "-")


def _groups(cells: Iterable[dict]) -> list[list[dict]]:
    """Return cells in groups, each of which begins where a slide does."""
    groups: list[list[dict]] = []
    for cell in cells:
        if _kind(cell) in BEGINS or not groups:
            groups.append([])
        groups[-1].append(cell)
    return groups


def _steps(cells: Iterable[dict]) -> list[list[dict]]:
    """Return what a slide shows, in the steps in which it does: each fragment begins one."""
    steps: list[list[dict]] = [[]]
    for cell in cells:
        if _kind(cell) == "fragment":
            steps.append([])
        if _kind(cell) != "skip":
            steps[-1].append(cell)
    return [step for step in steps if step]


def _title(cell: dict) -> str:
    if cell["cell_type"] != "markdown":
        return ""
    found = HEADING.search("".join(cell["source"]))
    return re.sub(r"<[^>]+>|[`*]", "", found[1]) if found else ""


def _html(markdown: str) -> str:
    if not markdown:
        return ""
    from nbconvert.filters import markdown2html

    return markdown2html(markdown).strip()


def _as_deck(page: str, slides: list[Slide], language: str) -> str:
    """Return an exported page with the deck's style and script in it."""
    words: dict[str, Any] = {name: TEXTS[name].say(language) for name in BUTTONS}
    words["keys"] = [(key, TEXTS[name].say(language)) for key, name in KEYS.items()]
    state = json.dumps({"slides": [asdict(slide) for slide in slides], "words": words}, ensure_ascii=False)
    state = state.replace("</", "<\\/")  # so that no text of ours ends the script
    style, script = ((STATIC / f"deck.{kind}").read_text(encoding="utf-8") for kind in ("css", "js"))
    page = re.sub(r"<title>.*?</title>", lambda _: f"<title>{escape(slides[0].title)}</title>", page, count=1)
    page = page.replace("</head>", f"<style>{style}</style>\n</head>", 1)
    content, end, rest = page.rpartition("</body>")
    deck = f'<script type="application/json" id="tflab-deck">{state}</script>\n'
    return f"{content}{deck}<script>{script}</script>\n{end}{rest}"


def _options(words: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="tflab slides", description="Write pages as decks that work from a disk.")
    parser.add_argument("pages", nargs="+", metavar="PAGE", help="such as 03, or a notebook's path")
    parser.add_argument("--lang", choices=LANGUAGES, help="the workbook's language if left out")
    parser.add_argument("--out", default="slides", metavar="DIR", help="where to; %(default)s if left out")
    parser.add_argument("--no-notes", action="store_true", help="leave out what the speaker says")
    parser.add_argument("--single-file", action="store_true", help="everything in one file that can be mailed")
    return parser.parse_args(list(words))
