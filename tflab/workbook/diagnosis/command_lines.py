"""Recognise what is wrong with a command line."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from ...text import Text, Texts

__all__ = ["TEXTS", "Line", "describe_line", "wrong_in"]

TEXTS = Texts(__file__)
COMMANDS: Mapping[str, Text] = Texts(str(Path(__file__).with_name("commands.yaml")))  # what each does

Line = list[float | str]

ROS_1 = ("rosrun", "rostopic", "rosnode", "rosbag", "rosparam", "rosservice", "roslaunch", "roscore")
STATIC = ["ros2", "run", "tf2_ros", "static_transform_publisher"]
STATIC_OPTIONS = {
    "--x", "--y", "--z", "--qx", "--qy", "--qz", "--qw", "--roll", "--pitch", "--yaw", "--frame-id", "--child-frame-id",
}  # fmt: skip


def describe_line(kind: str, told: str) -> Text:
    """Return what is told of a line: what the command does that it starts, or which of its words nobody asked for."""
    if kind == "line: other command":
        return Text(f"`{told}` {COMMANDS[told].en}", f"`{told}`: {COMMANDS[told].ko}")
    return Text(f"Not asked for: {told}.", f"필요 없는 것: {told}.")


def wrong_in(given: Line, wanted: Line) -> Iterator[tuple[str, str]]:
    """Yield one thing that is wrong with a line, beside the one that is asked for, and what to tell of it."""
    if given[:1] == ["static"] == wanted[:1]:
        return
    is_static = wanted[:1] == ["static"]
    head = STATIC if is_static else wanted[: 4 if wanted[1:2] == ["run"] else 3]
    if given[: len(head)] != head:
        kind = _wrong_head(given, head)
        yield kind, _starts(given) if kind == "line: other command" else ""
    else:
        yield from _wrong_static(given[4:]) if is_static else _wrong_rest(given[len(head) :], wanted[len(head) :])


def _wrong_head(given: Line, head: Line) -> str:
    """Return what is wrong with the words that say which command it is."""
    program, package = head[-1], head[-2]
    if given[0] in ROS_1:
        return "line: ROS 1"
    if head[1] != "run":
        return "line: other command"
    if given[:3] == ["ros2", "run", program] or given[1:2] == [program] or given[1:3] == [package, program]:
        return "line: no run"
    is_an_option = given[:3] == head[:3] and _is_option(given[3:4])
    return "line: no run" if is_an_option else "line: other command"


def _starts(given: Line) -> str:
    """Return which of the known commands a line starts: its program, or its first words; none if it is not known."""
    words = [str(word) for word in given if not _is_option([word])]
    program = words[3:4] if words[1:2] == ["run"] else words[1:2]
    known = (" ".join(program), " ".join(words[:3]), " ".join(words[:2]))
    return next((name for name in known if name in COMMANDS), "")


def _wrong_static(given: Line) -> Iterator[tuple[str, str]]:
    """Yield that the words of an option are joined by underscores, so that nothing is published."""
    if any(str(word).replace("_", "-") in STATIC_OPTIONS - {word} for word in given):
        yield "static: underscores", ""


def _wrong_rest(given: Line, wanted: Line) -> Iterator[tuple[str, str]]:
    """Yield what is wrong behind the command: a comma, the options, the names; nothing if no word differs."""
    if any(isinstance(word, str) and "," in word for word in given):
        yield "line: commas", ""
        return
    more, less = Counter(given) - Counter(wanted), Counter(wanted) - Counter(given)
    too_many, missing = ([word for word in words if _is_option([word])] for words in (more, less))
    if too_many or missing:
        if not (too_many and missing):
            yield "line: option too many" if too_many else "line: option missing", _quoted(too_many)
    elif less:
        yield "line: other names" if more else "line: too few names", _quoted(more)


def _quoted(words: Iterable[float | str]) -> str:
    return ", ".join(f"`{word:g}`" if isinstance(word, float) else f"`{word}`" for word in words)


def _is_option(words: Line) -> bool:
    return bool(words) and isinstance(words[0], str) and words[0].startswith("-")
