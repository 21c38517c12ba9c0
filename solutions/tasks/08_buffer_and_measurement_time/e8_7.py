"""E8.7: Where is it now?"""

from __future__ import annotations

from tflab.ros.time import Time
from tflab.workbook.tasks import Task, Twin, Vector, Words

from .draws import _moved, _time, drive, seen


def resting_objects(rng):
    """The robot drives on between the sighting and now, and the localiser corrects itself in between."""
    rows = []
    for share, later in ((0.05, 0.9), (0.2, 0.95), (0.35, 0.9), (0.1, 0.85), (0.5, 1.0), (0.3, 0.97)):
        buffer, start_s, end_s, sensor = drive(rng)
        stamp_s, now_s = (round(start_s + part * (end_s - start_s), 3) for part in (share, later))
        rows.append((buffer, seen(rng, sensor, stamp_s), _time(now_s)))
    return rows


def _at(buffer, message, target_time, source_time, fixed="odom"):
    frame = message.header.frame_id
    point = _moved(message, buffer.lookup_transform_full("base_link", target_time, frame, source_time, fixed)).point
    return (point.x, point.y, point.z)


def _stamp(message):
    return Time.from_msg(message.header.stamp)


BASE_LINK_THEN = Twin(
    "base_link then",
    lambda buffer, message, now: _at(buffer, message, _stamp(message), _stamp(message)),
    Words(
        en="That is the object in the base_link of one single moment, as if the robot had stood still between the sighting and now. It has driven on.",
        ko="어느 한 순간의 base_link 기준으로만 구한 위치입니다. 본 때와 지금 사이에 로봇이 서 있었던 것처럼 계산했지만, 로봇은 계속 달렸습니다.",
    ),
    "M9",
)


LATEST_INSTEAD_OF_NOW = Twin(
    "latest instead of now",
    lambda buffer, message, now: _at(buffer, message, Time(), _stamp(message)),
    Words(
        en="The moment of the sighting is right. But for base_link you took `Time()`, the newest pose in the buffer, and `now` is asked for.",
        ko="본 순간은 맞습니다. 그런데 base_link에는 버퍼의 가장 새로운 자세를 뜻하는 `Time()`을 썼습니다. 필요한 것은 `now`입니다.",
    ),
    "M9",
)


TIMES_SWAPPED = Twin(
    "times swapped",
    lambda buffer, message, now: _at(buffer, message, _stamp(message), now),
    Words(
        en="The two times are swapped: you moved a sighting of now into the base_link of then. Each frame is followed by its own time.",
        ko="두 시각이 뒤바뀌었습니다. 지금 본 것을 그때의 base_link로 옮겼습니다. 좌표계마다 바로 뒤에 자기 시각이 옵니다.",
    ),
)


THROUGH_MAP = Twin(
    "through map",
    lambda buffer, message, now: _at(buffer, message, now, _stamp(message), "map"),
    Words(
        en="You went through map. Between the two moments the localiser corrected itself, map jumped, and the object jumped with it; odom runs on smoothly.",
        ko="map을 거쳐 갔습니다. 두 순간 사이에 위치 추정이 보정하면서 map이 뛰었고 물체도 함께 뛰었습니다. odom은 매끄럽게 이어집니다.",
    ),
    "M8",
)


def _left_in_odom(buffer, message):
    point = _moved(message, buffer.lookup_transform("odom", message.header.frame_id, _stamp(message))).point
    return (point.x, point.y, point.z)


LEFT_IN_ODOM = Twin(
    "left in odom",
    lambda buffer, message, now: _left_in_odom(buffer, message),
    Words(
        en="These are the coordinates in odom, where the two moments meet. Asked for is base_link, as it is at `now`: one more step.",
        ko="두 순간이 만나는 odom 기준의 좌표입니다. 필요한 것은 `now` 시각의 base_link 기준 좌표입니다. 한 걸음 더 가십시오.",
    ),
)


def _the_wrong_way(buffer, message, now):
    then_T_now = buffer.lookup_transform_full(message.header.frame_id, _stamp(message), "base_link", now, "odom")
    point = _moved(message, then_T_now).point
    return (point.x, point.y, point.z)


THE_WRONG_WAY = Twin(
    "the wrong way",
    lambda buffer, message, now: _the_wrong_way(buffer, message, now),
    Words(
        en="Target and source are swapped. The target with its time comes first: base_link, now.",
        ko="목표와 원본이 뒤바뀌었습니다. 목표와 그 시각이 먼저입니다. base_link와 now입니다.",
    ),
    "M1",
)


TASK = Task(
    id="E8.7",
    kind="F",
    points=4,
    title=Words(en="Where is it now?", ko="지금은 어디에 있습니까?"),
    answer="object_now",
    form=Vector(3, unit="m", frame="base_link", tolerance=0.002),
    inputs=resting_objects,
    variants=3,
    twins=(
        BASE_LINK_THEN,
        LATEST_INSTEAD_OF_NOW,
        TIMES_SWAPPED,
        LEFT_IN_ODOM,
        THE_WRONG_WAY,
        THROUGH_MAP,
    ),
    hints=(
        Words(
            en="Two moments, so one stamp is not enough. Which lookup takes two times?",
            ko="순간이 둘이므로 측정 시각 하나로는 모자랍니다. 시각을 둘 받는 조회는 무엇입니까?",
        ),
        Words(
            en="`lookup_transform_full(target, its time, source, its time, fixed)`. Which of your moments belongs to the target?",
            ko="`lookup_transform_full(target, 그 시각, source, 그 시각, fixed)`입니다. 두 순간 가운데 어느 것이 목표의 시각입니까?",
        ),
        Words(
            en="base_link at `now`, the message's frame at its stamp, fixed in odom; then `do_transform_point(message, ...)`, and its `.point`.",
            ko="base_link는 `now`, 메시지의 좌표계는 그 측정 시각, 고정은 odom입니다. 그다음 `do_transform_point(message, ...)`의 `.point`입니다.",
        ),
    ),
    cures=("M9", "M8"),
    equivalent={
        "Time.from_msg(message.header.stamp) -> message.header.stamp in: stamp = Time.from_msg(message.header.stamp)": (
            "a lookup takes a message's stamp as it takes a Time"
        ),
    },
)
