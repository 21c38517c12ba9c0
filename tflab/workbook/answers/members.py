"""Compare answers whose order does not matter: pairs, sets and trees.

    Pair(Name(), Choice(("up", "down")))    ("laser_frame", "up")
    Set(Name())                         {"map", "odom"}, or a list: each member counts once, whatever the order
    Tree()                              {"odom": "map", "base_link": "odom"}: child -> parent

A set and a tree have credit for each member.  Whoever names more than there are loses
what was too much: to answer with everything is no answer (the field's term is precision
beside recall).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ...text import Text
from .form import Form, Mark, Probe, inside, is_given, pose_of
from .structures import RENAMED, as_one
from .values import Plain

__all__ = ["Pair", "Set", "Tree", "belonging", "dict_of", "edges_of", "members_of", "pairs_of"]

MOST_NAMED = 4  # children that are called by name
MOST_MEMBERS = 1000  # of a set or a tree; no answer has as many
NOTHING: Probe = [(Mark("nothing"), Mark("at all"))]  # what an empty set shows

Edge = tuple[str, str]  # child, parent


@dataclass(frozen=True)
class Pair(Form):
    """Two things that belong together, each of its own form."""

    first: Form
    second: Form

    def probes(self, plain: Plain) -> list[Probe] | None:
        held = inside(plain)
        if not isinstance(held, list) or len(held) != 2:
            return None
        pairs = zip((self.first, self.second), held, strict=True)
        return [as_one([as_one(form.probes(member)) for form, member in pairs])]

    def wanted(self) -> Text:
        first, second = self.first.wanted(), self.second.wanted()
        return Text(en=f"a pair ({first.en}, {second.en})", ko=f"쌍({first.ko}, {second.ko})")


@dataclass(frozen=True)
class Set(Form):
    """Members of one form, in whichever order, each counted once; with `once`, a list may not hold one twice."""

    of: Form
    once: bool = False
    in_any_order: ClassVar[bool] = True
    mistakes: ClassVar = ("nothing filled in", *RENAMED, "members twice")

    def probes(self, plain: Plain) -> list[Probe] | None:
        members = members_of(plain)
        if members is None or len(members) > MOST_MEMBERS:
            return None
        probes: list[Probe] = []
        for member in members:
            probe = as_one(self.of.probes(member))
            if not probe or self.once or probe not in probes:
                probes.append(probe)
        return sorted(probes, key=repr) or [NOTHING]

    def wanted(self) -> Text:
        each = self.of.wanted()
        return Text(en=f"a set or a list, each member {each.en}", ko=f"set이나 리스트(각 원소는 {each.ko})")

    def describe_difference(self, answer: Plain, expected: Plain) -> Text | None:
        if self.read(answer) is None:
            return None
        wanted = len(self.probes(expected)) if members_of(expected) else 0
        fits = belonging(self, answer, expected) if members_of(answer) else []
        missing = wanted - sum(fits)
        said = []
        if not all(fits):
            count = len(fits) - sum(fits)
            said.append(Text(f"members that do not belong: {count}", f"들어가면 안 되는 원소: {count}개"))
        if missing > 0:
            said.append(Text(f"members that are missing: {missing}", f"빠진 원소: {missing}개"))
        return Text.joined(*said, between="; ") if said else None


@dataclass(frozen=True)
class Tree(Form):
    """Who is whose parent: a dict child -> parent, or transforms; no pairs, whose order nobody can tell."""

    in_any_order: ClassVar[bool] = True
    mistakes: ClassVar = ("pairs", "nothing filled in", *RENAMED, "tree")

    def probes(self, plain: Plain) -> list[Probe] | None:
        edges = edges_of(plain)
        if edges is None or len(edges) > MOST_MEMBERS:
            return None
        return [[(Mark(child), Mark(parent))] for child, parent in edges] or [NOTHING]

    def wanted(self) -> Text:
        return Text(en="a dict child -> parent", ko="자식 → 부모로 된 dict")

    def describe_difference(self, answer: Plain, expected: Plain) -> Text | None:
        if self.read(answer) is None:
            return None
        wanted = len(self.probes(expected)) if edges_of(expected) else 0
        edges = edges_of(answer) or []
        fits = belonging(self, answer, expected) if edges else []
        wrong = sorted({child for (child, _), fit in zip(edges, fits, strict=True) if not fit})
        short = wanted - len({child for child, _ in edges})
        said = []
        if wrong:
            names = ", ".join(f'"{name}"' for name in wrong[:MOST_NAMED])
            said.append(
                Text(f"wrong as a child, or below the wrong parent: {names}", f"자식이나 그 부모가 틀린 곳: {names}")
            )
        if short > 0:
            said.append(Text(f"children that are missing: {short}", f"빠진 자식: {short}개"))
        return Text.joined(*said, between="; ") if said else None


def belonging(form: Set | Tree, answer: Plain, expected: Plain) -> list[bool]:
    """Return for each member of an answer whether it is among those of `expected`."""
    wanted = form.read(expected) or []
    return [any(is_given(probe, right) for right in wanted) for probe in form.read(answer) or []]


def members_of(plain: Plain) -> list[Plain] | None:
    """Return what a set, a list or the keys of a dict hold, or None."""
    if isinstance(plain, dict) and "set" in plain:
        plain = plain["set"]
    held = inside(plain)
    return held if isinstance(held, list) else None


def edges_of(plain: Plain) -> list[Edge] | None:
    """Return the edges (child, parent) of whatever says who is whose parent, each once, sorted; None if it does not."""
    held = inside(plain)
    if isinstance(plain, dict) and "dict" in plain:
        edges = list(held.items())
    elif isinstance(plain, dict) and (body := plain.get("BufferCore") or plain.get("Buffer")):
        edges = [(child, parent) for _, _, parent, child, *_ in body["samples"]]
    else:
        members = members_of(plain)
        edges = None if members is None else [_edge(member) for member in members]
    if edges is None or not all(edge and isinstance(edge[0], str) and isinstance(edge[1], str) for edge in edges):
        return None
    return sorted(set(edges))


def pairs_of(plain: Plain) -> list[Edge]:
    """Return the pairs that were given for a dict; none of anything else."""
    members = list(map(inside, members_of(plain) or ()))
    is_pairs = all(isinstance(one, list) and len(one) == 2 and all(isinstance(n, str) for n in one) for one in members)
    return [(one[0], one[1]) for one in members] if is_pairs else []


def dict_of(plain: Plain, is_child_first: bool = False) -> Plain:
    """Return the dict child -> parent that pairs (parent, child) mean; anything else as it is."""
    pairs = [pair if is_child_first else pair[::-1] for pair in pairs_of(plain)]
    return {"dict": dict(pairs)} if pairs else plain


def _edge(plain: Plain) -> Edge | None:
    """Return the edge of a transform with its frames, or None."""
    parts = pose_of(plain)
    return None if parts is None or parts[0] is None else (parts[0][1], parts[0][0])
