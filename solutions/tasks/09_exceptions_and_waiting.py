"""The tasks of chapter 9: which "no" was it, what is to be done about it, and where, how long and for what may one wait?

The error lines are made by the engine, so they are those of a robot.  A clock
that is wrong and data that is late are told apart by what each does to the
numbers, never by name.
"""

from __future__ import annotations

import numpy as np

from tflab.core import BufferCore, StampedTransform, Transform, TransformException, seconds
from tflab.ros.duration import Duration
from tflab.ros.messages import geometry_msgs
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.time import Time
from tflab.workbook.answers.forms import Choice, Number, Parts, Sequence
from tflab.workbook.tasks.task import Task, Twin, Words

# E9.1: eight lines -----------------------------------------------------------------

KINDS = ("lookup", "connectivity", "future", "past", "one sample", "invalid argument", "not a TransformException")
CHECKS = ("spelling and publisher", "roots of the tree", "use_sim_time", "the line of code", "a longer timeout")
RIGHT_KINDS = dict(zip("abcdefgh", (*KINDS[:2], "future", "past", "one sample", *KINDS[5:], "future"), strict=True))
RIGHT = {
    **RIGHT_KINDS,
    "c edge": "odom",
    "d edge": "base_footprint",
    "h check": "use_sim_time",
}
EDGES = Choice(("odom", "base_footprint", "base_link", "laser_frame", "arm_link", "tool0"))


def edge(parent: str, child: str, *times_s: float, x: float = 0.1) -> list[StampedTransform]:
    """Return one transform for each time [s]; with none it is static."""
    return [StampedTransform(parent, child, seconds(t), Transform((x, 0.0, 0.0))) for t in times_s or (0.0,)]


def filled(buffer: BufferCore | Buffer, *edges: list[StampedTransform]):
    """Put edges into a buffer, and return it; those at 0 s are static."""
    store = buffer.core if isinstance(buffer, Buffer) else buffer
    for stamped in (one for each in edges for one in each):
        store.set_transform(stamped, "robot", is_static=stamped.stamp_ns == 0)
    return buffer


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


def eight_lines(_rng: np.random.Generator) -> dict:
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


# E9.2: classify --------------------------------------------------------------------


def robot_buffer(t: float, *, is_localized: bool = True) -> Buffer:
    """Return a buffer that is good for map <- laser_frame from `t` + 1 to `t` + 4 [s], or has never heard of map."""
    return filled(
        Buffer(Duration(seconds=20)),
        edge("map", "odom", t, t + 2.0, t + 4.0) if is_localized else [],
        edge("odom", "base_footprint", t + 1.0, t + 2.5, t + 4.5),
        edge("base_footprint", "base_link"),
        edge("base_link", "laser_frame", x=0.2),
        edge("base_link", "tool0", t + 2.0),
        edge("base_lnk", "camera_link"),
    )


def questions(rng: np.random.Generator) -> list[tuple]:
    """Draw one question of each kind, and three that have several faults at once."""
    t = round(float(rng.uniform(20.0, 60.0)), 1)

    def at(low: float, high: float) -> Time:
        return Time(nanoseconds=seconds(round(t + float(rng.uniform(low, high)), 3)))

    drawn = [
        ("map", "laser_frame", at(1.1, 3.9)),
        ("map", "laser_frame", at(4.05, 4.45)),
        ("map", "laser_frame", at(0.1, 0.9)),
        ("map", "camera_link", at(1.1, 3.9)),
        ("map", "Laser_frame", at(1.1, 3.9)),
        ("/map", "laser_frame", at(1.1, 3.9)),
        ("base_link", "tool0", at(2.2, 3.9)),
        ("map", "laser_frame", Time()),
        ("camera_link", "odom", at(20.0, 40.0)),  # no path either
        ("map", "gripper", at(20.0, 40.0)),  # an unknown name, and too late
        ("gripper", "/laser_frame", at(1.1, 3.9)),  # two names that are wrong, each in its way
    ]
    return [(robot_buffer(t), *question) for question in drawn]


def refusal(buffer: Buffer, target: str, source: str, stamp: Time) -> TransformException | None:
    """Return why there is no answer, or None if there is one."""
    try:
        buffer.lookup_transform(target, source, stamp)
    except TransformException as error:
        return error
    return None


def kind_of(error: TransformException | None) -> str:
    """Return the kind of a refusal, as the task names them."""
    if error is None:
        return "ok"
    directions = {"future": "future", "past": "past", "no_data": "one sample"}
    names = {"LookupException": "lookup", "ConnectivityException": "connectivity"}
    return directions.get(getattr(error, "direction", "")) or names.get(type(error).__name__, "invalid argument")


def latest_only(buffer: Buffer, target: str, source: str, stamp: Time) -> str:
    return kind_of(refusal(buffer, target, source, Time()))


def path_first(buffer: Buffer, target: str, source: str, stamp: Time) -> str:
    first = kind_of(refusal(buffer, target, source, Time()))
    return first if first in ("connectivity", "lookup") else kind_of(refusal(buffer, target, source, stamp))


def two_texts(buffer: Buffer, target: str, source: str, stamp: Time) -> str:
    kind = kind_of(refusal(buffer, target, source, stamp))
    return "past" if kind == "one sample" else kind


def base_first(buffer: Buffer, target: str, source: str, stamp: Time) -> str:
    return "ok" if refusal(buffer, target, source, stamp) is None else "invalid argument"


def one_word(buffer: Buffer, target: str, source: str, stamp: Time) -> str:
    return "ok" if refusal(buffer, target, source, stamp) is None else "lookup"


def ends_swapped(buffer: Buffer, target: str, source: str, stamp: Time) -> str:
    return kind_of(refusal(buffer, source, target, stamp))


