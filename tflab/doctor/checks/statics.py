"""Check that fixed transforms are on /tf_static, latched and sent once, and moving ones on /tf.

    /tf_static   base_link -> laser        once, latched
    /tf          odom -> base_link         again and again, each with its stamp

A mount that is repeated on /tf wastes the network and is unknown between its
samples; a motion on /tf_static has no history, so every lookup gets the last value.
A latched transform is older than the recording, and a joint may stand still: both
are as it should be.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from tflab.bags.recording import namespace_of
from tflab.core import NSEC_PER_SEC
from tflab.text import Text

from ..evidence import Edge, Evidence
from ..findings import Finding, first_of
from .motion import LEAST_DIFFERENCE_M, distances, is_constant, steps_and_turns, unit

__all__ = ["constant_on_tf", "empty_topics", "missing_statics", "moving_on_static", "odometry_on_static",
           "replaced_latched_messages", "volatile_statics"]  # fmt: skip

FEWEST_SAMPLES = 8
LEAST_TIME_S = 1.0
LEAST_CHANGE_M = 1e-4
WORLD_FRAMES = ("map", "world", "earth", "odom")
ODOM = re.compile(r"(^|[/_])odom$")
ROBOT_BODY = re.compile(r"(^|[/_])base_(link|footprint)$")
FEWEST_MOVING = 20  # samples on /tf_static: so often nobody says what is fixed
TOGETHER_NS = NSEC_PER_SEC
MOST_SHOWN = 6
MOVABLE = re.compile(
    r"wheel|caster_(rot|swivel)|steer|joint|shoulder|elbow|wrist|(^|_)(fore|upper)?arm(_|\d|$)|finger|grip|hip|knee"
    r"|(^|_)pan(_|$)|tilt|link_?[1-9]\d*$"
)


def missing_statics(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding if there are moving transforms and no static ones; a warning if anything misses them."""
    if evidence.statics or not evidence.moving:
        return
    topic = f"{evidence.namespace}/tf_static"
    hanging = sorted(evidence.named_by_messages - evidence.frames - evidence.all_parents)
    is_robot = any(ROBOT_BODY.search(frame) for frame in evidence.frames)
    mounts_on_tf = any(_looks_like_a_mount(evidence, edge) for edge in evidence.moving)
    needed = len(evidence.roots()) > 1 or ((hanging or is_robot) and not mounts_on_tf)
    facts = {"hanging": ", ".join(hanging) or Text("none", "없음"), "trees": len(evidence.roots())}
    yield Finding("statics-missing", "warning" if needed else "info", topic=topic, facts=facts)


