"""The order of the checks of a diagnosis."""

from tflab.views.diagnosis_log import (
    describe_minutes,
    describe_order,
    draw_minutes,
    draw_order,
)

LOG = [("view_frames", 3, 3), ("delay /scan", 1, 1), ("monitor", 4, 1)]


def test_the_order_is_a_list_and_bars_with_the_moment_at_which_the_cause_was_clear():
    assert describe_order([]) == "nothing was asked"
    picture = draw_order(LOG)
    assert picture.text.splitlines() == [
        "1. view_frames: 3 min, 3 in all, 3 left",
        "2. delay /scan: 1 min, 4 in all, 1 left  one suspect left",
        "3. monitor: 4 min, 8 in all, 1 left  added nothing",
    ]
    bars = [(bar.get_x(), bar.get_width(), str(bar.get_hatch())) for bar in picture.figure.axes[0].patches]
    assert bars == [(0, 3, ""), (3, 1, ""), (4, 4, "////")]


def test_ways_of_asking_are_compared_by_mean_worst_and_budget():
    ways = {"in order": {"a": 6, "b": 14}, "best next": {"a": 2, "b": 4}}
    assert describe_minutes(ways, 12).splitlines() == [
        "in order   mean 10.0 min, worst 14, 1 of 2 within 12",
        "best next  mean 3.0 min, worst 4, 2 of 2 within 12",
    ]
    assert draw_minutes(ways, 12).text == describe_minutes(ways, 12)
