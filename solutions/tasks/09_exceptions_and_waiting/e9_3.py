"""E9.3: From exception to action."""

from __future__ import annotations

import math
import re
from functools import partial

from tflab.core import TransformException, seconds
from tflab.ros.messages import geometry_msgs
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.time import Time
from tflab.workbook.tasks import Choice, Draws, Task, Text, WrongAnswer, WrongStep

from .draws import kind_of, refusal, robot_buffer

LIMIT_S = 0.2


ACTIONS = ("use", "wait", "check clocks", "drop", "check names", "check tree", "fix message")


def point_in(frame: str, time_s: float) -> geometry_msgs.PointStamped:
    """Return a point with this header."""
    point = geometry_msgs.PointStamped()
    point.header.frame_id = frame
    point.header.stamp = Time(nanoseconds=seconds(time_s)).to_msg()
    point.point.x = 2.0
    return point


def messages(rng: Draws) -> list[tuple]:
    """Draw messages for each action, gaps on both sides of the limit, one gap longer than its text says, a frame on
    a slower edge than the robot's own, and one that is no name where there is no map yet: tf2 speaks of its target first.
    """
    t = 0.0
    while round(t + 4.2, 1) - round(t + 4.0, 1) <= LIMIT_S:  # until floats miss the limit
        t = round(float(rng.uniform(20.0, 60.0)), 1)
    drawn = [
        ("laser_frame", rng.uniform(1.2, 3.8)),
        ("laser_frame", 4.0 + rng.uniform(0.05, 0.09)),
        ("laser_frame", 4.0 + rng.uniform(0.22, 0.35)),
        ("laser_frame", 4.0 + rng.uniform(1.2, 2.0)),
        ("laser_frame", 4.5 + rng.uniform(0.02, 0.12)),  # 0.5 s more for map -> odom
        ("laser_frame", rng.uniform(0.2, 0.8)),
        ("gripper_link", 3.6 + rng.uniform(0.05, 0.15)),
        ("gripper_link", 3.6 + rng.uniform(0.25, 0.35)),  # map has heard of the robot later than that
        ("tool0", rng.uniform(2.3, 3.5)),
        ("Laser_frame", rng.uniform(1.2, 3.8)),
        ("camera_link", rng.uniform(1.2, 3.8)),
        ("/laser_frame", rng.uniform(1.2, 3.8)),
        ("", rng.uniform(1.2, 3.8)),
    ]
    rows = [(robot_buffer(t), point_in(frame, round(t + float(later), 3))) for frame, later in drawn]
    for beside_ns in (0, -1, 1, -1_000_000, 1_000_000):  # at the limit of 0.2 s, a hair beside it, and a little
        at_the_limit = point_in("laser_frame", t + 4.0)
        stamp = Time(nanoseconds=seconds(t + 4.0) + 200_000_000 + beside_ns)
        at_the_limit.header.stamp = stamp.to_msg()
        rows.append((robot_buffer(t), at_the_limit))
    rows += [(robot_buffer(t), point_in(frame, t + 30.0)) for frame in ("camera_link", "Laser_frame")]  # two faults
    start = math.floor(t) + 0.9  # a second begins between the newest transform and this message
    rows.append((robot_buffer(start), point_in("laser_frame", start + 4.0 + round(float(rng.uniform(0.17, 0.195)), 3))))
    slow = point_in("laser_frame", t + 4.0 + round(float(rng.uniform(0.02, 0.1)), 3))
    rows.append((robot_buffer(t, wheels_s=3.4), slow))
    lost = point_in("/laser_frame", round(t + float(rng.uniform(1.2, 3.8)), 3))
    rows.append((robot_buffer(t, is_localized=False), lost))
    for gap_ns in (100, 100_000, 100_000_000_000):  # what a bound in another unit lets wait
        point = point_in("laser_frame", t + 4.0)
        point.header.stamp = Time(nanoseconds=seconds(t + 4.0) + gap_ns).to_msg()
        rows.append((robot_buffer(t), point))
    return rows


def action(
    buffer: Buffer,
    message: geometry_msgs.PointStamped,
    *,
    limit_s: float = LIMIT_S,
    by_text: bool | str = False,
    latest: bool = False,
    wait_for_past: bool | str = False,
    swapped: bool = False,
    two_texts: bool | str = False,
    drops: str = "what is no future",
    spelt: str = "as it came",
    target: str = "map",
    newest_of: tuple[str, str] | None = None,
    classes: str = "each its own",
    let_through: str = "none",
) -> str:
    """Decide as the task asks; the options are the mistakes."""
    stamp = Time() if latest else Time.from_msg(message.header.stamp)
    written = {"without slashes": lambda name: name.lstrip("/"), "in small letters": str.lower}.get(spelt, str)
    frame = written(message.header.frame_id)
    ends = (target, frame)
    error = refusal(buffer, *(reversed(ends) if swapped else ends), stamp)
    kind = kind_of(error)
    if error is not None and kind == let_through:
        raise error
    if error is not None and classes == "base first":
        return "fix message"
    kind = {
        "names alone": {"connectivity": "lookup"},
        "no question is a name": {"invalid argument": "lookup"},
        "a slash is a name": {"invalid argument": "lookup"} if frame.startswith("/") else {},
        "nothing is a name": {"invalid argument": "lookup"} if not frame else {},
        "exchanged": {"connectivity": "lookup", "lookup": "connectivity"},
    }.get(classes, {}).get(kind, kind)
    if kind == "future" and drops == "every extrapolation":
        return "drop"
    if kind == "future" and drops == "turned round":
        gap_ns = stamp.nanoseconds - buffer.get_latest_common_time("map", frame).nanoseconds
        return "wait" if gap_ns >= seconds(limit_s) else "check clocks"
    if kind == "future" and drops == "whole seconds":
        newest_s = buffer.get_latest_common_time("map", frame).nanoseconds // 10**9
        return "wait" if stamp.nanoseconds // 10**9 - newest_s <= limit_s else "check clocks"
    if kind == "future" and drops == "nanoseconds alone":
        newest = buffer.get_latest_common_time("map", frame).nanoseconds
        return "wait" if stamp.nanoseconds % 10**9 - newest % 10**9 <= seconds(limit_s) else "check clocks"
    if two_texts and kind == "one sample":
        return two_texts if isinstance(two_texts, str) else "check clocks"
    if kind == "future":
        one, other = newest_of or ("map", "")
        newest_ns = buffer.get_latest_common_time(one, other or frame).nanoseconds
        gap_ns = stamp.nanoseconds - (error.bound_ns if by_text else newest_ns)
        if by_text == "as a float":
            asked_s, newest_s = map(float, re.findall(r"time (\d+\.\d+)", str(error))[:2])
            return "wait" if asked_s - newest_s <= limit_s else "check clocks"
        if by_text == "to its six digits":
            gap_ns = round(stamp.nanoseconds, -3) - round(error.bound_ns, -3)
        far = "drop" if drops == "what is far off" else "check clocks"
        return "wait" if gap_ns <= seconds(limit_s) else far
    words = {"ok": "use", "past": "drop", "one sample": "drop", "lookup": "check names", "connectivity": "check tree"}
    if kind == "past" and isinstance(wait_for_past, str):
        return {"the past alone": "wait", "the past is used": "use", "the clocks": "check clocks"}[wait_for_past]
    if wait_for_past is True and kind in ("past", "one sample"):
        return "wait"
    return words.get(kind, "fix message")


