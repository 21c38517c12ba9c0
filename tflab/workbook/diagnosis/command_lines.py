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


ANOTHER = ("line: other command", "line: other program")


def describe_line(kind: str, told: str) -> Text:
    """Return what is told of a line: what the command does that it starts, or which of its words nobody asked for."""
    if kind in ANOTHER:
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
        yield kind, _starts(given) if kind in ANOTHER else ""
    else:
        yield from _wrong_static(given[4:]) if is_static else _wrong_rest(given[len(head) :], wanted[len(head) :])


def _wrong_head(given: Line, head: Line) -> str:
    """Return what is wrong with the words that say which command it is."""
    program, package = head[-1], head[-2]
    if given[0] in ROS_1:
        return "line: ROS 1"
    if given[0] != "ros2":
        return "line: no ros2"
    if sorted(map(str, given[: len(head)])) == sorted(map(str, head)):
        return "line: words exchanged"
    if head[1] != "run":
        return "line: other command"
    if given[:3] == ["ros2", "run", program] or given[1] == program or given[1:3] == [package, program]:
        return "line: no run"
    if given[:3] == head[:3] and _is_option(given[3:4]):
        return "line: no run"
    if given[:3] == head[:3]:
        return "line: other program"
    is_elsewhere = given[1:2] == ["run"] and given[3:4] == [program]
    return "line: other package" if is_elsewhere else "line: other command"


def _starts(given: Line) -> str:
    """Return which of the known commands a line starts: its program, or its first words; none if it is not known."""
    words = [str(word) for word in given if not _is_option([word])]
    program = words[3:4] if words[1:2] == ["run"] else words[1:2]
    known = (" ".join(program), " ".join(words[:3]), " ".join(words[:2]))
    return next((name for name in known if name in COMMANDS), "")


def _wrong_static(given: Line) -> Iterator[tuple[str, str]]:
    """Yield why a line with the right beginning publishes no static transform."""
    options = [str(word) for word in given if _is_option([word])]
    foreign = [option for option in options if option not in STATIC_OPTIONS]
    if foreign:
        kind = _foreign(foreign)
        yield kind, _quoted(foreign) if kind == "static: no such option" else ""
    elif not options:
        yield from _wrong_count(given)
    elif not {"--frame-id", "--child-frame-id"} <= set(options):
        yield "static: a frame missing", ""
    elif len(given) > 2 * len(options):
        yield "static: a word without option", ""


def _wrong_count(given: Line) -> Iterator[tuple[str, str]]:
    """Yield what is wrong with how many words there are, where none is an option."""
    if len(given) in (9, 10) and [isinstance(word, float) for word in given[-3:]] == [False, False, True]:
        yield "static: a period", ""
    elif len(given) not in (8, 9):
        yield "static: not eight words", ""


def _foreign(options: list[str]) -> str:
    """Return what is wrong with options that the program lacks."""
    if any(option.replace("_", "-") in STATIC_OPTIONS for option in options):
        return "static: underscores"
    is_short = any(not option.startswith("--") and f"-{option}" in STATIC_OPTIONS for option in options)
    return "line: hyphens" if is_short else "static: no such option"


def _wrong_rest(given: Line, wanted: Line) -> Iterator[tuple[str, str]]:
    """Yield what is wrong behind the command: a comma, the options, the names; nothing if no word differs."""
    if any(isinstance(word, str) and "," in word for word in given):
        yield "line: commas", ""
        return
    more, less = Counter(given) - Counter(wanted), Counter(wanted) - Counter(given)
    too_many, missing = ([word for word in words if _is_option([word])] for words in (more, less))
    if too_many or missing:
        yield _wrong_options(too_many, missing), _quoted(too_many)
    elif more or less:
        yield _wrong_words(list(more.elements()), list(less.elements())), _quoted(more)
    elif given != wanted:
        yield "line: order of names", ""


def _wrong_words(more: Line, less: Line) -> str:
    if more and sorted(str(word).removeprefix("/") for word in more) == sorted(map(str, less)):
        return "line: slash in front"
    return "line: other names" if more and less else "line: too many names" if more else "line: too few names"


def _quoted(words: Iterable[float | str]) -> str:
    return ", ".join(f"`{word:g}`" if isinstance(word, float) else f"`{word}`" for word in words)


def _wrong_options(too_many: Line, missing: Line) -> str:
    if not (too_many and missing):
        return "line: option too many" if too_many else "line: option missing"
    given, wanted = ({str(word).lstrip("-") for word in words} for words in (too_many, missing))
    return "line: hyphens" if given == wanted else "line: other options"


def _is_option(words: Line) -> bool:
    return bool(words) and isinstance(words[0], str) and words[0].startswith("-")
