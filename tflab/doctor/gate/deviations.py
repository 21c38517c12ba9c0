"""Where is a recording not as expected?  Each deviation is a finding like the others.

    expected  odom -> base_link   15.9 to 23.8 Hz
    is        odom -> base_link    9.9 Hz             expected-rate

Two recordings are compared by the same means: what the first shows is expected of
the second, and what is said of a deviation is what changed.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from tflab.text import Text

from ..checks.motion import distances
from ..findings import Finding, Severity
from ..profile import EdgeProfile, RecordingProfile
from .expectations import Expectations, ExpectedEdge, expectations_from

__all__ = ["changes_between", "deviations_from"]


def deviations_from(expectations: Expectations, profile: RecordingProfile) -> list[Finding]:
    """Return a finding for each thing in a recording that is not as expected."""
    by_child: dict[tuple[str, str], list[EdgeProfile]] = {}
    for edge in profile.edges:
        by_child.setdefault((edge.namespace, edge.child), []).append(edge)
    findings = [
        replace(finding, namespace=expected.namespace)
        for expected in expectations.edges
        for finding in _of_edge(expected, by_child.get((expected.namespace, expected.child), []))
    ]
    if not expectations.other_edges:
        named = {(edge.namespace, edge.parent, edge.child) for edge in expectations.edges}
        findings += [
            Finding(
                "unexpected-edge",
                "warning",
                edge.parent,
                edge.child,
                edge.topic,
                facts={"count": edge.count},
                namespace=edge.namespace,
            )
            for edge in profile.edges
            if (edge.namespace, edge.parent, edge.child) not in named
        ]
    return [*findings, *_of_topics(expectations, profile)]


def changes_between(before: RecordingProfile, after: RecordingProfile) -> list[Finding]:
    """Return what is not in one recording as it was in another."""
    return deviations_from(expectations_from(before, other_edges=False), after)


def _of_edge(expected: ExpectedEdge, candidates: list[EdgeProfile]) -> Iterator[Finding]:
    is_there = [edge for edge in candidates if edge.parent == expected.parent]
    if not is_there:
        others = ", ".join(edge.parent for edge in candidates)
        instead = Text(f'nobody publishes "{expected.child}"', f'"{expected.child}" 좌표계를 발행하는 노드가 없습니다')
        if others:
            instead = Text(f'"{expected.child}" hangs under {others}', f'"{expected.child}"의 부모가 {others}입니다')
        yield Finding("expected-edge", "error", expected.parent, expected.child, facts={"instead": instead})
        return
    of_kind = [edge for edge in is_there if edge.is_static == expected.static]
    edge = (of_kind or is_there)[0]
    if expected.static is not None and not of_kind:
        yield _deviation("expected-kind", "error", edge, _kind(expected.static), _kind(edge.is_static))
    yield from _of_figures(expected, edge)
    yield from _of_who_and_where(expected, edge)


def _of_who_and_where(expected: ExpectedEdge, edge: EdgeProfile) -> Iterator[Finding]:
    if expected.owners is not None and edge.owners and set(edge.owners) != set(expected.owners):
        yield _deviation("expected-owners", "error", edge, ", ".join(expected.owners), ", ".join(edge.owners))
    if expected.mount is not None and edge.mount:
        apart_m = float(distances(np.array([expected.mount]), np.array([edge.mount]))[0])
        if apart_m > expected.mount_tolerance_m:
            before, now = (" ".join(f"{v + 0.0:.3f}" for v in mount) for mount in (expected.mount, edge.mount))
            apart = f"{now}, {apart_m:.4f} m"
            instead = Text(f"{apart} from there", f"{apart} 떨어져 있음")
            yield _deviation("expected-mount", "error", edge, before, instead)


def _of_figures(expected: ExpectedEdge, edge: EdgeProfile) -> Iterator[Finding]:
    if edge.is_static:
        return
    if expected.rate_hz is not None and not expected.rate_hz[0] <= edge.rate_hz <= expected.rate_hz[1]:
        least, most = expected.rate_hz
        yield _deviation(
            "expected-rate",
            "warning",
            edge,
            Text(f"{least:.1f} to {most:.1f} Hz", f"{least:.1f}~{most:.1f} Hz"),
            f"{edge.rate_hz:.1f} Hz",
        )
    if expected.largest_delay_s is not None and edge.delay_s[1] > expected.largest_delay_s:
        late = f"{edge.delay_s[1]:.3f} s"
        is_now = Text(f"{late} (95 % of the samples are less late)", f"{late} (표본의 95 %는 이보다 작음)")
        yield _deviation("expected-delay", "warning", edge, _at_most(f"{expected.largest_delay_s:.3f} s"), is_now)
    if expected.longest_silence_s is not None and edge.silence_s > expected.longest_silence_s:
        is_now = f"{edge.silence_s:.2f} s"
        yield _deviation("expected-silence", "warning", edge, _at_most(f"{expected.longest_silence_s:.2f} s"), is_now)


def _of_topics(expectations: Expectations, profile: RecordingProfile) -> Iterator[Finding]:
    for topic, expected in sorted(expectations.frames_of.items()):
        frames = profile.frames_of.get(topic)
        if frames is None:
            yield Finding("expected-topic", "warning", topic=topic)
        elif not set(frames) <= set(expected):
            facts = {"expected": ", ".join(expected), "instead": ", ".join(frames)}
            yield Finding("expected-frame", "error", topic=topic, facts=facts)


def _at_most(limit: str) -> Text:
    return Text(f"{limit} at most", f"최대 {limit}")


def _deviation(code: str, severity: Severity, edge: EdgeProfile, expected: Text | str, instead: Text | str) -> Finding:
    facts = {"expected": expected, "instead": instead}
    return Finding(code, severity, edge.parent, edge.child, edge.topic, facts=facts)


def _kind(is_static: bool) -> Text:
    return Text("static", "정적 변환") if is_static else Text("moving", "동적 변환")
