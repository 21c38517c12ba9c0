"""A hundred thousand questions at once: the same lookup, in columns.

    stamps_ns   [ t0   t1   t2  ... ]            one question each
                  |    |    |
                  v    v    v                    which segment of the history?  (search)
    table       [ x  dx  q  ...     ]  per edge  what is needed of it           (take)
                  |    |    |
                  v    v    v                    along the route, edge by edge  (arithmetic)
    answer      [ translations, rotations ]      and, for the rest, why not

The arithmetic is that of `cache.py` and `transforms.py`, with a column of numbers
where they have one.  Questions are answered in blocks that fit the processor's
cache, each block in the order of time, because a search that walks forward is
several times faster than one that jumps.

tf2 has nothing of the kind.  Read `inspection.py` next.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from . import quaternions
from .cache import TimeCache
from .checks import are_ordinary_names
from .errors import ExtrapolationException, TransformException
from .stamps import LATEST
from .transforms import A_BIT, HALF_AND_A_BIT, canonical_pose, compose, invert
from .walk import Route, extrapolation_text

if TYPE_CHECKING:
    from .buffer import BufferCore

__all__ = ["Batch", "Failures", "Tables", "columns_from_arrays", "is_plain", "lookup"]

BLOCK = 4096  # questions at a time
FEWEST = 16  # below this, asking one by one is faster
TABLE_BYTES_AT_MOST = 256 * 2**20


class Failures(Mapping[int, TransformException]):
    """Which questions of a batch have no answer, and why: position -> exception.

    The exceptions are made when they are looked at.
    """

    def __init__(self, positions: np.ndarray, stamps_ns: np.ndarray, kinds: np.ndarray, examples: list) -> None:
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
        example = self._examples[self._kinds[i]]
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


class Tables:
    """A table of segments for each history that was asked many questions, until it changes."""

    def __init__(self) -> None:
        self._tables: dict[TimeCache, tuple[tuple[int, int], np.ndarray, np.ndarray]] = {}

    @property
    def nbytes(self) -> int:
        return sum(stamps.nbytes + table.nbytes for _, stamps, table in self._tables.values())

    def clear(self) -> None:
        self._tables.clear()

    def of(self, cache: TimeCache) -> tuple[np.ndarray, np.ndarray]:
        """Return the stamps of a history, shape (n,), and its table, shape (16, n)."""
        version, stamps, table = self._tables.get(cache, (None, None, None))
        if version != cache.version:
            stamps, table = segment_table(cache)
            if self.nbytes + table.nbytes > TABLE_BYTES_AT_MOST:
                self._tables.clear()
            self._tables[cache] = (cache.version, stamps, table)
        return stamps, table


def lookup(
    buffer: BufferCore,
    tables: Tables,
    route: Route | None,
    target_frame: str,
    source_frame: str,
    stamps_ns: Sequence[int] | np.ndarray,
    raise_on_failure: bool,
) -> Batch:
    """Return the answers of BufferCore.lookup_transforms; the buffer is locked."""
    stamps = integer_stamps(stamps_ns)
    moments = stamps
    if route is not None and (stamps == LATEST).any():
        moments = np.where(stamps == LATEST, route.latest_common_time(), stamps)
    if route is None or len(stamps) < FEWEST or (route.moving and (moments == LATEST).any()):
        batch = _one_by_one(buffer, target_frame, source_frame, stamps)
    else:
        batch = _in_columns(buffer, tables, route, target_frame, source_frame, moments)
    if raise_on_failure and len(batch.failures):
        raise batch.failures[int(batch.failures.positions[0])]
    return batch


def _one_by_one(buffer: BufferCore, target_frame: str, source_frame: str, stamps: np.ndarray) -> Batch:
    """Answer few questions, or questions about frames that changed their parents."""
    numbers = np.full((len(stamps), 7), np.nan)
    positions, examples = [], []
    for position, stamp_ns in enumerate(stamps.tolist()):
        try:
            transform = buffer.lookup_transform(target_frame, source_frame, stamp_ns).transform
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
    buffer: BufferCore, tables: Tables, route: Route, target_frame: str, source_frame: str, moments: np.ndarray
) -> Batch:
    """Answer many questions along a route whose shape does not change."""
    numbers = np.empty((7, len(moments)))
    outside = np.zeros(0, dtype=np.int64)
    if not route.moving:
        numbers[:] = np.reshape(canonical_pose(route.pose_at(LATEST)), (7, 1))
    else:
        begin = max(cache.oldest_ns for cache in route.moving)
        end = min(cache.newest_ns for cache in route.moving)
        outside = np.flatnonzero((moments < begin) | (moments > end))
        if begin <= end:
            within = np.clip(moments, begin, end) if len(outside) else moments
            _fill(numbers, tables, route, within)
        numbers[:, outside] = np.nan
    failures = _explained(buffer, target_frame, source_frame, outside, moments[outside])
    return Batch(numbers[:3].T, numbers[3:].T, failures)


def _fill(numbers: np.ndarray, tables: Tables, route: Route, moments: np.ndarray) -> None:
    """Write the poses at moments that every history reaches into `numbers`, shape (7, N), block by block."""
    readers = {cache: _reader(tables, cache, len(moments)) for cache in route.up + route.down}
    for start in range(0, len(moments), BLOCK):
        block = moments[start : start + BLOCK]
        place: slice | np.ndarray = slice(start, start + len(block))
        if (block[1:] < block[:-1]).any():
            order = np.argsort(block)
            block, place = block[order], start + order
        *position, qx, qy, qz, qw = _along(route, readers, block)
        signs = _signs((qx, qy, qz, qw))
        for row, column in zip(numbers, (*position, qx * signs, qy * signs, qz * signs, qw * signs), strict=True):
            row[place] = column


def _explained(
    buffer: BufferCore, target_frame: str, source_frame: str, positions: np.ndarray, moments: np.ndarray
) -> Failures:
    """Ask once for each kind of failure: between two ends of histories all moments fail alike."""
    ends = buffer.history_ends()
    kinds = np.searchsorted(ends, moments, side="left") + np.searchsorted(ends, moments, side="right")
    _, first, kinds = np.unique(kinds, return_index=True, return_inverse=True)
    examples = []
    for stamp_ns in moments[first].tolist():
        try:
            buffer.lookup_transform(target_frame, source_frame, stamp_ns)
        except TransformException as failure:
            examples.append(failure)
    return Failures(positions, moments, kinds, examples)


# -- arithmetic in columns: a pose is seven arrays of shape (n,) --------------


def segment_table(cache: TimeCache) -> tuple[np.ndarray, np.ndarray]:
    """Return the stamps of a history and what it takes to interpolate after each: shape (16, n).

    Rows: both positions (3 + 3), rotation (4), its perpendicular (4), angle [rad],
    1 / duration [1/ns].  Compare TimeCache._segment.
    """
    stamps, numbers, first = cache.columns()
    stamps = np.array(stamps[first:], dtype=np.int64)
    numbers = np.array(numbers[7 * first :]).reshape(-1, 7)
    return stamps, _segments(stamps, numbers, np.arange(len(stamps)))


def _segments(stamps: np.ndarray, numbers: np.ndarray, which: np.ndarray) -> np.ndarray:
    """Return the columns of the table for the segments that begin at the samples `which`."""
    following = np.minimum(which + 1, len(stamps) - 1)
    start, end = numbers[which], numbers[following]
    a, b = _unit_rows(start[:, 3:]), _unit_rows(end[:, 3:])
    dot = np.einsum("ij,ij->i", a, b)
    b[dot < 0.0] *= -1.0
    lengths = np.sqrt(np.einsum("ij,ij->i", a, a) * np.einsum("ij,ij->i", b, b))
    theta = np.arccos(np.minimum(np.abs(dot) / lengths, 1.0))
    turning = theta != 0.0
    scale = np.divide(1.0, np.sin(theta), where=turning, out=np.zeros_like(theta))
    duration = stamps[following] - stamps[which]
    table = np.empty((16, len(which)))
    table[0:3] = start[:, :3].T
    table[3:6] = end[:, :3].T
    table[6:10] = a.T
    table[10:14] = ((b - np.cos(theta)[:, None] * a) * scale[:, None]).T
    table[14] = theta
    table[15] = np.divide(1.0, duration, where=duration != 0, out=np.zeros(len(which)))
    return table


def _unit_rows(rotations: np.ndarray) -> np.ndarray:
    """Return quaternions, shape (n, 4), scaled to length one; tf2's way for those out of all proportion."""
    squared = np.einsum("ij,ij->i", rotations, rotations)
    with np.errstate(all="ignore"):
        unit = rotations / np.sqrt(squared)[:, None]
    for i in np.flatnonzero(~((squared > 1e-300) & (squared < 1e300))):
        unit[i] = quaternions.canonical(rotations[i].tolist())
    return unit