def turned_round(buffer: Buffer, target: str, source: str, stamp: Time) -> str:
    kind = kind_of(refusal(buffer, target, source, stamp))
    return {"past": "future", "future": "past"}.get(kind, kind)


# E9.3: what to do ------------------------------------------------------------------

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
    """Draw messages for each action, gaps on both sides of the limit, one gap longer than its text says, and one
    frame that is no name for a robot that has no map yet: tf2 speaks of its target first.
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
        ("tool0", rng.uniform(2.3, 3.5)),
        ("Laser_frame", rng.uniform(1.2, 3.8)),
        ("camera_link", rng.uniform(1.2, 3.8)),
        ("/laser_frame", rng.uniform(1.2, 3.8)),
        ("", rng.uniform(1.2, 3.8)),
    ]
    rows = [(robot_buffer(t), point_in(frame, round(t + float(later), 3))) for frame, later in drawn]
    lost = point_in("/laser_frame", round(t + float(rng.uniform(1.2, 3.8)), 3))
    return [*rows, (robot_buffer(t, is_localized=False), lost)]


def action(
    buffer: Buffer,
    message: geometry_msgs.PointStamped,
    *,
    limit_s: float = LIMIT_S,
    by_text: bool = False,
    latest: bool = False,
    wait_for_past: bool = False,
    swapped: bool = False,
    two_texts: bool = False,
) -> str:
    """Decide as the task asks; the options are the mistakes."""
    stamp = Time() if latest else Time.from_msg(message.header.stamp)
    ends = ("map", message.header.frame_id)
    error = refusal(buffer, *(reversed(ends) if swapped else ends), stamp)
    kind = kind_of(error)
    if two_texts and kind == "one sample":
        return "check clocks"
    if kind == "future":
        newest_ns = buffer.get_latest_common_time("map", message.header.frame_id).nanoseconds
        gap_ns = stamp.nanoseconds - (error.bound_ns if by_text else newest_ns)
        return "wait" if gap_ns <= seconds(limit_s) else "check clocks"
    words = {"ok": "use", "past": "drop", "one sample": "drop", "lookup": "check names", "connectivity": "check tree"}
    if wait_for_past and kind in ("past", "one sample"):
        return "wait"
    return words.get(kind, "fix message")


def use_or_drop(buffer: Buffer, message: geometry_msgs.PointStamped) -> str:
    return "use" if action(buffer, message) == "use" else "drop"


# E9.4: late or wrong ---------------------------------------------------------------

CAUSES = ("transforms arrive late", "laser clock is fast", "cannot be told from this")
REMEDIES = ("wait a little", "set the laser's clock", "ask chrony on both computers")
LATE, FAST, UNKNOWN = CAUSES


def arrivals(rng: np.random.Generator) -> dict:
    """Draw six seconds of three robots, each with another trouble; rows are (stamp, heard) [s]."""
    troubles = [CAUSES[i] for i in rng.permutation(3)]
    return {f"robot_{name}": one_robot(rng, trouble) for name, trouble in zip("abc", troubles, strict=True)}


def one_robot(rng: np.random.Generator, trouble: str) -> dict:
    stamps = round(float(rng.uniform(20.0, 60.0)), 1) + np.arange(6.0)
    scan = 0.105 + rng.uniform(0.0, 0.004, 6)
    odom = 0.004 + rng.uniform(0.0, 0.002, 6)
    if trouble == LATE:
        odom = odom + rng.uniform(0.18, 0.24) + rng.permutation(np.linspace(0.0, 0.25, 6))
    elif trouble == FAST:
        scan = scan - rng.uniform(0.32, 0.48)
    else:
        odom = odom + rng.uniform(0.28, 0.42)
    rows = {"scan": np.column_stack([stamps, stamps + scan]), "odom": np.column_stack([stamps, stamps + odom])}
    return {name: np.round(row, 3) for name, row in rows.items()}


def guess(given, cause_of) -> dict:
    """Return an answer in which each robot's cause is `cause_of(scan delays, odom delays)`."""
    answer = {}
    for name in "abc":
        heard = getattr(given, f"robot_{name}")
        scan, odom = (np.asarray(heard[topic])[:, 1] - np.asarray(heard[topic])[:, 0] for topic in ("scan", "odom"))
        cause = cause_of(scan, odom)
        answer[name], answer[f"{name} do"] = cause, REMEDIES[CAUSES.index(cause)]
    return answer


def always_late(given) -> dict:
    return guess(given, lambda scan, odom: LATE)


def always_fast(given) -> dict:
    return guess(given, lambda scan, odom: FAST)


def no_tremble(given) -> dict:
    return guess(given, lambda scan, odom: FAST if scan.min() < 0 else LATE)


def smooth_is_laser(given) -> dict:
    return guess(given, lambda scan, odom: LATE if np.ptp(odom) > 0.1 else FAST)


def no_sign(given) -> dict:
    return guess(given, lambda scan, odom: LATE if np.ptp(odom) > 0.1 else UNKNOWN)


def tremble_not_trusted(given) -> dict:
    return guess(given, lambda scan, odom: FAST if scan.min() < 0 else UNKNOWN)


def long_timeout(given) -> dict:
    def cause_of(scan, odom) -> str:
        return FAST if scan.min() < 0 else LATE if np.ptp(odom) > 0.1 else UNKNOWN

    answer = guess(given, cause_of)
    late = next(name for name in "abc" if answer[name] == LATE)
    return {**answer, f"{late} do": "set a timeout of 10 s"}


# E9.5: a queue ---------------------------------------------------------------------