WAITS_HOWEVER_FAR = WrongStep(
    "waits however far",
    {"limit_s": 1e6},
    misconception="M10",
    reply=Text(
        en="your function waits for a future that is too far off. A gap of more than 0.2 s is not data on its way: no wait cures it. Is the gap compared with anything, and is it the whole stamp minus the latest common time? The other way round it is below zero for every future.",
        ko="너무 먼 미래까지 기다립니다. 0.2초를 넘는 간격은 오는 중인 데이터가 아닙니다. 기다려도 해결되지 않습니다. 간격을 무엇과 비교하고 있습니까? 측정 시각 전체에서 최신 공통 시각을 뺀 것입니까? 반대로 빼면 미래는 언제나 음수입니다.",
    ),
)


GAP_FROM_THE_TEXT = WrongStep(
    "gap from the text",
    {"by_text": True},
    misconception="M11",
    reply=Text(
        en="the time in the text is that of the first edge that failed, not of the slowest. A wait must last until every edge on the way is there: reckon from the latest common time.",
        ko="오류 메시지의 시각은 처음 실패한 연결의 것이지, 가장 느린 연결의 것이 아닙니다. 경로의 모든 연결이 올 때까지 기다려야 하므로 최신 공통 시각에서 계산하십시오.",
    ),
)


GAP_FROM_THE_TEXT_AS_A_FLOAT = WrongStep(
    "gap from the text, as a float",
    {"by_text": "as a float"},
    misconception="M11",
    reply=Text(
        en="you read the gap off the text, as decimals. The text names the first edge that failed, not the slowest, and it has six digits; at the limit itself a float errs. Reckon in nanoseconds from the latest common time.",
        ko="오류 메시지에서 간격을 소수로 읽었습니다. 메시지의 시각은 가장 느린 연결이 아니라 처음 실패한 연결의 것이고 여섯 자리뿐이며, 한계에서는 float가 어긋납니다. 최신 공통 시각에서 나노초로 계산하십시오.",
    ),
)


GAP_FROM_THE_TEXT_TO_ITS_DIGITS = WrongStep(
    "gap from the text, to its six digits",
    {"by_text": "to its six digits"},
    misconception="M11",
    reply=Text(
        en="you read the gap off the text. The text tells of one edge, the first that failed, and another may be slower; nor has it all digits: a nanosecond beyond 0.2 s reads like 0.2 s. Reckon in nanoseconds from the latest common time, which looks at every edge on the way.",
        ko="오류 메시지에서 간격을 읽었습니다. 메시지에는 처음 실패한 연결 하나만 나오고, 더 느린 연결이 있을 수 있습니다. 자릿수도 모자라 0.2초를 1나노초 넘어도 0.2초로 보입니다. 경로의 모든 연결을 보는 최신 공통 시각에서 나노초로 계산하십시오.",
    ),
)


GAP_FROM_THE_FIRST_EDGE = WrongStep(
    "gap from map and odom",
    {"newest_of": ("map", "odom")},
    misconception="M11",
    reply=Text(
        en="you reckon from the newest map in odom alone. The way to the message's frame has other edges, and one of them may be slower: ask for the latest common time of both ends.",
        ko="map과 odom 사이의 최신 시각에서만 계산했습니다. 메시지의 좌표계까지는 다른 연결도 있고, 그중 하나가 더 느릴 수 있습니다. 양 끝의 최신 공통 시각을 물으십시오.",
    ),
)


GAP_FROM_THE_WHEELS_EDGE = WrongStep(
    "gap from the wheels' edge",
    {"newest_of": ("odom", "base_footprint")},
    misconception="M11",
    reply=Text(
        en="you reckon from the newest odometry alone. The way from map to the message's frame has other edges, and one of them may be slower: ask for the latest common time of both ends.",
        ko="오도메트리의 최신 시각에서만 계산했습니다. map에서 메시지의 좌표계까지는 다른 연결도 있고, 그중 하나가 더 느릴 수 있습니다. 양 끝의 최신 공통 시각을 물으십시오.",
    ),
)


GAP_FROM_THE_ROBOT = WrongStep(
    "gap from the robot's own pose",
    {"newest_of": ("map", "base_footprint")},
    misconception="M11",
    reply=Text(
        en="you reckon from the newest pose of the robot in map. A message's frame may move on the robot, by an edge of its own that is slower: ask for the latest common time of map and *that* frame.",
        ko="map에서 로봇 포즈의 최신 시각으로 계산했습니다. 메시지의 좌표계가 로봇 위에서 움직이고 그 연결이 더 느릴 수 있습니다. map과 *그* 좌표계의 최신 공통 시각을 물으십시오.",
    ),
)


