"""Read and write expectations (rates, delays, owners, mounts), and report how a recording deviates from them.

    tflab doctor good_drive --write-expectations robot.toml
    tflab doctor today --expect robot.toml

    [edges."odom -> base_link"]
    rate_hz = [15.9, 23.8]         least and most
    largest_delay_s = 0.1
    longest_silence_s = 0.5
    owners = ["/wheel_odometry"]   only where the recording has them

    [lookups]
    "/scan -> map" = [0.1, 0.99]   after 0.1 s, at least 99 % of the messages can be looked up in map

What is not in the file is not checked. Each deviation is a finding like the others. Two recordings are compared by
the same means: the first one is the expectation of the second.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from tflab.text import Text

from ..checks.lookups import text_of_shares
from ..checks.motion import distances
from ..findings import Finding, Severity
from ..lookups import WAITS_S
from ..profile import EdgeProfile, RecordingProfile, name_of

__all__ = ["ExpectationError", "Expectations", "ExpectedEdge", "changes_between", "deviations_from",
           "expectations_from", "read_expectations", "toml_from"]  # fmt: skip

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


RATE_SLACK = 0.2  # of the rate
DELAY_SLACK = 2.0  # times the 95th percentile ...
LEAST_DELAY_S = 0.05  # ... but not less
SILENCE_SLACK = 2.0
LEAST_SILENCE_S = 0.25
MOUNT_TOLERANCE_M = 0.001
LOOKUP_SLACK = 0.1  # of the share
LEAST_SHARE = 0.5  # of the messages, from which on lookups are expected to work

HEAD = """\
# What a good recording of this robot looks like, for `tflab doctor --expect`.
# Edit freely: what is not written is not asked.

# Edges that are not written here: may they be there?
other_edges = true

