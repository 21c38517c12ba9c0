"""Between two samples of a bend: the gap of chord and arc, and how long one waits."""

import numpy as np
import pytest

from tflab.views.motion_error import Bend, deepest, draw_bend, gap_m, wait_s
from tflab.views.panels import rate_panel


@pytest.mark.parametrize(("rate_hz", "gap_mm"), [(1.0, 61.21), (2.0, 15.54), (10.0, 0.62), (20.0, 0.16)])
def test_the_gap_in_a_bend_of_half_a_metre_radius(rate_hz, gap_mm):
    # (0.5 / 1) (1 - cos(1 / 2f)): 0.5 * 0.122417 = 0.061209 at 1 Hz
    assert 1000 * gap_m(Bend(0.5, 1.0, rate_hz)) == pytest.approx(gap_mm, abs=0.005)


def test_straight_ahead_nothing_is_missed_at_any_rate():
    assert gap_m(Bend(2.0, 0.0, 1.0)) == 0.0


def test_to_the_right_the_gap_is_as_large_as_to_the_left():
    assert gap_m(Bend(0.5, -1.0, 2.0)) == gap_m(Bend(0.5, 1.0, 2.0)) > 0


def test_a_scan_waits_a_period_less_its_own_way_and_never_less_than_nothing():
    assert wait_s(Bend(rate_hz=1.0)) == pytest.approx(0.899)
    assert wait_s(Bend(rate_hz=20.0)) == 0.0


def test_the_words_say_the_three_numbers():
    assert draw_bend(Bend(0.5, 1.0, 1.0)).text.splitlines() == [
        "between two samples 0.500 m driven, 1.000 rad turned",
        "gap between arc and chord 61.21 mm at worst",
        "wait 0.899 s at worst",
    ]


@pytest.mark.parametrize("yaw_rate", [1.0, -1.0, 0.0])
def test_the_arc_bulges_to_the_outside_of_the_turn_and_begins_and_ends_on_the_chord(yaw_rate):
    arc = np.column_stack(draw_bend(Bend(0.5, yaw_rate, 1.0))._arc.get_data())
    assert arc[[0, -1]] == pytest.approx(np.array([(-0.5, 0.0), (0.5, 0.0)]), abs=1e-9)
    assert np.sign(round(arc[30, 1], 9)) == -np.sign(yaw_rate)


def test_the_panel_follows_its_sliders():
    panel = rate_panel()
    panel.controls["rate [Hz]"].value = 1.0
    assert "61.21 mm" in panel.text
    panel.controls["yaw rate [rad/s]"].value = 0.0
    assert "0.00 mm" in panel.text
    panel.close()


@pytest.mark.parametrize("turn", [0.0, 0.5, -1.5, 3.0])
def test_the_card_is_as_high_as_the_arc_and_nothing_is_cut(turn):
    picture = draw_bend(Bend(0.5, turn, 1.0))
    low, high = picture.ax.get_ylim()
    heights = picture._arc.get_ydata()
    assert low < heights.min() and heights.max() < high
    assert np.abs(heights).max() == pytest.approx(deepest(turn), abs=1e-9)
    across, up = 1.24 / picture.ax.bbox.width, (high - low) / picture.ax.bbox.height
    assert across == pytest.approx(up)  # a circle is drawn round
