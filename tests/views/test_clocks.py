"""While a bag is played, a node lives in the bag's time, in the wall's, or in none."""

import pytest

from tflab.views.clocks import NowAnswer, Play, asked_now, bag_time, clock_of, describe_clocks, draw_clocks

DAY_LATER = Play(begin_s=1.0, length_s=15.0, wall_s=86401.0, tf_behind_s=0.25)


def test_a_node_lives_in_the_time_of_the_bag_or_of_the_machine_and_now_is_short_by_what_transforms_take():
    for follows, now_s, short_s in ((True, 5.0, 0.25), (False, 86405.0, 86400.25)):
        assert clock_of(DAY_LATER, follows, 4.0) == now_s
        assert asked_now(DAY_LATER, follows, 4.0) == NowAnswer("future", pytest.approx(short_s))


def test_without_a_clock_to_follow_the_time_is_zero_and_zero_asks_for_the_latest():
    silent = Play(publishes_clock=False)
    assert clock_of(silent, True, 4.0) == 0.0
    assert asked_now(silent, True, 4.0) == NowAnswer("latest")
    assert asked_now(silent, False, 4.0).kind == "future"


def test_the_rate_is_the_slope_and_at_the_end_the_time_of_the_bag_stands_still_or_begins_again():
    assert bag_time(Play(rate=2.0), 3.0) == 7.0
    assert bag_time(Play(rate=2.0), 8.0) == bag_time(Play(), 40.0) == 16.0
    loop = Play(loops=True)
    assert [round(bag_time(loop, played_s), 3) for played_s in (14.9, 15.01, 17.01)] == [15.9, 1.0, 3.0]


def test_a_clock_that_is_behind_everything_in_the_buffer_asks_for_the_past():
    early = Play(wall_s=-3.0)
    assert asked_now(early, False, 1.0) == NowAnswer("past", 3.0)
    assert asked_now(Play(wall_s=1.5), False, 2.0) == NowAnswer("future", pytest.approx(0.51))
    assert asked_now(Play(wall_s=0.5), False, 2.0) == NowAnswer("answered")


def test_the_words_say_for_each_node_its_now_and_what_comes_of_asking_for_it():
    nodes = {"rviz2": True, "detector": False}
    assert describe_clocks(nodes, DAY_LATER, 4.0).splitlines() == [
        "after 4.00 s of playing",
        "node          its now  newest TF  lookup at now",
        "rviz2         5.000 s    4.750 s  future extrapolation, 0.250 s",
        "detector  86405.000 s    4.750 s  future extrapolation, 86400.250 s",
    ]
    assert "미래" in describe_clocks(nodes, DAY_LATER, 4.0, "ko")


def test_each_clock_stands_where_its_time_is_and_is_told_apart_by_line_and_mark():
    picture = draw_clocks({"rviz2": True, "detector": False}, DAY_LATER, 4.0)
    (rviz_wall, rviz_bag), (detector_wall, detector_bag) = picture.lines
    assert rviz_bag.get_ydata()[0] == 1.0 and detector_wall.get_ydata()[0] == 86401.0
    for absent in (rviz_wall, detector_bag):
        assert all(value != value for value in absent.get_ydata())
    assert rviz_bag.get_linestyle() != detector_wall.get_linestyle()
    assert picture.dots[0][1].get_marker() != picture.dots[1][0].get_marker()
    back = draw_clocks({"rviz2": True}, Play(loops=True)).lines[0][1].get_ydata()
    assert sum(value != value for value in back) == 1  # a line is broken where the clock goes back


def test_more_clocks_than_can_be_told_apart_and_a_rate_of_zero_are_refused():
    for nodes in ({}, dict.fromkeys("abcd", True)):
        with pytest.raises(ValueError, match="between one and 3 clocks"):
            draw_clocks(nodes)
    with pytest.raises(ValueError, match="above 0"):
        Play(rate=0.0)
