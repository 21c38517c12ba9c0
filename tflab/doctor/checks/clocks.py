"""Check that the nodes' clocks agree: stamps against times of receipt.

    receipt   |----|----|----|----|----|
    stamps    |----|----|  |----|----|        the clock was set back: a bag in a loop, a simulator
                          back                that was reset, NTP after the start

If all publishers jump together, it is the time source. If one does, it is that computer. Whether all nodes read the
same clock can only be seen in a graph: a recording has no nodes.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tflab.bags.recording import Headers
from tflab.core import NSEC_PER_SEC
from tflab.ros.snapshot import GraphSnapshot
from tflab.text import Text

from ..evidence import Edge, Evidence, Jump, find_jumps, is_stamped
from ..findings import Finding, first_of, times_of
from .time_bases import has_copied_stamps, in_groups

__all__ = ["JumpEvent", "clock_offset", "jump_events", "jumping_clocks", "mixed_time_sources",
           "other_time_source", "settled_delays_s"]  # fmt: skip

MOST_NAMES = 6
TOGETHER_NS = 2 * NSEC_PER_SEC  # jumps this close to each other are one event
OFFSET_S = 0.1
FEWEST_SAMPLES = 8
MANY = 0.4  # of the sources have the common delay; the others may take longer ...
SWEPT = re.compile(r"LaserScan|PointCloud|Image")
LEAST_SHARE = 0.6  # ... but nobody much less


class JumpEvent(NamedTuple):
    """Clocks that were set at the same moment by the same amount: one time source, or one computer.

    Attributes:
        moment_ns: of receipt [ns].
        size_s: negative if back.
        edges: with the sample from which on each has the new time.
        topics: whose stamps jumped with them.
    """

    moment_ns: int
    size_s: float
    edges: tuple[tuple[Edge, int], ...]
    topics: tuple[str, ...]


def jump_events(evidence: Evidence, headers: tuple[Headers, ...] = ()) -> list[JumpEvent]:
    """Return each moment at which the clock of edges, and of topics if they are given, was set.

    An edge that leaps ahead alone is not among them: it may have begun to stamp ahead (see stamps.odd_delays).
    """
    jumps = [(int(edge.receive_ns[jump.index]), edge, jump) for edge in evidence.moving for jump in edge.jumps]
    for header in filter(_has_stamps, headers):
        found = find_jumps(header.stamp_ns, header.receive_ns, int(np.median(np.diff(header.receive_ns))))
        jumps += [(int(header.receive_ns[jump.index]), header, jump) for jump in found]
    events = [
        JumpEvent(
            group[0][0],
            float(np.median([jump.size_s for *_, jump in group])),
            tuple((source, jump.index) for _, source, jump in group if isinstance(source, Edge)),
            tuple(source.topic for _, source, _ in group if isinstance(source, Headers)),
        )
        for group in in_groups(sorted(jumps, key=lambda entry: entry[0]), _are_together)
    ]
    return [event for event in events if event.size_s < 0 or len(event.edges) > 1]


def _are_together(a: tuple[int, Edge | Headers, Jump], b: tuple[int, Edge | Headers, Jump]) -> bool:
    """Return whether a source jumped as another did: its last sample before may be as old as its period."""
    is_same = abs(a[2].size_s - b[2].size_s) < 0.2 * max(abs(a[2].size_s), abs(b[2].size_s)) + 0.05
    return bool(is_same and b[1].receive_ns[b[2].index - 1] - a[0] < TOGETHER_NS)


def settled_delays_s(evidence: Evidence) -> list[np.ndarray]:
    """Return how late each sample of each moving edge was received, as if no clock had been set meanwhile [s]."""
    delays_s = [evidence.delay_s(edge) for edge in evidence.moving]
    if evidence.clock.source != "same":  # then the difference of the clocks, taken off, holds the jumps already
        return delays_s
    places = {edge.child: place for place, edge in enumerate(evidence.moving)}
    for event in jump_events(evidence):
        for edge, index in event.edges:
            delays_s[places[edge.child]][index:] += event.size_s
    return delays_s


def jumping_clocks(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for what had its clock set together, back or forward; a loop sets it again and again."""
    alike: dict[tuple, list[JumpEvent]] = {}
    for event in jump_events(evidence, tuple(header for header in evidence.headers if any(header.frames))):
        names = sorted({f"{edge.usual_parent} -> {edge.child}" for edge, _ in event.edges})
        alike.setdefault((event.size_s < 0, *names), []).append(event)
    for (is_back, *names), events in alike.items():
        topics = sorted({topic for event in events for topic in event.topics})
        largest_s = max(abs(event.size_s) for event in events)
        facts = {"size": f"{largest_s:.3f}", "times": times_of(len(events)),
                 "edges": first_of([*names, *topics], MOST_NAMES)}  # fmt: skip
        facts |= {"remedy": "chronyc tracking"} if evidence.clock.source == "same" else {}  # nothing is simulated
        code, severity = (
            ("clock-jump-back", "error" if names else "warning") if is_back else ("clock-jump-forward", "warning")
        )
        topic = next(iter((*(edge.topic for edge, _ in events[0].edges), *topics)))
        parent, child = names[0].split(" -> ", 1) if len(names) == 1 else ("", "")
        yield Finding(code, severity, parent, child, topic, events[0].moment_ns, events[-1].moment_ns, facts)


