"""What the ward writes is told in two languages; what a tool printed stays."""

from tflab.clinic.told import done, told
from tflab.clinic.trolley import TROLLEY
from tflab.clinic.ward import CABLE, TAPE


def test_what_is_typed_stays_and_what_is_done_is_told():
    typed = [check for check in TROLLEY.values() if check.command.startswith("ros2 ")]
    assert [done(check, "ko") for check in typed] == [check.command for check in typed]
    rest = [check for check in TROLLEY.values() if check not in typed]
    assert all(any("가" <= letter <= "힣" for letter in done(check, "ko")) for check in rest) and len(rest) == 3


def test_of_a_fix_the_wards_own_lines_are_told_and_the_tools_stay():
    text = "RViz: all Ok\nScan on the map: up to 0.47 m beside the walls\n$ ros2 topic delay /scan\n  average delay: 1"
    assert told(text) == text
    assert told(text, "ko").splitlines() == [
        "RViz: 모두 Ok", "지도 위의 스캔: 벽에서 최대 0.47 m 벗어남", "$ ros2 topic delay /scan", "  average delay: 1",
    ]  # fmt: skip


def test_every_line_of_the_ward_that_is_no_tools_has_its_korean():
    for line in (TAPE, CABLE, "Scan on the map: nothing can be placed"):
        assert told(line, "ko") != line and "0.200" in told(TAPE, "ko")
