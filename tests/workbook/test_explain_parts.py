"""How `check` explains a wrong part beside the others, and words that are no options."""

from __future__ import annotations

import math

import pytest

from tflab.workbook.answers.forms import Choice, Message, Number, Parts
from tflab.workbook.answers.values import to_plain
from tflab.workbook.diagnosis.explanation import PartFound, merge_found
from tflab.workbook.diagnosis.failure import Failure
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.tasks import Text
from tflab.workbook.tasks.case_types import Case, Feedback

from .small_chapter import bare
from .test_explain import judged, judged_function

STAMP = Parts({"stamp_s": Number("s"), "speed": Number("m/s"), "turn": Number("rad/s")})
READ = {"stamp_s": 38.02, "speed": 0.62, "turn": 0.3571}
DECIMALS = {"stamp_s": 38.2, "speed": 0.55, "turn": 0.3137}
IN = {"zeros lost": Feedback(Text("Zeros.", "0입니다."), "", part="stamp_s")}


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        (
            DECIMALS | {"turn": math.degrees(0.3137)},
            '"turn": this would be right in degrees/s. The task asks for another unit.',
        ),
        (READ | {"stamp_s": 38.2, "turn": 0.3137}, '"turn": this is wrong only because "stamp_s" is wrong.'),
        (DECIMALS | {"turn": 0.41}, '"turn": not right yet'),
    ],
)
def test_a_part_that_follows_from_a_mistake_is_told_so_and_a_second_mistake_on_it_is_named(answer, said):
    verdict = judged(STAMP, READ, {"zeros lost": DECIMALS}, answer, IN)
    assert said in verdict.said.en


@pytest.mark.parametrize(
    ("answer", "tip"),
    [
        ({"a": "start it", "a do": "no driver"}, 'possible answers for "a do"'),
        ({"a": "no driver", "a do": "/dolly/tf"}, 'A node that subscribes to "/tf" does not receive it'),
        ({"a": "the moon", "a do": "start it"}, None),
    ],
)
def test_a_word_that_is_none_to_choose_from_is_told_where_it_would_be_one(answer, tip):
    form = Parts({"a": Choice(("no driver", "degrees")), "a do": Choice(("start it", "write radians", "/tf"))})
    verdict = judged(form, {"a": "degrees", "a do": "start it"}, {}, answer)
    assert verdict.failure is Failure.OPTION
    assert verdict.detail.get("tip") is None if tip is None else tip in verdict.detail["tip"].en


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (("ok", "future", "future", "future"), 'you never answer "past", "lookup"'),
        (("ok", "future", "future", "lookup"), 'you never answer "past"'),
        (("ok", "future", "future", "past"), 'wherever "past" is expected, your answer is "future"'),
    ],
)
def test_words_that_all_have_one_said_for_them_are_named_together(given, said):
    asked = ("ok", "past", "future", "lookup")
    assert said in judged_function(Choice(asked), list(zip(asked, given, strict=True))).said.en


def test_a_part_that_never_changes_is_told_so_and_one_that_does_is_not():
    form = Parts({"cause": Choice(("a", "b", "c")), "frame": Choice(("map", "odom", "none"))})
    asked = [("a", "map"), ("b", "odom"), ("c", "none"), ("a", "odom")]

    def verdict(*frames):
        return judged_function(form, [
            ({"cause": cause, "frame": frame}, {"cause": cause, "frame": said})
            for (cause, frame), said in zip(asked, frames, strict=True)
        ])  # fmt: skip

    assert 'this is "none" in every call' in verdict("none", "none", "none", "none").said.en
    assert "in every call" not in verdict("none", "none", "none", "map").said.en


def test_a_class_for_its_name_is_told_how_it_is_written():
    form = Parts({"placed": Number(tolerance=0.0), "first": Choice(("none", "LookupException"))})
    pairs = [({"placed": 1, "first": "none"}, {"placed": 1, "first": "none"}),
             ({"placed": 2, "first": "LookupException"}, {"placed": 2, "first": LookupError})]  # fmt: skip
    assert "`type(error).__name__`" in judged_function(form, pairs).said.en
    named = [pairs[0], (pairs[1][0], {"placed": 2, "first": "lookup"})]
    verdict = judged_function(form, named)
    assert verdict.said is None or "`type(error).__name__`" not in verdict.said.en


