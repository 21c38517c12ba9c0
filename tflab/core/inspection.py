"""Read the content of a buffer without changing it: names, parents, histories, memory, and a snapshot to draw.

    odom -> base_link    o---o---o--o---o      stamps, parents, authorities, transforms
    base_link -> laser   ================      static: one sample, valid at any time

A view never holds a buffer. It gets a `Snapshot`, the tree at one time as plain
values, or a function to look transforms up. tf2 has some of these methods
(allFramesAsYAML, getParent), but not the histories.
"""

from __future__ import annotations

from threading import RLock
from typing import NamedTuple

import numpy as np

from . import describe, validation
from .cache import Gap
from .columns import Tables
from .describe import edges
from .failures import exception_from_failure
from .routes import Routes
from .stamps import LATEST
from .transforms import Transform, transform_from_pose
from .tree import FrameTree, LookupFailure, TreePath, find_path, frames_on_path

__all__ = ["FrameSnapshot", "History", "Inspection", "Memory", "Snapshot", "snapshot_of"]


class FrameSnapshot(NamedTuple):
    """One child of the tree.

    Attributes:
        name, parent: the edge, as its newest sample has it.
        is_static: whether it is good for any time.
        owners: every (parent, authority) within its history, in alphabetical order; more than one is a fault.
        samples: how many are stored.
        rate_hz: how many a second, as tf2 reckons it; 0 for a static one.
        oldest_ns, newest_ns: where its history begins and ends [ns]; 0 for a static one.
        parent_T_frame: its newest transform.
    """

    name: str
    parent: str
    is_static: bool
    owners: tuple[tuple[str, str], ...]
    samples: int
    rate_hz: float
    oldest_ns: int
    newest_ns: int
    parent_T_frame: Transform

    @property
    def parents(self) -> tuple[str, ...]:
        """Return every parent that it had, in alphabetical order."""
        return tuple(sorted({parent for parent, _ in self.owners}))

    def authorities(self, parent: str) -> tuple[str, ...]:
        """Return everybody who set it under one parent, in alphabetical order; "" who is not known is left out."""
        return tuple(sorted({who for each, who in self.owners if each == parent and who}))


class Snapshot(NamedTuple):
    """A tree at one moment.

    Attributes:
        roots: frames without a parent, in the order of first mention; more than one means separate trees.
        frames: the others, in the order of first mention.
    """

    roots: tuple[str, ...]
    frames: tuple[FrameSnapshot, ...]


def snapshot_of(tree: FrameTree) -> Snapshot:
    """Return what there is to draw of a tree now."""
    rates_hz = {edge.child: edge.rate_hz for edge in edges(tree)}
    roots, frames = [], []
    for name, cache in zip(tree.names[1:], tree.caches[1:], strict=True):
        if cache is None or (newest := cache.newest()) is None:
            roots.append(name)
            continue
        frames.append(
            FrameSnapshot(
                name=name,
                parent=tree.names[newest.parent],
                is_static=cache.is_static,
                owners=tuple(sorted((tree.names[parent], authority) for parent, authority in cache.owners())),
                samples=len(cache),
                rate_hz=0.0 if cache.is_static else rates_hz[name],
                oldest_ns=cache.oldest_ns,
                newest_ns=cache.newest_ns,
                parent_T_frame=transform_from_pose(newest.pose),
            )
        )
    return Snapshot(tuple(roots), tuple(frames))


class History(NamedTuple):
    """One child through time: parallel tuples, oldest first.

    Attributes:
        frame: the child.
        is_static: whether its one sample is good for any time.
        stamps_ns: when each sample was measured [ns].
        parents: whose child it was.
        authorities: who said so.
        transforms: `parent_T_frame` of each.
    """

    frame: str
    is_static: bool
    stamps_ns: tuple[int, ...]
    parents: tuple[str, ...]
    authorities: tuple[str, ...]
    transforms: tuple[Transform, ...]


class Memory(NamedTuple):
    """The memory of a buffer: its samples, and separately its caches.

    Attributes:
        samples: how many transforms are stored.
        sample_bytes: what they take.
        memo_bytes: what segments, routes and tables take; bounded, see `routes.py`.
    """

    samples: int
    sample_bytes: int
    memo_bytes: int


