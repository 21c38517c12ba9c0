"""Prepare the transforms of a recording or a buffer for the checks: sorted by child frame, with clock offsets removed.

    received minus stamp  =  delay  +  recorder's clock minus the stamping clock
                              ^             ^ in simulation: years
                              what we look for

So the difference of the clocks is estimated first, from /clock if it was recorded,
else from what all publishers have in common, and subtracted.

A buffer does not keep the order of arrival, the times of receipt or what it refused. Checks that need those are
not made.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import compress

import numpy as np

from tflab.bags.recording import Clock, Headers, Recording, namespace_of
from tflab.core import NSEC_PER_SEC, BufferCore

from .evidence import SAME_CLOCK_NS, YEAR_NS, ClockRelation, Edge, Evidence, OtherSamples, is_stamped, part_of

__all__ = ["clock_relation", "evidence_from_buffer", "evidence_from_recording"]

BINS = 64
SAME_PACE = 0.02  # from one second a second: a replay is seldom so close to it


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
    clock = clock_relation(moving, headers, recording.clock)
    in_other_time: list[OtherSamples] = []
    moving, headers = list(_separated(moving, clock, in_other_time)), tuple(_separated(headers, clock, in_other_time))
    subject = recording.name + (f" ({namespace})" if namespace else "")
    statics = [edge for edge in edges if edge.is_static]
    raw_names = [(label.parent, label.child, label.topic) for label in compress(table.labels, mine)]
    return Evidence(
        subject, namespace, moving, statics, raw_names, True, recording.begin_ns, recording.end_ns, headers,
        tuple(in_other_time), recording.joint_states, recording.connections, recording.robot_description, clock,
    )  # fmt: skip


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
                 np.arange(len(stamps)), numbers, np.arange(len(stamps)))
        )  # fmt: skip
        raw_names.extend((name, frame, topic) for name in parents)
    moving = [edge for edge in edges if not edge.is_static]
    begin_ns = min((int(edge.stamp_ns[0]) for edge in moving), default=0)
    end_ns = max((int(edge.stamp_ns[-1]) for edge in moving), default=0)
    return Evidence(subject, "", moving, [edge for edge in edges if edge.is_static], raw_names, False, begin_ns, end_ns)


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
    varying = [source for source in sources if isinstance(source, Headers) or np.ptp(source.numbers, axis=0).any()]
    sources = varying or sources  # a mount that is repeated has the stamps of whoever repeats it
    if not sources:
        return ClockRelation("same", np.zeros(0), np.zeros(0))
    if _are_on_one_clock(sources):
        return ClockRelation("same", np.zeros(0), np.zeros(0))
    return _estimated_relation(sources)


def _are_on_one_clock(sources: list) -> bool:
    """Return whether sources are on the recorder's clock, or the others have a date and its pace: none is simulated."""
    usual_ns = [abs(float(np.median(s.receive_ns - s.stamp_ns))) for s in sources]
    if sorted(usual_ns)[(len(usual_ns) - 1) // 2] < SAME_CLOCK_NS:  # of two that disagree, the recorder's counts
        return True
    far = [source for source, away_ns in zip(sources, usual_ns, strict=True) if away_ns >= SAME_CLOCK_NS]
    paces = [np.ptp(source.stamp_ns) / max(np.ptp(source.receive_ns), 1) for source in far]
    are_dated = all(np.median(source.stamp_ns) > YEAR_NS for source in far)
    return len(far) < len(sources) and are_dated and all(abs(pace - 1.0) < SAME_PACE for pace in paces)


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


def _separated(sources: Sequence, clock: ClockRelation, in_other_time: list[OtherSamples]) -> Iterator:
    """Yield the samples of each source in the usual time base, and append the others to `in_other_time`."""
    for source in sources:
        offset_ns = source.receive_ns - source.stamp_ns
        away_ns = offset_ns - clock.difference_at(source.receive_ns) * NSEC_PER_SEC
        is_no_date = (away_ns > SAME_CLOCK_NS) & (source.stamp_ns < YEAR_NS)
        is_on_the_wall = (np.abs(away_ns) > SAME_CLOCK_NS) & (np.abs(offset_ns) <= SAME_CLOCK_NS)
        is_other = is_no_date | is_on_the_wall
        if is_other.any() and not is_other.all():
            in_other_time.append(OtherSamples(part_of(source, is_other), len(is_other)))
            source = part_of(source, ~is_other)
        yield source


def _edge(table, child: str, is_static: bool, parts: list[tuple[int, np.ndarray]]) -> Edge:
    """Return one edge of the rows of several labels."""
    rows = np.sort(np.concatenate([rows for _, rows in parts]).astype(np.int32))
    labels = table.label[rows]
    parents, parent_of_label = _indices([table.labels[number].parent.removeprefix("/") for number, _ in parts])
    publishers, publisher_of_label = _indices([table.labels[number].publisher for number, _ in parts])
    place = np.zeros(len(table.labels), dtype=np.int64)
    place[[number for number, _ in parts]] = np.arange(len(parts))
    parent, publisher = (column.astype(np.int32)[place[labels]] for column in (parent_of_label, publisher_of_label))
    columns = (column[rows] for column in (table.receive_ns, table.stamp_ns, table.message))
    topic = table.labels[parts[0][0]].topic
    return Edge(child, is_static, topic, parents, publishers, parent, publisher, *columns, table.numbers, rows)


def _indices(names) -> tuple[tuple[str, ...], np.ndarray]:
    """Return the different names in the order of first mention, and for each name its place among them."""
    places: dict[str, int] = {}
    column = [places.setdefault(name, len(places)) for name in names]
    return tuple(places), np.array(column, dtype=np.int64)
