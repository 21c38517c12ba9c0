"""What would one draw of a buffer?  Its tree at one moment, as plain values.

A view never holds a buffer: it gets a `Snapshot`, or a function to ask.

Here the engine ends.  On top of it, `tflab.ros` speaks ROS 2 and `tflab.views`
draws; `records.py` is the form in which recordings come in.
"""

from __future__ import annotations

from typing import NamedTuple

from .describe import edges
from .transforms import Transform, transform_from_pose
from .tree import FrameTree

__all__ = ["FrameSnapshot", "Snapshot", "snapshot_of"]


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
