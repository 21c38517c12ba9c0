"""E10.6: Can a bag place its own messages?"""

from __future__ import annotations

from tflab.core import StampedTransform, Transform, seconds
from tflab.ros.duration import Duration
from tflab.ros.messages import geometry_msgs, std_msgs
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.time import Time
from tflab.workbook.tasks import Choice, Number, Parts, Task, Text, WrongStep

KINDS = ("none", "LookupException", "ConnectivityException", "ExtrapolationException")


def edge(parent, child, *times_s):
    """Return one transform for each time [s]; with none it is static."""
    return [StampedTransform(parent, child, seconds(t), Transform((0.1, 0.0, 0.0))) for t in times_s or (0.0,)]


def filled(*edges):
    buffer = Buffer(Duration(seconds=60))
    for stamped in (one for each in edges for one in each):
        buffer.core.set_transform(stamped, "bag", is_static=stamped.stamp_ns == 0)
    return buffer


def message(frame, time_s):
    header = std_msgs.Header(frame_id=frame, stamp=Time(nanoseconds=seconds(time_s)).to_msg())
    return geometry_msgs.PointStamped(header=header)


def bags(rng):
    """Draw what bags hold: whole, begun late, without mounts, with two trees, with a lost frame, and in another order."""
    t = int(rng.integers(20, 40)) + 0.2

    def at(share):
        return round(t + 10.0 * share + float(rng.uniform(0.01, 0.4)), 3)

    drive = edge("map", "odom", t, t + 5.0, t + 10.0), edge("odom", "base_link", t, t + 5.0, t + 10.0)
    laser, camera = edge("base_link", "laser_frame"), edge("mast", "camera_link")
    scans = [message("laser_frame", at(share)) for share in (0.1, 0.3, 0.5, 0.7, 0.9)]
    barely = message("laser_frame", t + 10.05)  # in the same whole second as what can be placed
    soon = message("laser_frame", t + 9.85)  # its nanosec has lost a zero
    early, late, seen = (
        message("laser_frame", t - 0.3),
        message("laser_frame", t + 11.5),
        message("camera_link", at(0.4)),
    )
    lost = message("lazer_frame", at(0.2))
    return [
        (filled(*drive, laser), [*scans, soon], "map"),
        (filled(*drive, laser), [early, *scans, late], "map"),
        (filled(*drive), scans[:3], "map"),
        (filled(*drive, laser, camera), [scans[0], seen, scans[1], barely, late, lost, scans[2]], "map"),
        (filled(*drive, laser), [lost, early, *scans[:2]], "odom"),
        (filled(*drive, laser, camera), [*scans[:2], late, seen, lost], "base_link"),
        (filled(*drive, laser, camera), [scans[0], seen, lost, scans[3], late], "map"),  # by stamp it is the second
        (filled(*drive, laser), [], "map"),
    ]


def placing(buffer, messages, target, ask="the stamp", stops=False, which="first", kind="its own",
            frame="each", into="target", count="placed"):  # fmt: skip
    """Return what the bag can place, step by step."""
    placed, noes, frames = 0, [], set()
    in_order = sorted(messages, key=lambda each: (each.header.stamp.sec, each.header.stamp.nanosec))
    for each in in_order if which == "by stamp" else messages:
        source = {
            "the first's": messages[0].header.frame_id,
            "base_link": "base_link",
            "laser_frame": "laser_frame",
        }.get(frame, each.header.frame_id)
        try:
            when = _asked(ask, messages[0].header.stamp if ask == "the first's" else each.header.stamp)
            buffer.lookup_transform("map" if into == "map" else target, source, when)
        except Exception as error:
            noes.append(_named(type(error).__name__, kind))
            placed += count == "or the latest" and buffer.can_transform(target, source, Time())
            if stops:
                break
        else:
            placed += 1
            frames.add(source)
    told = {"last": noes[-1:], "most": noes and [max(noes, key=noes.count)]}.get(which, noes)
    no = told[0] if told else "none"
    share = placed / max(1, len(messages))
    counted = {"noes": len(messages) - placed, "all": len(messages), "share": share, "frames": len(frames)}.get(
        count, placed
    )
    return {"placed": counted, "first_no": no}


