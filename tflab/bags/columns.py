"""Where do a million transforms go while they are read?  Into columns that grow, and the largest onto the disk.

    stamps, times of receipt, labels    in memory, 24 bytes a transform
    x y z qx qy qz qw                   in memory up to a few million, then in a file without a name

So hours of a robot fit into the memory of a laptop (out of core, memory mapped).
"""

from __future__ import annotations

from array import array
from tempfile import TemporaryFile
from typing import IO

import numpy as np

from .messages import NUMBERS_SIZE, RawTransform
from .recording import Headers, TransformLabel, Transforms

__all__ = ["HeaderColumns", "TransformColumns"]

MOST_IN_MEMORY = 128 * 2**20  # bytes of numbers, about two million transforms


class TransformColumns:
    """Transforms, as many as there are, in growing columns; of a long recording the numbers lie on disk."""

    def __init__(self) -> None:
        self._receive_ns, self._stamp_ns = array("q"), array("q")
        self._message, self._label = array("i"), array("i")
        self._numbers = bytearray()
        self._on_disk: IO[bytes] | None = None
        self._labels: dict[tuple, int] = {}
        self._messages = 0

    def add(self, how: tuple[str, str, bool], receive_ns: int, transforms: list[RawTransform]) -> None:
        """Take the transforms of one message; `how` is topic, publisher, is_static."""
        for stamp_ns, parent, child, numbers in transforms:
            key = (how, parent, child)
            label = self._labels.setdefault(key, len(self._labels))
            self._append(label, receive_ns, stamp_ns, numbers)
        self._messages += 1

    def add_one(self, label: int, receive_ns: int, stamp_ns: int, numbers: bytes) -> None:
        """Take the one transform of a message whose label is known."""
        self._append(label, receive_ns, stamp_ns, numbers)
        self._messages += 1

    @property
    def newest_label(self) -> int:
        return self._label[-1]

    def ends_with(self, data: bytes) -> bool:
        """Return whether the numbers that came last are the last bytes of `data`."""
        return bool(self._numbers) and data.endswith(bytes(self._numbers[-NUMBERS_SIZE:]))

    def _append(self, label: int, receive_ns: int, stamp_ns: int, numbers: bytes) -> None:
        self._stamp_ns.append(stamp_ns)
        self._label.append(label)
        self._numbers += numbers
        if len(self._numbers) >= MOST_IN_MEMORY:
            self._to_disk()
        self._receive_ns.append(receive_ns)
        self._message.append(self._messages)

    def _to_disk(self) -> None:
        """Move the numbers into a file without a name, but for the newest; it is gone when nobody holds it any more."""
        if self._on_disk is None:
            self._on_disk = TemporaryFile()  # noqa: SIM115
        self._on_disk.write(memoryview(self._numbers)[:-NUMBERS_SIZE])
        self._numbers = self._numbers[-NUMBERS_SIZE:]

    def _all_numbers(self) -> np.ndarray:
        if self._on_disk is None:
            return np.frombuffer(self._numbers, dtype="<f8").reshape(-1, 7)
        self._on_disk.write(self._numbers)
        self._on_disk.flush()
        return np.memmap(self._on_disk, dtype="<f8", mode="r", shape=(len(self._stamp_ns), 7))

    def table(self) -> Transforms:
        columns = (self._receive_ns, self._stamp_ns, self._message, self._label)
        return Transforms(
            *(np.frombuffer(column, dtype=np.dtype(column.typecode)) for column in columns),
            self._all_numbers(),
            tuple(
                TransformLabel(topic, publisher, _text(parent), _text(child), is_static)
                for (topic, publisher, is_static), parent, child in self._labels
            ),
        )


class HeaderColumns:
    """The headers of one topic, in growing columns."""

    def __init__(self, msgtype: str) -> None:
        self._msgtype = msgtype
        self._receive_ns, self._stamp_ns, self._frame = array("q"), array("q"), array("q")
        self._frames: dict[bytes, int] = {}

    def add(self, receive_ns: int, stamp_ns: int, frame: bytes) -> None:
        self._stamp_ns.append(stamp_ns)
        self._receive_ns.append(receive_ns)
        self._frame.append(self._frames.setdefault(frame, len(self._frames)))

    def table(self, topic: str) -> Headers:
        columns = (np.frombuffer(c, dtype=np.int64) for c in (self._receive_ns, self._stamp_ns, self._frame))
        return Headers(topic, self._msgtype, *columns, tuple(map(_text, self._frames)))


def _text(name: bytes) -> str:
    return name.decode("utf-8", errors="replace")
