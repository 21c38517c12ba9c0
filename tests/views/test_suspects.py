"""Suspects by checks: who is struck, which question would tell nothing, and the same in words."""

import pytest

from tflab.views.fault_tables import describe_suspects, draw_suspects

TABLE = {
    "clock ahead": {"delay /scan": "ahead", "hz /odom": "as on the card", "hz /scan": "as on the card"},
    "late": {"delay /scan": "as on the card", "hz /odom": "trembles", "hz /scan": "as on the card"},
    "slow": {"delay /scan": "as on the card", "hz /odom": "too seldom", "hz /scan": "as on the card"},
}


def test_the_words_say_who_is_left_and_which_questions_tell_something():
    assert describe_suspects(TABLE, {"delay /scan": "as on the card"}).splitlines() == [
        "2 of 3 suspects left",
        "  clock ahead  struck: delay /scan would be ahead",
        "  late         left",
        "  slow         left",
        "asked: delay /scan: as on the card",
        "not asked: hz /odom: would tell 2 apart",
        "not asked: hz /scan: nothing",
    ]


def test_a_struck_row_has_a_line_through_it_and_an_unasked_column_is_hatched():
    picture = draw_suspects(TABLE, {"delay /scan": "ahead"})
    assert len(picture.ax.lines) == 2
    assert sum(patch.get_hatch() is not None for patch in picture.ax.patches) == 6
    picture.tell({"delay /scan": "ahead", "hz /odom": "as on the card"})
    assert sum(patch.get_hatch() is not None for patch in picture.ax.patches) == 3
    assert picture.text.startswith("1 of 3 suspects left")


def test_what_is_no_column_is_refused():
    with pytest.raises(ValueError, match="nobody to suspect"):
        draw_suspects({})
    with pytest.raises(ValueError, match=r"no column 'tape'; there is delay /scan"):
        draw_suspects(TABLE, {"tape": "x"})
