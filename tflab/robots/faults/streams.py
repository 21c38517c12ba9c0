"""Which edges are in a stream of transforms?  A summary to pick from.

    records: odom->base  base->laser  odom->base  map->odom  odom->base ...
                |                         |                      |
    StreamEdge(child="base", parent="odom", places=(0, 2, 4, ...))

Places are positions in the stream, so that a change to an edge is a change to the
records at its places.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

from tflab.core import StampedTransform, Transform
from tflab.core.records import TransformRecord

__all__ = ["Stream", "StreamEdge", "edges_of", "in_order", "restamped"]

Stream = list[TransformRecord]


@dataclass(frozen=True, slots=True)
class StreamEdge:
    """One child and its samples.

    Attributes:
        child: its name as sent.
        parent: its usual parent.
        is_static: whether its samples came as static ones.
        publisher: who usually sends it; "" if not known.
        places: positions of its samples in the stream, ascending.
        varies: whether its numbers ever change.
    """

    child: str
    parent: str
    is_static: bool
    publisher: str
    places: tuple[int, ...]
    varies: bool


def edges_of(records: Sequence[TransformRecord]) -> dict[str, StreamEdge]:
    """Return the edges of a stream by child, in the order of the names."""
    places: dict[str, list[int]] = {}
    for place, record in enumerate(records):
        places.setdefault(record.stamped.child_frame_id, []).append(place)
    edges = {}
    for child, where in sorted(places.items()):
        samples = [records[place] for place in where]
        first = samples[0].stamped.transform
        edges[child] = StreamEdge(
            child,
            _usual([sample.stamped.frame_id for sample in samples]),
            _usual([sample.is_static for sample in samples]),
            _usual([sample.publisher for sample in samples]),
            tuple(where),
            any(sample.stamped.transform != first for sample in samples),
        )
    return edges


def in_order(records: Sequence[TransformRecord]) -> Stream:
    """Return records in the order of arrival; those that came together stay as they were."""
    return sorted(records, key=lambda record: record.receive_ns)


def restamped(
    record: TransformRecord,
    *,
    stamp_ns: int | None = None,
    frame_id: str | None = None,
    child_frame_id: str | None = None,
    transform: Transform | None = None,
) -> TransformRecord:
    """Return a record with some fields of its transform replaced."""
    new = {
        "stamp_ns": stamp_ns,
        "frame_id": frame_id,
        "child_frame_id": child_frame_id,
        "transform": transform,
    }
    stamped: StampedTransform = replace(
        record.stamped, **{key: value for key, value in new.items() if value is not None}
    )
    return record._replace(stamped=stamped)


def _usual(values: list):
    return Counter(values).most_common(1)[0][0]
