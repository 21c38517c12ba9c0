"""Which cells run, in which order?  Ours, theirs, and a probe where a check stood.

    prepare + load + imports      one cell of ours: what is given comes from the pack, not from the notebook
    e3-2-given, e3-2-answer       ours, theirs
    e3-2-check        ->          probe "9d1f...": one message with the outcomes of all cases
    e3-3-given ...

Normally a task is probed in one cell.  Looked at closely, after trouble, each case
has a cell of its own, so that one that does not end leaves the others their credit;
the time of one cell is for all of them, and for what is left then, a fifth of it.
The first case of a function is asked once more at the end.  Expected values are
nowhere in here.  Read `nbval_items.py` next.
"""

from __future__ import annotations

import json
import secrets
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from typing import Any

from .transplant import Piece, Transplant

__all__ = ["BRIEFLY", "Asked", "Plan", "PlannedCell", "plan"]

BRIEFLY = 0.2  # of the time, for what is left of a task


@dataclass(frozen=True, slots=True)
class Asked:
    """What a probe asks: outcomes of these cases of a task (the number of cases means: the first once more)."""

    task: str
    cases: tuple[int, ...]
    again: bool = False  # behind the learner's own cells that follow the check


@dataclass(frozen=True, slots=True)
class PlannedCell:
    """A cell to run, and the piece it came from.

    Attributes:
        probe: the id of the probe in it, if any.
        shared: cells with the same word take the time of one cell together, ...
        part: ... and of that no more than this.
    """

    piece: Piece
    source: str
    probe: str | None = None
    shared: str = ""
    part: float = 1.0


@dataclass(frozen=True)
class Plan:
    """The cells in order, and what each probe asks."""

    cells: tuple[PlannedCell, ...]
    asked: dict[str, Asked]


def plan(
    transplanted: Transplant,
    tasks: Mapping[str, Mapping[str, Any]],
    wanted: Collection[str],
    *,
    without: Collection[str] = (),
    closely: bool = False,
    cases_left: Mapping[str, Collection[int]] | None = None,
) -> Plan:
    """Return what to run to hear of the tasks in `wanted`.

    Args:
        tasks: by id, each with its "answer", "is_function", "given" and "cases".
        without: names of pieces that are left out.
        closely: a cell for each case.
        cases_left: of some tasks, one case of which did not end, only these cases, and briefly.
    """
    wanted = set(wanted)
    givens = {task: held["given"] for task, held in tasks.items()}
    ours = [f"from tflab.grading.kernels.probe import prepare as _prepare; _prepare({json.dumps(givens)!r})"]
    cells: list[PlannedCell] = []
    asked: dict[str, Asked] = {}
    last = max((number for number, piece in enumerate(transplanted.pieces) if piece.task in wanted), default=-1)

    def flush() -> None:
        if ours and cells and cells[-1].probe:  # a cell less is a millisecond less
            before = cells.pop()
            cells.append(replace(before, source="\n".join([before.source, *ours])))
        elif ours:
            cells.append(PlannedCell(Piece("ours", "ours"), "\n".join(ours)))
        ours.clear()

    for place, piece in enumerate(transplanted.pieces[: last + 1]):
        if piece.name in without:
            continue
        if piece.kind == "ours":
            ours.append(piece.source)
        elif piece.kind in ("own", "answer") or (piece.kind == "stub" and piece.task in wanted):
            flush()
            cells.append(PlannedCell(piece, piece.source))
        elif piece.kind == "probe" and piece.task in wanted and piece.task in tasks:
            flush()
            again = piece.name.endswith("-again")
            left = (cases_left or {}).get(piece.task)
            part = 1.0 if left is None else BRIEFLY
            for cases in _groups(tasks[piece.task], closely, left):
                identity = secrets.token_hex(8)
                asked[identity] = Asked(piece.task, cases, again)
                source = _probe(identity, tasks[piece.task], cases)
                cells.append(PlannedCell(piece, source, identity, str(place), part))
    return Plan(tuple(cells), asked)


def _groups(task: Mapping[str, Any], closely: bool, left: Collection[int] | None) -> list[tuple[int, ...]]:
    count = len(task["cases"])
    cases = [*range(count), count] if task["is_function"] else [0]
    cases = [case for case in cases if left is None or case in left]
    return [(case,) for case in cases] if closely else [tuple(cases)] if cases else []


def _probe(identity: str, task: Mapping[str, Any], cases: tuple[int, ...]) -> str:
    count = len(task["cases"])
    args = [task["cases"][case % count]["args"] for case in cases] if task["is_function"] else None
    say = "from tflab.grading.kernels.probe import probe as _probe; "
    return f"{say}_probe({identity!r}, lambda: {task['answer']}, {json.dumps(args)!r})"
