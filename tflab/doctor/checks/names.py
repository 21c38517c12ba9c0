"""Are the names right?  Question 1: a name that nobody else uses is usually misspelt.

    /laser            tf2 has no leading slashes
    Base_link         somebody else says base_link
    robot1/base_link  everybody else says base_link
    odm               nobody else says odm, but odom hangs in the air

A prefix alone is no fault: two robots have two of everything.  What counts is a
name that differs from another *and* leaves somebody unconnected.

Read `tree.py` next.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from difflib import SequenceMatcher

from ..evidence import Evidence
from ..findings import Finding

__all__ = ["empty_names", "leading_slashes", "misspelt_names", "unknown_frames_in_messages"]

ALIKE = 0.75  # of difflib's measure, for a misspelling
SPATIAL = re.compile(
    r"LaserScan|PointCloud|Image|CameraInfo|Imu|Range|Odometry|Path|Grid|geometry_msgs|Detection|Marker"
)
STANDARD = ("earth", "map", "odom", "base_link", "base_footprint", "world")  # REP-105, and what is usual beside it
ROBOT_FRAMES = 3  # a prefix that so many frames share, in a tree of their own, is a robot


def leading_slashes(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each topic on which names were sent with a leading slash."""
    edges_of: dict[str, list[tuple[str, str]]] = {}
    for parent, child, topic in evidence.raw_names:
        if parent.startswith("/") or child.startswith("/"):
            edges_of.setdefault(topic, []).append((parent, child))
    for topic, edges in edges_of.items():
        names = sorted({name for edge in edges for name in edge if name.startswith("/")})
        facts = {"names": ", ".join(names), "bare": ", ".join(name[1:] for name in names)}
        yield Finding("leading-slash", "warning", *edges[0], topic, facts=facts)


def empty_names(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each edge with an empty name at one end."""
    for parent, child, topic in evidence.raw_names:
        if not parent.removeprefix("/") or not child.removeprefix("/"):
            yield Finding("empty-name", "error", parent, child, topic)


def misspelt_names(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each frame whose name is another's, but for case, prefix or a slip."""
    frames = sorted(evidence.frames | _alternative_parents(evidence))
    named_by_messages = _frames_in_messages(evidence)
    for name in frames:
        if name not in evidence.frames | _alternative_parents(evidence):
            continue
        for other in sorted({*frames, *named_by_messages} - {name}):
            kind = _likeness(evidence, name, other)
            if kind and _is_the_wrong_one(evidence, name, other, kind):
                parent, child, topic = next(
                    raw for raw in evidence.raw_names if name in (raw[0].removeprefix("/"), raw[1].removeprefix("/"))
                )
                facts = {"name": name, "other": other}
                yield Finding(f"name-{kind}", "error", parent, child, topic, facts=facts)
                break


def unknown_frames_in_messages(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each frame that messages name and nobody publishes."""
    if not evidence.frames:
        return
    for header in evidence.headers:
        for frame in header.frames:
            bare = frame.removeprefix("/")
            if frame.startswith("/") and bare in evidence.frames:
                facts = {"name": frame, "bare": bare, "topic": header.topic}
                yield Finding("message-slash", "warning", topic=header.topic, facts=facts)
            elif bare and bare not in evidence.frames:
                count = int((header.frame == header.frames.index(frame)).sum())
                severity = "warning" if SPATIAL.search(header.msgtype) else "info"
                facts = {"name": frame, "topic": header.topic, "count": count}
                yield Finding("unknown-frame", severity, topic=header.topic, facts=facts)


def _likeness(evidence: Evidence, name: str, other: str) -> str:
    """Return how two names are alike: "case", "prefix", "slip" or ""."""
    if _folded(name) == _folded(other):
        return "case"
    if name.rpartition("/")[2] == other.rpartition("/")[2] and ("/" in name) != ("/" in other):
        return "prefix"
    if (
        name[:1] == other[:1]
        and _digits(name) == _digits(other)
        and SequenceMatcher(None, name, other).ratio() >= ALIKE
    ):
        return "slip"
    return ""


def _is_the_wrong_one(evidence: Evidence, name: str, other: str, kind: str) -> bool:
    """Return whether `name` is the one that should be `other`."""
    if kind == "case":
        return _weight(evidence, name) < _weight(evidence, other)
    if kind == "prefix":
        hangs = name not in evidence.parent_of and other in evidence.parent_of  # a whole robot with a wrong prefix
        is_stranger = not _is_a_robot(evidence, name) and not _is_a_robot(evidence, other)
        return hangs or (is_stranger and _weight(evidence, name) < _weight(evidence, other))
    # A slip must leave something unconnected: many pairs of honest names are alike.
    if other not in evidence.frames:
        return name not in _frames_in_messages(evidence) and _is_leaf(evidence, name)
    if name in evidence.parent_of and other in evidence.parent_of:
        return False
    apart = evidence.root_of(name) != evidence.root_of(other) or name not in evidence.frames
    hangs = name not in evidence.parent_of or other not in evidence.parent_of
    return apart and hangs and _weight(evidence, name) < _weight(evidence, other)


def _weight(evidence: Evidence, name: str) -> tuple:
    """Return how much speaks for a name; of two equal ones the later in the alphabet is suspected."""
    samples = links = 0
    for edge in evidence.edges():
        for number, parent in enumerate(edge.parents):
            if name in (edge.child, parent):
                links += 1
                samples += int((edge.parent == number).sum())
    said = name in _frames_in_messages(evidence)
    neat = name == name.lower()
    return (
        said,
        name.rpartition("/")[2] in STANDARD,
        links,
        neat,
        "/" not in name,
        samples,
        [-ord(letter) for letter in name],
    )


def _is_a_robot(evidence: Evidence, name: str) -> bool:
    """Return whether the prefix of a name is that of a whole robot: its frames hang together, without strangers."""
    prefix, slash, _ = name.rpartition("/")
    if not slash:
        return False
    own = [frame for frame in evidence.frames if frame.startswith(prefix + "/")]
    below = [child for child, parent in evidence.parent_of.items() if parent in own]
    return len(own) >= ROBOT_FRAMES and all(child in own for child in below)


def _alternative_parents(evidence: Evidence) -> set[str]:
    """Return every parent that any sample named, also those that are not the usual ones."""
    return {parent for edge in evidence.edges() for parent in edge.parents if parent}


def _frames_in_messages(evidence: Evidence) -> set[str]:
    return {frame.removeprefix("/") for header in evidence.headers for frame in header.frames if frame}


def _is_leaf(evidence: Evidence, name: str) -> bool:
    return name in evidence.parent_of and name not in evidence.parent_of.values()


def _folded(name: str) -> str:
    """Return a name without case and without the characters that people put between words."""
    return "".join(letter for letter in name.lower() if letter.isalnum() or letter == "/")


def _digits(name: str) -> list[str]:
    return [letter for letter in name if letter.isdigit()]
