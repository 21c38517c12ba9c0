"""Points read in a wrong frame, by a swapped lookup, or with the rotation forgotten."""

import math

import numpy as np
import pytest

from tflab.core import Transform
from tflab.views.wrong_frames import describe_mount, draw_misread, draw_mount, seen_from

LASER_AT = (0.2, 0.0, 0.15)


def turned(yaw_rad, at=LASER_AT):
    return Transform.from_rpy(yaw=yaw_rad, translation=at)


def test_a_laser_that_looks_left_sees_the_corner_on_the_left():
    # 2 m along the laser's x is 2 m along the robot's y, from the laser's place on
    places = seen_from(turned(math.pi / 2), (2.0, 0.0, 0.0))
    assert places["corner"] == pytest.approx((0.2, 2.0, 0.15))
    assert places["rotation left out"] == pytest.approx((2.2, 0.0, 0.15))
    # swapped: undo the step first, (1.8, 0, -0.15), then turn right
    assert places["swapped"] == pytest.approx((0.0, -1.8, -0.15))


def test_a_mistake_can_hide_without_a_turn_the_forgotten_one_and_at_half_a_turn_the_swapped_lookup():
    places = seen_from(turned(0.0), (2.0, 0.5, 0.0))
    assert places["rotation left out"] == pytest.approx(places["corner"])
    places = seen_from(turned(math.pi), (2.0, 0.7, 0.0))
    assert places["swapped"][:2] == pytest.approx(places["corner"][:2])
    assert places["swapped"][2] == pytest.approx(-0.15)


def test_the_picture_in_words():
    assert describe_mount(math.pi / 2) == (
        "laser_frame at (0.200, 0.000, 0.150) m in base_link, yaw 1.57 rad\n"
        "the laser measures (2.000, 0.000, 0.000) m  in laser_frame\n"
        "the corner is at   (0.200, 2.000, 0.150) m  in base_link\n"
        "swapped:           (0.000, -1.800, -0.150) m  off by 3.817 m  (laser_T_base.apply(laser_p))\n"
        "rotation left out: (2.200, 0.000, 0.150) m  off by 2.828 m  (laser_p + translation)"
    )


@pytest.mark.parametrize("yaw_rad", [-math.pi, -1.0, 0.7])
def test_points_stay_in_the_picture_for_any_yaw(yaw_rad):
    picture = draw_mount(yaw_rad)
    low, high = picture.figure.axes[0].get_xlim()
    for x, y, _ in seen_from(turned(yaw_rad), (2.0, 0.0, 0.0)).values():
        assert low < x < high and low < y < high


def test_a_mistake_that_hides_behind_the_truth_is_a_ring_around_it():
    picture = draw_mount(math.pi)
    assert picture.points["swapped"].mark.get_markersize() > picture.points["corner"].mark.get_markersize()
    assert picture.points["swapped"].mark.get_zorder() < picture.points["corner"].mark.get_zorder()


WALL = np.array([(2.0, -1.0, 0.0), (2.0, 1.0, 1.5)])


def test_both_readings_are_in_the_words_and_the_picture_fits_on_a_page():
    picture = draw_misread({"wall": WALL}, {"wall": WALL[:, [1, 2, 0]]}, ("as it is", "as misread"))
    assert picture.text == (
        "as it is. In base_link:\n  wall: x 2.000 m, y -1.000 to 1.000 m, z 0.000 to 1.500 m\n"
        "as misread. In base_link:\n  wall: x -1.000 to 1.000 m, y 0.000 to 1.500 m, z 2.000 m"
    )
    assert len(picture.png()) < 60_000
    assert draw_misread({"wall": WALL}, {}, ("all", "none")).text.endswith("none. In base_link:")