def other_time_source(evidence: Evidence) -> Iterator[Finding]:
    """Yield a note if stamps come from another clock than the times of receipt, as in simulation."""
    if evidence.clock.source != "same":
        difference_s = evidence.clock.difference_s
        steps_s = np.diff(evidence.clock.receive_ns) / NSEC_PER_SEC
        paces = 1.0 - np.diff(difference_s)[steps_s > 0.0] / steps_s[steps_s > 0.0]
        facts = {
            "source": Text("estimated", "추정") if evidence.clock.source == "estimated" else evidence.clock.source,
            "difference": f"{np.median(difference_s):.3f}",
            "pace": f"{np.mean(np.clip(paces, 0.0, 10.0)) if len(paces) else 1.0:.2f}",
        }
        yield Finding("other-clock", "info", facts=facts)


def clock_offset(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding if everything is stamped early, or late, by about the same amount."""
    if evidence.clock.source != "same":
        return
    settled = [*zip(evidence.moving, settled_delays_s(evidence), strict=True)]
    settled += [(header, evidence.delay_s(header)) for header in evidence.headers]
    settled = [entry for entry in settled if _has_stamps(entry[0])]
    usual_s = np.array([float(np.median(delay_s)) for _, delay_s in settled])
    witnesses = in_groups(settled, lambda a, b: has_copied_stamps(b[0], a[0]))
    # of one source alone there is nothing to compare it with, see stamps.odd_delays
    if sum(not any(map(_is_sweep, group)) for group in witnesses) < 2:
        return
    sign = math.copysign(1.0, float(np.median(usual_s)))
    common_s = sign * float(np.percentile(sign * usual_s, 20, method="lower"))
    near = np.abs(usual_s - common_s) < max(0.05, 0.1 * abs(common_s))
    if sign * common_s > OFFSET_S and near.mean() >= MANY and (usual_s / common_s > LEAST_SHARE).all():
        way = Text("after", "이후") if common_s > 0 else Text("before", "이전")
        facts = {"offset": f"{abs(common_s):.3f}", "way": way, "count": len(usual_s)}
        yield Finding("clock-offset", "warning", facts=facts)


def _has_stamps(source: Edge | Headers) -> bool:
    return len(source.stamp_ns) >= FEWEST_SAMPLES and is_stamped(source)


def _is_sweep(settled: tuple[Edge | Headers, np.ndarray]) -> bool:
    """Return whether messages are stamped at the beginning of what was measured in one period."""
    source, delay_s = settled
    period_s = float(np.median(np.diff(source.receive_ns))) / NSEC_PER_SEC
    return isinstance(source, Headers) and bool(SWEPT.search(source.msgtype)) and np.median(delay_s) < period_s + 0.05


TRANSFORM_TOPICS = ("/tf", "/tf_static")


def mixed_time_sources(snapshot: GraphSnapshot) -> Iterator[Finding]:
    """Yield a finding if, of the nodes that deal with transforms, some follow /clock and others do not."""
    nodes = [n for n in snapshot.nodes if {*n.publishes, *n.subscribes} & set(TRANSFORM_TOPICS)]
    following = [node.name for node in nodes if node.follows_clock]
    others = [node.name for node in nodes if not node.follows_clock]
    if following and others:
        facts = {"following": ", ".join(following), "others": ", ".join(others), "node": others[0]}
        yield Finding("mixed-time", "error", topic="/clock", facts=facts)
