"""Call a learner's functions within limits: of time and of memory, without prompts, with what they print held back.

with call_limits() as printed:
    outcome = outcome_of(function, args)     TimeLimitError after `CALL_S`, MemoryError beyond `MEMORY_BYTES`
printed.lines                                how many lines were printed
"""

from __future__ import annotations

import builtins
import random
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout
from io import TextIOBase
from pathlib import Path
from types import FrameType

try:
    import resource
except ModuleNotFoundError:  # Windows
    resource = None

from .answers.values import outcomes_of

__all__ = ["CALL_S", "PrintedLines", "TimeLimitError", "call_limits"]

CALL_S = 5.0  # of one call
AGAIN_S = 0.1
SOON_S = (2e-6, 1e-5)
MEMORY_BYTES = 1 << 30  # more than there was before


class TimeLimitError(BaseException):
    """A call has run for `CALL_S`; no Exception, because a learner's function may catch those."""


class PrintedLines(TextIOBase):
    """Count the lines that are printed, and drop them."""

    lines = 0

    def write(self, text: str) -> int:
        """Count the lines of a text."""
        self.lines += text.count("\n")
        return len(text)


@contextmanager
def call_limits(seconds: float) -> Iterator[PrintedLines]:
    """Bound time and memory of what is called inside, refuse `input()`, and count printed lines.

    Time is bounded in the main thread alone, and where signals have a timer; memory where the system bounds it.

    Raises:
        TimeLimitError: the time is over.
    """
    printed, prompt = PrintedLines(), builtins.input
    builtins.input = _refuse_input
    try:
        with redirect_stdout(printed), _memory_limit(), _time_limit(seconds):
            yield printed
    finally:
        builtins.input = prompt


def _refuse_input(prompt: object = "") -> str:
    raise EOFError("input() cannot be used here: the function gets what it needs as arguments")


@contextmanager
def _time_limit(seconds: float) -> Iterator[None]:
    if threading.current_thread() is not threading.main_thread() or not hasattr(signal, "setitimer"):
        yield
        return
    before = signal.signal(signal.SIGALRM, _Alarm().stop)
    signal.setitimer(signal.ITIMER_REAL, seconds, AGAIN_S)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        if before is not signal.SIG_DFL:  # a last alarm may still be on its way, and the default ends the process
            signal.signal(signal.SIGALRM, before)


class _Alarm:
    """Stop a call when its time is over, again and again while a bare `except` in it catches that."""

    caught = 0

    def stop(self, _number: int, frame: FrameType | None) -> None:
        """Raise TimeLimitError, unless the call has ended."""
        if not _is_called_by_us(frame):
            return
        self.caught += 1
        if self.caught > 1:  # one of these alarms comes between two rounds of the loop, outside its `try`
            signal.setitimer(signal.ITIMER_REAL, random.uniform(*SOON_S), AGAIN_S)
        raise TimeLimitError


def _is_called_by_us(frame: FrameType | None) -> bool:
    """Return whether a frame is of what `outcomes_of` called, and not of itself or of one further out."""
    while frame is not None and frame.f_back is not None:
        frame = frame.f_back
        if frame.f_code is outcomes_of.__code__:
            return True
    return False


@contextmanager
def _memory_limit() -> Iterator[None]:
    used = _address_space()
    if used is None:
        yield
        return
    before, hard = resource.getrlimit(resource.RLIMIT_AS)
    most = used + MEMORY_BYTES
    if before == resource.RLIM_INFINITY or most < before:
        resource.setrlimit(resource.RLIMIT_AS, (most, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, (before, hard))


def _address_space() -> int | None:
    """Return how much address space this process has now [bytes]; None where the system does not say."""
    if resource is None:
        return None
    try:
        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
    except OSError:
        return None
    return pages * resource.getpagesize()
