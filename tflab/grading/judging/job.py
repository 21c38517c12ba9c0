"""What is there to grade?  A job for each submission: plain data that holds all that is needed.

Job(learner, files, chapters, limits)     can be done in any process, here or elsewhere
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..kernels.limits import Limits
from ..submissions.remarks import Remark
from .cells import Master, MasterCell

__all__ = ["SEVERAL", "HandedIn", "Job"]

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
