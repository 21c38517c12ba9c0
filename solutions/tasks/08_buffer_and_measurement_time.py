"""Chapter 08: how fresh, how far off, and at which moment?"""

import math

from tflab.core import StampedTransform, Transform, seconds
from tflab.ros.convert import msg_from_stamp, msg_from_stamped
from tflab.ros.messages import geometry_msgs, std_msgs
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.time import Time
from tflab.workbook.answers.forms import Angle, Choice, Message, Number, Parts, Vector
from tflab.workbook.tasks.task import Task, Twin, Words

# -- E8.1: the latest common time -----------------------------------------------------


def lanes(rng):
    map_s, odom_s = sorted(rng.uniform(6.0, 9.0, 2).round(2).tolist(), key=lambda _: rng.random())
    if abs(map_s - odom_s) < 0.2:
        odom_s = round(odom_s + 0.3, 2)
    arm_s = round(min(map_s, odom_s) - float(rng.uniform(0.3, 1.0)), 2)
    starts = (1.0 + 0.4 * rng.permutation(4)[:3] + rng.uniform(0.0, 0.1, 3)).round(2).tolist()
    names = ("map -> odom", "odom -> base_link", "base_link -> arm_link")
    return {
        "oldest_s": dict(zip(names, starts, strict=True)),
        "newest_s": dict(zip(names, (map_s, odom_s, arm_s), strict=True)),
        "static": ["base_link -> laser_frame, sent at 0.50"],
        "clock_s": round(max(map_s, odom_s) + 0.17, 2),
    }


PATH = ("map -> odom", "odom -> base_link")

# -- E8.2: between two samples --------------------------------------------------------


def two_samples(rng):
    """Turns to the left, to the right, both across the back; a moment at each sample, and one outside on either side."""
    rows = []
    for way, share in ((1, 0.25), (-1, 0.7), (0, 0.35), (0, 0.85), (0, 0.0), (0, 1.0), (1, -0.3), (-1, 1.4)):
        t0, gap = float(rng.uniform(1.0, 9.0)), float(rng.uniform(0.2, 1.0))
        x0, y0, x1, y1 = rng.uniform(-3.0, 3.0, 4).tolist()
        size = float(rng.uniform(0.4, 1.2))
        across = way * (math.pi - float(rng.uniform(0.3, 0.7)) * size)  # where yaw leaps from pi to -pi
        yaw0 = across if way else float(rng.uniform(-1.5, 0.2))
        yaw1 = math.remainder(yaw0 + (way or 1) * size, math.tau)
        rows.append((t0 + share * gap, (t0, x0, y0, yaw0), (t0 + gap, x1, y1, yaw1)))
    return rows


def _refuse(stamp_s, before, after):
    from tflab.core import ExtrapolationException

    if not before[0] <= stamp_s <= after[0]:
        raise ExtrapolationException("outside")


def _blend(stamp_s, before, after, turn):
    (t0, x0, y0, yaw0), (t1, x1, y1, _) = before, after
    ratio = (stamp_s - t0) / (t1 - t0)
    return {"position": (x0 + ratio * (x1 - x0), y0 + ratio * (y1 - y0)), "yaw": yaw0 + ratio * turn}


def _short(before, after):
    return math.remainder(after[3] - before[3], math.tau)


def long_way(stamp_s, before, after):
    _refuse(stamp_s, before, after)
    return _blend(stamp_s, before, after, after[3] - before[3])


def nearest(stamp_s, before, after):
    _refuse(stamp_s, before, after)
    _, x, y, yaw = before if stamp_s - before[0] <= after[0] - stamp_s else after
    return {"position": (x, y), "yaw": yaw}


def guesses(stamp_s, before, after):
    return _blend(stamp_s, before, after, _short(before, after))


def clamps(stamp_s, before, after):
    return guesses(min(max(stamp_s, before[0]), after[0]), before, after)


def middle(stamp_s, before, after):
    _refuse(stamp_s, before, after)
    return guesses((before[0] + after[0]) / 2, before, after)


def earlier(stamp_s, before, after):
    _refuse(stamp_s, before, after)
    return {"position": before[1:3], "yaw": before[3]}


def shy(stamp_s, before, after):
    from tflab.core import ExtrapolationException

    if stamp_s in (before[0], after[0]):
        raise ExtrapolationException("at a sample")
    _refuse(stamp_s, before, after)
    return guesses(stamp_s, before, after)


def backwards(stamp_s, before, after):
    _refuse(stamp_s, before, after)
    return guesses(before[0] + after[0] - stamp_s, before, after)


def long_way_and_guesses(stamp_s, before, after):
    return _blend(stamp_s, before, after, after[3] - before[3])


# -- E8.3 and E8.7: a robot that drives an arc ----------------------------------------


