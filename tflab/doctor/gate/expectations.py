"""What does a good recording look like?  A small file, written from one and then edited by hand.

    tflab doctor good_drive --write-expectations robot.toml
    tflab doctor today --expect robot.toml

    [edges."odom -> base_link"]
    rate_hz = [15.9, 23.8]         least and most
    largest_delay_s = 0.1
    longest_silence_s = 0.5
    owners = ["/wheel_odometry"]   only where the recording tells

Whatever is not written is not asked.  The form is TOML.
"""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass, field
from pathlib import Path

from ..profile import RecordingProfile, name_of

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

__all__ = ["ExpectationError", "Expectations", "ExpectedEdge", "expectations_from", "read_expectations", "toml_from"]

RATE_SLACK = 0.2  # of the rate
DELAY_SLACK = 2.0  # times the 95th percentile ...
LEAST_DELAY_S = 0.05  # ... but not less
SILENCE_SLACK = 2.0
LEAST_SILENCE_S = 0.25
MOUNT_TOLERANCE_M = 0.001

HEAD = """\
# What a good recording of this robot looks like, for `tflab doctor --expect`.
# Edit freely: what is not written is not asked.

# Edges that are not written here: may they be there?
other_edges = true

# Findings that are let pass, as for --ignore: "CODE" or "CODE:WHERE".
ignore = []
"""
KEYS = {
    "static": bool,
    "rate_hz": list,
    "largest_delay_s": float,
    "longest_silence_s": float,
    "owners": list,
    "mount": list,
    "mount_tolerance_m": float,
}


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
        other_edges: whether edges may be there that are not named.
        ignore: findings that are let pass.
    """

    edges: tuple[ExpectedEdge, ...] = ()
    frames_of: dict[str, tuple[str, ...]] = field(default_factory=dict)
    other_edges: bool = True
    ignore: tuple[str, ...] = ()


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
    return Expectations(tuple(edges), dict(profile.frames_of), other_edges)


def toml_from(expectations: Expectations) -> str:
    """Return the file."""
    lines = [HEAD]
    for edge in expectations.edges:
        lines.append(f"[edges.{json.dumps(name_of(edge.namespace, edge.parent, edge.child), ensure_ascii=False)}]")
        if edge.static is not None:
            lines.append(f"static = {str(edge.static).lower()}")
        if edge.rate_hz is not None:
            lines.append(f"rate_hz = [{edge.rate_hz[0]:.1f}, {edge.rate_hz[1]:.1f}]")
        if edge.largest_delay_s is not None:
            lines.append(f"largest_delay_s = {edge.largest_delay_s:.3f}")
        if edge.longest_silence_s is not None:
            lines.append(f"longest_silence_s = {edge.longest_silence_s:.2f}")
        if edge.owners is not None:
            lines.append(f"owners = {json.dumps(list(edge.owners), ensure_ascii=False)}")
        if edge.mount is not None:
            lines.append(f"mount = [{', '.join(f'{value + 0.0:.6f}' for value in edge.mount)}]")
        lines.append("")
    if expectations.frames_of:
        lines.append("[frames]")
        for topic, frames in sorted(expectations.frames_of.items()):
            lines.append(f"{json.dumps(topic, ensure_ascii=False)} = {json.dumps(list(frames), ensure_ascii=False)}")
        lines.append("")
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
    unknown = set(data) - {"edges", "frames", "other_edges", "ignore"}
    if unknown:
        raise ExpectationError(
            f"{path}: unknown: {', '.join(sorted(unknown))}; known: edges, frames, other_edges, ignore"
        )
    edges = tuple(_edge_of(path, name, asked) for name, asked in _table(path, data, "edges").items())
    frames = _table(path, data, "frames")
    wrong = [topic for topic, names in frames.items() if not _is_words(names)]
    if wrong or not _is_words(data.get("ignore", [])):
        raise ExpectationError(f'{path}: {wrong[0] if wrong else "ignore"}: expected a list of words, as ["a", "b"]')
    frames_of = {topic: tuple(names) for topic, names in frames.items()}
    return Expectations(edges, frames_of, data.get("other_edges", True) is True, tuple(data.get("ignore", ())))


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
    return isinstance(value, bool) if KEYS[key] is bool else _is_number(value)


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _is_words(value: object) -> bool:
    return isinstance(value, list) and all(isinstance(word, str) for word in value)


def _table(path: str | Path, data: dict, name: str) -> dict:
    table = data.get(name, {})
    if not isinstance(table, dict):
        raise ExpectationError(f"{path}: {name}: expected a table, [{name}...]")
    return table
