"""The table is what eighteen robots said; a proof rules everybody else out, and stops there."""

from itertools import permutations

import pytest

from tflab.clinic.proof import fitting, flaw_of, left_after, minutes_of, order_of, rivals_of
from tflab.clinic.table import COMPLAINTS, DECIDING, SUSPECTS, kind_expected
from tflab.clinic.trolley import TROLLEY, check_named

CHEAP = [key for key, check in TROLLEY.items() if check.minutes <= 3]


def test_no_two_of_eighteen_suspects_would_give_the_same_answers():
    assert {len(complaint.suspects) for complaint in COMPLAINTS.values()} == {3}
    columns = {tuple(kind_expected(suspect, check) for check in TROLLEY) for suspect in SUSPECTS}
    assert len(columns) == len(SUSPECTS) == 3 * len(COMPLAINTS) == 18


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


@pytest.mark.parametrize(
    ("checks", "kind"),
    [
        (["hz /scan"], "unproved"),
        ([], "unproved"),
        (["delay /scan", "hz /odom", "monitor"], "idle"),
        (["hz /odom"], "all healthy"),
        (["tape measure", "delay /scan"], "late"),
    ],
)
def test_what_leaves_a_rival_or_asks_too_much_is_no_proof(checks, kind):
    flaw = flaw_of(checks, "laser clock ahead")
    assert flaw.kind == kind
    assert checks != ["hz /scan"] or flaw.rival == "transforms late"
    assert kind != "idle" or (flaw.count, flaw.minutes) == (1, 5)
    assert flaw_of(["delay /scan"], "laser clock ahead") is None
    assert flaw_of(["echo odom base_footprint"], "nothing is wrong") is None


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