GAP_BELOW_ODOM = WrongStep(
    "gap below odom",
    {"newest_of": ("odom", "")},
    misconception="M11",
    reply=Text(
        en="you reckon from odom to the message's frame. The point is wanted in map: the edge from map to odom is on the way, too, and it is often the slowest.",
        ko="odom에서 메시지의 좌표계까지만 계산했습니다. 점은 map 기준으로 필요하므로 map과 odom 사이의 연결도 경로에 있고, 그것이 가장 느릴 때가 많습니다.",
    ),
)


GAP_FROM_THE_BASE = WrongAnswer(
    "gap from base_link",
    partial(action, newest_of=("base_link", "")),
    misconception="M11",
    reply=Text(
        en="you reckon from base_link to the message's frame. A mount is good at any time and has no newest moment, and map and odom are not on that way: ask for the latest common time of map and the message's frame.",
        ko="base_link에서 메시지의 좌표계까지만 계산했습니다. 장착 변환은 언제나 유효해서 최신 시각이 없고, map과 odom은 그 경로에 없습니다. map과 메시지 좌표계의 최신 공통 시각을 물으십시오.",
    ),
)


COMPARISON_TURNED_ROUND = WrongAnswer(
    "comparison turned round",
    partial(action, drops="turned round"),
    misconception="M10",
    reply=Text(
        en="you wait where the gap is 0.2 s or more, and check the clocks where it is less: the comparison is the wrong way round.",
        ko="간격이 0.2초 이상이면 기다리고, 그보다 작으면 시계를 의심합니다. 비교가 거꾸로입니다.",
    ),
)


WAITS_FOR_THE_PAST_ALONE = WrongStep(
    "waits for the past alone",
    {"wait_for_past": "the past alone"},
    misconception="M10",
    reply=Text(
        en='you wait where the text says "into the past". The buffer has forgotten that moment, or never had it: nothing on its way will bring it. Such a message is a "drop".',
        ko='"into the past"일 때 기다립니다. 버퍼가 이미 잊었거나 가진 적이 없는 시각이라 앞으로 올 것이 없습니다. 그런 메시지는 "drop"입니다.',
    ),
)


NEVER_WAITS = WrongStep(
    "never waits",
    {"limit_s": -1.0},
    misconception="M10",
    reply=Text(
        en="your function suspects the clocks at any gap, even at one of 100 ns. A small one is ordinary: the transform is on its way. Is the gap the stamp minus the latest common time, and not the time on a clock minus the stamp? And is the bound in its unit? In nanoseconds 0.2 s are 200 000 000.",
        ko="간격이 100나노초뿐이어도 시계를 의심합니다. 작은 간격은 흔한 일이고 변환이 오는 중입니다. 간격이 시계의 현재 시각이 아니라 최신 공통 시각과의 차이입니까? 한계의 단위가 간격의 단위와 같습니까? 0.2초를 나노초로 쓰면 200 000 000입니다.",
    ),
)


LATEST_INSTEAD_OF_THE_STAMP = WrongStep(
    "latest instead of the stamp",
    {"latest": True},
    misconception="M9",
    reply=Text(
        en="this asks for the latest transform, whatever the message's stamp. Then nothing is ever too old or too new, and the robot uses poses of another moment.",
        ko="메시지의 시각과 상관없이 최신 변환을 묻고 있습니다. 그러면 너무 오래되거나 너무 새로운 것이 없어지고, 로봇은 다른 시각의 포즈를 쓰게 됩니다.",
    ),
)


WAITS_FOR_THE_PAST = WrongStep(
    "waits for the past",
    {"wait_for_past": True},
    misconception="M10",
    reply=Text(
        en='your function waits where the text does not say "into the future", too. What the buffer has forgotten does not come back, and an edge that was heard just once says nothing of late: such a message is a "drop".',
        ko='오류 메시지가 "into the future"가 아닐 때도 기다립니다. 버퍼가 잊은 것은 돌아오지 않고, 딱 한 번 들은 연결이라면 늦는다고 볼 근거가 없습니다. 그런 메시지는 "drop"입니다.',
    ),
)


ENDS_SWAPPED = WrongStep(
    "ends swapped",
    {"swapped": True},
    misconception="M1",
    reply=Text(
        en="where map is unknown and the message's frame is no name at all, tf2 complains of its target first. Your function asks for the other direction, or looks at the frame before tf2 does: data in the message's frame, wanted in map, and map comes first.",
        ko="map을 모르고 메시지의 좌표계도 이름이 될 수 없을 때, tf2는 목표부터 탓합니다. 이 함수는 방향을 거꾸로 묻거나, tf2보다 먼저 좌표계 이름을 따지고 있습니다. 메시지의 좌표계 기준 데이터를 map 기준으로 보려 하니 map이 먼저입니다.",
    ),
)


WAITS_FOR_EVERY_EXTRAPOLATION = WrongStep(
    "waits for every extrapolation",
    {"limit_s": 1e6, "wait_for_past": True},
    misconception="M10",
    reply=Text(
        en="every extrapolation is a wait for you. Three kinds are in this class: a little into the future may wait, far into the future is a clock, and what is past does not come back. The text tells them apart.",
        ko="외삽이면 무조건 기다립니다. 이 클래스에는 세 가지가 있습니다. 조금 늦은(미래의) 시각은 기다릴 만하고, 한참 늦은(미래의) 시각은 시계 문제이며, 과거는 돌아오지 않습니다. 오류 메시지가 셋을 가려 줍니다.",
    ),
)


THIRD_TEXT_TAKEN_FOR_THE_FUTURE = WrongStep(
    "third text taken for the future",
    {"two_texts": True},
    misconception="M11",
    reply=Text(
        en='what is not "past" is not yet "future". An edge that has been heard exactly once gives a third text: any other extrapolation is a "drop".',
        ko='"past"가 아니라고 해서 "future"인 것은 아닙니다. 딱 한 번 들은 연결은 세 번째 오류 메시지를 냅니다. 그 밖의 외삽은 "drop"입니다.',
    ),
)


def one_word(buffer: Buffer, message: geometry_msgs.PointStamped, *, word: str) -> str:
    return "use" if action(buffer, message) == "use" else word


def no_path_at_the_latest(buffer: Buffer, message: geometry_msgs.PointStamped) -> str:
    at_the_latest = refusal(buffer, "map", message.header.frame_id, Time())
    return action(buffer, message) if at_the_latest is None else "check tree"


