"""How far is it?  One line on a terminal that is written over; into a file or a pipe nothing is written.

    graded  [=============>        ]  131/200   0:41 left   s131

Short work shows nothing, and nothing that is compared depends on it.
"""

from __future__ import annotations

import sys
import time
from typing import TextIO

__all__ = ["ProgressBar"]

WIDTH = 24
SECONDS_BETWEEN = 0.1


class ProgressBar:
    """A bar for `total` steps; use it in a `with` block, so that the line is cleared however it ends."""

    def __init__(self, total: int, what: str, *, quiet: bool = False, stream: TextIO | None = None) -> None:
        self.total, self.what, self.done = total, what, 0
        self._stream = stream or sys.stderr
        self._watched = not quiet and self._stream.isatty()
        self._began = self._last = time.monotonic()
        self._drawn = False

    def __enter__(self) -> ProgressBar:
        return self

    def __exit__(self, *_: object) -> None:
        if self._drawn:
            self._stream.write("\r\x1b[K")
            self._stream.flush()

    def step(self, name: str = "") -> None:
        """One more is done."""
        self.at(self.done + 1, name)

    def at(self, done: int, name: str = "") -> None:
        """Say how much is done."""
        self.done = done
        now = time.monotonic()
        if not self._watched or now - self._last < SECONDS_BETWEEN:
            return
        self._last = now
        self._stream.write(f"\r\x1b[K{self.line(name, now - self._began)}")
        self._stream.flush()
        self._drawn = True

    def line(self, name: str, seconds: float) -> str:
        """Return the line as it stands after so many seconds."""
        share = min(self.done / self.total, 1.0) if self.total else 1.0
        bar = "=" * round(share * WIDTH)
        left = int(seconds / self.done * (self.total - self.done)) if self.done else 0
        clean = "".join(letter for letter in name if letter.isprintable())[:24]
        return f"{self.what}  [{bar:<{WIDTH}}]  {self.done}/{self.total}   {left // 60}:{left % 60:02d} left   {clean}"
