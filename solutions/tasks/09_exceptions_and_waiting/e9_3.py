"""E9.3: From exception to action."""

from __future__ import annotations

import math
import re
from functools import partial

from tflab.core import TransformException, seconds
from tflab.ros.messages import geometry_msgs
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.time import Time
from tflab.workbook.tasks import Choice, Draws, define_task

from .draws import kind_of, make_buffer, refusal_of

LIMIT_S = 0.2

ACTIONS = ("use", "wait", "check clocks", "drop", "check names", "check tree", "fix message")


def point_in(frame: str, time_s: float) -> geometry_msgs.PointStamped:
    """Return a point with this header."""
    point = geometry_msgs.PointStamped()
    point.header.frame_id = frame
    point.header.stamp = Time(nanoseconds=seconds(time_s)).to_msg()
    point.point.x = 2.0
    return point


def draw_messages(rng: Draws) -> list[tuple]:
    """Draw messages for each action: gaps around the limit, a misleading text, a slow edge, a missing map."""
    t = 0.0
    while round(t + 4.2, 1) - round(t + 4.0, 1) <= LIMIT_S:  # until floats miss the limit
        t = round(float(rng.uniform(20.0, 60.0)), 1)
    drawn = [
        ("laser_frame", rng.uniform(1.2, 3.8)),
        ("left/future_lamp", rng.uniform(1.2, 3.8)),
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
    rows = [(make_buffer(t), point_in(frame, round(t + float(later), 3))) for frame, later in drawn]
    for beside_ns in (0, -1, 1, -1_000_000, 1_000_000):  # at the limit of 0.2 s, just past it, and a little further
        at_the_limit = point_in("laser_frame", t + 4.0)
        stamp = Time(nanoseconds=seconds(t + 4.0) + 200_000_000 + beside_ns)
        at_the_limit.header.stamp = stamp.to_msg()
        rows.append((make_buffer(t), at_the_limit))
    rows += [(make_buffer(t), point_in(frame, t + 30.0)) for frame in ("camera_link", "Laser_frame")]  # two faults
    start = math.floor(t) + 0.9  # a second begins between the newest transform and this message
    rows.append((make_buffer(start), point_in("laser_frame", start + 4.0 + round(float(rng.uniform(0.17, 0.195)), 3))))
    slow = point_in("laser_frame", t + 4.0 + round(float(rng.uniform(0.02, 0.1)), 3))
    rows.append((make_buffer(t, wheels_s=3.4), slow))
    lost = point_in("/laser_frame", round(t + float(rng.uniform(1.2, 3.8)), 3))
    rows.append((make_buffer(t, is_localized=False), lost))
    for gap_ns in (100, 100_000, 100_000_000_000):  # what a bound in another unit lets wait
        point = point_in("laser_frame", t + 4.0)
        point.header.stamp = Time(nanoseconds=seconds(t + 4.0) + gap_ns).to_msg()
        rows.append((make_buffer(t), point))
    return rows


def decide(
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
    """Return the action, step by step; other arguments are mistakes."""
    stamp = Time() if latest else Time.from_msg(message.header.stamp)
    written = {"without slashes": lambda name: name.lstrip("/"), "in small letters": str.lower}.get(spelt, str)
    frame = written(message.header.frame_id)
    ends = (target, frame)
    error = refusal_of(buffer, *(reversed(ends) if swapped else ends), stamp)
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


def always(buffer: Buffer, message: geometry_msgs.PointStamped, *, word: str) -> str:
    return "use" if decide(buffer, message) == "use" else word


def report_no_path(buffer: Buffer, message: geometry_msgs.PointStamped) -> str:
    at_the_latest = refusal_of(buffer, "map", message.header.frame_id, Time())
    return decide(buffer, message) if at_the_latest is None else "check tree"


def compare_gap_first(buffer: Buffer, message: geometry_msgs.PointStamped) -> str:
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
    return decide(buffer, message)


def decide_by_text(buffer: Buffer, message: geometry_msgs.PointStamped) -> str:
    word = decide(buffer, message)
    return "drop" if word in ("check names", "check tree", "fix message") else word


ANSWERS = {
    "texts alone": decide_by_text,
    "one action for every no": partial(always, word="drop"),
    "a wait for every no": partial(always, word="wait"),
    "every no: check names": partial(always, word="check names"),
    "every no: check tree": partial(always, word="check tree"),
    "every no: check clocks": partial(always, word="check clocks"),
    "gap before the lookup": compare_gap_first,
    "no answer at the latest is no path": report_no_path,
}

TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="decide",
    form=Choice(ACTIONS),
    inputs=draw_messages,
    variants=3,
    model=decide,
    answers=ANSWERS,
)