def _asked(ask, stamp):
    """Return the moment that is asked for."""
    return {
        "the latest": lambda: Time(),
        "whole seconds": lambda: Time(seconds=stamp.sec),
        "nanosec alone": lambda: Time(nanoseconds=stamp.nanosec),
        "decimals": lambda: Time(seconds=float(f"{stamp.sec}.{stamp.nanosec}")),
    }.get(ask, lambda: Time.from_msg(stamp))()


def _named(name, kind):
    """Return what a refusal is called."""
    as_another = {
        "its own": {},
        "lookup as connectivity": {"LookupException": "ConnectivityException"},
        "extrapolation as lookup": {"ExtrapolationException": "LookupException"},
    }
    return as_another[kind].get(name, name) if kind in as_another else kind


LATEST = WrongStep(
    "the latest",
    {"ask": "the latest"},
    Text(
        en="You ask with `Time()`, and place every message where the robot was at the end. Each message has a stamp of its own.",
        ko="`Time()`을 조회해서, 모든 메시지를 마지막 순간의 로봇 위치에 놓았습니다. 메시지마다 자기 측정 시각이 있습니다.",
    ),
    "M9",
)

FIRST_NO_ENDS_IT = WrongStep(
    "the first no ends it",
    {"stops": True},
    Text(
        en="After the first message without a place you stop looking. One old scan says nothing about the others: catch inside the loop, and go on.",
        ko="위치를 찾지 못하는 메시지가 처음 나오면 멈춥니다. 오래된 스캔 하나로 나머지까지 알 수는 없습니다. 반복문 안에서 예외를 잡고 계속하십시오.",
    ),
    "M11",
)

LAST_NO = WrongStep(
    "the last no",
    {"which": "last"},
    Text(
        en="You tell the last refusal. Asked for is the first: keep it, once you have one.",
        ko="마지막 거절을 반환합니다. 필요한 것은 첫 거절입니다. 한번 얻었으면 그대로 두십시오.",
    ),
)

COUNTS_NOES = WrongStep(
    "counts noes",
    {"count": "noes"},
    Text(
        en="That is how many could *not* be placed. Count the answers.",
        ko="위치를 찾지 *못한* 메시지의 개수입니다. 답을 얻은 것을 세십시오.",
    ),
)

ALWAYS_EXTRAPOLATION = WrongStep(
    "always extrapolation",
    {"kind": "ExtrapolationException"},
    Text(
        en="Every refusal is an extrapolation to you. A name that nobody knows and a path that is missing are other classes: `type(error).__name__`.",
        ko="모든 거절을 외삽이라고 합니다. 모르는 이름과 없는 경로는 다른 클래스입니다. `type(error).__name__`을 쓰십시오.",
    ),
    "M11",
)

ALWAYS_LOOKUP = WrongStep(
    "always lookup",
    {"kind": "LookupException"},
    Text(
        en="Every refusal is a lookup error to you. A missing path and a missing moment are other classes: `type(error).__name__`.",
        ko="모든 거절을 LookupException이라고 합니다. 없는 경로와 없는 시각은 다른 클래스입니다. `type(error).__name__`을 쓰십시오.",
    ),
    "M11",
)

BASE_CLASS = WrongStep(
    "base class",
    {"kind": "TransformException"},
    Text(
        en="You name the base class that you caught, not the class that was raised: `type(error).__name__`.",
        ko="잡은 부모 클래스의 이름을 반환합니다. 실제로 일어난 예외의 이름은 `type(error).__name__`입니다.",
    ),
    "M11",
)

YES_OR_NO = WrongStep(
    "yes or no",
    {"kind": "none"},
    Text(
        en='"first_no" is always "none". `can_transform` says only yes or no; ask with `lookup_transform`, and keep what it raises.',
        ko='"first_no"가 언제나 "none"입니다. `can_transform`은 되는지만 알려 줍니다. `lookup_transform`으로 조회하고 일어난 예외를 간직하십시오.',
    ),
    "M11",
)

FRAME_OF_THE_FIRST = WrongStep(
    "frame of the first",
    {"frame": "the first's"},
    Text(
        en="You take the frame of the first message for all of them. Each has its own.",
        ko="첫 메시지의 좌표계를 모두에 썼습니다. 메시지마다 자기 좌표계가 있습니다.",
    ),
)

