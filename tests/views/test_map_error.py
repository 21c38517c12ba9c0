"""Distances of points and tracks from what is really there."""

import numpy as np
import pytest

from tflab.views.map_error import (
    describe_tracks,
    distances_to,
    draw_detections,
    draw_placed,
    draw_tracks,
    point_errors,
    smoothness,
)

WALL = ((0.0, 0.0), (4.0, 0.0))


def test_the_distance_of_a_point_is_that_to_the_nearest_spot_of_a_wall_or_thing():
    beside, beyond = (1.0, 0.5), (7.0, 4.0)  # 3-4-5 from the wall's end
    assert distances_to(np.array([beside, beyond]), walls=[WALL]) == pytest.approx([0.5, 5.0])
    points = np.array([(1.0, 3.0, 9.9), (1.0, 0.25, 9.9)])  # heights do not count
    assert distances_to(points, walls=[WALL], things=[(1.0, 2.0, 0.3)]) == pytest.approx([1.0, 0.25])
    assert distances_to(np.array([(3.0, 4.0)]), walls=[((0.0, 0.0), (0.0, 0.0))]) == pytest.approx([5.0])
    with pytest.raises(ValueError, match="nothing is really there"):
        distances_to(np.array([(0.0, 0.0)]))


def test_points_that_hit_nothing_are_left_out():
    points = np.array([(1.0, 0.1, 0.0), (np.nan, np.nan, np.nan), (1.0, 0.3, 0.0)])
    assert point_errors(points, walls=[WALL]) == pytest.approx((2, 0.2, 0.3))
    assert point_errors(np.full((2, 3), np.nan), things=[(0.0, 0.0)]) == (0, 0.0, 0.0)


def test_the_picture_says_in_words_how_far_off_each_way_is():
    ways = {"right": np.array([(1.0, 2.0)]), "wrong": np.array([(1.0, 2.5), (1.0, 3.0)])}
    picture = draw_placed(ways, things=[(1.0, 2.0)])
    assert picture.text.splitlines() == [
        "right      1 points, off by 0.000 m on average, 0.000 m at worst",
        "wrong      2 points, off by 0.750 m on average, 1.000 m at worst",
    ]


def test_detections_are_shown_in_map_with_the_robots_path_and_enlarged():
    points, path = [(1.0, 2.5), (1.0, 3.0)], [(-1.0, 0.0), (0.0, 0.5)]
    picture = draw_detections(points, (1.0, 2.0, 0.3), path, "with Time()")
    assert picture.text.splitlines() == [
        "the robot's path: from (-1.00, 0.00) m to (0.00, 0.50) m in map",
        "ball (true position): (1.00, 2.00) m",
        "detections, with Time()      2 points, off by 0.750 m on average, 1.000 m at worst",
    ]
    near, far = (np.ptp(ax.get_xlim()) for ax in picture.figure.axes)
    assert near < far


def test_every_way_has_a_panel_at_the_same_scale_and_a_metre_is_a_metre():
    ways = {"right": np.array([(1.0, 2.0)]), "wrong": np.array([(5.0, 2.5)])}
    picture = draw_placed(ways, walls=[WALL], shown_m=(0.0, -1.0, 6.0, 3.0))
    left, right = picture.figure.axes
    assert left.get_xlim() == right.get_xlim()
    assert left.get_xlim()[0] <= 1e-9 and left.get_xlim()[1] >= 6.0 - 1e-9
    box = left.get_window_extent()
    across, up = np.ptp(left.get_xlim()) / box.width, np.ptp(left.get_ylim()) / box.height
    assert across == pytest.approx(up)


# The robot drives along x, 1 m a second.  One track is 1 cm short each second, the other leaps by half a metre once.
TIMES_S = np.arange(5.0)
TRUTH = np.column_stack((TIMES_S, np.zeros(5)))
DRIFTS = TRUTH * (0.99, 1.0)
LEAPS = TRUTH + np.array([(0, 0), (0, 0), (0, 0.5), (0, 0.5), (0, 0.5)])


def test_a_track_that_drifts_has_small_steps_and_one_that_leaps_has_one_that_no_robot_drives():
    assert smoothness(DRIFTS, TRUTH) == pytest.approx((0.99, 0.04))
    assert smoothness(LEAPS, TRUTH) == pytest.approx((np.hypot(1.0, 0.5), 0.5))
    assert describe_tracks({"map": LEAPS, "odom": DRIFTS}, TRUTH).splitlines() == [
        "map   largest step 1.118 m, worst error 0.500 m",
        "odom  largest step 0.990 m, worst error 0.040 m",
    ]


def test_tracks_are_told_apart_by_their_lines_too():
    ground, steps, errors = draw_tracks({"map": LEAPS, "odom": DRIFTS}, TRUTH, TIMES_S).figure.axes
    for axes in (steps, errors):
        assert len({line.get_linestyle() for line in axes.lines}) == 2
    assert [text.get_text() for text in ground.get_legend().get_texts()] == ["truth", "map", "odom"]


def test_what_cannot_be_drawn_is_said():
    for tracks, why in (
        ({}, "between one and 3 tracks"),
        ({"short": TRUTH[:3]}, "short has 3 samples, and there are 5"),
    ):
        with pytest.raises(ValueError, match=why):
            draw_tracks(tracks, TRUTH, TIMES_S)