def _reader(tables: Tables, cache, questions: int):
    """Return the function that reads one history at many moments, given in ascending order."""
    if cache.is_static:
        pose = cache.at(LATEST)
        return lambda moments: pose
    stamps, numbers, first = cache.columns()
    if questions * 8 < len(stamps) - first:  # few questions to a long history: make only the segments they need
        stamps = np.frombuffer(stamps, dtype=np.int64)[first:].copy()
        numbers = np.frombuffer(numbers).reshape(-1, 7)[first:].copy()
        return lambda moments: _interpolated(stamps, moments, lambda which: _segments(stamps, numbers, which))
    stamps, table = tables.of(cache)
    return lambda moments: _interpolated(stamps, moments, lambda which: table.take(which, axis=1))


def _interpolated(stamps: np.ndarray, moments: np.ndarray, segments) -> tuple[np.ndarray, ...]:
    """Return the pose at each of the moments, all of them within the history."""
    which = np.searchsorted(stamps, moments, side="right") - 1
    if stamps[0] != stamps[-1]:  # of twins at the old end the first counts, at the new end the last
        which[: np.searchsorted(moments, stamps[0], side="right")] = 0
    segment = segments(which)
    ratio = (moments - stamps.take(which)) * segment[15]
    turned = ratio * segment[14]
    rotation = segment[6:10] * np.cos(turned)
    rotation += segment[10:14] * np.sin(turned)
    return (*((1.0 - ratio) * segment[0:3] + ratio * segment[3:6]), *rotation)