def gap_first(buffer: Buffer, message: geometry_msgs.PointStamped) -> str:
    stamp = Time.from_msg(message.header.stamp)
    try:
        newest = buffer.get_latest_common_time("map", message.header.frame_id)
    except TransformException as error:
        return {"LookupException": "check names", "ConnectivityException": "check tree"}.get(
            type(error).__name__, "fix message"
        )
    gap_ns = stamp.nanoseconds - newest.nanoseconds
    if gap_ns > 0:
        return "wait" if gap_ns <= seconds(LIMIT_S) else "check clocks"
    return action(buffer, message)


GAP_BEFORE_THE_LOOKUP = WrongAnswer(
    "gap before the lookup",
    gap_first,
    misconception="M11",
    reply=Text(
        en='you reckon the gap before you ask tf2. `get_latest_common_time` refuses in its own way: without a path it raises no ConnectivityException. And an edge that was heard just once has a gap and no future. Look up at the stamp first, and reckon the gap only where the text says "into the future".',
        ko='tf2에 묻기 전에 간격부터 계산합니다. `get_latest_common_time`은 거절하는 방식이 달라서, 경로가 없어도 ConnectivityException을 일으키지 않습니다. 딱 한 번 들은 연결에는 간격은 있어도 미래가 없습니다. 먼저 메시지의 시각으로 조회하고, "into the future"일 때만 간격을 계산하십시오.',
    ),
)


DIRECTION_UNREAD = WrongStep(
    "direction unread",
    {"wait_for_past": "the past alone", "two_texts": True},
    misconception="M11",
    reply=Text(
        en='you judge every extrapolation by its gap. Into the past the gap is below zero, and so it "waits" for what the buffer has forgotten; and an edge that was heard just once has no newest sample to wait for. Read the direction in the text first: only "into the future" has a gap to compare.',
        ko='외삽이면 모두 간격으로 판단합니다. 과거라면 간격이 음수라서 버퍼가 잊은 것을 "wait"하게 되고, 딱 한 번 들은 연결에는 기다릴 다음 표본이 없습니다. 먼저 오류 메시지에서 방향을 읽으십시오. 간격을 비교할 것은 "into the future"뿐입니다.',
    ),
)


DIRECTION_LOST = WrongStep(
    "direction lost",
    {"wait_for_past": "the clocks", "two_texts": True},
    misconception="M11",
    reply=Text(
        en='you never drop: the past, and an edge that was heard just once, are "check clocks" for you. Is it the size of the gap alone that you judge, as `abs(...)` makes it, or an `else` for all that may not wait? Read the direction in the text first: a gap is compared only where it says "into the future".',
        ko='버리는 일이 없습니다. 과거도, 딱 한 번 들은 연결도 "check clocks"입니다. `abs(...)`처럼 간격의 크기만 보거나, 기다리지 않을 것을 모두 `else`에 넣지 않았습니까? 먼저 오류 메시지에서 방향을 읽으십시오. 간격을 비교할 것은 "into the future"뿐입니다.',
    ),
)


DIRECTIONS_EXCHANGED = WrongAnswer(
    "directions exchanged",
    partial(action, drops="every extrapolation", wait_for_past="the past alone", two_texts=True),
    misconception="M10",
    reply=Text(
        en='the directions have changed places: you drop what lies in the future, and judge the rest by its gap. Only where the text says "into the future" is a transform on its way; look whether a `not` is missing, or one too many.',
        ko='방향이 뒤바뀌었습니다. 미래는 버리고 나머지를 간격으로 판단합니다. 변환이 오는 중인 것은 메시지에 "into the future"가 있을 때뿐입니다. `not`이 빠지거나 더 들어가지 않았는지 보십시오.',
    ),
)


EVERY_EXTRAPOLATION_IS_A_CLOCK = WrongAnswer(
    "every extrapolation is a clock",
    partial(action, limit_s=-1.0, wait_for_past="the clocks", two_texts=True),
    misconception="M10",
    reply=Text(
        en='every extrapolation is "check clocks" for you. Three kinds are in this class: a little into the future may wait, far into the future is a clock, and what is past does not come back. The text and the gap tell them apart.',
        ko='외삽이면 무조건 "check clocks"입니다. 이 클래스에는 세 가지가 있습니다. 조금 미래면 기다릴 만하고, 한참 미래면 시계 문제이며, 과거는 돌아오지 않습니다. 오류 메시지와 간격으로 가려집니다.',
    ),
)


def by_the_text_alone(buffer: Buffer, message: geometry_msgs.PointStamped) -> str:
    word = action(buffer, message)
    return "drop" if word in ("check names", "check tree", "fix message") else word


TEXTS_ALONE = WrongAnswer(
    "texts alone",
    by_the_text_alone,
    misconception="M11",
    reply=Text(
        en='a wrong name, no path and what is no question are a "drop" for you, too: you look at the text and not at the class. "drop" is for what is left of an ExtrapolationException, not of every exception.',
        ko='틀린 이름도, 없는 경로도, 질문이 되지 않는 것도 "drop"합니다. 클래스는 보지 않고 오류 메시지만 봅니다. "drop"은 모든 예외가 아니라 ExtrapolationException에서 남는 것입니다.',
    ),
)


def third_text_is(word: str) -> WrongAnswer:
    """Return the twin that answers the text of an edge heard just once with this word."""
    return WrongAnswer(
        f"third text: {word}",
        partial(action, two_texts=word),
        misconception="M11",
        reply=Text(
            en=f'where an edge was heard just once, you say "{word}". tf2 says "extrapolation at time …, but only time … is in the buffer" there: neither into the past nor into the future, and an extrapolation all the same. Any that is not into the future is a "drop".',
            ko=f'연결을 딱 한 번 들은 곳에서 "{word}"라고 합니다. 거기서 tf2의 메시지는 "extrapolation at time …, but only time … is in the buffer"입니다. 과거도 미래도 아니지만 외삽은 외삽입니다. 미래가 아닌 외삽은 모두 "drop"입니다.',
        ),
    )


THIRD_TEXTS = tuple(map(third_text_is, ("use", "wait", "check names", "check tree", "fix message")))


