"""Compare answers whose order does not matter: names, pairs, sets and trees.

    Name()                              "odom": a text of the learner's own, to the letter
    Pair(Name(), Choice(("up", "down")))    ("laser_frame", "up")
    Set(Name())                         {"map", "odom"}, or a list: each member counts once, whatever the order
    Tree()                              {"odom": "map", "base_link": "odom"}: child -> parent

A set and a tree have credit for each member.  Whoever names more than there are loses
what was too much: to answer with everything is no answer (the field's term is precision
beside recall).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from ...text import Text
from .form import Form, Mark, Probe, inside, is_given, pose_of
from .structures import as_one
from .values import Plain

__all__ = ["Name", "Pair", "Set", "Tree"]

MOST_MEMBERS = 1000  # of a set or a tree; no answer has as many
NOTHING: Probe = [(Mark("nothing"), Mark("at all"))]  # what an empty set shows

Edge = tuple[str, str]  # child, parent


@dataclass(frozen=True)
class Name(Form):
    """A name, written by the learner: compared to the letter, for `odom` and `Odom` are two frames.

    Of a `topic`, the slash in front may be left out, as `ros2` takes it.
    """

    topic: bool = False

    def probes(self, plain: Plain) -> list[Probe] | None:
        if not isinstance(plain, str):
            return None
        return [[(Mark("/" + plain.strip().lstrip("/") if self.topic else plain),)]]

    def wanted(self) -> Text:
        return Text(en="a name, as a str", ko="이름 하나(str)")

    def plain(self) -> dict[str, Any]:
        """Return the form as JSON has it: what kind of name it is only where that is said."""
        return super().plain() if self.topic else {"form": "Name"}


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


@dataclass(frozen=True)
class Tree(Form):
    """Who is whose parent: a dict child -> parent, pairs (parent, child) as `frames.gv` has them, or transforms."""

    in_any_order: ClassVar[bool] = True

    def probes(self, plain: Plain) -> list[Probe] | None:
        edges = edges_of(plain)
        if edges is None or len(edges) > MOST_MEMBERS:
            return None
        return [[(Mark(child), Mark(parent))] for child, parent in edges] or [NOTHING]

    def wanted(self) -> Text:
        return Text(en="a dict child -> parent", ko="자식 → 부모로 된 dict")


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


def _edge(plain: Plain) -> Edge | None:
    """Return the edge of a pair (parent, child) or of a transform with its frames, or None."""
    held = inside(plain)
    if isinstance(held, list) and len(held) == 2:
        parent, child = held
        return child, parent
    parts = pose_of(plain)
    return None if parts is None or parts[0] is None else (parts[0][1], parts[0][0])
