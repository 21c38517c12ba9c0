"""Is it one tree?  Question 2: one parent for each child, one root, no circle.

      map            map   odm          map <-.
       |              |     |            |     |
      odom           odom  base_link    odom   |
       |                                 |     |
    base_link                         base_link

tf2 accepts all of these in silence, and only a lookup that needs the missing
piece fails.  Read `values.py` next.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..evidence import Evidence
from ..findings import Finding

__all__ = ["loops", "self_transforms", "separate_trees", "several_parents"]


def self_transforms(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each frame that was published as its own parent."""
    for parent, child, topic in evidence.raw_names:
        if child and parent.removeprefix("/") == child.removeprefix("/"):
            yield Finding("self-transform", "error", parent, child, topic)


def loops(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each circle that the parents form at some moment."""
    reported = set()
    for moment_ns, parent_of in _arrangements(evidence):
        for circle in _circles(parent_of):
            if frozenset(circle) not in reported:
                reported.add(frozenset(circle))
                way = " -> ".join([*circle, circle[0]])
                yield Finding(
                    "loop", "error", parent_of[circle[0]], circle[0], begin_ns=moment_ns, facts={"circle": way}
                )


def several_parents(evidence: Evidence) -> Iterator[Finding]:
    """Yield a finding for each child with more than one parent, at once or one after the other."""
    for edge in evidence.moving:
        if len(edge.parents) < 2:
            continue
        changes = np.flatnonzero(np.diff(edge.parent)) + 1
        parents = ", ".join(sorted(edge.parents))
        facts = {"parents": parents, "changes": len(changes)}
        first, last = int(edge.receive_ns[changes[0]]), int(edge.receive_ns[changes[-1]])
        # A robot may be re-parented and given back; whoever goes back and forth more often is two.
        code = "two-parents" if len(changes) > 2 * (len(edge.parents) - 1) else "re-parented"
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
    members = {root: sorted(f for f in evidence.frames if evidence.root_of(f) == root) for root in roots}
    largest = max(roots, key=lambda root: len(members[root]))
    robots = {root.rpartition("/")[0] for root in roots}
    if len(robots) == len(roots) and "" not in robots:
        yield Finding("several-robots", "info", facts={"roots": ", ".join(roots)})
        return
    for root in roots:
        if root != largest:
            facts = {"root": root, "frames": ", ".join(members[root]), "largest": largest, "count": len(roots)}
            yield Finding("two-trees", "error", "", root, facts=facts)


def _arrangements(evidence: Evidence) -> Iterator[tuple[int, dict[str, str]]]:
    """Yield (moment of receipt [ns], parent of each child) at each new arrangement of children and parents."""
    changes = []
    for edge in evidence.edges():
        if len(edge):
            starts = np.concatenate([[0], np.flatnonzero(np.diff(edge.parent)) + 1])
            changes.extend((int(edge.receive_ns[i]), edge.child, edge.parents[edge.parent[i]]) for i in starts.tolist())
    parent_of: dict[str, str] = {}
    seen = set()
    for moment_ns, child, parent in sorted(changes):
        parent_of[child] = parent
        arrangement = frozenset(parent_of.items())
        if arrangement not in seen:
            seen.add(arrangement)
            yield moment_ns, parent_of


def _circles(parent_of: dict[str, str]) -> Iterator[list[str]]:
    """Yield each circle of at least two frames once, from child to parent, beginning with the first in the alphabet."""
    done: set[str] = set()
    for start in sorted(parent_of):
        way: list[str] = []
        frame = start
        while frame in parent_of and frame not in done and frame not in way:
            way.append(frame)
            frame = parent_of[frame]
        if frame in way:
            circle = way[way.index(frame) :]
            first = circle.index(min(circle))
            if len(circle) > 1:
                yield circle[first:] + circle[:first]
        done.update(way)
