"""The steps of a diagnosis, and the order of its checks."""

import pytest

from tflab.views.diagnosis_log import (
    VisitStep,
    describe_minutes,
    describe_order,
    describe_visit,
    draw_minutes,
    draw_order,
    draw_visit,
)

STEPS = [
    VisitStep("RViz", 0.0, "into the future", "", ("ahead", "late", "slow")),
    VisitStep("hz /odom", 1.0, "20.0 Hz", "card: 20.0 Hz", ("ahead", "late")),
    VisitStep("delay /scan", 1.0, "-0.295 s", "card: 0.105 s", ("ahead",)),
    VisitStep("set the clock", 10.0, "all Ok", "", ("ahead",), is_fix=True),
]


def ends(picture):
    return [line for line in picture.ax.lines if line.get_marker() == "x"]


def bars(picture):
    return [patch for patch in picture.ax.patches if patch.get_height() == 16]


def test_the_words_say_what_was_struck_and_by_what():
    assert describe_visit(STEPS).splitlines() == [
        "1. RViz: into the future",
        "   left: ahead, late, slow",
        "2. hz /odom (1 min, 1 in all): 20.0 Hz; card: 20.0 Hz",
        "   struck: slow",
        "   left: ahead, late",
        "3. delay /scan (1 min, 2 in all): -0.295 s; card: 0.105 s",
        "   struck: late",
        "   left: ahead",
        "4. set the clock (10 min, 12 in all): all Ok",
    ]


def test_what_comes_later_is_not_told_yet():
    picture = draw_visit(STEPS, 12.0)
    picture.show(1)
    assert picture.text == describe_visit(STEPS, 1) and "delay /scan" not in picture.text
    assert "delay /scan" not in " ".join(text.get_text() for text in picture.ax.texts)
    assert len(ends(picture)) == 1


def test_a_line_ends_where_its_suspect_is_struck_and_a_bar_begins_where_the_one_before_ends():
    picture = draw_visit(STEPS, 12.0)
    assert len(ends(picture)) == 2
    heights = [mark.get_ydata()[0] for mark in ends(picture)]
    assert heights == sorted(heights, reverse=True)
    begin = [bar.get_x() for bar in bars(picture)]
    over = [bar.get_x() + bar.get_width() for bar in bars(picture)]
    assert begin[1:] == pytest.approx(over[:-1]) and [bool(bar.get_hatch()) for bar in bars(picture)][-1]


def test_of_many_suspects_only_the_last_few_bear_their_names():
    many = tuple(f"suspect {number}" for number in range(18))
    picture = draw_visit([VisitStep("RViz", 0.0, "", "", many), VisitStep("view_frames", 3.0, "", "", many[:2])], 12.0)
    names = [text.get_text() for text in picture.ax.texts if text.get_text() in many]
    assert names == ["suspect 0", "suspect 1"]
    picture.show(0)
    assert not [text for text in picture.ax.texts if text.get_text() in many]


def test_a_long_finding_ends_in_dots_in_the_picture_alone_and_no_step_is_refused():
    picture = draw_visit([VisitStep("node list", 1.0, "node " * 30, "", ("a",))], 12.0)
    assert any(text.get_text().endswith("…") for text in picture.ax.texts) and "…" not in picture.text
    with pytest.raises(ValueError, match="no step to draw"):
        draw_visit([], 12.0)


LOG = [("view_frames", 3, 3), ("delay /scan", 1, 1), ("monitor", 4, 1)]


def test_the_order_is_a_list_and_bars_with_the_moment_at_which_the_cause_was_clear():
    assert describe_order([]) == "nothing was asked"
    picture = draw_order(LOG)
    assert picture.text.splitlines() == [
        "1. view_frames: 3 min, 3 in all, 3 left",
        "2. delay /scan: 1 min, 4 in all, 1 left  one suspect left",
        "3. monitor: 4 min, 8 in all, 1 left  told nothing more",
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
