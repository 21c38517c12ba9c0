"""Compare command lines, whatever the order of their options, their quotes and written-out defaults.

    ros2 run tf2_ros tf2_echo map base_link           (a leading `$`, `!` or `%` is no part of it)
    ros2 topic echo --once /tf_static     ==     ros2 topic echo tf_static --once
    static_transform_publisher: by the transform that it would publish

A line becomes a row of marks: words, then options by name.  Numbers are compared
as numbers.
"""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from functools import lru_cache

from tflab.tools import static_transform_publisher

__all__ = ["rows"]

MarkPair = tuple[float | str, float]
TOLERANCE = 1e-3
LONGEST = 4_000  # characters: what is longer is no line that anybody types, and takes long to take apart

# Options that stand alone; every other one takes the word after it.
ALONE = {
    "--all", "--csv", "--flow-style", "--help", "--include-hidden-nodes", "--include-hidden-topics", "--loop",
    "--no-arr", "--no-daemon", "--no-log", "--no-str", "--once", "--raw", "--ros-args", "--show-types",
    "--spin", "--verbose", "-1", "-a", "-h", "-l", "-t", "-v", "-w",
}  # fmt: skip
LONG_NAMES = {
    "-a": "--all",
    "-h": "--help",
    "-l": "--loop",
    "-t": "--show-types",
    "-v": "--verbose",
    "-o": "--output",
    "--param": "-p",
}
NAMES_WITH_A_ROOT = {"topic", "node", "param", "service", "bag"}  # `tf` and `/tf` are the same to these


def rows(line: str) -> list[list[MarkPair]] | None:
    """Return the equal ways to write what `line` does, or None if it is not a line for a shell."""
    read = _rows(line) if len(line) <= LONGEST else None
    return None if read is None else list(map(list, read))


@lru_cache(maxsize=1024)  # an answer is held against hundreds of lines, and these against each other
def _rows(line: str) -> tuple[tuple[MarkPair, ...], ...] | None:
    words = _words(line)
    if not words:
        return None
    if words[:4] == ["ros2", "run", "tf2_ros", "static_transform_publisher"]:
        published = _published(_without_node_name(words[4:]))
        if published is not None:
            return tuple(map(tuple, published))
    return (tuple(_row(words)),)


def _words(line: str) -> list[str]:
    """Return the words of a line; none of one that a shell would not take."""
    try:
        words = shlex.split(line.strip().lstrip("$!%").replace("\\\n", " "), comments=True)
    except ValueError:
        return []
    is_with_topics = words[:4] == ["ros2", "bag", "record", "--topics"]  # which Jazzy accepts, and does not need
    return words[:3] + words[4:] if is_with_topics else words


def _without_node_name(arguments: list[str]) -> list[str]:
    """Return the tool's own arguments, without ROS's at the end if they only say how the node is called."""
    if "--ros-args" not in arguments:
        return arguments
    at = arguments.index("--ros-args")
    named = [word for word in arguments[at + 1 :] if word not in ("-r", "--remap")]
    return arguments[:at] if all(word.startswith(("__node:=", "__ns:=")) for word in named) else arguments


def _published(arguments: Sequence[str]) -> list[list[MarkPair]] | None:
    try:
        request = static_transform_publisher.parse([word for word in arguments if word != "--"])
    except static_transform_publisher.UsageError:
        return None
    if request.help:
        return None
    names = [("static", 0.0), (request.frame_id, 0.0), (request.child_frame_id, 0.0)]
    before = names + [(number, TOLERANCE) for number in request.translation]
    return [before + [(sign * number, TOLERANCE) for number in request.rotation] for sign in (1.0, -1.0)]


def _row(words: Sequence[str]) -> list[MarkPair]:
    bare: list[str] = []
    options: list[tuple[str, list[str]]] = []
    remaining = iter(words)
    for word in remaining:
        if not word.startswith("-") or _number(word) is not None:
            bare.append(word)
            continue
        name, _, value = word.partition("=")
        if not value and name not in ALONE:
            value = next(remaining, "")
        options.append((LONG_NAMES.get(name, name), [value] if value else []))
    if bare[:1] == ["ros2"] and bare[1:2] and bare[1] in NAMES_WITH_A_ROOT:
        # What follows the verb are names; `ros2 bag record` takes them in any order.
        names = [word.removeprefix("/") for word in bare[3:]]
        bare = bare[:3] + (sorted(names) if bare[1:3] == ["bag", "record"] else names)
    flat = bare + [word for name, values in sorted(options) for word in (name, *values)]
    return [_mark(word) for word in flat]


def _mark(word: str) -> MarkPair:
    number = _number(word)
    if number is not None:
        return (number, TOLERANCE)
    name, sign, value = word.rpartition(":=")  # a parameter's value, or the whole word
    return (name + sign + value.lower() if value.lower() in ("true", "false") else word, 0.0)


def _number(word: str) -> float | None:
    try:
        return float(word)
    except ValueError:
        return None
