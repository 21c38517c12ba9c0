"""The table is what eighteen robots said; a proof rules everybody else out, and stops there."""

from itertools import permutations

import pytest

from tflab.clinic.proof import fitting, flaw_of, left_after, minutes_of, order_of, rivals_of
from tflab.clinic.table import COMPLAINTS, DECIDING, SUSPECTS, kind_expected
from tflab.clinic.trolley import TROLLEY, check_named

CHEAP = [key for key, check in TROLLEY.items() if check.minutes <= 3]


def test_each_of_eighteen_suspects_belongs_to_one_of_six_complaints():
    assert len(COMPLAINTS) == 6
    assert len(SUSPECTS) == len(set(SUSPECTS)) == 18
    assert {len(complaint.suspects) for complaint in COMPLAINTS.values()} == {3}


def test_no_two_suspects_would_give_the_same_answers():
    columns = {tuple(kind_expected(suspect, check) for check in TROLLEY) for suspect in SUSPECTS}
    assert len(columns) == 18


@pytest.mark.parametrize("suspect", SUSPECTS)
def test_each_suspect_has_a_proof_of_three_minutes_at_most(suspect):
    proofs = [
        checks
        for count in (1, 2)
        for checks in permutations(CHEAP, count)
        if minutes_of(checks) <= 3 and flaw_of(checks, suspect) is None
    ]
    assert proofs
    for checks in proofs:
        assert left_after(suspect, rivals_of(suspect), checks)[-1] == ()


def test_one_question_proves_a_clock_that_is_ahead():
    assert flaw_of(["delay /scan"], "laser clock ahead") is None


def test_a_list_that_leaves_a_rival_is_no_proof_and_names_one():
    flaw = flaw_of(["hz /scan"], "laser clock ahead")
    assert (flaw.kind, flaw.rival) == ("unproved", "transforms late")
    assert flaw_of([], "laser clock ahead").kind == "unproved"


def test_what_comes_after_the_proof_is_idle():
    flaw = flaw_of(["delay /scan", "hz /odom", "monitor"], "laser clock ahead")
    assert (flaw.kind, flaw.count, flaw.minutes) == ("idle", 1, 5)


def test_a_proof_shows_something_that_is_sick():
    assert flaw_of(["hz /odom"], "laser clock ahead").kind == "all healthy"
    assert flaw_of(["echo odom base_footprint"], "nothing is wrong") is None


def test_a_proof_keeps_to_the_budget():
    assert flaw_of(["tape measure", "delay /scan"], "laser clock ahead").kind == "late"


def test_everything_asked_proves_nothing():
    everything = list(TROLLEY)
    assert not [suspect for suspect in SUSPECTS if flaw_of(everything, suspect) is None]


def test_without_a_complaint_all_others_are_rivals():
    assert len(rivals_of("mount wrong")) == 2
    assert len(rivals_of("mount wrong", whole=True)) == 17
    assert fitting({"delay /scan": "ahead"}) == ("laser clock ahead",)


def test_the_order_of_a_visit_counts_who_is_left():
    assert order_of("laser clock ahead", ["hz /scan", "delay /scan"]) == [("hz /scan", 1, 3), ("delay /scan", 1, 1)]


def test_the_deciding_reading_of_a_suspect_is_not_as_on_the_card():
    for suspect, check in DECIDING.items():
        if suspect != "nothing is wrong":
            assert kind_expected(suspect, check) != TROLLEY[check].usual


def test_a_check_goes_by_its_name_or_by_what_is_typed():
    assert check_named("delay /scan") == check_named("ros2 topic  delay /scan") == check_named("topic delay /scan")
    with pytest.raises(ValueError, match=r'"delay scan" is not on the trolley.*did you mean "delay /scan"'):
        check_named("delay scan")
