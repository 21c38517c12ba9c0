"""Where does a command line go wrong?  At its beginning, its options, or its names: seen by comparing words.

    ros2 run tf2_ros tf2_echo map odom 5          asked for
    ros2 tf2_echo map odom 5                      `ros2 run` and the package are missing
    ros2 run tf2_ros tf2_echo map, odom 5         a comma becomes part of a name
    ros2 topic delay /tf                          another command

A line is read as what it does (`answers/command_lines.py`); nothing is said of which
words are asked for.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

from ...text import Text

__all__ = ["LINES", "Line", "told_of_a_line", "wrong_in"]

Line = list[float | str]

ROS_1 = ("rosrun", "rostopic", "rosnode", "rosbag", "rosparam", "rosservice", "roslaunch", "roscore")
STATIC = ["ros2", "run", "tf2_ros", "static_transform_publisher"]
STATIC_OPTIONS = {
    "--x", "--y", "--z", "--qx", "--qy", "--qz", "--qw", "--roll", "--pitch", "--yaw", "--frame-id", "--child-frame-id",
}  # fmt: skip

LINES = {
    "line: ROS 1": Text(
        en="this is a command of ROS 1. In ROS 2 every line begins with `ros2`.",
        ko="ROS 1의 명령입니다. ROS 2에서는 모든 명령이 `ros2`로 시작합니다.",
    ),
    "line: no ros2": Text(
        en="the line does not begin with `ros2`.",
        ko="명령이 `ros2`로 시작하지 않습니다.",
    ),
    "line: no run": Text(
        en="a program is started with `ros2 run`, then its package, then its own name; not all of these are there.",
        ko="프로그램은 `ros2 run`, 패키지, 프로그램 이름 순서로 실행합니다. 이 가운데 빠진 것이 있습니다.",
    ),
    "line: words exchanged": Text(
        en="these first words belong here, and in another order: `ros2`, then what it is about, then what to do.",
        ko="앞의 단어는 맞지만 순서가 다릅니다. `ros2` 다음에 무엇에 관한 것인지, 그다음에 무엇을 할지를 씁니다.",
    ),
    "line: other package": Text(en="this program is not in that package.", ko="그 패키지에는 이 프로그램이 없습니다."),
    "line: other command": Text(
        en="this line starts another command than the one that does what is asked for.",
        ko="요청한 일을 하는 명령이 아니라 다른 명령입니다.",
    ),
    "line: other program": Text(
        en="the package is the right one, the program behind it is not.",
        ko="패키지는 맞지만 그 뒤의 프로그램이 다릅니다.",
    ),
    "line: commas": Text(
        en="on a command line words are separated by spaces alone: a comma becomes part of a name.",
        ko="명령 줄에서는 단어를 공백으로만 나눕니다. 쉼표는 이름의 일부가 됩니다.",
    ),
    "line: hyphens": Text(
        en="a long option has two hyphens in front of it, a short one has one.",
        ko="긴 옵션 앞에는 하이픈이 둘, 짧은 옵션 앞에는 하나 있습니다.",
    ),
    "line: option too many": Text(
        en="the command is the right one, and it has an option that nobody asked for.",
        ko="명령은 맞지만 필요 없는 옵션이 있습니다.",
    ),
    "line: option missing": Text(
        en="the command is the right one, and an option is missing.",
        ko="명령은 맞지만 옵션이 빠졌습니다.",
    ),
    "line: other options": Text(
        en="the command is the right one, its options are not.",
        ko="명령은 맞지만 옵션이 다릅니다.",
    ),
    "line: order of names": Text(
        en="the right words, and not in the order in which the command takes them.",
        ko="단어는 맞지만 명령이 받는 순서가 아닙니다.",
    ),
    "static: underscores": Text(
        en="the words of an option are joined by hyphens here, not by underscores.",
        ko="여기서 옵션의 단어는 밑줄이 아니라 하이픈으로 잇습니다.",
    ),
    "static: no such option": Text(
        en="this program lacks an option that you use. Lengths are `--x`, `--y`, `--z`, angles `--roll`, `--pitch`, "
        "`--yaw`, and the two frames `--frame-id` and `--child-frame-id`.",
        ko="이 프로그램에 없는 옵션이 있습니다. 길이는 `--x`, `--y`, `--z`, 각도는 `--roll`, `--pitch`, `--yaw`, "
        "두 좌표계는 `--frame-id`와 `--child-frame-id`입니다.",
    ),
    "static: a frame missing": Text(
        en="with options, both frames have to be named: the parent by `--frame-id`, the child by `--child-frame-id`.",
        ko="옵션을 쓸 때는 두 좌표계를 모두 적습니다. 부모는 `--frame-id`, 자식은 `--child-frame-id`입니다.",
    ),
    "static: a word without option": Text(
        en="among the options stands a word that belongs to none: an option takes one word after it, and each "
        "number and each name needs an option of its own.",
        ko="옵션 사이에 어느 옵션의 것도 아닌 단어가 있습니다. 옵션은 뒤의 단어 하나를 받으므로, 숫자와 이름마다 "
        "옵션을 따로 붙여야 합니다.",
    ),
    "static: a period": Text(
        en="the number at the end is a period, as ROS 1 had it. The tool of ROS 2 takes none: a static transform is "
        "sent once. Named options, `--x` … `--yaw` … `--frame-id` … `--child-frame-id`, are its own form.",
        ko="끝의 숫자는 ROS 1에서 쓰던 주기입니다. ROS 2의 정적 변환은 한 번만 보내므로 주기를 쓰지 않습니다. "
        "`--x` … `--yaw` … `--frame-id` … `--child-frame-id`처럼 이름이 있는 옵션을 쓰십시오.",
    ),
    "static: not eight words": Text(
        en="without options there are eight words behind the program's name, x y z yaw pitch roll parent child, or "
        "nine with a quaternion; here is another number of them.",
        ko="옵션 없이 쓰면 프로그램 이름 뒤에 x y z yaw pitch roll 부모 자식의 여덟 단어, 쿼터니언이면 아홉 단어가 "
        "옵니다. 그 수가 다릅니다.",
    ),
    "line: too few names": Text(
        en="the command is the right one; something is missing behind it.",
        ko="명령은 맞지만 그 뒤에 써야 할 것이 빠졌습니다.",
    ),
    "line: too many names": Text(
        en="the command is the right one; there is more behind it than asked for.",
        ko="명령은 맞지만 그 뒤에 필요 없는 것이 더 있습니다.",
    ),
    "line: slash in front": Text(
        en="the command is the right one; here a name has no slash in front of it.",
        ko="명령은 맞습니다. 여기서는 이름 앞에 슬래시를 쓰지 않습니다.",
    ),
    "line: other names": Text(
        en="the command is the right one; a name or a value behind it is not.",
        ko="명령은 맞지만 그 뒤의 이름이나 값이 다릅니다.",
    ),
}

ANOTHER = ("line: other command", "line: other program")
DOES = {  # what a command does, by its program or its first words
    "tf2_echo": Text(
        "prints where one frame is, as seen from another.", "한 좌표계 기준으로 다른 좌표계가 어디 있는지 출력합니다."
    ),
    "tf2_monitor": Text(
        en="measures how late transforms are.",
        ko="변환이 얼마나 늦는지 잽니다.",
    ),
    "view_frames": Text(
        en="draws the tree.",
        ko="트리를 그립니다.",
    ),
    "static_transform_publisher": Text(
        en="publishes a transform that never changes.",
        ko="변하지 않는 변환을 발행합니다.",
    ),
    "ros2 topic echo": Text(
        en="prints the messages of a topic.",
        ko="토픽의 메시지를 출력합니다.",
    ),
    "ros2 topic hz": Text(
        "counts how often the messages of a topic come.", "토픽의 메시지가 얼마나 자주 오는지 셉니다."
    ),
    "ros2 topic delay": Text(
        "tells how old the messages of a topic are when they arrive.",
        "토픽의 메시지가 도착할 때 얼마나 오래되었는지 알려 줍니다.",
    ),
    "ros2 topic info": Text(
        "tells how many publish and subscribe on a topic.", "토픽의 발행자와 구독자가 몇인지 알려 줍니다."
    ),
    "ros2 topic list": Text(
        en="lists the topics.",
        ko="토픽의 목록을 보여 줍니다.",
    ),
    "ros2 topic bw": Text(
        en="measures how many bytes come on a topic.",
        ko="토픽으로 오는 데이터의 양을 잽니다.",
    ),
    "ros2 topic pub": Text(
        en="publishes a message.",
        ko="메시지를 발행합니다.",
    ),
    "ros2 node list": Text(
        en="lists the nodes.",
        ko="노드의 목록을 보여 줍니다.",
    ),
    "ros2 node info": Text(
        en="takes a node, and lists its topics.",
        ko="노드 하나의 토픽을 보여 줍니다.",
    ),
    "ros2 param": Text(
        "reads or sets a parameter of a node that runs already.", "이미 실행 중인 노드의 파라미터를 읽거나 바꿉니다."
    ),
    "ros2 launch": Text(
        en="starts what a launch file lists.",
        ko="launch 파일에 적힌 것을 실행합니다.",
    ),
    "ros2 service": Text(
        en="is about services.",
        ko="서비스를 다룹니다.",
    ),
    "ros2 interface": Text(
        en="shows how messages are defined.",
        ko="메시지의 정의를 보여 줍니다.",
    ),
    "ros2 doctor": Text(
        en="looks at how ROS 2 is installed.",
        ko="ROS 2의 설치 상태를 봅니다.",
    ),
    "ros2 bag record": Text(
        en="records topics.",
        ko="토픽을 기록합니다.",
    ),
    "ros2 bag play": Text(
        en="plays what was recorded.",
        ko="기록한 것을 재생합니다.",
    ),
    "ros2 bag info": Text(
        en="tells what is in a recording.",
        ko="기록에 무엇이 들어 있는지 알려 줍니다.",
    ),
    "rviz2": Text(
        en="shows things on a screen.",
        ko="화면에 보여 줍니다.",
    ),
}


def told_of_a_line(kind: str, told: str) -> Text:
    """Return what is told of a line: what the command does that it starts, or which of its words nobody asked for."""
    if kind in ANOTHER:
        return Text(f"`{told}` {DOES[told].en}", f"`{told}`: {DOES[told].ko}")
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
    return next((name for name in known if name in DOES), "")


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
    if any(isinstance(word, str) and word.endswith(",") for word in given):
        yield "line: commas", ""
        return
    more, less = Counter(given) - Counter(wanted), Counter(wanted) - Counter(given)
    too_many, missing = ([word for word in words if _is_option([word])] for words in (more, less))
    if too_many or missing:
        yield _wrong_options(too_many, missing), _quoted(too_many)
    elif more or less:
        yield f"line: {_wrong_words(list(more.elements()), list(less.elements()))}", _quoted(more)
    elif given != wanted:
        yield "line: order of names", ""


def _wrong_words(more: Line, less: Line) -> str:
    if more and sorted(str(word).removeprefix("/") for word in more) == sorted(map(str, less)):
        return "slash in front"
    return "other names" if more and less else "too many names" if more else "too few names"


def _quoted(words: Iterable[float | str]) -> str:
    return ", ".join(f"`{word:g}`" if isinstance(word, float) else f"`{word}`" for word in words)


def _wrong_options(too_many: Line, missing: Line) -> str:
    if not (too_many and missing):
        return "line: option too many" if too_many else "line: option missing"
    given, wanted = ({str(word).lstrip("-") for word in words} for words in (too_many, missing))
    return "line: hyphens" if given == wanted else "line: other options"


def _is_option(words: Line) -> bool:
    return bool(words) and isinstance(words[0], str) and words[0].startswith("-")
