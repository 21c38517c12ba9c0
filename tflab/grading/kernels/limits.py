"""How much may one submission take?  Time, memory, output, processes, files.

    Limits()                  what a course's answers need, many times over
    Limits().times(3)         the second chance after a deadline: three times the time

Time is enforced by the grader, by its own clock; memory by the keeper of the kernel, which
looks at all its processes together; the rest by the kernel of the operating system
(`setrlimit`), as a second net also for time and memory.

Read `sandbox.py` next.
"""

from __future__ import annotations

import resource
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

    def apply(self) -> None:
        """Limit this process and those it will start, for good."""
        cpu_s = int(self.notebook_s) + 5  # a second net below the grader's clock
        hard = {
            resource.RLIMIT_AS: virtual_memory() + 2 * self.memory_bytes,
            resource.RLIMIT_CPU: cpu_s,
            resource.RLIMIT_FSIZE: self.file_bytes,
            resource.RLIMIT_NOFILE: 256,
            resource.RLIMIT_NPROC: self.processes,
            resource.RLIMIT_CORE: 0,
            resource.RLIMIT_MSGQUEUE: 0,
            resource.RLIMIT_MEMLOCK: MIB,
        }
        for limit, value in hard.items():
            _, most = resource.getrlimit(limit)
            value = value if most == resource.RLIM_INFINITY else min(value, most)
            resource.setrlimit(limit, (value, value))


def virtual_memory() -> int:
    """Return the size of this process's address space [bytes]."""
    with open("/proc/self/statm", encoding="ascii") as statm:
        return int(statm.read().split()[0]) * resource.getpagesize()
