"""E5.6: The correction, through TF."""

from __future__ import annotations

from tflab.core import LATEST, BufferCore, StampedTransform, Transform, TransformException, seconds
from tflab.workbook.tasks import Pose, Task, Text, WrongAnswer, WrongStep

from .draws import STEP_NEGATED, by_parts, on_the_floor, turned_round

STEP_S = 0.2  # between two poses of the wheels
HAIR_NS = 400_000  # less than half a millisecond


def scans(rng):
    """Scans between two poses of the wheels, one when the map's edge was silent already, one too new, one too old.

    Then at the newest pose and the oldest, and a hair beyond: there a stamp that was rounded asks for another moment.
    """
    rows = []
    for share in (0.15, 0.35, 0.55, 0.95, 1.25, -0.25):
        buffer, start_s, newest_s = in_a_bend(rng)
        stamp_s = start_s + share * (newest_s - start_s)
        rows.append((buffer, on_the_floor(rng), seconds(round(stamp_s, 3))))
    for end, beyond_ns in (("newest", 0), ("newest", HAIR_NS), ("oldest", 0), ("oldest", -HAIR_NS)):
        buffer, start_s, newest_s = in_a_bend(rng)
        stamp_s = newest_s if end == "newest" else start_s
        rows.append((buffer, on_the_floor(rng), seconds(stamp_s) + beyond_ns))
    return rows


def in_a_bend(rng):
    """Return a buffer of a robot that drives a bend, and the wheels' first and newest stamp [s]."""
    buffer = BufferCore()
    start_s = float(rng.integers(5, 40))
    here = on_the_floor(rng)
    speed_mps, yaw_rate_radps = (
        float(rng.uniform(0.4, 0.8)),
        float(rng.choice([-1.0, 1.0])) * float(rng.uniform(0.5, 0.9)),
    )
    step = Transform.from_rpy(yaw=yaw_rate_radps * STEP_S, translation=(speed_mps * STEP_S, 0.0, 0.0))
    edge = on_the_floor(rng, 2.0)
    for tick in range(11):
        stamp_ns = seconds(start_s + STEP_S * tick)
        buffer.set_transform(StampedTransform("odom", "base_footprint", stamp_ns, here), "/wheel_odometry")
        if tick <= 7:
            buffer.set_transform(StampedTransform("map", "odom", stamp_ns, edge), "/localization")
        here = here @ step
    return buffer, start_s, start_s + 10 * STEP_S