def drive(rng):
    """Return a filled buffer, its first and newest common stamp [s], and the sensor's frame."""
    buffer = Buffer()
    start_s = float(rng.integers(2, 20))
    speed, way = float(rng.uniform(0.5, 1.5)), float(rng.choice([-1.0, 1.0]))
    yaw_rate = way * float(rng.uniform(0.4, 0.9))
    yaw = float(rng.uniform(-2.5, 2.5))
    x, y = rng.uniform(-2.0, 2.0, 2).tolist()
    sensor = str(rng.choice(["laser_frame", "camera_link"]))
    mount = Transform.from_rpy(yaw=float(rng.uniform(0.4, 1.2)), translation=(0.2, float(rng.uniform(0.05, 0.2)), 0.15))
    _put(buffer, "base_link", sensor, start_s, mount, is_static=True)
    for i in range(9):  # 5 Hz
        pose = Transform.from_rpy(yaw=yaw, translation=(x, y, 0.0))
        _put(buffer, "odom", "base_link", start_s + 0.2 * i, pose)
        x, y, yaw = x + 0.2 * speed * math.cos(yaw), y + 0.2 * speed * math.sin(yaw), yaw + 0.2 * yaw_rate
    before = Transform.from_rpy(
        yaw=float(rng.uniform(0.2, 0.6)), translation=tuple(rng.uniform(-1.0, 1.0, 3) * (1, 1, 0))
    )
    jump = Transform.from_rpy(yaw=0.12, translation=(0.25, -0.2, 0.0))
    for i in range(4):  # 2.5 Hz; the localiser corrects itself at the last one
        _put(buffer, "map", "odom", start_s + 0.4 * i, before if i < 3 else before @ jump)
    return buffer, start_s, start_s + 1.2, sensor


def _put(buffer, parent, child, stamp_s, pose, is_static=False):
    message = msg_from_stamped(StampedTransform(parent, child, seconds(stamp_s), pose))
    (buffer.set_transform_static if is_static else buffer.set_transform)(message, "robot")


def seen(rng, frame_id, stamp_s):
    x, y, z = rng.uniform((2.0, -1.5, 0.1), (5.0, 1.5, 0.6)).tolist()
    header = std_msgs.Header(stamp=msg_from_stamp(seconds(stamp_s)), frame_id=frame_id)
    return geometry_msgs.PointStamped(header=header, point=geometry_msgs.Point(x=x, y=y, z=z))


def _time(stamp_s):
    return Time(nanoseconds=seconds(stamp_s))


def sightings(rng):
    """Points from within the buffer, one from before it, and one whose transform has not come yet."""
    rows = []
    for share in (0.1, 0.35, 0.6, 0.75, -0.3, 1.2):
        buffer, start_s, end_s, sensor = drive(rng)
        stamp_s = round(start_s + share * (end_s - start_s), 3)
        now_s = round(max(end_s, stamp_s) + float(rng.uniform(0.45, 0.7)), 3)
        rows.append((buffer, seen(rng, sensor, stamp_s), _time(now_s)))
    return rows


def _moved(message, transform):
    from tflab.ros.tf2.geometry import do_transform_point

    return do_transform_point(message, transform)


def latest(buffer, message, now):
    return _moved(message, buffer.lookup_transform("map", message.header.frame_id, Time()))


def fresh_stamp(buffer, message, now):
    return _moved(message, buffer.lookup_transform("map", message.header.frame_id, now))


def falls_back(buffer, message, now):
    from tflab.core import TransformException

    try:
        return _moved(message, buffer.lookup_transform("map", message.header.frame_id, message.header.stamp))
    except TransformException:
        return latest(buffer, message, now)


def swallows(buffer, message, now):
    from tflab.core import TransformException

    try:
        return _moved(message, buffer.lookup_transform("map", message.header.frame_id, message.header.stamp))
    except TransformException:
        return None


def swapped(buffer, message, now):
    return _moved(message, buffer.lookup_transform(message.header.frame_id, "map", message.header.stamp))


def restamped(buffer, message, now):
    moved = _moved(message, buffer.lookup_transform("map", message.header.frame_id, message.header.stamp))
    moved.header.stamp = now.to_msg()
    return moved


def relabelled(buffer, message, now):
    header = std_msgs.Header(stamp=message.header.stamp, frame_id="map")
    return geometry_msgs.PointStamped(header=header, point=message.point)


def only_odom(buffer, message, now):
    return _moved(message, buffer.lookup_transform("odom", message.header.frame_id, message.header.stamp))


# -- E8.4: how far off ----------------------------------------------------------------


def motion(rng):
    way = float(rng.choice([-1.0, 1.0]))
    speed_mps = float(rng.uniform(0.6, 1.8))
    yaw_rate_degps = way * float(rng.uniform(15.0, 40.0))
    range_m = float(rng.uniform(3.0, 8.0))
    if abs(speed_mps - range_m * math.radians(abs(yaw_rate_degps))) < 0.15:  # the two pieces must not look alike
        speed_mps += 0.3
    return {
        "speed_mps": round(speed_mps, 2),
        "yaw_rate_degps": round(yaw_rate_degps, 1),
        "range_m": round(range_m, 1),
        "delay_ms": float(rng.integers(8, 25) * 10),
    }


