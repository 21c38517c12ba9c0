"""Errors of a moving robot: by latency, and between two samples."""

import math

import numpy as np
import pytest

from tflab.core import seconds
from tflab.views.motion_error import (
    Bend,
    Sight,
    describe_latency,
    draw_bend,
    draw_latency,
    drive,
    gap_m,
    largest_chord_gap,
    latency_error,
    wait_s,
)
from tflab.views.panels import rate_panel


def test_a_robot_drives_straight_or_along_an_arc_of_a_circle():
    straight = drive(1.0, 0.0, seconds(0.2))
    assert straight.translation == pytest.approx((0.2, 0.0, 0.0))
    assert straight.rpy() == pytest.approx((0.0, 0.0, 0.0))
    # a quarter of a circle of radius 2 m, to the left: 2 m ahead and 2 m to the left
    arc = drive(math.pi, math.pi / 2, seconds(1.0))
    assert arc.translation == pytest.approx((2.0, 2.0, 0.0))
    assert arc.rpy() == pytest.approx((0.0, 0.0, math.pi / 2))


def test_the_error_splits_into_speed_and_turn_and_the_exact_one_is_that_of_the_arc():
    # 1 m/s x 0.2 s = 0.2 m; 5 m x 0.5 rad/s x 0.2 s = 0.5 m; together sqrt(0.04 + 0.25)
    error = latency_error(Sight(speed_mps=1.0, yaw_rate_radps=0.5, range_m=5.0, delay_ns=seconds(0.2)))
    assert error.forwards_m == pytest.approx(0.2)
    assert error.sideways_m == pytest.approx(0.5)
    assert error.approximate_m == pytest.approx(0.53852, abs=1e-5)
    # radius 2 m, turned 0.1 rad: (2 sin 0.1, 2 - 2 cos 0.1) + 5 (cos 0.1 - 1, sin 0.1)
    assert error.exact == pytest.approx((0.174688, 0.509159, 0.0), abs=1e-6)
    assert error.exact_m == pytest.approx(0.538293, abs=1e-6)
    assert error.drawn_at == pytest.approx((5.174688, 0.509159, 0.0), abs=1e-6)
    to_the_right = latency_error(Sight(0.0, -0.5, 4.0, seconds(0.1)))
    assert to_the_right.sideways_m == pytest.approx(-0.2) and to_the_right.exact[1] < 0.0
    assert latency_error(Sight(3.0, 1.0, 10.0, 0)).exact_m == 0.0


def test_the_pieces_are_good_only_while_the_robot_turns_little():
    # half a turn at 1 m: the object is drawn 2 m away, on the other side; the piece says pi
    error = latency_error(Sight(0.0, math.pi, 1.0, seconds(1.0)))
    assert error.exact_m == pytest.approx(2.0)
    assert error.sideways_m == pytest.approx(math.pi)


def test_latency_in_words():
    assert describe_latency(Sight(1.0, 0.5, 5.0, seconds(0.2))) == (
        "A robot drives 1.000 m/s and turns 0.500 rad/s.\n"
        "It sees an object 5.000 m ahead and uses the detection 0.200 s after its stamp.\n"
        "  at the stamp, the truth      (5.000, 0.000) m\n"
        "  at now, the wrong answer     (5.175, 0.509) m\n"
        "  error, exactly               0.538 m\n"
        "  speed x delay                0.200 m  forwards, approximately\n"
        "  range x yaw rate x delay     0.500 m  to the left, approximately\n"
        "  both together                0.539 m  approximately"
    )


@pytest.mark.parametrize("sight", [Sight(3.0, 1.0, 10.0, seconds(0.5)), Sight(0.0, -1.0, 1.0, 0), Sight(0, 0, 10, 0)])
def test_any_sight_that_a_slider_can_choose_stays_in_the_picture(sight):
    picture = draw_latency(sight)
    error = latency_error(sight)
    x0, x1 = picture.figure.axes[0].get_xlim()
    y0, y1 = picture.figure.axes[0].get_ylim()
    assert x0 < error.drawn_at[0] < x1 and y0 < error.drawn_at[1] < y1


def test_the_gap_in_a_bend_of_half_a_metre_radius():
    # (0.5 / 1) (1 - cos(1 / 2f)): 0.5 * 0.122417 = 0.061209 at 1 Hz
    for rate_hz, gap_mm in ((1.0, 61.21), (2.0, 15.54), (10.0, 0.62), (20.0, 0.16)):
        for yaw_rate in (1.0, -1.0):
            assert 1000 * gap_m(Bend(0.5, yaw_rate, rate_hz)) == pytest.approx(gap_mm, abs=0.005)
    assert gap_m(Bend(2.0, 0.0, 1.0)) == 0.0


def test_a_scan_waits_a_period_less_its_own_way_and_never_less_than_nothing():
    assert wait_s(Bend(rate_hz=1.0)) == pytest.approx(0.899)
    assert wait_s(Bend(rate_hz=20.0)) == 0.0


def test_the_words_say_the_three_numbers_and_the_panel_passes_its_sliders_on():
    assert draw_bend(Bend(0.5, 1.0, 1.0)).text.splitlines() == [
        "between two samples 0.500 m driven, 1.000 rad turned",
        "gap between arc and chord 61.21 mm at worst",
        "wait 0.899 s at worst",
    ]
    panel = rate_panel()
    panel.controls["rate [Hz]"].value = 1.0
    assert "61.21 mm" in panel.text
    panel.controls["yaw rate [rad/s]"].value = 0.0
    assert "0.00 mm" in panel.text
    panel.close()


@pytest.mark.parametrize("turn", [0.0, 0.5, -1.5, 3.0])
def test_the_arc_bulges_to_the_outside_of_the_turn_and_the_card_is_as_high_as_it(turn):
    picture = draw_bend(Bend(0.5, turn, 1.0))
    arc = np.column_stack(picture._arc.get_data())
    assert arc[[0, -1]] == pytest.approx(np.array([(-0.5, 0.0), (0.5, 0.0)]), abs=1e-9)  # on the chord
    assert np.sign(round(arc[30, 1], 9)) == -np.sign(turn)
    low, high = picture.ax.get_ylim()
    assert low < arc[:, 1].min() and arc[:, 1].max() < high
    assert np.abs(arc[:, 1]).max() == pytest.approx(largest_chord_gap(turn), abs=1e-9)
    across, up = 1.24 / picture.ax.bbox.width, (high - low) / picture.ax.bbox.height
    assert across == pytest.approx(up)  # a circle is drawn round
