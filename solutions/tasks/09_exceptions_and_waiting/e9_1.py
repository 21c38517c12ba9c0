"""E9.1: Eight lines from a log."""

from __future__ import annotations

from tflab.core import BufferCore, TransformException, seconds
from tflab.workbook.tasks import Choice, Draws, Parts, Task, Text, WrongAnswer

from .draws import edge, filled

KINDS = ("lookup", "connectivity", "future", "past", "one sample", "invalid argument", "not a TransformException")


CHECKS = ("spelling and publisher", "roots of the tree", "use_sim_time", "the line of code", "a longer timeout")


RIGHT_KINDS = dict(zip("abcdefgh", (*KINDS[:2], "future", "past", "one sample", *KINDS[5:], "future"), strict=True))


RIGHT = {
    **RIGHT_KINDS,
    "c edge": "odom",
    "d edge": "base_footprint",
    "h check": "use_sim_time",
}


ACCUSED_THE_NAMED_FRAME = WrongAnswer(
    "accused the named frame",
    {**RIGHT, "c edge": "laser_frame", "d edge": "laser_frame"},
    misconception="M11",
    reply=Text(
        en="the frames in the text are the two ends of the question, and the edge at fault is somewhere "
        "between them. Look in the buffer for the window that ends, or begins, at the second time of the text.",
        ko="오류 메시지에 나온 좌표계는 질문의 양 끝이고, 문제의 연결은 그 사이 어딘가에 있습니다. "
        "오류 메시지의 두 번째 시각에서 끝나거나 시작하는 구간을 버퍼에서 찾으십시오.",
    ),
    partly=True,
)


ACCUSED_THE_ONE_THAT_MOVES = WrongAnswer(
    "accused the one that moves",
    {**RIGHT, "c edge": "base_footprint"},
    misconception="M11",
    reply=Text(
        en="that edge had news until later than line c says. The window of a chain ends where its laziest publisher ends.",
        ko="그 연결에는 c에 나온 시각 이후의 표본도 있었습니다. 사슬의 구간은 가장 게으른 발행자가 끝나는 곳에서 끝납니다.",
    ),
)


ACCUSED_THE_ONE_THAT_REACHES_BACK = WrongAnswer(
    "accused the one that reaches back",
    {**RIGHT, "d edge": "odom"},
    misconception="M11",
    reply=Text(
        en="map -> odom reaches back furthest, to 20.5 s, and so it has the moment of line d. Into the past the walk "
        "ends at an edge that begins too late: the last number of line d says when.",
        ko="map -> odom은 가장 오래전인 20.5초부터 있으므로 d의 요청 시각에도 표본이 있습니다. 과거로는 너무 늦게 시작하는 "
        "연결에서 막힙니다. 그 시작은 d의 마지막 숫자입니다.",
    ),
)


THIRD_TEXT_MISSED = WrongAnswer(
    "third text missed",
    {**RIGHT, "e": "past"},
    misconception="M11",
    reply=Text(
        en="one of these extrapolations says neither future nor past. Read it again: how many samples does that edge have?",
        ko="외삽 오류 가운데 하나는 미래도 과거도 아닙니다. 다시 읽어 보십시오. 그 연결에는 표본이 몇 개 있습니까?",
    ),
)


THIRD_TEXT_TAKEN_FOR_THE_FUTURE = WrongAnswer(
    "third text taken for the future",
    {**RIGHT, "e": "future"},
    misconception="M11",
    reply=Text(
        en='line e is newer than the only sample, but its text does not say "future". With a single sample tf2 has a text of its own.',
        ko='e는 하나뿐인 표본보다 새롭지만 오류 메시지는 "future"라고 하지 않습니다. 표본이 하나뿐일 때 tf2는 다른 오류 메시지를 씁니다.',
    ),
)


SLASH_TAKEN_FOR_A_NAME = WrongAnswer(
    "slash taken for a name",
    {**RIGHT, "f": "lookup"},
    misconception="M11",
    reply=Text(
        en="line f never got as far as looking a name up. Read its first two words.",
        ko="f는 이름을 찾아보는 데까지 가지도 못했습니다. 첫 두 단어를 읽어 보십시오.",
    ),
)


