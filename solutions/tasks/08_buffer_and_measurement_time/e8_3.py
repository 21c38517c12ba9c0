"""E8.3: PointToMap: a point onto the map."""

from __future__ import annotations

from tflab.ros.messages import geometry_msgs, std_msgs
from tflab.ros.time import Time
from tflab.workbook.tasks import Message, Task, Twin, Words

from .draws import _moved, _time, drive, seen


def sightings(rng):
    """Points from within the buffer, one from before it, and one whose transform has not come yet."""
    rows = []
    for share in (0.1, 0.35, 0.6, 0.75, -0.3, 1.2):
        buffer, start_s, end_s, sensor = drive(rng)
        stamp_s = round(start_s + share * (end_s - start_s), 3)
        now_s = round(max(end_s, stamp_s) + float(rng.uniform(0.45, 0.7)), 3)
        rows.append((buffer, seen(rng, sensor, stamp_s), _time(now_s)))
    return rows


def latest(buffer, message, now):
    return _moved(message, buffer.lookup_transform("map", message.header.frame_id, Time()))


LATEST = Twin(
    "latest",
    latest,
    Words(
        en="You asked for `Time()`, the latest common time, and the point was moved with a pose from another moment. No error came, did it? Use the message's own stamp.",
        ko="최신 공통 시각인 `Time()`으로 물어서, 점이 다른 순간의 자세로 옮겨졌습니다. 오류는 나지 않았습니다. 메시지 자신의 측정 시각을 쓰십시오.",
    ),
    "M9",
)


def fresh_stamp(buffer, message, now):
    return _moved(message, buffer.lookup_transform("map", message.header.frame_id, now))


NOW = Twin(
    "now",
    fresh_stamp,
    Words(
        en="You asked for `now`, the moment of arrival. The buffer refuses, for nothing in it is that fresh; and if it did answer, it would be for the wrong moment.",
        ko="도착한 순간인 `now`로 물었습니다. 버퍼에 그만큼 새로운 것이 없어 거절합니다. 설령 답하더라도 틀린 순간의 답입니다.",
    ),
    "M9",
)


def falls_back(buffer, message, now):
    from tflab.core import TransformException

    try:
        return _moved(message, buffer.lookup_transform("map", message.header.frame_id, message.header.stamp))
    except TransformException:
        return latest(buffer, message, now)


FALLS_BACK_ON_LATEST = Twin(
    "falls back on latest",
    falls_back,
    Words(
        en="Where the buffer refuses, you fall back on the latest transform. That turns an honest refusal into a wrong point: let the exception through.",
        ko="버퍼가 거절하면 최신 변환으로 물러섭니다. 정직한 거절을 틀린 점으로 바꾸는 일입니다. 예외를 그대로 내보내십시오.",
    ),
    "M9",
)


def swallows(buffer, message, now):
    from tflab.core import TransformException

    try:
        return _moved(message, buffer.lookup_transform("map", message.header.frame_id, message.header.stamp))
    except TransformException:
        return None


SWALLOWS_THE_REFUSAL = Twin(
    "swallows the refusal",
    swallows,
    Words(
        en="Where the buffer refuses, you return nothing, and nobody learns why. Let the exception through: whoever calls you decides what to do.",
        ko="버퍼가 거절하면 아무것도 반환하지 않아 아무도 이유를 알지 못합니다. 예외를 그대로 내보내십시오. 어떻게 할지는 부른 쪽이 정합니다.",
    ),
    "M11",
)


def swapped(buffer, message, now):
    return _moved(message, buffer.lookup_transform(message.header.frame_id, "map", message.header.stamp))


SWAPPED = Twin(
    "swapped",
    swapped,
    Words(
        en="Target and source are swapped. Say it: data expressed in the message's frame, wanted in map. The wanted one comes first.",
        ko="목표와 원본이 뒤바뀌었습니다. 소리 내어 말해 보십시오. “메시지의 좌표계 기준 데이터를 map 기준으로 보고 싶다.” 보고 싶은 쪽이 먼저입니다.",
    ),
    "M1",
)


def restamped(buffer, message, now):
    moved = _moved(message, buffer.lookup_transform("map", message.header.frame_id, message.header.stamp))
    moved.header.stamp = now.to_msg()
    return moved


STAMPED_ANEW = Twin(
    "stamped anew",
    restamped,
    Words(
        en="The place is right, but your point says that it was measured when it arrived. Whoever uses it next can no longer ask about the right moment.",
        ko="위치는 맞지만, 여러분의 점은 도착한 때 측정했다고 말합니다. 다음에 쓰는 사람은 올바른 순간을 물을 수 없게 됩니다.",
    ),
    "M9",
)


def relabelled(buffer, message, now):
    header = std_msgs.Header(stamp=message.header.stamp, frame_id="map")
    return geometry_msgs.PointStamped(header=header, point=message.point)


ONLY_THE_LABEL = Twin(
    "only the label",
    relabelled,
    Words(
        en="You wrote map on the label, and left the numbers as the sensor gave them. A frame is not a name to be changed: the point itself has to be moved.",
        ko="꼬리표만 map으로 바꾸고 숫자는 센서가 준 그대로 두었습니다. 좌표계는 이름만 바꾼다고 바뀌지 않습니다. 점의 숫자를 옮겨야 합니다.",
    ),
)


def only_odom(buffer, message, now):
    return _moved(message, buffer.lookup_transform("odom", message.header.frame_id, message.header.stamp))


LEFT_IN_ODOM = Twin(
    "left in odom",
    only_odom,
    Words(
        en="You stopped in odom. The moment is right, but asked for is map: one edge further up.",
        ko="odom에서 멈추었습니다. 순간은 맞지만 필요한 것은 map입니다. 한 연결 더 올라가야 합니다.",
    ),
)


TASK = Task(
    id="E8.3",
    kind="F",
    points=4,
    title=Words(en="PointToMap: a point onto the map", ko="PointToMap: 점을 지도 위로"),
    answer="point_to_map",
    form=Message("geometry_msgs/msg/PointStamped", ("point", "header.frame_id", "header.stamp"), tolerance=0.002),
    inputs=sightings,
    variants=3,
    twins=(
        LATEST,
        NOW,
        FALLS_BACK_ON_LATEST,
        SWALLOWS_THE_REFUSAL,
        SWAPPED,
        STAMPED_ANEW,
        ONLY_THE_LABEL,
        LEFT_IN_ODOM,
    ),
    hints=(
        Words(
            en="Value, frame, stamp: all three stand in the message. Which two does the lookup need besides the target?",
            ko="값, 좌표계, 측정 시각이 모두 메시지에 있습니다. 조회에는 목표 말고 어느 둘이 필요합니까?",
        ),
        Words(
            en="tf2 has a method of the buffer that reads frame and stamp off the message itself.",
            ko="tf2의 버퍼에는 좌표계와 측정 시각을 메시지에서 직접 읽는 메서드가 있습니다.",
        ),
        Words(
            en="`buffer.transform(message, ...)` takes the message and the target frame, and keeps the stamp. No try, no now.",
            ko="`buffer.transform(message, ...)`은 메시지와 목표 좌표계를 받고 측정 시각을 지킵니다. try도 now도 필요 없습니다.",
        ),
    ),
    cures=("M9", "M1"),
)
