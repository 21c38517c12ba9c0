"""Check the names of frames: misspelt, empty, with a leading slash, or unknown to the tree.

    /laser            -              tf2 has no leading slashes
    Base_link         base_link      case     the same letters
    robot1/base_link  base_link      prefix   the same last word
    odm               odom           slip     one letter more, less, other, or two exchanged
    left_wheel        right_wheel    -        sides and numbers tell honest names apart

A slip is a Damerau-Levenshtein distance of one, of two in long names. A prefix alone is no fault: two robots have
two of everything. What counts is a name that differs from another *and* leaves a frame unconnected.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from tflab.bags.recording import Headers
from tflab.text import Text

from ..evidence import Evidence
from ..findings import Finding, first_of

__all__ = ["are_confusable", "differ_in_side", "empty_names", "endings_of", "is_misspelling", "leading_slashes",
           "letters_of", "messages_without_a_frame", "misspelt_names", "name_similarity", "prefix_of",
           "slashes_in_messages", "unknown_frames_in_messages"]  # fmt: skip

LONG_NAME = 12  # letters, from which on two slips are one misspelling
SIDES = {"left", "right", "front", "rear", "back", "upper", "lower", "top", "bottom", "inner", "outer",
         "master", "slave"}  # fmt: skip
SHORT_WORD = 2  # letters: l, r, fl, x, ... tell honest names apart


def name_similarity(name: str, other: str) -> str:
    """Return how `name` is like `other`, but for a slip: "case", "prefix" or ""."""
    if letters_of(name) == letters_of(other):
        return "case"
    if name.rpartition("/")[2] == other.rpartition("/")[2] and ("/" in name) != ("/" in other):
        return "prefix"
    if name.endswith("_" + other) and not {*re.split(r"[_/\d]+", name[: -len(other)])} & SIDES:
        return "prefix"
    return ""


def are_confusable(name: str, other: str) -> bool:
    """Return whether somebody may have written one name for the other: also laser for laser_frame."""
    longer, shorter = (name, other) if len(name) > len(other) else (other, name)
    return bool(name_similarity(longer, shorter)) or longer.startswith(f"{shorter}_") or is_misspelling(name, other)


def letters_of(name: str) -> str:
    """Return a name without case and without the characters that people put between words."""
    return "".join(letter for letter in name.lower() if letter.isalnum() or letter == "/")


def endings_of(name: str) -> list[str]:
    """Return what is left of a name without its first words: "base_link" and "link" of "r1/base_link"."""
    return [name[match.end() :] for match in re.finditer(r"[_/]", name)]


def prefix_of(name: str, other: str) -> str:
    """Return what one of two names has before the other."""
    longer, shorter = (name, other) if len(name) > len(other) else (other, name)
    return longer[: len(longer) - len(shorter)]


def differ_in_side(name: str, other: str) -> bool:
    """Return whether one of two names has a side that the other has not: parts of one robot have."""
    return bool(({*_words(name)} ^ {*_words(other)}) & SIDES)


def is_misspelling(name: str, other: str) -> bool:
    """Return whether one name is probably the other, misspelt."""
    most = 1 if min(len(name), len(other)) <= LONG_NAME else 2
    if abs(len(name) - len(other)) > most or name[:1] != other[:1] or _digits(name) != _digits(other):
        return False
    return not _differ_as_honest_names_do(name, other) and _distance(name, other) <= most


def _differ_as_honest_names_do(name: str, other: str) -> bool:
    """Return whether the words in which two names differ are sides, or too short to tell."""
    words, others = _words(name), _words(other)
    if len(words) != len(others):
        return False
    pairs = [(a, b) for a, b in zip(words, others, strict=True) if a != b]
    return any({a, b} <= SIDES or max(len(a), len(b)) <= SHORT_WORD for a, b in pairs)


def _distance(a: str, b: str) -> int:
    """Return how many letters to add, drop, change or exchange with their neighbour to make one word of the other."""
    before: list[int] = []
    last = list(range(len(b) + 1))
    for i, x in enumerate(a, 1):
        here = [i]
        for j, y in enumerate(b, 1):
            cost = min(last[j] + 1, here[j - 1] + 1, last[j - 1] + (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and a[i - 2] == y:
                cost = min(cost, before[j - 2] + 1)
            here.append(cost)
        before, last = last, here
    return last[-1]


def _words(name: str) -> list[str]:
    return [word.strip("0123456789") for word in re.split(r"[_/\-.]+", name.lower())]


def _digits(name: str) -> list[str]:
    return [letter for letter in name if letter.isdigit()]


SPATIAL = re.compile(
    r"LaserScan|PointCloud|Image|CameraInfo|Imu|Range|Odometry|Path|Grid|geometry_msgs|Detection|Marker"
)
NO_PLACE = re.compile(r"Twist|Wrench|Accel")  # drivers and controllers leave their frame_id empty as a rule
OF_THE_WORLD = re.compile(r"Odometry|Path|Grid|PoseWithCovariance|PoseArray")
STANDARD = ("earth", "map", "odom", "base_link", "base_footprint", "world")  # REP-105, and what is usual beside it
ROBOT_FRAMES = 3  # a prefix that so many frames share, in a tree of their own, is a robot
MOST_NAMES = 8  # that are told
MOST_EDGES = 4  # in which a wrong name is said, that are told
MOST_ROOTS = 40  # with more, it is not a slip


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
    """Yield a finding for each frame whose name is another's, but for case, prefix or a slip.

    Frames that got the same wrong prefix are one finding.
    """
    said = set()
    with_prefix: dict[str, list[tuple[str, str]]] = {}
    for name, other, kind in _pairs_alike(evidence):
        if name in said or not _is_the_wrong_one(evidence, name, other, kind):
            continue
        said.add(name)
        if kind == "prefix":
            with_prefix.setdefault(prefix_of(name, other), []).append((name, other))
            continue
        hanging = name if name not in evidence.parent_of else other
        yield _finding_of(evidence, f"name-{kind}", name, {"name": name, "other": other, "hanging": hanging})
    for prefix, pairs in with_prefix.items():
        name, other = pairs[0]
        names = list(dict.fromkeys(name for pair in pairs for name in pair if name.startswith(prefix)))
        without = [frame for frame in evidence.frames if not frame.startswith(prefix)]
        is_odd = 2 * len(without) > len(
            evidence.frames
        )  # then most are without the prefix, and those with it stand out
        facts = {"name": name, "other": other, "prefix": prefix, "names": first_of(names, MOST_NAMES),
                 "with": len(evidence.frames) - len(without), "without": len(without)}  # fmt: skip
        odd = (n for n in pairs[0] if n.startswith(prefix) == is_odd and n in evidence.frames)
        yield _finding_of(evidence, "name-prefix", next(odd, name), facts)


def slashes_in_messages(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each frame that messages name with a slash, and the tree has without."""
    for header in evidence.headers:
        for frame in header.frames:
            bare = frame.removeprefix("/")
            if frame.startswith("/") and bare in evidence.frames | evidence.all_parents:
                facts = {"name": frame, "bare": bare, "topic": header.topic}
                yield Finding("message-slash", "warning", topic=header.topic, facts=facts)


