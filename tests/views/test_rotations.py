"""Drives from above, and two turns in two orders."""

import math

import pytest

from tflab.views.rotations import describe_drives, describe_orders, describe_turns, turn

QUARTER = math.pi / 2


def test_a_positive_yaw_rate_ends_on_the_left_and_a_negative_one_on_the_right():
    lines = describe_drives({"plus": 0.5, "none": 0.0, "minus": -0.5}, speed_mps=0.5, duration_s=math.pi)
    assert lines.splitlines()[1:] == [
        "  plus: to its left, ends at (1.000, 1.000) m, yaw 1.571 rad",
        "  none: straight on, ends at (1.571, 0.000) m, yaw 0.000 rad",
        "  minus: to its right, ends at (1.000, -1.000) m, yaw -1.571 rad",
    ]


def test_two_quarter_turns_end_differently_in_the_other_order():
    # Roll leaves the nose forward, yaw takes it left.  Yaw takes it left, roll takes left up.
    assert describe_orders(("roll", QUARTER), ("yaw", QUARTER)).splitlines()[1:] == [
        "  roll 1.571 rad, then yaw 1.571 rad: nose left, top forward",
        "  yaw 1.571 rad, then roll 1.571 rad: nose up, top right",
    ]


def test_a_direction_that_has_no_word_is_given_in_numbers_and_an_unknown_turn_is_refused():
    text = describe_orders(("yaw", math.pi / 4), ("roll", 0.0))
    assert "nose (0.707, 0.707, 0.000), top up" in text
    with pytest.raises(ValueError, match="no turn is called 'heading'; there are roll, pitch, yaw"):
        turn("heading", 0.1)


def test_two_quarter_turns_make_optical_axes_of_body_axes():
    assert describe_turns(("roll", -QUARTER), ("yaw", -QUARTER)).splitlines()[1:] == [
        "  start: x forward, y left, z up",
        "  first roll -1.571 rad: x forward, y down, z left",
        "  then yaw -1.571 rad: x right, y down, z forward",
    ]
