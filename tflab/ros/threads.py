"""How does code that knows nothing of us get along?  Three calls of Python's, replaced (monkey patches).

    time.sleep(s)        inside a participant: lets the graph's time pass, and hears Ctrl-C
    Thread(...).start()  the new thread belongs to the starter's process
    thread.join()        lets the graph's time pass

Everybody else gets Python's own.  Put in place with the first graph, taken away
by `deactivate()`.
"""

from __future__ import annotations

import threading
import time

from tflab.core import NSEC_PER_SEC

from .process import process_here

__all__ = ["install", "uninstall"]

_sleep, _start, _join = time.sleep, threading.Thread.start, threading.Thread.join


def install() -> None:
    """Put the three calls in place."""
    time.sleep = sleep
    threading.Thread.start = start
    threading.Thread.join = join


def uninstall() -> None:
    """Give Python its own calls back."""
    time.sleep = _sleep
    threading.Thread.start = _start
    threading.Thread.join = _join


def sleep(seconds: float) -> None:
    """Sleep [s], on the time of whoever calls."""
    process = process_here()
    if process is None or not (process.driver.is_cooperative() or process.main_thread is threading.current_thread()):
        _sleep(seconds)
        return
    if seconds < 0:
        raise ValueError("sleep length must be non-negative")
    process.sleep(round(seconds * NSEC_PER_SEC))


def start(thread: threading.Thread) -> None:
    """Start a thread in the process of whoever calls."""
    process = process_here()
    if process is not None and not hasattr(thread, "tflab_process"):
        thread.tflab_process = process
        if process.driver.is_virtual and (process.driver.is_cooperative() or _spins(thread)):
            process.driver.adopt(thread, process)
    _start(thread)


def join(thread: threading.Thread, timeout: float | None = None) -> None:
    """Wait for a thread, on the time of whoever calls."""
    strand = getattr(thread, "tflab_strand", None)
    if strand is not None and not strand.is_finished:
        strand.process.driver.join(strand, None if timeout is None else round(timeout * NSEC_PER_SEC))
        if not strand.is_finished:
            return  # the timeout is over, in the graph's time
    _join(thread, timeout)


def _spins(thread: threading.Thread) -> bool:
    """Return whether a thread was made to run one of our functions, such as rclpy.spin."""
    target = getattr(thread, "_target", None)
    return (getattr(target, "__module__", None) or "").startswith("tflab.ros")