COUNTS_EVERYTHING = WrongStep(
    "counts everything",
    {"count": "all"},
    Text(
        en="That is how many messages there are. Count those for which the lookup answered.",
        ko="그것은 메시지의 개수입니다. 조회에 답이 나온 것을 세십시오.",
    ),
)

CONNECTIVITY_FOR_LOOKUP = WrongStep(
    "lookup called connectivity",
    {"kind": "lookup as connectivity"},
    Text(
        en="A name that nobody knows is a LookupException; you call it a missing path. `type(error).__name__` says it by itself.",
        ko="모르는 이름은 LookupException입니다. 그것을 경로 없음이라고 했습니다. `type(error).__name__`을 쓰면 저절로 맞습니다.",
    ),
    "M11",
)

LOOKUP_FOR_EXTRAPOLATION = WrongStep(
    "extrapolation called lookup",
    {"kind": "extrapolation as lookup"},
    Text(
        en="A moment that the buffer has not is an ExtrapolationException; you call it an unknown name.",
        ko="버퍼에 없는 시각은 ExtrapolationException입니다. 그것을 모르는 이름이라고 했습니다.",
    ),
    "M11",
)

A_SHARE = WrongStep(
    "a share",
    {"count": "share"},
    Text(
        en="You divide by the number of messages. Asked for is how many there are, not which share.",
        ko="메시지의 수로 나눴습니다. 비율이 아니라 개수를 물었습니다.",
    ),
)

MOST_FREQUENT_NO = WrongStep(
    "the most frequent no",
    {"which": "most"},
    Text(
        en="You tell the refusal that comes most often. Asked for is the one that comes first.",
        ko="가장 자주 나온 거절을 답했습니다. 구할 것은 맨 처음 나온 거절입니다.",
    ),
)

STAMP_OF_THE_FIRST = WrongStep(
    "stamp of the first",
    {"ask": "the first's"},
    Text(
        en="You ask at the stamp of the first message for all of them. Each has its own.",
        ko="모든 메시지를 첫 메시지의 측정 시각으로 조회합니다. 측정 시각은 메시지마다 다릅니다.",
    ),
    "M9",
)

BASE_FOR_THE_SENSOR = WrongStep(
    "base for the sensor",
    {"frame": "base_link"},
    Text(
        en="You ask where the robot was, and not where the sensor was: each message says in which frame its numbers are.",
        ko="센서가 아니라 로봇의 위치를 조회합니다. 메시지의 숫자가 어느 좌표계 기준인지는 메시지마다 적혀 있습니다.",
    ),
    "M1",
)

LASER_FOR_ALL = WrongStep(
    "laser for all",
    {"frame": "laser_frame"},
    Text(
        en="You ask for `laser_frame` each time. Not every message is of the laser: its header says in which frame its numbers are.",
        ko="언제나 `laser_frame`으로 조회합니다. 모두 레이저의 메시지인 것은 아닙니다. 숫자가 어느 좌표계 기준인지는 header에 적혀 있습니다.",
    ),
    "M1",
)

ALWAYS_IN_MAP = WrongStep(
    "always in map",
    {"into": "map"},
    Text(
        en="You ask for all of it in one and the same frame. The third argument says in which frame it is wanted.",
        ko="언제나 같은 좌표계 기준으로 조회합니다. 어느 좌표계 기준으로 필요한지는 셋째 인자에 있습니다.",
    ),
    "M1",
)

NANOSEC_AS_DECIMALS = WrongStep(
    "nanosec as decimals",
    {"ask": "decimals"},
    Text(
        en="You write `nanosec` behind a point. It is a number of nanoseconds and has lost its leading zeros: 50000000 would become half a second.",
        ko="`nanosec`을 소수점 뒤에 붙였습니다. 나노초의 수이므로 첫머리의 0이 없습니다. 그러면 50000000이 0.5초가 됩니다.",
    ),
    "M9",
)

WHOLE_SECONDS = WrongStep(
    "whole seconds",
    {"ask": "whole seconds"},
    Text(
        en="You ask at the whole second of a stamp. Its nanosec belongs to it: `Time.from_msg`.",
        ko="측정 시각에서 초만 조회했습니다. nanosec도 시각의 일부입니다. `Time.from_msg`를 쓰십시오.",
    ),
    "M9",
)

