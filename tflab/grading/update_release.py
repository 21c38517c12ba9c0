"""Update a release to a newer tflab: new texts and fixes, with every learner's answers kept.

    as released                   this version                     after --update
    E3.2  asks about a = 2.31     asks about a = 2.31, new text    the new text, replies, right answers
    E3.4  asks about b = 1.07     asks about b = 2.4               nothing is changed: grade with the old version
    -                             E3.8                             not in this release: nobody's points change

Seed, roster, stamps and points stay, so what was handed in before is graded as well as
what comes after.  Each exercise as it was is kept in the pack.  The learners' copies are
brought up to date cell by cell (a three-way merge, see `merge.py` of the workbook).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from tflab.workbook.tasks.task import slug

__all__ = ["update_exercise"]

TASK_CELL = re.compile(r"e\d+-\d+(?=-|$)")
TITLE = "title"  # says how many tasks there are, and how many points


def update_exercise(released: Mapping[str, Any], new: Mapping[str, Any], tasks: Iterable[str]) -> dict[str, Any]:
    """Return an exercise: new, with the tasks of the release and no others.

    Args:
        tasks: those of the release.
    """
    names = {slug(task) for task in tasks}
    cells = [cell for cell in new["cells"] if _task_of(cell) in names | {""}]
    if {_task_of(cell) for cell in new["cells"]} - {""} != names:
        cells = [_titled(cell, released) for cell in cells]
    return {**new, "cells": cells}


def _titled(cell: Any, released: Mapping[str, Any]) -> Any:
    """Return a cell; of the title the released one, which counts the released tasks."""
    return next((old for old in released["cells"] if old["id"] == cell["id"] == TITLE), cell)


def _task_of(cell: Mapping[str, Any]) -> str:
    """Return the task that a cell belongs to, as cells are named after it; "" if none."""
    found = TASK_CELL.match(cell["id"])
    return found[0] if found else ""