GAP_ALONE = WrongAnswer(
    "the gap alone",
    partial(action, wait_for_past="the past is used", two_texts=True),
    misconception="M11",
    reply=Text(
        en='you "use" a message that is older than all the buffer holds, and of an edge that was heard just once you judge by the gap. That a message is no newer than the latest common time does not mean that tf2 has an answer for it: ask at its stamp first, and reckon a gap only where the text says "into the future".',
        ko='버퍼에 있는 것보다 오래된 메시지를 "use"하고, 딱 한 번 들은 연결은 간격으로 판단합니다. 최신 공통 시각보다 새롭지 않다고 해서 tf2가 답할 수 있는 것은 아닙니다. 먼저 메시지의 시각으로 묻고, "into the future"일 때만 간격을 계산하십시오.',
    ),
)


GAP_OF_NANOSEC = WrongStep(
    "gap of nanosec alone",
    {"drops": "nanoseconds alone"},
    Text(
        en="you reckon the gap from the nanoseconds within the second: `nanosec` alone, or `%`, drops the whole seconds, and a message that is a second ahead, or thirty, comes out near. Compare `Time.nanoseconds`, which holds both.",
        ko="간격을 초 아래의 나노초로만 계산합니다. `nanosec`만 쓰거나 `%`로 나누면 초가 사라져, 1초나 30초 미래의 메시지도 가까워 보입니다. 둘을 다 담은 `Time.nanoseconds`로 비교하십시오.",
    ),
)


FAR_OFF_IS_DROPPED = WrongStep(
    "far off is dropped",
    {"drops": "what is far off"},
    Text(
        en='a future of more than 0.2 s is a "drop" for you. No transform on its way explains such a gap, and the next message will have it as well: the clocks are to be checked.',
        ko='0.2초를 넘는 미래를 "drop"합니다. 오는 중인 변환으로는 그런 간격이 설명되지 않고, 다음 메시지도 마찬가지일 것입니다. 시계를 확인해야 합니다.',
    ),
    "M10",
)


NOTHING_IS_A_WRONG_NAME = WrongAnswer(
    "an empty name is a wrong name",
    partial(action, classes="nothing is a name"),
    misconception="M11",
    reply=Text(
        en='where the frame is empty, you say "check names". tf2 looks no such name up: it raises an InvalidArgumentException, and the message is to be mended. Do you look at the name yourself, before you ask?',
        ko='좌표계가 비어 있으면 "check names"라고 합니다. tf2는 빈 이름을 찾아보지도 않고 InvalidArgumentException을 일으키며, 고칠 것은 메시지입니다. 묻기 전에 이름을 직접 따지고 있습니까?',
    ),
)


BASE_CLASS_FIRST = WrongAnswer(
    "base class first",
    partial(action, classes="base first"),
    misconception="M11",
    reply=Text(
        en='every refusal is "fix message" for you. Python takes the first `except` that fits, and the base class fits everything: let it come last.',
        ko='거절이면 무조건 "fix message"입니다. 파이썬은 조건에 맞는 `except` 가운데 맨 위의 것을 택하고, 부모 클래스는 무엇에나 해당합니다. 맨 뒤로 보내십시오.',
    ),
)


NO_PATH_IS_A_WRONG_NAME = WrongStep(
    "no path is a wrong name",
    {"classes": "names alone"},
    misconception="M11",
    reply=Text(
        en='where tf2 knows both names and no path leads across, you say "check names". That is a ConnectivityException, and the tree is to be checked.',
        ko='tf2가 두 이름을 다 알지만 길이 없는 곳에서 "check names"라고 합니다. 그것은 ConnectivityException이고, 확인할 것은 트리입니다.',
    ),
)


NO_QUESTION_IS_A_WRONG_NAME = WrongStep(
    "no question is a wrong name",
    {"classes": "no question is a name"},
    misconception="M11",
    reply=Text(
        en='where the question is none (a slash in front, an empty name), you say "check names". It has a class of its own, InvalidArgumentException: the message is to be mended.',
        ko='질문이 되지 않는 곳(앞의 슬래시, 빈 이름)에서 "check names"라고 합니다. InvalidArgumentException이라는 클래스가 따로 있습니다. 고칠 것은 메시지입니다.',
    ),
)


SLASH_IS_A_WRONG_NAME = WrongStep(
    "a slash is a wrong name",
    {"classes": "a slash is a name"},
    misconception="M14",
    reply=Text(
        en='where the frame begins with a slash, you say "check names". tf2 looks no such name up: it raises an InvalidArgumentException, and the message is to be mended. Do you look at the name yourself, before you ask?',
        ko='좌표계가 슬래시로 시작하면 "check names"라고 합니다. tf2는 그런 이름을 찾아보지도 않고 InvalidArgumentException을 일으키며, 고칠 것은 메시지입니다. 묻기 전에 이름을 직접 따지고 있습니까?',
    ),
)


NAMES_AND_TREE_EXCHANGED = WrongStep(
    "names and tree exchanged",
    {"classes": "exchanged"},
    misconception="M11",
    reply=Text(
        en='"check names" and "check tree" have changed places: a name that nobody knows is a LookupException, two known ones without a path a ConnectivityException.',
        ko='"check names"와 "check tree"가 바뀌었습니다. 아무도 모르는 이름이 LookupException, 아는 두 이름 사이에 길이 없는 것이 ConnectivityException입니다.',
    ),
)


NO_BRANCH_FOR_NO_QUESTION = WrongAnswer(
    "no branch for no question",
    partial(action, let_through="invalid argument"),
    misconception="M11",
    reply=Text(
        en="you catch three of the four classes. A message whose frame is no name (a slash in front, nothing at all) goes through your function as an InvalidArgumentException.",
        ko="네 클래스 가운데 셋만 잡습니다. 좌표계가 이름이 될 수 없는 메시지(앞의 슬래시, 빈 이름)는 InvalidArgumentException이 되어 함수를 그대로 지나갑니다.",
    ),
)


