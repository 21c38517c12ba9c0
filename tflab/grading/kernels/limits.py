"""Set how much a submission may use: time, memory, output, processes, files.

    Limits()                  what a course's answers need, many times over
    Limits().times(3)         the second chance after a deadline: three times the time

Time is enforced by the grader, by its own clock; memory by the supervisor of the kernel, which
looks at all its processes together; the rest by the kernel of the operating system.
Where there is no wall (`tflab check` on another system) only the time is limited.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace

__all__ = ["Limits"]

MIB = 1 << 20


@dataclass(frozen=True)
class Limits:
    """What one run of a notebook may take."""

    cell_s: float = 5.0  # wall clock, each cell; the slowest of a course takes a fifth of a second
    notebook_s: float = 30.0  # wall clock, all cells together
    memory_bytes: int = 1024 * MIB  # all processes of the run together
    output_bytes: int = 4 * MIB  # of one cell, on the way to the grader
    messages: int = 1000  # of one cell
    processes: int = 64  # threads count
    file_bytes: int = 64 * MIB  # all files together

    def __post_init__(self) -> None:
        for name, value in asdict(self).items():
            if not value > 0:
                raise ValueError(f"Limits.{name} is {value}; it has to be more than 0")

    def times(self, factor: float) -> Limits:
        """Return the same limits with `factor` times the time."""
        return replace(self, cell_s=self.cell_s * factor, notebook_s=self.notebook_s * factor)
