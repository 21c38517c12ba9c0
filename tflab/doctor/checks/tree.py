"""Check that the frames are one tree: one parent for each child, one root, no loop.

      map            map   odm          map <-.
       |              |     |            |     |
      odom           odom  base_link    odom   |
       |                                 |     |
    base_link                         base_link

tf2 accepts all of these in silence, and only a lookup that needs the missing
piece fails.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations, takewhile

import numpy as np

from tflab.core import NSEC_PER_SEC
from tflab.text import Text

from ..evidence import Evidence
from ..findings import Finding, first_of
from .names import differ_in_side

__all__ = ["loops", "self_transforms", "separate_trees", "several_parents", "upside_down"]

MOST_SHOWN = 3  # pieces
NEW_NS = NSEC_PER_SEC  # after the others, for an edge to be new: edges that are there already begin together
MOST_NAMES = 8  # of a piece
MOST_CHANGES = 20_000  # of parents; where there are more, each arrangement of two frames is looked at once
RANKS = {"earth": 0, "map": 1, "odom": 2, "base_footprint": 3, "base_link": 3}  # REP-105, from the top


def self_transforms(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each frame that was published as its own parent."""
    for parent, child, topic in evidence.raw_names:
        if child and parent.removeprefix("/") == child.removeprefix("/"):
            yield Finding("self-transform", "error", parent, child, topic)


def loops(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each circle that the parents form at some moment."""
    reported = set()
    heard_ns: dict[str, int] = {}
    for moment_ns, parent_of, child in _arrangements(evidence):
        heard_ns[child] = moment_ns
        circle = _circle_through(parent_of, child)
        if circle and frozenset(circle) not in reported:
            reported.add(frozenset(circle))
            way = " -> ".join([*circle, circle[0]])
            is_new = all(heard_ns[frame] < moment_ns - NEW_NS for frame in circle if frame != child)
            last = f"{parent_of[child]} -> {child}"
            closed = Text(
                f" It was closed by {last}, which was not there before.",
                f" 이전에 없던 {last} 변환이 고리를 이루었습니다.",
            )
            facts = {"circle": way, "closed": closed if is_new else ""}
            yield Finding("loop", "error", parent_of[circle[0]], circle[0], begin_ns=moment_ns, facts=facts)


def several_parents(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each child with more than one parent, at once or one after the other."""
    for edge in evidence.moving:
        changes = np.flatnonzero(np.diff(edge.parent)) + 1
        if not len(changes):
            continue
        first, last = int(edge.receive_ns[changes[0]]), int(edge.receive_ns[changes[-1]])
        # A robot may be re-parented and given back; whoever goes back and forth more often is two.
        code = "two-parents" if len(changes) > 2 * (len(edge.parents) - 1) else "re-parented"
        told = [edge.parents[number] for number in edge.parent[[0, *changes.tolist()]].tolist()]
        in_turn = Text(", then ".join(told), " → ".join(told))
        parents = in_turn if code == "re-parented" else ", ".join(sorted(edge.parents))
        facts = {"parents": parents, "changes": len(changes)}
        yield Finding(code, "error", edge.usual_parent, edge.child, edge.topic, first, last, facts)
    yield from _parents_of_statics(evidence)


def _parents_of_statics(evidence: Evidence) -> Iterator[Finding]:
    moving = {edge.child: edge for edge in evidence.moving}
    for edge in evidence.statics:
        parents = set(edge.parents) | set(moving[edge.child].parents if edge.child in moving else ())
        if len(parents) > 1:
            facts = {"parents": ", ".join(sorted(parents)), "changes": len(parents) - 1}
            begin_ns = int(edge.receive_ns[0])
            yield Finding("two-parents", "error", edge.usual_parent, edge.child, edge.topic, begin_ns, facts=facts)


def separate_trees(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding if there is more than one root: some transform between them is missing."""
    roots = evidence.roots()
    if len(roots) < 2:
        return
    if _are_robots(evidence.trees):
        yield Finding("several-robots", "info", facts={"roots": first_of(roots, MOST_NAMES)})
        return
    largest = max(roots, key=lambda root: len(evidence.trees[root]))
    others = [root for root in roots if root != largest]
    members = [first_of(evidence.trees[root], MOST_NAMES) for root in others]
    pieces = Text(*(first_of(texts, MOST_SHOWN, "; ")[i] for i, texts in enumerate(zip(*members, strict=True))))
    facts = {"root": others[0], "roots": first_of(others, MOST_NAMES), "pieces": pieces, "largest": largest,
             "count": len(roots)}  # fmt: skip
    yield Finding("two-trees", "error", "", others[0], facts=facts)


def upside_down(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each edge whose parent should be below its child: map -> odom -> base_link (REP-105)."""
    for edge in evidence.edges():
        above, below = (RANKS.get(name.rpartition("/")[2]) for name in (edge.usual_parent, edge.child))
        if above is not None and below is not None and above > below:
            yield Finding("upside-down", "warning", edge.usual_parent, edge.child, edge.topic)


def _are_robots(trees: dict[str, list[str]]) -> bool:
    """Return whether the frames of each tree begin with a name of its own: robot1/odom, robot2_odom.

    What only begins with a word may be a part of a robot (left_finger); robots have the same frames behind it.
    """
    names: dict[str, set[str]] = {}
    for frames in trees.values():
        first, last = min(frames), max(frames)  # what these two begin with, all do
        same = "".join(a for a, b in takewhile(lambda pair: pair[0] == pair[1], zip(first, last, strict=False)))
        prefix = same[: max(same.rfind("/"), same.rfind("_")) + 1]
        names[prefix] = {frame[len(prefix) :] for frame in frames}
    if "" in names or len(names) < len(trees) or min(map(len, names.values())) < 2:
        return False
    return all(
        not a.startswith(b) and not differ_in_side(a, b) and ("/" in a or names[a] & names[b])
        for a, b in permutations(names, 2)
    )


def _arrangements(evidence: Evidence) -> Iterator[tuple[int, dict[str, str], str]]:
    """Yield (moment of receipt [ns], parent of each child, child that has just got it) at each change."""
    changes = []
    for edge in evidence.edges():
        if len(edge):
            starts = np.concatenate([[0], np.flatnonzero(np.diff(edge.parent)) + 1])
            changes.extend((int(edge.receive_ns[i]), edge.child, edge.parents[edge.parent[i]]) for i in starts.tolist())
    parent_of: dict[str, str] = {}
    seen = set()
    for moment_ns, child, parent in sorted(changes):
        parent_of[child] = parent
        if (child, parent) not in seen or len(changes) < MOST_CHANGES:
            yield moment_ns, parent_of, child
        seen.add((child, parent))


def _circle_through(parent_of: dict[str, str], start: str) -> list[str]:
    """Return the circle of at least two frames that a frame is in, beginning with the first in the alphabet."""
    way, frame = [start], parent_of[start]
    seen = {start}
    while frame in parent_of and frame not in seen:
        way.append(frame)
        seen.add(frame)
        frame = parent_of[frame]
    if frame != start or len(way) < 2:
        return []
    first = way.index(min(way))
    return way[first:] + way[:first]