NO_BRANCH_FOR_NO_PATH = WrongAnswer(
    "no branch for no path",
    partial(action, let_through="connectivity"),
    misconception="M11",
    reply=Text(
        en="you catch three of the four classes. Where no path leads to map, a ConnectivityException goes through your function.",
        ko="네 클래스 가운데 셋만 잡습니다. map까지 이어진 길이 없으면 ConnectivityException이 함수를 그대로 지나갑니다.",
    ),
)


NO_BRANCH_FOR_NO_NAME = WrongAnswer(
    "no branch for no name",
    partial(action, let_through="lookup"),
    misconception="M11",
    reply=Text(
        en="you catch three of the four classes. Where a name is unknown, a LookupException goes through your function.",
        ko="네 클래스 가운데 셋만 잡습니다. 모르는 이름이 있으면 LookupException이 함수를 그대로 지나갑니다.",
    ),
)


ONE_ACTION_FOR_EVERY_NO = WrongAnswer(
    "one action for every no",
    partial(one_word, word="drop"),
    misconception="M11",
    reply=Text(
        en='every refusal is a "drop" for you. Then a transform that is 0.1 s late costs a message each time, and a typo is never found: one branch for each class.',
        ko='거절이면 무조건 "drop"입니다. 그러면 변환이 0.1초만 늦어도 매번 메시지를 잃고, 오타는 영영 찾지 못합니다. 클래스마다 분기를 하나씩 두십시오.',
    ),
)


EVERY_EXTRAPOLATION_IS_DROPPED = WrongStep(
    "every extrapolation is dropped",
    {"drops": "every extrapolation"},
    Text(
        en="you drop every message that meets an extrapolation. One that is newer than the transforms is not lost: 0.2 s or less are worth a wait, and more is a matter of clocks. The text says which way it goes.",
        ko="외삽 오류가 난 메시지를 모두 버립니다. 변환보다 새로운 메시지는 잃은 것이 아닙니다. 0.2초까지는 기다릴 만하고, 그보다 크면 시계의 문제입니다. 방향은 오류 메시지에 있습니다.",
    ),
    "M10",
)


GAP_IN_WHOLE_SECONDS = WrongStep(
    "gap in whole seconds",
    {"drops": "whole seconds"},
    Text(
        en="you reckon the gap from whole seconds: `sec` alone, or `//`, drops the nanoseconds, and then a gap is 0 or 1 s. Compare nanoseconds.",
        ko="간격을 초 단위로 끊어 계산합니다. `sec`만 쓰거나 `//`로 나누면 나노초가 사라져 간격이 0초 아니면 1초가 됩니다. 나노초로 비교하십시오.",
    ),
)


SLASHES_TAKEN_OFF = WrongStep(
    "slashes taken off",
    {"spelt": "without slashes"},
    Text(
        en="you take the slash in front off before you ask, and a message that nobody else can place is used: hand over its frame as it came.",
        ko="묻기 전에 이름 앞의 슬래시를 떼어, 다른 노드는 위치를 알 수 없는 메시지를 씁니다. 좌표계 이름을 받은 그대로 넘기십시오.",
    ),
    "M14",
)


IN_SMALL_LETTERS = WrongStep(
    "names in small letters",
    {"spelt": "in small letters"},
    Text(
        en="you write the frame in small letters before you ask. `Laser_frame` is another name than `laser_frame`, and tf2 does not know it.",
        ko="묻기 전에 좌표계 이름을 소문자로 바꿉니다. `Laser_frame`은 `laser_frame`과 다른 이름이고 tf2는 그것을 모릅니다.",
    ),
    "M14",
)


THE_LIMIT_IS_TOO_FAR = WrongStep(
    "the limit is too far",
    {"limit_s": LIMIT_S - 1e-9},
    Text(
        en='at exactly 0.2 s you check the clocks already, and "0.2 s or less" lets the limit itself wait. Is it `<` where `<=` is meant? If not, you compare seconds as floats, whose last digit errs: then just 0.2 comes out larger. Compare nanoseconds, which are whole numbers.',
        ko='간격이 정확히 0.2초일 때 이미 시계를 의심합니다. "0.2초 이하"이므로 한계 자체는 기다려야 합니다. `<=`를 쓸 곳에 `<`를 썼습니까? 아니라면 초를 float로 비교한 것입니다. 마지막 자리가 어긋나 0.2가 조금 더 커집니다. 정수인 나노초로 비교하십시오.',
    ),
)

LIMIT_OF_A_QUARTER = WrongStep(
    "another limit",
    {"limit_s": 0.25},
    Text(
        en="you wait somewhat beyond 0.2 s. The task draws the line at 0.2 s sharp; 0.2 s are 200 000 000 ns. Is the gap rounded before you compare it?",
        ko="0.2초를 조금 넘어도 기다립니다. 문제의 기준은 정확히 0.2초이고, 0.2초는 200 000 000 ns입니다. 비교하기 전에 간격을 반올림합니까?",
    ),
)


LIMIT_IS_BLUNT = WrongAnswer(
    "the limit is blunt",
    partial(action, limit_s=0.2005),
    Text(
        en="you wait where the gap is a nanosecond beyond 0.2 s, and no longer at a millisecond: the gap loses its last digits before you compare it. Compare nanoseconds as they are.",
        ko="간격이 0.2초를 1나노초 넘어도 기다리고 1밀리초를 넘으면 기다리지 않습니다. 비교하기 전에 간격의 아래 자릿수가 사라집니다. 나노초를 그대로 비교하십시오.",
    ),
)


LIMIT_OF_HALF_A_SECOND = WrongStep(
    "a limit of half a second",
    {"limit_s": 0.5},
    misconception="M10",
    reply=Text(
        en="you still wait where the gap is a third of a second, and no longer where it is more than half of one. The task draws the line at 0.2 s: 200 000 000 ns.",
        ko="간격이 3분의 1초일 때도 기다리고, 0.5초를 넘으면 기다리지 않습니다. 문제의 기준은 0.2초, 곧 200 000 000 ns입니다.",
    ),
)


LIMIT_OF_A_TENTH = WrongStep(
    "a limit of a tenth",
    {"limit_s": 0.1},
    Text(
        en="you check the clocks where the gap is just below 0.2 s, and wait only where it is smaller by half or so. The task draws the line at 0.2 s: 200 000 000 ns.",
        ko="간격이 0.2초보다 조금 작을 때 이미 시계를 의심하고, 그 절반쯤이어야 기다립니다. 문제의 기준은 0.2초, 곧 200 000 000 ns입니다.",
    ),
)


