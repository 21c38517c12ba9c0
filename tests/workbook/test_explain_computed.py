"""How `check` explains what a function computes, and what the names in an answer hold."""

from __future__ import annotations

import pytest

from tflab.core import Transform
from tflab.workbook.answers.forms import Command, Name, Number, Parts, Pose, Tree, Vector
from tflab.workbook.answers.values import raised, to_plain
from tflab.workbook.diagnosis.python_errors import python_error_hint
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.tasks.case_types import Case

from .small_chapter import bare
from .test_explain import judged, words

POSES = [Transform.from_rpy(0.1 * n, 0.2, 0.3 + n, translation=(1.0 + n, 2.3 - n, 0.4)) for n in range(1, 6)]


def called(form, rows):
    """Return the verdict on a function, where `rows` are (arguments, expected, outcome)."""
    cases = [Case(to_plain(list(args)), to_plain(want), {}) for args, want, _ in rows]
    task, variant = bare(form, *cases, is_function=True)
    return judge_outcomes(task, variant, [to_plain(outcome) for *_, outcome in rows])


def test_step_and_turn_of_a_pose_are_looked_at_each_by_itself():
    here, there = POSES[0], POSES[1]
    half = Transform(here.translation, there.rotation)
    verdict = judged(Pose(), here, {"turn kept": half}, Transform((9.0, 8.0, 7.7), there.rotation))
    assert list(verdict.mistakes) == ["turn kept"] and '"rotation": turn kept' in verdict.said.en
    assert '"translation": not right yet' in verdict.said.en


def test_a_mistake_in_all_calls_that_have_an_answer_is_named_and_one_in_some_is_not():
    cases = [Case([n], float(n), {"late": n + 5.0}) for n in range(1, 4)]
    cases.append(Case([9], raised(LookupError("no")), {"late": 14.0}))
    task, variant = bare(Number("m"), *cases, is_function=True)
    task = task._replace(feedback={"late": words("late")})
    outcomes = [6.0, 7.0, 8.0, raised(LookupError("no"))]
    assert judge_outcomes(task, variant, outcomes).said.en == "late"
    assert judge_outcomes(task, variant, [1.0, *outcomes[1:]]).mistakes == {}


def test_names_are_told_what_is_to_be_seen_in_them_and_nothing_where_that_is_not_all():
    wanted = ["r/odom", "odom", "r/arm/tool", "r/base"]
    rows = [
        ([n, want], want, given)
        for n, (want, given) in enumerate(zip(wanted, ["/r/odom", "/odom", "r//arm/tool", "r/base"], strict=True))
    ]
    said = called(Name(), rows).said.en
    assert said == (
        "in 2 of the 3 wrong names: a slash in front, `/r/odom`; "
        "in 1 of the 3 wrong names: two slashes in a row, `r//arm/tool`."
    )
    assert called(Name(), [*rows[:3], ([3, "r/base"], "r/base", "lamp")]).mistakes == {}


@pytest.mark.parametrize(
    ("text", "is_missing"),
    [
        ("{prefix}/odom", True),
        ("{t.x/100}", True),
        ("{yaw:.3f}", True),
        ("{data:5}", False),  # of YAML
        ("/${robot}/tf", False),  # of a shell
        ('pub /a std_msgs/msg/Int32 "{data: 1}"', False),
    ],
)
def test_braces_that_are_left_in_a_text_are_told_as_an_f_that_is_missing(text, is_missing):
    mistakes = judged(Command(), "ros2 topic hz /tf", {}, f"ros2 topic hz {text}").mistakes
    assert ("nothing filled in" in mistakes) is is_missing


def test_a_half_is_rounded_up_or_down_and_is_rounded_either_way():
    for number in (0.8, 0.9):
        assert list(judged(Vector(3, "m"), (2.76, 0.64, 0.85), {}, (2.8, 0.6, number)).mistakes) == ["rounded"]
    assert judged(Vector(3, "m"), (2.76, 0.64, 0.85), {}, (2.8, 0.6, 0.7)).mistakes == {}


def test_a_field_of_a_message_says_what_it_takes():
    for text, tip in (
        ("The 'translation' field must be a sub message of type 'Vector3'", "one by one"),
        ("The 'x' field must be of type 'float'", "`float(…)`"),
    ):
        assert tip in python_error_hint("AssertionError", text).en


def test_none_for_a_word_and_dicts_inside_a_tree_are_told_how_they_are_written():
    verdict = judged(Parts({"a": Name(), "b": Name()}), {"a": "x", "b": "y"}, {}, {"a": None, "b": "y"})
    assert "in quotes" in verdict.detail["tip"].en
    nested = {"red": {"red/odom": "map"}, "blue": {"blue/odom": "map"}}
    assert "into one dict" in judged(Tree(), {"red/odom": "map", "blue/odom": "map"}, {}, nested).detail["tip"].en


def test_a_sign_in_one_part_alone_is_told_before_two_mistakes_that_meet_there():
    form = Parts({"x": Number("m"), "y": Number("m")})
    right, wrong = {"x": 1.0, "y": 2.0}, {"x": 1.0, "y": -2.0}
    by_mistake = {"late": {"x": 3.0, "y": 2.0}, "far": {"x": 5.0, "y": 7.0}, "late + far": wrong}
    assert judged(form, right, by_mistake, wrong).said.en == '"y": the size is right, the sign is not.'
    both = {"x": 4.123, "y": -2.345}
    assert list(judged(form, right, by_mistake | {"late + far": both}, both).mistakes) == ["late", "far"]
