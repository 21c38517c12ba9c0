"""E9.3: From exception to action."""

from __future__ import annotations

import re

import numpy as np

from tflab.core import seconds
from tflab.ros.messages import geometry_msgs
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.time import Time
from tflab.workbook.tasks import Choice, Slip, Task, Twin, Words

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


def messages(rng: np.random.Generator) -> list[tuple]:
    """Draw messages for each action, gaps on both sides of the limit, one gap longer than its text says, a frame on
    a slower edge than the robot's own, and one that is no name where there is no map yet: tf2 speaks of its target first.
    """
    t = round(float(rng.uniform(20.0, 60.0)), 1)
    drawn = [
        ("laser_frame", rng.uniform(1.2, 3.8)),
        ("laser_frame", 4.0 + rng.uniform(0.05, 0.15)),
        ("laser_frame", 4.0 + rng.uniform(0.17, 0.195)),
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
    slow = point_in("laser_frame", t + 4.0 + round(float(rng.uniform(0.02, 0.1)), 3))
    rows.append((robot_buffer(t, wheels_s=3.4), slow))
    lost = point_in("/laser_frame", round(t + float(rng.uniform(1.2, 3.8)), 3))
    return [*rows, (robot_buffer(t, is_localized=False), lost)]


def action(
    buffer: Buffer,
    message: geometry_msgs.PointStamped,
    *,
    limit_s: float = LIMIT_S,
    by_text: bool | str = False,
    latest: bool = False,
    wait_for_past: bool | str = False,
    swapped: bool = False,
    two_texts: bool = False,
    drops: str = "what is no future",
    spelt: str = "as it came",
    target: str = "map",
    newest_of: tuple[str, str] | None = None,
) -> str:
    """Decide as the task asks; the options are the mistakes."""
    stamp = Time() if latest else Time.from_msg(message.header.stamp)
    written = {"without slashes": lambda name: name.lstrip("/"), "in small letters": str.lower}.get(spelt, str)
    frame = written(message.header.frame_id)
    ends = (target, frame)
    error = refusal(buffer, *(reversed(ends) if swapped else ends), stamp)
    kind = kind_of(error)
    if kind == "future" and drops == "every extrapolation":
        return "drop"
    if kind == "future" and drops == "whole seconds":
        newest_s = buffer.get_latest_common_time("map", frame).nanoseconds // 10**9
        return "wait" if stamp.nanoseconds // 10**9 - newest_s <= limit_s else "check clocks"
    if two_texts and kind == "one sample":
        return "check clocks"
    if kind == "future":
        one, other = newest_of or ("map", "")
        newest_ns = buffer.get_latest_common_time(one, other or frame).nanoseconds
        gap_ns = stamp.nanoseconds - (error.bound_ns if by_text else newest_ns)
        if by_text == "as a float":
            asked_s, newest_s = map(float, re.findall(r"time (\d+\.\d+)", str(error))[:2])
            return "wait" if asked_s - newest_s <= limit_s else "check clocks"
        if by_text == "to its six digits":
            gap_ns = round(stamp.nanoseconds, -3) - round(error.bound_ns, -3)
        return "wait" if gap_ns <= seconds(limit_s) else "check clocks"
    words = {"ok": "use", "past": "drop", "one sample": "drop", "lookup": "check names", "connectivity": "check tree"}
    if kind == "past" and wait_for_past == "the past alone":
        return "wait"
    if wait_for_past is True and kind in ("past", "one sample"):
        return "wait"
    return words.get(kind, "fix message")


WAITS_HOWEVER_FAR = Slip(
    "waits however far",
    {"limit_s": 1e6},
    misconception="M10",
    reply=Words(
        en="your function waits for any future, however far off. A gap of more than 0.2 s is not data on its way: no wait cures it. Is the gap compared with anything, and is it the stamp minus the latest common time? The other way round it is below zero for every future.",
        ko="아무리 먼 미래라도 기다립니다. 0.2초를 넘는 간격은 오는 중인 데이터가 아닙니다. 기다려도 해결되지 않습니다. 간격을 무엇과 비교하고 있습니까? 측정 시각에서 최신 공통 시각을 뺀 것입니까? 반대로 빼면 미래는 언제나 음수입니다.",
    ),
)


GAP_FROM_THE_TEXT = Slip(
    "gap from the text",
    {"by_text": True},
    misconception="M11",
    reply=Words(
        en="the time in the text is that of the first edge that failed, not of the slowest. A wait must last until every edge on the way is there: reckon from the latest common time.",
        ko="오류 메시지의 시각은 처음 실패한 연결의 것이지, 가장 느린 연결의 것이 아닙니다. 경로의 모든 연결이 올 때까지 기다려야 하므로 최신 공통 시각에서 계산하십시오.",
    ),
)


GAP_FROM_THE_TEXT_AS_A_FLOAT = Slip(
    "gap from the text, as a float",
    {"by_text": "as a float"},
    misconception="M11",
    reply=Words(
        en="you read the gap off the text, as decimals. The text names the first edge that failed, not the slowest, and it has six digits; at the limit itself a float errs. Reckon in nanoseconds from the latest common time.",
        ko="오류 메시지에서 간격을 소수로 읽었습니다. 메시지의 시각은 가장 느린 연결이 아니라 처음 실패한 연결의 것이고 여섯 자리뿐이며, 한계에서는 float가 어긋납니다. 최신 공통 시각에서 나노초로 계산하십시오.",
    ),
)


GAP_FROM_THE_TEXT_TO_ITS_DIGITS = Slip(
    "gap from the text, to its six digits",
    {"by_text": "to its six digits"},
    misconception="M11",
    reply=Words(
        en="you read the gap off the text. The text tells of one edge, the first that failed, and another may be slower; nor has it all digits: a nanosecond beyond 0.2 s reads like 0.2 s. Reckon in nanoseconds from the latest common time, which looks at every edge on the way.",
        ko="오류 메시지에서 간격을 읽었습니다. 메시지는 처음 실패한 연결 하나만 말하고, 더 느린 연결이 있을 수 있습니다. 자릿수도 모자라 0.2초를 1나노초 넘어도 0.2초로 보입니다. 경로의 모든 연결을 보는 최신 공통 시각에서 나노초로 계산하십시오.",
    ),
)


GAP_FROM_THE_FIRST_EDGE = Slip(
    "gap from map and odom",
    {"newest_of": ("map", "odom")},
    misconception="M11",
    reply=Words(
        en="you reckon from the newest map in odom alone. The way to the message's frame has other edges, and one of them may be slower: ask for the latest common time of both ends.",
        ko="map과 odom 사이의 최신 시각에서만 계산했습니다. 메시지의 좌표계까지는 다른 연결도 있고, 그중 하나가 더 느릴 수 있습니다. 양 끝의 최신 공통 시각을 물으십시오.",
    ),
)


GAP_FROM_THE_WHEELS_EDGE = Slip(
    "gap from the wheels' edge",
    {"newest_of": ("odom", "base_footprint")},
    misconception="M11",
    reply=Words(
        en="you reckon from the newest odometry alone. The way from map to the message's frame has other edges, and one of them may be slower: ask for the latest common time of both ends.",
        ko="오도메트리의 최신 시각에서만 계산했습니다. map에서 메시지의 좌표계까지는 다른 연결도 있고, 그중 하나가 더 느릴 수 있습니다. 양 끝의 최신 공통 시각을 물으십시오.",
    ),
)


GAP_FROM_THE_ROBOT = Slip(
    "gap from the robot's own pose",
    {"newest_of": ("map", "base_footprint")},
    misconception="M11",
    reply=Words(
        en="you reckon from the newest pose of the robot in map. A message's frame may move on the robot, by an edge of its own that is slower: ask for the latest common time of map and *that* frame.",
        ko="map에서 로봇 포즈의 최신 시각으로 계산했습니다. 메시지의 좌표계가 로봇 위에서 움직이고 그 연결이 더 느릴 수 있습니다. map과 *그* 좌표계의 최신 공통 시각을 물으십시오.",
    ),
)


GAP_BELOW_ODOM = Slip(
    "gap below odom",
    {"newest_of": ("odom", "")},
    misconception="M11",
    reply=Words(
        en="you reckon from odom to the message's frame. The point is wanted in map: the edge from map to odom is on the way, too, and it is often the slowest.",
        ko="odom에서 메시지의 좌표계까지만 계산했습니다. 점은 map 기준으로 필요하므로 map과 odom 사이의 연결도 경로에 있고, 그것이 가장 느릴 때가 많습니다.",
    ),
)


WAITS_FOR_THE_PAST_ALONE = Slip(
    "waits for the past alone",
    {"wait_for_past": "the past alone"},
    misconception="M10",
    reply=Words(
        en='you wait where the text says "into the past". The buffer has forgotten that moment, or never had it: nothing on its way will bring it. Such a message is a "drop".',
        ko='"into the past"일 때 기다립니다. 버퍼가 이미 잊었거나 가진 적이 없는 시각이라 앞으로 올 것이 없습니다. 그런 메시지는 "drop"입니다.',
    ),
)


NEVER_WAITS = Slip(
    "never waits",
    {"limit_s": -1.0},
    misconception="M10",
    reply=Words(
        en="a small gap into the future is ordinary: the transform is on its way. Your function suspects the clocks even then. Between which two moments do you take the gap, and is your bound in its unit?",
        ko="작은 미래 간격은 흔한 일이고 변환이 오는 중입니다. 이 함수는 그때도 시계를 의심합니다. 어느 두 시각의 차이를 구하고, 한계의 단위는 그 차이의 단위와 같습니까?",
    ),
)


LATEST_INSTEAD_OF_THE_STAMP = Slip(
    "latest instead of the stamp",
    {"latest": True},
    misconception="M9",
    reply=Words(
        en="this asks for the latest transform, whatever the message's stamp. Then nothing is ever too old or too new, and the robot uses poses of another moment.",
        ko="메시지의 시각과 상관없이 최신 변환을 묻고 있습니다. 그러면 너무 오래되거나 너무 새로운 것이 없어지고, 로봇은 다른 시각의 포즈를 쓰게 됩니다.",
    ),
)


WAITS_FOR_THE_PAST = Slip(
    "waits for the past",
    {"wait_for_past": True},
    misconception="M10",
    reply=Words(
        en="your function waits for data that is older than everything in the buffer. Old data does not come back: what does a robot do with such a message?",
        ko="버퍼의 모든 것보다 오래된 데이터를 기다리고 있습니다. 지나간 데이터는 돌아오지 않습니다. 그런 메시지는 어떻게 해야 합니까?",
    ),
)


ENDS_SWAPPED = Slip(
    "ends swapped",
    {"swapped": True},
    misconception="M1",
    reply=Words(
        en="where map is unknown and the message's frame is no name at all, tf2 complains of its target first. Your function asks for the other direction, or looks at the frame before tf2 does: data in the message's frame, wanted in map, and map comes first.",
        ko="map을 모르고 메시지의 좌표계도 이름이 될 수 없을 때, tf2는 목표부터 탓합니다. 이 함수는 방향을 거꾸로 묻거나, tf2보다 먼저 좌표계 이름을 따지고 있습니다. 메시지의 좌표계 기준 데이터를 map 기준으로 보려 하니 map이 먼저입니다.",
    ),
)


WAITS_FOR_EVERY_EXTRAPOLATION = Slip(
    "waits for every extrapolation",
    {"limit_s": 1e6, "wait_for_past": True},
    misconception="M10",
    reply=Words(
        en="every extrapolation is a wait for you. Three kinds are in this class: a little into the future may wait, far into the future is a clock, and what is past does not come back. The text tells them apart.",
        ko="외삽이면 무조건 기다립니다. 이 클래스에는 세 가지가 있습니다. 조금 늦은(미래의) 시각은 기다릴 만하고, 한참 늦은(미래의) 시각은 시계 문제이며, 과거는 돌아오지 않습니다. 오류 메시지이 셋을 가려 줍니다.",
    ),
)


THIRD_TEXT_TAKEN_FOR_THE_FUTURE = Slip(
    "third text taken for the future",
    {"two_texts": True},
    misconception="M11",
    reply=Words(
        en='what is not "past" is not yet "future". An edge that has been heard exactly once gives a third text: any other extrapolation is a "drop".',
        ko='"past"가 아니라고 해서 "future"인 것은 아닙니다. 딱 한 번 들은 연결은 세 번째 오류 메시지를 냅니다. 그 밖의 외삽은 "drop"입니다.',
    ),
)


def use_or_drop(buffer: Buffer, message: geometry_msgs.PointStamped) -> str:
    return "use" if action(buffer, message) == "use" else "drop"


ONE_ACTION_FOR_EVERY_NO = Twin(
    "one action for every no",
    use_or_drop,
    misconception="M11",
    reply=Words(
        en='every refusal is a "drop" for you. Then a transform that is 0.1 s late costs a message each time, and a typo is never found: one branch for each class.',
        ko='거절이면 무조건 "drop"입니다. 그러면 변환이 0.1초만 늦어도 매번 메시지를 잃고, 오타는 영영 찾지 못합니다. 클래스마다 분기를 하나씩 두십시오.',
    ),
)


EVERY_EXTRAPOLATION_IS_DROPPED = Slip(
    "every extrapolation is dropped",
    {"drops": "every extrapolation"},
    Words(
        en="you drop every message that meets an extrapolation. One that is newer than the transforms is not lost: 0.2 s or less are worth a wait, and more is a matter of clocks. The text says which way it goes.",
        ko="외삽 오류가 난 메시지를 모두 버립니다. 변환보다 새로운 메시지는 잃은 것이 아닙니다. 0.2초까지는 기다릴 만하고, 그보다 크면 시계의 문제입니다. 방향은 오류 메시지에 있습니다.",
    ),
    "M10",
)


GAP_IN_WHOLE_SECONDS = Slip(
    "gap in whole seconds",
    {"drops": "whole seconds"},
    Words(
        en="you reckon the gap from whole seconds: `sec` alone, or `//`, drops the nanoseconds, and then a gap is 0 or 1 s. Compare nanoseconds.",
        ko="간격을 초 단위로 끊어 계산합니다. `sec`만 쓰거나 `//`로 나누면 나노초가 사라져 간격이 0초 아니면 1초가 됩니다. 나노초로 비교하십시오.",
    ),
)


SLASHES_TAKEN_OFF = Slip(
    "slashes taken off",
    {"spelt": "without slashes"},
    Words(
        en="you take the slash in front off before you ask, and a message that nobody else can place is used: hand over its frame as it came.",
        ko="묻기 전에 이름 앞의 슬래시를 떼어, 다른 노드는 위치를 알 수 없는 메시지를 씁니다. 좌표계 이름을 받은 그대로 넘기십시오.",
    ),
    "M14",
)


IN_SMALL_LETTERS = Slip(
    "names in small letters",
    {"spelt": "in small letters"},
    Words(
        en="you write the frame in small letters before you ask. `Laser_frame` is another name than `laser_frame`, and tf2 does not know it.",
        ko="묻기 전에 좌표계 이름을 소문자로 바꿉니다. `Laser_frame`은 `laser_frame`과 다른 이름이고 tf2는 그것을 모릅니다.",
    ),
    "M14",
)


THE_LIMIT_IS_TOO_FAR = Slip(
    "the limit is too far",
    {"limit_s": LIMIT_S - 1e-9},
    Words(
        en='at exactly 0.2 s you check the clocks already, and "0.2 s or less" lets the limit itself wait. Is it `<` where `<=` is meant? If not, you compare seconds as floats, whose last digit errs: then just 0.2 comes out larger. Compare nanoseconds, which are whole numbers.',
        ko='간격이 정확히 0.2초일 때 이미 시계를 의심합니다. "0.2초 이하"이므로 한계 자체는 기다려야 합니다. `<=`를 쓸 곳에 `<`를 썼습니까? 아니라면 초를 float로 비교한 것입니다. 마지막 자리가 어긋나 0.2가 조금 더 커집니다. 정수인 나노초로 비교하십시오.',
    ),
)

LIMIT_OF_A_QUARTER = Slip(
    "another limit",
    {"limit_s": 0.25},
    Words(
        en="you wait somewhat beyond 0.2 s. The task draws the line at 0.2 s sharp; 0.2 s are 200 000 000 ns.",
        ko="0.2초를 조금 넘어도 기다립니다. 문제의 기준은 정확히 0.2초이고, 0.2초는 200 000 000 ns입니다.",
    ),
)


WANTED_IN_BASE_LINK = Slip(
    "wanted in base_link",
    {"target": "base_link"},
    Words(
        en="you ask for base_link. The point is wanted in map, and that chain is longer: it has other edges to wait for.",
        ko="base_link를 물었습니다. 점은 map 기준으로 필요하고, 그 사슬에는 기다려야 할 연결이 더 있습니다.",
    ),
)


WANTED_IN_ODOM = Slip(
    "wanted in odom",
    {"target": "odom"},
    Words(
        en="you ask for odom. The point is wanted in map: that is one edge more, and often the slowest.",
        ko="odom을 물었습니다. 점은 map 기준으로 필요합니다. 연결이 하나 더 있고, 그것이 가장 느릴 때가 많습니다.",
    ),
)


TASK = Task(
    id="E9.3",
    kind="F",
    points=4,
    title=Words(en="From exception to action", ko="예외에서 행동으로"),
    answer="decide",
    form=Choice(ACTIONS),
    inputs=messages,
    variants=3,
    model=action,
    twins=(
        WAITS_HOWEVER_FAR,
        GAP_FROM_THE_TEXT,
        GAP_FROM_THE_TEXT_AS_A_FLOAT,
        GAP_FROM_THE_TEXT_TO_ITS_DIGITS,
        GAP_FROM_THE_FIRST_EDGE,
        GAP_FROM_THE_WHEELS_EDGE,
        GAP_FROM_THE_ROBOT,
        GAP_BELOW_ODOM,
        WAITS_FOR_THE_PAST_ALONE,
        NEVER_WAITS,
        LATEST_INSTEAD_OF_THE_STAMP,
        WAITS_FOR_THE_PAST,
        ENDS_SWAPPED,
        WAITS_FOR_EVERY_EXTRAPOLATION,
        THIRD_TEXT_TAKEN_FOR_THE_FUTURE,
        ONE_ACTION_FOR_EVERY_NO,
        EVERY_EXTRAPOLATION_IS_DROPPED,
        GAP_IN_WHOLE_SECONDS,
        SLASHES_TAKEN_OFF,
        IN_SMALL_LETTERS,
        THE_LIMIT_IS_TOO_FAR,
        LIMIT_OF_A_QUARTER,
        WANTED_IN_BASE_LINK,
        WANTED_IN_ODOM,
    ),
    hints=(
        Words(
            en="It is E9.2 with other words, and one comparison more.",
            ko="E9.2와 같되 낱말이 다르고 비교가 하나 더 있습니다.",
        ),
        Words(
            en="For the future, `buffer.get_latest_common_time(target, source)` says how far TF has come. Compare nanoseconds: Times of two clock types cannot be subtracted.",
            ko="미래라면 `buffer.get_latest_common_time(target, source)`가 TF가 어디까지 왔는지 알려 줍니다. 시계 종류가 다른 Time끼리는 뺄 수 없으니 나노초로 비교하십시오.",
        ),
        Words(
            en='gap = stamp.nanoseconds − newest.nanoseconds; up to 0.2e9 "wait", beyond "check clocks". Every extrapolation that is not into the future is a "drop".',
            ko='gap = stamp.nanoseconds − newest.nanoseconds이고, 0.2e9까지는 "wait", 넘으면 "check clocks"입니다. 미래가 아닌 외삽은 모두 "drop"입니다.',
        ),
    ),
    seen={
        "use": Words(
            en="There tf2 answers at the message's own stamp.",
            ko="여기서는 메시지의 측정 시각에 tf2가 답합니다.",
        ),
        "wait": Words(
            en="There the message is at most 0.2 s newer than the latest common time of map and its frame.",
            ko="여기서는 메시지가 map과 메시지 좌표계의 최신 공통 시각보다 많아야 0.2초 나중 것입니다.",
        ),
        "check clocks": Words(
            en="There the message is more than 0.2 s newer than the latest common time of map and its frame.",
            ko="여기서는 메시지가 map과 메시지 좌표계의 최신 공통 시각보다 0.2초 넘게 새롭습니다.",
        ),
        "drop": Words(
            en="There an extrapolation does not lead into the future, so that nothing on its way can help.",
            ko="여기서는 외삽이 미래를 향하지 않아, 앞으로 올 것이 도움이 되지 않습니다.",
        ),
        "check names": Words(
            en="There tf2 does not know a name, and asks for no path and no moment then.",
            ko="여기서는 tf2가 이름을 모르고, 그러면 길도 시각도 묻지 않습니다.",
        ),
        "check tree": Words(
            en="There tf2 knows both names, and no path leads from one to the other.",
            ko="여기서는 tf2가 두 이름을 다 알지만 둘을 잇는 길이 없습니다.",
        ),
        "fix message": Words(
            en="There the question is none, by a slash in front or an empty name.",
            ko="여기서는 앞의 슬래시나 빈 이름 때문에 질문이 되지 않습니다.",
        ),
    },
    cures=("M9", "M10", "M11"),
    equivalent={
        "buffer.get_latest_common_time('map', source) -> buffer.get_latest_common_time(source, 'map') in: newest = buffer.get_latest_common_time('map', source)": "the latest "
        "common time of two frames is the same whichever comes first",
    },
)
