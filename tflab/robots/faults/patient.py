"""Where could a fault happen?  A stream to break, its edges, and chance.

    Patient(records, edges, rng)
        .pick_moving()    one edge that moves, by chance
        .tail(edge)       its samples from some moment in the middle on
        .done(...)        the broken stream and its diagnosis

Each injector is a function from a Patient to an Injection.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple, TypeVar

import numpy as np

from tflab.core import Transform
from tflab.core.records import TransformRecord

from .catalogue import Diagnosis, Fault
from .streams import Stream, StreamEdge, in_order

__all__ = ["CannotInject", "Injection", "Patient"]

Thing = TypeVar("Thing")

FEWEST_SAMPLES = 20  # with fewer, a change halfway is hardly to be seen


class CannotInject(ValueError):
    """The stream has nothing that this fault could happen to."""


class Injection(NamedTuple):
    """A broken stream, and what is wrong with it."""

    records: Stream
    diagnosis: Diagnosis


class Patient(NamedTuple):
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