def corrected(buffer, map_T_base, stamp_ns, *, moment="stamp", asked="odom", refusal="let through",
              wheels="turned round", found="as given", order="found first", way="as asked"):  # fmt: skip
    """Return map_T_odom, step by step; other steps are the slips."""
    asked_ns = {"stamp": stamp_ns, "latest": LATEST, "seconds": seconds(stamp_ns),
                "milliseconds": round(stamp_ns / 1e6) * 10**6, "whole seconds": stamp_ns // 10**9 * 10**9}[moment]  # fmt: skip
    try:
        odom_T_base = buffer.lookup_transform(asked, "base_footprint", asked_ns).transform
    except TransformException:
        if refusal == "let through":
            raise
        if refusal == "None":
            return None
        if refusal == "old edge":
            return buffer.lookup_transform("map", "odom", LATEST).transform
        odom_T_base = buffer.lookup_transform(asked, "base_footprint", LATEST).transform
    if wheels == "parts":
        return by_parts(map_T_base, odom_T_base)
    right = turned_round(odom_T_base, wheels)
    left = map_T_base.inverse() if found == "turned round" else map_T_base
    edge = left @ right if order == "found first" else right @ left
    return edge.inverse() if way == "turned round" else edge


LATEST_INSTEAD = WrongStep(
    "latest",
    {"moment": "latest"},
    Text(
        en="You asked for the latest pose of the wheels. The robot was found where it stood when the scan was taken, and it has driven and turned since: both poses belong to `stamp_ns`.",
        ko="바퀴의 최신 포즈를 물었습니다. 지도에서 찾은 포즈는 스캔을 측정한 때의 것이고, 로봇은 그 뒤로 달리고 돌았습니다. 두 포즈 모두 `stamp_ns`의 것이어야 합니다.",
    ),
    "M9",
)

STAMP_TAKEN_FOR_SECONDS = WrongStep(
    "stamp taken for seconds",
    {"moment": "seconds"},
    Text(
        en="The buffer refuses each of your questions: the moment that you ask about is none of those that it holds. `stamp_ns` is in nanoseconds, just as the buffer takes it: hand it over as it is, neither multiplied (`seconds(...)` does so, too) nor divided. Whether the rest is right shows only once the buffer answers.",
        ko="버퍼가 모든 질문을 거절합니다. 요청 시각이 버퍼에 있는 시각이 아닙니다. `stamp_ns`는 버퍼가 받는 그대로 나노초이므로, 곱하지도(`seconds(...)`도 곱셈입니다) 나누지도 말고 그대로 넘기십시오. 나머지가 맞는지는 버퍼가 답한 다음에 알 수 있습니다.",
    ),
)

STAMP_ROUNDED = WrongStep(
    "stamp rounded",
    {"moment": "milliseconds"},
    Text(
        en="You round the stamp. A hair beyond the wheels' poses the buffer then answers for a moment that nobody asked about: hand over `stamp_ns` as it is.",
        ko="시각을 반올림했습니다. 바퀴의 포즈가 끝난 바로 다음 시각을 물을 때, 버퍼가 다른 시각의 값을 답하게 됩니다. `stamp_ns`를 그대로 넘기십시오.",
    ),
)

AGAINST_THE_MAP = WrongStep(
    "against the map",
    {"asked": "map"},
    Text(
        en="You asked where the robot was in `map`. That holds the old correction already; what is to be turned round is the pose that the wheels measured, in `odom`.",
        ko="`map` 기준 로봇의 포즈를 물었습니다. 여기에는 이전의 보정이 이미 들어 있습니다. 뒤집을 것은 바퀴가 잰 포즈, 곧 `odom` 기준의 포즈입니다.",
    ),
    "M7",
)

FALLS_BACK_ON_LATEST = WrongStep(
    "falls back on latest",
    {"refusal": "latest"},
    Text(
        en="Where the buffer has no pose of that moment, you take the latest. The edge is then wrong, and nobody hears of it: let the exception through.",
        ko="버퍼에 그 시각의 포즈가 없으면 최신 포즈를 씁니다. 그러면 연결이 틀리는데도 아무도 알지 못합니다. 예외를 그대로 내보내십시오.",
    ),
    "M9",
)

FALLS_BACK_ON_THE_OLD_EDGE = WrongStep(
    "falls back on the old edge",
    {"refusal": "old edge"},
    Text(
        en="Where the buffer has no pose of that moment, you hand back the newest `map → odom` that is in it, as if the scan had corrected nothing, and nobody hears of it: let the exception through.",
        ko="버퍼에 그 시각의 포즈가 없으면 버퍼의 최신 `map → odom`을 그대로 반환합니다. 스캔이 아무것도 바로잡지 않은 셈인데 아무도 알지 못합니다. 예외를 그대로 내보내십시오.",
    ),
    "M9",
)

SWALLOWS_THE_REFUSAL = WrongStep(
    "swallows the refusal",
    {"refusal": "None"},
    Text(
        en="Where the buffer refuses, you return None. Whoever calls you has to learn why there is no correction: let the exception through.",
        ko="버퍼가 거절하면 None을 반환합니다. 호출한 쪽은 왜 보정이 없는지 알아야 합니다. 예외를 그대로 내보내십시오.",
    ),
    "M11",
)

NOT_TURNED_ROUND = WrongStep(
    "not turned round",
    {"wheels": "as given"},
    Text(
        en="The tiles [map|base][odom|base] do not match. Either the inverse is missing, or the ends of the lookup are exchanged and then turned back once more.",
        ko="[map|base][odom|base]는 이웃이 맞지 않습니다. 역변환이 빠졌거나, 조회의 목표와 원본을 바꾸어 쓰고 그것을 다시 뒤집었습니다.",
    ),
    "M1",
)

SUBTRACTED = WrongStep(
    "subtracted",
    {"wheels": "parts"},
    Text(
        en="You subtracted steps and yaws. The wheels' step is measured along odom's axes, and those are turned in `map`: join with `@`.",
        ko="이동과 yaw를 따로 뺐습니다. 바퀴의 이동은 odom의 축을 따라 잰 것이고, 그 축은 `map` 기준으로 돌아 있습니다. `@`로 이으십시오.",
    ),
    "M3",
)

OTHER_ORDER = WrongStep(
    "other order",
    {"order": "wheels first"},
    Text(
        en="The factors stand in the other order. The tile that begins with map comes first.",
        ko="곱의 순서가 바뀌었습니다. map으로 시작하는 조각이 먼저입니다.",
    ),
    "M1",
)

THE_OTHER_WAY = WrongStep(
    "the other way",
    {"way": "turned round"},
    Text(
        en="That is odom_T_map: the same edge, read the other way. Asked for is map_T_odom, map as the parent.",
        ko="odom_T_map입니다. 같은 연결을 거꾸로 읽은 것입니다. map이 부모인 map_T_odom이 필요합니다.",
    ),
    "M1",
)

WHAT_THE_WHEELS_SAY = WrongAnswer(
    "what the wheels say",
    lambda buffer, map_T_base, stamp_ns: buffer.lookup_transform("odom", "base_footprint", stamp_ns).transform,
    Text(
        en="That is what the wheels publish already, at the right moment. What was found on the map has no part in it.",
        ko="바퀴가 이미 발행한, 그 시각의 포즈입니다. 지도에서 찾은 포즈가 들어 있지 않습니다.",
    ),
    "M7",
)

WHERE_THE_ROBOT_IS = WrongAnswer(
    "where the robot is",
    lambda buffer, map_T_base, stamp_ns: map_T_base,
    Text(
        en="You hand back where the robot is on the map. `base_footprint` has its parent, `odom`: what is wanted is the edge above odom.",
        ko="지도 위 로봇의 포즈를 그대로 반환합니다. `base_footprint`에는 이미 부모 `odom`이 있습니다. 필요한 것은 odom 위의 연결입니다.",
    ),
    "M7",
)

AGAINST_THE_OLD_EDGE = WrongAnswer(
    "against the old edge",
    lambda buffer, map_T_base, stamp_ns: (
        map_T_base @ buffer.lookup_transform("map", "odom", stamp_ns).transform.inverse()
    ),
    Text(
        en="You turned the old edge round, `map → odom`, and took it out of the pose on the map. What has to be taken out is the wheels' pose, from odom to `base_footprint`.",
        ko="이전 연결 `map → odom`을 뒤집어 지도 위의 포즈에서 빼냈습니다. 빼낼 것은 odom에서 `base_footprint`까지, 곧 바퀴의 포즈입니다.",
    ),
    "M7",
)

THE_OLD_EDGE = WrongAnswer(
    "the old edge",
    lambda buffer, map_T_base, stamp_ns: buffer.lookup_transform("map", "odom", stamp_ns).transform,
    Text(
        en="That is the edge as it was before this scan. The correction has to come out of `map_T_base`.",
        ko="이 스캔 이전의 연결입니다. 보정은 `map_T_base`에서 나와야 합니다.",
    ),
)


THE_OTHER_ONE_TURNED_ROUND = WrongStep(
    "the other one turned round",
    {"wheels": "as given", "found": "turned round"},
    Text(
        en="You turned the wrong one of the two round: the pose on the map begins with map already; it is the wheels' that has to be turned.",
        ko="둘 가운데 다른 쪽을 뒤집었습니다. 지도 위의 포즈는 이미 map으로 시작합니다. 뒤집을 것은 바퀴의 포즈입니다.",
    ),
    "M1",
)


ORDER_AND_NO_INVERSE = WrongStep(
    "other order, nothing turned",
    {"wheels": "as given", "order": "wheels first"},
    Text(
        en="Both poses went in as they are, and the wheels' one stands first. Begin with map, and turn the wheels' pose round.",
        ko="두 포즈를 그대로 곱했고 바퀴의 포즈가 앞에 있습니다. map부터 시작하고 바퀴의 포즈를 뒤집으십시오.",
    ),
    "M1",
)


WHOLE_SECONDS = WrongStep(
    "whole seconds",
    {"moment": "whole seconds"},
    Text(
        en="You ask at the whole second of the stamp. In what is cut off the robot drives on and turns: hand over `stamp_ns` as it is.",
        ko="시각을 초 단위로 잘라 조회합니다. 잘라 낸 동안에도 로봇은 달리고 돕니다. `stamp_ns`를 그대로 넘기십시오.",
    ),
    "M9",
)


TURNED_BACK_STEP_NEGATED = WrongStep(
    "turned back, step negated",
    {"wheels": "turned back, step negated"},
    Text(
        en="Of the wheels' pose the rotation is turned back, and the step has only changed its signs. In an inverse the step is turned as well: `.inverse()` does both.",
        ko="바퀴 포즈의 회전은 뒤집었지만 이동은 부호만 바꾸었습니다. 역변환에서는 이동도 함께 돌아갑니다. `.inverse()`가 둘 다 합니다.",
    ),
    "M3",
)


TASK = Task(
    id="E5.6",
    kind="F",
    points=4,
    title=Text(en="The correction, through TF", ko="TF로 구하는 보정"),
    answer="correction",
    form=Pose(),
    inputs=scans,
    variants=3,
    model=corrected,
    mistakes=(
        LATEST_INSTEAD,
        NOT_TURNED_ROUND,
        AGAINST_THE_MAP,
        FALLS_BACK_ON_LATEST,
        FALLS_BACK_ON_THE_OLD_EDGE,
        SWALLOWS_THE_REFUSAL,
        OTHER_ORDER,
        THE_OTHER_WAY,
        SUBTRACTED,
        STAMP_TAKEN_FOR_SECONDS,
        STAMP_ROUNDED,
        WHAT_THE_WHEELS_SAY,
        WHERE_THE_ROBOT_IS,
        THE_OLD_EDGE,
        AGAINST_THE_OLD_EDGE,
        THE_OTHER_ONE_TURNED_ROUND,
        ORDER_AND_NO_INVERSE,
        WHOLE_SECONDS,
        STEP_NEGATED,
        TURNED_BACK_STEP_NEGATED,
    ),
    hints=(
        Text(
            en="Two poses of one moment, as in E5.1. One of them is given; the other one TF has.",
            ko="E5.1처럼 같은 시각의 두 포즈입니다. 하나는 주어지고 다른 하나는 TF에 있습니다.",
        ),
        Text(
            en="Which moment is it? The buffer holds many poses of the wheels, and the newest is not the scan's.",
            ko="어느 시각일까요? 버퍼에는 바퀴의 포즈가 여럿 있고, 최신 포즈는 스캔의 것이 아닙니다.",
        ),
        Text(
            en="`buffer.lookup_transform(target, source, stamp_ns).transform` is a Transform; then go on as in E5.1. Catch nothing.",
            ko="`buffer.lookup_transform(target, source, stamp_ns).transform`은 Transform입니다. 그다음은 E5.1과 같습니다. 예외는 잡지 마십시오.",
        ),
    ),
    misconceptions=("M9", "M1", "M7"),
)
