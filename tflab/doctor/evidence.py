"""What is there to judge?  One namespace of transforms, sorted by child, and the clocks behind them.

    Recording  --.
    BufferCore --+-->  Evidence:  edges      one child each, in the order of arrival
                                  headers    what other messages say about time and frames
                                  clock      what to expect of "received minus stamp"

A message is received after its stamp by the delay that we look for, *plus* the
difference of two clocks: the recorder's, and the one that stamps.  In simulation
that difference is years.  So it is estimated first, from /clock if it was
recorded, else from what all publishers have in common, and taken off.

A buffer has forgotten the order of arrival, the times of receipt and whatever it
refused; checks that need those are then not made.

Read `jumps.py` next.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise

import numpy as np

from tflab.bags.recording import Clock, Connection, Headers, JointStates, Recording, namespace_of
from tflab.core import NSEC_PER_SEC, BufferCore

from .jumps import Jump, find_jumps

__all__ = ["ClockRelation", "Edge", "Evidence", "evidence_from_buffer", "evidence_from_recording", "is_stamped"]

SAME_CLOCK_NS = 3600 * NSEC_PER_SEC  # two clocks of one robot differ by less than this, sim time and 1970 by more
BINS = 64


@dataclass(eq=False)
class Edge:
    """One child, as it came on /tf or on /tf_static, in the order of arrival.

    Attributes:
        child: without a leading slash.
        parents, publishers: the different ones, in the order of first mention.
        parent, publisher: shape (n,), indices into these.
        receive_ns, stamp_ns, message: shape (n,).
        numbers: shape (n, 7), as sent.
    """

    child: str
    is_static: bool
    topic: str
    parents: tuple[str, ...]
    publishers: tuple[str, ...]
    parent: np.ndarray
    publisher: np.ndarray
    receive_ns: np.ndarray
    stamp_ns: np.ndarray
    message: np.ndarray
    numbers: np.ndarray

    def __len__(self) -> int:
        return len(self.stamp_ns)

    @property
    def usual_parent(self) -> str:
        """The parent of most samples."""
        return self.parents[int(np.bincount(self.parent).argmax())]

    @cached_property
    def is_finite(self) -> np.ndarray:
        """Which samples hold only finite numbers: shape (n,)."""
        return np.isfinite(self.numbers).all(axis=1)

    @cached_property
    def norm(self) -> np.ndarray:
        """The length of each rotation: shape (n,)."""
        return np.sqrt(np.einsum("ij,ij->i", self.numbers[:, 3:], self.numbers[:, 3:]))

    @cached_property
    def is_usable(self) -> np.ndarray:
        """Which samples are poses: shape (n,)."""
        return self.is_finite & (self.norm > 0.0)

    @cached_property
    def period_ns(self) -> int:
        """The usual time between two samples [ns], 0 if there are none."""
        steps = np.diff(np.unique(self.stamp_ns))
        return int(np.median(steps)) if len(steps) else 0

    @cached_property
    def jumps(self) -> list[Jump]:
        """Where the clock behind the stamps was set; none if there are no times of receipt."""
        return find_jumps(self.stamp_ns, self.receive_ns, self.period_ns)

    def stretches(self) -> list[slice]:
        """Return the samples between the jumps of the clock."""
        bounds = [0, *(jump.index for jump in self.jumps), len(self)]
        return [slice(a, b) for a, b in pairwise(bounds) if b > a]


@dataclass(frozen=True)
class ClockRelation:
    """What "received minus stamp" is on the whole: (time of receipt, difference) pairs to interpolate between.

    Attributes:
        source: "same" (one clock), "/clock" (recorded) or "estimated".
    """

    source: str
    receive_ns: np.ndarray
    difference_s: np.ndarray

    def difference_at(self, receive_ns: np.ndarray) -> np.ndarray:
        """Return the difference of the two clocks at moments of receipt [s]."""
        if not len(self.receive_ns):
            return np.zeros(len(receive_ns))
        begin_ns = self.receive_ns[0]  # a float cannot tell nanoseconds apart that are counted from 1970
        return np.interp(
            (receive_ns - begin_ns).astype(float), (self.receive_ns - begin_ns).astype(float), self.difference_s
        )


@dataclass(eq=False)
class Evidence:
    """Everything that the checks look at.

    Attributes:
        moving, statics: what came on /tf and on /tf_static, in the order of first mention.
        has_arrival: whether times of receipt and the order of arrival are known.
        raw_names: every (parent, child, topic), as sent, in the order of first mention.
    """

    subject: str
    namespace: str
    moving: list[Edge]
    statics: list[Edge]
    raw_names: list[tuple[str, str, str]]
    has_arrival: bool
    begin_ns: int = 0
    end_ns: int = 0
    headers: tuple[Headers, ...] = ()
    joint_states: tuple[JointStates, ...] = ()
    connections: tuple[Connection, ...] = ()
    clock: ClockRelation = field(default_factory=lambda: ClockRelation("same", np.zeros(0), np.zeros(0)))

    def edges(self) -> Iterator[Edge]:
        """Yield every edge, the moving ones first."""
        yield from self.moving
        yield from self.statics

    @cached_property
    def parent_of(self) -> dict[str, str]:
        """The usual parent of each child; a static one counts if there are both."""
        return {edge.child: edge.usual_parent for edge in self.edges() if edge.usual_parent}

    @cached_property
    def frames(self) -> set[str]:
        """Every frame of the tree."""
        return {frame for pair in self.parent_of.items() for frame in pair}

    def roots(self) -> list[str]:
        """Return the frames that are nobody's child, sorted."""
        return sorted(self.frames - set(self.parent_of))

    def root_of(self, frame: str) -> str:
        """Return where the climb from a frame ends; in a loop, at the frame itself."""
        seen = set()
        top = frame
        while top in self.parent_of:
            if top in seen:
                return frame
            seen.add(top)
            top = self.parent_of[top]
        return top

    def delay_s(self, edge: Edge | Headers) -> np.ndarray:
        """Return how late each message was received, the clocks' difference taken off [s]."""
        offset_s = (edge.receive_ns - edge.stamp_ns) / NSEC_PER_SEC
        return offset_s - self.clock.difference_at(edge.receive_ns)