def queues(rng: np.random.Generator) -> list[tuple]:
    """Draw queues with room and without, old messages, one from the future, and one out of order."""
    now = round(float(rng.uniform(20.0, 60.0)), 1)

    def before(*ages_s: float) -> list[float]:
        wobble = rng.uniform(0.0, 0.02, len(ages_s))
        return [round(now - age - float(w), 3) for age, w in zip(ages_s, wobble, strict=True)]

    return [
        (before(0.35, 0.25, 0.15, 0.05), now, 1.0, 2),
        (before(0.95, 0.75, 0.35, 0.15), now, 0.5, 3),
        (before(2.4, 1.7, 0.9), now, 0.5, 3),
        (before(0.3, 0.2, 0.1), now, 0.5, 5),
        (before(0.4, 0.3, -0.4, 0.2), now, 0.5, 2),
        (before(0.15, 0.45, 0.25), now, 1.0, 2),
        ([], now, 0.5, 2),
    ]


def kept(
    stamps_s,
    now_s,
    max_age_s,
    max_size,
    *,
    oldest=False,
    ages=True,
    sizes=True,
    future=False,
    by_place=False,
    backwards=False,
    cut_first=False,
) -> dict:
    """Return what a policy keeps; the options are the mistakes."""
    came = len(stamps_s)
    stamps_s = sorted(stamps_s)[-max_size:] if cut_first else stamps_s
    young = [s for s in stamps_s if not ages or (now_s - s <= max_age_s and (future or s <= now_s))]
    young = young if by_place else sorted(young)
    if sizes:
        young = young[:max_size] if oldest else young[-max_size:]
    return {"kept": young[::-1] if backwards else young, "lost": came - len(young)}


def counted_wrongly(*arguments) -> dict:
    right = kept(*arguments)
    return {**right, "lost": len(right["kept"])}


# E9.6: where may I wait ------------------------------------------------------------

OUTCOMES = ("works", "waits in vain", "waits for ever")
WAITS = dict(zip("abcdefgh", ("waits in vain", "works", "waits in vain", "works", "waits for ever", "waits in vain",
                              "waits in vain", "works"), strict=True))  # fmt: skip


def waits(**changed: str) -> dict[str, str]:
    return {**WAITS, **changed}


# E9.7: how long --------------------------------------------------------------------


def two_edges(rng: np.random.Generator) -> dict:
    """Draw two edges of which the slow one decides, and a scan that has been under way for a while."""
    return {
        "localization": {
            "rate_hz": float(rng.choice((4.0, 5.0, 8.0, 10.0))),
            "delay_s": round(float(rng.uniform(0.070, 0.090)), 3),
            "jitter_s": round(float(rng.uniform(0.020, 0.040)), 3),
        },
        "wheel_odometry": {
            "rate_hz": float(rng.choice((20.0, 25.0))),
            "delay_s": round(float(rng.uniform(0.004, 0.015)), 3),
            "jitter_s": round(float(rng.uniform(0.006, 0.012)), 3),
        },
        "scan_delay_s": round(float(rng.uniform(0.010, 0.022)), 3),
    }


def wait_of(given, *, periods=1.0, jitter=1.0, scan=1.0, combine=max) -> float:
    """Return the wait; the options are the mistakes."""
    sources = (given.localization, given.wheel_odometry)
    each = [periods / one["rate_hz"] + one["delay_s"] + jitter * one["jitter_s"] for one in sources]
    return combine(each) - scan * given.scan_delay_s


