"""What would one draw of a buffer?  Its tree at one moment, as plain values.

A view never holds a buffer: it gets a `Snapshot`, or a function to ask.

This is the last page of the engine.  On top of it, `tflab.ros` speaks ROS 2, and
`tflab.views` draws.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from .stamps import LATEST
from .transforms import Transform

if TYPE_CHECKING:
    from .buffer import BufferCore

__all__ = ["FrameSnapshot", "Snapshot", "snapshot"]


class FrameSnapshot(NamedTuple):
    """One child of the tree.

    Attributes:
        name, parent: the edge, as its newest sample has it.
        is_static: whether it is good for any time.
        authorities: everybody who set it, in alphabetical order; more than one is a fault.
        parents: every parent it had within its history, in alphabetical order.
        samples: how many are stored.
        rate_hz: how many a second, as tf2 reckons it; 0 for a static one.
        oldest_ns, newest_ns: where its history begins and ends [ns]; 0 for a static one.
        parent_T_frame: its newest transform.
    """

    name: str
    parent: str
    is_static: bool
    authorities: tuple[str, ...]
    parents: tuple[str, ...]
    samples: int
    rate_hz: float
    oldest_ns: int
    newest_ns: int
    parent_T_frame: Transform


class Snapshot(NamedTuple):
    """A tree at one moment.

    Attributes:
        roots: frames without a parent, in the order of first mention; more than one means separate trees.
        frames: the others, in the order of first mention.
    """

    roots: tuple[str, ...]
    frames: tuple[FrameSnapshot, ...]


def snapshot(buffer: BufferCore) -> Snapshot:
    """Return what there is to draw of a buffer now."""
    roots, frames = [], []
    for name in buffer.frame_names():
        history = buffer.history(name)
        if not history.stamps_ns:
            roots.append(name)
            continue
        span_ns = history.stamps_ns[-1] - history.stamps_ns[0]
        frames.append(
            FrameSnapshot(
                name=name,
                parent=history.parents[-1],
                is_static=history.is_static,
                authorities=tuple(sorted(set(history.authorities))),
                parents=tuple(sorted(set(history.parents))),
                samples=len(history.stamps_ns),
                rate_hz=0.0,
                oldest_ns=0 if history.is_static else history.stamps_ns[0],
                newest_ns=0 if history.is_static else history.stamps_ns[-1],
                parent_T_frame=history.transforms[-1],
            )
        )
    return Snapshot(tuple(roots), tuple(frames))