def evidence_from_recording(recording: Recording, namespace: str = "") -> Evidence:
    """Return what a recording tells about the transforms of one namespace."""
    table = recording.transforms
    mine = [namespace_of(label.topic) == namespace for label in table.labels]
    rows_of = {}
    order = np.argsort(table.label, kind="stable")
    bounds = np.searchsorted(table.label[order], np.arange(len(table.labels) + 1))
    for number, label in enumerate(table.labels):
        if mine[number]:
            key = (label.child.removeprefix("/"), label.is_static)
            rows_of.setdefault(key, []).append((number, order[bounds[number] : bounds[number + 1]]))
    edges = [_edge(table, child, is_static, parts) for (child, is_static), parts in rows_of.items()]
    moving = [edge for edge in edges if not edge.is_static]
    headers = tuple(header for header in recording.headers if not namespace or header.topic.startswith(namespace + "/"))
    return Evidence(
        subject=recording.name + (f" ({namespace})" if namespace else ""),
        namespace=namespace,
        moving=moving,
        statics=[edge for edge in edges if edge.is_static],
        raw_names=[
            (label.parent, label.child, label.topic)
            for label, is_mine in zip(table.labels, mine, strict=True)
            if is_mine
        ],
        has_arrival=True,
        begin_ns=recording.begin_ns,
        end_ns=recording.end_ns,
        headers=headers,
        joint_states=recording.joint_states,
        connections=recording.connections,
        clock=clock_relation(moving, headers, recording.clock),
    )


def evidence_from_buffer(buffer: BufferCore, subject: str = "buffer") -> Evidence:
    """Return what a buffer still tells: its histories, without what it refused and when it heard of them."""
    edges = []
    raw_names = []
    for frame in buffer.frame_names():
        history = buffer.history(frame)
        if not history.stamps_ns:
            continue
        parents, parent = _indices(history.parents)
        publishers, publisher = _indices(history.authorities)
        stamps = np.array(history.stamps_ns, dtype=np.int64)
        numbers = np.array([(*t.translation, *t.rotation) for t in history.transforms], dtype=float)
        topic = "/tf_static" if history.is_static else "/tf"
        edges.append(
            Edge(frame, history.is_static, topic, parents, publishers, parent, publisher, stamps, stamps,
                 np.arange(len(stamps)), numbers)
        )  # fmt: skip
        raw_names.extend((name, frame, topic) for name in parents)
    moving = [edge for edge in edges if not edge.is_static]
    return Evidence(
        subject=subject,
        namespace="",
        moving=moving,
        statics=[edge for edge in edges if edge.is_static],
        raw_names=raw_names,
        has_arrival=False,
        begin_ns=min((int(edge.stamp_ns[0]) for edge in moving), default=0),
        end_ns=max((int(edge.stamp_ns[-1]) for edge in moving), default=0),
    )


