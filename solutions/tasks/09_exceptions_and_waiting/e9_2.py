"""E9.2: Classify an exception."""

from __future__ import annotations

from tflab.core import seconds
from tflab.ros.time import Time
from tflab.workbook.tasks import Choice, Draws, define_task

from .draws import kind_of, make_buffer, refusal_of


def draw_queries(rng: Draws) -> list[tuple]:
    """Draw one lookup of each kind, and three that have several faults at once."""
    t = round(float(rng.uniform(20.0, 60.0)), 1)

    def at(low: float, high: float) -> Time:
        return Time(nanoseconds=seconds(round(t + float(rng.uniform(low, high)), 3)))

    drawn = [
        ("map", "laser_frame", at(1.1, 3.9)),
        ("map", "laser_frame", at(4.05, 4.45)),
        ("map", "laser_frame", Time(nanoseconds=seconds(round(t + 4.01, 3)))),  # a hundredth too late
        ("map", "laser_frame", at(0.1, 0.9)),
        ("map", "camera_link", at(1.1, 3.9)),
        ("map", "Laser_frame", at(1.1, 3.9)),
        ("/map", "laser_frame", at(1.1, 3.9)),
        ("base_link", "tool0", at(2.2, 3.9)),
        ("map", "laser_frame", Time()),
        ("camera_link", "odom", at(20.0, 40.0)),  # no path either
        ("map", "gripper", at(20.0, 40.0)),  # an unknown name, and too late
        ("gripper", "/laser_frame", at(1.1, 3.9)),  # two names that are wrong, each in its way
        ("map", "", at(1.1, 3.9)),
        ("odom", "laser_frame", at(4.05, 4.45)),  # too late for map alone
        ("tool0", "laser_frame", at(2.2, 3.9)),
        ("map", "left/future_lamp", at(1.1, 3.9)),
        ("map", "left/future_lamp", at(0.1, 0.9)),  # into the past, whatever the name says
        ("map", "right/past_lamp", at(4.05, 4.45)),  # into the future
    ]
    another = make_buffer(t + 100.0), "map", "laser_frame", at(101.1, 103.9)
    return [*((make_buffer(t), *question) for question in drawn), another]


def classify(
    buffer, target, source, stamp, *, ends="as given", moment="stamp", texts="three", classes="each its own",
    let_through="none",
):  # fmt: skip
    """Return the kind of an exception, step by step; other arguments are mistakes."""
    target, source = (source, target) if ends == "swapped" else (target, source)
    written = {"without slashes": lambda name: name.lstrip("/"), "in small letters": str.lower}.get(ends, str)
    target, source = written(target), written(source)
    moments = {"latest": Time(), "whole seconds": Time(nanoseconds=stamp.nanoseconds // 10**9 * 10**9)}
    refused = refusal_of(buffer, target, source, moments.get(moment, stamp))
    kind = kind_of(refused)
    extrapolations = ("future", "past", "one sample")
    if refused is not None and let_through in (kind, "extrapolation" if kind in extrapolations else kind, "any"):
        raise refused
    if moment == "no path at the latest" and refusal_of(buffer, target, source, Time()) is not None:
        return "connectivity"
    if moment == "path first":
        first = kind_of(refusal_of(buffer, target, source, Time()))
        kind = first if first in ("connectivity", "lookup") else kind
    if texts == "by the newest" and kind in extrapolations:
        newest = buffer.get_latest_common_time(target, source).nanoseconds
        kind = "future" if stamp.nanoseconds > newest else "past"
    said = {
        "turned round": {"past": "future", "future": "past"},
        "two": {"one sample": "past"},
        "two, and an answer": {"one sample": "ok"},
        "two, and future": {"one sample": "future"},
        "all future": {"past": "future", "one sample": "future"},
        "all past": {"future": "past", "one sample": "past"},
        "none read": dict.fromkeys(extrapolations, "one sample"),
    }.get(texts, {})
    kind = said.get(kind, kind)
    odd = {"a slash is a name": lambda name: name.startswith("/"), "nothing is a name": lambda name: not name}
    if kind == "ok" or classes == "each its own" or not any(map(odd.get(classes, bool), (target, source))):
        return kind
    return {
        "base first": "invalid argument",
        "by the text": kind if kind in extrapolations else "one sample",
        "one word": "lookup",
        "one word: future": "future",
        "one word: past": "past",
        "one word: connectivity": "connectivity",
        "exchanged": {"lookup": "connectivity", "connectivity": "lookup"}.get(kind, kind),
        "names alone": {"connectivity": "lookup"}.get(kind, kind),
        "no question is a name": {"invalid argument": "lookup"}.get(kind, kind),
        "a slash is a name": {"invalid argument": "lookup"}.get(kind, kind),
        "nothing is a name": {"invalid argument": "lookup"}.get(kind, kind),
    }[classes]


TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="classify",
    form=Choice(("ok", "invalid argument", "lookup", "connectivity", "future", "past", "one sample")),
    inputs=draw_queries,
    variants=3,
    model=classify,
)
