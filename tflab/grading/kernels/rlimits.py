"""Apply the limits that the operating system enforces (`setrlimit`), to a process and all that it starts.

The grader's clock and the supervisor's look at memory come first; this is a second net below
them.  `setrlimit(2)` says more.
"""

from __future__ import annotations

import contextlib
import os
import resource
from pathlib import Path

from .limits import MIB, Limits

__all__ = ["apply"]


def apply(limits: Limits, others: int = 0) -> None:
    """Limit this process and those it will start, for good.

    Args:
        others: processes and threads that this user has already: the system counts them, too.
    """
    cpu_s = int(limits.notebook_s) + 5  # above the grader's clock
    hard = {
        resource.RLIMIT_AS: virtual_memory() + 2 * limits.memory_bytes,
        resource.RLIMIT_CPU: cpu_s,
        resource.RLIMIT_FSIZE: limits.file_bytes,
        resource.RLIMIT_NOFILE: 256,
        resource.RLIMIT_NPROC: limits.processes + others,
        resource.RLIMIT_CORE: 0,
        resource.RLIMIT_MSGQUEUE: 0,
        resource.RLIMIT_MEMLOCK: MIB,
    }
    for limit, value in hard.items():
        _, most = resource.getrlimit(limit)
        value = value if most == resource.RLIM_INFINITY else min(value, most)
        resource.setrlimit(limit, (value, value))


def tasks_of(uid: int) -> int:
    """Return how many processes and threads a user has."""
    count = 0
    for process in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            if process.stat().st_uid == uid:
                count += len(os.listdir(process / "task"))
    return count


def virtual_memory() -> int:
    """Return the size of this process's address space [bytes]."""
    with open("/proc/self/statm", encoding="ascii") as statm:
        return int(statm.read().split()[0]) * resource.getpagesize()
