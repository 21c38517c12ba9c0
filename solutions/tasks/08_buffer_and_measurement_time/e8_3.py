"""E8.3: PointToMap: a point onto the map."""

from __future__ import annotations

import math

from tflab.core import ExtrapolationException, TransformException
from tflab.ros.messages import builtin_interfaces, geometry_msgs, std_msgs
from tflab.ros.time import Time
from tflab.workbook.tasks import Message, Task, Text, WrongStep

from .draws import _moved, _time, drive, seen


def sightings(rng):
    """Points from within the buffer, one from before it, and one whose transform has not come yet."""
    rows = []
    for share in (0.1, 0.35, 0.6, 0.75, -0.3, 1.2, 0.15, -0.15):
        buffer, start_s, end_s, sensor = drive(rng)
        stamp_s = round(start_s + share * (end_s - start_s), 3)
        if share == 0.1:  # its nanosec starts with a zero, and without that zero there is a transform, too
            stamp_s = round(math.floor(start_s) + 0.045, 3)
        now_s = round(max(end_s, stamp_s) + float(rng.uniform(0.45, 0.7)), 3)
        if share == 0.1:  # it came at once, and transforms have gone on coming
            now_s = round(stamp_s + 0.3, 3)
        if share == 0.15:  # it is old, and transforms have come for what is now
            now_s = round(stamp_s + 0.9, 3)
        if share == -0.15:  # it is from before all transforms, and there are some for what is now
            now_s = round(start_s + 0.5, 3)
        rows.append((buffer, seen(rng, sensor, stamp_s), _time(now_s)))
    return rows


