"""Define what is passed to and from a grading process, as plain data: submission, cells to run, outcomes.

Job(learner, files, chapters, limits)                       can be done in any process
RunCell("answer", "e3-2-answer", "x = f(2)", "E3.2")        CellOutcome(trouble="error: NameError: ...")
RunCell("probe", "e3-2-check", ..., probe="7f3a")           CellOutcome(value=[[1.0, 2.0, 0.0]])

cells in order  --RunCells-->  Run(outcomes, seconds, why it stopped)
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..kernels.limits import Limits
from ..submissions.remarks import Remark
from .cells import Master, MasterCell

__all__ = ["SEVERAL", "CellOutcome", "HandedIn", "Job", "NotRun", "Run", "RunCell", "RunCells"]


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


SEVERAL = ("answers", "latest", "first")  # which of several notebooks of one chapter counts


@dataclass(frozen=True)
class HandedIn:
    """A notebook as it was handed in: its bytes, or why there are none."""

    name: str
    data: bytes = b""
    fault: Remark | None = None


@dataclass(frozen=True)
class Job:
    """All that is needed to grade one submission.

    Attributes:
        chapters: by stem: "master" (name, source, task, role of each code cell) and "tasks" (as in the cases, with
            this learner's "given" and hidden "cases").
        several: one of SEVERAL.
        only: by stem, the tasks to look at closely, alone; None for a first look at everything.
    """

    learner: str
    name: str
    language: str
    release: str
    version: str
    files: tuple[HandedIn, ...]
    chapters: Mapping[str, Mapping[str, Any]]
    limits: Limits
    remarks: tuple[Remark, ...] = ()
    on_roster: bool = True
    has_roster: bool = False
    several: str = SEVERAL[0]
    only: Mapping[str, Sequence[str]] | None = None

    def masters(self) -> dict[str, Master]:
        """Return the chapters' exercises as they were handed out."""
        cells = {stem: chapter["master"] for stem, chapter in self.chapters.items()}
        return {stem: Master(stem, tuple(MasterCell(*cell) for cell in rows)) for stem, rows in cells.items()}
