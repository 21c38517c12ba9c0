"""How `check` explains two mistakes that stand beside each other: in other calls, in other places."""

from __future__ import annotations

import pytest

from tflab.core import Transform
from tflab.ros.messages import geometry_msgs
from tflab.workbook.answers.forms import Choice, Command, Message, Name, Number, Parts, Quaternion, Sequence, Vector
from tflab.workbook.answers.values import raised
from tflab.workbook.diagnosis.failure import Failure
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.tasks.case_types import Case

from .small_chapter import bare
from .test_explain import judged, words

STOPPED = raised(TypeError("no"))
MOUNT = "ros2 run tf2_ros static_transform_publisher"
ASKED = f"{MOUNT} --x 0.2 --y -0.1 --z 0.3 --yaw 0.5 --frame-id base_link --child-frame-id laser"


def test_a_function_that_stops_in_some_calls_hears_what_is_wrong_in_the_others_first():
    cases = [Case([place], float(place + 1), {"late": float(place + 1) if place < 3 else 9.0}) for place in range(4)]
    task, variant = bare(Number("m"), *cases, is_function=True)
    task = task._replace(feedback={"late": words("late")})
    verdict = judge_outcomes(task, variant, [-1.0, -2.0, -3.0, STOPPED])
    assert list(verdict.mistakes) == ["sign", "stops: TypeError"]
    assert "in 1 of the 4 calls" in verdict.said.en
    verdict = judge_outcomes(task, variant, [1.0, 2.0, 3.0, STOPPED])
    assert (verdict.failure, verdict.mistakes) == (Failure.RAISES, {})  # "late" would show only where it stops
    assert judge_outcomes(task, variant, [-1.0, 2.5, -3.0, STOPPED]).failure is not Failure.KNOWN


def test_each_member_of_a_list_of_choices_has_a_mistake_of_its_own():
    form = Parts({name: Sequence(Choice(("in", "out"))) for name in "ab"})
    right = {"a": ["in", "in", "in"], "b": ["out", "out", "out"]}
    by_mistake = {f"no {place}": right | {"a": ["in"] * place + ["out"] + ["in"] * (2 - place)} for place in range(3)}
    answer = right | {"a": ["out", "out", "out"]}
    verdict = judged(form, right, by_mistake, answer)
    assert list(verdict.mistakes) == ["no 0", "no 1", "no 2"]
    assert verdict.said.en == '"a[0]": no 0 "a[1]": no 1 "a[2]": no 2'


def test_a_whole_list_is_called_by_its_name_and_one_reply_is_given_once():
    form = Parts({name: Sequence(Choice(("in", "out"))) for name in "ab"})
    right = {"a": ["in", "out"], "b": ["out", "out"]}
    swapped = {"a": ["out", "in"], "b": ["in", "out"]}
    said = {"swapped": words("swapped", partly=True)}
    assert judged(form, right, {"swapped": swapped}, swapped | {"b": ["out", "out"]}, said).said.en == '"a": swapped'


@pytest.mark.parametrize(
    ("line", "name"),
    [
        (ASKED.replace("frame-id", "frame_id"), "static: underscores"),
        (ASKED.replace("0.5", "-0.5"), "inverse rotation"),
    ],
)
def test_what_is_wrong_with_a_mount_on_a_command_line_is_said_of_its_option_or_its_part(line, name):
    assert list(judged(Command(), ASKED, {}, line).mistakes) == [name]
    assert judged(Command(), ASKED, {}, ASKED).failure is None


@pytest.mark.parametrize(("answer", "fits"), [(0.3333333333, True), (0.333, True), (0.332, False), (0.3326667, False)])
def test_the_more_digits_a_number_has_the_closer_a_mistake_has_to_fit(answer, fits):
    form = Number("m", tolerance=0.002)
    verdict = judged(form, 0.47, {"one third": 1 / 3}, answer)
    assert (list(verdict.mistakes) == ["one third"]) is fits


@pytest.mark.parametrize("error", [ValueError("no way"), KeyError("map")])
def test_another_exception_than_the_one_asked_for_hides_no_other_mistake(error):
    wanted, other = raised(LookupError("no")), raised(error)
    cases = (Case([1], 1.0, {}), Case([2], 2.0, {}), Case([3], wanted, {}), Case([4], wanted, {}))
    task, variant = bare(Number("m"), *cases, is_function=True)
    verdict = judge_outcomes(task, variant, [-1.0, -2.0, other, other])
    assert list(verdict.mistakes) == ["sign", "another exception"]
    assert type(error).__name__ in verdict.said.en and type(error).__name__ in verdict.said.ko
    assert list(judge_outcomes(task, variant, [-1.0, -2.0, wanted, wanted]).mistakes) == ["sign"]
    assert "another exception" not in judge_outcomes(task, variant, [-1.0, -2.0, wanted, other]).mistakes
    assert judge_outcomes(task, variant, [1.0, 2.0, other, other]).mistakes == {}


POINT = Message("geometry_msgs/msg/PointStamped", ("header.frame_id", "point"))


@pytest.mark.parametrize(
    ("form", "right", "wrong", "tip"),
    [
        (Quaternion(), (0.0, 0.0, 0.0, 1.0), Transform(), "`.rotation`"),
        (Vector(3, "m"), (1.0, 0.0, 0.0), Transform((1.0, 0.0, 0.0)), "`.translation`"),
        (POINT, geometry_msgs.PointStamped(), geometry_msgs.Point(), "only its `.point`"),
        (POINT, geometry_msgs.PointStamped(), {"x": 1.0}, "`message = PointStamped()`"),
        (Sequence(Name()), ["a", "b"], {"a", "b"}, "A set has no order"),
        (Sequence(Name()), ["a", "b"], "a", "the task asks for a list"),
    ],
)
def test_an_answer_of_another_kind_hears_how_the_right_one_is_made_of_it(form, right, wrong, tip):
    verdict = judged(form, right, {}, wrong)
    assert verdict.failure is Failure.TYPE
    assert tip in verdict.detail["tip"].en


def test_an_answer_of_a_kind_of_which_nothing_can_be_made_hears_no_tip():
    for form, right, wrong in ((Quaternion(), (0.0, 0.0, 0.0, 1.0), None), (Sequence(Name()), ["a"], 5.0)):
        assert "tip" not in judged(form, right, {}, wrong).detail