def _along(route: Route, readers: dict, moments: np.ndarray) -> tuple[np.ndarray, ...]:
    """Return the pose along a route at each of the moments.  Compare Route.pose_at."""
    total = None
    for caches in (route.down, route.up):
        half = None
        for cache in caches:
            pose = readers[cache](moments)
            half = pose if half is None else compose(pose, half)
        if caches is route.down:
            total = None if half is None else invert(half)
        elif half is not None:
            total = half if total is None else compose(total, half)
    return total


def _signs(rotation: Sequence[np.ndarray]) -> np.ndarray:
    """Return 1 or -1 for each quaternion: tf2's choice between q and -q.  Compare transforms.canonical_pose."""
    x, y, z, w = rotation
    signs = np.where(w < 0.0, -1.0, 1.0)
    far = np.flatnonzero(np.abs(w) < HALF_AND_A_BIT)  # turned so far that the largest of x, y, z decides
    if len(far):
        x, y, z, w = (part.take(far) for part in rotation)
        ax, ay, az = np.abs(x), np.abs(y), np.abs(z)
        xy = np.maximum(ax, ay)
        largest = np.where(xy < az, z, np.where(ax < ay, y, x))
        signs[far] = np.where(largest < 0.0, -1.0, 1.0)
        middle = np.maximum(np.minimum(ax, ay), np.minimum(xy, az))
        on_a_digit = (np.abs(largest) - middle < A_BIT) | (np.abs(w) > 0.5 - A_BIT)
        for i in far[on_a_digit].tolist():
            q = [float(part[i]) for part in rotation]
            signs[i] = 1.0 if np.dot(quaternions.canonical(q), q) > 0.0 else -1.0
    return signs


# -- arrays that come in --------------------------------------------------------


def integer_stamps(stamps_ns: Sequence[int] | np.ndarray) -> np.ndarray:
    """Return stamps as an array of int64, shape (N,).

    Raises:
        TypeError: they are not integers: seconds, perhaps?
        ValueError: they are not one-dimensional.
    """
    stamps = np.asarray(stamps_ns)
    if stamps.ndim != 1:
        raise ValueError(f"stamps_ns must have shape (N,), not {stamps.shape}")
    if len(stamps) and stamps.dtype.kind not in "iu":
        raise TypeError(f"stamps_ns must be integer nanoseconds, not {stamps.dtype}; seconds(1.5) makes one")
    return stamps.astype(np.int64)


def columns_from_arrays(
    stamps_ns: Sequence[int] | np.ndarray, translations: np.ndarray, rotations_xyzw: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return stamps, shape (N,), and x, y, z, qx, qy, qz, qw, shape (N, 7), of arrays that fit together."""
    stamps = integer_stamps(stamps_ns)
    translations = np.asarray(translations, dtype=float).reshape(-1, 3) if not len(stamps) else np.asarray(translations)
    rotations = (
        np.asarray(rotations_xyzw, dtype=float).reshape(-1, 4) if not len(stamps) else np.asarray(rotations_xyzw)
    )
    if translations.shape != (len(stamps), 3) or rotations.shape != (len(stamps), 4):
        raise ValueError(
            f"{len(stamps)} stamps need translations of shape ({len(stamps)}, 3) and rotations (x, y, z, w) of shape "
            f"({len(stamps)}, 4), not {translations.shape} and {rotations.shape}"
        )
    return stamps, np.hstack([translations, rotations]).astype(float)


def is_plain(parent: str, child: str, stamps: np.ndarray, numbers: np.ndarray, newest_ns: int | None) -> bool:
    """Return whether samples may be stored without looking at each: sound, and each newer than the one before."""
    if not are_ordinary_names(parent, child):
        return False
    squared = np.einsum("ij,ij->i", numbers[:, 3:], numbers[:, 3:])
    return bool(
        np.isfinite(numbers).all()
        and ((squared > 1e-300) & (squared < 1e300)).all()
        and (stamps[1:] > stamps[:-1]).all()
        and (newest_ns is None or not len(stamps) or stamps[0] > newest_ns)
    )
