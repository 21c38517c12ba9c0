"""The card for the pocket."""

import math

import pytest

from tflab.core import Transform
from tflab.views.axes import draw_card


def test_the_card_names_both_conventions_and_the_turn_between_them():
    text = draw_card().text
    assert "base_link, camera_link: x forward, y left, z up" in text
    assert "..._optical_frame: x right, y down, z forward" in text
    assert "xyzw  (-0.5, 0.5, -0.5, 0.5)" in text


def test_what_the_card_says_of_the_optical_turn_is_true():
    assert Transform.from_rpy(-math.pi / 2, 0.0, -math.pi / 2).rotation == pytest.approx((-0.5, 0.5, -0.5, 0.5))


def test_what_the_card_says_of_positive_turns_is_true():
    quarter = math.pi / 2
    assert Transform.from_rpy(roll=quarter).apply((0, 1, 0)) == pytest.approx((0, 0, 1))  # left side up
    assert Transform.from_rpy(pitch=quarter).apply((1, 0, 0)) == pytest.approx((0, 0, -1))  # nose down
    assert Transform.from_rpy(yaw=quarter).apply((1, 0, 0)) == pytest.approx((0, 1, 0))  # nose left


def test_the_card_fits_on_a_page():
    assert len(draw_card().png()) < 60_000
