"""How far off a map puts what was seen: distances by hand, and a picture that says them."""

import numpy as np
import pytest

from tflab.views.map_error import distances_to, draw_placed, offs

WALL = ((0.0, 0.0), (4.0, 0.0))


def test_a_point_is_as_far_from_a_wall_as_from_its_nearest_spot():
    beside, beyond = (1.0, 0.5), (7.0, 4.0)  # 3-4-5 from the wall's end
    assert distances_to(np.array([beside, beyond]), walls=[WALL]) == pytest.approx([0.5, 5.0])


def test_the_nearest_of_walls_and_things_counts():
    points = np.array([(1.0, 3.0, 9.9), (1.0, 0.25, 9.9)])  # heights do not count
    assert distances_to(points, walls=[WALL], things=[(1.0, 2.0, 0.3)]) == pytest.approx([1.0, 0.25])


def test_a_wall_without_length_is_a_point():
    assert distances_to(np.array([(3.0, 4.0)]), walls=[((0.0, 0.0), (0.0, 0.0))]) == pytest.approx([5.0])


def test_points_that_hit_nothing_are_left_out():
    points = np.array([(1.0, 0.1, 0.0), (np.nan, np.nan, np.nan), (1.0, 0.3, 0.0)])
    assert offs(points, walls=[WALL]) == pytest.approx((2, 0.2, 0.3))


def test_without_anything_there_nothing_can_be_off():
    with pytest.raises(ValueError, match="nothing is really there"):
        distances_to(np.array([(0.0, 0.0)]))


def test_no_points_are_not_off():
    assert offs(np.full((2, 3), np.nan), things=[(0.0, 0.0)]) == (0, 0.0, 0.0)


def test_the_picture_says_in_words_how_far_off_each_way_is():
    ways = {"right": np.array([(1.0, 2.0)]), "wrong": np.array([(1.0, 2.5), (1.0, 3.0)])}
    picture = draw_placed(ways, things=[(1.0, 2.0)])
    assert picture.text.splitlines() == [
        "right      1 points, off by 0.000 m on average, 0.000 m at worst",
        "wrong      2 points, off by 0.750 m on average, 1.000 m at worst",
    ]


def test_every_way_has_a_panel_at_the_same_scale_and_a_metre_is_a_metre():
    ways = {"right": np.array([(1.0, 2.0)]), "wrong": np.array([(5.0, 2.5)])}
    picture = draw_placed(ways, walls=[WALL], shown_m=(0.0, -1.0, 6.0, 3.0))
    left, right = picture.figure.axes
    assert left.get_xlim() == right.get_xlim()
    assert left.get_xlim()[0] <= 0.0 and left.get_xlim()[1] >= 6.0
    box = left.get_window_extent()
    across, up = np.ptp(left.get_xlim()) / box.width, np.ptp(left.get_ylim()) / box.height
    assert across == pytest.approx(up)


def test_the_picture_is_the_same_bytes_every_time_and_small():
    points = np.random.default_rng(1).normal(size=(5000, 3))
    first, again = (draw_placed({"here": points}, walls=[WALL]).png() for _ in range(2))
    assert first == again
    assert len(first) < 60_000
