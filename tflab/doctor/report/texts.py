"""What does it mean, and what to do?  The sentences of the report, in English.

    code  ->  four sentences with blanks  ->  four sentences

Another language is another table with the same keys.
"""

from __future__ import annotations

from ..findings import Finding
from .gate_texts import GATE_TEXTS
from .sentences import Sentences
from .time_texts import TIME_TEXTS
from .tree_texts import OWNERS, TREE_TEXTS

__all__ = ["CHECK_TEXTS", "TEXTS", "sentences"]

TEXTS: dict[str, Sentences] = {**TREE_TEXTS, **TIME_TEXTS, **GATE_TEXTS}

MOST_SIBLINGS = 8  # that are told by name

CHECK_TEXTS = {
    "arrival": "the order and the times of arrival, which a buffer does not keep",
    "raw": "what was sent, which a buffer corrects or refuses",
    "recording": "the other topics, which a buffer does not know",
}


def sentences(finding: Finding, texts: dict[str, Sentences] = TEXTS) -> Sentences:
    """Return what a finding says, its blanks filled."""
    others = f" and {len(finding.siblings)} more" if finding.siblings else ""
    edge = f"{finding.parent} -> {finding.child}{others}"
    blanks = {
        "edge": edge,
        "parent": finding.parent,
        "child": finding.child,
        "topic": finding.topic or "/tf",
        "frame": finding.child,
        "who": OWNERS.get(str(finding.facts.get("kind")), ""),
        **finding.facts,
    }
    said = Sentences(*(part.format(**blanks) for part in texts[finding.code]))
    if finding.siblings:
        said = said._replace(evidence=f"{said.evidence} Likewise {_siblings(finding)}.")
    return _in_namespace(said, finding.namespace) if finding.namespace else said


def _in_namespace(said: Sentences, namespace: str) -> Sentences:
    """Return what is said of one of several robots: tools of tf2 listen to /tf unless they are told otherwise."""
    remap = f" --ros-args -r /tf:={namespace}/tf -r /tf_static:={namespace}/tf_static"
    command = said.command + remap if said.command.startswith("ros2 run tf2_") else said.command
    return said._replace(title=f"{namespace}: {said.title}", command=command)


def _siblings(finding: Finding) -> str:
    """Return the other edges of which the same is to be said, the first of many."""
    more = f" and {len(finding.siblings) - MOST_SIBLINGS} more" if len(finding.siblings) > MOST_SIBLINGS else ""
    return ", ".join(finding.siblings[:MOST_SIBLINGS]) + more
