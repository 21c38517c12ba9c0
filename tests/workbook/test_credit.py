"""Which right results earn credit: those that could not be guessed."""

from __future__ import annotations

import pytest

from tflab.core import LookupException
from tflab.workbook.answers.form import inside
from tflab.workbook.answers.forms import Angle, Choice, Name, Number, Parts, Set
from tflab.workbook.answers.values import raised, to_plain
from tflab.workbook.diagnosis.failure import Failure
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.tasks.case_types import Case
from tflab.workbook.tasks.credit import (
    asked_alike,
    beyond_guessing,
    beyond_one_word,
    beyond_the_usual,
    credited,
    trivial_pattern,
    usual_among,
)

from .each_task import READS, cases_of, each_task, task_in
from .small_chapter import bare

PLANAR = Parts({"x": Number("m"), "yaw": Angle()})
POSES = [(1.0, 0.5), (2.0, -1.0), (0.0, 2.0), (3.0, 0.0)]


def planar(x, yaw):
    return to_plain({"x": x, "yaw": yaw})


def judged(form, asked, function):
    """Return the verdict on a function, where `asked` is a list of (argument, expected)."""
    cases = [Case([to_plain(given)], expected, {}) for given, expected in asked]
    task, variant = bare(form, *cases, is_function=True)
    return judge_outcomes(task, variant, [to_plain_or_raised(function, given) for given, _ in asked])


def to_plain_or_raised(function, given):
    try:
        return to_plain(function(given))
    except Exception as error:
        return raised(error)


NEGATED = [({"x": x, "yaw": yaw}, planar(-x, -yaw)) for x, yaw in POSES]


@pytest.mark.parametrize(
    ("function", "passed", "kind"),
    [
        (lambda pose: {"x": -pose["x"], "yaw": -pose["yaw"]}, 8, None),
        (lambda pose: {"x": 0.0, "yaw": 0.0}, 0, "constant"),
        (lambda pose: dict(pose), 0, "echo"),
        (lambda pose: {"x": -pose["x"], "yaw": 0.0}, 4, "known"),  # the x is understood
        (lambda pose: {"x": pose["x"] ** 2, "yaw": -pose["yaw"]}, 4, "parts"),  # 0 ** 2 shows nothing
        (lambda pose: {"x": -pose["x"], "yaw": pose["yaw"]}, 4, "known"),  # neither does a yaw of 0
        (
            lambda pose: {"x": -pose["x"] if pose["x"] < 2 else 9.0, "yaw": 9.0},
            2,
            "known",
        ),  # two different ones do; a yaw that is always the same is told so
    ],
)
def test_a_part_earns_credit_for_two_different_results(function, passed, kind):
    verdict = judged(PLANAR, NEGATED, function)
    assert (verdict.passed, verdict.of, verdict.failure) == (passed, 8, kind)
    assert sum(verdict.right) == passed


def test_the_same_word_for_every_call_earns_nothing():
    asked = [(stamp, "yes" if stamp < 2 else "no") for stamp in range(5)]
    assert judged(Choice(("yes", "no")), asked, lambda stamp: "yes").failure is Failure.CONSTANT
    assert judged(Choice(("yes", "no")), asked, lambda stamp: "yes").passed == 0
    assert judged(Choice(("yes", "no")), asked, lambda stamp: "yes" if stamp < 3 else "no").passed == 4


def test_a_result_that_is_always_the_same_may_be_a_constant():
    asked = [(stamp, 7.0) for stamp in range(3)]
    assert judged(Number(), asked, lambda stamp: 7.0).failure is None
    assert judged(Number(), asked, lambda stamp: 7.0 if stamp else 8.0).passed == 2


REFUSING = [(1.0, 1.0), (2.0, 2.5), (-1.0, {"raises": "LookupException", "text": ""})]


