"""Look up transforms at many stamps at once.

    stamps_ns   [ t0   t1   t2  ... ]      one lookup each
    result      [ translations, rotations ]; failed rows are NaN, with their exceptions

Lookups run in blocks that fit the processor's cache, each block in the order of time,
because a search that moves forward is several times faster than random access. Small
batches, and frames that changed their parents, are looked up one by one.

This module does not hold a buffer. It gets `ask(stamp_ns)`, the single lookup between
the two frames, for what columns cannot compute. tf2 has no counterpart. (Batch
processing; cache blocking.)
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from .columns import Tables, canonical_signs, history_reader, integer_stamps, poses_along_route
from .errors import ExtrapolationException, TransformException
from .failures import extrapolation_text
from .routes import Route
from .stamps import LATEST
from .transforms import StampedTransform

__all__ = ["Batch", "Failures", "lookup"]

BLOCK = 4096  # questions at a time
FEWEST = 16  # below this, asking one by one is faster

Ask = Callable[[int], StampedTransform]


class Failures(Mapping[int, TransformException]):
    """Which questions of a batch have no answer, and why: position -> exception.

    The exceptions are made when they are looked at.
    """

    def __init__(
        self, positions: np.ndarray, stamps_ns: np.ndarray, kinds: np.ndarray, examples: list[TransformException]
    ) -> None:
        self.positions = positions  # shape (M,), ascending
        self._stamps_ns = stamps_ns
        self._kinds = kinds  # which example each of them is like
        self._examples = examples

    def __len__(self) -> int:
        return len(self.positions)

    def __iter__(self) -> Iterator[int]:
        return iter(self.positions.tolist())

    def __getitem__(self, position: int) -> TransformException:
        i = int(np.searchsorted(self.positions, position))
        if i == len(self.positions) or self.positions[i] != position:
            raise KeyError(position)
        example: TransformException = self._examples[int(self._kinds[i])]
        if not isinstance(example, ExtrapolationException):
            return example
        requested_ns = int(self._stamps_ns[i])
        asked = (example.target_frame, example.source_frame)
        return ExtrapolationException(
            extrapolation_text(example.direction, requested_ns, example.bound_ns, *asked),
            **{**vars(example), "requested_ns": requested_ns},
        )


class Batch(NamedTuple):
    """Answers to N questions.

    Attributes:
        translations: shape (N, 3) [m].
        rotations: shape (N, 4), (x, y, z, w).
        failures: position -> exception, for the rows that are NaN.
    """

    translations: np.ndarray
    rotations: np.ndarray
    failures: Failures

    @property
    def ok(self) -> np.ndarray:
        """Which rows hold an answer: shape (N,), bool."""
        ok = np.ones(len(self.translations), dtype=bool)
        ok[self.failures.positions] = False
        return ok


def lookup(
    ask: Ask,
    history_ends: Callable[[], np.ndarray],
    tables: Tables,
    route: Route | None,
    stamps_ns: Sequence[int] | np.ndarray,
) -> Batch:
    """Return the answers of BufferCore.lookup_transforms; the buffer is locked."""
    moments = integer_stamps(stamps_ns)
    if route is not None and (moments == LATEST).any():
        moments = np.where(moments == LATEST, route.latest_common_time(), moments)
    if route is None or len(moments) < FEWEST or (route.moving and (moments == LATEST).any()):
        return _one_by_one(ask, integer_stamps(stamps_ns))
    return _in_columns(ask, history_ends, tables, route, moments)


def _one_by_one(ask: Ask, stamps: np.ndarray) -> Batch:
    """Answer few questions, or questions about frames that changed their parents."""
    numbers = np.full((len(stamps), 7), np.nan)
    positions: list[int] = []
    examples: list[TransformException] = []
    for position, stamp_ns in enumerate(stamps.tolist()):
        try:
            transform = ask(stamp_ns).transform
        except TransformException as failure:
            positions.append(position)
            examples.append(failure)
        else:
            numbers[position] = transform.translation + transform.rotation
    requested = [getattr(example, "requested_ns", LATEST) for example in examples]
    failures = Failures(
        np.array(positions, dtype=np.int64), np.array(requested, dtype=np.int64), np.arange(len(examples)), examples
    )
    return Batch(numbers[:, :3], numbers[:, 3:], failures)


def _in_columns(
    ask: Ask, history_ends: Callable[[], np.ndarray], tables: Tables, route: Route, moments: np.ndarray
) -> Batch:
    """Answer many questions along a route whose shape does not change."""
    numbers = np.empty((7, len(moments)))
    outside = np.zeros(0, dtype=np.int64)
    if not route.moving:
        numbers[:] = np.reshape(route.pose_at(LATEST), (7, 1))
    else:
        begin = max(cache.oldest_ns for cache in route.moving)
        end = min(cache.newest_ns for cache in route.moving)
        outside = np.flatnonzero((moments < begin) | (moments > end))
        if begin <= end:
            within = np.clip(moments, begin, end) if len(outside) else moments
            _fill(numbers, tables, route, within)
        numbers[:, outside] = np.nan
    failures = _explained(ask, history_ends, outside, moments[outside])
    return Batch(numbers[:3].T, numbers[3:].T, failures)


def _fill(numbers: np.ndarray, tables: Tables, route: Route, moments: np.ndarray) -> None:
    """Write the poses at moments that every history reaches into `numbers`, shape (7, N), block by block."""
    readers = {cache: history_reader(tables, cache, len(moments)) for cache in route.up + route.down}
    for start in range(0, len(moments), BLOCK):
        block = moments[start : start + BLOCK]
        place: slice | np.ndarray = slice(start, start + len(block))
        if (block[1:] < block[:-1]).any():
            order = np.argsort(block)
            block, place = block[order], start + order
        *position, qx, qy, qz, qw = poses_along_route(route, readers, block)
        sign = canonical_signs((qx, qy, qz, qw))
        for row, column in zip(numbers, (*position, qx * sign, qy * sign, qz * sign, qw * sign), strict=True):
            row[place] = column


def _explained(
    ask: Ask, history_ends: Callable[[], np.ndarray], positions: np.ndarray, moments: np.ndarray
) -> Failures:
    """Ask once for each kind of failure: between two ends of histories all moments fail alike.

    A moment's kind is how many ends lie before it, and how many before or at it:
    different at an end, before and after it.
    """
    if not len(positions):
        return Failures(positions, moments, positions, [])
    ends = history_ends()
    kinds = np.searchsorted(ends, moments, side="left") + np.searchsorted(ends, moments, side="right")
    _, first, kinds = np.unique(kinds, return_index=True, return_inverse=True)
    examples = []
    for stamp_ns in moments[first].tolist():
        try:
            ask(stamp_ns)
        except TransformException as failure:
            examples.append(failure)
    return Failures(positions, moments, kinds, examples)
