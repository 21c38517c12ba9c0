"""What of a notebook counts?  The answers, and the learner's own cells between ours; everything else is the master's.

    master                    handed in                 what runs
    load                      load (changed)            load            the master's
                              import math               import math     the learner's own
    e3-2-given                e3-2-given                e3-2-given      the master's
    e3-2-answer  x = ...      e3-2-answer  x = f(2)     e3-2-answer     the learner's
    e3-2-check                e3-2-check                <probe E3.2>

A fold over the master's cells: each becomes the cells that stand in its place.  Two
different cells that answer under one name void that answer and no other.  Own cells
stay behind the cell of ours that they were put behind.  An answer that only a cell
behind the check completes is seen by a second probe there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..submissions.reader import SubmittedNotebook
from ..submissions.remarks import Remark
from .cells import Master, MasterCell, Theirs, compared, defined
from .run import RunCell

__all__ = ["Transplant", "transplant"]


@dataclass(frozen=True)
class Transplant:
    """What to run, which tasks have an answer at all, and what is to be said about it."""

    cells: tuple[RunCell, ...]
    answered: tuple[str, ...]
    remarks: tuple[Remark, ...] = ()


def transplant(master: Master, handed_in: SubmittedNotebook) -> Transplant:
    """Return what runs of a notebook in the place of the master's answers."""
    theirs = compared(master, handed_in)
    cells = _own_behind("", "", theirs)
    for cell in master.cells:
        cells += _in_place_of(cell, master, theirs)
    cells += _probes_at_the_end(master, theirs, cells)
    counted = tuple(cell for cell in cells if cell.kind != "probe" or cell.task not in theirs.void)
    return Transplant(counted, _answered(master, theirs), theirs.complaints)


def _in_place_of(cell: MasterCell, master: Master, theirs: Theirs) -> list[RunCell]:
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


def _answered(master: Master, theirs: Theirs) -> tuple[str, ...]:
    """Return the tasks that are worth a look."""
    tasks = [cell.task for cell in master.answers if theirs.wrote_elsewhere or cell.task not in theirs.stubs]
    return tuple(task for task in tasks if task not in theirs.void)


def _own_behind(name: str, task: str, theirs: Theirs) -> list[RunCell]:
    """Return the learner's own cells behind one of ours."""
    texts = [*theirs.kept.get(name, ()), *theirs.own.get(name, ())]
    return [RunCell("own", f"{name or 'top'}+{number}", text, task) for number, text in enumerate(texts, start=1)]


def _stubs_behind(cell: MasterCell, master: Master, theirs: Theirs) -> list[RunCell]:
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


def _stub(answer: MasterCell, master: Master, theirs: Theirs) -> RunCell:
    """Return what fills the place of an answer; if its cell is gone, unless another cell has answered already."""
    unless = master.asked[answer.task] if answer.task in theirs.lost else ()
    names = ", ".join(map(repr, sorted(unless)))
    source = f"if not {{{names}}} & set(globals()): exec({answer.source!r})" if names else answer.source
    return RunCell("stub", f"{answer.name}-stub", source, answer.task)


def _probes_at_the_end(master: Master, theirs: Theirs, cells: Sequence[RunCell]) -> list[RunCell]:
    """Return one more look at each task that may be answered further down than its check."""
    if not theirs.wrote_elsewhere:
        return []
    half = {cell.task for cell in master.answers if not defined(theirs.sources[cell.name]) & defined(cell.source)}
    checks = [cell for cell in master.cells if cell.role == "check" and cell.task in half | theirs.stubs]
    written = [check for check in checks if _is_written_behind(cells, check.task, theirs)]
    return [RunCell("probe", f"{check.name}-again", task=check.task) for check in written]


def _is_written_behind(cells: Sequence[RunCell], task: str, theirs: Theirs) -> bool:
    """Return whether there is a cell behind the last probe of a task that may answer it."""
    kinds = ("own", "answer") if task in theirs.lost else ("own",)
    last = max(number for number, cell in enumerate(cells) if (cell.kind, cell.task) == ("probe", task))
    return any(cell.kind in kinds for cell in cells[last:])
