"""Summarise the edges of a stream of transforms, and pick the edges into which a fault can be injected.

    records: odom->base  base->laser  odom->base  map->odom  odom->base ...
                |                         |                      |
    StreamEdge(child="base", parent="odom", places=(0, 2, 4, ...))

`places` are indices into the stream. Each injector is a function from a `Patient`
(the stream, its edges and a random generator) to an `Injection`:

    Patient(records, edges, rng)
        .pick_moving()    a random edge that moves
        .tail(edge)       its samples after a random time in the middle
        .done(...)        the broken stream and its diagnosis
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple, TypeVar

import numpy as np

from tflab.core import StampedTransform, Transform
from tflab.core.transforms import TransformRecord

from .catalogue import Diagnosis, Fault

__all__ = ["CannotInject", "Injection", "InjectionTarget", "Stream", "StreamEdge", "edges_of", "in_order", "restamped"]


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


Thing = TypeVar("Thing")

FEWEST_SAMPLES = 20  # with fewer, a change halfway is hardly to be seen


class CannotInject(ValueError):
    """The stream has nothing that this fault could happen to."""


class Injection(NamedTuple):
    """A broken stream, and what is wrong with it."""

    records: Stream
    diagnosis: Diagnosis


class InjectionTarget(NamedTuple):
    """What an injector works with: the stream, its edges, and chance."""

    records: Stream
    edges: dict[str, StreamEdge]
    rng: np.random.Generator
    aim: str = ""  # the child of the edge that is to have the fault; "" leaves it to chance

    def pick(self, edges: Iterable[StreamEdge], otherwise: str) -> StreamEdge:
        """Return one of `edges` by chance, or the one that is aimed at; CannotInject says what is missing."""
        return self.choose(self.aimed(edges), otherwise)

    def aimed(self, edges: Iterable[StreamEdge]) -> list[StreamEdge]:
        """Return those of `edges` that may have the fault: all, or the one that is aimed at."""
        return [edge for edge in edges if self.aim in ("", edge.child)]

    def choose(self, things: Sequence[Thing], otherwise: str) -> Thing:
        """Return one of `things` by chance, or raise CannotInject saying what is missing."""
        if not things:
            of_it = f"{self.aim} cannot have the fault" if self.aim else "this stream cannot have the fault"
            raise CannotInject(f"{of_it}: it needs {otherwise}")
        return things[int(self.rng.integers(len(things)))]

    def moving(self) -> list[StreamEdge]:
        """Return the edges whose numbers change, and often enough to show a fault."""
        return [e for e in self.edges.values() if not e.is_static and e.varies and len(e.places) >= FEWEST_SAMPLES]

    def static(self) -> list[StreamEdge]:
        """Return the edges that came as static ones."""
        return [edge for edge in self.edges.values() if edge.is_static]

    def pick_moving(self) -> StreamEdge:
        """Return one moving edge by chance."""
        return self.pick(self.moving(), f"a moving edge of at least {FEWEST_SAMPLES} samples")

    def between(self, low: float, high: float) -> float:
        """Return a number by chance, in [low, high)."""
        return float(self.rng.uniform(low, high))

    def tail(self, edge: StreamEdge) -> tuple[int, ...]:
        """Return the places of an edge from some moment in the middle on; of a static one, all."""
        return edge.places if edge.is_static else edge.places[int(len(edge.places) * self.between(0.25, 0.6)) :]

    def sound(self, places: Iterable[int]) -> list[int]:
        """Return those places whose transforms can be computed with: an earlier fault may have spoilt some."""
        sound = [place for place in places if _can_be_computed_with(self.records[place].stamped.transform)]
        if not sound:
            raise CannotInject("this stream cannot have the fault: it needs transforms that are not broken already")
        return sound

    def period_ns(self, edge: StreamEdge) -> int:
        """Return the usual time between two samples of an edge, as they arrive."""
        heard = np.array([self.records[place].receive_ns for place in edge.places])
        return int(np.median(np.diff(heard)))

    def below(self, frame: str) -> set[str]:
        """Return a frame and everything under it."""
        family = {frame}
        while True:
            more = {edge.child for edge in self.edges.values() if edge.parent in family} - family
            if not more:
                return family
            family |= more

    def frames(self) -> list[str]:
        """Return every frame that is named, by the alphabet."""
        return sorted({edge.child for edge in self.edges.values()} | {edge.parent for edge in self.edges.values()})

    def changed(self, changes: dict[int, TransformRecord]) -> Stream:
        """Return the stream with some records replaced."""
        return [changes.get(place, record) for place, record in enumerate(self.records)]

    def done(
        self, records: Sequence[TransformRecord], fault: Fault, edges: Iterable[StreamEdge], at: int, detail: str
    ) -> Injection:
        """Return the result; `at` is the place of the first record at fault."""
        frames = tuple(edge.child for edge in edges)
        return Injection(in_order(records), Diagnosis(fault, frames, self.records[at].receive_ns, detail))


def _can_be_computed_with(transform: Transform) -> bool:
    length = math.hypot(*transform.rotation)
    return 0.0 < length < math.inf
