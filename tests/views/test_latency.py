"""What it costs to use the robot's pose of now for a sight of then."""

import math

import pytest

from tflab.core import seconds
from tflab.views.motion_error import Sight, describe_latency, draw_latency, drive, latency_error


def test_a_robot_that_does_not_turn_drives_straight():
    then_T_now = drive(1.0, 0.0, seconds(0.2))
    assert then_T_now.translation == pytest.approx((0.2, 0.0, 0.0))
    assert then_T_now.rpy() == pytest.approx((0.0, 0.0, 0.0))


def test_a_robot_that_turns_drives_an_arc_of_a_circle():
    # a quarter of a circle of radius 2 m, to the left: 2 m ahead and 2 m to the left
    then_T_now = drive(math.pi, math.pi / 2, seconds(1.0))
    assert then_T_now.translation == pytest.approx((2.0, 2.0, 0.0))
    assert then_T_now.rpy() == pytest.approx((0.0, 0.0, math.pi / 2))


def test_the_error_splits_into_speed_and_turn():
    # 1 m/s x 0.2 s = 0.2 m; 5 m x 0.5 rad/s x 0.2 s = 0.5 m; together sqrt(0.04 + 0.25)
    error = latency_error(Sight(speed_mps=1.0, yaw_rate_radps=0.5, range_m=5.0, delay_ns=seconds(0.2)))
    assert error.forwards_m == pytest.approx(0.2)
    assert error.sideways_m == pytest.approx(0.5)
    assert error.approximate_m == pytest.approx(0.53852, abs=1e-5)


def test_the_exact_error_is_that_of_the_arc():
    # radius 2 m, turned 0.1 rad: (2 sin 0.1, 2 - 2 cos 0.1) + 5 (cos 0.1 - 1, sin 0.1)
    error = latency_error(Sight(1.0, 0.5, 5.0, seconds(0.2)))
    assert error.exact == pytest.approx((0.174688, 0.509159, 0.0), abs=1e-6)
    assert error.exact_m == pytest.approx(0.538293, abs=1e-6)
    assert error.drawn_at == pytest.approx((5.174688, 0.509159, 0.0), abs=1e-6)


def test_no_delay_means_no_error():
    assert latency_error(Sight(3.0, 1.0, 10.0, 0)).exact_m == 0.0


def test_turning_right_moves_the_object_to_the_right():
    error = latency_error(Sight(0.0, -0.5, 4.0, seconds(0.1)))
    assert error.sideways_m == pytest.approx(-0.2)
    assert error.exact[1] < 0.0


def test_the_pieces_are_good_only_while_the_robot_turns_little():
    # half a turn at 1 m: the object is drawn 2 m away, on the other side; the piece says pi
    error = latency_error(Sight(0.0, math.pi, 1.0, seconds(1.0)))
    assert error.exact_m == pytest.approx(2.0)
    assert error.sideways_m == pytest.approx(math.pi)


def test_latency_in_words():
    assert describe_latency(Sight(1.0, 0.5, 5.0, seconds(0.2))) == (
        "A robot drives 1.000 m/s and turns 0.500 rad/s.\n"
        "It sees an object 5.000 m ahead and uses the sight 0.200 s after its stamp.\n"
        "  at the stamp, the truth      (5.000, 0.000) m\n"
        "  at now, the wrong answer     (5.175, 0.509) m\n"
        "  error, exactly               0.538 m\n"
        "  speed x delay                0.200 m  forwards, approximately\n"
        "  range x yaw rate x delay     0.500 m  to the left, approximately\n"
        "  both together                0.539 m  approximately"
    )


def test_the_picture_says_which_number_is_exact_and_which_is_not():
    picture = draw_latency(Sight(1.0, 0.5, 5.0, seconds(0.2)))
    words = [text.get_text() for text in picture.figure.findobj(match=lambda a: hasattr(a, "get_text"))]
    assert "exactly\n0.538 m" in words
    assert "speed × delay\n≈ 0.200 m" in words
    assert "range × yaw rate × delay\n≈ 0.500 m" in words


@pytest.mark.parametrize("sight", [Sight(3.0, 1.0, 10.0, seconds(0.5)), Sight(0.0, -1.0, 1.0, 0), Sight(0, 0, 10, 0)])
def test_any_sight_that_a_slider_can_choose_stays_in_the_picture(sight):
    picture = draw_latency(sight)
    error = latency_error(sight)
    x0, x1 = picture.figure.axes[0].get_xlim()
    y0, y1 = picture.figure.axes[0].get_ylim()
    assert x0 < error.drawn_at[0] < x1 and y0 < error.drawn_at[1] < y1
