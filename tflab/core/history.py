"""What is stored?  One child through time, and what it all weighs.

    odom -> base_link    o---o---o--o---o      stamps, parents, authorities, transforms
    base_link -> laser   ================      bolted on: one sample, good for any time

Timelines, reports and tests read a buffer through these values; a lookup does
not need them.  tf2 keeps this to itself.  Read `snapshot.py` next.
"""

from __future__ import annotations

from typing import NamedTuple

from .cache import TimeCache
from .transforms import Transform
from .tree import Tree

__all__ = ["History", "Memory", "history_of", "memory_of"]

# In CPython on 64 bits.
STATIC_BYTES = 400
SEGMENT_BYTES = 700


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
    """What a buffer holds, and apart from that what it merely remembers to be fast.

    Attributes:
        samples: how many transforms are stored.
        sample_bytes: what they take.
        memo_bytes: what segments, routes and tables take; bounded, and gone whenever they might be stale.
    """

    samples: int
    sample_bytes: int
    memo_bytes: int


def history_of(tree: Tree, number: int) -> History:
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


def memory_of(tree: Tree, other_memo_bytes: int) -> Memory:
    """Return the weight of a tree; `other_memo_bytes` is what its owner remembers besides."""
    samples = sample_bytes = segments = 0
    for cache in tree.caches:
        samples += len(cache) if cache is not None else 0
        if isinstance(cache, TimeCache):
            column_bytes, remembered = cache.memory()
            sample_bytes += column_bytes
            segments += remembered
        elif cache is not None:
            sample_bytes += STATIC_BYTES
    return Memory(samples, sample_bytes, SEGMENT_BYTES * segments + other_memo_bytes)
