"""The table is what eighteen robots said; a proof rules everybody else out, and stops there."""

from itertools import permutations

import pytest

from tflab.clinic.checks import CHECKS, find_check
from tflab.clinic.proof import check_steps, consistent_suspects, find_flaw, minutes_of, rivals_left, rivals_of
from tflab.clinic.table import COMPLAINTS, DECIDING, SUSPECTS, expected_kind

CHEAP = [key for key, check in CHECKS.items() if check.minutes <= 3]


def test_no_two_of_eighteen_suspects_would_give_the_same_answers():
    assert {len(complaint.suspects) for complaint in COMPLAINTS.values()} == {3}
    columns = {tuple(expected_kind(suspect, check) for check in CHECKS) for suspect in SUSPECTS}
    assert len(columns) == len(SUSPECTS) == 3 * len(COMPLAINTS) == 18


@pytest.mark.parametrize("suspect", SUSPECTS)
def test_each_suspect_has_a_proof_of_three_minutes_at_most(suspect):
    proofs = [
        checks
        for count in (1, 2)
        for checks in permutations(CHEAP, count)
        if minutes_of(checks) <= 3 and find_flaw(checks, suspect) is None
    ]
    assert proofs
    for checks in proofs:
        assert rivals_left(suspect, rivals_of(suspect), checks)[-1] == ()


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
    flaw = find_flaw(checks, "laser clock ahead")
    assert flaw.kind == kind
    assert checks != ["hz /scan"] or flaw.rival == "transforms late"
    assert kind != "idle" or (flaw.count, flaw.minutes) == (1, 5)
    assert find_flaw(["delay /scan"], "laser clock ahead") is None
    assert find_flaw(["echo odom base_footprint"], "nothing is wrong") is None


def test_everything_asked_proves_nothing():
    everything = list(CHECKS)
    assert not [suspect for suspect in SUSPECTS if find_flaw(everything, suspect) is None]


def test_without_a_complaint_all_others_are_rivals():
    assert len(rivals_of("mount wrong")) == 2
    assert len(rivals_of("mount wrong", whole=True)) == 17
    assert consistent_suspects({"delay /scan": "ahead"}) == ("laser clock ahead",)


def test_the_order_of_a_visit_counts_who_is_left():
    assert check_steps("laser clock ahead", ["hz /scan", "delay /scan"]) == [("hz /scan", 1, 3), ("delay /scan", 1, 1)]


def test_the_deciding_reading_of_a_suspect_is_not_as_on_the_card():
    for suspect, check in DECIDING.items():
        if suspect != "nothing is wrong":
            assert expected_kind(suspect, check) != CHECKS[check].usual


def test_a_check_goes_by_its_name_or_by_what_is_typed():
    assert find_check("delay /scan") == find_check("ros2 topic  delay /scan") == find_check("topic delay /scan")
    with pytest.raises(ValueError, match=r'"delay scan" is not on the trolley.*did you mean "delay /scan"'):
        find_check("delay scan")