# Findings that are let pass, as for --ignore: "CODE" or "CODE:WHERE".
ignore = []
"""
FORMS: dict[str, Callable] = {  # how a file holds what is asked of an edge
    "static": lambda value: str(value).lower(),
    "rate_hz": lambda value: f"[{value[0]:.1f}, {value[1]:.1f}]",
    "largest_delay_s": "{:.3f}".format,
    "longest_silence_s": "{:.2f}".format,
    "owners": lambda value: json.dumps(list(value), ensure_ascii=False),
    "mount": lambda value: f"[{', '.join(f'{number + 0.0:.6f}' for number in value)}]",
}
KEYS = (*FORMS, "mount_tolerance_m")


class ExpectationError(ValueError):
    """A file of expectations cannot be used; the text is one line that says why."""


@dataclass(frozen=True)
class ExpectedEdge:
    """What is asked of one edge; None is not asked."""

    parent: str
    child: str
    static: bool | None = None
    rate_hz: tuple[float, float] | None = None
    largest_delay_s: float | None = None
    longest_silence_s: float | None = None
    owners: tuple[str, ...] | None = None
    mount: tuple[float, ...] | None = None
    mount_tolerance_m: float = MOUNT_TOLERANCE_M
    namespace: str = ""


@dataclass(frozen=True)
class Expectations:
    """What is asked of a recording.

    Attributes:
        frames_of: the frames that the messages of a topic may be in.
        lookups: wait [s] and least share of "topic -> fixed frame".
        other_edges: whether edges may be there that are not named.
        ignore: findings that are let pass.
    """

    edges: tuple[ExpectedEdge, ...] = ()
    frames_of: dict[str, tuple[str, ...]] = field(default_factory=dict)
    other_edges: bool = True
    ignore: tuple[str, ...] = ()
    lookups: dict[str, tuple[float, float]] = field(default_factory=dict)


def expectations_from(profile: RecordingProfile, other_edges: bool = True) -> Expectations:
    """Return what is to be expected of recordings that are like this one, with some slack."""
    edges = []
    for edge in profile.edges:
        owners = edge.owners or None
        who = {"owners": owners, "namespace": edge.namespace}
        if edge.is_static:
            edges.append(ExpectedEdge(edge.parent, edge.child, True, mount=edge.mount or None, **who))
            continue
        rate_hz = (edge.rate_hz * (1.0 - RATE_SLACK), edge.rate_hz * (1.0 + RATE_SLACK)) if edge.rate_hz else None
        delay_s = max(DELAY_SLACK * edge.delay_s[1], LEAST_DELAY_S)
        silence_s = max(SILENCE_SLACK * edge.silence_s, LEAST_SILENCE_S)
        edges.append(ExpectedEdge(edge.parent, edge.child, False, rate_hz, delay_s, silence_s, **who))
    lookups = {}
    for row in profile.lookups:
        most = row.shares[-1]
        if most >= LEAST_SHARE:
            wait_s = next(wait_s for wait_s, share in zip(WAITS_S, row.shares, strict=True) if share > most - 0.02)
            lookups[f"{row.topic} -> {row.fixed}"] = (wait_s, round(most - LOOKUP_SLACK, 2))
    return Expectations(tuple(edges), dict(profile.frames_of), other_edges, lookups=lookups)


def toml_from(expectations: Expectations) -> str:
    """Return the file."""
    lines = [HEAD]
    for edge in expectations.edges:
        lines.append(f"[edges.{json.dumps(name_of(edge.namespace, edge.parent, edge.child), ensure_ascii=False)}]")
        for key, form in FORMS.items():
            value = getattr(edge, key)
            lines += [f"{key} = {form(value)}"] if value is not None else []
        lines.append("")
    frames = {topic: list(names) for topic, names in sorted(expectations.frames_of.items())}
    lookups = {name: list(asked) for name, asked in expectations.lookups.items()}
    for head, table in (("[frames]", frames), ("[lookups]  # wait [s], least share", lookups)):
        rows = [f"{json.dumps(key, ensure_ascii=False)} = {json.dumps(values, ensure_ascii=False)}"
                for key, values in table.items()]  # fmt: skip
        lines += [head, *rows, ""] if rows else []
    return "\n".join(lines)


def read_expectations(path: str | Path) -> Expectations:
    """Return what a file expects.

    Raises:
        ExpectationError: it is not there, is not TOML, or says something unknown.
    """
    try:
        data = tomllib.loads(Path(path).read_text(encoding="utf-8"))
    except OSError as error:
        raise ExpectationError(f"{path}: cannot be read ({error.strerror})") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ExpectationError(f"{path}: not TOML ({error})") from None
    unknown = set(data) - {"edges", "frames", "lookups", "other_edges", "ignore"}
    if unknown:
        raise ExpectationError(
            f"{path}: unknown: {', '.join(sorted(unknown))}; known: edges, frames, lookups, other_edges, ignore"
        )
    edges = tuple(_edge_of(path, name, asked) for name, asked in _table(path, data, "edges").items())
    frames = _table(path, data, "frames")
    wrong = [topic for topic, names in frames.items() if not _is_words(names)]
    if wrong or not _is_words(data.get("ignore", [])):
        raise ExpectationError(f'{path}: {wrong[0] if wrong else "ignore"}: expected a list of words, as ["a", "b"]')
    lookups = {name: _lookup_of(path, name, asked) for name, asked in _table(path, data, "lookups").items()}
    frames_of = {topic: tuple(names) for topic, names in frames.items()}
    return Expectations(edges, frames_of, data.get("other_edges", True) is True, tuple(data.get("ignore", ())), lookups)


def _lookup_of(path: str | Path, name: str, asked: object) -> tuple[float, float]:
    is_pair = isinstance(asked, list) and len(asked) == 2 and all(map(_is_number, asked))
    if not is_pair or asked[0] not in WAITS_S or not 0.0 <= asked[1] <= 1.0 or " -> " not in name:
        waits = ", ".join(f"{wait_s:g}" for wait_s in WAITS_S)
        raise ExpectationError(
            f'{path}: lookups."{name}": expected "topic -> frame" = [wait, share]; wait: {waits}; share: 0 to 1'
        )
    return float(asked[0]), float(asked[1])


def _edge_of(path: str | Path, name: str, asked: object) -> ExpectedEdge:
    namespace, colon, edge = name.partition(": ") if name.startswith("/") else ("", "", name)
    namespace, edge = (namespace, edge) if colon else ("", name)
    parent, arrow, child = edge.partition(" -> ")
    if not (arrow and parent and child) or not isinstance(asked, dict):
        raise ExpectationError(f'{path}: edges."{name}": expected a table named "parent -> child"')
    for key, value in asked.items():
        if key not in KEYS:
            raise ExpectationError(f'{path}: edges."{name}".{key}: unknown; known: {", ".join(KEYS)}')
        if not _is_of_kind(key, value):
            raise ExpectationError(
                f'{path}: edges."{name}".{key}: {value!r} is not what it should be; see docs/doctor.md'
            )
    values = {key: tuple(value) if isinstance(value, list) else value for key, value in asked.items()}
    return ExpectedEdge(parent, child, namespace=namespace, **values)


def _is_of_kind(key: str, value: object) -> bool:
    """Return whether a value is of the kind, and of the length, that a key asks for."""
    if key == "owners":
        return _is_words(value)
    if key in ("rate_hz", "mount"):
        length = 2 if key == "rate_hz" else 7
        return isinstance(value, list) and len(value) == length and all(map(_is_number, value))
    return isinstance(value, bool) if key == "static" else _is_number(value)


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _is_words(value: object) -> bool:
    return isinstance(value, list) and all(isinstance(word, str) for word in value)


def _table(path: str | Path, data: dict, name: str) -> dict:
    table = data.get(name, {})
    if not isinstance(table, dict):
        raise ExpectationError(f"{path}: {name}: expected a table, [{name}...]")
    return table


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
        named = {name_of(edge.namespace, edge.parent, edge.child) for edge in expectations.edges}
        for edge in profile.edges:
            place = (edge.parent, edge.child, edge.topic)
            if edge.name not in named:
                facts: dict[str, object] = {"count": edge.count}
                findings.append(Finding("unexpected-edge", "warning", *place, facts=facts, namespace=edge.namespace))
    return [*findings, *_of_topics(expectations, profile), *_of_lookups(expectations, profile)]


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
        asked = Text(f"{least:.1f} to {most:.1f} Hz", f"{least:.1f}~{most:.1f} Hz")
        yield _deviation("expected-rate", "warning", edge, asked, f"{edge.rate_hz:.1f} Hz")
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


def _of_lookups(expectations: Expectations, profile: RecordingProfile) -> Iterator[Finding]:
    rows = {f"{row.topic} -> {row.fixed}": row for row in profile.lookups}
    for name, (wait_s, least) in expectations.lookups.items():
        topic, _, fixed = name.partition(" -> ")
        row = rows.get(name)
        share = row.shares[WAITS_S.index(wait_s)] if row else 0.0
        if share < least and (row or topic in profile.frames_of):
            asked = f"{100.0 * least:.0f} %"
            expected = Text(f"{asked} or more after {wait_s:g} s", f"{wait_s:g} s 뒤 {asked} 이상")
            instead = text_of_shares(row) if row else Text("no lookup", "조회할 수 없음")
            facts = {"fixed": fixed, "expected": expected, "instead": instead}
            edge = (row.parent, row.child) if row else ("", "")
            yield Finding("expected-lookup", "warning", *edge, topic, facts=facts)


def _at_most(limit: str) -> Text:
    return Text(f"{limit} at most", f"최대 {limit}")


def _deviation(code: str, severity: Severity, edge: EdgeProfile, expected: Text | str, instead: Text | str) -> Finding:
    facts = {"expected": expected, "instead": instead}
    return Finding(code, severity, edge.parent, edge.child, edge.topic, facts=facts)


def _kind(is_static: bool) -> Text:
    return Text("static", "정적 변환") if is_static else Text("moving", "동적 변환")
