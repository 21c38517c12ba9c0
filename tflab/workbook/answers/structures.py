"""Choices, lists, messages and command lines: the forms of answers that are more than a number.

    Choice(("past", "future"))     a word of these
    Parts({"a": ..., "b": ...})    a dict, credit for each part
    Sequence(Number())             a list in its order
    Message("geometry_msgs/msg/TransformStamped", ("header.frame_id", "transform.rotation"))
    Command()                      a line for a terminal, see `command_lines.py`

What has no order, sets and trees, is next.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice, product
from typing import Any

from ...text import Text
from . import command_lines
from .form import Form, Mark, Probe, Quaternion, Vector, inside, member, numbers_of
from .values import Plain

__all__ = ["Choice", "Command", "Message", "Parts", "Sequence", "as_one", "named_beside"]

MOST_WAYS = 64  # to write one sequence; beyond these, the plainest


@dataclass(frozen=True)
class Choice(Form):
    """One of `options`, read as a person means it: `'Use it.'` is "use it", " Node_B " is "node_b".

    Capitals count where two options differ by nothing else; of names alone, all but capitals and spaces counts.
    """

    options: tuple[str, ...] = ()

    def probes(self, plain: Plain) -> list[Probe] | None:
        word = self.option(plain)
        return None if word is None else [[(Mark(word),)]]

    def option(self, plain: Plain) -> str | None:
        """Return the option that is meant, or None if there is none, or more than one."""
        if not isinstance(plain, str | bool):
            return None
        text = str(plain).strip()
        if not self.options or text in self.options:
            return text
        meant = _options_meant(self.options, text)
        return meant[0] if len(meant) == 1 else None

    def wanted(self) -> Text:
        options = ", ".join(f'"{option}"' for option in self.options)
        return Text(en=f"one of {options}", ko=f"{options} 가운데 하나")


@dataclass(frozen=True)
class Parts(Form):
    """A dict of named parts, each of its own form, and each with credit of its own.

    What stands under other keys is not looked at; with `alone`, a dict that has such is no answer.
    """

    parts: dict[str, Form]
    alone: bool = False

    def probes(self, plain: Plain) -> list[Probe] | None:
        answers = inside(plain)
        if not isinstance(plain, dict) or not isinstance(answers, dict):
            return None
        if self.alone and set(answers) - set(self.parts):
            return None
        return [as_one(form.probes(self.part(answers, name))) for name, form in self.parts.items()]

    def part(self, answers: Mapping[str, Plain], name: str) -> Plain:
        """Return one part of a dict, as it is meant beside the others."""
        neighbours = {other: answers.get(other) for other in named_beside(name, self.parts) if other != name}
        return self.parts[name].beside(answers.get(name), neighbours)

    def wanted(self) -> Text:
        names = ", ".join(f'"{name}"' for name in self.parts)
        alone = Text(" and nothing else", "만") if self.alone else Text("", "")
        return Text(
            en=f"a dict with {names}{alone.en}", ko=f"{names} 키{alone.ko}를 가진 dict".replace("키만를", "키만")
        )

    def plain(self) -> dict[str, Any]:
        """Return the form as JSON has it, and where that would sort the parts, their order: that of the work."""
        names = list(self.parts)
        return super().plain() | ({"order": names} if names != sorted(names) else {})


def named_beside(name: str, parts: Iterable[str]) -> list[str]:
    """Return the parts that speak of the same one: of "c checks" those of c; of a name of one word, all."""
    who, space, _ = name.rpartition(" ")
    return [part for part in parts if part.startswith(who + space)]


@dataclass(frozen=True)
class Sequence(Form):
    """A list of any length, all members of one form."""

    of: Form

    def probes(self, plain: Plain) -> list[Probe] | None:
        members = inside(plain)
        if not isinstance(members, list):
            return None
        probes = [as_one(self.of.probes(item)) for item in members]
        length: Probe = [(Mark(f"{len(members)} members"),)]
        return [as_one([length, *probes])]

    def wanted(self) -> Text:
        each = self.of.wanted()
        return Text(en=f"a list, each member {each.en}", ko=f"리스트(각 원소는 {each.ko})")


@dataclass(frozen=True)
class Message(Form):
    """A ROS message of a type; `fields`, written with dots, are compared, each with credit of its own."""

    type: str
    fields: tuple[str, ...]
    tolerance: float = 1e-3

    def probes(self, plain: Plain) -> list[Probe] | None:
        if not isinstance(plain, dict) or not isinstance(plain.get("message"), list) or not plain["message"]:
            return None
        if plain["message"][0] != self.type:
            return None
        return [self._field(member(plain, *path.split("."))) for path in self.fields]

    def wanted(self) -> Text:
        return Text(en=f"a message {self.type}", ko=f"{self.type} 메시지")

    def _field(self, plain: Plain) -> Probe:
        for size in (4, 3):
            if (row := numbers_of(plain, size)) is not None:
                return (Quaternion(self.tolerance) if size == 4 else Vector(3, "", "", self.tolerance)).probes(plain)[0]
        if (row := numbers_of(plain, None)) is not None:
            return [(Mark(row[0], self.tolerance),)]
        return [(Mark(_text(plain)),)]


@dataclass(frozen=True)
class Command(Form):
    """One line for a terminal, compared by what it does."""

    def probes(self, plain: Plain) -> list[Probe] | None:
        rows = command_lines.rows(plain) if isinstance(plain, str) else None
        return None if rows is None else [[tuple(Mark(*mark) for mark in row) for row in rows]]

    def wanted(self) -> Text:
        return Text(en="a command line, as a str", ko="명령 한 줄(str)")


def as_one(probes: list[Probe] | None) -> Probe:
    """Return several probes as one that wants them all; what could not be read fits nothing."""
    if probes is None:
        return []
    ways = islice(product(*probes), MOST_WAYS)
    return [tuple(mark for row in rows for mark in row) for rows in ways]


NO_NAME = {"none", "nobody", "nothing"}  # words among names, and read as words
UNHEARD = str.maketrans("", "", "_-,'’")  # what nobody hears in words


def _is_name(option: str) -> bool:
    """Return whether this is a frame, a node or an edge, and no words about one."""
    return ("_" in option or "/" in option) and (" " not in option or "->" in option)


@lru_cache(4096)  # one word is read again for each mistake that a task knows
def _options_meant(options: tuple[str, ...], text: str) -> tuple[str, ...]:
    """Return the options that a person may mean by a text."""
    names = [option for option in options if _is_name(option)]
    as_names = {option: _is_read_as_a_name(option, options, names) for option in options}
    meant = [option for option, is_name in as_names.items() if _meant(option, is_name) == _meant(text, is_name)]
    spelt = {"_".join(text.casefold().split())}  # no name has a space in it
    if all(name.startswith("/") for name in names):
        spelt.add("/" + _meant(text, is_name=True))  # `ros2` takes both
    return tuple(meant or [option for option in options if option.casefold() in spelt])


def _is_read_as_a_name(option: str, options: tuple[str, ...], names: list[str]) -> bool:
    """Return whether each sign of an option counts: among names alone, and where it does not say that there is none.

    Where phrases stand among them (`tf2_echo` beside "no ROS 2 tool"), it is a list of words.
    """
    is_list_of_names = bool(names) and all(" " not in other or other in names for other in options)
    return is_list_of_names and option.casefold() not in NO_NAME


def _meant(text: str, is_name: bool) -> str:
    """Return a text without capitals, quotes, spaces and the like, `-` in a name as `_`; a word also without commas,
    "Exception".
    """
    text = "".join(text.replace("→", "->").split()).strip("\"'`“”‘’").casefold()
    if is_name:
        return re.sub("-(?!>)", "_", text)
    return text.rstrip(".").translate(UNHEARD).removesuffix("exception")


def _text(plain: Plain) -> str:
    """Return a value as one word; in which order its keys were written says nothing."""
    return json.dumps(plain, sort_keys=True)