LIMIT_OF_A_SECOND = WrongStep(
    "a limit of a second",
    {"limit_s": 1.0},
    misconception="M10",
    reply=Text(
        en="you still wait where the gap is a third of a second, and no longer where it is more than one. The task draws the line at 0.2 s: 200 000 000 ns.",
        ko="간격이 3분의 1초일 때도 기다리고, 1초를 넘으면 기다리지 않습니다. 문제의 기준은 0.2초, 곧 200 000 000 ns입니다.",
    ),
)


LIMIT_OF_SECONDS = WrongStep(
    "a limit of seconds",
    {"limit_s": 2.0},
    misconception="M10",
    reply=Text(
        en="you still wait where the gap is more than a second, and no longer where it is a hundred. The task draws the line at 0.2 s: that is 200 000 000 ns. Is there a zero too many?",
        ko="간격이 1초를 넘어도 기다리고, 100초라면 기다리지 않습니다. 문제의 기준은 0.2초, 곧 200 000 000 ns입니다. 0이 하나 더 있지 않습니까?",
    ),
)


LIMIT_IN_MICROSECONDS = WrongStep(
    "a limit in microseconds",
    {"limit_s": 2e-4},
    Text(
        en="your function waits where the gap is a tenth of a millisecond, and no longer where it is some hundredths of a second: the bound is far below 0.2 s. Which unit is it in? In nanoseconds 0.2 s are 200 000 000.",
        ko="간격이 0.1밀리초일 때는 기다리고, 100분의 몇 초만 되어도 기다리지 않습니다. 한계가 0.2초보다 훨씬 작습니다. 어떤 단위입니까? 0.2초를 나노초로 쓰면 200 000 000입니다.",
    ),
)


LIMIT_IN_MILLISECONDS = WrongStep(
    "a limit in milliseconds",
    {"limit_s": 2e-7},
    Text(
        en="your function waits where the gap is 100 ns, and no longer where it is a tenth of a millisecond: the bound is far below 0.2 s. Which unit is it in? In nanoseconds 0.2 s are 200 000 000.",
        ko="간격이 100나노초일 때는 기다리고, 0.1밀리초만 되어도 기다리지 않습니다. 한계가 0.2초보다 훨씬 작습니다. 어떤 단위입니까? 0.2초를 나노초로 쓰면 200 000 000입니다.",
    ),
)


WANTED_IN_BASE_LINK = WrongStep(
    "wanted in base_link",
    {"target": "base_link"},
    Text(
        en="you ask for base_link. The point is wanted in map, and that chain is longer: it has other edges to wait for.",
        ko="base_link를 물었습니다. 점은 map 기준으로 필요하고, 그 사슬에는 기다려야 할 연결이 더 있습니다.",
    ),
)


WANTED_IN_ODOM = WrongStep(
    "wanted in odom",
    {"target": "odom"},
    Text(
        en="you ask for odom. The point is wanted in map: that is one edge more, and often the slowest.",
        ko="odom을 물었습니다. 점은 map 기준으로 필요합니다. 연결이 하나 더 있고, 그것이 가장 느릴 때가 많습니다.",
    ),
)


ODOM_THROUGHOUT = WrongAnswer(
    "odom throughout",
    partial(action, target="odom", newest_of=("odom", "")),
    misconception="M11",
    reply=Text(
        en="you ask for odom, and reckon the gap from there, too. The point is wanted in map: the edge from map to odom is on the way, and it is often the slowest.",
        ko="odom을 물었고 간격도 odom에서 계산했습니다. 점은 map 기준으로 필요합니다. map과 odom 사이의 연결도 경로에 있고, 그것이 가장 느릴 때가 많습니다.",
    ),
)


A_WAIT_FOR_EVERY_NO = WrongAnswer(
    "a wait for every no",
    partial(one_word, word="wait"),
    Text(
        en='every refusal is a "wait" for you. Only what is on its way is worth one: a little into the future. A typo, a torn tree, a wrong clock and the past stay as they are, however long you wait. `can_transform` says only yes or no: the class of the exception, and its text, say why.',
        ko='거절이면 무조건 "wait"입니다. 기다릴 만한 것은 오는 중인 것, 곧 조금 미래인 경우뿐입니다. 오타, 끊어진 트리, 틀린 시계, 과거는 아무리 기다려도 그대로입니다. `can_transform`은 예, 아니요만 답합니다. 까닭은 예외의 클래스와 오류 메시지에 있습니다.',
    ),
    "M10",
)


def every_no_is(word: str) -> WrongAnswer:
    """Return the twin that does this whatever tf2 refuses."""
    return WrongAnswer(
        f"every no: {word}",
        partial(one_word, word=word),
        misconception="M11",
        reply=Text(
            en=f'every refusal is "{word}" for you, whatever the reason. `can_transform` says only yes or no, and so does a single `except`; why tf2 refuses stands in the class of its exception, and of an extrapolation in its text. One branch for each.',
            ko=f'이유가 무엇이든 거절이면 모두 "{word}"입니다. `can_transform`은 예, 아니요만 답하고 `except` 하나도 마찬가지입니다. 까닭은 예외의 클래스에 있고, 외삽이라면 오류 메시지에 있습니다. 경우마다 분기를 하나씩 두십시오.',
        ),
    )


EVERY_NO = tuple(map(every_no_is, ("check names", "check tree", "check clocks")))


NO_ANSWER_AT_THE_LATEST_IS_NO_PATH = WrongAnswer(
    "no answer at the latest is no path",
    no_path_at_the_latest,
    misconception="M11",
    reply=Text(
        en='whatever tf2 refuses at the latest, too, is "check tree" for you: a name that is unknown, and one that is none, as well. That `can_transform` is false, or that a lookup at `Time()` fails, says no more than no. Which no it is stands in the class of the exception.',
        ko='최신으로 물어도 거절되면 모두 "check tree"라고 합니다. 모르는 이름도, 이름이 될 수 없는 것도 그렇습니다. `can_transform`이 False이거나 `Time()` 조회가 실패해도 안 된다는 것만 알 수 있습니다. 왜 안 되는지는 예외의 클래스에 있습니다.',
    ),
)


