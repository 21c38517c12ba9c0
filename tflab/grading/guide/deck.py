"""Write a page as slides with votes: the instructor types the counts, and the slide shows the shares.

    page's cells  --votes put among them-->  notebook  --as `tflab slides`-->  deck, with `static/votes.js` in it

A slide that does nothing but ask is not shown twice: the vote takes its place.
The deck is a file: what is typed stays in this browser.
For a plan only some cells are shown; all of them run.
"""

from __future__ import annotations

import copy
import json
import re
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from tflab.text import Texts
from tflab.workbook.pages.slides import deck_from_notebook

from .layout import STATIC, inline, markdown
from .teaching import ARGUE_BELOW, EXPLAIN_BELOW, RULES, Vote

__all__ = ["only", "with_votes", "write_deck"]

BEGINS, FRAGMENT = ("slide", "subslide"), "fragment"
HEADING = re.compile(r"#{1,6} .*\S")
TEXTS = Texts(__file__)
SHOWN = ("expected", "voters", "again", "say", "clear", "right", "later", "do0", "do1", "do2")  # what votes.js shows


def write_deck(
    notebook: Mapping[str, Any],
    votes: Sequence[Vote],
    out_dir: Path,
    *,
    name: str,
    language: str,
    cells: Collection[str] = (),
) -> Path:
    """Run a page and write it as a deck with its votes; return the deck's path.

    Args:
        name: of the file, without its ending.
        cells: what is shown; everything if empty.

    Raises:
        PageRunError: a cell raised an error, or nothing is shown.
    """
    chosen = only(notebook, cells) if cells else notebook
    shown = [vote for vote in votes if not cells or vote.after in cells]
    with TemporaryDirectory() as folder:
        path = Path(folder) / f"{name}.ipynb"
        path.write_text(json.dumps(with_votes(chosen, shown, language)), encoding="utf-8")
        deck = deck_from_notebook(path, out_dir)
    if shown:
        content, end, rest = deck.read_text(encoding="utf-8").rpartition("</body>")
        deck.write_text(content + _scripts(shown, language) + end + rest, encoding="utf-8")
    return deck


def with_votes(notebook: Mapping[str, Any], votes: Sequence[Vote], language: str) -> dict[str, Any]:
    """Return a notebook with a slide for each vote, behind what is shown together with the cell it comes after.

    Where that is one cell, and the question all that it says, the vote takes its place.
    """
    cells: list[dict[str, Any]] = copy.deepcopy(notebook["cells"])
    for number, vote in reversed(list(enumerate(votes, start=1))):
        asks = next(index for index, cell in enumerate(cells) if cell["id"] == vote.after)
        at = asks + 1
        if vote.asked == vote.after and _is_alone(cells, asks):
            _take_its_place(cells[asks], vote, number, language)
            continue
        while at < len(cells) and _kind(cells[at]) not in (*BEGINS, FRAGMENT):
            at += 1
        if at < len(cells) and _kind(cells[at]) == FRAGMENT:  # what a fragment tells, a vote must not know
            cells[at]["metadata"]["slideshow"]["slide_type"] = "subslide"
        cells.insert(at, _slide(vote, number, language))
    return {**notebook, "cells": cells}


def only(notebook: Mapping[str, Any], chosen: Collection[str]) -> dict[str, Any]:
    """Return a notebook of which a deck shows the chosen cells alone; all of them still run."""
    cells: list[dict[str, Any]] = copy.deepcopy(notebook["cells"])
    begins = "slide"
    for cell in cells:
        kind = _kind(cell)
        begins = kind if kind in BEGINS else begins
        if cell["id"] not in chosen:
            kind = "skip"
        elif kind == "skip" or begins:
            kind = begins or "-"
        if kind != "skip":
            begins = ""
        cell["metadata"].setdefault("slideshow", {})["slide_type"] = kind
    return {**notebook, "cells": cells}


def _kind(cell: Mapping[str, Any]) -> str:
    return cell["metadata"].get("slideshow", {}).get("slide_type", "-")


def _is_alone(cells: Sequence[Mapping[str, Any]], at: int) -> bool:
    """Return whether a cell is all that its slide shows."""
    rest = (_kind(cell) for cell in cells[at + 1 :] if _kind(cell) != "skip")
    return _kind(cells[at]) in BEGINS and next(rest, "slide") in BEGINS


def _take_its_place(cell: dict[str, Any], vote: Vote, number: int, language: str) -> None:
    """Let a slide that only asks take the vote itself, under its own heading."""
    made = _slide(vote, number, language)
    heading = HEADING.match("".join(cell["source"]))
    cell["source"] = made["source"].replace("## ", f"{heading[0]} · " if heading else "## ", 1)
    ours = cell["metadata"].setdefault("tflab", {})
    ours["notes"] = "\n\n".join(filter(None, (ours.get("notes"), _notes(vote, language))))


def _slide(vote: Vote, number: int, language: str) -> dict[str, Any]:
    called = TEXTS["vote"].say(language)
    source = f'## {called} {number}\n\n{vote.question}\n\n<div class="tflab-vote" data-vote="{vote.name}"></div>'
    return {
        "cell_type": "markdown",
        "id": f"vote-{vote.name}",
        "metadata": {"slideshow": {"slide_type": "subslide"}, "tflab": {"notes": _notes(vote, language)}},
        "source": source,
    }


def _notes(vote: Vote, language: str) -> str:
    """Return what the speaker reads beside a vote: the right option, what to say to each, and the rule."""
    lines = []
    for option in vote.options:
        right = " ✓" if option.is_right else ""
        say = " ".join(option.say.split())
        lines.append(f"- **{option.label}** {option.text}{right} ({option.expected:g} %): {say}")
    rules = [f"- {rule.say(language)}" for rule in RULES]
    return "\n".join([*lines, "", *rules])


def _scripts(votes: Sequence[Vote], language: str) -> str:
    words = {name: TEXTS[name].say(language) for name in SHOWN}
    rows = [
        {
            "stem": vote.stem,
            "name": vote.name,
            "later": bool(vote.answered),
            "options": [
                {
                    "label": option.label,
                    "html": inline(option.text),
                    "expected": option.expected,
                    "right": option.is_right,
                    "say": markdown(option.say),
                }
                for option in vote.options
            ],
        }
        for vote in votes
    ]
    held = {"votes": rows, "words": words, "bounds": [EXPLAIN_BELOW, ARGUE_BELOW]}
    state = json.dumps(held, ensure_ascii=False).replace("</", "<\\/")  # so that no text of ours ends the script
    style, script = ((STATIC / f"votes.{kind}").read_text(encoding="utf-8") for kind in ("css", "js"))
    return (
        f'<style>{style}</style>\n<script type="application/json" id="tflab-votes">{state}</script>\n'
        f"<script>{script}</script>\n"
    )
