"""Where does a command line go wrong?  At its beginning, its options, or its names: seen by comparing words.

    ros2 run tf2_ros tf2_echo map odom 5          asked for
    ros2 tf2_echo map odom 5                      `ros2 run` and the package are missing
    ros2 run tf2_ros tf2_echo map, odom 5         a comma becomes part of a name
    ros2 topic delay /tf                          another command

A line is read as what it does (`answers/command_lines.py`); nothing is said of which
words are asked for.  Read `fields.py` next.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from ..words import Words

__all__ = ["LINES", "Line", "wrong_in"]

Line = list[float | str]

ROS_1 = ("rosrun", "rostopic", "rosnode", "rosbag", "rosparam", "rosservice", "roslaunch", "roscore")
STATIC = ["ros2", "run", "tf2_ros", "static_transform_publisher"]

LINES = {
    "line: ROS 1": Words(
        en="this is a command of ROS 1. In ROS 2 every line begins with `ros2`.",
        ko="ROS 1의 명령입니다. ROS 2에서는 모든 명령이 `ros2`로 시작합니다.",
    ),
    "line: no ros2": Words(
        en="the line does not begin with `ros2`.",
        ko="명령이 `ros2`로 시작하지 않습니다.",
    ),
    "line: no run": Words(
        en="a program is started with `ros2 run`, then its package, then its own name; not all of these are there.",
        ko="프로그램은 `ros2 run`, 패키지, 프로그램 이름 순서로 실행합니다. 이 가운데 빠진 것이 있습니다.",
    ),
    "line: words exchanged": Words(
        en="these first words belong here, and in another order: `ros2`, then what it is about, then what to do.",
        ko="앞의 단어는 맞지만 순서가 다릅니다. `ros2` 다음에 무엇에 관한 것인지, 그다음에 무엇을 할지를 씁니다.",
    ),
    "line: other package": Words(en="this program is not in that package.", ko="그 패키지에는 이 프로그램이 없습니다."),
    "line: other command": Words(
        en="this line starts another command than the one that does what is asked for.",
        ko="요청한 일을 하는 명령이 아니라 다른 명령입니다.",
    ),
    "line: commas": Words(
        en="on a command line words are separated by spaces alone: a comma becomes part of a name.",
        ko="명령 줄에서는 단어를 공백으로만 나눕니다. 쉼표는 이름의 일부가 됩니다.",
    ),
    "line: hyphens": Words(
        en="a long option has two hyphens in front of it, a short one has one.",
        ko="긴 옵션 앞에는 하이픈이 둘, 짧은 옵션 앞에는 하나 있습니다.",
    ),
    "line: option too many": Words(
        en="the command is the right one, and it has an option that nobody asked for.",
        ko="명령은 맞지만 필요 없는 옵션이 있습니다.",
    ),
    "line: option missing": Words(
        en="the command is the right one, and an option is missing.",
        ko="명령은 맞지만 옵션이 빠졌습니다.",
    ),
    "line: other options": Words(
        en="the command is the right one, its options are not.",
        ko="명령은 맞지만 옵션이 다릅니다.",
    ),
    "line: order of names": Words(
        en="the right words, and not in the order in which the command takes them.",
        ko="단어는 맞지만 명령이 받는 순서가 아닙니다.",
    ),
    "line: too few names": Words(
        en="the command is the right one, and it is told too little: something is missing behind it.",
        ko="명령은 맞지만 그 뒤에 써야 할 것이 빠졌습니다.",
    ),
    "line: too many names": Words(
        en="the command is the right one, and it is told too much: there is more behind it than asked for.",
        ko="명령은 맞지만 그 뒤에 필요 없는 것이 더 있습니다.",
    ),
    "line: other names": Words(
        en="the command is the right one; a name or a value behind it is not.",
        ko="명령은 맞지만 그 뒤의 이름이나 값이 다릅니다.",
    ),
}


def wrong_in(given: Line, wanted: Line) -> Iterator[str]:
    """Yield what is wrong with a line, as it is read, beside the one that is asked for; one thing at most."""
    is_static = wanted[:1] == ["static"]
    head = STATIC if is_static else wanted[: 4 if wanted[1:2] == ["run"] else 3]
    if given[: len(head)] != head:
        yield _wrong_head(given, head)
    elif not is_static:
        yield from _wrong_rest(given[len(head) :], wanted[len(head) :])


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
    is_elsewhere = given[1:2] == ["run"] and given[3:4] == [program]
    return "line: other package" if is_elsewhere else "line: other command"


def _wrong_rest(given: Line, wanted: Line) -> Iterator[str]:
    """Yield what is wrong behind the command: a comma, the options, the names; nothing if no word differs."""
    if any(isinstance(word, str) and word.endswith(",") for word in given):
        yield "line: commas"
        return
    more, less = Counter(given) - Counter(wanted), Counter(wanted) - Counter(given)
    too_many, missing = ([word for word in words if _is_option([word])] for words in (more, less))
    if too_many or missing:
        yield _wrong_options(too_many, missing)
    elif more or less:
        sides = (bool(more), bool(less))
        yield {(True, True): "line: other names", (True, False): "line: too many names"}.get(
            sides, "line: too few names"
        )
    elif given != wanted:
        yield "line: order of names"


def _wrong_options(too_many: Line, missing: Line) -> str:
    if not (too_many and missing):
        return "line: option too many" if too_many else "line: option missing"
    given, wanted = ({str(word).lstrip("-") for word in words} for words in (too_many, missing))
    return "line: hyphens" if given == wanted else "line: other options"


def _is_option(words: Line) -> bool:
    return bool(words) and isinstance(words[0], str) and words[0].startswith("-")