def asked_at(moment, stamp, now):
    """Return for which time the buffer is asked."""
    right = Time.from_msg(stamp)
    return {
        "stamp": right,
        "latest": Time(),
        "now": now,
        "sec alone": Time(seconds=stamp.sec),
        "digits": Time(seconds=float(f"{stamp.sec}.{stamp.nanosec}")),
        "a tenth before now": Time(nanoseconds=now.nanoseconds - 100_000_000),
        "half way": Time(nanoseconds=(right.nanoseconds + now.nanoseconds) // 2),
    }[moment]


def looked_up(buffer, names, moment, stamp, now):
    """Return the transform for one moment, or for two: that of map, and that of the sensor."""
    one, _, other = moment.partition(" and ")
    target_time, source_time = (asked_at(each, stamp, now) for each in (one, other or one))
    if not other:
        return buffer.lookup_transform(*names, target_time)
    return buffer.lookup_transform_full(names[0], target_time, names[1], source_time, "odom")


def on_the_map(buffer, message, now, *, ends="wanted first", target="map", source="the message's", moment="stamp",
               refusal="let through", move="all", stamp="kept", asks="nothing", label="true"):  # fmt: skip
    """Return the point, step by step; other steps are the slips."""
    if move == "label":
        return geometry_msgs.PointStamped(
            header=std_msgs.Header(stamp=message.header.stamp, frame_id=target), point=message.point
        )
    if asks == "for now" and not buffer.can_transform(target, message.header.frame_id, now):
        return None
    if asks.startswith("how old") and now.nanoseconds - Time.from_msg(message.header.stamp).nanoseconds > 400_000_000:
        if asks == "how old, and refuses":
            raise ExtrapolationException("too old")
        return None
    names = (target, message.header.frame_id if source == "the message's" else source)
    names = names[::-1] if ends == "swapped" else names
    try:
        transform = looked_up(buffer, names, moment, message.header.stamp, now)
    except TransformException:
        if refusal == "let through":
            raise
        if refusal == "None":
            return None
        if refusal == "as it came":
            return message
        transform = buffer.lookup_transform(*names, now if refusal == "now" else Time())
    if move == "nothing":
        return message
    if move == "step":
        transform.transform.rotation = geometry_msgs.Quaternion(w=1.0)
    if move == "turn":
        transform.transform.translation = geometry_msgs.Vector3()
    if move == "turned back":
        transform.transform.rotation.z *= -1.0
    if move == "half turned":
        yaw = math.atan2(transform.transform.rotation.z, transform.transform.rotation.w)
        transform.transform.rotation = geometry_msgs.Quaternion(z=math.sin(yaw / 2), w=math.cos(yaw / 2))
    if move == "step taken off":
        step = transform.transform.translation
        transform.transform.translation = geometry_msgs.Vector3(x=-step.x, y=-step.y, z=-step.z)
        transform.transform.rotation = geometry_msgs.Quaternion(w=1.0)
    moved = _moved(message, transform)
    if move == "on the floor":
        moved.point.z = message.point.z
    moved = _moved(moved, transform) if move == "twice" else moved
    stamps = {"now": now.to_msg(), "zero": builtin_interfaces.Time(), "put back": message.header.stamp}
    moved.header.stamp = stamps.get(stamp, moved.header.stamp)
    moved.header.frame_id = "map" if label == "map" else moved.header.frame_id
    return moved


LATEST = WrongStep(
    "latest",
    {"moment": "latest"},
    Text(
        en="The point was moved with the latest transform there is, as `Time()` gives it: with a pose from another moment. No error came, did it? Use the message's own stamp.",
        ko="`Time()`이 주는 최신 변환, 곧 다른 순간의 포즈로 점을 옮겼습니다. 오류는 나지 않았습니다. 메시지 자신의 측정 시각을 쓰십시오.",
    ),
    "M9",
)


NOW = WrongStep(
    "now",
    {"moment": "now"},
    Text(
        en="You asked for `now`, the moment of arrival. Mostly the buffer refuses, for nothing in it is that fresh; and where it does answer, it is for the wrong moment.",
        ko="도착한 순간인 `now`로 물었습니다. 버퍼에 그만큼 새로운 것이 없으면 거절하고, 답하더라도 틀린 순간의 답입니다.",
    ),
    "M9",
)


FALLS_BACK_ON_LATEST = WrongStep(
    "falls back on latest",
    {"refusal": "latest"},
    Text(
        en="Where the buffer refuses, you fall back on the latest transform. That turns an honest refusal into a wrong point: let the exception through.",
        ko="버퍼가 거절하면 최신 변환으로 물러섭니다. 정직한 거절을 틀린 점으로 바꾸는 일입니다. 예외를 그대로 내보내십시오.",
    ),
    "M9",
)


FALLS_BACK_AND_PUTS_BACK = WrongStep(
    "falls back on latest, and the stamp put back",
    {"refusal": "latest", "stamp": "put back"},
    Text(
        en="Where the buffer refuses, you take the latest transform and put the message's own stamp on the result: a wrong point, and a label that hides it. Let the exception through.",
        ko="버퍼가 거절하면 최신 변환을 쓰고 결과에 메시지의 측정 시각을 적습니다. 틀린 점인데 이름표가 그것을 숨깁니다. 예외를 그대로 내보내십시오.",
    ),
    "M9",
)


ASKS_FOR_NOW_FIRST = WrongStep(
    "asks for now first",
    {"asks": "for now"},
    Text(
        en="You answer only where there is a transform for `now`, too, and mostly there is none yet: nothing in the buffer is that fresh. Whether there is one for the stamp, the lookup itself tells.",
        ko="`now`의 변환까지 있을 때만 답하는데, 버퍼에 그만큼 새로운 것은 대개 아직 없습니다. 측정 시각의 변환이 있는지는 조회가 직접 알려 줍니다.",
    ),
    "M9",
)


SWALLOWS_THE_REFUSAL = WrongStep(
    "swallows the refusal",
    {"refusal": "None"},
    Text(
        en="Where the buffer refuses, you return nothing, and nobody learns why. Let the exception through: whoever calls you decides what to do.",
        ko="버퍼가 거절하면 아무것도 반환하지 않아 아무도 이유를 알지 못합니다. 예외를 그대로 내보내십시오. 어떻게 할지는 호출한 쪽이 정합니다.",
    ),
    "M11",
)


SWAPPED = WrongStep(
    "swapped",
    {"ends": "swapped"},
    Text(
        en="Target and source are swapped. Say it: data expressed in the message's frame, wanted in map. The wanted one comes first.",
        ko="목표와 원본이 뒤바뀌었습니다. 소리 내어 말해 보십시오. “메시지의 좌표계 기준 데이터를 map 기준으로 보고 싶다.” 기준이 될 좌표계, 곧 목표가 먼저입니다.",
    ),
    "M1",
)


STAMPED_ANEW = WrongStep(
    "stamped anew",
    {"stamp": "now"},
    Text(
        en="Your point says that it was measured when it arrived. Whoever uses it next can no longer ask about the right moment.",
        ko="반환한 점의 측정 시각이 도착 시각으로 되어 있습니다. 다음에 쓰는 사람은 올바른 시각의 변환을 조회할 수 없게 됩니다.",
    ),
    "M9",
)


ONLY_THE_LABEL = WrongStep(
    "only the label",
    {"move": "label"},
    Text(
        en="You wrote map on the label, and left the numbers as the sensor gave them. A frame is not a name to be changed: the point itself has to be moved.",
        ko="이름표만 map으로 바꾸고 숫자는 센서가 준 그대로 두었습니다. 좌표계는 이름만 바꾼다고 바뀌지 않습니다. 점의 숫자를 옮겨야 합니다.",
    ),
)


LEFT_IN_ODOM = WrongStep(
    "left in odom",
    {"target": "odom"},
    Text(
        en="You stopped in odom. Asked for is map: one edge further up.",
        ko="odom에서 멈추었습니다. 필요한 것은 map입니다. 한 연결 더 올라가야 합니다.",
    ),
)

ODOM_CALLED_MAP = WrongStep(
    "odom called map",
    {"target": "odom", "label": "map"},
    Text(
        en="You moved the point into odom and wrote map on it. The numbers are still counted from odom: look up one edge further.",
        ko="점을 odom까지만 옮기고 이름표에 map이라고 썼습니다. 숫자는 아직 odom 기준입니다. 한 연결 더 올라가 조회하십시오.",
    ),
)

LATEST_PUT_BACK = WrongStep(
    "latest, and the stamp put back",
    {"moment": "latest", "stamp": "put back"},
    Text(
        en="You asked for the latest transform and put the message's stamp back afterwards. The label is true again, and the numbers are those of another moment.",
        ko="최신 변환을 조회한 뒤 메시지의 측정 시각을 되돌려 놓았습니다. 이름표는 다시 맞지만 숫자는 다른 순간의 것입니다.",
    ),
    "M9",
)

NOW_PUT_BACK = WrongStep(
    "now, and the stamp put back",
    {"moment": "now", "stamp": "put back"},
    Text(
        en="You asked for `now`, and the label says the message's stamp. Mostly the buffer refuses, for nothing in it is that fresh; where it does answer, the numbers are those of the moment of arrival.",
        ko="`now`의 변환을 조회했는데, 이름표에는 메시지의 측정 시각이 있습니다. 버퍼에 그만큼 새로운 것은 대개 없어서 거절하고, 답하더라도 숫자는 도착한 순간의 것입니다.",
    ),
    "M9",
)

FROM_BASE_LINK = WrongStep(
    "from base_link",
    {"source": "base_link"},
    Text(
        en="You asked from base_link. The numbers were counted in the frame that the message names.",
        ko="base_link를 원본으로 물었습니다. 숫자는 메시지에 적힌 좌표계에서 센 것입니다.",
    ),
)

FROM_ODOM = WrongStep(
    "from odom",
    {"source": "odom"},
    Text(
        en="You asked from odom. The numbers were counted in the frame that the message names.",
        ko="odom을 원본으로 물었습니다. 숫자는 메시지에 적힌 좌표계에서 센 것입니다.",
    ),
)

ALWAYS_FROM_THE_LASER = WrongStep(
    "always from laser_frame",
    {"source": "laser_frame"},
    Text(
        en='You wrote the name "laser_frame" into your function. The message says itself in which frame its numbers are: `message.header.frame_id`, and here it is not always the same.',
        ko='함수 안에 "laser_frame"이라는 이름을 적어 두었습니다. 숫자가 어느 좌표계 기준인지는 메시지의 `message.header.frame_id`에 있고, 늘 같지는 않습니다.',
    ),
    "M14",
)

ALWAYS_FROM_THE_CAMERA = WrongStep(
    "always from camera_link",
    {"source": "camera_link"},
    Text(
        en='You wrote the name "camera_link" into your function. The message says itself in which frame its numbers are: `message.header.frame_id`, and here it is not always the same.',
        ko='함수 안에 "camera_link"라는 이름을 적어 두었습니다. 숫자가 어느 좌표계 기준인지는 메시지의 `message.header.frame_id`에 있고, 늘 같지는 않습니다.',
    ),
    "M14",
)

SEC_ALONE = WrongStep(
    "sec alone",
    {"moment": "sec alone"},
    Text(
        en="You asked for the stamp's sec alone: up to a second too early. `Time.from_msg(stamp)` reads both fields.",
        ko="sec만으로 물었습니다. 최대 1초나 이릅니다. `Time.from_msg(stamp)`는 두 항목을 모두 읽습니다.",
    ),
)

HALF_WAY = WrongStep(
    "half way to now",
    {"moment": "half way"},
    Text(
        en="You asked for a moment between measuring and arriving. The point was where it was at the stamp.",
        ko="측정과 도착 사이의 순간으로 물었습니다. 점은 측정 시각에 거기 있었습니다.",
    ),
    "M9",
)

STEP_ALONE = WrongStep(
    "step alone",
    {"move": "step"},
    Text(
        en="You added the translation and left the rotation out. The sensor looks another way than the map's x.",
        ko="이동만 더하고 회전을 빠뜨렸습니다. 센서는 지도의 x와 다른 쪽을 봅니다.",
    ),
)

TURN_ALONE = WrongStep(
    "turn alone",
    {"move": "turn"},
    Text(
        en="You turned the point and left the translation out: the sensor does not stand where the map begins.",
        ko="점을 돌리기만 하고 이동을 빠뜨렸습니다. 센서는 지도의 원점에 있지 않습니다.",
    ),
)

MOVED_TWICE = WrongStep(
    "moved twice",
    {"move": "twice"},
    Text(
        en="The point was moved twice by the same transform: once it is in map, it stays.",
        ko="같은 변환으로 점을 두 번 옮겼습니다. 한 번 옮기면 이미 map 기준입니다.",
    ),
)

STAMP_LOST = WrongStep(
    "stamp lost",
    {"stamp": "zero"},
    Text(
        en="Your point has no stamp any more. Whoever uses it next asks for the latest without knowing it.",
        ko="결과에 측정 시각이 없습니다. 다음에 쓰는 쪽은 모르는 사이에 최신을 묻게 됩니다.",
    ),
    "M9",
)

AS_IT_CAME = WrongStep(
    "as it came",
    {"refusal": "as it came"},
    Text(
        en="Where the buffer refuses, you hand the message on, its numbers still in the sensor's frame. Let the exception through.",
        ko="버퍼가 거절하면 메시지를 그대로 넘기는데, 숫자는 아직 센서 좌표계의 것입니다. 예외를 그대로 내보내십시오.",
    ),
    "M11",
)


DIGITS = WrongStep(
    "digits",
    {"moment": "digits"},
    Text(
        en="The digits of nanosec stand right behind the decimal point: 45000000 ns is 0.045 s, not 0.45 s. `Time.from_msg(stamp)` has it right.",
        ko="nanosec의 숫자가 소수점 바로 뒤에 왔습니다. 45000000 ns는 0.45초가 아니라 0.045초입니다. `Time.from_msg(stamp)`를 쓰면 됩니다.",
    ),
)


A_TENTH_BEFORE_NOW = WrongStep(
    "a tenth before now",
    {"moment": "a tenth before now"},
    Text(
        en="You asked for a tenth of a second before now. How old a message is differs each time, and its stamp says when it was.",
        ko="현재보다 0.1초 전을 물었습니다. 메시지의 나이는 매번 다르고, 언제 측정했는지는 측정 시각에 적혀 있습니다.",
    ),
    "M9",
)


MAP_OF_NOW = WrongStep(
    "map of now",
    {"moment": "now and stamp"},
    Text(
        en="You ask for two moments: map → odom as it is at `now`, and only the rest of the way at the stamp. For `now` there is mostly nothing yet, and the point lay where it was at the stamp: ask the whole way at that.",
        ko="두 시각을 섞었습니다. map → odom은 `now`의 것을, 나머지 경로만 측정 시각의 것을 물었습니다. `now`에는 대개 아직 아무것도 없고, 점은 측정 시각의 그 자리에 있었습니다. 경로 전체를 측정 시각으로 물으십시오.",
    ),
    "M9",
)


MAP_OF_THE_LATEST = WrongStep(
    "map of the latest",
    {"moment": "latest and stamp"},
    Text(
        en="You ask for two moments: the newest map → odom, and only the rest of the way at the stamp. Where the localiser has corrected itself since, the point jumps: ask the whole way at the stamp.",
        ko="두 시각을 섞었습니다. map → odom은 가장 새로운 것을, 나머지 경로만 측정 시각의 것을 물었습니다. 그사이 위치 추정이 보정했다면 점이 튑니다. 경로 전체를 측정 시각으로 물으십시오.",
    ),
    "M9",
)


ROBOT_OF_THE_LATEST = WrongStep(
    "robot of the latest",
    {"moment": "stamp and latest"},
    Text(
        en="You ask for two moments: map → odom at the stamp, and the robot in odom where it was last. It has driven on since it saw the point: ask the whole way at the stamp.",
        ko="두 시각을 섞었습니다. map → odom은 측정 시각의 것을, odom에서 로봇의 위치는 가장 새로운 것을 물었습니다. 로봇은 점을 본 뒤에 더 달렸습니다. 경로 전체를 측정 시각으로 물으십시오.",
    ),
    "M9",
)


ROBOT_OF_NOW = WrongStep(
    "robot of now",
    {"moment": "stamp and now"},
    Text(
        en="You ask for two moments: map → odom at the stamp, and the robot in odom at `now`. It has driven on since it saw the point, and for `now` there is mostly nothing yet: ask the whole way at the stamp.",
        ko="두 시각을 섞었습니다. map → odom은 측정 시각의 것을, odom에서 로봇의 위치는 `now`의 것을 물었습니다. 로봇은 점을 본 뒤에 더 달렸고, `now`에는 대개 아직 아무것도 없습니다. 경로 전체를 측정 시각으로 물으십시오.",
    ),
    "M9",
)


PUT_BACK = tuple(
    WrongStep(
        f"{slip.name}, and the stamp put back",
        slip.at | {"stamp": "put back"},
        Text(
            en=slip.reply.en
            + " The message's own stamp, put back afterwards, makes the label true again and not the numbers.",
            ko=slip.reply.ko + " 나중에 메시지의 측정 시각을 되돌려 놓아도 이름표만 맞고 숫자는 그대로 틀립니다.",
        ),
        slip.misconception,
    )
    for slip in (SEC_ALONE, HALF_WAY, DIGITS, A_TENTH_BEFORE_NOW, MAP_OF_NOW, MAP_OF_THE_LATEST)
)


LEFT_IN_BASE_LINK = WrongStep(
    "left in base_link",
    {"target": "base_link"},
    Text(
        en="You moved it into base_link. It is wanted in map.",
        ko="base_link로 옮겼습니다. map 기준이 필요합니다.",
    ),
)


GIVES_UP_ON_THE_OLD = WrongStep(
    "gives up on the old",
    {"asks": "how old"},
    Text(
        en="You answer only for a message that has just come, and return nothing where it is older. Its age says nothing of what the buffer knows: ask at its stamp, and let the buffer refuse.",
        ko="방금 온 메시지에만 답하고 더 오래된 것에는 아무것도 반환하지 않습니다. 메시지의 나이로는 버퍼가 그 시각을 아는지 알 수 없습니다. 측정 시각으로 묻고, 거절은 버퍼에 맡기십시오.",
    ),
    "M9",
)


REFUSES_THE_OLD = WrongStep(
    "refuses the old",
    {"asks": "how old, and refuses"},
    Text(
        en="You answer only for a message that has just come, and refuse yourself where it is older. Its age says nothing of what the buffer knows: ask at its stamp, and let the buffer refuse.",
        ko="방금 온 메시지에만 답하고 더 오래된 것은 직접 거절합니다. 메시지의 나이로는 버퍼가 그 시각을 아는지 알 수 없습니다. 측정 시각으로 묻고, 거절은 버퍼에 맡기십시오.",
    ),
    "M9",
)


NOTHING_MOVED = WrongStep(
    "nothing moved",
    {"move": "nothing"},
    Text(
        en="Where the buffer has an answer, you return the message as it came. `buffer.transform` and `do_transform_point` leave what they are handed as it is, and *return* the moved point: keep that, and return it.",
        ko="버퍼가 답하는데도 받은 메시지를 그대로 반환합니다. `buffer.transform`과 `do_transform_point`는 넘겨받은 것을 바꾸지 않고 옮긴 점을 *반환*합니다. 그 반환값을 받아서 돌려주십시오.",
    ),
)


FALLS_BACK_ON_NOW = WrongStep(
    "falls back on now",
    {"refusal": "now"},
    Text(
        en="Where the buffer refuses for the stamp, you ask for `now` instead. Mostly it refuses that, too; where it does not, an honest refusal becomes a wrong point: let the exception through.",
        ko="버퍼가 측정 시각의 변환을 거절하면 대신 `now`의 변환을 묻습니다. 그것도 대개 거절되지만, 거절되지 않으면 정직한 거절이 틀린 점으로 바뀝니다. 예외를 그대로 내보내십시오.",
    ),
    "M9",
)


FALLS_BACK_ON_NOW_AND_PUTS_BACK = WrongStep(
    "falls back on now, and the stamp put back",
    {"refusal": "now", "stamp": "put back"},
    Text(
        en="Where the buffer refuses for the stamp, you ask for `now` instead, and put the message's own stamp on the result: a wrong point, and a label that hides it. Let the exception through.",
        ko="버퍼가 측정 시각의 변환을 거절하면 대신 `now`의 변환을 묻고, 결과에 메시지의 측정 시각을 적습니다. 틀린 점인데 이름표가 그것을 숨깁니다. 예외를 그대로 내보내십시오.",
    ),
    "M9",
)


STEP_TAKEN_OFF = WrongStep(
    "step taken off",
    {"move": "step taken off"},
    Text(
        en="You took the translation off, and left the rotation out. `map_T_sensor` takes points from the sensor's frame into map as it is: turn the point, then *add* the translation.",
        ko="이동을 빼고 회전을 빠뜨렸습니다. `map_T_sensor`는 센서 기준의 점을 그대로 map 기준으로 옮깁니다. 점을 돌린 다음 이동을 *더하십시오*.",
    ),
)


TURNED_BACK = WrongStep(
    "turned back",
    {"move": "turned back"},
    Text(
        en="The translation is right, and the point was turned the other way: a sign of the yaw, or of a sine, is the wrong one.",
        ko="이동은 맞지만 점을 반대쪽으로 돌렸습니다. yaw나 사인의 부호가 반대입니다.",
    ),
)


HALF_TURNED = WrongStep(
    "half turned",
    {"move": "half turned"},
    Text(
        en="The point was turned only half as far as it has to be: a quaternion's z and w are sine and cosine of *half* the angle, so yaw is `2 * atan2(z, w)`.",
        ko="점을 절반만 돌렸습니다. 쿼터니언의 z와 w는 각의 *절반*의 사인과 코사인이므로 yaw는 `2 * atan2(z, w)`입니다.",
    ),
)


ON_THE_FLOOR = WrongStep(
    "on the floor",
    {"move": "on the floor"},
    Text(
        en="x and y are moved, and z is still the sensor's: it stands above the floor, and that height is part of the translation.",
        ko="x와 y는 옮겼지만 z는 아직 센서 기준입니다. 센서는 바닥보다 높이 있고, 그 높이도 이동의 일부입니다.",
    ),
)


TASK = Task(
    id="E8.3",
    kind="F",
    points=4,
    title=Text(en="PointToMap: a point onto the map", ko="PointToMap: 점을 지도 위로"),
    answer="point_to_map",
    form=Message("geometry_msgs/msg/PointStamped", ("point", "header.frame_id", "header.stamp"), tolerance=0.002),
    inputs=sightings,
    variants=3,
    model=on_the_map,
    mistakes=(
        LATEST,
        NOW,
        FALLS_BACK_ON_LATEST,
        FALLS_BACK_AND_PUTS_BACK,
        ASKS_FOR_NOW_FIRST,
        SWALLOWS_THE_REFUSAL,
        SWAPPED,
        STAMPED_ANEW,
        ONLY_THE_LABEL,
        LEFT_IN_ODOM,
        ODOM_CALLED_MAP,
        LATEST_PUT_BACK,
        NOW_PUT_BACK,
        FROM_BASE_LINK,
        FROM_ODOM,
        ALWAYS_FROM_THE_LASER,
        ALWAYS_FROM_THE_CAMERA,
        SEC_ALONE,
        HALF_WAY,
        STEP_ALONE,
        TURN_ALONE,
        MOVED_TWICE,
        STAMP_LOST,
        AS_IT_CAME,
        DIGITS,
        A_TENTH_BEFORE_NOW,
        LEFT_IN_BASE_LINK,
        *PUT_BACK,
        MAP_OF_NOW,
        MAP_OF_THE_LATEST,
        ROBOT_OF_THE_LATEST,
        ROBOT_OF_NOW,
        GIVES_UP_ON_THE_OLD,
        REFUSES_THE_OLD,
        NOTHING_MOVED,
        FALLS_BACK_ON_NOW,
        FALLS_BACK_ON_NOW_AND_PUTS_BACK,
        STEP_TAKEN_OFF,
        TURNED_BACK,
        HALF_TURNED,
        ON_THE_FLOOR,
    ),
    hints=(
        Text(
            en="Value, frame, stamp: all three stand in the message. Which two does the lookup need besides the target?",
            ko="값, 좌표계, 측정 시각이 모두 메시지에 있습니다. 조회에는 목표 말고 어느 둘이 필요합니까?",
        ),
        Text(
            en="tf2 has a method of the buffer that reads frame and stamp off the message itself.",
            ko="tf2의 버퍼에는 좌표계와 측정 시각을 메시지에서 직접 읽는 메서드가 있습니다.",
        ),
        Text(
            en="`buffer.transform(message, ...)` takes the message and the target frame, and keeps the stamp. No try, no now.",
            ko="`buffer.transform(message, ...)`은 메시지와 목표 좌표계를 받고 측정 시각을 지킵니다. try도 now도 필요 없습니다.",
        ),
    ),
    misconceptions=("M9", "M1"),
)