NANOSEC_ALONE = WrongStep(
    "a moment far away",
    {"ask": "nanosec alone"},
    Text(
        en="You ask at moments that are far away from all transforms. `sec` and `nanosec` make one moment together: `Time.from_msg`.",
        ko="모든 변환에서 멀리 떨어진 시각으로 조회합니다. `sec`과 `nanosec`이 함께 한 시각입니다: `Time.from_msg`.",
    ),
    "M9",
)


FRAMES_COUNTED = WrongStep(
    "frames counted",
    {"count": "frames"},
    Text(
        en='"placed" is how many different frames the placed messages have, as in a set of names. Count the messages.',
        ko='"placed"에 위치를 찾은 메시지의 서로 다른 좌표계 수가 있습니다. 이름을 집합에 모을 때 그렇습니다. 메시지를 세십시오.',
    ),
)


OR_THE_LATEST = WrongStep(
    "or the latest",
    {"count": "or the latest"},
    Text(
        en="Where there is nothing at its stamp, you count a message all the same if there is something at another time, the latest. That places it where it was not measured.",
        ko="측정 시각의 변환이 없어도 다른 시각, 곧 최신 변환이 있으면 셉니다. 그러면 측정한 곳이 아닌 자리에 놓입니다.",
    ),
    "M9",
)


FIRST_BY_STAMP = WrongStep(
    "first by stamp",
    {"which": "by stamp"},
    Text(
        en="You tell the refusal of the oldest stamp. Asked for is the first one in the order in which the messages come.",
        ko="측정 시각이 가장 이른 메시지의 거절을 답했습니다. 메시지가 놓인 순서에서 맨 처음 나온 거절이 필요합니다.",
    ),
)


TASK = Task(
    id="E10.6",
    kind="F",
    points=4,
    title=Text(en="Can a bag place its own messages?", ko="bag은 자기 메시지의 위치를 스스로 찾을 수 있습니까?"),
    answer="placeable",
    form=Parts({"placed": Number(tolerance=0.0), "first_no": Choice(KINDS)}),
    inputs=bags,
    variants=3,
    model=placing,
    mistakes=(
        FRAME_OF_THE_FIRST,
        BASE_FOR_THE_SENSOR,
        LASER_FOR_ALL,
        ALWAYS_IN_MAP,
        LATEST,
        STAMP_OF_THE_FIRST,
        NANOSEC_AS_DECIMALS,
        ALWAYS_EXTRAPOLATION,
        ALWAYS_LOOKUP,
        BASE_CLASS,
        YES_OR_NO,
        FIRST_NO_ENDS_IT,
        LAST_NO,
        MOST_FREQUENT_NO,
        A_SHARE,
        COUNTS_NOES,
        COUNTS_EVERYTHING,
        CONNECTIVITY_FOR_LOOKUP,
        LOOKUP_FOR_EXTRAPOLATION,
        WHOLE_SECONDS,
        NANOSEC_ALONE,
        FRAMES_COUNTED,
        OR_THE_LATEST,
        FIRST_BY_STAMP,
    ),
    hints=(
        Text(
            en="One loop, one `try` inside of it, and two things to keep: a count, and the first refusal.",
            ko="반복문 하나, 그 안에 `try` 하나, 그리고 간직할 것 둘입니다. 개수와 첫 거절입니다.",
        ),
        Text(
            en="The question for each message: `lookup_transform(target, message.header.frame_id, Time.from_msg(message.header.stamp))`.",
            ko="메시지마다 조회하는 것: `lookup_transform(target, message.header.frame_id, Time.from_msg(message.header.stamp))`.",
        ),
        Text(
            en='`except TransformException as error:`, and there `type(error).__name__`, unless you have one already. Begin with "none".',
            ko='`except TransformException as error:`에서 아직 없을 때만 `type(error).__name__`을 적습니다. 처음 값은 "none"입니다.',
        ),
    ),
    misconceptions=("M9", "M11"),
    equivalent={
        "buffer.lookup_transform(target, message.header.frame_id, Time.from_msg(message.header.stamp)) -> "
        "buffer.lookup_transform(message.header.frame_id, target, Time.from_msg(message.header.stamp))": "there is a "
        "transform one way exactly if there is one the other way, and the refusal is of the same class",
        "Time.from_msg(message.header.stamp) -> message.header.stamp": "a lookup takes the stamp of a message, too",
    },
)
