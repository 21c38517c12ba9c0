"""Which cells run, in which order?  Ours, theirs, and a probe where a check stood.

    prepare + load + imports      one cell of ours: what is given comes from the pack, not from the notebook
    e3-2-given, e3-2-answer       ours, theirs
    e3-2-check        ->          probe "9d1f...": one message with the outcomes of all cases
    e3-3-given ...

Normally a task is probed in one cell.  Looked at closely, after trouble, each case
has a cell of its own, so that one that does not end leaves the others their credit;
the time of one cell is for all of them, and for what is left then, a fifth of it.
Some cases of a function are asked twice, at a distance.  Expected values are
nowhere in here.
"""

from __future__ import annotations

import json
import secrets
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from .draw import asks_of
from .run import RunCell
from .transplant import Transplant

__all__ = ["BRIEFLY", "Asked", "RunPlan", "plan"]

BRIEFLY = 0.2  # of the time, for what is left of a task


@dataclass(frozen=True, slots=True)
class Asked:
    """What a probe asks: outcomes of a task's cases, by their places in the order of asking."""

    task: str
    places: tuple[int, ...]
    again: bool = False  # behind the learner's own cells that follow the check


@dataclass(frozen=True)
class RunPlan:
    """The cells in order, and what each probe asks."""

    cells: tuple[RunCell, ...]
    asked: dict[str, Asked]


def plan(
    transplanted: Transplant,
    tasks: Mapping[str, Mapping[str, Any]],
    wanted: Collection[str],
    *,
    without: Collection[str] = (),
    closely: bool = False,
    places_left: Mapping[str, Collection[int]] | None = None,
    own_part: float = 1.0,
) -> RunPlan:
    """Return what to run to hear of the tasks in `wanted`.

    Args:
        tasks: by id, each with its "answer", "is_function", "given", "cases" and the order in which they are asked.
        without: names of cells that are left out.
        closely: a cell for each case.
        own_part: of the time of a cell, for each of the learner's own.
        places_left: of some tasks, one case of which did not end, only what stands here, and briefly.
    """
    cells = [_preparation(tasks)]
    asked: dict[str, Asked] = {}
    for place, cell in enumerate(_up_to_the_last(transplanted.cells, set(wanted))):
        if cell.kind == "probe" and cell.task in wanted and cell.task in tasks:
            left = (places_left or {}).get(cell.task)
            for places in _groups(tasks[cell.task], closely, left):
                identity = secrets.token_hex(8)
                asked[identity] = Asked(cell.task, places, cell.name.endswith("-again"))
                source = _probe(identity, tasks[cell.task], places)
                part = 1.0 if left is None else BRIEFLY
                cells.append(replace(cell, source=source, probe=identity, shared=str(place), part=part))
        elif cell.name not in without and _runs(cell, wanted):
            cells.append(replace(cell, part=own_part) if cell.kind == "own" else cell)
    return RunPlan(tuple(_joined(cells)), asked)


def _preparation(tasks: Mapping[str, Mapping[str, Any]]) -> RunCell:
    givens = {task: held["given"] for task, held in tasks.items()}
    say = "from tflab.grading.kernels.probe import prepare as _prepare; "
    return RunCell("ours", "ours", f"{say}_prepare({json.dumps(givens)!r})")


def _up_to_the_last(cells: Sequence[RunCell], wanted: Collection[str]) -> Sequence[RunCell]:
    """Return the cells up to the last that has to do with a task that is wanted."""
    last = max((number for number, cell in enumerate(cells) if cell.task in wanted), default=-1)
    return cells[: last + 1]


def _runs(cell: RunCell, wanted: Collection[str]) -> bool:
    return cell.kind in ("ours", "own", "answer") or (cell.kind == "stub" and cell.task in wanted)


def _joined(cells: Sequence[RunCell]) -> list[RunCell]:
    """Return the cells with ours in one, behind the probe before them if there is one.

    A cell less is a millisecond less.  What stands behind the last cell that is not ours is not needed.
    """
    joined: list[RunCell] = []
    ours: list[str] = []
    for cell in cells:
        if cell.kind == "ours":
            ours.append(cell.source)
            continue
        if ours and joined and joined[-1].probe:
            joined[-1] = replace(joined[-1], source="\n".join([joined[-1].source, *ours]))
        elif ours:
            joined.append(RunCell("ours", "ours", "\n".join(ours)))
        ours = []
        joined.append(cell)
    return joined


def _groups(task: Mapping[str, Any], closely: bool, left: Collection[int] | None) -> list[tuple[int, ...]]:
    places = [place for place in range(len(asks_of(task))) if left is None or place in left]
    return [(place,) for place in places] if closely else [tuple(places)] if places else []


def _probe(identity: str, task: Mapping[str, Any], places: tuple[int, ...]) -> str:
    asks = asks_of(task)
    args = [task["cases"][asks[place]]["args"] for place in places] if task["is_function"] else None
    say = "from tflab.grading.kernels.probe import probe as _probe; "
    return f"{say}_probe({identity!r}, lambda: {task['answer']}, {json.dumps(args)!r})"
