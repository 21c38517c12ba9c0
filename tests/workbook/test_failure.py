"""Every way to fail has a sentence in `check` and in a feedback page, and a verdict that names it."""

from __future__ import annotations

import string

import pytest

from tflab.workbook.answers.forms import Number, Urdf
from tflab.workbook.answers.values import raised
from tflab.workbook.diagnosis.failure import REPLIES, WITHOUT_THE_ANSWER, Failure
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.tasks.case_types import Case

from .small_chapter import bare


def gaps(text: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(text) if name}


def test_check_and_a_feedback_page_have_a_sentence_for_every_failure_and_nothing_of_the_learners_code():
    assert set(REPLIES) == set(WITHOUT_THE_ANSWER) == set(Failure)
    for failure in Failure:
        for words in (REPLIES[failure], WITHOUT_THE_ANSWER[failure]):
            assert {gap.removesuffix("_ko") for gap in gaps(words.ko)} == gaps(words.en)
        assert not gaps(WITHOUT_THE_ANSWER[failure].en) & {"got", "text", "answer", "frame"}


@pytest.mark.parametrize(
    ("outcomes", "failure"),
    [
        ([None, None], Failure.NOTHING_RETURNED),
        ([1.0, None], Failure.SOMETIMES_NOTHING),
        ([raised(ZeroDivisionError("x")), 2.0], Failure.RAISES),
        ([{"object": "function"}, {"object": "function"}], Failure.A_FUNCTION),
        (["1.0", "2.0"], Failure.TYPE),
        ([1000.0, 2000.0], Failure.UNIT),
        ([3.0, 3.0], Failure.CONSTANT),
        ([1.0, 9.0], Failure.VALUE),
    ],
)
def test_what_came_out_is_called_by_its_name(outcomes, failure):
    cases = (Case([8.0], 1.0, {}), Case([9.5], 2.0, {}))
    assert judge_outcomes(*bare(Number("m"), *cases, is_function=True), outcomes).failure is failure


def test_a_urdf_that_cannot_be_read_is_answered_with_the_readers_own_error():
    joint = '<joint name="j" type="fixed"><parent link="base_link"/><child link="{}"/></joint>'

    form = Urdf(("lens",))
    lost = judge_outcomes(*bare(form, Case(None, joint.format("lens"), {})), [joint.format("lense")])
    assert lost.failure is Failure.NO_ROBOT and 'its child link "lense" does not exist' in lost.detail["fault"]