NAME_AND_PATH_SWAPPED = WrongAnswer(
    "name and path swapped",
    {**RIGHT, "a": "connectivity", "b": "lookup"},
    misconception="M11",
    reply=Text(
        en='"does not exist" and "not part of the same tree" are two different noes: one is about a name, the other about a path.',
        ko='"does not exist"와 "not part of the same tree"는 서로 다른 "아니요"입니다. 하나는 이름, 다른 하나는 경로 문제입니다.',
    ),
    partly=True,
)


ALL_IN_ONE_FAMILY = WrongAnswer(
    "all in one family",
    {**RIGHT, "g": "lookup"},
    reply=Text(
        en="one of these lines is not from tf2's family at all, and `except TransformException` does not catch it. "
        "Which one speaks of a Python type?",
        ko="이 가운데 한 줄은 tf2 예외 가족이 아니어서 `except TransformException`에 잡히지 않습니다. "
        "파이썬 타입을 말하는 줄은 어느 것입니까?",
    ),
)


WAIT_FOR_A_CLOCK = WrongAnswer(
    "wait for a clock",
    {**RIGHT, "h check": "a longer timeout"},
    misconception="M10",
    reply=Text(
        en="compare the two times in line h: they are about 56 years apart. Which timeout would bridge that? Two kinds of clock are at work.",
        ko="h의 두 시각을 비교해 보십시오. 약 56년 차이가 납니다. timeout을 얼마로 늘려야 그만큼을 기다리겠습니까? 종류가 다른 두 시계가 돌고 있습니다.",
    ),
)


DIRECTION_OF_H_TURNED_ROUND = WrongAnswer(
    "direction of h turned round",
    {**RIGHT, "h": "past"},
    misconception="M11",
    reply=Text(
        en="line h says itself which way it goes. The moment asked for counts: is it before or after all that the buffer has?",
        ko="h의 메시지에 방향이 적혀 있습니다. 요청 시각이 기준입니다. 버퍼가 가진 모든 것보다 이릅니까, 늦습니까?",
    ),
)


NAMES_FOR_A_CLOCK = WrongAnswer(
    "names for a clock",
    {**RIGHT, "h check": "spelling and publisher"},
    misconception="M11",
    reply=Text(
        en="line h: tf2 got as far as the moment, so both names are known and there is a path. Look at the two times.",
        ko="h: tf2가 시각까지 따졌으니 두 이름은 알려져 있고 경로도 있습니다. 두 시각을 보십시오.",
    ),
)


ROOTS_FOR_A_CLOCK = WrongAnswer(
    "roots for a clock",
    {**RIGHT, "h check": "roots of the tree"},
    misconception="M11",
    reply=Text(
        en="line h: tf2 got as far as the moment, so there is a path between the two. Look at the two times.",
        ko="h: tf2가 시각까지 따졌으니 둘 사이에 경로는 있습니다. 두 시각을 보십시오.",
    ),
)


EDGES = Choice(("odom", "base_footprint", "base_link", "laser_frame", "arm_link", "tool0"))


def robot_of_the_lines() -> BufferCore:
    """Return the buffer that gave the eight lines."""
    return filled(
        BufferCore(seconds(20.0)),
        edge("map", "odom", 20.5, 25.3, 30.1),
        edge("odom", "base_footprint", 21.0, 25.7, 30.4),
        edge("base_footprint", "base_link"),
        edge("base_link", "laser_frame"),
        edge("base_link", "arm_link", 29.5),
        edge("arm_link", "tool0"),
        edge("base_lnk", "camera_link"),
    )


def line_of(buffer: BufferCore, target: str, source: str, time_s: float) -> str:
    """Return what tf2 says to a question that has no answer."""
    try:
        buffer.lookup_transform(target, source, seconds(time_s))
    except TransformException as error:
        return str(error)
    raise ValueError(f"{target} <- {source} at {time_s} has an answer")


