"""What runs, and what comes of it?  A cell on its way from the notebook to a kernel, its outcome on the way back.

    RunCell("answer", "e3-2-answer", "x = f(2)", "E3.2")        CellOutcome(trouble="error: NameError: ...")
    RunCell("probe", "e3-2-check", ..., probe="7f3a")           CellOutcome(value=[[1.0, 2.0, 0.0]])

    cells in order  --run-->  Run(outcomes, seconds, why it stopped)

A transplant says which cells there are; a plan fills in what its probes ask; what
runs them, behind a wall or not, hands back a Run.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from ..kernels.limits import Limits

__all__ = ["CellOutcome", "NotRun", "Run", "RunCell", "RunCells"]


class NotRun(Exception):
    """The kernel did not even run our own cells: no fault of the learner's."""


@dataclass(frozen=True, slots=True)
class RunCell:
    """One thing to run, or the place of a probe.

    Attributes:
        kind: "ours", "own" (the learner's helper cell), "answer", "stub" (an answer cell left as it was), or "probe".
        name: the cell's name; an own cell has one of ours with a number.
        probe: of a probe that is planned, the id of the one message that it sends.
        shared: cells with the same word take the time of one cell together, ...
        part: ... and of that no more than this.
    """

    kind: str
    name: str
    source: str = ""
    task: str = ""
    probe: str | None = None
    shared: str = ""
    part: float = 1.0


@dataclass(frozen=True, slots=True)
class CellOutcome:
    """The result of one cell: of a probe a value, plain JSON from a hostile place; of any, what went wrong."""

    value: Any = None
    trouble: str | None = None


@dataclass(frozen=True, slots=True)
class Run:
    """The results of all cells, as far as they ran."""

    outcomes: Sequence[CellOutcome]
    seconds: float
    stopped: str | None = None  # why the last cell of `outcomes` was the last one


RunCells = Callable[[Sequence[RunCell], Limits], Run]
