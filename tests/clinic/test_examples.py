"""The printed tables say what the ward's findings look like, and of whom."""

import pytest

from tflab.clinic.checks import CHECKS
from tflab.clinic.examples import EXAMPLES, checks_as_text, findings_as_text, suspects_as_text
from tflab.clinic.table import SUSPECTS, expected_kind


@pytest.mark.parametrize("check", CHECKS)
def test_of_each_check_there_is_an_example_of_every_kind_that_is_read_as_that_kind(check):
    kinds = {expected_kind(suspect, check) for suspect in SUSPECTS}
    assert set(EXAMPLES[check]) == kinds
    assert {CHECKS[check].kind(line): line for line in EXAMPLES[check].values()} == EXAMPLES[check]


def test_every_suspect_stands_in_print_and_every_check_with_its_price():
    assert all(f"    {suspect}\n" in suspects_as_text() + "\n" for suspect in SUSPECTS)
    assert len(checks_as_text().splitlines()) == len(CHECKS)
    assert "delay /scan                   1 min   ros2 topic delay /scan" in checks_as_text()
    assert "delay /scan                   1분   ros2 topic delay /scan" in checks_as_text("ko")


def test_what_a_check_says_of_whom_stands_beside_what_the_card_has():
    lines = [" ".join(line.split()) for line in findings_as_text().splitlines()]
    at = lines.index("delay /scan 1 min $ ros2 topic delay /scan")
    assert lines[at + 1 : at + 4] == [
        "0.105 s, std dev 0.000 s (card)",
        "0.505 s, std dev 0.000 s laser clock behind",
        "-0.295 s, std dev 0.000 s laser clock ahead",
    ]


def test_of_one_complaint_only_the_checks_stand_there_that_tell_its_suspects_apart():
    text = findings_as_text("beside the walls")
    heads = [line.split("  ")[0] for line in text.splitlines() if not line.startswith(" ")]
    assert heads == ["echo base_link laser_frame", "delay /scan", "scan header", "echo /tf_static"]
    assert "clock ahead" not in text
    with pytest.raises(ValueError, match='"tired" is no complaint; there is no map'):
        findings_as_text("tired")
