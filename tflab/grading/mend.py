"""How does a release that is out take in what was mended?  Task by task: a question that is the same is taken in new.

    as released                   this version                     after --update
    E3.2  given a = 2.31, ...     given a = 2.31, ... text mended  the new text, replies, right answers
    E3.4  given b = 1.07, ...     draws other numbers              as it was released, in all its parts
    -                             E3.8                             not in this release: nobody's points change
    E3.5                          -                                as it was released

Seed, roster, stamps and points stay, so what was handed in before is graded as well as
what comes after; each chapter as it was is kept in the pack.  Around answers, the
learners' copies are brought up to date cell by cell (a three-way merge, see `merge.py`
of the workbook).  Read `grade.py` next.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from itertools import chain
from pathlib import Path
from typing import Any, NamedTuple

from tflab.workbook.answers.values import Plain
from tflab.workbook.tasks.task import slug

__all__ = ["Mended", "mended_cases", "mended_exercise", "notebook_of"]

TASK_CELL = re.compile(r"e\d+-\d+(?=-|$)")
SAME = ("kind", "points", "answer", "is_function", "counts")  # of a task, or it is another one
TITLE = "title"  # says how many tasks there are, and how many points


class Mended(NamedTuple):
    """A chapter's cases after an update, and the tasks that stay as they were released."""

    graded: dict[str, Any]
    staying: tuple[str, ...]
    left_out: tuple[str, ...]


def mended_cases(released: Mapping[str, Any], new: Mapping[str, Any]) -> Mended:
    """Return what a chapter is graded on: each task new where it asks the same as it did, else as it was released."""
    before, now = released["tasks"], new["tasks"]
    staying = tuple(task for task in before if not _asks_the_same(before[task], now.get(task)))
    tasks = {task: before[task] if task in staying else now[task] for task in before}
    return Mended({**new, "tasks": tasks}, staying, tuple(task for task in now if task not in before))


def mended_exercise(
    released: Mapping[str, Any], new: Mapping[str, Any], tasks: Iterable[str], staying: Iterable[str]
) -> dict[str, Any]:
    """Return an exercise: new, with the tasks of the release and no others, those that stay as they were.

    Args:
        tasks: those of the release.
    """
    names, kept = {slug(task) for task in tasks}, {slug(task) for task in staying}
    before = {name: _cells_of(released, name) for name in sorted(kept)}
    cells: list[Any] = []
    for cell in new["cells"]:
        name = _task_of(cell)
        if name in kept:
            cells += before.pop(name, [])  # all of it, where the first of its cells stands now
        elif not name or name in names:
            cells.append(cell)
    behind = max((number for number, cell in enumerate(cells, start=1) if _task_of(cell)), default=len(cells))
    cells[behind:behind] = list(chain.from_iterable(before.values()))
    if {_task_of(cell) for cell in new["cells"]} - {""} != names:
        cells = [_titled(cell, released) for cell in cells]
    return {**new, "cells": cells}


def _cells_of(notebook: Mapping[str, Any], task: str) -> list[Any]:
    return [cell for cell in notebook["cells"] if _task_of(cell) == task]


def _titled(cell: Any, released: Mapping[str, Any]) -> Any:
    """Return a cell; of the title the released one, which counts the released tasks."""
    return next((old for old in released["cells"] if old["id"] == cell["id"] == TITLE), cell)


def _task_of(cell: Mapping[str, Any]) -> str:
    """Return the task that a cell belongs to, as cells are named after it; "" if none."""
    found = TASK_CELL.match(cell["id"])
    return found[0] if found else ""


def _asks_the_same(before: Mapping[str, Any], now: Mapping[str, Any] | None) -> bool:
    """Return whether a task asks for the same thing about the same values."""
    if now is None or any(before.get(name, now.get(name)) != now.get(name) for name in SAME):
        return False
    return _shape(before["form"]) == _shape(now["form"]) and _asked(before) == _asked(now)


def _asked(task: Mapping[str, Any]) -> list[Plain]:
    """Return all values that a task asks about, in all its variants."""
    return [[variant["given"], [case["args"] for case in variant["cases"]]] for variant in task["variants"]]


def _shape(form: Plain) -> Plain:
    """Return a form without how near is near enough."""
    if isinstance(form, dict):
        return {name: _shape(part) for name, part in form.items() if "tolerance" not in name}
    return form


def notebook_of(path: Path) -> dict[str, Any] | None:
    """Return a notebook of ours in a file; None if it is not there, or no notebook."""
    try:
        notebook = json.loads(path.read_text(encoding="utf-8"))
        return notebook if isinstance(notebook["cells"], list) else None
    except (OSError, ValueError, TypeError, KeyError):
        return None
