"""Run nodes on real (wall) time, for scripts and `tflab run`.

Threads run in parallel.  The other driver, for pages, is
`virtual.py`; both have the same methods.
"""

from __future__ import annotations

import contextlib
import queue
import threading
import time
from collections.abc import Callable

from tflab.core import NSEC_PER_SEC

__all__ = ["WallTime"]

# Some systems do not see Ctrl-C while a thread waits, so nobody waits for longer than this at a time.
LONGEST_WAIT_S = 0.5

# Windows sets these clocks on every 15.6 ms before Python 3.13: a faster node would repeat its stamps.
IS_COARSE = time.get_clock_info("time").resolution > 1e-3
STARTED_NS = time.time_ns() - time.perf_counter_ns()


class WallWaiter:
    """A thread that waits, and can be woken, also by a signal handler that runs in that thread.

    An Event would not do: its set() in a signal handler blocks for ever if the handler interrupts its wait().
    """

    def __init__(self) -> None:
        self._wakes: queue.SimpleQueue[None] = queue.SimpleQueue()

    def wake(self) -> None:
        """End the present wait, or the next one."""
        if self._wakes.empty():
            self._wakes.put(None)

    def wait(self, duration_ns: int | None) -> None:
        """Block until woken, or for `duration_ns` [ns]."""
        until_s = None if duration_ns is None else time.perf_counter() + duration_ns / NSEC_PER_SEC
        while self._wakes.empty():
            left_s = LONGEST_WAIT_S if until_s is None else until_s - time.perf_counter()
            if left_s <= 0.0:
                return
            with contextlib.suppress(queue.Empty):
                self._wakes.get(timeout=min(left_s, LONGEST_WAIT_S))
                break
        while not self._wakes.empty():
            self._wakes.get()


class WallTime:
    """The machine's own clocks."""

    is_virtual = False
    poll_ns = 0  # what an unsuccessful poll costs besides the time it takes

    def now_ns(self) -> int:
        """Return the time since 1970 [ns]."""
        return STARTED_NS + time.perf_counter_ns() if IS_COARSE else time.time_ns()

    def steady_ns(self) -> int:
        """Return a time that is never set back [ns]."""
        return time.perf_counter_ns()

    def new_waiter(self) -> WallWaiter:
        """Return something to wait on."""
        return WallWaiter()

    def wait(self, waiter: WallWaiter, duration_ns: int | None) -> None:
        """Block until woken, or for `duration_ns` [ns]."""
        waiter.wait(duration_ns)

    def call_after(self, delay_ns: int, action: Callable[[], None]) -> None:
        """Have `action` called in `delay_ns` [ns], from another thread."""
        timer = threading.Timer(delay_ns / NSEC_PER_SEC, action)
        timer.daemon = True
        timer.start()

    def enter_callback(self) -> None:
        """Note that a callback begins; nothing depends on it in real time."""

    def leave_callback(self) -> None:
        """Note that it has ended."""

    def spinning(self) -> contextlib.AbstractContextManager:
        """Mark that something spins without end; nothing depends on it in real time."""
        return contextlib.nullcontext()

    def is_cooperative(self) -> bool:
        """Return whether this thread waits for its turn; nobody does in real time."""
        return False
