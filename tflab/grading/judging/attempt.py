"""What comes out when a submission runs?  Outcomes for each task, though one of them may hang, die or shout.

    run everything in one kernel
      |-- all probes answered                        done
      `-- E3.4 does not end (dies, floods)           E3.4 is set aside; what is left runs in a fresh kernel

Those that were set aside are tried once more when nothing else runs on the machine,
with three times the time, each case in a cell of its own (`closely`).  So one endless
function costs its own points, not its neighbours', and a busy machine costs nobody.
Three times is for all cases of a task; once they have not ended within that, those
that are left are asked once more, briefly, for they may be right.
Read `marks.py` next.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

from tflab.workbook.answers.values import is_unanswered
from tflab.workbook.tasks.task import slug

from ..submissions.remarks import Remark
from .marks import safe_error_name
from .plan import Plan, PlannedCell, plan
from .transplant import Transplant

__all__ = ["Attempt", "NotRun", "Ran", "RanCell", "Runner", "attempt"]

MOST_RUNS = 20
ENOUGH_TO_KNOW = 2  # cases of one task that do not end
MOST_TIMES_THE_NOTEBOOK = 2.0
REMARK_OF = {"timed out": "timed out", "output limit": "flood", "unreadable output": "flood"}  # else it died


class NotRun(Exception):
    """The kernel did not even run our own cells: no fault of the learner's."""


class RanCell(Protocol):
    """What became of one cell."""

    value: Any
    trouble: str | None


class Ran(Protocol):
    """What became of the cells, as far as they ran."""

    outcomes: Sequence[RanCell]
    seconds: float
    stopped: str | None  # why the last of them was the last


Runner = Callable[[Sequence[PlannedCell], bool], Ran]  # patiently, or with the usual limits


@dataclass
class Attempt:
    """What came out.

    Attributes:
        outcomes: for each task its outcomes by case.
        trouble: for each task, what the run says of it.
        set_aside: tasks that hit a deadline or died: to be tried alone.
        remarks: on the notebook as a whole.
    """

    outcomes: dict[str, dict[int, Any]] = field(default_factory=dict)
    trouble: dict[str, list[Remark]] = field(default_factory=dict)
    set_aside: list[str] = field(default_factory=list)
    remarks: list[Remark] = field(default_factory=list)
    seconds: float = 0.0


def attempt(
    transplanted: Transplant,
    tasks: Mapping[str, Mapping[str, Any]],
    run: Runner,
    *,
    wanted: Sequence[str],
    cell_s: float,
    notebook_s: float,
    closely: bool = False,
    leave_out: Collection[str] = (),
) -> Attempt:
    """Run a notebook as often as it takes to hear of each task in `wanted`, or of what is wrong with it.

    Args:
        cell_s: what a cell may take, for what is said.
        notebook_s: what all cells together may take.
        closely: patiently, and each case in a cell of its own.
        leave_out: tasks whose answers do not run.

    Raises:
        NotRun: our own cells did not run.
    """
    made = Attempt()
    left = list(wanted)
    without = {piece.name for piece in transplanted.pieces if piece.kind == "answer" and piece.task in leave_out}
    cases_left: dict[str, set[int]] = {}
    heard_again: dict[str, dict[int, Any]] = {}
    own_that_hang: set[str] = set()
    hung: Counter[str] = Counter()
    for _ in range(MOST_RUNS):
        if not left or made.seconds > notebook_s * MOST_TIMES_THE_NOTEBOOK:
            break
        planned = plan(transplanted, tasks, left, without=without, closely=closely, cases_left=cases_left)
        ran = run(planned.cells, closely)
        made.seconds += ran.seconds
        stopped = _listen(planned, ran, made, heard_again)
        if stopped is None:
            left = []
            break
        cell, trouble = stopped
        piece = cell.piece
        if piece.kind == "ours":
            raise NotRun(trouble)
        remark = Remark(REMARK_OF.get(trouble, "died"), piece.task, seconds=f"{cell_s:g}")
        if piece.kind == "own":
            own_that_hang.add(piece.name)
            without.add(piece.name)
            continue
        made.trouble[piece.task] = [remark]
        asked = planned.asked.get(cell.probe or "")
        hung[piece.task] += 1
        if closely and asked is not None and hung[piece.task] < ENOUGH_TO_KNOW:
            cases = cases_left.setdefault(piece.task, set(range(len(tasks[piece.task]["cases"]) + 1)))
            cases -= {*asked.cases, *made.outcomes.get(piece.task, {})}
        else:
            made.set_aside.append(piece.task)
            without |= {cell.name for cell in transplanted.pieces if (cell.kind, cell.task) == ("answer", piece.task)}
        left = [task for task in left if task not in made.set_aside and not _is_heard(task, tasks, made, cases_left)]
    for task in left:
        made.set_aside.append(task)
        made.trouble[task] = [Remark("timed out", task, seconds=f"{notebook_s:g}")]
    if own_that_hang:
        made.set_aside = list(wanted)  # they may have needed it
        made.remarks += [Remark("left out", cell=name.rpartition("+")[0]) for name in sorted(own_that_hang)]
    _prefer_what_was_answered_later(made, heard_again)
    return made


def _listen(
    planned: Plan, ran: Ran, made: Attempt, heard_again: dict[str, dict[int, Any]]
) -> tuple[PlannedCell, str] | None:
    """Take in what came out; return the cell at which the run was stopped, and why, if it was."""
    for cell, became in zip(planned.cells, ran.outcomes, strict=False):
        asked = planned.asked.get(cell.probe or "")
        if asked is not None and isinstance(became.value, list) and len(became.value) == len(asked.cases):
            heard = heard_again if asked.again else made.outcomes
            heard.setdefault(asked.task, {}).update(zip(asked.cases, became.value, strict=True))
        elif (became.trouble or "").startswith("error: ") and cell.piece.kind == "answer":
            name = became.trouble.removeprefix("error: ").partition(":")[0]
            made.trouble[cell.piece.task] = [Remark("raised", cell.piece.task, error=safe_error_name(name))]
    return (planned.cells[len(ran.outcomes) - 1], ran.stopped) if ran.stopped else None


def _is_heard(
    task: str, tasks: Mapping[str, Mapping[str, Any]], made: Attempt, cases_left: Mapping[str, Collection[int]]
) -> bool:
    """Return whether every case that can be asked has answered."""
    cases = cases_left.get(task, set(range(len(tasks[task]["cases"]))))
    return set(cases) <= set(made.outcomes.get(task, ()))


def _prefer_what_was_answered_later(made: Attempt, heard_again: dict[str, dict[int, Any]]) -> None:
    """Take the outcomes from behind the learner's own cells where there were none at the check."""
    for task, later in heard_again.items():
        if _is_nothing(made.outcomes.get(task, {})) and not _is_nothing(later):
            made.outcomes[task] = later
            made.trouble.pop(task, None)
            made.remarks.append(Remark("elsewhere", task, cell=f"{slug(task)}-answer"))


def _is_nothing(outcomes: Mapping[int, Any]) -> bool:
    return all(
        is_unanswered(plain) or (isinstance(plain, dict) and plain.get("raises") == "NameError")
        for plain in outcomes.values()
    )