def is_stamped(source: Edge | Headers) -> bool:
    """Return whether the stamps of a source were set; a single zero may be the first moment of a simulated clock."""
    return len(source.stamp_ns) > 0 and np.count_nonzero(source.stamp_ns == 0) <= min(1, len(source.stamp_ns) - 1)


def clock_relation(moving: list[Edge], headers: tuple[Headers, ...], clock: Clock) -> ClockRelation:
    """Return the difference between the recorder's clock and the one that stamps.

    If /clock was recorded, it is the one that stamps.  Otherwise, if the usual
    "received minus stamp" is small, the clocks are one; if not, a recording was
    recorded again from its replay, or /clock was left out: then the level that all
    have in common is the difference, and it may drift.
    """
    if len(clock.time_ns) > 1:
        return ClockRelation("/clock", clock.receive_ns, (clock.receive_ns - clock.time_ns) / NSEC_PER_SEC)
    sources = [source for source in (*moving, *headers) if len(source.stamp_ns) > 1 and is_stamped(source)]
    if not sources:
        return ClockRelation("same", np.zeros(0), np.zeros(0))
    usual_s = float(np.median([np.median(s.receive_ns - s.stamp_ns) for s in sources])) / NSEC_PER_SEC
    if abs(usual_s) < SAME_CLOCK_NS / NSEC_PER_SEC:
        return ClockRelation("same", np.zeros(0), np.zeros(0))
    return _estimated_relation(sources)


def _estimated_relation(sources: list) -> ClockRelation:
    """Return what most sources agree on: in each stretch of time the median of their least differences."""
    begin_ns = min(int(source.receive_ns.min()) for source in sources)
    span_ns = max(int(source.receive_ns.max()) for source in sources) - begin_ns + 1
    bins = min(BINS, max(max(len(source.receive_ns) for source in sources) // 8, 1))
    least_s = np.full((len(sources), bins), np.nan)
    for row, source in zip(least_s, sources, strict=True):
        offset_s = (source.receive_ns - source.stamp_ns) / NSEC_PER_SEC
        which = (source.receive_ns - begin_ns) * bins // span_ns
        for i in np.unique(which).tolist():
            row[i] = offset_s[which == i].min()
    filled = np.flatnonzero(~np.isnan(least_s).all(axis=0))
    middle_ns = begin_ns + (2 * filled + 1) * span_ns // (2 * bins)
    return ClockRelation("estimated", middle_ns, np.nanmedian(least_s[:, filled], axis=0))


def _edge(table, child: str, is_static: bool, parts: list[tuple[int, np.ndarray]]) -> Edge:
    """Return one edge of the rows of several labels."""
    rows = np.sort(np.concatenate([rows for _, rows in parts]))
    labels = table.label[rows]
    parents, parent_of_label = _indices([table.labels[number].parent.removeprefix("/") for number, _ in parts])
    publishers, publisher_of_label = _indices([table.labels[number].publisher for number, _ in parts])
    place = np.zeros(len(table.labels), dtype=np.int64)
    place[[number for number, _ in parts]] = np.arange(len(parts))
    return Edge(
        child=child,
        is_static=is_static,
        topic=table.labels[parts[0][0]].topic,
        parents=parents,
        publishers=publishers,
        parent=parent_of_label[place[labels]],
        publisher=publisher_of_label[place[labels]],
        receive_ns=table.receive_ns[rows],
        stamp_ns=table.stamp_ns[rows],
        message=table.message[rows],
        numbers=table.numbers[rows],
    )


def _indices(names) -> tuple[tuple[str, ...], np.ndarray]:
    """Return the different names in the order of first mention, and for each name its place among them."""
    places: dict[str, int] = {}
    column = [places.setdefault(name, len(places)) for name in names]
    return tuple(places), np.array(column, dtype=np.int64)
