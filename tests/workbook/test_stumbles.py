"""What one of Python's own errors means: a tip where it is sure, none where it is not."""

from __future__ import annotations

import re

import pytest

from tflab.core import ConnectivityException, Transform
from tflab.ros.clock_type import ClockType
from tflab.ros.messages import checks as field_checks
from tflab.ros.messages import geometry_msgs
from tflab.ros.time import Time
from tflab.workbook.answers.forms import Number
from tflab.workbook.answers.values import outcome_of
from tflab.workbook.mistakes.stumbles import TIPS, tip_for
from tflab.workbook.tasks.case import Case
from tflab.workbook.verdicts.mistake import Mistake
from tflab.workbook.verdicts.verdict import judge_outcomes

from .small_chapter import bare

POSE = Transform((1.0, 0.0, 0.0))


def stamped_with_a_time():
    point = geometry_msgs.PointStamped()
    point.header.stamp = Time(seconds=1)


def raised_by_oneself():
    raise ConnectivityException("no way")


STUMBLES = [
    (lambda: Time(clock_type=ClockType.ROS_TIME) - Time(), "nanoseconds"),
    (lambda: POSE @ POSE.inverse, "not called"),
    (lambda: POSE.rpy[2], "not called"),
    (lambda: POSE - POSE, "`@` joins"),
    (lambda: [1.0] - [2.0], "one by one"),
    (lambda: (1.0, 2.0) * 0.5, "one by one"),
    (lambda: None + 1, "is None"),
    (lambda: {"x": 1.0}.x, "square brackets"),
    (lambda: {}["joint_b"], ".get("),
    (lambda: [][0], "short, or empty"),
    (lambda: "2" + 1, "float(text)"),
    (lambda: int("5.0"), "a point where a whole number"),
    (lambda: int("5", basis=2), "of that name"),
    (lambda: max([]), "short, or empty"),
    (lambda: Time().sec, "two kinds of Time"),
    (lambda: {["base_link"]}, "`.update(…)`"),
    (lambda: 1 / 0.0, "is 0"),
    (raised_by_oneself, "a `raise` of your own"),
    (lambda: undefined_name, "misspelt"),  # noqa: F821
]


@pytest.mark.parametrize(("stumble", "tip"), STUMBLES)
def test_an_error_that_python_raises_here_gets_its_tip(stumble, tip):
    with pytest.raises(Exception) as raised:
        stumble()
    assert tip in tip_for(raised.type.__name__, str(raised.value)).en


def test_a_message_that_gets_a_time_says_how_a_time_becomes_a_stamp(monkeypatch):
    monkeypatch.setattr(field_checks, "on", True)
    with pytest.raises(AssertionError) as raised:
        stamped_with_a_time()
    assert "`.to_msg()`" in tip_for("AssertionError", str(raised.value)).en


def test_an_error_of_ones_own_gets_none():
    assert tip_for("ValueError", "the robot is tired").en == ""
    assert tip_for("Tired", "KeyError").en == ""
    assert tip_for("IndexError", "only integers, slices (`:`) and integer arrays are valid indices").en == ""


def test_however_long_an_error_is_its_tip_is_there_at_once():
    assert tip_for("TypeError", "unsupported operand" * 100_000).en == ""


def test_each_tip_is_said_in_both_languages():
    for _, words in TIPS:
        assert re.search("[가-힣]", words.ko) and not re.search("[가-힣]", words.en)


def test_the_verdict_on_a_function_that_stops_carries_the_tip():
    case = Case([8.0], 1.0, {})
    task, variant = bare(Number("m"), case, is_function=True)
    verdict = judge_outcomes(task, variant, [outcome_of(lambda given: {}[given], case.args)])
    assert verdict.mistake is Mistake.RAISES and ".get(" in verdict.detail["tip"].en
