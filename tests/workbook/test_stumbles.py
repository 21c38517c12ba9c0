"""What one of Python's own errors means: a tip where it is certain, none where it is not."""

from __future__ import annotations

import math

import pytest

from tflab.core import BufferCore, StampedTransform, Transform
from tflab.ros.messages import checks as field_checks
from tflab.ros.messages import geometry_msgs
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.time import ClockType, Time
from tflab.workbook.answers.forms import Number
from tflab.workbook.answers.values import outcome_of
from tflab.workbook.diagnosis.failure import Failure
from tflab.workbook.diagnosis.python_errors import python_error_hint
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.tasks.case_types import Case

from .small_chapter import bare

POSE = Transform((1.0, 0.0, 0.0))


def in_a_buffer(*args):
    buffer = BufferCore()
    for stamp_ns in (4, 9):
        buffer.set_transform(StampedTransform("map", "base", stamp_ns, POSE), "")
        buffer.set_transform(StampedTransform("hall", "lamp", stamp_ns, POSE), "")
    return buffer.lookup_transform(*args)


def looked_up():
    return in_a_buffer("map", "base", 5)


STUMBLES = [
    (lambda: Time(clock_type=ClockType.ROS_TIME) - Time(), "nanoseconds"),
    (lambda: POSE @ POSE.inverse, "not called"),
    (lambda: POSE - POSE, "`@` composes"),
    (lambda: [1.0] - [2.0], "one by one"),
    (lambda: None + 1, "is None"),
    (lambda: {"x": 1.0}.x, "square brackets"),
    (lambda: "2" + 1, "float(text)"),
    (lambda: int("5.0"), "meets a decimal point"),
    (lambda: Time().sec, "two kinds of Time"),
    (lambda: {["base_link"]}, "`.update(…)`"),
    (lambda: int("5", basis=2), "of that name"),
    (lambda: {}.append(1), "with a key"),
    (lambda: Time().to_msg() - Time().to_msg(), "cannot subtract"),
    (lambda: Time() + Time(), "cannot add two times"),
    (lambda: looked_up().inverse(), "`.transform`"),
    (lambda: geometry_msgs.TransformStamped().inverse(), "only holds numbers"),
    (lambda: geometry_msgs.TransformStamped().translation, "one level down"),
    (lambda: geometry_msgs.TransformStamped().frame, "three parts"),
    (lambda: geometry_msgs.PointStamped().stamp, "header"),
    (lambda: geometry_msgs.PointStamped().header.child_frame_id, "not in the header"),
    (lambda: POSE.yaw, "`.rpy()`"),
    (lambda: POSE.apply(geometry_msgs.Point()), "not an object"),
    (lambda: POSE.apply(1.0, 2.0, 3.0), "takes one point"),
    (lambda: POSE.translation.x, "indices, not names"),
    (lambda: POSE.rpy().yaw, "in this order"),
    (lambda: POSE.translation(), "Brackets after a value"),
    (lambda: Time().to_msg().to_msg(), "already"),
    (lambda: Time() - 5, "not a number"),
    (lambda: (Time() - Time()).sec, "a Duration"),
    (lambda: Time(5), "`Time(nanoseconds="),
    (lambda: (5).nanoseconds, "plain number"),
    (lambda: Buffer().lookup_transform("map", "base", Time(), timeout=0.2), "a Duration"),
    (lambda: Buffer().lookup_transform_full("map", Time(), "base", Time()), "five arguments"),
    (lambda: Buffer().lookup_transform("map", "base", "odom"), "expects a time"),
    (lambda: Buffer().transform(geometry_msgs.Point(), "map"), "with a header"),
    (lambda: Buffer().transform("map", geometry_msgs.PointStamped()), "the message first"),
    (lambda: geometry_msgs.PointStamped.header.frame_id, "Add brackets to make an object"),
    (lambda: len(5), "no members"),
    (lambda: [{"x": 1}].__getitem__("x"), "indices, not names"),
    (lambda: [].add(1), "`.append("),
    (lambda: math.sin((1.0, 2.0)), "single numbers"),
    (lambda: math.asin(1.5), "from -1 to 1"),
    (lambda: max([{"x": 1}, {"x": 2}]), "cannot be compared"),
    (lambda: math.radian(90), "spelling"),
    (lambda: in_a_buffer("/map", "base", 5), "without the slash"),
    (lambda: in_a_buffer("", "base", 5), "without a name"),
    (lambda: in_a_buffer("map", "base", 50), "later than all"),
    (lambda: in_a_buffer("map", "base", 2), "earlier than all"),
    (lambda: in_a_buffer("map", "lamp", 5), "no path connects"),
    (lambda: in_a_buffer("map", "base"), "three arguments"),
]


@pytest.mark.parametrize(("stumble", "tip"), STUMBLES)
def test_an_error_that_python_raises_here_gets_its_tip(stumble, tip):
    with pytest.raises(Exception) as raised:
        stumble()
    assert tip in python_error_hint(raised.type.__name__, str(raised.value)).en


@pytest.mark.parametrize(
    ("field", "value", "tip"),
    [
        ("stamp", Time(seconds=1), "`.to_msg()`"),
        ("frame_id", 5, "takes a text"),
        ("stamp.sec", 5_000_000_000, "whole seconds"),
        ("stamp.sec", 5.5, "whole seconds"),
        ("stamp.nanosec", 0.5, "`int(…)`"),
    ],
)
def test_a_field_that_is_filled_wrongly_says_what_it_takes(monkeypatch, field, value, tip):
    monkeypatch.setattr(field_checks, "on", True)
    *owners, name = field.split(".")
    header = geometry_msgs.PointStamped().header
    with pytest.raises(AssertionError) as raised:
        setattr(header.stamp if owners else header, name, value)
    assert tip in python_error_hint("AssertionError", str(raised.value)).en


def test_an_error_of_ones_own_gets_none():
    assert python_error_hint("ValueError", "the robot is tired").en == ""
    assert python_error_hint("Tired", "KeyError").en == ""
    assert python_error_hint("AttributeError", "'Robot' object has no attribute 'x'").en == ""
    assert python_error_hint("AttributeError", "type object 'Transform' has no attribute 'from_ryp'").en == ""
    assert python_error_hint("IndexError", "only integers, slices (`:`) and integer arrays are valid indices").en == ""
    assert python_error_hint("TypeError", "unsupported operand" * 100_000).en == ""  # at once


def test_the_verdict_on_a_function_that_stops_carries_the_tip():
    case = Case([8.0], 1.0, {})
    task, variant = bare(Number("m"), case, is_function=True)
    verdict = judge_outcomes(task, variant, [outcome_of(lambda given: [given] + 1.0, case.args)])
    assert verdict.failure is Failure.RAISES and "one by one" in verdict.detail["tip"].en
