"""Plan which cells to run: the given cells of the release, the learner's answers, and cells that test them.

    e3-2-given, e3-2-answer       ours, theirs
    e3-2-check        ->          probe "9d1f...": one message with the outcomes of all cases

What is given comes from the pack, not from the notebook. Normally a task is probed in one
cell. Looked at closely, after trouble, each case has a cell of its own, so that one that does
not end leaves the others their credit; the time of one cell is for all of them, and for what
is left then, a fifth of it. Some cases of a function are asked twice, at a distance.
Expected values are nowhere in here.
"""

from __future__ import annotations

import json
import secrets
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from ..submissions.reader import SubmittedNotebook
from ..submissions.remarks import Remark
from .cells import Master, MasterCell, NotebookMatch, defines, match_notebook
from .draw import asks_of
from .job import RunCell

__all__ = ["BRIEFLY", "Asked", "MergedNotebook", "RunPlan", "merge_submission", "plan"]


@dataclass(frozen=True)
class MergedNotebook:
    """What to run, which tasks have an answer at all, and what is to be said about it."""

    cells: tuple[RunCell, ...]
    answered: tuple[str, ...]
    remarks: tuple[Remark, ...] = ()


def merge_submission(master: Master, handed_in: SubmittedNotebook) -> MergedNotebook:
    """Return what runs of a notebook in the place of the master's answers."""
    theirs = match_notebook(master, handed_in)
    cells = _own_behind("", "", theirs)
    for cell in master.cells:
        cells += _in_place_of(cell, master, theirs)
    cells += _probes_at_the_end(master, theirs, cells)
    counted = tuple(cell for cell in cells if cell.kind != "probe" or cell.task not in theirs.void)
    return MergedNotebook(counted, _answered(master, theirs), theirs.complaints)


def _in_place_of(cell: MasterCell, master: Master, theirs: NotebookMatch) -> list[RunCell]:
    """Return what runs where one of the master's cells stood."""
    own = _own_behind(cell.name, cell.task, theirs)
    if cell.role == "answer":
        mine = [] if cell.task in theirs.stubs else [RunCell("answer", cell.name, theirs.sources[cell.name], cell.task)]
        return [*mine, *own]
    if cell.role == "check":
        # What is asked may also be completed behind the check: look again there.
        again = [RunCell("probe", f"{cell.name}-again", task=cell.task)] if own else []
        return [RunCell("probe", cell.name, task=cell.task), *own, *again]
    return [RunCell("ours", cell.name, cell.source, cell.task), *_stubs_behind(cell, master, theirs), *own]


def _answered(master: Master, theirs: NotebookMatch) -> tuple[str, ...]:
    """Return the tasks that are worth a look."""
    tasks = [cell.task for cell in master.answers if theirs.wrote_elsewhere or cell.task not in theirs.stubs]
    return tuple(task for task in tasks if task not in theirs.void)


def _own_behind(name: str, task: str, theirs: NotebookMatch) -> list[RunCell]:
    """Return the learner's own cells behind one of ours."""
    texts = [*theirs.kept.get(name, ()), *theirs.own.get(name, ())]
    return [RunCell("own", f"{name or 'top'}+{number}", text, task) for number, text in enumerate(texts, start=1)]


def _stubs_behind(cell: MasterCell, master: Master, theirs: NotebookMatch) -> list[RunCell]:
    """Return the answers that were left as they were and that stand behind this cell.

    They come before all else of their task, so that they undo no answer that stands in a cell of the learner's own.
    """
    if cell.role == "given":
        tasks = {cell.task}
    elif cell is _last_before_the_tasks(master):
        tasks = set(master.tasks) - {other.task for other in master.cells if other.role == "given"}
    else:
        return []
    return [_stub(answer, master, theirs) for answer in master.answers if answer.task in tasks & theirs.stubs]


def _last_before_the_tasks(master: Master) -> MasterCell | None:
    first = next((number for number, cell in enumerate(master.cells) if cell.task), len(master.cells))
    return master.cells[first - 1] if first else None


def _stub(answer: MasterCell, master: Master, theirs: NotebookMatch) -> RunCell:
    """Return what fills the place of an answer; if its cell is gone, unless another cell has answered already."""
    unless = master.asked[answer.task] if answer.task in theirs.lost else ()
    names = ", ".join(map(repr, sorted(unless)))
    source = f"if not {{{names}}} & set(globals()): exec({answer.source!r})" if names else answer.source
    return RunCell("stub", f"{answer.name}-stub", source, answer.task)


def _probes_at_the_end(master: Master, theirs: NotebookMatch, cells: Sequence[RunCell]) -> list[RunCell]:
    """Return one more look at each task that may be answered further down than its check."""
    if not theirs.wrote_elsewhere:
        return []
    half = {cell.task for cell in master.answers if not defines(theirs.sources[cell.name]) & defines(cell.source)}
    checks = [cell for cell in master.cells if cell.role == "check" and cell.task in half | theirs.stubs]
    written = [check for check in checks if _is_written_behind(cells, check.task, theirs)]
    return [RunCell("probe", f"{check.name}-again", task=check.task) for check in written]


def _is_written_behind(cells: Sequence[RunCell], task: str, theirs: NotebookMatch) -> bool:
    """Return whether there is a cell behind the last probe of a task that may answer it."""
    kinds = ("own", "answer") if task in theirs.lost else ("own",)
    last = max(number for number, cell in enumerate(cells) if (cell.kind, cell.task) == ("probe", task))
    return any(cell.kind in kinds for cell in cells[last:])


BRIEFLY = 0.2  # of the time, for what is left of a task
ALWAYS_RUN = ("ours", "own", "answer")  # kinds of cells; a stub runs for its own task only


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
    merged: MergedNotebook,
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
    for place, cell in enumerate(_up_to_the_last(merged.cells, set(wanted))):
        if cell.kind == "probe" and cell.task in wanted and cell.task in tasks:
            left = (places_left or {}).get(cell.task)
            for places in _groups(tasks[cell.task], closely, left):
                identity = secrets.token_hex(8)
                asked[identity] = Asked(cell.task, places, cell.name.endswith("-again"))
                source = _probe(identity, tasks[cell.task], places)
                part = 1.0 if left is None else BRIEFLY
                cells.append(replace(cell, source=source, probe=identity, shared=str(place), part=part))
        elif cell.name not in without and (cell.kind in ALWAYS_RUN or (cell.kind == "stub" and cell.task in wanted)):
            cells.append(replace(cell, part=own_part) if cell.kind == "own" else cell)
    return RunPlan(tuple(_joined(cells)), asked)


def _preparation(tasks: Mapping[str, Mapping[str, Any]]) -> RunCell:
    givens = {task: held["given"] for task, held in tasks.items()}
    say = "from tflab.grading.kernels.probe_answer import prepare as _prepare; "
    return RunCell("ours", "ours", f"{say}_prepare({json.dumps(givens)!r})")


def _up_to_the_last(cells: Sequence[RunCell], wanted: Collection[str]) -> Sequence[RunCell]:
    """Return the cells up to the last that has to do with a task that is wanted."""
    last = max((number for number, cell in enumerate(cells) if cell.task in wanted), default=-1)
    return cells[: last + 1]


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
    say = "from tflab.grading.kernels.probe_answer import probe_answer as _probe; "
    return f"{say}_probe({identity!r}, lambda: {task['answer']}, {json.dumps(args)!r})"
