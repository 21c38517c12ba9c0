"""How far along is it?  One line on the terminal that rewrites itself.

    reading drive.mcap  [##########..........]  52%

Only where somebody is watching: into a file or a pipe nothing is written, and
nothing that is compared depends on it.  Read `wire.py` next.
"""

from __future__ import annotations

import sys
import time
from typing import TextIO

__all__ = ["Progress"]

WIDTH = 30
REDRAW_EVERY_S = 0.1


class Progress:
    """A bar for work of a known size; use it in a `with` block, so that the line is cleared however it ends."""

    def __init__(self, label: str, total: int, stream: TextIO | None = None) -> None:
        self._label = label
        self._total = max(total, 1)
        self._stream = sys.stderr if stream is None else stream
        self._watched = self._stream.isatty()
        self._next_s = time.monotonic() + REDRAW_EVERY_S  # short work shows nothing
        self._drawn = False

    def __enter__(self) -> Progress:
        return self

    def __exit__(self, *_: object) -> None:
        if self._drawn:
            self._stream.write("\r\x1b[K")
            self._stream.flush()

    def at(self, done: int) -> None:
        """Say how much is done."""
        if not self._watched or time.monotonic() < self._next_s:
            return
        self._next_s = time.monotonic() + REDRAW_EVERY_S
        part = min(done / self._total, 1.0)
        full = round(WIDTH * part)
        self._stream.write(f"\r{self._label}  [{'#' * full}{'.' * (WIDTH - full)}] {part:4.0%}")
        self._stream.flush()
        self._drawn = True
