"""Merge a new page with the learner's, cell by cell and by name.

    as handed out   yours          new            what you get
    a               a              b              b              untouched cells are replaced
    a               yours          a              yours          answers stay
    a               yours          b              yours, then b  both changed: the new one stands beside, as text
    -               yours          -              yours          cells of your own stay where they were
    a               -              a              -              what you took out stays out
    a               -              b              b              unless it is new

This is the three-way merge of version control, with cells for lines.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

from ...text import Text

__all__ = ["Merged", "merge_notebooks"]

Cell = dict[str, Any]

BESIDE = Text(
    en="**New in tflab {version}.** You changed the cell above, and so did we. Yours stays; this is ours:",
    ko="**tflab {version}에서 바뀐 내용입니다.** 위 셀은 직접 고친 것이라 그대로 두었고, 이것이 새 셀입니다.",
)


@dataclass(frozen=True)
class Merged:
    """A merged file: its content, how many cells of the learner's it keeps, and how many have the new one beside."""

    content: bytes
    kept: int = 0
    beside: int = 0


def merge_notebooks(base: bytes | None, mine: bytes, new: bytes, *, language: str, version: str) -> Merged | None:
    """Return the new notebook with what the learner wrote in it; None if theirs is not a notebook.

    Args:
        base: the notebook as it was handed out, if that is known.
    """
    try:
        written = json.loads(mine)
        own = _by_name(written["cells"])
        page = json.loads(new)
        before = _by_name(json.loads(base)["cells"]) if base else {}
    except (ValueError, KeyError, TypeError, AttributeError):
        return None
    merge = _Merge(before, own, language, version, known=base is not None)
    cells: list[Cell] = []
    ours = _by_name(page["cells"])
    for name, cell in ours.items():
        cells += merge.cells_for(name, cell)
    cells = merge.with_own_cells(cells, set(ours))
    metadata = {**written.get("metadata", {}), **page.get("metadata", {})}
    merged = {**page, "metadata": metadata, "cells": cells}
    content = json.dumps(merged, indent=1, ensure_ascii=False, sort_keys=True) + "\n"
    return Merged(content.encode(), merge.kept, merge.beside)


class _Merge:
    """One merge at work."""

    def __init__(self, before: dict[str, Cell], own: dict[str, Cell], language: str, version: str, known: bool) -> None:
        self.before, self.own = before, own
        self.language, self.version, self.known = language, version, known
        self.kept = self.beside = 0

    def cells_for(self, name: str, new: Cell) -> list[Cell]:
        """Return what stands in the place of one cell of the new page."""
        mine, base = self.own.get(name), self.before.get(name)
        if mine is None:
            return [] if self.known and name in self.before and _text(base) == _text(new) else [new]
        metadata = {**mine.get("metadata", {}), **new.get("metadata", {})}
        yours = {**mine, "metadata": metadata}
        if _text(mine) == _text(new):
            not_run = mine.get("outputs") and mine["outputs"] == (base or {}).get("outputs")
            return [new if new.get("outputs") or not_run else yours]  # what `check` said stays in sight
        if _text(mine) == _text(base):
            return [new]
        self.kept += 1
        if _text(base) == _text(new) or (not self.known and "answer" in metadata.get("tags", ())):
            return [yours]
        note = self._note(name, new)
        if note["id"] in self.own:  # it stands there since an update that was cut short
            return [yours]
        self.beside += 1
        return [yours, note]

    def with_own_cells(self, cells: list[Cell], ours: set[str]) -> list[Cell]:
        """Return the cells with the learner's own among them, each behind the one that it stood behind."""
        result = list(cells)
        previous = None
        for name, cell in self.own.items():
            written = name not in self.before or _text(cell) != _text(self.before[name])
            if name not in ours and written and _text(cell).strip():
                result.insert(_behind(result, previous), cell)
                self.kept += 1
            if any(there.get("id") == name for there in result):
                previous = name
        return result

    def _note(self, name: str, new: Cell) -> Cell:
        """Return the new cell as text, so that running the page does not put it over the learner's."""
        text = _text(new)
        if new["cell_type"] == "code":
            text = f"```python\n{text}\n```"
        said = BESIDE.say(self.language, version=self.version)
        mark = "".join(letter if letter.isalnum() else "-" for letter in self.version)
        return {
            "cell_type": "markdown",
            "id": f"{name[:40]}-new-{mark}"[:64],
            "metadata": {"tags": ["new"]},
            "source": f"{said}\n\n{text}",
        }


def _behind(cells: list[Cell], name: str | None) -> int:
    """Return the place behind the cell of that name and the note that belongs to it."""
    for i, cell in enumerate(cells):
        if name is not None and cell.get("id") == name:
            follows = i + 1
            while follows < len(cells) and cells[follows].get("id", "").startswith(f"{name[:40]}-new-"):
                follows += 1
            return follows
    return 0


def _by_name(cells: list[Cell]) -> dict[str, Cell]:
    """Return the cells by their ids, each with one of its own: a copy of a cell is another cell."""
    named: dict[str, Cell] = {}
    for place, cell in enumerate(cells):
        name = cell.get("id") or f"cell-{place}"
        while name in named:
            name = f"{name[:60]}-{place}"
        named[name] = {**cell, "id": name}
    return named


def _text(cell: Cell | None) -> str | None:
    if cell is None:
        return None
    source = cell.get("source", "")
    return source if isinstance(source, str) else "".join(source)
