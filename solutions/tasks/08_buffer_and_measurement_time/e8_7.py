"""E8.7: Where is it now?"""

from __future__ import annotations

import math

from tflab.core import TransformException
from tflab.ros.messages import geometry_msgs
from tflab.ros.time import Time
from tflab.workbook.tasks import Task, Text, Vector, WrongStep

from .draws import _moved, _time, drive, seen


def resting_objects(rng):
    """The robot drives on between the sighting and now, and the localiser corrects itself in between; twice the buffer cannot tell."""
    rows = []
    for share, later in (
        (0.05, 0.9),
        (0.2, 0.95),
        (0.35, 0.9),
        (0.1, 0.85),
        (0.5, 1.0),
        (0.3, 0.97),
        (0.4, 1.9),
        (-0.2, 0.8),
    ):
        buffer, start_s, end_s, sensor = drive(rng)
        stamp_s, now_s = (round(start_s + part * (end_s - start_s), 3) for part in (share, later))
        rows.append((buffer, seen(rng, sensor, stamp_s), _time(now_s)))
    return rows


def in_base_link(buffer, message, now, *, sight="stamp", base="now", fixed="odom", target="base_link",
                 ends="wanted first", refusal="let through", move="all", source="the message's"):  # fmt: skip
    """Return the coordinates, step by step; other steps are the slips."""
    if move == "not":
        return (message.point.x, message.point.y, message.point.z)
    if move in ("at one moment", "mount"):  # which never changes, so no moment is refused
        mount = buffer.lookup_transform(target, message.header.frame_id, Time())
        place = _moved(message, mount).point if move == "at one moment" else mount.transform.translation
        return (place.x, place.y, place.z)
    if move in ("base taken off", "base turned on"):
        seen_in_odom = _moved(message, buffer.lookup_transform("odom", message.header.frame_id, message.header.stamp))
        base = buffer.lookup_transform("odom", "base_link", now).transform
        x, y, z = (getattr(seen_in_odom.point, name) - getattr(base.translation, name) for name in "xyz")
        yaw = 2.0 * math.atan2(base.rotation.z, base.rotation.w) if move == "base turned on" else 0.0
        return (x * math.cos(yaw) - y * math.sin(yaw), x * math.sin(yaw) + y * math.cos(yaw), z)
    if move in ("step taken off", "step added"):
        seen = _moved(message, buffer.lookup_transform(target, message.header.frame_id, message.header.stamp)).point
        then, later = (
            buffer.lookup_transform("odom", "base_link", moment).transform.translation
            for moment in (message.header.stamp, now)
        )
        way = -1.0 if move == "step taken off" else 1.0
        return tuple(getattr(seen, name) + way * (getattr(later, name) - getattr(then, name)) for name in "xyz")
    if move == "second from map":
        seen_in_odom = _moved(message, buffer.lookup_transform("odom", message.header.frame_id, message.header.stamp))
        point = _moved(seen_in_odom, buffer.lookup_transform(target, "map", now)).point
        return (point.x, point.y, point.z)
    if move in ("second way round", "first way round"):
        first, second = ("odom", message.header.frame_id, message.header.stamp), (target, "odom", now)
        for one, other, moment in (first, second):
            is_round = (one == "odom") is (move == "first way round")
            message = _moved(message, buffer.lookup_transform(*((other, one) if is_round else (one, other)), moment))
        return (message.point.x, message.point.y, message.point.z)
    times = {"stamp": Time.from_msg(message.header.stamp), "now": now, "latest": Time()}
    times["sec alone"] = Time(seconds=message.header.stamp.sec)
    target = message.header.frame_id if target == "the sensor" else target
    ends_at = [(target, times[base]), (message.header.frame_id if source == "the message's" else source, times[sight])]
    if target in ("odom", "map"):  # which rests: its time does not matter
        ends_at[0] = (target, times[sight])
    (one, one_time), (other, other_time) = ends_at if ends == "wanted first" else ends_at[::-1]
    one_time, other_time = (other_time, one_time) if ends == "names swapped" else (one_time, other_time)
    try:
        transform = buffer.lookup_transform_full(one, one_time, other, other_time, fixed)
    except TransformException:
        if refusal == "let through":
            raise
        if refusal == "None":
            return None
        transform = buffer.lookup_transform(one, other, Time())
    if move == "step alone":
        transform.transform.rotation = geometry_msgs.Quaternion(w=1.0)
    if move == "turn alone":
        transform.transform.translation = geometry_msgs.Vector3()
    if move == "translation":
        return tuple(getattr(transform.transform.translation, name) for name in "xyz")
    moved = _moved(message, transform)
    moved = _moved(moved, transform) if move == "twice" else moved
    return (moved.point.x, moved.point.y, moved.point.z)