class Inspection:
    """A tree, what is remembered of it, and what one can read off it: the silent half of a BufferCore."""

    def __init__(self, cache_time_ns: int) -> None:
        self._lock = RLock()  # held by whoever reads or changes anything below
        self._tree = FrameTree(cache_time_ns)
        self._routes = Routes(self._tree)
        self._tables = Tables()

    @property
    def cache_time_ns(self) -> int:
        """How far each history reaches back from its newest sample [ns]."""
        return self._tree.cache_time_ns

    def frame_names(self) -> list[str]:
        """Return every frame ever named, roots included, in the order of first mention."""
        with self._lock:
            return list(self._tree.known_names())

    def frame_exists(self, name: str) -> bool:
        """Return whether a frame was ever named."""
        return name in self._tree.numbers

    def frame_number(self, name: str) -> int:
        """Return a frame's number, counted from 1 in the order of first mention; 0 if unknown."""
        return self._tree.numbers.get(name, 0)

    def parent_of(self, frame: str, stamp_ns: int = LATEST) -> str | None:
        """Return the parent of a frame at `stamp_ns`, or None if it has none then."""
        with self._lock:
            cache = self._tree.caches[self.frame_number(frame)]
            try:
                number = cache.parent_at(stamp_ns) if cache is not None else 0
            except Gap:
                return None
            return self._tree.names[number] if number else None

    def chain(self, target_frame: str, source_frame: str, stamp_ns: int = LATEST) -> list[str]:
        """Return the frames on the way, from `source_frame` up and down to `target_frame`, both included.

        Raises:
            TransformException: as for BufferCore.lookup_transform.
        """
        with self._lock:
            path = self._find_path(target_frame, source_frame, validation.whole_nanoseconds(stamp_ns))
            frames = frames_on_path(self._tree, path, self._tree.numbers[source_frame])
            return [self._tree.names[frame] for frame in frames]

    def history(self, frame: str) -> History:
        """Return every sample of one child; of a root, an empty history.

        Raises:
            LookupException: the frame was never named.
        """
        with self._lock:
            if frame not in self._tree.numbers:
                raise validation.unknown_frame(self._tree, "history", frame)
            return _history_of(self._tree, self._tree.numbers[frame])

    def memory(self) -> Memory:
        """Return the memory of the samples, and separately of the caches."""
        with self._lock:
            caches = [cache for cache in self._tree.caches if cache is not None]
            weights = [cache.memory() for cache in caches]
            return Memory(
                samples=sum(map(len, caches)),
                sample_bytes=sum(stored for stored, _ in weights),
                memo_bytes=sum(memos for _, memos in weights) + self._routes.nbytes + self._tables.nbytes,
            )

    def snapshot(self) -> Snapshot:
        """Return what there is to draw of the tree now."""
        with self._lock:
            return snapshot_of(self._tree)

    def history_ends(self) -> np.ndarray:
        """Return the stamps at which any history begins or ends, ascending, shape (n,) [ns]."""
        with self._lock:
            caches = [cache for cache in self._tree.caches if cache is not None]
            return np.unique(np.array([end for c in caches for end in (c.oldest_ns, c.newest_ns)], dtype=np.int64))

    def all_frames_as_string(self) -> str:
        """Return one line for each frame that has a parent, as tf2 prints it."""
        with self._lock:
            return describe.all_frames_as_string(self._tree)

    def all_frames_as_yaml(self, now_ns: int | None = None) -> str:
        """Return tf2's YAML of every edge; with `now_ns` [ns], also how old each is."""
        with self._lock:
            return describe.all_frames_as_yaml(self._tree, now_ns or 0)

    def all_frames_as_dot(self, now_ns: int | None = None) -> str:
        """Return tf2's Graphviz drawing; with `now_ns` [ns], also how old each edge is."""
        with self._lock:
            return describe.all_frames_as_dot(self._tree, now_ns or 0)

    def _find_path(self, target_frame: str, source_frame: str, stamp_ns: int) -> TreePath:
        """Return tf2's path between two frames at a moment, or raise its reason why there is none."""
        target = validation.frame_number_or_raise(self._tree, "lookupTransform argument target_frame", target_frame)
        source = validation.frame_number_or_raise(self._tree, "lookupTransform argument source_frame", source_frame)
        path = find_path(self._tree, target, source, stamp_ns)
        if isinstance(path, LookupFailure):
            raise exception_from_failure(self._tree, path, target_frame, source_frame)
        return path


def _history_of(tree: FrameTree, number: int) -> History:
    """Return every sample of one frame; of a root, none."""
    cache = tree.caches[number]
    samples = cache.samples() if cache is not None else []
    return History(
        frame=tree.names[number],
        is_static=cache is not None and cache.is_static,
        stamps_ns=tuple(sample.stamp_ns for sample in samples),
        parents=tuple(tree.names[sample.parent] for sample in samples),
        authorities=tuple(sample.authority for sample in samples),
        transforms=tuple(Transform(sample.pose[:3], sample.pose[3:]) for sample in samples),
    )
