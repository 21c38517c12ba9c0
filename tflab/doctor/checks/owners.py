"""Check that each transform has one owner (one node that publishes it).

    /wheel_odometry  --o---o---o---.
                                    >-- odom -> base_link    o x o x o x   the robot trembles in RViz
    /ekf             ----x---x---x-'

A rosbag2 does not record who published a message.  Then two owners show in the
values: each of them is smooth, but they take turns.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from tflab.text import Text

from ..evidence import Edge, Evidence
from ..findings import Finding
from .motion import LEAST_DIFFERENCE_M, distances, interleaved_streams, unit

__all__ = ["owners_of_both_kinds", "several_joint_publishers", "several_owners", "several_static_owners"]

MOST_SHOWN = 3
FEWEST_CONTRADICTIONS = 3
ODOMETRY = re.compile(r"(^|[/_])(map|odom|world|earth)")


def several_owners(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each moving child that several publish, by their names or by their values."""
    for edge in evidence.moving:
        named = _publishers_at_once(edge)
        if named:
            facts = {"evidence": _published_by(named), "apart": "", "count": len(edge), "kind": _kind_of(edge)}
            span = (int(edge.receive_ns[0]), int(edge.receive_ns[-1]))
            yield Finding("two-owners", "error", edge.usual_parent, edge.child, edge.topic, *span, facts)
            continue
        streams = interleaved_streams(edge) if evidence.has_arrival else None
        if streams:
            told = Text(
                f"two sequences of values, {streams.apart_m:.3f} m apart, that took turns {streams.returns} times",
                f"{streams.apart_m:.3f} m 떨어진 두 값이 {streams.returns}번 번갈아 나타났습니다",
            )
            span = (int(edge.receive_ns[streams.first]), int(edge.receive_ns[streams.last]))
            facts = {"evidence": told, "apart": f"{streams.apart_m:.3f}", "count": streams.returns,
                     "kind": _kind_of(edge)}  # fmt: skip
            yield Finding("two-owners", "error", edge.usual_parent, edge.child, edge.topic, *span, facts)


def several_static_owners(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each static child of which two publishers tell different values."""
    for edge in evidence.statics:
        if len(set(edge.publisher[edge.is_usable].tolist())) < 2:
            continue
        poses = unit(edge.numbers[edge.is_usable])
        apart_m = distances(poses, np.broadcast_to(poses[0], poses.shape))
        if apart_m.max() > LEAST_DIFFERENCE_M / 10:
            facts = {"evidence": _published_by(sorted(edge.publishers)), "apart": f"{apart_m.max():.3f}",
                     "count": len(edge), "kind": "mount"}  # fmt: skip
            yield Finding("two-owners", "error", edge.usual_parent, edge.child, edge.topic, facts=facts)


def several_joint_publishers(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each topic of joint states on which two publishers contradict each other."""
    for joints in evidence.joint_states:
        states: dict[int, dict[str, float]] = {}
        contradictions = 0
        for stamp_ns, names, positions in zip(joints.stamp_ns.tolist(), joints.names, joints.positions, strict=True):
            state = dict(zip(names, positions, strict=False))
            before = states.setdefault(stamp_ns, state)
            contradictions += any(before[name] != state[name] for name in before.keys() & state.keys())
        publishers = evidence.publishers_of(joints.topic)
        if publishers > 1 and contradictions >= FEWEST_CONTRADICTIONS:
            facts = {"count": contradictions, "publishers_count": publishers}
            siblings = tuple(sorted(evidence.stamped_by_joint_states))
            yield Finding("two-joint-publishers", "error", topic=joints.topic, facts=facts, siblings=siblings)


def owners_of_both_kinds(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each child that is published as moving and as static, unless both say the same."""
    statics = {edge.child: edge for edge in evidence.statics}
    for edge in evidence.moving:
        static = statics.get(edge.child)
        if static is not None and not _say_the_same(edge, static):
            facts = {"count": len(edge), "static_count": len(static)}
            yield Finding("moving-and-static", "error", edge.usual_parent, edge.child, edge.topic, facts=facts)


def _published_by(names: list[str]) -> Text:
    return Text(f"published by {', '.join(names)}", f"발행자: {', '.join(names)}")


def _kind_of(edge: Edge) -> str:
    """Return what an edge stands for, which tells who usually quarrels about it."""
    return "odometry" if ODOMETRY.search(edge.usual_parent) else "joint"


def _say_the_same(a: Edge, b: Edge) -> bool:
    """Return whether all values of two edges are one: a mount that is repeated as if it moved."""
    poses = unit(np.concatenate([a.numbers[a.is_usable], b.numbers[b.is_usable]]))
    return len(poses) == 0 or bool((distances(poses, np.broadcast_to(poses[0], poses.shape)) < 1e-6).all())


def _publishers_at_once(edge: Edge) -> list[str]:
    """Return who published an edge, if several known nodes did so during the same time."""
    if len(edge.publishers) < 2:
        return []
    spans = []
    for number in np.unique(edge.publisher).tolist():
        mine = edge.receive_ns[edge.publisher == number]
        spans.append((int(mine.min()), int(mine.max()), edge.publishers[number]))
    spans.sort()
    overlap = any(later[0] < earlier[1] for earlier, later in pairwise(spans))
    return sorted(name or "(unknown)" for *_, name in spans)[:MOST_SHOWN] if overlap else []