BASE_LINK_THEN = WrongStep(
    "base_link then",
    {"base": "stamp"},
    Text(
        en="That is the object in the base_link of one single moment, the sighting's, as if the robot had stood still until now. It has driven on. If you went over odom by two `buffer.transform`: the second reads the stamp off the point in odom, and that is still the old one.",
        ko="본 때의 base_link 기준으로 구한 위치입니다. 그때부터 지금까지 로봇이 서 있었던 것처럼 계산했지만, 로봇은 계속 달렸습니다. `buffer.transform`을 두 번 써서 odom을 거쳤다면, 둘째 호출은 odom 기준 점에 적힌 시각을 읽는데 그것은 아직 옛 측정 시각입니다.",
    ),
    "M9",
)


LATEST_INSTEAD_OF_NOW = WrongStep(
    "latest instead of now",
    {"base": "latest"},
    Text(
        en="For base_link you took `Time()`, the newest pose in the buffer, and `now` is asked for.",
        ko="base_link에 버퍼의 가장 새로운 포즈를 뜻하는 `Time()`을 썼습니다. 필요한 것은 `now`입니다.",
    ),
    "M9",
)


TIMES_SWAPPED = WrongStep(
    "times swapped",
    {"base": "stamp", "sight": "now"},
    Text(
        en="The two times are swapped: you moved a sighting of now into the base_link of then. Each frame is followed by its own time.",
        ko="두 시각이 뒤바뀌었습니다. 지금 본 것을 그때의 base_link로 옮겼습니다. 좌표계마다 바로 뒤에 자기 시각이 옵니다.",
    ),
)


THROUGH_MAP = WrongStep(
    "through map",
    {"fixed": "map"},
    Text(
        en="You went through map. Between the two moments the localiser corrected itself, map jumped, and the object jumped with it; odom runs on smoothly.",
        ko="map을 거쳐 갔습니다. 두 순간 사이에 위치 추정이 보정하면서 map이 뛰었고 물체도 함께 뛰었습니다. odom은 매끄럽게 이어집니다.",
    ),
    "M8",
)


LEFT_IN_ODOM = WrongStep(
    "left in odom",
    {"target": "odom"},
    Text(
        en="These are the coordinates in odom, where the two moments meet. Asked for is base_link, as it is at `now`: one more step.",
        ko="두 순간이 만나는 odom 기준의 좌표입니다. 필요한 것은 `now` 시각의 base_link 기준 좌표입니다. 한 걸음 더 가십시오.",
    ),
)


THE_WRONG_WAY = WrongStep(
    "the wrong way",
    {"ends": "swapped"},
    Text(
        en="Target and source are swapped. The target with its time comes first: base_link, now.",
        ko="목표와 원본이 뒤바뀌었습니다. 목표와 그 시각이 먼저입니다. base_link와 now입니다.",
    ),
    "M1",
)

BOTH_NOW = WrongStep(
    "both now",
    {"sight": "now"},
    Text(
        en="The sighting, too, is taken for one of now. It was made at the stamp: the sensor's frame goes with that time.",
        ko="본 것까지 지금의 것으로 다루었습니다. 측정 시각에 본 것이므로 센서의 좌표계에는 그 시각이 따라갑니다.",
    ),
    "M9",
)

SWALLOWS = WrongStep(
    "swallows the refusal",
    {"refusal": "None"},
    Text(
        en="Where the buffer refuses, you return nothing, and nobody learns why. Let its exception through.",
        ko="버퍼가 거절하면 아무것도 반환하지 않아 아무도 이유를 알지 못합니다. 예외를 그대로 내보내십시오.",
    ),
    "M11",
)

FALLS_BACK = WrongStep(
    "falls back on latest",
    {"refusal": "latest"},
    Text(
        en="Where the buffer refuses, you answer by another transform all the same: a wrong place instead of an honest no. Let its exception through.",
        ko="버퍼가 거절하는데도 다른 변환으로 답합니다. 정직한 거절 대신 틀린 위치가 됩니다. 예외를 그대로 내보내십시오.",
    ),
    "M9",
)