def test_a_mistake_that_stops_in_some_calls_is_named_in_a_part_where_the_others_show_it():
    form = Message("geometry_msgs/msg/Point", ("x", "y"))
    raised = {"raises": "ExtrapolationException", "text": ""}
    wants = [{"message": ["geometry_msgs/msg/Point", {"x": float(x), "y": 1.0}]} for x in (1, 2, 3)]
    gives = [{"message": ["geometry_msgs/msg/Point", {"x": x + 0.5, "y": 2.0}]} for x in (1, 2, 3)]
    halves = [{"message": ["geometry_msgs/msg/Point", {"x": x + 0.5, "y": 1.0}]} for x in (1, 2)]

    def verdict(last_of_the_mistake, last):
        rows = zip(wants, [*gives[:2], last_of_the_mistake], strict=True)
        task, variant = bare(form, *(Case([n], want, {"late": give}) for n, (want, give) in enumerate(rows)),
                             is_function=True)  # fmt: skip
        task = task._replace(feedback={"late": Feedback(Text("Late.", "늦습니다."), "", partly=True)})
        return judge_outcomes(task, variant, [*halves, last])

    assert list(verdict(raised, raised).mistakes) == ["late"]
    assert verdict(gives[2], raised).mistakes == {}


def test_of_many_causes_the_first_are_told_and_the_rest_comes_later():
    def reply(count):
        texts = [(name, Text(f"Cause {name}.", f"Cause {name}.")) for name in "abcdefg"[:count]]
        return merge_found([PartFound.of(name, said, name) for name, said in texts], {}, "abcdefgh").said

    assert reply(7).en.endswith('"d": Cause d. "e", "f", "g": not right yet either. Fix the others first.')
    assert reply(5).en.endswith('"e": Cause e.')


def test_a_text_is_no_switch():
    verdict = judged(Parts({"a": Choice(("True", "False"))}), {"a": True}, {}, {"a": "True"})
    assert verdict.failure is Failure.TYPE


@pytest.mark.parametrize(("answer", "part"), [("tree", '"a"'), ("clock", '"b"'), ("wind", None), (3, None)])
def test_a_word_for_one_part_alone_is_told_for_which(answer, part):
    form = Parts({"a": Choice(("tree", "mount")), "b": Choice(("clock", "wait"))})
    verdict = judged(form, {"a": "tree", "b": "wait"}, {}, answer)
    assert verdict.failure is Failure.TYPE
    assert part in verdict.detail["tip"].en if part else "tip" not in verdict.detail


def test_a_mistake_of_a_function_that_is_made_in_one_part_is_told_and_costs_what_follows():
    form = Parts({"cause": Choice(("late", "fast")), "frame": Choice(("all", "laser"))})
    late, fast = to_plain({"cause": "late", "frame": "all"}), to_plain({"cause": "fast", "frame": "laser"})
    cases = [
        Case([1], late, {"never late": fast}),
        Case([2], fast, {"never late": fast}),
        Case([3], late, {"never late": fast}),
    ]
    task, variant = bare(form, *cases)
    task = task._replace(
        is_function=True, feedback={"never late": Feedback(Text("Late?", "늦었습니까?"), "", part="cause")}
    )
    verdict = judge_outcomes(task, variant, [fast, fast, to_plain({"cause": "fast", "frame": "all"})])
    assert next(iter(verdict.mistakes)) == "never late"
    assert verdict.follows == ()


def test_a_number_that_two_mistakes_give_to_a_hair_is_not_called_by_one_that_it_is_only_near_to():
    by_mistake = {"mean": 0.1445, "late": 0.2, "far": 0.3, "late + far": 0.144}
    assert list(judged(Number("s"), 0.223, by_mistake, 0.144).mistakes) == ["late", "far"]
    assert list(judged(Number("s"), 0.223, by_mistake, 0.1445).mistakes) == ["mean"]
    near = judged(Number("s"), 0.223, {"mean": 0.1445}, 0.144)  # to three digits
    assert list(near.mistakes) == ["mean"]
    assert near.said.en.startswith("Apart from rounding, this is the result of the following. ")
    assert judged(Number("s"), 0.223, {"mean": 0.1445}, 0.1445).said.en == "mean"


def test_exceptions_that_go_through_where_words_are_asked_for_are_named():
    form = Choice(("ok", "lookup", "connectivity", "past", "future"))
    expected = ["ok", "lookup", "connectivity", "past", "future"]
    task, variant = bare(form, *(Case([n], word, {}) for n, word in enumerate(expected)))
    task = task._replace(is_function=True)
    outcomes = ["ok", {"raises": "LookupException"}, {"raises": "ConnectivityException"}, "past", "future"]
    verdict = judge_outcomes(task, variant, outcomes)
    assert list(verdict.mistakes) == ["uncaught"]
    assert (
        "in 2 of the 5 your function lets an exception through: ConnectivityException, LookupException"
        in verdict.said.en
    )
    assert list(judge_outcomes(task, variant, ["ok", {"raises": "KeyError"}, *expected[2:]]).mistakes) == []
    beside = judge_outcomes(task, variant, ["ok", *outcomes[1:3], "ok", "future"])
    assert list(beside.mistakes) == ["ok for past", "uncaught"]
