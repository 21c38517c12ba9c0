"""How far is it?  One line on a terminal that is written over; elsewhere nothing but the end.

    graded  [=============>        ]  131/200   0:41 left   s131

Read `submissions/` next.
"""

from __future__ import annotations

import sys
import time
from typing import TextIO

__all__ = ["ProgressBar"]

WIDTH = 24
SECONDS_BETWEEN = 0.1


class ProgressBar:
    """A bar for `total` steps; quiet if it is asked to be, or if nobody is looking."""

    def __init__(self, total: int, what: str, *, quiet: bool = False, stream: TextIO | None = None) -> None:
        self.total, self.what, self.done = total, what, 0
        self._stream = stream or sys.stderr
        self._shown = not quiet and self._stream.isatty()
        self._began = self._last = time.monotonic()

    def step(self, name: str = "") -> None:
        """One more is done."""
        self.done += 1
        now = time.monotonic()
        if self._shown and (now - self._last > SECONDS_BETWEEN or self.done == self.total):
            self._last = now
            self._stream.write(f"\r\x1b[K{self.line(name, now - self._began)}")
            self._stream.flush()

    def line(self, name: str, seconds: float) -> str:
        """Return the line as it stands after so many seconds."""
        share = self.done / self.total if self.total else 1.0
        bar = "=" * round(share * WIDTH)
        left = int(seconds / self.done * (self.total - self.done)) if self.done else 0
        clean = "".join(letter for letter in name if letter.isprintable())[:24]
        return f"{self.what}  [{bar:<{WIDTH}}]  {self.done}/{self.total}   {left // 60}:{left % 60:02d} left   {clean}"

    def close(self) -> None:
        """Leave the line."""
        if self._shown and self.done:
            self._stream.write("\n")
            self._stream.flush()
