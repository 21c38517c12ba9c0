"""Choices, names, lists, messages and command lines: the forms of answers that are more than a number.

    Choice(("past", "future"))     a word of these
    Name()                         "odom": a text of the learner's own, to the letter
    Parts({"a": ..., "b": ...})    a dict, credit for each part
    Sequence(Number())             a list in its order
    Message("geometry_msgs/msg/TransformStamped", ("header.frame_id", "transform.rotation"))
    Command()                      a line for a terminal, see `command_lines.py`

What has no order, sets and trees, is next.
"""

from __future__ import annotations

import difflib
import json
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import islice, product
from typing import Any, ClassVar

from ...text import Text, Texts
from . import command_lines
from .form import Form, Mark, Probe, inside, member, numbers_of
from .numeric import Number, Quaternion, Vector
from .values import Plain

__all__ = ["RENAMED", "Choice", "Command", "Message", "Name", "Parts", "Sequence", "as_one", "named_beside"]

TEXTS = Texts(__file__)
RENAMED = ("other case", "slash in front", "no slash in front", "space around", "other separator")
MOST_WAYS = 64  # to write one sequence; beyond these, the plainest
NEARLY = 0.6  # from which share of letters on a name looks like another


@dataclass(frozen=True)
class Choice(Form):
    """One of `options`, read as a person means it: `'Use it.'` is "use it", " Node_B " is "node_b".

    Capitals count where two options differ by nothing else, and of frames; of other names, all but them and spaces.
    """

    options: tuple[str, ...] = ()
    are_frames: bool = field(default=False, kw_only=True)
    mistakes: ClassVar = ("no_name", "several", "a_class", "an_error")

    def probes(self, plain: Plain) -> list[Probe] | None:
        word = self.option(plain)
        return None if word is None else [[(Mark(word),)]]

    @property
    def is_bool(self) -> bool:
        """Whether True and False are the options."""
        return set(self.options) == {"True", "False"}

    def option(self, plain: Plain) -> str | None:
        """Return the option that is meant, or None if there is none, or more than one."""
        if not isinstance(plain, str | bool):
            return None
        text = str(plain).strip()
        if self.is_bool and isinstance(plain, str):
            return None  # as for a parameter: the text "True" is no bool
        if not self.options or text in self.options:
            return text
        meant = () if self.are_frames else _options_meant(self.options, text)
        return meant[0] if len(meant) == 1 else None

    def wanted(self) -> Text:
        if self.is_bool:
            return Text(en="True or False, without quotes", ko="True 또는 False(따옴표 없이)")
        options = ", ".join(f'"{option}"' for option in self.options)
        en, ko = (" (capitals count)", " (대소문자 구별)") if self.are_frames else ("", "")
        return Text(en=f"one of {options}{en}", ko=f"{options} 가운데 하나{ko}")


@dataclass(frozen=True)
class Name(Form):
    """A name, written by the learner: compared to the letter, for `odom` and `Odom` are two frames.

    Of a `topic`, the slash in front may be left out, as `ros2` takes it.
    """

    topic: bool = False
    mistakes: ClassVar = ("no_name", "a_class", "an_error", "nothing filled in", *RENAMED, "empty", "stamp")

    def probes(self, plain: Plain) -> list[Probe] | None:
        if not isinstance(plain, str):
            return None
        return [[(Mark("/" + plain.strip().lstrip("/") if self.topic else plain),)]]

    def wanted(self) -> Text:
        return Text(en="a name, as a str", ko="이름 하나(str)")

    def plain(self) -> dict[str, Any]:
        """Return the form as JSON has it: what kind of name it is only where that is said."""
        return super().plain() if self.topic else {"form": "Name"}

    def describe_difference(self, answer: Plain, expected: Plain) -> Text | None:
        if not isinstance(answer, str) or not isinstance(expected, str) or not answer:
            return None
        if difflib.SequenceMatcher(None, answer, expected).ratio() >= NEARLY:
            return TEXTS["nearly"]
        return Text("another name than the expected one", "필요한 이름이 아닙니다")


@dataclass(frozen=True)
class Parts(Form):
    """A dict of named parts, each of its own form, and each with credit of its own.

    What stands under other keys is not looked at; with `alone`, a dict that has such is no answer.
    """

    parts: dict[str, Form]
    alone: bool = False
    is_measured: ClassVar[bool] = True

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

    def names(self) -> tuple[str, ...]:
        return tuple(self.parts)

    def forms_of_parts(self, like: Plain) -> dict[str, Form]:
        return dict(self.parts)

    def part_of(self, plain: Plain, name: str) -> Plain:
        """Return one part of a dict, or one member of a list in it, as in "frames[2]"."""
        held = inside(plain)
        if not isinstance(held, dict):
            return None
        name, _, place = name.partition("[")
        part = self.part(held, name)
        if not place:
            return part
        members, at = inside(part), int(place[:-1])
        return members[at] if isinstance(members, list) and at < len(members) else None

    def describe_difference(self, answer: Plain, expected: Plain) -> Text | None:
        given, wanted = inside(answer), inside(expected)
        if not isinstance(given, dict) or not isinstance(wanted, dict):
            return None
        for name, part in self.parts.items():
            if name in given and not part.alike(given[name], wanted[name]):
                said = part.describe_difference(given[name], wanted[name])
                if said is not None:
                    return Text(f'"{name}": {said.en}', f'"{name}": {said.ko}')
        return None


def named_beside(name: str, parts: Iterable[str]) -> list[str]:
    """Return the parts that speak of the same one: of "c checks" those of c; of a name of one word, all."""
    who, space, _ = name.rpartition(" ")
    return [part for part in parts if part.startswith(who + space)]