def _late(given, forwards=1.0, left=1.0, together=None, degrees=False, delay=1e-3):
    delay_s = given.delay_ms * delay
    yaw_rate = given.yaw_rate_degps if degrees else math.radians(given.yaw_rate_degps)
    forwards_m = forwards * given.speed_mps * delay_s
    left_m = left * given.range_m * yaw_rate * delay_s
    length = math.hypot(forwards_m, left_m) if together is None else together(forwards_m, left_m)
    return {"forwards_m": forwards_m, "left_m": left_m, "together_m": length}


def _crosswise(given):
    right = _late(given)
    return {**right, "forwards_m": right["left_m"], "left_m": right["forwards_m"]}


# -- E8.6: how long must it remember --------------------------------------------------


def detector(rng):
    slow = float(rng.choice([1.0, 2.0, 2.5, 4.0]))
    return {
        "thinking_s": round(float(rng.uniform(1.5, 6.0)), 2),
        "rate_hz": {"map -> odom": slow, "odom -> base_link": float(rng.choice([20.0, 25.0, 50.0]))},
    }


# -- E8.7: where is it now ------------------------------------------------------------


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


def _left_in_odom(buffer, message):
    point = _moved(message, buffer.lookup_transform("odom", message.header.frame_id, _stamp(message))).point
    return (point.x, point.y, point.z)


def _the_wrong_way(buffer, message, now):
    then_T_now = buffer.lookup_transform_full(message.header.frame_id, _stamp(message), "base_link", now, "odom")
    point = _moved(message, then_T_now).point
    return (point.x, point.y, point.z)


SYMPTOMS = ("a", "b", "c", "d", "e", "f")
CAUSES = (
    "stamp overwritten", "odometry slow", "static mount wrong", "two clocks", "cache too short", "import missing",
)  # fmt: skip
RIGHT = dict(
    zip(
        SYMPTOMS,
        ("stamp overwritten", "static mount wrong", "two clocks", "cache too short", "odometry slow", "import missing"),
        strict=True,
    )
)