AS_SEEN = WrongStep(
    "as seen",
    {"move": "not"},
    Text(
        en="Those are the numbers that the sensor saw. The object rests in the room, not on the robot: in base_link its numbers change as the robot drives.",
        ko="센서가 본 숫자 그대로입니다. 물체는 로봇이 아니라 방에 있습니다. 로봇이 달리면 base_link 기준 숫자는 바뀝니다.",
    ),
)


AT_ONE_MOMENT = WrongStep(
    "at one moment",
    {"move": "at one moment"},
    Text(
        en="Your point stays in one moment: you asked for one alone (a new stamp on the old sighting makes it no newer), or held fast a frame that rides along. Between the sensor and base_link nothing ever moves, so that is where the object was *seen*; the drive since then is missing.",
        ko="점이 한 시각에 머물러 있습니다. 한 시각의 변환만 조회했거나(옛 관측에 새 시각을 적어도 새것이 되지 않습니다), 로봇과 함께 움직이는 좌표계를 고정으로 삼았습니다. 센서와 base_link 사이는 움직이지 않으므로 물체를 *본* 곳이 나옵니다. 그 뒤에 달린 것이 빠졌습니다.",
    ),
    "M9",
)


LEFT_IN_MAP = WrongStep(
    "left in map",
    {"target": "map"},
    Text(
        en="These are the coordinates in map. Asked for is base_link, as it is at `now`.",
        ko="map 기준 좌표입니다. `now`의 base_link 기준이 필요합니다.",
    ),
)


SIGHTING_OF_THE_LATEST = WrongStep(
    "sighting of the latest",
    {"sight": "latest"},
    Text(
        en="The sighting is taken for one of the newest pose in the buffer (`Time()`). It was made at the stamp.",
        ko="본 시각을 버퍼의 가장 새로운 시각(`Time()`)으로 여겼습니다. 측정 시각에 본 것입니다.",
    ),
    "M9",
)


STEP_ALONE = WrongStep(
    "step alone",
    {"move": "step alone"},
    Text(
        en="You added the step and left out the turn: the robot has turned since, and the sensor sits turned on it.",
        ko="이동만 더하고 회전을 빠뜨렸습니다. 로봇은 그 뒤에 돌았고 센서도 돌려 달려 있습니다.",
    ),
    "M3",
)


TURN_ALONE = WrongStep(
    "turn alone",
    {"move": "turn alone"},
    Text(
        en="You turned the point and left the translation out: how far the robot has come since, and where the sensor sits on it.",
        ko="점을 돌리기만 하고 이동을 빠뜨렸습니다. 로봇이 그 뒤에 간 거리와 센서가 달린 위치가 들어가지 않았습니다.",
    ),
    "M3",
)


IN_THE_SENSORS_FRAME = WrongStep(
    "in the sensor's frame",
    {"target": "the sensor"},
    Text(
        en="These are coordinates in the sensor's frame. Asked for is base_link: the sensor sits turned on it, and not at its origin.",
        ko="센서 좌표계 기준의 좌표입니다. 필요한 것은 base_link 기준입니다. 센서는 base_link의 원점이 아닌 곳에 돌려 달려 있습니다.",
    ),
)


FROM_BASE_LINK = WrongStep(
    "from base_link",
    {"source": "base_link"},
    Text(
        en="You asked from base_link. The numbers were counted in the frame that the message names.",
        ko="base_link를 원본으로 물었습니다. 숫자는 메시지에 적힌 좌표계에서 센 것입니다.",
    ),
)


SECOND_FROM_MAP = WrongStep(
    "second step from map",
    {"move": "second from map"},
    Text(
        en="In the second of your two steps the source is map, and the point is in odom by then: the source is the frame in which the numbers are.",
        ko="두 단계 가운데 둘째 단계의 원본이 map인데 그때 점은 odom 기준입니다. 원본은 숫자가 놓인 좌표계입니다.",
    ),
)


BASE_TAKEN_OFF = WrongStep(
    "base taken off",
    {"move": "base taken off"},
    Text(
        en="From the point in odom you took off where base_link is, and left out how it is turned: these are steps along odom's axes, and base_link has its own.",
        ko="odom 기준의 점에서 base_link의 위치만 뺐습니다. base_link가 돌아간 것을 빠뜨려 odom의 축으로 잰 값입니다. base_link에는 자기 축이 있습니다.",
    ),
    "M3",
)


