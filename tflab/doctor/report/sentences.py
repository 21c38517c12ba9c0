"""Describe a finding in English or Korean: title, evidence, cause, the next command, and how certain it is.

The texts of each code are in `sentences.yaml`. Their blanks are filled from the edge, the topic and the facts of a
finding. A fact that holds words is a Text.
"""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Literal, NamedTuple

from tflab.robots.faults.catalogue import Fault
from tflab.ros import distro
from tflab.text import Text, Texts, compose_yaml, text_of_node

from ..findings import Finding, first_of

__all__ = ["Description", "Sentences", "certainty_of", "describe", "descriptions", "evidence_needed", "faults_of_code"]

TEXTS = Texts(str(Path(__file__).with_name("evidence")))
MOST_SIBLINGS = 8  # that are named


class Sentences(NamedTuple):
    """What is said of one finding: what is wrong, what shows it, why it happens, what to type on the robot next."""

    title: str
    evidence: str
    cause: str
    command: str


class Description(NamedTuple):
    """What `sentences.yaml` holds of one code.

    Attributes:
        ros1: the command in ROS 1, "" if it is the same.
        likely, open: what would settle it; at most one of the two is there.
        faults: those of the catalogue that the code names; none for a mere note.
    """

    title: Text
    evidence: Text
    cause: Text
    command: str
    ros1: str = ""
    likely: Text | None = None
    open: Text | None = None
    faults: tuple[Fault, ...] = ()


@cache
def descriptions() -> dict[str, Description]:
    """Return the description of each code.

    Raises:
        TextError: the file is not as it has to be.
    """
    path = Path(__file__).with_suffix(".yaml")
    read = {}
    for code, node in compose_yaml(path).value:
        fields: dict[str, object] = {}
        for key, value in node.value:
            if key.value in ("command", "ros1"):
                fields[key.value] = value.value
            elif key.value == "faults":
                fields["faults"] = tuple(Fault(fault.value) for fault in value.value)
            else:
                fields[key.value] = text_of_node(value, path)
        read[code.value] = Description(**fields)
    return read


def describe(finding: Finding, language: str = "en") -> Sentences:
    """Return the sentences of a finding, with their blanks filled."""
    description = descriptions()[finding.code]
    edge = f"{finding.parent} -> {finding.child}" if finding.child else finding.topic
    others = len(finding.siblings)
    blanks = {
        "edge": Text(f"{edge} and {others} more", f"{edge} 외 {others}개") if others else edge,
        "parent": finding.parent,
        "child": finding.child,
        "topic": finding.topic or "/tf",
        "frame": finding.child,
        "who": TEXTS.get(f"owners_of_{finding.facts.get('kind')}", ""),
        **finding.facts,
    }
    title, evidence, cause = (text.filled(**blanks).say(language) for text in description[:3])
    if finding.siblings:
        evidence += " " + TEXTS["likewise"].filled(names=first_of(finding.siblings, MOST_SIBLINGS)).say(language)
    if "publishers" in finding.facts:
        evidence += " " + TEXTS["published_by"].filled(**blanks).say(language)
    command = _command_of(finding, description, blanks)
    if not finding.namespace:
        return Sentences(title, evidence, cause, command)
    if command.startswith("ros2 run tf2_"):  # the tools of tf2 listen to /tf
        command += f" --ros-args -r /tf:={finding.namespace}/tf -r /tf_static:={finding.namespace}/tf_static"
    return Sentences(f"{finding.namespace}: {title}", evidence, cause, command)


def _command_of(finding: Finding, description: Description, blanks: Mapping[str, object]) -> str:
    """Return the command to type next, in the words of the recording's ROS."""
    words = {name: value.en if isinstance(value, Text) else str(value) for name, value in blanks.items()}
    quoted = {name: shlex.quote(word) for name, word in words.items()}  # a name may hold spaces, or a shell's signs
    # a frame stands in quotes of its own, and a remedy is a command already
    form = description.ros1 if finding.is_ros1 and description.ros1 else description.command
    form = "{remedy}" if "remedy" in finding.facts else form
    command = form.format(**quoted | {name: words.get(name, "") for name in ("frame", "remedy")})
    if distro.current().record_takes_names:
        return command
    return command.replace("bag record /", "bag record --topics /")


def certainty_of(code: str) -> Literal["certain", "likely", "open"]:
    """Return how certain a finding is.

    `certain`: it is in the recording, whatever the cause. `likely`: the pattern fits one cause best. `open`: two
    causes leave the same traces.
    """
    description = descriptions()[code]
    return "likely" if description.likely else "open" if description.open else "certain"


def evidence_needed(code: str, language: str = "en") -> str:
    """Return what would settle a finding that is not certain, "" if it is certain."""
    description = descriptions()[code]
    text = description.likely or description.open
    return text.say(language) if text else ""


def faults_of_code(code: str) -> tuple[Fault, ...]:
    """Return the faults of the catalogue that a finding names; none for a mere note."""
    return descriptions()[code].faults