@dataclass(frozen=True)
class Sequence(Form):
    """A list of any length, all members of one form."""

    of: Form
    mistakes: ClassVar = ("a_set", "one_alone", "nothing filled in", "list")

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

    def describe_difference(self, answer: Plain, expected: Plain) -> Text | None:
        given, wanted = inside(answer), inside(expected)
        if not isinstance(given, list) or not isinstance(wanted, list):
            return None
        if len(given) > len(wanted):
            return Text("too many members", "원소가 너무 많습니다")
        if len(given) < len(wanted):
            return Text("too few members", "원소가 모자랍니다")
        first = next((place for place, pair in enumerate(zip(given, wanted, strict=True)) if pair[0] != pair[1]), 0)
        if first:
            return Text(f"the first members are right, up to number {first}", f"앞에서 {first}번째 원소까지는 맞습니다")
        return Text("the number of members is right, but the members are not", "원소의 수는 맞지만 내용이 다릅니다")


@dataclass(frozen=True)
class Message(Form):
    """A ROS message of a type; `fields`, written with dots, are compared, each with credit of its own."""

    type: str
    fields: tuple[str, ...]
    tolerance: float = 1e-3
    is_measured: ClassVar[bool] = True
    mistakes: ClassVar = ("a_field", "no_message")

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

    def names(self) -> tuple[str, ...]:
        return self.fields

    def forms_of_parts(self, like: Plain) -> dict[str, Form]:
        return {path: self._form_of_field(path, self.part_of(like, path)) for path in self.fields}

    def describe_difference(self, answer: Plain, expected: Plain) -> Text | None:
        rights = self.judge(answer, expected)
        right = [path for path, right in zip(self.fields, rights, strict=True) if right]
        said = [Text(f"right: {', '.join(right)}", f"맞음: {', '.join(right)}")] if right else []
        parts = self.forms_of_parts(expected)
        for name in (name for name, is_right in zip(parts, rights, strict=True) if not is_right):
            of_field = parts[name].describe_difference(self.part_of(answer, name), self.part_of(expected, name))
            if of_field is not None:
                return Text.joined(Text(f"{name}: {of_field.en}", f"{name}: {of_field.ko}"), *said, between="; ")
        return Text.joined(*said) if said else None

    def _form_of_field(self, path: str, held: Plain) -> Form:
        """Return the form of a field: its numbers are metres, its rotation a quaternion, its texts words."""
        if numbers_of(held, 4) is not None or path.endswith("rotation"):
            return Quaternion(self.tolerance)
        if numbers_of(held, 3) is not None or path.endswith(("translation", "point", "position")):
            return Vector(3, "m", "", self.tolerance)
        return Number("", self.tolerance) if numbers_of(held, None) is not None else Name()


MOUNT = {
    "--frame-id": Name(), "--child-frame-id": Name(), "translation": Vector(3, "m"), "rotation": Quaternion(),
}  # fmt: skip
STATIC_FIELDS = ("frame-id", "child-frame-id", "x", "y", "z")  # of static_transform_publisher, beside the rotation


@dataclass(frozen=True)
class Command(Form):
    """One line for a terminal, compared by what it does."""

    mistakes: ClassVar = ("nothing filled in", "empty", "line")

    def probes(self, plain: Plain) -> list[Probe] | None:
        rows = command_lines.rows(plain) if isinstance(plain, str) else None
        return None if rows is None else [[tuple(Mark(*mark) for mark in row) for row in rows]]

    def wanted(self) -> Text:
        return Text(en="a command line, as a str", ko="명령 한 줄(str)")

    def forms_of_parts(self, like: Plain) -> dict[str, Form]:
        return dict(MOUNT) if self._mount(like) else {}

    def part_of(self, plain: Plain, name: str) -> Plain:
        return self._mount(plain).get(name)

    def describe_difference(self, answer: Plain, expected: Plain) -> Text | None:
        given, wanted = self.read(answer), self.probes(expected)
        if not given or not wanted:
            return None
        row, right = given[0][0], wanted[0][0]
        if right[0].value != "static":
            same = next((place for place, pair in enumerate(zip(row, right, strict=False)) if not Mark.same(*pair)), 0)
            return Text(f"right up to word {same}", f"{same}번째 단어까지는 맞습니다") if same else None
        if row[0].value != "static":
            return TEXTS["no_static"]
        wrong = [name for name, *pair in zip(STATIC_FIELDS, row[1:6], right[1:6], strict=True) if not Mark.same(*pair)]
        if not any(all(map(Mark.same, row[6:], other[6:])) for other in wanted[0]):
            wrong.append("rotation")
        right_ones = [name for name in (*STATIC_FIELDS, "rotation") if name not in wrong]
        names, others = ", ".join(wrong), ", ".join(right_ones)
        return Text(f"right: {others}; wrong: {names}", f"맞음: {others}; 틀림: {names}")

    def _mount(self, plain: Plain) -> dict[str, Plain]:
        """Return what a line publishes as a static transform, by parts; nothing of another line."""
        read = self.read(plain)
        words = [mark.value for mark in read[0][0]] if read else []
        if words[:1] != ["static"]:
            return {}
        return dict(zip(MOUNT, (words[1], words[2], words[3:6], words[6:]), strict=True))


def as_one(probes: list[Probe] | None) -> Probe:
    """Return several probes as one that wants them all; what could not be read fits nothing."""
    if probes is None:
        return []
    combinations = islice(product(*probes), MOST_WAYS)
    return [tuple(mark for row in rows for mark in row) for rows in combinations]


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