STEP_TAKEN_OFF = WrongStep(
    "step taken off",
    {"move": "step taken off"},
    Text(
        en="From the point in the base_link of then you took off how far base_link has come since, counted along odom's axes. The two do not lie alike, and the turn that the robot made since is left out: a pose is more than a step.",
        ko="그때의 base_link 기준 점에서 그 뒤로 base_link가 간 거리를 odom의 축으로 재어 뺐습니다. 두 좌표계의 축은 나란하지 않고, 그사이 로봇이 돈 것도 빠졌습니다. 포즈는 이동만이 아닙니다.",
    ),
    "M3",
)


SEC_ALONE = WrongStep(
    "sec alone",
    {"sight": "sec alone"},
    Text(
        en="For the sighting you took the stamp's sec alone: up to a second too early. `Time.from_msg(stamp)` reads both fields.",
        ko="본 시각을 sec만으로 물었습니다. 최대 1초나 이릅니다. `Time.from_msg(stamp)`는 두 항목을 모두 읽습니다.",
    ),
)


SECOND_WAY_ROUND = WrongStep(
    "second step swapped",
    {"move": "second way round"},
    Text(
        en="In the second of your two steps, from odom to base_link, target and source are swapped: the point is in odom and wanted in base_link, so base_link comes first there.",
        ko="두 단계 가운데 odom에서 base_link로 가는 둘째 단계에서 목표와 원본이 뒤바뀌었습니다. 점은 odom 기준이고 base_link 기준이 필요하므로 그 조회에서는 base_link가 먼저입니다.",
    ),
    "M1",
)


FIRST_WAY_ROUND = WrongStep(
    "first step swapped",
    {"move": "first way round"},
    Text(
        en="In the first of the two steps target and source are swapped: the point is in the message's frame and wanted in odom, so odom comes first there.",
        ko="두 단계 가운데 첫 단계에서 목표와 원본이 뒤바뀌었습니다. 점은 메시지의 좌표계 기준이고 odom 기준이 필요하므로 그 조회에서는 odom이 먼저입니다.",
    ),
    "M1",
)


TRANSLATION_ALONE = WrongStep(
    "translation alone",
    {"move": "translation"},
    Text(
        en="You return the transform's own translation: where the sensor was, seen from base_link, and not the object. The point was never moved: hand it to `do_transform_point` with that transform.",
        ko="변환 자체의 이동을 반환합니다. base_link에서 본 센서의 위치이지 물체의 위치가 아닙니다. 점을 옮기지 않았습니다. 그 변환과 함께 `do_transform_point`에 넘기십시오.",
    ),
)


TRANSLATION_OF_ONE_MOMENT = WrongStep(
    "translation of one moment",
    {"move": "mount"},
    Text(
        en="You return where the sensor sits on base_link, the translation of a lookup for one moment: no point was moved by it, and the drive since the sighting is not in it.",
        ko="한 시각의 조회에서 이동만 꺼내, 센서가 base_link의 어디에 달렸는지를 반환합니다. 점을 옮기지 않았고, 본 뒤에 로봇이 달린 것도 들어 있지 않습니다.",
    ),
)


NAMES_SWAPPED = WrongStep(
    "names swapped",
    {"ends": "names swapped"},
    Text(
        en="The two frames have changed places, and the two times have not: you ask from base_link at the stamp to the sensor's frame at `now`. The target comes first, and each frame is followed by its own time.",
        ko="두 좌표계는 자리가 바뀌었는데 두 시각은 그대로입니다. 측정 시각의 base_link에서 `now`의 센서 좌표계로 가는 변환을 물었습니다. 목표가 먼저이고, 좌표계마다 바로 뒤에 자기 시각이 옵니다.",
    ),
    "M1",
)


STEP_ADDED = WrongStep(
    "step added",
    {"move": "step added"},
    Text(
        en="To the point in the base_link of then you added how far base_link has come since. What the robot drives towards comes nearer, so that way is taken off; and along odom's axes, without the turn, it would not fit either: a pose is more than a step.",
        ko="그때의 base_link 기준 점에 그 뒤로 base_link가 간 거리를 더했습니다. 로봇이 다가가면 물체는 가까워지므로 빼야 할 거리이고, odom의 축으로 잰 데다 회전도 빠져서 빼더라도 맞지 않습니다. 포즈는 이동만이 아닙니다.",
    ),
    "M3",
)


