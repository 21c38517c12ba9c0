"""Interpolate and compose transforms for many stamps at once, with NumPy arrays (used by `batch.py`).

    moments_ns  [ t0   t1   t2  ... ]
                  |    |    |                    which segment of the history?  (search)
                  v    v    v
    table       [ x  dx  q  ...     ]  per edge  what is needed of it           (gather)
                  |    |    |
                  v    v    v                    along the route, edge by edge  (arithmetic)
    pose        [ x, y, z, qx, qy, qz, qw ]      seven arrays of shape (n,)

Compare `segments.py`, `routes.py` and `poses.canonical_pose`: this is what they
say, and the tests hold the two together.  Composing needs no second version:
`quaternions.rotate` and `multiply` are plain arithmetic, of numbers or of arrays.

tf2 has nothing of the kind.  (Vectorization.)
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from . import quaternions
from .cache import Cache, StaticCache, TimeCache
from .poses import A_BIT, HALF_AND_A_BIT
from .routes import Route
from .stamps import LATEST
from .validation import are_ordinary_names

__all__ = ["Tables", "canonical_signs", "columns_from_arrays", "integer_stamps", "is_plain", "poses_along_route"]

TABLE_BYTES_AT_MOST = 256 * 2**20


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
        known = self._tables.get(cache)
        if known is not None and known[0] == cache.version:
            return known[1:]
        stamps, table = segment_table(cache)
        if self.nbytes + table.nbytes > TABLE_BYTES_AT_MOST:
            self._tables.clear()
        self._tables[cache] = (cache.version, stamps, table)
        return stamps, table


def segment_table(cache: TimeCache) -> tuple[np.ndarray, np.ndarray]:
    """Return the stamps of a history and what it takes to interpolate after each: shape (16, n)."""
    stamps, numbers = _live_columns(cache)
    return stamps, _segments(stamps, numbers, np.arange(len(stamps)))


def _live_columns(cache: TimeCache) -> tuple[np.ndarray, np.ndarray]:
    """Return copies of the stamps, shape (n,), and of the numbers as sent, shape (n, 7)."""
    stamps, numbers, first = cache.columns()
    return np.frombuffer(stamps, np.int64)[first:].copy(), np.frombuffer(numbers).reshape(-1, 7)[first:].copy()


def _segments(stamps: np.ndarray, numbers: np.ndarray, which: np.ndarray) -> np.ndarray:
    """Return what it takes to interpolate after the samples `which`; compare segments.Segment.

    Rows: both positions (3 + 3), rotation (4), its perpendicular (4), angle [rad],
    1 / duration [1/ns].
    """
    following = np.minimum(which + 1, len(stamps) - 1)
    start, end = numbers[which], numbers[following]
    a, b = _unit_rows(start[:, 3:]), _unit_rows(end[:, 3:])
    dot = np.einsum("ij,ij->i", a, b)
    for i in np.flatnonzero(np.abs(dot) < A_BIT):
        a[i], b[i] = quaternions.canonical(a[i].tolist()), quaternions.canonical(b[i].tolist())
        dot[i] = a[i] @ b[i]
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
        unit: np.ndarray = rotations / np.sqrt(squared)[:, None]
    for i in np.flatnonzero(~((squared > 1e-300) & (squared < 1e300))):
        unit[i] = quaternions.canonical(rotations[i].tolist())
    return unit


# -- along a route ------------------------------------------------------------

Columns = tuple[Any, ...]  # a pose: seven arrays of shape (n,), or numbers that are the same for all
Reader = Callable[[np.ndarray], Columns]


def history_reader(tables: Tables, cache: Cache, questions: int) -> Reader:
    """Return the function that reads one history at many moments, given in ascending order."""
    if isinstance(cache, StaticCache):
        pose = cache.at(LATEST)
        return lambda moments: pose
    if questions * 8 < len(cache):  # few questions to a long history: make only the segments they need
        stamps, numbers = _live_columns(cache)
        return lambda moments: _interpolated(stamps, moments, lambda which: _segments(stamps, numbers, which))
    stamps, table = tables.of(cache)
    return lambda moments: _interpolated(stamps, moments, lambda which: table.take(which, axis=1))


def _interpolated(stamps: np.ndarray, moments: np.ndarray, segments: Callable[[np.ndarray], np.ndarray]) -> Columns:
    """Return the pose at each of the moments, all of them within the history; compare Segment.pose_at."""
    which = np.searchsorted(stamps, moments, side="right") - 1
    if stamps[0] != stamps[-1]:  # of equal stamps at the old end the first counts, at the new end the last
        which[: np.searchsorted(moments, stamps[0], side="right")] = 0
    segment = segments(which)
    ratio = (moments - stamps.take(which)) * segment[15]
    turned = ratio * segment[14]
    rotation = segment[6:10] * np.cos(turned)
    rotation += segment[10:14] * np.sin(turned)
    return (*((1.0 - ratio) * segment[0:3] + ratio * segment[3:6]), *rotation)


def poses_along_route(route: Route, readers: dict[Cache, Reader], moments: np.ndarray) -> Columns:
    """Return the pose along a route at each of the moments; compare Route.pose_at."""
    if not route.down:
        return _chained(route.up, readers, moments)
    back = _inverse(_chained(route.down, readers, moments))
    return _composed(back, _chained(route.up, readers, moments)) if route.up else back


def _chained(caches: list[Cache], readers: dict[Cache, Reader], moments: np.ndarray) -> Columns:
    total = readers[caches[0]](moments)
    for cache in caches[1:]:
        total = _composed(readers[cache](moments), total)
    return total


def _composed(outer: Columns, inner: Columns) -> Columns:
    x, y, z = quaternions.rotate(outer[3:], inner[:3])
    return (x + outer[0], y + outer[1], z + outer[2], *quaternions.multiply(outer[3:], inner[3:]))


def _inverse(pose: Columns) -> Columns:
    x, y, z = pose[:3]
    back = quaternions.conjugate(pose[3:])
    return (*quaternions.rotate(back, (-x, -y, -z)), *back)


def canonical_signs(rotation: Sequence[np.ndarray]) -> np.ndarray:
    """Return 1 or -1 for each quaternion: tf2's choice between q and -q.  Compare poses.canonical_pose."""
    x, y, z, w = rotation
    sign = np.where(w < 0.0, -1.0, 1.0)
    far = np.flatnonzero(np.abs(w) < HALF_AND_A_BIT)  # turned so far that the largest of x, y, z decides
    if len(far):
        x, y, z, w = (part.take(far) for part in rotation)
        ax, ay, az = np.abs(x), np.abs(y), np.abs(z)
        xy = np.maximum(ax, ay)
        largest = np.where(xy < az, z, np.where(ax < ay, y, x))
        sign[far] = np.where(largest < 0.0, -1.0, 1.0)
        middle = np.maximum(np.minimum(ax, ay), np.minimum(xy, az))
        on_a_digit = (np.abs(largest) - middle < A_BIT) | (np.abs(w) > 0.5 - A_BIT)
        for i in far[on_a_digit].tolist():
            q = [float(part[i]) for part in rotation]
            sign[i] = 1.0 if np.dot(quaternions.canonical(q), q) > 0.0 else -1.0
    return sign


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