TASKS = (
    Task(
        id="E9.1", kind="M", points=4,
        title=Words(en="Eight lines from a log", ko="로그 속 여덟 줄"),
        answer="lines",
        form=Parts({
            **{name: Choice(KINDS) for name in "abcdefgh"},
            "c edge": EDGES, "d edge": EDGES, "h check": Choice(CHECKS),
        }),
        given=eight_lines,
        twins=(
            Twin("accused the named frame",
                 {**RIGHT, "c edge": "laser_frame", "d edge": "laser_frame"},
                 misconception="M11",
                 reply=Words(
                     en="the frames in the text are the two ends of the question, and the edge at fault is somewhere "
                        "between them. Look in the buffer for the window that ends, or begins, at the second time of the text.",
                     ko="오류문에 나온 좌표계는 질문의 양 끝이고, 문제의 연결은 그 사이 어딘가에 있습니다. "
                        "오류문의 두 번째 시각에서 끝나거나 시작하는 구간을 버퍼에서 찾으십시오.")),
            Twin("accused the one that moves", {**RIGHT, "c edge": "base_footprint"}, misconception="M11",
                 reply=Words(
                     en="that edge had news until later than line c says. The window of a chain ends where its laziest publisher ends.",
                     ko="그 연결에는 c에 나온 시각보다 뒤까지 소식이 있었습니다. 체인의 구간은 가장 게으른 발행자가 끝나는 곳에서 끝납니다.")),
            Twin("third text missed", {**RIGHT, "e": "past"}, misconception="M11",
                 reply=Words(
                     en="one of these extrapolations says neither future nor past. Read it again: how many samples does that edge have?",
                     ko="외삽 오류 가운데 하나는 미래도 과거도 아닙니다. 다시 읽어 보십시오. 그 연결에는 표본이 몇 개 있습니까?")),
            Twin("third text taken for the future", {**RIGHT, "e": "future"}, misconception="M11",
                 reply=Words(
                     en="line e is newer than the only sample, but its text does not say \"future\". With a single sample tf2 has a text of its own.",
                     ko="e는 하나뿐인 표본보다 새롭지만 오류문은 \"future\"라고 하지 않습니다. 표본이 하나뿐일 때 tf2는 다른 오류문을 씁니다.")),
            Twin("slash taken for a name", {**RIGHT, "f": "lookup"}, misconception="M11",
                 reply=Words(
                     en="line f never got as far as looking a name up. Read its first two words.",
                     ko="f는 이름을 찾아보는 데까지 가지도 못했습니다. 첫 두 단어를 읽어 보십시오.")),
            Twin("name and path swapped", {**RIGHT, "a": "connectivity", "b": "lookup"}, misconception="M11",
                 reply=Words(
                     en='"does not exist" and "not part of the same tree" are two different noes: one is about a name, the other about a path.',
                     ko='"does not exist"와 "not part of the same tree"는 서로 다른 "아니요"입니다. 하나는 이름, 다른 하나는 경로 문제입니다.')),
            Twin("all in one family", {**RIGHT, "g": "lookup"},
                 reply=Words(
                     en="one of these lines is not from tf2's family at all, and `except TransformException` does not catch it. "
                        "Which one speaks of a Python type?",
                     ko="이 가운데 한 줄은 tf2 예외 가족이 아니어서 `except TransformException`에 잡히지 않습니다. "
                        "파이썬 타입을 말하는 줄은 어느 것입니까?")),
            Twin("wait for a clock", {**RIGHT, "h check": "a longer timeout"}, misconception="M10",
                 reply=Words(
                     en="compare the two times in line h: they are about 56 years apart. Which timeout would bridge that? Two kinds of clock are at work.",
                     ko="h의 두 시각을 비교해 보십시오. 약 56년 차이가 납니다. 어떤 timeout이 그것을 건널 수 있겠습니까? 종류가 다른 두 시계가 돌고 있습니다.")),
            Twin("direction of h turned round", {**RIGHT, "h": "past"}, misconception="M11",
                 reply=Words(
                     en="line h says itself which way it goes. The moment asked for counts: is it before or after all that the buffer has?",
                     ko="h는 방향을 스스로 말하고 있습니다. 물어본 시각을 기준으로 합니다. 버퍼가 가진 모든 것보다 앞입니까, 뒤입니까?")),
            Twin("names for a clock", {**RIGHT, "h check": "spelling and publisher"}, misconception="M11",
                 reply=Words(
                     en="line h: tf2 got as far as the moment, so both names are known and there is a path. Look at the two times.",
                     ko="h: tf2가 시각까지 따졌으니 두 이름은 알려져 있고 경로도 있습니다. 두 시각을 보십시오.")),
            Twin("roots for a clock", {**RIGHT, "h check": "roots of the tree"}, misconception="M11",
                 reply=Words(
                     en="line h: tf2 got as far as the moment, so there is a path between the two. Look at the two times.",
                     ko="h: tf2가 시각까지 따졌으니 둘 사이에 경로는 있습니다. 두 시각을 보십시오.")),
        ),
        hints=(
            Words(en="Ask in this order: was it a question at all? the names? the path? the moment?",
                  ko="이 순서로 물으십시오. 질문이 말이 됩니까? 이름은? 경로는? 시각은?"),
            Words(en='For an edge, take the last number of the line ("… data is at time …"), and look for it among the windows of the buffer.',
                  ko='연결을 찾으려면 줄의 마지막 숫자("… data is at time …")를 버퍼의 구간들 가운데서 찾으십시오.'),
            Words(en="Line e names no direction, line g names a Python type, and the times of line h come from two different worlds: seconds since 1970, and seconds since the start.",
                  ko="e에는 방향이 없고, g에는 파이썬 타입이 있으며, h의 두 시각은 서로 다른 세계의 것입니다. 하나는 1970년부터, 하나는 시작부터 센 초입니다."),
        ),
        cures=("M10", "M11"),
    ),
    Task(
        id="E9.2", kind="F", points=4,
        title=Words(en="Classify a refusal", ko="거절을 분류하기"),
        answer="classify",
        form=Choice(("ok", "invalid argument", "lookup", "connectivity", "future", "past", "one sample")),
        inputs=questions, variants=3,
        twins=(
            Twin("asked for the latest", latest_only, misconception="M9",
                 reply=Words(
                     en="whatever stamp it is given, your function judges as if the latest had been asked for. Is `stamp` really handed on to the lookup?",
                     ko="어떤 시각을 주어도 최신을 물은 것처럼 판단합니다. `stamp`를 조회에 그대로 넘기고 있습니까?")),
            Twin("path before moment", path_first, misconception="M11",
                 reply=Words(
                     en="where a question has no path and no data either, tf2 reports what it finds first while it walks. Ask tf2 once, with the stamp, and believe it; do not check the path yourself beforehand.",
                     ko="경로도 없고 데이터도 없는 질문이라면 tf2는 경로를 따라가며 먼저 찾은 것을 보고합니다. 경로를 미리 따로 확인하지 말고, 주어진 시각으로 한 번만 묻고 그 답을 믿으십시오.")),
            Twin("two texts", two_texts, misconception="M11",
                 reply=Words(
                     en="extrapolation has three texts, and your function knows two. What does tf2 say of an edge that has been heard exactly once?",
                     ko="외삽 오류문은 세 가지인데 이 함수는 두 가지만 압니다. 딱 한 번 들은 연결에 대해 tf2는 무엇이라고 합니까?")),
            Twin("base class first", base_first, misconception="M11",
                 reply=Words(
                     en="every refusal ends in the same branch. Python takes the first `except` that fits, and the base class fits everything: let it come last.",
                     ko="모든 거절이 같은 분기로 들어갑니다. 파이썬은 맞는 첫 `except`를 택하고, 부모 클래스는 무엇에나 맞습니다. 맨 뒤로 보내십시오.")),
            Twin("future and past swapped", turned_round, misconception="M10",
                 reply=Words(
                     en="future and past have changed places. The words are about the moment asked for: newer than all the data is the future.",
                     ko="미래와 과거가 뒤바뀌었습니다. 물어본 시각을 기준으로 한 말입니다. 모든 데이터보다 새로우면 미래입니다.")),
            Twin("ends swapped", ends_swapped, misconception="M1",
                 reply=Words(
                     en="where both names are wrong, tf2 complains of the target first. Your function seems to hand over source and target in the other order: wanted comes first.",
                     ko="두 이름이 모두 틀리면 tf2는 목표(target_frame)부터 탓합니다. 이 함수는 원본과 목표를 거꾸로 넘기는 것 같습니다. 보려는 쪽이 먼저입니다.")),
            Twin("one word for every no", one_word, misconception="M11",
                 reply=Words(
                     en="every refusal gets the same word. An `except TransformException` that stands first takes them all, and `can_transform` says only yes or no: give each class a branch of its own, and let the base class come last.",
                     ko="모든 거절에 같은 단어를 돌려줍니다. 맨 앞에 둔 `except TransformException`은 모두를 가져가고, `can_transform`은 예, 아니요만 말합니다. 클래스마다 분기를 두고 부모 클래스는 맨 뒤에 두십시오.")),
        ),
        hints=(
            Words(en="Do not examine the buffer. Ask it, and sort what it raises.",
                  ko="버퍼를 들여다보지 말고 물어본 다음, 일으킨 예외를 분류하십시오."),
            Words(en="One `try`, four `except`. Python has one ExtrapolationException; which of the three it is stands in `str(error)`.",
                  ko="`try` 하나에 `except` 넷입니다. 파이썬의 ExtrapolationException은 하나이고, 셋 중 무엇인지는 `str(error)`에 있습니다."),
            Words(en='Look in the text for "into the future" and "into the past"; an extrapolation that says neither is the third. InvalidArgumentException is what is left of TransformException.',
                  ko='오류문에서 "into the future"와 "into the past"를 찾으십시오. 둘 다 없으면 세 번째입니다. 나머지 TransformException이 InvalidArgumentException입니다.'),
        ),
        cures=("M11",),
    ),
    Task(
        id="E9.3", kind="F", points=4,
        title=Words(en="From exception to action", ko="예외에서 행동으로"),
        answer="decide",
        form=Choice(ACTIONS),
        inputs=messages, variants=3,
        twins=(
            Twin("waits however far", lambda b, m: action(b, m, limit_s=1e6), misconception="M10",
                 reply=Words(
                     en="your function waits for any future, however far off. A gap of more than 0.2 s is not data on its way: no wait cures it.",
                     ko="아무리 먼 미래라도 기다립니다. 0.2초를 넘는 간격은 오는 중인 데이터가 아닙니다. 기다려도 해결되지 않습니다.")),
            Twin("gap from the text", lambda b, m: action(b, m, by_text=True), misconception="M11",
                 reply=Words(
                     en="the time in the text is that of the first edge that failed, not of the slowest. A wait must last until every edge on the way is there: reckon from the latest common time.",
                     ko="오류문의 시각은 처음 실패한 연결의 것이지, 가장 느린 연결의 것이 아닙니다. 경로의 모든 연결이 올 때까지 기다려야 하므로 최신 공통 시각에서 계산하십시오.")),
            Twin("never waits", lambda b, m: action(b, m, limit_s=-1.0), misconception="M10",
                 reply=Words(
                     en="a small gap into the future is ordinary: the transform is on its way. Your function suspects the clocks even then.",
                     ko="작은 미래 간격은 흔한 일이고 변환이 오는 중입니다. 이 함수는 그때도 시계를 의심합니다.")),
            Twin("latest instead of the stamp", lambda b, m: action(b, m, latest=True), misconception="M9",
                 reply=Words(
                     en="this asks for the latest transform, whatever the message's stamp. Then nothing is ever too old or too new, and the robot uses poses of another moment.",
                     ko="메시지의 시각과 상관없이 최신 변환을 묻고 있습니다. 그러면 너무 오래되거나 너무 새로운 것이 없어지고, 로봇은 다른 시각의 자세를 쓰게 됩니다.")),
            Twin("waits for the past", lambda b, m: action(b, m, wait_for_past=True), misconception="M10",
                 reply=Words(
                     en="your function waits for data that is older than everything in the buffer. Old data does not come back: what does a robot do with such a message?",
                     ko="버퍼의 모든 것보다 오래된 데이터를 기다리고 있습니다. 지나간 데이터는 돌아오지 않습니다. 그런 메시지는 어떻게 해야 합니까?")),
            Twin("ends swapped", lambda b, m: action(b, m, swapped=True), misconception="M1",
                 reply=Words(
                     en="where map is unknown and the message's frame is no name at all, tf2 complains of its target first. Your function asks for the other direction, or looks at the frame before tf2 does: data in the message's frame, wanted in map, and map comes first.",
                     ko="map을 모르고 메시지의 좌표계도 이름이 될 수 없을 때, tf2는 목표부터 탓합니다. 이 함수는 방향을 거꾸로 묻거나, tf2보다 먼저 좌표계 이름을 따지고 있습니다. 메시지의 좌표계 기준 데이터를 map 기준으로 보려 하니 map이 먼저입니다.")),
            Twin("waits for every extrapolation", lambda b, m: action(b, m, limit_s=1e6, wait_for_past=True), misconception="M10",
                 reply=Words(
                     en="every extrapolation is a wait for you. Three kinds are in this class: a little into the future may wait, far into the future is a clock, and what is past does not come back. The text tells them apart.",
                     ko="외삽이면 무조건 기다립니다. 이 클래스에는 세 가지가 있습니다. 조금 앞선 미래는 기다릴 만하고, 한참 앞선 미래는 시계 문제이며, 과거는 돌아오지 않습니다. 오류문이 셋을 가려 줍니다.")),
            Twin("third text taken for the future", lambda b, m: action(b, m, two_texts=True), misconception="M11",
                 reply=Words(
                     en='what is not "past" is not yet "future". An edge that has been heard exactly once gives a third text: any other extrapolation is a "drop".',
                     ko='"past"가 아니라고 해서 "future"인 것은 아닙니다. 딱 한 번 들은 연결은 세 번째 오류문을 냅니다. 그 밖의 외삽은 "drop"입니다.')),
            Twin("one action for every no", use_or_drop, misconception="M11",
                 reply=Words(
                     en='every refusal is a "drop" for you. Then a transform that is 0.1 s late costs a message each time, and a typo is never found: one branch for each class.',
                     ko='거절이면 무조건 "drop"입니다. 그러면 변환이 0.1초만 늦어도 매번 메시지를 잃고, 오타는 영영 찾지 못합니다. 클래스마다 분기를 하나씩 두십시오.')),
        ),
        hints=(
            Words(en="It is E9.2 with other words, and one comparison more.",
                  ko="E9.2와 같되 낱말이 다르고 비교가 하나 더 있습니다."),
            Words(en="For the future, `buffer.get_latest_common_time(target, source)` says how far TF has come. Compare nanoseconds: Times of two clock types cannot be subtracted.",
                  ko="미래라면 `buffer.get_latest_common_time(target, source)`가 TF가 어디까지 왔는지 알려 줍니다. 시계 종류가 다른 Time끼리는 뺄 수 없으니 나노초로 비교하십시오."),
            Words(en='gap = stamp.nanoseconds − newest.nanoseconds; up to 0.2e9 "wait", beyond "check clocks". Every extrapolation that is not into the future is a "drop".',
                  ko='gap = stamp.nanoseconds − newest.nanoseconds이고, 0.2e9까지는 "wait", 넘으면 "check clocks"입니다. 미래가 아닌 외삽은 모두 "drop"입니다.'),
        ),
        cures=("M9", "M10", "M11"),
    ),
    Task(
        id="E9.4", kind="D", points=3,
        title=Words(en="Late, or wrong?", ko="늦은 것입니까, 틀린 것입니까?"),
        answer="causes",
        form=Parts({
            **{name: Choice(CAUSES) for name in "abc"},
            **{f"{name} do": Choice((*REMEDIES, "set a timeout of 10 s")) for name in "abc"},
        }),
        given=arrivals, variants=6,
        twins=(
            Twin("always late", always_late, misconception="M10",
                 reply=Words(
                     en="not all three are late. Subtract stamp from heard for each message first, and look at the sign and at how much the numbers tremble.",
                     ko="셋 다 늦은 것은 아닙니다. 먼저 메시지마다 들은 시각에서 측정 시각을 빼고, 부호와 떨림을 보십시오.")),
            Twin("ten seconds for the late one", long_timeout, misconception="M10",
                 reply=Words(
                     en="the causes are right. But the late robot is late by about a third of a second: whoever may wait ten will one day decide on data that is ten seconds old.",
                     ko="원인은 맞았습니다. 하지만 늦은 로봇도 겨우 3분의 1초 늦습니다. 10초를 기다려도 되는 로봇은 언젠가 10초 묵은 데이터로 결정합니다.")),
            Twin("tremble overlooked", no_tremble, misconception="M10",
                 reply=Words(
                     en="the robot with the negative delay is right. Of the other two, one trembles and one is smooth as glass: can a smooth delay only be a slow network?",
                     ko="지연이 음수인 로봇은 맞았습니다. 나머지 둘 가운데 하나는 떨리고 하나는 유리처럼 매끈합니다. 매끈한 지연이 느린 네트워크에서만 나올까요?")),
            Twin("smooth means laser", smooth_is_laser, misconception="M10",
                 reply=Words(
                     en="one robot's delay is smooth, but it is on /odom, and positive. Nothing is wrong with that laser's numbers.",
                     ko="한 로봇의 지연은 매끈하지만 /odom 쪽이고 양수입니다. 그 레이저의 숫자에는 이상이 없습니다.")),
            Twin("always a clock", always_fast, misconception="M10",
                 reply=Words(
                     en="not every gap is the laser's clock. A fast laser clock makes the delay of /scan too small: look at /scan of each robot first.",
                     ko="모든 간격이 레이저 시계 탓은 아닙니다. 레이저 시계가 빠르면 /scan의 지연이 너무 작아집니다. 로봇마다 /scan부터 보십시오.")),
            Twin("sign overlooked", no_sign, misconception="M10",
                 reply=Words(
                     en="one robot hears its scans before they are measured. That much can be told from the numbers: look at the sign.",
                     ko="한 로봇은 스캔을 측정하기도 전에 듣습니다. 그것만은 숫자로 알 수 있습니다. 부호를 보십시오.")),
            Twin("tremble not trusted", tremble_not_trusted, misconception="M10",
                 reply=Words(
                     en="one robot's /odom trembles by a quarter of a second from message to message. A clock does not do that, a network does: so much can be told.",
                     ko="한 로봇의 /odom은 메시지마다 4분의 1초씩 떨립니다. 시계는 그러지 않지만 네트워크는 그럽니다. 그만큼은 알 수 있습니다.")),
        ),
        hints=(
            Words(en="For each topic: heard minus stamp. Then look at three things: sign, size, tremble.",
                  ko="토픽마다 들은 시각에서 측정 시각을 빼십시오. 그리고 부호, 크기, 떨림 세 가지를 보십시오."),
            Words(en="A healthy /scan is about 0.105 s, a healthy /odom about 0.005 s. Which topic of each robot is not healthy?",
                  ko="정상인 /scan은 약 0.105초, 정상인 /odom은 약 0.005초입니다. 로봇마다 어느 토픽이 정상이 아닙니까?"),
            Words(en="Negative: a clock, and you can say whose. Positive and trembling: the network. Positive and smooth: either, and one-way times cannot tell.",
                  ko="음수면 시계이고, 누구의 시계인지 말할 수 있습니다. 양수이고 떨리면 네트워크입니다. 양수이고 매끈하면 둘 중 어느 쪽인지 한 방향 시각만으로는 알 수 없습니다."),
        ),
        cures=("M10",),
    ),
    Task(
        id="E9.5", kind="F", points=3,
        title=Words(en="A queue that stays fresh", ko="늘 신선한 큐"),
        answer="keep",
        form=Parts({"kept": Sequence(Number("s", 1e-6)), "lost": Number("", 1e-6)}),
        inputs=queues, variants=3,
        twins=(
            Twin("keeps the oldest", lambda *a: kept(*a, oldest=True),
                 reply=Words(
                     en="when the queue is full, yours turns the new ones away. Then the robot decides on the oldest data it has. Let the oldest go.",
                     ko="큐가 꽉 차면 새 메시지를 돌려보내고 있습니다. 그러면 로봇은 가진 것 중 가장 오래된 데이터로 결정합니다. 가장 오래된 것부터 버리십시오.")),
            Twin("age ignored", lambda *a: kept(*a, ages=False),
                 reply=Words(
                     en="there are messages in your queue that are older than the limit. A queue that is not full may still be stale.",
                     ko="한계보다 오래된 메시지가 큐에 남아 있습니다. 꽉 차지 않은 큐도 낡을 수 있습니다.")),
            Twin("size ignored", lambda *a: kept(*a, sizes=False),
                 reply=Words(
                     en="your queue has no size. Where everybody is young enough, everybody stays, and the decisions fall behind.",
                     ko="큐에 크기 제한이 없습니다. 모두 충분히 새로우면 모두 남고, 결정은 점점 뒤처집니다.")),
            Twin("future kept", lambda *a: kept(*a, future=True), misconception="M10",
                 reply=Words(
                     en="a message from the future has a negative age, which is younger than any limit. It comes from a clock that is wrong: do not keep it.",
                     ko="미래에서 온 메시지는 나이가 음수라서 어떤 한계보다도 젊습니다. 틀린 시계에서 온 것이니 두지 마십시오.")),
            Twin("newest first", lambda *a: kept(*a, backwards=True),
                 reply=Words(
                     en="the right messages, in the other order: asked for is oldest first.",
                     ko="메시지는 맞게 골랐지만 순서가 반대입니다. 오래된 것부터 써야 합니다.")),
            Twin("by place", lambda *a: kept(*a, by_place=True),
                 reply=Words(
                     en="you go by the order of arrival. Messages may overtake each other: age is a matter of the stamp.",
                     ko="도착 순서를 따르고 있습니다. 메시지는 서로 앞지를 수 있습니다. 나이는 측정 시각으로 정합니다.")),
            Twin("cut before sieving", lambda *a: kept(*a, cut_first=True),
                 reply=Words(
                     en="you cut to size first and sieve afterwards. Then a message from the future takes the place of a good one: sieve first, and cut what is left.",
                     ko="먼저 개수를 자르고 나중에 거르고 있습니다. 그러면 미래에서 온 메시지가 멀쩡한 메시지의 자리를 차지합니다. 먼저 거르고, 남은 것을 자르십시오.")),
            Twin("everything kept", lambda *a: {"kept": list(a[0]), "lost": 0},
                 reply=Words(
                     en="nothing is ever lost in your queue. That is the queue of the page that decides on data four seconds old.",
                     ko="이 큐는 아무것도 버리지 않습니다. 4초 묵은 데이터로 결정하던 그 큐입니다.")),
            Twin("neither sorted nor cut", lambda *a: kept(*a, by_place=True, sizes=False),
                 reply=Words(
                     en="two things: nobody is turned away when the queue is full, and the messages stand in the order of arrival, not of their stamps.",
                     ko="두 가지입니다. 큐가 꽉 차도 아무것도 버리지 않고, 메시지가 측정 시각이 아니라 도착 순서로 서 있습니다.")),
            Twin("counted what stayed", counted_wrongly,
                 reply=Words(
                     en='"lost" counts the messages that went, not those that stayed.',
                     ko='"lost"는 남은 메시지가 아니라 버린 메시지의 수입니다.')),
        ),
        hints=(
            Words(en="Three sieves, one after the other: from the future, too old, too many.",
                  ko="차례로 세 번 거르십시오. 미래에서 온 것, 너무 오래된 것, 너무 많은 것입니다."),
            Words(en="Sort by stamp before you count from the end.", ko="뒤에서부터 세기 전에 시각 순으로 정렬하십시오."),
            Words(en="`0 <= now_s - stamp <= max_age_s` for the first two; a slice from the end for the third. Lost is what came minus what stayed.",
                  ko="앞의 둘은 `0 <= now_s - stamp <= max_age_s`, 셋째는 끝에서 자르기입니다. 버린 수는 들어온 수에서 남은 수를 뺀 것입니다."),
        ),
        cures=("M10",),
    ),
    Task(
        id="E9.6", kind="M", points=2,
        title=Words(en="Where may I wait?", ko="어디서 기다려도 될까요?"),
        answer="outcomes",
        form=Parts({name: Choice(OUTCOMES) for name in "abcdefgh"}),
        twins=(
            Twin("a timeout always helps", waits(a="works", c="works", e="works", f="works", g="works"), misconception="M10",
                 reply=Words(
                     en="you trust waiting too much. For each line ask: while it waits, who takes the transform off the network? And is it ever going to come?",
                     ko="기다림을 너무 믿고 있습니다. 줄마다 물어보십시오. 기다리는 동안 변환은 누가 받습니까? 그리고 오기는 합니까?")),
            Twin("only subscriptions block", waits(c="works"), misconception="M10",
                 reply=Words(
                     en="a timer's callback runs in the same thread as every other callback.",
                     ko="타이머 콜백도 다른 모든 콜백과 같은 스레드에서 실행됩니다.")),
            Twin("threads cannot help", waits(b="waits in vain", h="waits in vain"), misconception="M10",
                 reply=Words(
                     en="waiting in a callback is not bad as such. Where another thread may call the listener meanwhile, it works.",
                     ko="콜백에서 기다리는 것 자체가 나쁜 것은 아닙니다. 그동안 다른 스레드가 수신기를 부를 수 있으면 통합니다.")),
            Twin("a timeout never ends", waits(**dict.fromkeys("acfg", "waits for ever")), misconception="M10",
                 reply=Words(
                     en="a wait with `timeout=0.3 s` is over after 0.3 s, whatever happens. Which line has no timeout at all?",
                     ko="`timeout=0.3 s`인 기다림은 무슨 일이 있어도 0.3초 뒤에 끝납니다. timeout이 아예 없는 줄은 어느 것입니까?")),
            Twin("a promise blocks", waits(d="waits in vain"), misconception="M10",
                 reply=Words(
                     en="`wait_for_transform_async` returns at once, so the one thread is free again to take in the transform.",
                     ko="`wait_for_transform_async`는 바로 돌아오므로, 하나뿐인 스레드도 다시 변환을 받을 수 있습니다.")),
            Twin("promises expire", waits(e="waits in vain"), misconception="M10",
                 reply=Words(
                     en="a promise of `wait_for_transform_async` has no timeout. What becomes of one that can never be kept?",
                     ko="`wait_for_transform_async`의 약속에는 timeout이 없습니다. 결코 지켜질 수 없는 약속은 어떻게 됩니까?")),
        ),
        hints=(
            Words(en="Two questions for each line: who takes in transforms meanwhile, and will the right one ever come?",
                  ko="줄마다 두 가지를 물으십시오. 그동안 변환은 누가 받습니까? 맞는 변환이 언젠가 오기는 합니까?"),
            Words(en="`rclpy.spin(node)` is one thread. Nobody spins at all in one of the lines.",
                  ko="`rclpy.spin(node)`는 스레드 하나입니다. 아무도 spin하지 않는 줄도 있습니다."),
            Words(en="In two lines the right transform does not come in time whatever the threads: one has a timeout and gives up, the other is a promise and does not.",
                  ko="두 줄에서는 스레드가 몇 개든 맞는 변환이 제때 오지 않습니다. 하나는 timeout이 있어 포기하고, 다른 하나는 약속이라 포기하지 않습니다."),
        ),
        cures=("M10",),
    ),
    Task(
        id="E9.7", kind="N", points=2,
        title=Words(en="The smallest wait that always succeeds", ko="언제나 성공하는 가장 짧은 기다림"),
        answer="wait_s",
        form=Number("s", tolerance=0.0005),
        given=two_edges, variants=5,
        twins=(
            Twin("period forgotten", lambda g: wait_of(g, periods=0.0),
                 reply=Words(
                     en="with this wait it succeeds sometimes. In the worst case the transform you need is stamped a whole period after the scan.",
                     ko="이 시간으로는 가끔만 성공합니다. 최악의 경우 필요한 변환의 시각은 스캔보다 한 주기 뒤입니다.")),
            Twin("half a period", lambda g: wait_of(g, periods=0.5),
                 reply=Words(
                     en="half a period is the average. Asked for is a wait that always succeeds.",
                     ko="반 주기는 평균입니다. 필요한 것은 언제나 성공하는 시간입니다.")),
            Twin("jitter forgotten", lambda g: wait_of(g, jitter=0.0),
                 reply=Words(
                     en="this is enough on a quiet day. By how much may a transform be later than its delay?",
                     ko="조용한 날에는 충분합니다. 변환은 정해진 지연보다 얼마나 더 늦을 수 있습니까?")),
            Twin("scan's delay forgotten", lambda g: wait_of(g, scan=0.0),
                 reply=Words(
                     en="your wait is longer than it need be. While the scan was under way, time had already passed.",
                     ko="필요보다 길게 기다립니다. 스캔이 오는 동안 이미 시간이 흘렀습니다.")),
            Twin("scan's delay added", lambda g: wait_of(g, scan=-1.0),
                 reply=Words(
                     en="the wait is reckoned from the scan's arrival. Does the time that the scan was under way make it longer, or shorter?",
                     ko="기다림은 스캔이 도착한 때부터 잽니다. 스캔이 오는 데 걸린 시간은 기다림을 늘립니까, 줄입니까?")),
            Twin("quick edge", lambda g: wait_of(g, combine=min),
                 reply=Words(
                     en="that is the edge that comes first. A lookup needs all of them.",
                     ko="먼저 오는 연결로 계산했습니다. 조회에는 모든 연결이 필요합니다.")),
            Twin("added up", lambda g: wait_of(g, combine=sum),
                 reply=Words(
                     en="the two edges do not wait for one another: their messages travel at the same time.",
                     ko="두 연결은 서로를 기다리지 않습니다. 메시지는 동시에 옵니다.")),
            Twin("a round second", 1.0, misconception="M10",
                 reply=Words(
                     en="one second is a habit, not a result: it is longer than any of these numbers asks for, and it hides a clock that is wrong. Work it out.",
                     ko="1초는 습관이지 계산한 값이 아닙니다. 이 숫자들에 필요한 것보다 길고, 틀린 시계를 가립니다. 계산해 보십시오.")),
        ),
        hints=(
            Words(en="Work out for each edge when, at the latest, the first sample at or after the scan's stamp has arrived.",
                  ko="연결마다 스캔 시각과 같거나 뒤인 첫 표본이 늦어도 언제 도착하는지 계산하십시오."),
            Words(en="Period, delay and jitter each make it later. What makes your wait shorter?",
                  ko="주기, 지연, 지터는 모두 늦어지게 합니다. 기다림을 줄여 주는 것은 무엇입니까?"),
            Words(en="(1 / rate + delay + jitter) for each edge; the later of the two counts; the scan's own delay has already passed.",
                  ko="연결마다 (1 / 주파수 + 지연 + 지터)를 구하고, 둘 중 늦은 쪽을 씁니다. 스캔 자신의 지연은 이미 지나갔습니다."),
        ),
        cures=("M10",),
    ),
)  # fmt: skip
