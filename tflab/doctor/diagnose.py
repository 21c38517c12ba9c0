"""Run every check on a recording or a buffer, and separate causes from their effects.

One cause has many effects: a misspelt name also makes two trees, two owners also bring stamps out of order.
Only the cause is reported, with its effects in a line. `diagnose.yaml` lists the effects of each cause.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import NamedTuple

from tflab.bags.recording import Recording, namespace_of
from tflab.core import NSEC_PER_SEC, BufferCore
from tflab.text import Text, load_yaml

from .checks import clocks, lookups, names, owners, silence, stamps, statics, time_bases, tree, values
from .collect_evidence import evidence_from_buffer, evidence_from_recording
from .evidence import Evidence, LookupRow
from .findings import SEVERITIES, Coverage, Finding, Report, SkippedCheck
from .lookups import lookups_of

__all__ = ["CHECKS", "Check", "diagnose_buffer", "diagnose_recording"]


class Check(NamedTuple):
    """One question, and what it takes to answer it: "" (a tree), "raw", "arrival" or "recording"."""

    name: str
    run: Callable[[Evidence], Iterator[Finding]]
    needs: str = ""


CHECKS = (
    Check("leading slashes", names.leading_slashes, "raw"),
    Check("empty names", names.empty_names, "raw"),
    Check("misspelt names", names.misspelt_names),
    Check("slashes in messages", names.slashes_in_messages, "recording"),
    Check("frames that messages name", names.unknown_frames_in_messages, "recording"),
    Check("messages without a frame", names.messages_without_a_frame, "recording"),
    Check("frames that are their own parent", tree.self_transforms, "raw"),
    Check("loops", tree.loops),
    Check("one parent for each child", tree.several_parents),
    Check("one tree", tree.separate_trees),
    Check("the right way up", tree.upside_down),
    Check("numbers", values.not_numbers, "raw"),
    Check("rotations", values.bad_rotations, "raw"),
    Check("optical frames", values.unturned_optical_frames),
    Check("frames of images", values.images_in_body_frames, "recording"),
    Check("mounts in degrees", values.mounts_in_degrees),
    Check("stamps that are not set", stamps.unset_stamps),
    Check("repeated stamps", stamps.repeated_stamps),
    Check("order of stamps", stamps.unordered_stamps, "arrival"),
    Check("stamps in the future", stamps.future_stamps, "arrival"),
    Check("gaps", silence.gaps),
    Check("edges that begin late", silence.late_starts, "arrival"),
    Check("rates", silence.slow_edges),
    Check("stamps in another time", time_bases.other_times, "arrival"),
    Check("offsets of computers", time_bases.other_hosts, "recording"),
    Check("drift of clocks", time_bases.drifting_clocks, "arrival"),
    Check("delays", stamps.odd_delays, "arrival"),
    Check("delays of other messages", stamps.odd_message_delays, "recording"),
    Check("lookups at the stamps of messages", lookups.failing_lookups, "recording"),
    Check("jumps of a clock", clocks.jumping_clocks, "arrival"),
    Check("source of time", clocks.other_time_source, "recording"),
    Check("agreement of clocks", clocks.clock_offset, "arrival"),
    Check("one owner for each transform", owners.several_owners),
    Check("one owner for each static transform", owners.several_static_owners, "arrival"),
    Check("moving or static, not both", owners.owners_of_both_kinds, "raw"),
    Check("static transforms are there", statics.missing_statics, "recording"),
    Check("mounts repeated on /tf", statics.constant_on_tf),
    Check("motions on /tf_static", statics.moving_on_static, "arrival"),
    Check("odometry on /tf_static", statics.odometry_on_static, "recording"),
    Check("latched messages", statics.replaced_latched_messages, "recording"),
    Check("topics without messages", statics.empty_topics, "recording"),
    Check("one owner for each joint", owners.several_joint_publishers, "recording"),
    Check("static transforms for late listeners", statics.volatile_statics, "recording"),
)

AT_ONCE_NS = NSEC_PER_SEC
# what a buffer does not hold, by what a check needs
NEEDS = {
    "arrival": Text(
        "the order and the times of arrival, which a buffer does not keep", "버퍼가 보관하지 않는 도착 순서와 수신 시각"
    ),
    "raw": Text(
        "the transforms as sent, before a buffer corrects or rejects them",
        "버퍼가 고치거나 거절하기 전의, 발행된 그대로의 값",
    ),
    "recording": Text("the other topics, which a buffer does not know", "버퍼에 없는 다른 토픽"),
}


@cache
def effects_of() -> dict[str, dict[str, list[str]]]:
    """Return the effects of each cause: those on the same edge or topic, and those anywhere."""
    return load_yaml(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))


def diagnose_recording(recording: Recording) -> Report:
    """Return what is wrong with the transforms of a recording, in each of its namespaces."""
    unreadable = _unreadable(recording)
    if not recording.namespaces():
        return _report_without_transforms(recording, unreadable)
    findings = list(unreadable)
    rows: list[LookupRow] = []
    for namespace in recording.namespaces():
        evidence = evidence_from_recording(recording, namespace)
        evidence.lookups = lookups_of(evidence)
        rows += evidence.lookups
        grouped = group_by_cause([finding for check in CHECKS for finding in check.run(evidence)])
        findings += [replace(_with_publishers(finding, evidence), namespace=namespace) for finding in grouped]
    made, seen = tuple(check.name for check in CHECKS), _seen(recording)
    findings = list(worst_first(_of_ros(findings, recording)))
    return Report(recording.name, recording.begin_ns, tuple(findings), made, seen=seen, lookups=tuple(rows))


def _with_publishers(finding: Finding, evidence: Evidence) -> Finding:
    """Return a finding with the nodes that publish its edge or topic, where the recording names them."""
    names = [name for edge in evidence.moving if edge.child == finding.child for name in edge.publishers]
    named = names or [c.publisher for c in evidence.connections if c.topic == finding.topic and not finding.child]
    publishers = ", ".join(sorted(filter(None, set(named))))
    has_said_so = not publishers or finding.code == "two-owners"
    return finding if has_said_so else replace(finding, facts={**finding.facts, "publishers": publishers})


def _of_ros(findings: list[Finding], recording: Recording) -> list[Finding]:
    """Return findings as they are in the ROS of a recording: ROS 1 rejects rotations that ROS 2 normalises."""
    if not recording.is_ros1:
        return findings
    ros1 = [replace(finding, is_ros1=True) for finding in findings]
    return [replace(f, severity="error") if f.code == "not-unit-quaternion" else f for f in ros1]


def diagnose_buffer(buffer: BufferCore, name: str = "buffer") -> Report:
    """Return what is wrong with what a buffer holds; it has forgotten much of what a recording tells."""
    evidence = evidence_from_buffer(buffer, name)
    made = [check for check in CHECKS if not check.needs]
    findings = group_by_cause([finding for check in made for finding in check.run(evidence)])
    not_made = tuple(SkippedCheck(check.name, NEEDS[check.needs]) for check in CHECKS if check.needs)
    return Report(name, evidence.begin_ns, worst_first(findings), tuple(check.name for check in made), not_made)


def group_by_cause(findings: list[Finding]) -> list[Finding]:
    """Return the findings that no other explains, each with those that it explains."""
    cause_of = {number: _cause_of(finding, findings) for number, finding in enumerate(findings)}
    effects: dict[int, list[Finding]] = {}
    for number, finding in enumerate(findings):
        cause = first = cause_of[number]
        while cause is not None and cause_of[cause] is not None and cause_of[cause] != first:
            cause = cause_of[cause]
        if cause is not None:
            effects.setdefault(cause, []).append(finding)
    causes = [number for number in range(len(findings)) if cause_of[number] is None]
    grouped = [replace(f, effects=(*f.effects, *effects.get(number, ()))) for number, f in enumerate(findings)]
    return _together([grouped[number] for number in causes])


def _together(findings: list[Finding]) -> list[Finding]:
    """Return the findings with those as one that say the same of several edges at the same time."""
    firsts: dict[tuple, int] = {}
    together: list[Finding] = []
    for finding in findings:
        key = (finding.code, finding.severity, finding.topic)
        first = firsts.get(key)
        if first is not None and _are_at_once(together[first], finding):
            names = dict.fromkeys((*together[first].siblings, finding.child, *finding.siblings))
            siblings = tuple(sorted(names, key=lambda name: name.startswith("/")))  # topics last
            effects = (*together[first].effects, *finding.effects)
            together[first] = replace(together[first], siblings=siblings, effects=effects)
            continue
        if finding.code in effects_of()["of_one_node"]:
            firsts[key] = len(together)
        together.append(finding)
    return together


def _are_at_once(a: Finding, b: Finding) -> bool:
    return abs(a.begin_ns - b.begin_ns) < AT_ONCE_NS and abs(a.end_ns - b.end_ns) < AT_ONCE_NS


def _explains(cause: Finding, effect: Finding) -> bool:
    """Return whether a finding brings another about; what is brief explains only what is as brief."""
    if cause.severity == "info" or cause is effect or cause.namespace != effect.namespace:
        return False
    if cause.code == "stall" and effect.end_ns > cause.end_ns + AT_ONCE_NS:
        return False
    if cause.code == "time-wall" and effect.code == "late-start":  # a localiser waits for a pose that it can use
        return any("initialpose" in subject for subject in _subjects(cause))
    of_lookups = effects_of()["of_anything_on_the_same_edge_or_topic"]
    if effect.code in of_lookups and cause.code not in of_lookups and _subjects(cause) & {effect.child, effect.topic}:
        return True
    on_child = _subjects(cause) & _subjects(effect) and effect.code in effects_of()["on_the_same_edge_or_topic"].get(
        cause.code, ()
    )
    return bool(on_child) or effect.code in effects_of()["anywhere"].get(cause.code, ())


def _subjects(finding: Finding) -> set[str]:
    """Return the children, or the topics, that a finding is about."""
    return {finding.child or finding.topic, *finding.siblings}


def _cause_of(effect: Finding, findings: list[Finding]) -> int | None:
    """Return the number of the first finding that explains another."""
    return next((number for number, cause in enumerate(findings) if _explains(cause, effect)), None)


def worst_first(findings: list[Finding]) -> tuple[Finding, ...]:
    """Return findings by severity; among equals the order of the checks stays."""
    return tuple(sorted(findings, key=lambda finding: SEVERITIES.index(finding.severity)))


def _seen(recording: Recording) -> Coverage:
    """Return how much there was to look at; a frame counts once in each namespace."""
    labels = recording.transforms.labels
    frames = {(namespace_of(label.topic), frame) for label in labels for frame in (label.parent, label.child)}
    messages = sum(len(header.stamp_ns) for header in recording.headers)
    duration_s = (recording.end_ns - recording.begin_ns) / NSEC_PER_SEC
    return Coverage(len(frames), len(recording.transforms.label), messages, duration_s)


def _unreadable(recording: Recording) -> list[Finding]:
    """Return a finding for each topic of which messages could not be read; an error if it should hold transforms.

    What a killed recorder has left is told, too.
    """
    kinds = {connection.topic: connection.msgtype for connection in recording.connections}
    findings = []
    if recording.unfinished:
        severity = "warning" if recording.unfinished.is_cut else "info"
        facts = {"what": recording.unfinished.what, "remedy": recording.unfinished.remedy}
        findings.append(Finding(recording.unfinished.code, severity, facts=facts))
    for note in recording.notes:
        topic = next((topic for topic in kinds if f"on {topic} " in note), "")
        severity = "error" if kinds.get(topic, "").endswith(("TFMessage", "tfMessage")) else "info"
        findings.append(Finding("unreadable", severity, topic=topic, facts={"note": note}))
    return findings


def _report_without_transforms(recording: Recording, unreadable: list[Finding]) -> Report:
    names = sorted({connection.topic for connection in recording.connections})
    is_there = [name for name in names if name.rpartition("/")[2] in ("tf", "tf_static")]
    what = Text("/tf and /tf_static were not recorded.", "/tf와 /tf_static이 기록되지 않았습니다.")
    if is_there:
        topics = ", ".join(is_there)
        what = Text(f"In {topics} there are none.", f"다음 토픽에는 변환이 없습니다: {topics}.")
    facts = {"topics": ", ".join(names) or Text("nothing", "없음"), "what": what}
    findings = worst_first(_of_ros([*unreadable, Finding("no-transforms", "error", facts=facts)], recording))
    not_made = tuple(SkippedCheck(check.name, Text("transforms", "변환")) for check in CHECKS)
    return Report(recording.name, recording.begin_ns, findings, (), not_made)