def eight_lines(_rng: Draws) -> dict:
    """Return the lines; they are the same for everybody."""
    buffer = robot_of_the_lines()
    lines = {
        "a": line_of(buffer, "map", "lazer_frame", 25.0),
        "b": line_of(buffer, "map", "camera_link", 25.0),
        "c": line_of(buffer, "map", "laser_frame", 30.312),
        "d": line_of(buffer, "map", "laser_frame", 20.731),
        "e": line_of(buffer, "base_link", "tool0", 30.0),
        "f": line_of(buffer, "/map", "laser_frame", 25.0),
        "g": "Type <class 'geometry_msgs.msg._point_stamped.PointStamped'> is not loaded or supported",
        "h": line_of(buffer, "map", "laser_frame", 1763690412.3),
    }
    return {"buffer": buffer, "lines": lines}


TASK = Task(
    id="E9.1",
    kind="M",
    points=4,
    title=Text(en="Eight lines from a log", ko="로그 속 여덟 줄"),
    answer="lines",
    form=Parts(
        {
            **{name: Choice(KINDS) for name in "abcdefgh"},
            "c edge": EDGES,
            "d edge": EDGES,
            "h check": Choice(CHECKS),
        }
    ),
    given=eight_lines,
    mistakes=(
        ACCUSED_THE_NAMED_FRAME,
        ACCUSED_THE_ONE_THAT_MOVES,
        ACCUSED_THE_ONE_THAT_REACHES_BACK,
        THIRD_TEXT_MISSED,
        THIRD_TEXT_TAKEN_FOR_THE_FUTURE,
        SLASH_TAKEN_FOR_A_NAME,
        NAME_AND_PATH_SWAPPED,
        ALL_IN_ONE_FAMILY,
        WAIT_FOR_A_CLOCK,
        DIRECTION_OF_H_TURNED_ROUND,
        NAMES_FOR_A_CLOCK,
        ROOTS_FOR_A_CLOCK,
    ),
    hints=(
        Text(
            en="Ask in this order: was it a question at all? the names? the path? the moment?",
            ko="이 순서로 물으십시오. 질문이 말이 됩니까? 이름은? 경로는? 시각은?",
        ),
        Text(
            en='For an edge, take the last number of the line ("… data is at time …"), and look for it among the windows of the buffer.',
            ko='연결을 찾으려면 줄의 마지막 숫자("… data is at time …")를 버퍼의 구간들 가운데서 찾으십시오.',
        ),
        Text(
            en="Line e names no direction, line g names a Python type, and the times of line h come from two different worlds: seconds since 1970, and seconds since the start.",
            ko="e에는 방향이 없고, g에는 파이썬 타입이 있으며, h의 두 시각은 서로 다른 세계의 것입니다. 하나는 1970년부터, 하나는 시작부터 센 초입니다.",
        ),
    ),
    misconceptions=("M10", "M11"),
    means={
        "lookup": Text(
            en='a lookup error says that a frame "does not exist".',
            ko='lookup 오류에는 좌표계가 "does not exist"라고 나옵니다.',
        ),
        "connectivity": Text(
            en='a connectivity error says that two frames are not "part of the same tree".',
            ko='connectivity 오류에는 두 좌표계가 "part of the same tree"가 아니라고 나옵니다.',
        ),
        "future": Text(
            en='a future error says "into the future": the moment asked for is later than the newest sample.',
            ko='future 오류에는 "into the future"가 나옵니다. 요청 시각이 가장 새로운 표본보다 늦습니다.',
        ),
        "past": Text(
            en='a past error says "into the past": the moment asked for is earlier than the oldest sample.',
            ko='past 오류에는 "into the past"가 나옵니다. 요청 시각이 가장 오래된 표본보다 이릅니다.',
        ),
        "one sample": Text(
            en="the third text of an extrapolation speaks of a single time in the buffer, and of no direction.",
            ko="외삽의 세 번째 오류 메시지에는 버퍼에 있는 시각 하나만 나오고 방향은 나오지 않습니다.",
        ),
        "invalid argument": Text(
            en="an invalid argument is a question that is none, such as a name with a slash in front.",
            ko="invalid argument는 질문이 될 수 없는 경우입니다. 이름 앞의 슬래시가 그 예입니다.",
        ),
        "not a TransformException": Text(
            en="an error of another family speaks of a Python type, and of no frame or time.",
            ko="다른 가족의 오류에는 좌표계나 시각이 아니라 파이썬 타입이 나옵니다.",
        ),
        "odom": Text(
            en="the samples of map -> odom lie between 20.5 and 30.1 s.",
            ko="map -> odom의 표본은 20.5초에서 30.1초까지입니다.",
        ),
        "base_footprint": Text(
            en="the samples of odom -> base_footprint lie between 21.0 and 30.4 s.",
            ko="odom -> base_footprint의 표본은 21.0초에서 30.4초까지입니다.",
        ),
        "base_link": Text(
            en="the edge to base_link is static: it is good at any time.",
            ko="base_link로 가는 연결은 정적이어서 어느 시각에나 유효합니다.",
        ),
        "laser_frame": Text(
            en="the edge to laser_frame is static: it is good at any time.",
            ko="laser_frame으로 가는 연결은 정적이어서 어느 시각에나 유효합니다.",
        ),
        "arm_link": Text(
            en="arm_link does not lie between map and laser_frame.",
            ko="arm_link는 map과 laser_frame 사이에 있지 않습니다.",
        ),
        "tool0": Text(
            en="tool0 does not lie between map and laser_frame.",
            ko="tool0은 map과 laser_frame 사이에 있지 않습니다.",
        ),
        "spelling and publisher": Text(
            en="spelling is looked at where a name does not exist; here both names are known.",
            ko="철자는 이름이 없을 때 봅니다. 여기서는 두 이름 모두 알려져 있습니다.",
        ),
        "roots of the tree": Text(
            en="roots are looked at where there is no path; here tf2 got as far as the moment.",
            ko="루트는 경로가 없을 때 봅니다. 여기서는 tf2가 시각까지 따졌습니다.",
        ),
        "the line of code": Text(
            en="a line of code is looked at where the question is none; this one is a question, and the two times are of two worlds.",
            ko="코드는 질문이 될 수 없을 때 봅니다. 이것은 제대로 된 질문이고, 두 시각이 서로 다른 세계의 것입니다.",
        ),
        "a longer timeout": Text(
            en="a timeout bridges what is on its way, fractions of a second; here some fifty years are missing.",
            ko="timeout은 오는 중인 데이터, 곧 1초도 안 되는 차이에만 통합니다. 여기서는 50년쯤 모자랍니다.",
        ),
    },
    shows={
        "a": Text(
            en="Look for just these words in line a.",
            ko="a줄에 바로 그 말이 있는지 찾아보십시오.",
        ),
        "b": Text(
            en="Look for just these words in line b.",
            ko="b줄에 바로 그 말이 있는지 찾아보십시오.",
        ),
        "c": Text(
            en="Look for just these words in line c.",
            ko="c줄에 바로 그 말이 있는지 찾아보십시오.",
        ),
        "d": Text(
            en="Look for just these words in line d.",
            ko="d줄에 바로 그 말이 있는지 찾아보십시오.",
        ),
        "e": Text(
            en="Look for just these words in line e.",
            ko="e줄에 바로 그 말이 있는지 찾아보십시오.",
        ),
        "f": Text(
            en="Look for just these words in line f.",
            ko="f줄에 바로 그 말이 있는지 찾아보십시오.",
        ),
        "g": Text(
            en="Line g names no frame and no time, but a type of Python that is not loaded. Is that a no of tf2's at all?",
            ko="g줄에는 좌표계도 시각도 없고, 불러오지 않은 파이썬 타입만 나옵니다. 이것이 tf2가 한 거절입니까?",
        ),
        "h": Text(
            en="Look for just these words in line h.",
            ko="h줄에 바로 그 말이 있는지 찾아보십시오.",
        ),
        "c edge": Text(
            en="The last number of line c is where the samples of some edge end.",
            ko="c의 마지막 숫자는 어떤 연결의 표본이 끝나는 시각입니다.",
        ),
        "d edge": Text(
            en="The last number of line d is where the samples of some edge begin.",
            ko="d의 마지막 숫자는 어떤 연결의 표본이 시작되는 시각입니다.",
        ),
    },
)