def unknown_frames_in_messages(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each frame that messages name and nobody publishes."""
    known = evidence.frames | evidence.all_parents
    unknown: dict[str, list[tuple[Headers, int]]] = {}
    for header in evidence.headers if known else ():
        for number, frame in enumerate(header.frames):
            bare = frame.removeprefix("/")
            if bare and bare not in known:
                unknown.setdefault(bare, []).append((header, int((header.frame == number).sum())))
    for frame, topics in unknown.items():
        spatial = [header for header, _ in topics if SPATIAL.search(header.msgtype)]
        is_world = any(OF_THE_WORLD.search(header.msgtype) for header in spatial)
        facts = {
            "name": frame,
            "topics": ", ".join(header.topic for header, _ in topics),
            "count": sum(count for _, count in topics),
            "alike": _alike_text(frame, known),
        }
        code = "unknown-world-frame" if is_world else "unknown-frame"
        topic = spatial[0].topic if spatial else topics[0][0].topic
        yield Finding(code, "error" if spatial else "info", topic=topic, facts=facts)


def messages_without_a_frame(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each topic of sensors whose messages name no frame."""
    for header in evidence.headers:
        count = int(np.isin(header.frame, [n for n, frame in enumerate(header.frames) if not frame.strip("/")]).sum())
        if count and SPATIAL.search(header.msgtype) and not NO_PLACE.search(header.msgtype):
            facts = {"count": count, "total": len(header.frame)}
            yield Finding("empty-frame-id", "error", topic=header.topic, facts=facts)


def _alike_text(frame: str, known: set[str]) -> Text | str:
    """Return a sentence with the names of the tree that a name may be meant for, "" if there are none."""
    alike = sorted(name for name in known if are_confusable(name, frame))
    quoted = ", ".join(f'"{name}"' for name in alike[:MOST_NAMES])
    return Text(f" The tree has {quoted}.", f" 트리에 있는 비슷한 이름: {quoted}.") if alike else ""


def _pairs_alike(evidence: Evidence) -> Iterator[tuple[str, str, str]]:
    """Yield (name, other, how they are alike) without comparing everybody with everybody."""
    frames = sorted(evidence.frames | evidence.all_parents)
    everybody = sorted({*frames, *evidence.named_by_messages})
    known = set(everybody)
    same_letters: dict[str, set[str]] = {}
    ending_in: dict[str, set[str]] = {}
    for name in everybody:
        same_letters.setdefault(letters_of(name), set()).add(name)
        for ending in endings_of(name):
            ending_in.setdefault(ending, set()).add(name)
    for name in frames:
        others = same_letters[letters_of(name)] | ending_in.get(name, set()) | (known & set(endings_of(name)))
        yield from ((name, other, kind) for other in sorted(others - {name}) if (kind := name_similarity(name, other)))
    yield from _slips(evidence, frames, everybody)


def _slips(evidence: Evidence, frames: list[str], everybody: list[str]) -> Iterator[tuple[str, str, str]]:
    """Yield the names that are a slip away from each other, one of which hangs: in the air, or in messages only."""
    hanging = {*evidence.roots(), *(evidence.all_parents - evidence.frames)}
    if len(hanging) > MOST_ROOTS:
        return
    strangers = [name for name in everybody if name not in evidence.frames]
    for name in frames:
        for other in everybody if name in hanging else sorted({*hanging, *strangers}):
            if name != other and is_misspelling(name, other):
                yield name, other, "slip"


def _is_the_wrong_one(evidence: Evidence, name: str, other: str, kind: str) -> bool:
    """Return whether `name` is the one that should be `other`."""
    if name in evidence.joint_kinds and other in evidence.joint_kinds:
        return False  # the robot's description knows both
    if kind == "case":
        return _weight(evidence, name) < _weight(evidence, other)
    if kind == "prefix":
        return _has_a_wrong_prefix(evidence, name, other)
    # A slip must leave something unconnected: many pairs of honest names are alike.
    if other not in evidence.frames:
        return name not in evidence.named_by_messages and _is_leaf(evidence, name)
    return _fills_a_hole(evidence, name, other) and _weight(evidence, name) < _weight(evidence, other)


def _has_a_wrong_prefix(evidence: Evidence, name: str, other: str) -> bool:
    if "/" in prefix_of(name, other):
        hangs = name not in evidence.parent_of and other in evidence.parent_of  # a whole robot with a wrong prefix
        is_stranger = not _is_a_robot(evidence, name) and not _is_a_robot(evidence, other)
        return hangs or (is_stranger and _weight(evidence, name) < _weight(evidence, other))
    alike = [frame for frame in evidence.frames if frame.startswith(prefix_of(name, other))]
    return alike == [name] and other in evidence.frames and _fills_a_hole(evidence, name, other)


def _fills_a_hole(evidence: Evidence, name: str, other: str) -> bool:
    """Return whether two names are in two pieces, one of which begins with its name: one name would join them."""
    if name in evidence.parent_of and other in evidence.parent_of:
        return False
    return evidence.root_of(name) != evidence.root_of(other) or name not in evidence.frames


def _finding_of(evidence: Evidence, code: str, name: str, facts: dict[str, object]) -> Finding:
    said = [raw for raw in evidence.raw_names if name in (raw[0].removeprefix("/"), raw[1].removeprefix("/"))]
    edges = list(dict.fromkeys(f"{parent} -> {child} on {topic}" for parent, child, topic in said))
    return Finding(code, "error", *said[0], facts={**facts, "said": first_of(edges, MOST_EDGES)})


def _weight(evidence: Evidence, name: str) -> tuple:
    """Return how much speaks for a name; of two equal ones the later in the alphabet is suspected."""
    samples = links = 0
    for edge in evidence.edges():
        for number, parent in enumerate(edge.parents):
            if name in (edge.child, parent):
                links += 1
                samples += int((edge.parent == number).sum())
    neat = name == name.lower()
    is_named = name in evidence.joint_kinds or name in evidence.named_by_messages
    is_standard, is_bare = name.rpartition("/")[2] in STANDARD, "/" not in name
    return (is_named, is_standard, links, neat, is_bare, samples, [-ord(letter) for letter in name])


def _is_a_robot(evidence: Evidence, name: str) -> bool:
    """Return whether the prefix of a name is that of a whole robot: its frames hang together, without strangers."""
    prefix, slash, _ = name.rpartition("/")
    if not slash:
        return False
    own = [frame for frame in evidence.frames if frame.startswith(prefix + "/")]
    below = [child for child, parent in evidence.parent_of.items() if parent in own]
    return len(own) >= ROBOT_FRAMES and all(child in own for child in below)


def _is_leaf(evidence: Evidence, name: str) -> bool:
    return name in evidence.parent_of and name not in evidence.parent_of.values()