TASKS = (
    Task(
        id="E8.1",
        kind="N",
        points=2,
        title=Words(en="How fresh is latest?", ko="최신은 얼마나 새롭습니까?"),
        answer="latest_common_s",
        form=Number(unit="s", tolerance=0.005),
        given=lanes,
        variants=6,
        twins=(
            Twin(
                "newest of all",
                lambda g: max(g.newest_s[edge] for edge in PATH),
                Words(
                    en="That is the newest sample on the path. At that moment the other lane has nothing to say yet, and a lookup needs every lane.",
                    ko="경로에서 가장 새로운 표본의 시각입니다. 그 순간 다른 차선은 아직 아무 말도 하지 않았고, 조회에는 모든 차선이 필요합니다.",
                ),
                "M9",
            ),
            Twin(
                "now",
                lambda g: g.clock_s,
                Words(
                    en="That is the clock on the wall. `Time()` does not mean now; nothing in the buffer is that fresh.",
                    ko="벽시계의 시각입니다. `Time()`은 지금이 아닙니다. 버퍼 안에 그만큼 새로운 것은 없습니다.",
                ),
                "M9",
            ),
            Twin(
                "counting the static",
                0.5,
                Words(
                    en="You let the static edge limit the answer. It is good for any time, however long ago it was sent.",
                    ko="정적 연결이 답을 붙잡게 했습니다. 아무리 오래전에 보냈어도 정적 연결은 어느 시각에나 유효합니다.",
                ),
            ),
            Twin(
                "off the path",
                lambda g: g.newest_s["base_link -> arm_link"],
                Words(
                    en="You counted an edge that the lookup does not walk. Which edges lie between map and laser_frame?",
                    ko="조회가 지나지 않는 연결까지 세었습니다. map과 laser_frame 사이에 있는 연결은 무엇입니까?",
                ),
            ),
            Twin(
                "earliest start",
                lambda g: max(g.oldest_s[edge] for edge in PATH),
                Words(
                    en="That is where the common interval begins. `Time()` asks for its other end.",
                    ko="공통 구간이 시작되는 시각입니다. `Time()`은 반대쪽 끝을 묻습니다.",
                ),
            ),
            Twin(
                "oldest of all",
                lambda g: min(g.oldest_s[edge] for edge in PATH),
                Words(
                    en="That is the oldest sample on the path. `Time()` asks for something as new as possible.",
                    ko="경로에서 가장 오래된 표본의 시각입니다. `Time()`은 될 수 있는 대로 새로운 것을 묻습니다.",
                ),
            ),
            Twin(
                "time zero",
                0.0,
                Words(
                    en="Zero is how the question is written: `Time()` is time zero, and tf2 reads it as a wish for the latest. The answer has a stamp of its own. Which?",
                    ko="0은 질문을 적는 방법입니다. `Time()`은 시각 0이고 tf2는 이것을 최신을 달라는 말로 읽습니다. 답에는 자기 시각이 붙어 있습니다. 몇 초입니까?",
                ),
                "M9",
            ),
        ),
        hints=(
            Words(
                en="Draw one lane for each edge between map and laser_frame, and shade where all of them have data.",
                ko="map과 laser_frame 사이의 연결마다 차선을 하나씩 그리고, 모두 데이터가 있는 구간을 칠해 보십시오.",
            ),
            Words(
                en="Static lanes have no end, and lanes off the path do not matter. What is left?",
                ko="정적 연결의 차선에는 끝이 없고, 경로 밖의 차선은 상관없습니다. 무엇이 남습니까?",
            ),
            Words(
                en="It is the earliest of the latest ones: `min(...)` of the two `newest_s` on the path.",
                ko="마지막 시각들 가운데 가장 이른 것입니다. 경로에 있는 두 `newest_s`의 `min(...)`입니다.",
            ),
        ),
        cures=("M9",),
    ),
    Task(
        id="E8.2",
        kind="F",
        points=4,
        title=Words(en="Between two samples", ko="두 표본 사이"),
        answer="interpolate",
        form=Parts({"position": Vector(2, unit="m"), "yaw": Angle()}),
        inputs=two_samples,
        variants=4,
        twins=(
            Twin(
                "the long way",
                long_way,
                Words(
                    en="Your yaw goes the long way round when it crosses ±π: between 170° and −170° your robot looks to the front, where the real one turned 20° at the back.",
                    ko="±π를 넘을 때 yaw가 먼 길로 돌아갑니다. 170°와 −170° 사이에서 여러분의 로봇은 앞을 보지만, 진짜 로봇은 뒤쪽에서 20°만 돌았습니다.",
                ),
            ),
            Twin(
                "the nearest sample",
                nearest,
                Words(
                    en="You return the nearer of the two samples. The buffer goes along the line between them, so that a robot does not hop.",
                    ko="두 표본 가운데 가까운 쪽을 반환합니다. 버퍼는 둘을 잇는 선 위로 갑니다. 그래야 로봇이 껑충 뛰지 않습니다.",
                ),
            ),
            Twin(
                "guesses outside",
                guesses,
                Words(
                    en="Inside all is well, but outside your function goes on along the line. A buffer never guesses: raise `ExtrapolationException`.",
                    ko="안쪽은 모두 맞지만, 바깥에서도 선을 따라 계속 갑니다. 버퍼는 결코 짐작하지 않습니다. `ExtrapolationException`을 일으키십시오.",
                ),
            ),
            Twin(
                "stops at the ends",
                clamps,
                Words(
                    en="Inside all is well, but outside your function answers with the nearest end. That is a guess, too: raise `ExtrapolationException`.",
                    ko="안쪽은 모두 맞지만, 바깥에서는 가까운 끝의 값을 답합니다. 그것도 짐작입니다. `ExtrapolationException`을 일으키십시오.",
                ),
            ),
            Twin(
                "counted from the wrong end",
                backwards,
                Words(
                    en="Your ratio is counted from the later sample: near the first sample you answer as if near the second.",
                    ko="비율을 뒤쪽 표본에서 세었습니다. 첫 표본 가까이에서 둘째 표본 가까이에 있는 것처럼 답합니다.",
                ),
            ),
            Twin(
                "the long way, and guesses",
                long_way_and_guesses,
                Words(
                    en="Two things: yaw goes the long way round at ±π, and outside the two samples nothing is refused.",
                    ko="두 가지입니다. ±π에서 yaw가 먼 길로 돌고, 두 표본 바깥에서도 거절하지 않습니다.",
                ),
            ),
            Twin(
                "always the middle",
                middle,
                Words(
                    en="Wherever `stamp_s` lies, you answer with the middle of the two samples. How far along is it? Near the first sample the answer must be near the first.",
                    ko="`stamp_s`가 어디에 있든 두 표본의 한가운데를 답합니다. 얼마나 간 곳입니까? 첫 표본 가까이에서는 답도 첫 표본에 가까워야 합니다.",
                ),
            ),
            Twin(
                "the earlier sample",
                earlier,
                Words(
                    en="You return the earlier sample as it is. The robot has moved since: go along the line to the second one, as far as `stamp_s` says.",
                    ko="앞쪽 표본을 그대로 반환합니다. 그 뒤로 로봇은 움직였습니다. `stamp_s`가 말하는 만큼 둘째 표본 쪽으로 선을 따라가십시오.",
                ),
            ),
            Twin(
                "refuses at a sample",
                shy,
                Words(
                    en="Between the samples all is well, but exactly at a sample you refuse. There the buffer knows the answer best of all: only before the first and after the second is outside.",
                    ko="표본 사이는 모두 맞지만, 표본의 시각을 그대로 물으면 거절합니다. 버퍼가 가장 잘 아는 순간입니다. 첫 표본 앞과 둘째 표본 뒤만 바깥입니다.",
                ),
            ),
        ),
        hints=(
            Words(
                en="First the refusal, then a ratio between 0 and 1: how far along from the first stamp to the second is `stamp_s`?",
                ko="먼저 거절, 다음에 0과 1 사이의 비율입니다. `stamp_s`는 첫 측정 시각에서 둘째 측정 시각까지의 어디쯤입니까?",
            ),
            Words(
                en="Position: start + ratio × difference. For yaw the difference must be brought into −π to π before it is scaled.",
                ko="위치는 시작 + 비율 × 차이입니다. yaw는 비율을 곱하기 전에 차이를 −π에서 π 사이로 가져와야 합니다.",
            ),
            Words(
                en="`math.remainder(yaw1 - yaw0, math.tau)` is the short way round. Then `yaw0 + ratio * turn`; a full turn more or less does not matter.",
                ko="`math.remainder(yaw1 - yaw0, math.tau)`가 짧은 쪽 회전입니다. 그다음 `yaw0 + ratio * turn`이며, 한 바퀴 차이는 상관없습니다.",
            ),
        ),
    ),
    Task(
        id="E8.3",
        kind="F",
        points=4,
        title=Words(en="PointToMap: a point onto the map", ko="PointToMap: 점을 지도 위로"),
        answer="point_to_map",
        form=Message("geometry_msgs/msg/PointStamped", ("point", "header.frame_id", "header.stamp"), tolerance=0.002),
        inputs=sightings,
        variants=3,
        twins=(
            Twin(
                "latest",
                latest,
                Words(
                    en="You asked for `Time()`, the latest common time, and the point was moved with a pose from another moment. No error came, did it? Use the message's own stamp.",
                    ko="최신 공통 시각인 `Time()`으로 물어서, 점이 다른 순간의 자세로 옮겨졌습니다. 오류는 나지 않았습니다. 메시지 자신의 측정 시각을 쓰십시오.",
                ),
                "M9",
            ),
            Twin(
                "now",
                fresh_stamp,
                Words(
                    en="You asked for `now`, the moment of arrival. The buffer refuses, for nothing in it is that fresh; and if it did answer, it would be for the wrong moment.",
                    ko="도착한 순간인 `now`로 물었습니다. 버퍼에 그만큼 새로운 것이 없어 거절합니다. 설령 답하더라도 틀린 순간의 답입니다.",
                ),
                "M9",
            ),
            Twin(
                "falls back on latest",
                falls_back,
                Words(
                    en="Where the buffer refuses, you fall back on the latest transform. That turns an honest refusal into a wrong point: let the exception through.",
                    ko="버퍼가 거절하면 최신 변환으로 물러섭니다. 정직한 거절을 틀린 점으로 바꾸는 일입니다. 예외를 그대로 내보내십시오.",
                ),
                "M9",
            ),
            Twin(
                "swallows the refusal",
                swallows,
                Words(
                    en="Where the buffer refuses, you return nothing, and nobody learns why. Let the exception through: whoever calls you decides what to do.",
                    ko="버퍼가 거절하면 아무것도 반환하지 않아 아무도 이유를 알지 못합니다. 예외를 그대로 내보내십시오. 어떻게 할지는 부른 쪽이 정합니다.",
                ),
                "M11",
            ),
            Twin(
                "swapped",
                swapped,
                Words(
                    en="Target and source are swapped. Say it: data expressed in the message's frame, wanted in map. The wanted one comes first.",
                    ko="목표와 원본이 뒤바뀌었습니다. 소리 내어 말해 보십시오. “메시지의 좌표계 기준 데이터를 map 기준으로 보고 싶다.” 보고 싶은 쪽이 먼저입니다.",
                ),
                "M1",
            ),
            Twin(
                "stamped anew",
                restamped,
                Words(
                    en="The place is right, but your point says that it was measured when it arrived. Whoever uses it next can no longer ask about the right moment.",
                    ko="위치는 맞지만, 여러분의 점은 도착한 때 측정했다고 말합니다. 다음에 쓰는 사람은 올바른 순간을 물을 수 없게 됩니다.",
                ),
                "M9",
            ),
            Twin(
                "only the label",
                relabelled,
                Words(
                    en="You wrote map on the label, and left the numbers as the sensor gave them. A frame is not a name to be changed: the point itself has to be moved.",
                    ko="꼬리표만 map으로 바꾸고 숫자는 센서가 준 그대로 두었습니다. 좌표계는 이름만 바꾼다고 바뀌지 않습니다. 점의 숫자를 옮겨야 합니다.",
                ),
            ),
            Twin(
                "left in odom",
                only_odom,
                Words(
                    en="You stopped in odom. The moment is right, but asked for is map: one edge further up.",
                    ko="odom에서 멈추었습니다. 순간은 맞지만 필요한 것은 map입니다. 한 연결 더 올라가야 합니다.",
                ),
            ),
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
    ),
    Task(
        id="E8.4",
        kind="N",
        points=3,
        title=Words(en="How far off?", ko="얼마나 빗나갑니까?"),
        answer="late_error",
        form=Parts(
            {name: Number(unit="m", tolerance=0.003) for name in ("forwards_m", "left_m", "together_m")},
        ),
        given=motion,
        variants=6,
        twins=(
            Twin(
                "speed only",
                lambda g: _late(g, left=0.0),
                Words(
                    en="You left out the turn. The pose of now looks another way, and drags the object along sideways: the more, the farther it is.",
                    ko="회전을 빠뜨렸습니다. 지금의 자세는 다른 쪽을 보고 있어 물체를 옆으로 끌고 갑니다. 멀리 있을수록 더 그렇습니다.",
                ),
                "M9",
            ),
            Twin(
                "degrees",
                lambda g: _late(g, degrees=True),
                Words(
                    en="The yaw rate went in as degrees per second. Arc = range × angle holds for radians.",
                    ko="각속도를 초당 도 단위 그대로 넣었습니다. 호 = 거리 × 각도는 라디안일 때 맞습니다.",
                ),
                "M5",
            ),
            Twin(
                "wrong side",
                lambda g: _late(g, left=-1.0),
                Words(
                    en="The wrong side. If the robot has turned left meanwhile, its straight ahead points further left, and so does the old sight.",
                    ko="반대쪽입니다. 그사이 로봇이 왼쪽으로 돌았다면 정면이 더 왼쪽을 가리키고, 옛 관측도 왼쪽으로 갑니다.",
                ),
            ),
            Twin(
                "added",
                lambda g: _late(g, together=lambda f, s: abs(f) + abs(s)),
                Words(
                    en="The two pieces are at right angles: their lengths do not simply add up.",
                    ko="두 조각은 서로 직각입니다. 길이를 그냥 더하지 않습니다.",
                ),
            ),
            Twin(
                "milliseconds",
                lambda g: _late(g, delay=1.0),
                Words(
                    en="The delay went in as milliseconds. Speeds are per second.",
                    ko="지연을 밀리초 그대로 넣었습니다. 속도는 초당입니다.",
                ),
            ),
            Twin(
                "without the range",
                lambda g: _late(g, left=1.0 / g.range_m),
                Words(
                    en="Yaw rate × delay is the angle only. How long is the arc that it cuts off at the object's distance?",
                    ko="각속도 × 지연은 각도일 뿐입니다. 물체까지의 거리에서 그 각도는 얼마나 긴 호가 됩니까?",
                ),
            ),
            Twin(
                "crosswise",
                _crosswise,
                Words(
                    en="The two pieces have changed places. Driving pushes the point forwards, turning drags it to the side.",
                    ko="두 조각이 자리를 바꾸었습니다. 주행은 점을 앞으로 밀고, 회전은 옆으로 끌고 갑니다.",
                ),
            ),
        ),
        hints=(
            Words(
                en="First bring everything to seconds, metres and radians.",
                ko="먼저 모두 초, m, rad로 바꾸십시오.",
            ),
            Words(
                en="Forwards comes from driving, left from turning. Positive yaw turns to the left.",
                ko="앞뒤는 주행에서, 좌우는 회전에서 옵니다. 양의 yaw는 왼쪽으로 도는 것입니다.",
            ),
            Words(
                en="speed × delay, range × yaw rate × delay, and `math.hypot` of the two.",
                ko="속도 × 지연, 거리 × 각속도 × 지연, 그리고 둘의 `math.hypot`입니다.",
            ),
        ),
        cures=("M9", "M5"),
    ),
    Task(
        id="E8.5",
        kind="D",
        points=3,
        title=Words(en="Six symptoms", ko="여섯 가지 증상"),
        answer="causes",
        form=Parts({symptom: Choice(CAUSES) for symptom in SYMPTOMS}),
        twins=(
            Twin(
                "mount for a smear",
                {**RIGHT, "a": "static mount wrong"},
                Words(
                    en="a: a wrong mount is wrong standing still, too. What changes only while the robot turns, and why would a delay read zero after 0.3 s of filtering?",
                    ko="a: 장착값이 틀렸다면 서 있을 때도 틀립니다. 회전할 때만 달라지는 것은 무엇이고, 0.3초를 거른 뒤에 delay가 0인 까닭은 무엇입니까?",
                ),
                "M9",
            ),
            Twin(
                "odometry for a smear",
                {**RIGHT, "a": "odometry slow"},
                Words(
                    en="a: late odometry can smear walls, but it does not make the delay of a filtered scan read zero. Whose clock wrote that stamp?",
                    ko="a: 늦은 오도메트리도 벽을 번지게 하지만, 거른 스캔의 delay를 0으로 만들지는 않습니다. 그 시각은 누구의 시계로 찍었습니까?",
                ),
                "M9",
            ),
            Twin(
                "stamps for a mount",
                {**RIGHT, "b": "stamp overwritten"},
                Words(
                    en="b: an error of time needs motion. This one stays when the robot stands.",
                    ko="b: 시간의 오차는 움직여야 나타납니다. 이것은 로봇이 서 있어도 남습니다.",
                ),
                "M15",
            ),
            Twin(
                "slow for two clocks",
                {**RIGHT, "c": "odometry slow"},
                Words(
                    en="c: look at the size of the gap. No network and no publisher is that late.",
                    ko="c: 차이의 크기를 보십시오. 어떤 네트워크도 어떤 발행자도 그렇게 늦지 않습니다.",
                ),
                "M10",
            ),
            Twin(
                "clocks for a short cache",
                {**RIGHT, "d": "two clocks"},
                Words(
                    en="d: the past is 1.6 s out of reach, and somebody thinks for 12 s. How long does a buffer remember if you say nothing?",
                    ko="d: 1.6초 차이로 과거에 닿지 못했고, 누군가는 12초를 계산합니다. 따로 정하지 않으면 버퍼는 얼마나 기억합니까?",
                ),
                "M11",
            ),
            Twin(
                "cache for a slow lane",
                {**RIGHT, "e": "cache too short"},
                Words(
                    en="e: the cache decides how far back you can ask. These requests look forward, past the newest sample.",
                    ko="e: 보관 시간은 얼마나 옛날까지 물을 수 있는지를 정합니다. 이 요청들은 가장 새로운 표본보다 앞을 묻습니다.",
                ),
                "M11",
            ),
            Twin(
                "clocks for a slow lane",
                {**RIGHT, "e": "two clocks"},
                Words(
                    en="e: two clocks that disagree do so for every message alike. Here one in four gets through, and one publisher speaks once a second.",
                    ko="e: 시계가 서로 다르면 모든 메시지가 똑같이 어긋납니다. 여기서는 넷 중 하나가 통과하고, 한 발행자는 초당 한 번 말합니다.",
                ),
                "M10",
            ),
            Twin(
                "slow for a short cache",
                {**RIGHT, "d": "odometry slow"},
                Words(
                    en="d: this one is about the earliest data. A slow lane ends too early; which fault makes a lane begin too late?",
                    ko="d: 이 오류는 가장 오래된 데이터를 말합니다. 느린 차선은 너무 일찍 끝납니다. 차선이 너무 늦게 시작하게 만드는 것은 무엇입니까?",
                ),
                "M11",
            ),
            Twin(
                "a cause of time for the traceback",
                {**RIGHT, "f": "two clocks"},
                Words(
                    en="f: whatever is wrong with time or frames raises a TransformException, and every one of those is caught here. So this error is of another family.",
                    ko="f: 시각이나 좌표계에 문제가 있으면 TransformException이 나오고, 여기서는 그것을 모두 잡습니다. 그러니 이 오류는 다른 집안의 것입니다.",
                ),
                "M11",
            ),
        ),
        hints=(
            Words(
                en="Ask of each symptom first: does it stay when the robot stands still?",
                ko="증상마다 먼저 물으십시오. 로봇이 서 있어도 남아 있습니까?",
            ),
            Words(
                en="For the three texts: into the past or into the future, and by how much? Milliseconds, seconds or years?",
                ko="오류 문구에서는 과거인지 미래인지, 그리고 얼마나 모자라는지를 보십시오. 밀리초입니까, 초입니까, 년입니까?",
            ),
            Words(
                en="One of them is no TransformException at all, one has been made to look fresh, one forgot too soon. Each cause is used once.",
                ko="하나는 TransformException이 아예 아니고, 하나는 새것처럼 꾸며졌으며, 하나는 너무 빨리 잊었습니다. 원인은 한 번씩만 쓰입니다.",
            ),
        ),
        cures=("M9", "M10", "M11", "M15"),
    ),
    Task(
        id="E8.6",
        kind="N",
        points=2,
        title=Words(en="How long must it remember?", ko="얼마나 오래 기억해야 합니까?"),
        answer="cache_time_s",
        form=Number(unit="s", tolerance=0.002),
        given=detector,
        variants=6,
        twins=(
            Twin(
                "thinking only",
                lambda g: g.thinking_s,
                Words(
                    en="Then the sample just before the stamp may be gone already, and without it there is nothing to interpolate from.",
                    ko="그러면 측정 시각 바로 앞의 표본이 이미 사라졌을 수 있고, 그것이 없으면 보간할 수 없습니다.",
                ),
            ),
            Twin(
                "the fast lane",
                lambda g: g.thinking_s + 1.0 / max(g.rate_hz.values()),
                Words(
                    en="You counted with the fast edge. Every edge of the path must still hold the sample before the stamp, the slow one too.",
                    ko="빠른 연결로 계산했습니다. 경로의 모든 연결이 측정 시각 앞의 표본을 갖고 있어야 하고, 느린 연결도 마찬가지입니다.",
                ),
            ),
            Twin(
                "both periods",
                lambda g: g.thinking_s + sum(1.0 / rate for rate in g.rate_hz.values()),
                Words(
                    en="You added the periods of both edges. Each lane needs only its own, so the longest one is enough.",
                    ko="두 연결의 주기를 더했습니다. 차선마다 자기 주기만 필요하므로 가장 긴 것이면 충분합니다.",
                ),
            ),
            Twin(
                "one period less",
                lambda g: g.thinking_s - 1.0 / min(g.rate_hz.values()),
                Words(
                    en="A period less than the thinking time: then even the moment of the picture is forgotten.",
                    ko="계산 시간보다 한 주기 짧습니다. 그러면 영상을 찍은 순간조차 잊습니다.",
                ),
            ),
            Twin(
                "rate instead of period",
                lambda g: g.thinking_s + min(g.rate_hz.values()) * (1.0 if min(g.rate_hz.values()) > 1.0 else 1.5),
                Words(
                    en="Did you add a rate to a time? A period is one over the rate.",
                    ko="시간에 Hz를 더하지 않았습니까? 주기는 Hz의 역수입니다.",
                ),
            ),
            Twin(
                "what one gets",
                10.0,
                Words(
                    en="Ten seconds is what you get if you say nothing. It is enough here, but not the least that is enough.",
                    ko="10초는 따로 정하지 않을 때의 값입니다. 여기서는 충분하지만, 충분한 값 가운데 가장 작은 것은 아닙니다.",
                ),
            ),
        ),
        hints=(
            Words(
                en="When the question comes, how far back does the picture's stamp lie?",
                ko="물어보는 순간, 영상의 측정 시각은 얼마나 과거에 있습니까?",
            ),
            Words(
                en="To interpolate at the stamp, a lane needs a sample before it. How much older than the stamp can that one be?",
                ko="측정 시각에서 보간하려면 그 앞의 표본이 필요합니다. 그 표본은 측정 시각보다 얼마나 더 오래된 것일 수 있습니까?",
            ),
            Words(
                en="Thinking time plus one period of the slowest edge on the path.",
                ko="계산 시간에 경로에서 가장 느린 연결의 한 주기를 더합니다.",
            ),
        ),
    ),
    Task(
        id="E8.7",
        kind="F",
        points=4,
        title=Words(en="Where is it now?", ko="지금은 어디에 있습니까?"),
        answer="object_now",
        form=Vector(3, unit="m", frame="base_link", tolerance=0.002),
        inputs=resting_objects,
        variants=3,
        twins=(
            Twin(
                "base_link then",
                lambda buffer, message, now: _at(buffer, message, _stamp(message), _stamp(message)),
                Words(
                    en="That is the object in the base_link of one single moment, as if the robot had stood still between the sighting and now. It has driven on.",
                    ko="어느 한 순간의 base_link 기준으로만 구한 위치입니다. 본 때와 지금 사이에 로봇이 서 있었던 것처럼 계산했지만, 로봇은 계속 달렸습니다.",
                ),
                "M9",
            ),
            Twin(
                "latest instead of now",
                lambda buffer, message, now: _at(buffer, message, Time(), _stamp(message)),
                Words(
                    en="The moment of the sighting is right. But for base_link you took `Time()`, the newest pose in the buffer, and `now` is asked for.",
                    ko="본 순간은 맞습니다. 그런데 base_link에는 버퍼의 가장 새로운 자세를 뜻하는 `Time()`을 썼습니다. 필요한 것은 `now`입니다.",
                ),
                "M9",
            ),
            Twin(
                "times swapped",
                lambda buffer, message, now: _at(buffer, message, _stamp(message), now),
                Words(
                    en="The two times are swapped: you moved a sighting of now into the base_link of then. Each frame is followed by its own time.",
                    ko="두 시각이 뒤바뀌었습니다. 지금 본 것을 그때의 base_link로 옮겼습니다. 좌표계마다 바로 뒤에 자기 시각이 옵니다.",
                ),
            ),
            Twin(
                "left in odom",
                lambda buffer, message, now: _left_in_odom(buffer, message),
                Words(
                    en="These are the coordinates in odom, where the two moments meet. Asked for is base_link, as it is at `now`: one more step.",
                    ko="두 순간이 만나는 odom 기준의 좌표입니다. 필요한 것은 `now` 시각의 base_link 기준 좌표입니다. 한 걸음 더 가십시오.",
                ),
            ),
            Twin(
                "the wrong way",
                lambda buffer, message, now: _the_wrong_way(buffer, message, now),
                Words(
                    en="Target and source are swapped. The target with its time comes first: base_link, now.",
                    ko="목표와 원본이 뒤바뀌었습니다. 목표와 그 시각이 먼저입니다. base_link와 now입니다.",
                ),
                "M1",
            ),
            Twin(
                "through map",
                lambda buffer, message, now: _at(buffer, message, now, _stamp(message), "map"),
                Words(
                    en="You went through map. Between the two moments the localiser corrected itself, map jumped, and the object jumped with it; odom runs on smoothly.",
                    ko="map을 거쳐 갔습니다. 두 순간 사이에 위치 추정이 보정하면서 map이 뛰었고 물체도 함께 뛰었습니다. odom은 매끄럽게 이어집니다.",
                ),
                "M8",
            ),
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
    ),
)