TASK = Task(
    id="E9.3",
    kind="F",
    points=4,
    title=Text(en="From exception to action", ko="예외에서 행동으로"),
    answer="decide",
    form=Choice(ACTIONS),
    inputs=messages,
    variants=3,
    model=action,
    mistakes=(
        WAITS_HOWEVER_FAR,
        GAP_FROM_THE_TEXT,
        GAP_FROM_THE_TEXT_AS_A_FLOAT,
        GAP_FROM_THE_TEXT_TO_ITS_DIGITS,
        GAP_FROM_THE_FIRST_EDGE,
        GAP_FROM_THE_WHEELS_EDGE,
        GAP_FROM_THE_ROBOT,
        GAP_BELOW_ODOM,
        GAP_FROM_THE_BASE,
        COMPARISON_TURNED_ROUND,
        WAITS_FOR_THE_PAST_ALONE,
        NEVER_WAITS,
        LATEST_INSTEAD_OF_THE_STAMP,
        WAITS_FOR_THE_PAST,
        ENDS_SWAPPED,
        WAITS_FOR_EVERY_EXTRAPOLATION,
        THIRD_TEXT_TAKEN_FOR_THE_FUTURE,
        DIRECTION_UNREAD,
        DIRECTION_LOST,
        DIRECTIONS_EXCHANGED,
        EVERY_EXTRAPOLATION_IS_A_CLOCK,
        TEXTS_ALONE,
        *THIRD_TEXTS,
        GAP_ALONE,
        GAP_OF_NANOSEC,
        FAR_OFF_IS_DROPPED,
        NOTHING_IS_A_WRONG_NAME,
        BASE_CLASS_FIRST,
        NO_PATH_IS_A_WRONG_NAME,
        NO_QUESTION_IS_A_WRONG_NAME,
        SLASH_IS_A_WRONG_NAME,
        NAMES_AND_TREE_EXCHANGED,
        NO_BRANCH_FOR_NO_QUESTION,
        NO_BRANCH_FOR_NO_PATH,
        NO_BRANCH_FOR_NO_NAME,
        ONE_ACTION_FOR_EVERY_NO,
        EVERY_EXTRAPOLATION_IS_DROPPED,
        GAP_IN_WHOLE_SECONDS,
        SLASHES_TAKEN_OFF,
        IN_SMALL_LETTERS,
        THE_LIMIT_IS_TOO_FAR,
        LIMIT_OF_A_QUARTER,
        LIMIT_IS_BLUNT,
        LIMIT_OF_HALF_A_SECOND,
        LIMIT_OF_A_TENTH,
        LIMIT_OF_A_SECOND,
        LIMIT_OF_SECONDS,
        LIMIT_IN_MICROSECONDS,
        LIMIT_IN_MILLISECONDS,
        WANTED_IN_BASE_LINK,
        WANTED_IN_ODOM,
        ODOM_THROUGHOUT,
        A_WAIT_FOR_EVERY_NO,
        *EVERY_NO,
        GAP_BEFORE_THE_LOOKUP,
        NO_ANSWER_AT_THE_LATEST_IS_NO_PATH,
    ),
    hints=(
        Text(
            en="It is E9.2 with other words, and one comparison more.",
            ko="E9.2와 같되 낱말이 다르고 비교가 하나 더 있습니다.",
        ),
        Text(
            en="For the future, `buffer.get_latest_common_time(target, source)` says how far TF has come. Compare nanoseconds: Times of two clock types cannot be subtracted.",
            ko="미래라면 `buffer.get_latest_common_time(target, source)`가 TF가 어디까지 왔는지 알려 줍니다. 시계 종류가 다른 Time끼리는 뺄 수 없으니 나노초로 비교하십시오.",
        ),
        Text(
            en='gap = stamp.nanoseconds − newest.nanoseconds; up to 0.2e9 "wait", beyond "check clocks". Every extrapolation that is not into the future is a "drop".',
            ko='gap = stamp.nanoseconds − newest.nanoseconds이고, 0.2e9까지는 "wait", 넘으면 "check clocks"입니다. 미래가 아닌 외삽은 모두 "drop"입니다.',
        ),
    ),
    seen={
        "use": Text(
            en="There tf2 answers at the message's own stamp.",
            ko="여기서는 메시지의 측정 시각에 tf2가 답합니다.",
        ),
        "wait": Text(
            en="There the message is at most 0.2 s newer than the latest common time of map and its frame.",
            ko="여기서는 메시지가 map과 메시지 좌표계의 최신 공통 시각보다 많아야 0.2초 나중 것입니다.",
        ),
        "check clocks": Text(
            en="There the message is more than 0.2 s newer than the latest common time of map and its frame.",
            ko="여기서는 메시지가 map과 메시지 좌표계의 최신 공통 시각보다 0.2초 넘게 새롭습니다.",
        ),
        "drop": Text(
            en="There an extrapolation does not lead into the future, so that nothing on its way can help.",
            ko="여기서는 외삽이 미래를 향하지 않아, 앞으로 올 것이 도움이 되지 않습니다.",
        ),
        "check names": Text(
            en="There tf2 does not know a name, and asks for no path and no moment then.",
            ko="여기서는 tf2가 이름을 모르고, 그러면 길도 시각도 묻지 않습니다.",
        ),
        "check tree": Text(
            en="There tf2 knows both names, and no path leads from one to the other.",
            ko="여기서는 tf2가 두 이름을 다 알지만 둘을 잇는 길이 없습니다.",
        ),
        "fix message": Text(
            en="There the question is none, by a slash in front or an empty name.",
            ko="여기서는 앞의 슬래시나 빈 이름 때문에 질문이 되지 않습니다.",
        ),
    },
    misconceptions=("M9", "M10", "M11"),
    equivalent={
        "buffer.get_latest_common_time('map', source) -> buffer.get_latest_common_time(source, 'map') in: newest = buffer.get_latest_common_time('map', source)": "the latest "
        "common time of two frames is the same whichever comes first",
    },
)
