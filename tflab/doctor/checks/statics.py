"""Is what is fixed published as fixed?  Question 7: /tf_static says it once, for all times and late listeners.

    /tf_static   base_link -> laser        once, latched
    /tf          odom -> base_link         again and again, each with its stamp

A mount that is repeated on /tf wastes the network and is unknown between its
samples; a motion on /tf_static has no history, so every lookup gets the last value.
A latched transform is older than the recording, and a joint may stand still: both
are as it should be.  Read `time_sources.py` next.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from tflab.bags.recording import namespace_of
from tflab.core import NSEC_PER_SEC

from ..evidence import Edge, Evidence
from ..findings import Finding
from .motion import LEAST_DIFFERENCE_M, distances, is_constant, unit

__all__ = ["constant_on_tf", "missing_statics", "moving_on_static", "volatile_statics"]

FEWEST_SAMPLES = 8
LEAST_TIME_S = 1.0
LEAST_CHANGE_M = 1e-4
WORLD_FRAMES = ("map", "world", "earth", "odom")
MOVABLE = re.compile(r"wheel|caster|steer|joint|shoulder|elbow|wrist|arm|finger|grip|hip|knee|pan_|tilt|link_?\d")


def missing_statics(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding if there are moving transforms and no static ones."""
    if evidence.statics or not evidence.moving:
        return
    mounts_on_tf = any(_looks_like_a_mount(evidence, edge) for edge in evidence.moving)
    hanging = sorted(
        frame.removeprefix("/")
        for header in evidence.headers
        for frame in header.frames
        if frame and frame.removeprefix("/") not in evidence.frames
    )
    facts = {"hanging": ", ".join(dict.fromkeys(hanging)) or "none", "trees": len(evidence.roots())}
    needed = hanging or len(evidence.roots()) > 1 or not mounts_on_tf
    yield Finding("statics-missing", "warning" if needed else "info", topic="/tf_static", facts=facts)


def constant_on_tf(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each mount that is repeated on /tf."""
    for edge in evidence.moving:
        if _looks_like_a_mount(evidence, edge):
            rate_hz = NSEC_PER_SEC / edge.period_ns if edge.period_ns else 0.0
            facts = {"count": len(edge), "rate": f"{rate_hz:.1f}"}
            span = (int(edge.receive_ns[0]), int(edge.receive_ns[-1]))
            yield Finding("constant-on-tf", "warning", edge.usual_parent, edge.child, edge.topic, *span, facts)


def moving_on_static(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each child that changes its value on /tf_static."""
    for edge in evidence.statics:
        poses = unit(edge.numbers[edge.is_usable])
        if len(poses) < 2:
            continue
        is_change = distances(poses[1:], poses[:-1]) > LEAST_CHANGE_M
        changes = int(is_change.sum())
        apart_m = distances(poses, np.broadcast_to(poses[0], poses.shape))
        if not changes:
            continue
        facts = {"changes": changes, "apart": f"{apart_m.max():.3f}", "count": len(edge)}
        code, severity = "moving-on-static", "error"
        if changes == 1:
            code, severity = "static-changed", "warning"
        elif apart_m.max() > LEAST_DIFFERENCE_M and _takes_turns(poses, is_change):
            code = "two-owners"
            facts["evidence"] = f"two values on /tf_static, {apart_m.max():.3f} m apart, that took turns"
        span = (int(edge.receive_ns[0]), int(edge.receive_ns[-1]))
        yield Finding(code, severity, edge.usual_parent, edge.child, edge.topic, *span, facts)


def _takes_turns(poses: np.ndarray, is_change: np.ndarray) -> bool:
    """Return whether the values go back and forth between two."""
    told = poses[np.concatenate([[True], is_change])]
    return bool((distances(told[2:], told[:-2]) < LEAST_CHANGE_M).all())


def volatile_statics(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding if /tf_static was offered to those who were there, and not to late listeners."""
    for connection in evidence.connections:
        if connection.topic.endswith("tf_static") and namespace_of(connection.topic) == evidence.namespace:
            for qos in connection.qos:
                if qos.durability == "volatile":
                    facts = {"publisher": connection.publisher or "a publisher"}
                    yield Finding("volatile-static", "warning", topic=connection.topic, facts=facts)


def _looks_like_a_mount(evidence: Evidence, edge: Edge) -> bool:
    """Return whether an edge on /tf never changes, although the robot moves and it is no joint at rest."""
    spoken_s = (edge.receive_ns[-1] - edge.receive_ns[0]) / NSEC_PER_SEC
    if len(edge) < FEWEST_SAMPLES or spoken_s < LEAST_TIME_S or not is_constant(edge):
        return False
    if edge.usual_parent not in evidence.parent_of or edge.usual_parent in WORLD_FRAMES:
        return False  # at the top of the tree: a localiser that has had nothing to correct
    return not _is_a_joint_at_rest(evidence, edge)


def _is_a_joint_at_rest(evidence: Evidence, edge: Edge) -> bool:
    """Return whether an edge is one of the joints: by its stamps, its name, or because it comes with some that move."""
    for joints in evidence.joint_states:
        if np.isin(edge.stamp_ns, joints.stamp_ns).mean() > 0.5:
            return True
    if MOVABLE.search(edge.child.lower()):
        return True
    for other in evidence.moving:
        if other is edge or other.usual_parent in WORLD_FRAMES or is_constant(other):
            continue
        if np.isin(edge.message, other.message).mean() > 0.5:
            return True
    return False