def test_a_function_that_always_raises_earns_nothing():
    def refuse(stamp, below=9.0):
        if stamp < below:
            raise LookupException("no")
        return 9.0

    assert judged(Number(), REFUSING, refuse).passed == 0
    assert judged(Number(), REFUSING, lambda stamp: refuse(stamp, 0.0)).passed == 1


def test_one_case_is_judged_by_itself():
    case = Case([to_plain(1.0)], 2.0, {})
    assert credited(Number(), [case], [2.0], [[True]]) == [[True]]
    assert trivial_pattern(Number(), [case], [1.0]) == ""


def share_of(form, cases, outcomes, known):
    """Return the share of the points that outcomes earn."""
    variant_cases = [Case([number], expected, {}) for number, expected in enumerate(cases)]
    task, variant = bare(form, *variant_cases, is_function=True)
    passed = judge_outcomes(task, variant, outcomes).passed
    return beyond_guessing(form, variant_cases, passed, known)


WORDS = Choice(("ok", "zero", "nan"))
ASKED = ["ok", "ok", "ok", "ok", "zero", "nan"]


REFUSED = raised(LookupException("no"))
FOUR = [1.0, 2.0, 3.0, 4.0]


@pytest.mark.parametrize(
    ("form", "asked", "said", "known", "share"),
    [
        (WORDS, ASKED, ASKED, 0, 1.0),
        (WORDS, ASKED, ["ok"] * 6, 0, 0.0),
        (WORDS, ASKED, ["ok"] * 5 + ["nan"], 0, 0.5),  # one of the two that are not "ok"
        (WORDS, ASKED, ["nan", "ok", "ok", "ok", "zero", "nan"], 0, 0.5),
        (WORDS, ASKED, ["zero", "nan", "ok", "ok", "zero", "nan"], 0, 0.0),
        (Number(), FOUR, [1.0, 2.0, 3.0, 0.0], 0, 0.75),  # all differ: each earns its share
        (Number(), FOUR, [1.0, 2.0, 0.0, 0.0], 2, 0.0),  # of the first two, the answers are known
        (Number(), FOUR, [1.0, 2.0, 3.0, 0.0], 2, 0.5),
        (Number(), [0.0, 1.0, 7.0, 8.0], [0.0, 1.0, 5.0, 5.0], 0, 0.0),  # the argument comes back
        (Number(), [REFUSED] * 3 + [1.0, 2.0, 3.0], [REFUSED] * 5 + [0.0], 0, 0.0),
    ],
)
def test_only_results_beyond_the_most_frequent_answer_earn_points(form, asked, said, known, share):
    is_known = [place < known for place in range(len(asked))]
    assert share_of(form, asked, said, is_known) == pytest.approx(share)


def test_negating_the_argument_earns_nothing():
    pose = Parts({"x": Number(), "yaw": Number()})
    asked = [{"x": 1.0, "yaw": 0.5}, {"x": 2.0, "yaw": -1.0}, {"x": 3.0, "yaw": 2.0}]
    cases = [Case([to_plain(one)], to_plain({"x": 9.0 * one["x"], "yaw": -one["yaw"]}), {}) for one in asked]
    task, variant = bare(pose, *cases, is_function=True)
    for turned in ([-1, -1, -1], [-1, 1, -1]):
        said = [to_plain({name: sign * v for name, v in one.items()}) for sign, one in zip(turned, asked, strict=True)]
        passed = judge_outcomes(task, variant, said).passed
        assert passed == turned.count(-1)
        assert beyond_guessing(pose, cases, passed, [False] * 3) == 0.0


def test_sets_of_different_sizes_can_be_guessed():
    form = Set(Name())
    cases = [Case([number], to_plain(names), {}) for number, names in enumerate([{"a"}, {"a", "b"}, {"a", "b", "c"}])]
    assert beyond_guessing(form, cases, 6, [False] * 3) == 1.0
    assert beyond_guessing(form, cases, 3, [False] * 3) == 0.0  # who always says {"a"} has three of the six


LOOP = Parts({"leap_m": Number("m"), "step_m": Number("m")})


