"""Run a submission's answers; a task that hangs, crashes or prints too much does not affect other tasks.

    run everything in one kernel
      |-- all probes answered                        done
      `-- E3.4 does not end (dies, floods)           E3.4 is set aside; what is left runs in a fresh kernel

Those that were set aside are tried once more when nothing else runs on the machine,
with three times the time, each case in a cell of its own (`closely`).  So one endless
function costs its own points, not its neighbours', and a busy machine costs nobody.
Three times is for all cases of a task; once they have not ended within that, those
that are left are asked once more, briefly, for they may be right.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from tflab.workbook.answers.values import is_unanswered
from tflab.workbook.tasks.task import slug

from ..kernels.limits import Limits
from ..submissions.remarks import Remark
from .draw import asks_of
from .job import NotRun, Run, RunCell, RunCells
from .plan import Asked, MergedNotebook, RunPlan, plan
from .task_score import safe_error_name

__all__ = ["Execution", "execute"]

MOST_RUNS = 40
SHORTLY = 0.05  # of the time of a cell, for each own cell of one who has had several that did not end
ENOUGH_TO_KNOW = 2  # cases of one task, or own cells, that do not end
MOST_TIMES_THE_NOTEBOOK = 2.0
OURS = ("ours", "stub")  # cells in which there is nothing of the learner's
REMARK_OF = {"output limit": "flood", "unreadable output": "flood"}  # else it died


@dataclass(frozen=True)
class Execution:
    """What came out.

    Attributes:
        outcomes: for each task its outcomes, by their places in the order of asking.
        trouble: for each task, what the run says of it.
        set_aside: tasks that hit a deadline or died: to be tried alone.
        remarks: on the notebook as a whole.
    """

    outcomes: Mapping[str, Mapping[int, Any]] = field(default_factory=dict)
    trouble: Mapping[str, Sequence[Remark]] = field(default_factory=dict)
    set_aside: Sequence[str] = ()
    remarks: Sequence[Remark] = ()
    seconds: float = 0.0


def execute(
    merged: MergedNotebook,
    tasks: Mapping[str, Mapping[str, Any]],
    run_cells: RunCells,
    limits: Limits,
    *,
    wanted: Sequence[str],
    closely: bool = False,
    leave_out: Collection[str] = (),
) -> Execution:
    """Run a notebook until every task in `wanted` has an outcome, or a reason why not.

    Args:
        limits: the usual ones.
        closely: with three times the time, and each case in a cell of its own.
        leave_out: tasks whose answers do not run.

    Raises:
        NotRun: our own cells did not run.
    """
    run_limits = limits.times(3) if closely else limits
    notebook_s = run_limits.notebook_s
    tally = OutcomeCollector(merged, tasks, wanted, closely)
    for task in leave_out:
        tally.leave_out(task)
    for _ in range(MOST_RUNS):
        if not tally.left or tally.seconds > notebook_s * MOST_TIMES_THE_NOTEBOOK:
            break
        planned = plan(
            merged, tasks, tally.left, without=tally.without, closely=closely, places_left=tally.places_left,
            own_part=SHORTLY if len(tally.own_that_hang) >= ENOUGH_TO_KNOW else 1.0,
        )  # fmt: skip
        tally.take(planned, run_cells(planned.cells, run_limits), limits.cell_s)
    return tally.result(notebook_s)


class OutcomeCollector:
    """What is known after some runs, and what the next one is to ask.

    Attributes:
        left: tasks that are still to be heard of.
        without: cells that the next run leaves out.
        places_left: of a task one case of which did not end, those that have not been asked.
        own_that_hang: names of the learner's own cells that did not end.
    """

    def __init__(
        self, merged: MergedNotebook, tasks: Mapping[str, Mapping[str, Any]], wanted: Sequence[str], closely: bool
    ) -> None:
        self.left = list(wanted)
        self.without: set[str] = set()
        self.places_left: dict[str, set[int]] = {}
        self.seconds = 0.0
        self._transplanted, self._tasks, self._wanted, self._closely = merged, tasks, tuple(wanted), closely
        self._timed_out = "timed out twice" if closely else "timed out"
        self._outcomes: dict[str, dict[int, Any]] = {}
        self._outcomes_again: dict[str, dict[int, Any]] = {}  # behind the learner's own cells
        self._trouble: dict[str, list[Remark]] = {}
        self._set_aside: list[str] = []
        self.own_that_hang: set[str] = set()
        self._hung: Counter[str] = Counter()

    def take(self, planned: RunPlan, ran: Run, cell_s: float) -> None:
        """Take in the results of a run.

        Raises:
            NotRun: it stopped in a cell of ours, and nothing of the learner's had run by then.
        """
        self.seconds += ran.seconds
        for cell, outcome in zip(planned.cells, ran.outcomes, strict=False):
            self._hear(cell, outcome.value, outcome.trouble or "", planned.asked.get(cell.probe or ""))
        if ran.stopped is None:
            self.left = []
            return
        cell = _to_blame(planned.cells[: len(ran.outcomes)])
        if cell is None:
            raise NotRun(ran.stopped)
        if cell.kind == "own":
            self.own_that_hang.add(cell.name)
            self.without.add(cell.name)
            return
        kind = self._timed_out if ran.stopped == "timed out" else REMARK_OF.get(ran.stopped, "died")
        self._trouble[cell.task] = [Remark(kind, cell.task, seconds=f"{cell_s:g}")]
        self._stopped(cell.task, planned.asked.get(cell.probe or ""))
        self.left = [task for task in self.left if task not in self._set_aside and not self._is_heard(task)]

    def leave_out(self, task: str) -> None:
        """Run a task's answer no more."""
        self.without |= {cell.name for cell in self._transplanted.cells if (cell.kind, cell.task) == ("answer", task)}

    def result(self, notebook_s: float) -> Execution:
        """Return what came out in the end."""
        for task in self.left:  # the time for all was over
            self._set_aside.append(task)
            self._trouble[task] = [Remark(self._timed_out, task, seconds=f"{notebook_s:g}")]
        remarks = [Remark("left out", cell=name.rpartition("+")[0]) for name in sorted(self.own_that_hang)]
        # An answer may have needed an own cell that did not end.
        set_aside = list(self._wanted) if self.own_that_hang else self._set_aside
        later = [task for task in self._outcomes_again if self._was_answered_later(task)]
        remarks += [Remark("elsewhere", task, cell=f"{slug(task)}-answer") for task in later]
        return Execution(
            outcomes=self._outcomes | {task: self._outcomes_again[task] for task in later},
            trouble={task: said for task, said in self._trouble.items() if task not in later},
            set_aside=set_aside,
            remarks=remarks,
            seconds=self.seconds,
        )

    def _hear(self, cell: RunCell, value: Any, trouble: str, asked: Asked | None) -> None:
        """Take in the result of one cell: a probe's outcomes, or an answer's error."""
        if asked is not None and isinstance(value, list) and len(value) == len(asked.places):
            heard = self._outcomes_again if asked.again else self._outcomes
            heard.setdefault(asked.task, {}).update(zip(asked.places, value, strict=True))
        elif trouble.startswith("error: ") and cell.kind == "answer":
            name = trouble.removeprefix("error: ").partition(":")[0]
            self._trouble[cell.task] = [Remark("raised", cell.task, error=safe_error_name(name))]

    def _stopped(self, task: str, asked: Asked | None) -> None:
        """Draw the lesson of a run that stopped in a task: ask its other cases, or set it aside."""
        self._hung[task] += 1
        if self._closely and asked is not None and self._hung[task] < ENOUGH_TO_KNOW:
            left = self.places_left.setdefault(task, self._places(task))
            left -= {*asked.places, *self._outcomes.get(task, {})}
        else:
            self._set_aside.append(task)
            self.leave_out(task)

    def _is_heard(self, task: str) -> bool:
        """Return whether every case that can be asked has answered."""
        return self.places_left.get(task, self._places(task)) <= set(self._outcomes.get(task, ()))

    def _places(self, task: str) -> set[int]:
        return set(range(len(asks_of(self._tasks[task]))))

    def _was_answered_later(self, task: str) -> bool:
        """Return whether there was nothing at the check, and something behind the learner's own cells."""
        return _is_nothing(self._outcomes.get(task, {})) and not _is_nothing(self._outcomes_again[task])


def _to_blame(ran: Sequence[RunCell]) -> RunCell | None:
    """Return the cell that ended a run: the last one, or, if that is ours, the learner's last one before it.

    A patched event loop may give its answer and die a moment later, in whatever runs then.
    """
    return next((cell for cell in reversed(ran) if cell.kind not in OURS), None)


def _is_nothing(outcomes: Mapping[int, Any]) -> bool:
    return all(
        is_unanswered(plain) or (isinstance(plain, dict) and plain.get("raises") == "NameError")
        for plain in outcomes.values()
    )