def constant_on_tf(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each mount that is repeated on /tf."""
    for edge in evidence.moving:
        if _looks_like_a_mount(evidence, edge):
            rate_hz = NSEC_PER_SEC / edge.period_ns if edge.period_ns else 0.0
            facts = {"count": len(edge), "rate": f"{rate_hz:.1f}"}
            span = (int(edge.receive_ns[0]), int(edge.receive_ns[-1]))
            yield Finding("constant-on-tf", "warning", edge.usual_parent, edge.child, edge.topic, *span, facts)


def moving_on_static(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each child that changes its value on /tf_static, those that changed together as one."""
    changed_at: dict[int, list[tuple[Edge, float]]] = {}
    for edge in evidence.statics:
        rows = np.flatnonzero(edge.is_usable)
        poses = unit(edge.numbers[rows])
        if len(poses) < 2:
            continue
        apart_m = float(distances(poses, np.broadcast_to(poses[0], poses.shape)).max())
        is_change = distances(poses[1:], poses[:-1]) > (LEAST_CHANGE_M if len(poses) < FEWEST_MOVING else 0.0)
        changes = int(is_change.sum())
        if not changes or apart_m < LEAST_CHANGE_M:
            continue
        if changes == 1 and _was_replaced(evidence, edge, int(rows[int(np.argmax(is_change)) + 1])):
            yield _finding_of_replacement(edge, poses)
            continue
        if changes == 1:
            moment_ns = int(edge.receive_ns[rows[int(np.argmax(is_change)) + 1]])
            changed_at.setdefault(moment_ns // TOGETHER_NS, []).append((edge, apart_m))
            continue
        facts = {"changes": changes, "apart": f"{apart_m:.3f}", "count": len(edge)}
        code = "moving-on-static"
        if apart_m > LEAST_DIFFERENCE_M and _takes_turns(poses, is_change):
            code = "two-owners"
            facts["evidence"] = Text(
                f"two values on {edge.topic}, {apart_m:.3f} m apart, that took turns",
                f"{edge.topic} 토픽에서 {apart_m:.3f} m 떨어진 두 값이 번갈아 나타났습니다",
            )
            facts["kind"] = "mount"
        span = (int(edge.receive_ns[0]), int(edge.receive_ns[-1]))
        yield Finding(code, "error", edge.usual_parent, edge.child, edge.topic, *span, facts)
    for changed in changed_at.values():
        yield _finding_of_changes(changed)


def odometry_on_static(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each body of a robot that is fixed in odom by /tf_static alone."""
    moving = {edge.child for edge in evidence.moving}
    for edge in evidence.statics:
        parent = edge.usual_parent
        if (
            not ODOM.search(parent)
            or not ROBOT_BODY.search(edge.child)
            or edge.child in moving
            or not is_constant(edge)
        ):
            continue
        topics = [h.topic for h in evidence.headers if "Odometry" in h.msgtype and parent in h.frames]
        facts = {"topics": ", ".join(topics) or Text("none", "없음")}
        severity = "error" if topics else "warning"
        yield Finding("odometry-on-static", severity, parent, edge.child, edge.topic, facts=facts)


def _finding_of_changes(changed: list[tuple[Edge, float]]) -> Finding:
    edge = changed[0][0]
    names = [f"{other.usual_parent} -> {other.child}" for other, _ in changed]
    facts = {
        "edges": first_of(names, MOST_SHOWN),
        "count": len(changed),
        "apart": f"{max(apart_m for _, apart_m in changed):.3f}",
    }
    parent, child = (edge.usual_parent, edge.child) if len(changed) == 1 else ("", "")
    span = (int(edge.receive_ns[0]), int(edge.receive_ns[-1]))
    return Finding("static-changed", "warning", parent, child, edge.topic, *span, facts)


def _finding_of_replacement(edge: Edge, poses: np.ndarray) -> Finding:
    (moved_m,), (turned_rad,) = steps_and_turns(poses[-1:], poses[:1])
    apart = f"{moved_m:.3f} m, {turned_rad:.3f} rad"
    text = Text(
        f"two publishers of {edge.topic} disagree by {apart}; the last value stays",
        f"{edge.topic} 토픽의 두 발행자가 다른 값을 발행하고(차이 {apart}), 마지막 값이 남습니다",
    )
    facts = {"evidence": text, "kind": "mount", "count": len(edge), "apart": f"{moved_m:.3f}"}
    span = (int(edge.receive_ns[0]), int(edge.receive_ns[-1]))
    return Finding("two-owners", "error", edge.usual_parent, edge.child, edge.topic, *span, facts)


def _was_replaced(evidence: Evidence, edge: Edge, row: int) -> bool:
    """Return whether another publisher sent the new value: a broadcaster sends all of its transforms again with it."""
    before, after = edge.message[row - 1], edge.message[row]
    sent_before = {other.child for other in evidence.statics if before in other.message}
    sent_after = {other.child for other in evidence.statics if after in other.message}
    return evidence.publishers_of(edge.topic) > 1 and not sent_before <= sent_after


def _takes_turns(poses: np.ndarray, is_change: np.ndarray) -> bool:
    """Return whether the values go back and forth between two."""
    told = poses[np.concatenate([[True], is_change])]
    return bool((distances(told[2:], told[:-2]) < LEAST_CHANGE_M).all())


def replaced_latched_messages(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each latched publisher of ROS 1 whose last message lacks what an earlier one held."""
    sent: dict[tuple[str, str], dict[int, set[str]]] = {}  # children of each message of a publisher
    for edge in evidence.statics:
        for message, number in zip(edge.message.tolist(), edge.publisher.tolist(), strict=True):
            messages = sent.setdefault((edge.topic, edge.publishers[number]), {})
            messages.setdefault(message, set()).add(edge.child)
    for (topic, publisher), messages in sent.items():
        lost = sorted(set().union(*messages.values()) - messages[max(messages)])
        if publisher and lost:  # a rosbag2 names no publisher, and ROS 2 keeps as many messages as the depth
            facts = {"count": len(messages), "lost": first_of(lost, MOST_SHOWN)}
            yield Finding("latched-replaced", "warning", topic=topic, facts=facts)


def empty_topics(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each topic of transforms that was recorded without a message."""
    heard = {topic for *_, topic in evidence.raw_names}
    for connection in evidence.connections:
        topic = connection.topic
        is_ours = topic.rpartition("/")[2] in ("tf", "tf_static") and namespace_of(topic) == evidence.namespace
        if is_ours and not connection.count and topic not in heard:
            heard.add(topic)
            is_needed = evidence.named_by_messages - evidence.frames
            offers = sorted({", ".join(qos[2:]) for qos in connection.qos}) or [Text("unknown", "알 수 없음")]
            yield Finding("empty-topic", "error" if is_needed else "warning", topic=topic, facts={"offer": offers[0]})


def volatile_statics(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding if /tf_static was offered to those who were there, and not to late listeners."""
    for connection in evidence.connections:
        is_ours = connection.topic.endswith("tf_static") and namespace_of(connection.topic) == evidence.namespace
        if is_ours and any(qos.durability == "volatile" for qos in connection.qos):
            heard = "" if evidence.statics else Text(" No message was received on it.", " 수신된 메시지가 없습니다.")
            facts = {"publisher": connection.publisher or Text("a publisher", "이름을 알 수 없음"), "heard": heard}
            yield Finding("volatile-static", "warning", topic=connection.topic, facts=facts)


def _looks_like_a_mount(evidence: Evidence, edge: Edge) -> bool:
    """Return whether an edge on /tf never changes, although the robot moves and it is no joint at rest."""
    spoken_s = (edge.receive_ns[-1] - edge.receive_ns[0]) / NSEC_PER_SEC
    if len(edge) < FEWEST_SAMPLES or spoken_s < LEAST_TIME_S or not is_constant(edge):
        return False
    is_top = edge.usual_parent not in evidence.parent_of
    if edge.usual_parent in WORLD_FRAMES or (is_top and edge.child in evidence.all_parents):
        return False  # at the top of the tree: a localiser that has had nothing to correct
    if edge.child in evidence.joint_kinds:
        return evidence.joint_kinds[edge.child] == "fixed"
    return not _is_a_joint_at_rest(evidence, edge)


def _is_a_joint_at_rest(evidence: Evidence, edge: Edge) -> bool:
    """Return whether an edge is one of the joints: by its stamps, its name, or because it comes with some that move."""
    if evidence.stamped_by_joint_states:
        return edge.child in evidence.stamped_by_joint_states
    if MOVABLE.search(edge.child.lower()):
        return True
    for other in evidence.moving:
        if other is edge or other.usual_parent in WORLD_FRAMES or is_constant(other):
            continue
        if np.isin(edge.message, other.message).mean() > 0.5:
            return True
    return False