BASE_TURNED_ON = WrongStep(
    "base turned on",
    {"move": "base turned on"},
    Text(
        en="From the point in odom you took off where base_link is, and then turned by base_link's yaw: from odom into base_link it is turned *back*, by minus that.",
        ko="odom 기준의 점에서 base_link의 위치를 뺀 다음 base_link의 yaw만큼 돌렸습니다. odom에서 base_link로 갈 때는 *거꾸로*, 그 반대 부호만큼 돌립니다.",
    ),
    "M3",
)


MOVED_TWICE = WrongStep(
    "moved twice",
    {"move": "twice"},
    Text(
        en="The point was moved twice by the same transform: once it is in base_link, it stays.",
        ko="같은 변환으로 점을 두 번 옮겼습니다. 한 번 옮기면 이미 base_link 기준입니다.",
    ),
)


ODOM_OF_NOW = WrongStep(
    "odom of now",
    {"target": "odom", "sight": "now"},
    Text(
        en="These are coordinates in odom, and of a sighting that is taken for one of now. Is odom the target, and base_link the fixed frame? odom is what stands still between the two moments, and comes last.",
        ko="odom 기준의 좌표이고, 본 것을 지금의 것으로 다루었습니다. odom이 목표이고 base_link가 고정 아닙니까? 두 순간 사이에 가만히 있는 것이 odom이고, 맨 뒤에 옵니다.",
    ),
)


TASK = Task(
    id="E8.7",
    kind="F",
    points=4,
    title=Text(en="Where is it now?", ko="지금은 어디에 있습니까?"),
    answer="object_now",
    form=Vector(3, unit="m", frame="base_link", tolerance=0.002),
    inputs=resting_objects,
    variants=3,
    model=in_base_link,
    mistakes=(
        BASE_LINK_THEN,
        LATEST_INSTEAD_OF_NOW,
        TIMES_SWAPPED,
        LEFT_IN_ODOM,
        THE_WRONG_WAY,
        THROUGH_MAP,
        BOTH_NOW,
        SWALLOWS,
        FALLS_BACK,
        AS_SEEN,
        AT_ONE_MOMENT,
        LEFT_IN_MAP,
        SIGHTING_OF_THE_LATEST,
        STEP_ALONE,
        TURN_ALONE,
        IN_THE_SENSORS_FRAME,
        FROM_BASE_LINK,
        SECOND_FROM_MAP,
        BASE_TAKEN_OFF,
        STEP_TAKEN_OFF,
        SEC_ALONE,
        SECOND_WAY_ROUND,
        FIRST_WAY_ROUND,
        TRANSLATION_ALONE,
        TRANSLATION_OF_ONE_MOMENT,
        NAMES_SWAPPED,
        STEP_ADDED,
        BASE_TURNED_ON,
        MOVED_TWICE,
        ODOM_OF_NOW,
    ),
    hints=(
        Text(
            en="Two moments, so one stamp is not enough. Which lookup takes two times?",
            ko="순간이 둘이므로 측정 시각 하나로는 모자랍니다. 시각을 둘 받는 조회는 무엇입니까?",
        ),
        Text(
            en="`lookup_transform_full(target, its time, source, its time, fixed)`. Which of your moments belongs to the target?",
            ko="`lookup_transform_full(target, 그 시각, source, 그 시각, fixed)`입니다. 두 순간 가운데 어느 것이 목표의 시각입니까?",
        ),
        Text(
            en="base_link at `now`, the message's frame at its stamp, fixed in odom; then `do_transform_point(message, ...)`, and its `.point`.",
            ko="base_link는 `now`, 메시지의 좌표계는 그 측정 시각, 고정은 odom입니다. 그다음 `do_transform_point(message, ...)`의 `.point`입니다.",
        ),
    ),
    misconceptions=("M9", "M8"),
    equivalent={
        "Time.from_msg(message.header.stamp) -> message.header.stamp in: stamp = Time.from_msg(message.header.stamp)": (
            "a lookup takes a message's stamp as it takes a Time"
        ),
    },
)
