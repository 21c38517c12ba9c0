"""What `check` replies to whole answers of chapters 5 to 8: what is wrong with them, and nothing untrue."""

from __future__ import annotations

import pytest

from .whole_answers import mistakes_of

# -- chapter 8 ------------------------------------------------------------------------

BETWEEN = """
from tf2_ros import ExtrapolationException

def interpolate(stamp_s, before, after):
    (t0, x0, y0, a0), (t1, x1, y1, a1) = before, after
    if stamp_s < t0:
        raise ExtrapolationException("too early")
    if stamp_s > t1:
        raise ExtrapolationException("too late")
    u = (stamp_s - t0) / (t1 - t0)
    turn = a1 - a0
    if turn > math.pi:
        turn -= math.tau
    if turn < -math.pi:
        turn += math.tau
    return {"position": (x0 + u * (x1 - x0), y0 + u * (y1 - y0)), "yaw": a0 + u * turn}
"""
LATE = '    if stamp_s > t1:\n        raise ExtrapolationException("too late")\n'
ABOVE = "    if turn > math.pi:\n        turn -= math.tau\n"
BELOW = "    if turn < -math.pi:\n        turn += math.tau\n"


@pytest.mark.parametrize(
    ("changes", "mistakes"),
    [
        ({}, []),
        ({"turn -= math.tau": "turn -= math.pi", "turn += math.tau": "turn += math.pi"}, ["what is left over of pi"]),
        ({"(stamp_s - t0) / (t1 - t0)": "stamp_s - t0 / (t1 - t0)"}, ["no brackets"]),
        ({ABOVE: "", BELOW: "", "a0 + u * turn": "math.degrees(a0 + u * turn)"}, ["the long way", "unit degrees"]),
        ({LATE: "", ABOVE: "", BELOW: ""}, ["guesses after", "the long way"]),
        ({"u = (stamp_s - t0) / (t1 - t0)": "u = ((stamp_s - t0) / (t1 - t0)) ** 2"}, ["ratio squared"]),
        ({"a0 + u * turn": "a0 + u * u * turn"}, ["ratio squared"]),
        (
            {"x0 + u * (x1 - x0), y0": "x0 + (stamp_s - t0) * (x1 - x0), y0", " u * (y1": " (stamp_s - t0) * (y1"},
            ["seconds for a ratio"],
        ),
        ({ABOVE: "", BELOW: "", "turn = a1 - a0": "turn = (a1 - a0 + math.pi) % math.tau"}, ["half a turn on"]),
        ({"(t0, x0, y0, a0), (t1, x1, y1, a1)": "(t0, a0, x0, y0), (t1, a1, x1, y1)"}, ["yaw before x"]),
    ],
)
def test_between_two_samples(changes, mistakes):
    source = BETWEEN
    marks = {old: f"<{number}>" for number, old in enumerate(changes)}  # one may hold what another is replaced by
    for old, mark in marks.items():
        assert source.count(old) == 1
        source = source.replace(old, mark)
    for old, new in changes.items():
        source = source.replace(marks[old], new)
    assert mistakes_of("E8.2", source) == mistakes


ON_THE_MAP = """
from tf2_geometry_msgs import do_transform_point
from tf2_ros import TransformException

def point_to_map(buffer, message, now):
    stamp = message.header.stamp
    return do_transform_point(message, buffer.lookup_transform("map", {source}, {time}))
"""
OWN, AT = "message.header.frame_id", "Time.from_msg(stamp)"


@pytest.mark.parametrize("result", ["message", "do_transform_point(message, transform) and message"])
def test_what_was_moved_and_not_kept_is_told_so(result):
    source = ON_THE_MAP.replace("return do_transform_point(message, buffer", "transform = buffer").rstrip().rstrip(")")
    source = source.format(source=OWN, time=AT) + f")\n    return {result}\n"
    assert mistakes_of("E8.3", source) == ["nothing moved"]


def test_a_refusal_that_is_swallowed_is_named_though_most_lookups_are_refused():
    lookup = f'    try:\n        buffer.lookup_transform("map", {OWN}, stamp)\n    except TransformException:\n'
    source = ON_THE_MAP.format(source=OWN, time="stamp").replace(
        "    return", f"{lookup}        return None\n    return"
    )
    assert mistakes_of("E8.3", source) == ["swallows the refusal"]


@pytest.mark.parametrize(
    ("source", "time", "mistakes"),
    [
        (OWN, AT, []),
        (OWN, "Time(seconds=stamp.sec)", ["sec alone"]),
        (OWN, "now if buffer.can_transform('map', message.header.frame_id, now) else Time()",
         ["now", "falls back on latest"]),
    ],
)  # fmt: skip
def test_a_point_onto_the_map(source, time, mistakes):
    assert mistakes_of("E8.3", ON_THE_MAP.format(source=source, time=time)) == mistakes


def test_a_point_left_in_odom_and_called_map_is_told_apart_from_one_that_says_odom():
    left = ON_THE_MAP.format(source=OWN, time=AT).replace('"map"', '"odom"')
    assert mistakes_of("E8.3", left) == ["left in odom"]
    called = left.replace("return do", "moved = do") + '    moved.header.frame_id = "map"\n    return moved\n'
    assert mistakes_of("E8.3", called) == ["odom called map"]


@pytest.mark.parametrize(("of_map", "of_the_rest", "mistake"), [("now", AT, "map of now"), (AT, "now", "robot of now")])
def test_two_moments_on_one_way_are_told_apart(of_map, of_the_rest, mistake):
    lookup = f'full("map", {of_map}, {OWN}, {of_the_rest}, "odom")'
    source = ON_THE_MAP.replace('("map", {source}, {time})', f"_{lookup}")
    assert mistake in mistakes_of("E8.3", source)
