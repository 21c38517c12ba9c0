"""Summarise each edge in figures: its rate, its delays, its longest silence, its owners.

    edge                rate    delay p50  p95  max    longest silence   owners
    odom -> base_link   20.0    4 ms  6 ms  9 ms       0.10 s            /wheel_odometry

`--edges` prints the table. Expectations are written from it, and two recordings are compared by it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tflab.bags.recording import Recording, namespace_of
from tflab.core import NSEC_PER_SEC

from .checks.clocks import settled_delays_s
from .checks.motion import unit
from .collect_evidence import evidence_from_recording
from .evidence import Edge, Evidence, LookupRow
from .lookups import lookups_of

__all__ = ["EdgeProfile", "RecordingProfile", "lines_of_table", "name_of", "profile_of", "text_from_profile"]

NO_FIGURE = 0.0


class EdgeProfile(NamedTuple):
    """One edge in figures.

    Attributes:
        topic: on which it came.
        rate_hz: of its usual period; 0 if static, or heard once.
        delay_s: median, 95th percentile, and most [s]; zeros if static.
        silence_s: the longest [s]; 0 if static.
        owners: names of nodes, where they are known.
        mount: x, y, z [m], qx, qy, qz, qw of a static edge; empty if it moves.
    """

    parent: str
    child: str
    topic: str
    is_static: bool
    count: int
    rate_hz: float
    delay_s: tuple[float, float, float]
    silence_s: float
    owners: tuple[str, ...]
    mount: tuple[float, ...]

    @property
    def namespace(self) -> str:
        """Of which robot, "" if its transforms are on /tf."""
        return namespace_of(self.topic)

    @property
    def name(self) -> str:
        return name_of(self.namespace, self.parent, self.child)


def name_of(namespace: str, parent: str, child: str) -> str:
    """Return how an edge is called: "odom -> base_link", "/robot1: odom -> base_link"."""
    return f"{namespace}: {parent} -> {child}" if namespace else f"{parent} -> {child}"


class RecordingProfile(NamedTuple):
    """Every edge in figures, the frames of each topic of stamped messages, and how often their lookups work."""

    edges: tuple[EdgeProfile, ...]
    frames_of: dict[str, tuple[str, ...]]
    lookups: tuple[LookupRow, ...] = ()


def profile_of(recording: Recording) -> RecordingProfile:
    """Return a recording in figures."""
    edges: list[EdgeProfile] = []
    lookups: list[LookupRow] = []
    for namespace in recording.namespaces():
        evidence = evidence_from_recording(recording, namespace)
        edges += _moving(evidence)
        lookups += lookups_of(evidence)
        edges += [_static(edge) for edge in evidence.statics if edge.usual_parent]
    frames_of = {header.topic: tuple(sorted(filter(None, header.frames))) for header in recording.headers}
    return RecordingProfile(
        tuple(edges), {topic: frames for topic, frames in frames_of.items() if frames}, tuple(lookups)
    )


def text_from_profile(profile: RecordingProfile) -> str:
    """Return the edges as a table for a terminal, the moving ones first."""
    rows = [("edge", "samples", "rate [Hz]", "delay [ms] p50", "p95", "max", "silence [s]", "owners")]
    for edge in profile.edges:
        owners = ", ".join(edge.owners)
        if edge.is_static:
            rows.append((edge.name, str(edge.count), "static", "", "", "", "", owners))
            continue
        delays = [f"{1e3 * delay_s + 0.0:.0f}" for delay_s in edge.delay_s]
        rows.append((edge.name, str(edge.count), f"{edge.rate_hz:.1f}", *delays, f"{edge.silence_s:.2f}", owners))
    return "\n".join(lines_of_table(rows))


def lines_of_table(rows: list[tuple[str, ...]]) -> list[str]:
    """Return rows for a terminal, the first and the last column to the left, and the others to the right."""
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    lines = []
    for row in rows:
        cells = [
            row[0].ljust(widths[0]),
            *(cell.rjust(width) for cell, width in zip(row[1:-1], widths[1:-1], strict=True)),
        ]
        lines.append("  ".join([*cells, row[-1]]).rstrip())
    return lines


def _moving(evidence: Evidence) -> list[EdgeProfile]:
    profiles = []
    for edge, delay_s in zip(evidence.moving, settled_delays_s(evidence), strict=True):
        if not edge.usual_parent:
            continue
        delays = tuple(float(np.percentile(delay_s, share)) for share in (50, 95, 100)) if evidence.has_arrival else ()
        silence_s = float(np.diff(edge.receive_ns).max()) / NSEC_PER_SEC if len(edge) > 1 else NO_FIGURE
        rate_hz = NSEC_PER_SEC / edge.period_ns if edge.period_ns else NO_FIGURE
        profiles.append(
            EdgeProfile(edge.usual_parent, edge.child, edge.topic, False, len(edge), rate_hz,
                        delays or (NO_FIGURE,) * 3, silence_s, _owners(edge), ())
        )  # fmt: skip
    return profiles


def _static(edge: Edge) -> EdgeProfile:
    usable = np.flatnonzero(edge.is_usable)
    mount = tuple(unit(edge.numbers[usable[-1:]])[0].tolist()) if len(usable) else ()
    return EdgeProfile(edge.usual_parent, edge.child, edge.topic, True, len(edge), NO_FIGURE, (NO_FIGURE,) * 3,
                       NO_FIGURE, _owners(edge), mount)  # fmt: skip


def _owners(edge: Edge) -> tuple[str, ...]:
    return tuple(sorted(filter(None, edge.publishers)))