@pytest.mark.parametrize(
    ("own", "others", "usual"),
    [
        ((1.0, 0.0), [(2.0, 0.0), (3.0, 5.0)], [False, True]),
        ((1.0, 0.0), [(2.0, 4.0), (3.0, 5.0), (4.0, 0.0)], [False, False]),
        ((1.0, 0.0), [], []),
        ((1.0, 0.0), [(1.0, 0.0), (1.0, 0.0)], []),  # nothing differs: this is known, or not
    ],
)
def test_a_part_that_is_right_in_half_of_the_other_variants_is_usual(own, others, usual):
    plain = [{"dict": dict(zip(LOOP.parts, values, strict=True))} for values in (own, *others)]
    assert usual_among(LOOP, plain[0], plain[1:]) == usual


@pytest.mark.parametrize(
    ("right", "usual", "follows", "earned"),
    [
        ([True, True], [False, True], [], [True, True]),
        ([False, True], [False, True], [], [False, False]),
        ([True, False], [False, True], [], [True, False]),
        ([False, True], [], [], [False, True]),
        ([True, True, False], [True, False, False], [False, True, False], [False] * 3),
        ([True, True, False], [False, False, False], [False, True, False], [True, True, False]),
    ],
)
def test_a_usual_part_alone_earns_nothing_and_costs_nothing_if_all_is_right(right, usual, follows, earned):
    assert beyond_the_usual(right, usual, *([follows] if follows else [])) == earned


YES_NO = Choice(("yes", "no"))
FOUR_OF_SIX = {"a": "yes", "b": "yes", "c": "yes", "d": "yes", "e": "no", "f": "no"}


def passed_of(right, answer, form=YES_NO):
    case = Case(None, to_plain(right), {})
    task, variant = bare(Parts(dict.fromkeys(right, form)), case)
    return judge_outcomes(task, variant, [to_plain(answer)]).passed


@pytest.mark.parametrize(
    ("answer", "passed"),
    [
        (dict.fromkeys("abcdef", "yes"), 0),
        (dict.fromkeys("abcdf", "yes") | {"e": "no"}, 5),
        (dict.fromkeys("bcdef", "yes") | {"a": "no"}, 0),  # right in three of five: less than anywhere
        (dict.fromkeys("abc", "yes"), 3),  # the others are not answered yet
        (dict.fromkeys("abc", "yes") | dict.fromkeys("def", "no"), 5),
        ("yes", 0),
    ],
)
def test_a_word_that_is_used_too_often_earns_nothing(answer, passed):
    assert passed_of(FOUR_OF_SIX, answer) == passed


def test_one_word_for_all_parts_counts_if_it_is_right_for_all():
    assert passed_of(dict.fromkeys("abc", "yes"), dict.fromkeys("abc", "yes")) == 3
    assert passed_of(dict.fromkeys("abc", "yes"), {"a": "yes", "b": "yes", "c": "no"}) == 2
    assert passed_of({"a": "yes", "b": "no"}, {"a": "yes", "b": "yes"}) == 1


WORSE_THAN_LOTS = {("E2.1", "an aeroplane's axes")}  # three of five "negative": one is right, of the two that are


@pytest.mark.proof(reads=READS)
@each_task
def test_a_known_mistake_keeps_its_right_parts_unless_it_is_one_word_for_all(stem, file):
    form = task_in(stem, file).form
    groups = asked_alike(form.parts) if isinstance(form, Parts) and not task_in(stem, file).counts else []
    task = cases_of(stem, file) if groups else None
    for case in (case for variant in task.variants for case in variant.cases) if task else ():
        for name in (name for name in task.feedback if (task_in(stem, file).id, name) not in WORSE_THAN_LOTS):
            answer, right = case.wrong[name], form.judge(case.wrong[name], case.expected)
            said = [{str(inside(answer).get(part)) for part in group} for group in groups]
            if all(len(words) > 1 for words in said):
                assert beyond_one_word(form, answer, case.expected, right) == right, name
