"""A length of time in place of a number of seconds: what it is, and what is wrong with the number in it."""

from __future__ import annotations

import math

import pytest

from tflab.ros.messages import builtin_interfaces
from tflab.ros.time import Duration, Time
from tflab.workbook.answers.forms import Number, Parts
from tflab.workbook.diagnosis.failure import Failure
from tflab.workbook.tasks import Text
from tflab.workbook.tasks.case_types import Feedback

from .test_explain import judged

BY_MISTAKE = {"the fast one": 3.05}
REPLIES = {"the fast one": Feedback(Text("You counted the fast one.", "빠른 쪽을 셌습니다."), "")}


@pytest.mark.parametrize(
    ("answer", "kind"),
    [
        (Duration(seconds=3.05), "A Duration is not a number"),
        (Time(seconds=3.05), "A Time is not a number"),
        (builtin_interfaces.Time(sec=3, nanosec=50_000_000), "A stamp is not a number"),
    ],
)
def test_a_time_for_seconds_hears_what_it_is_and_what_is_wrong_with_its_length(answer, kind):
    verdict = judged(Number("s"), 3.4, BY_MISTAKE, answer, REPLIES)
    assert list(verdict.mistakes) == ["the fast one", "other type"]
    assert "You counted the fast one." in verdict.said.en and kind in verdict.said.en
    assert "빠른 쪽을 셌습니다." in verdict.said.ko


def test_a_time_that_no_known_mistake_explains_hears_only_what_it_is():
    right, other = (judged(Number("s"), 3.4, BY_MISTAKE, Duration(seconds=s), REPLIES) for s in (3.4, 3.1))
    assert right.failure is Failure.TYPE and ".nanoseconds / 1e9" in right.detail["tip"].en
    assert "other type" not in other.mistakes
    metres = judged(Number("m"), 3.4, BY_MISTAKE, Duration(seconds=3.05), REPLIES)
    assert metres.failure is Failure.TYPE and "tip" not in metres.detail


@pytest.mark.parametrize(("together", "is_anothers"), [(0.6, True), (math.hypot(0.05, 0.6), False)])
def test_a_part_that_is_near_to_anothers_answer_by_its_tolerance_alone_is_not_called_that(together, is_anothers):
    form = Parts({name: Number("m", tolerance=0.003) for name in ("ahead", "left", "together")})
    right = {"ahead": 0.4, "left": 0.6, "together": math.hypot(0.4, 0.6)}
    verdict = judged(form, right, {}, right | {"ahead": 0.05, "together": together})
    said = verdict.said.en if verdict.said else ""
    assert ('answer for "left"' in said) is is_anothers
