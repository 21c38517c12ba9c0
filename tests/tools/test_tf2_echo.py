"""What tf2_echo prints of one reading: to the letter."""

import math
from pathlib import Path

import pytest
import yaml

from tflab.core import StampedTransform, Transform
from tflab.core.quaternions import from_rpy, to_matrix
from tflab.tools.tf2_echo import USAGE, echo_text, failure_text, main, rpy_from_matrix

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))


def test_a_reading_with_a_turn_to_the_right():
    rotation = (0.0, 0.0, math.sin(1.536), -math.cos(1.536))  # half of 3.072 rad
    turned = StampedTransform("map", "base_link", 1714913843_708748879, Transform((4.541, 3.889, 0.0), rotation))
    lines = echo_text(turned).splitlines()
    assert lines == CASES["reading"]


def test_five_milliseconds_are_printed_without_leading_zeros_and_newer_builds_name_the_order_of_the_quaternion():
    text = echo_text(StampedTransform("a", "b", 12_005_000_000, Transform()), names_quaternion_order=True)
    assert text.startswith("At time 12.5000000\n")
    assert "- Rotation: in Quaternion (xyzw) [0.000, 0.000, 0.000, 1.000]" in text


@pytest.mark.parametrize("rpy", [(0.1, 0.2, 0.3), (-1.0, 1.2, 3.0), (3.0, -1.5, -3.0)])
def test_the_angles_come_back(rpy):
    assert rpy_from_matrix(to_matrix(from_rpy(*rpy))) == pytest.approx(rpy)


def test_looking_straight_down_or_up_yaw_is_zero():
    assert rpy_from_matrix(((0, 0, 1), (0, 1, 0), (-1, 0, 0))) == (0.0, math.pi / 2, 0.0)
    assert rpy_from_matrix(((0, 0, -1), (0, 1, 0), (1, 0, 0))) == (0.0, -math.pi / 2, 0.0)


def test_a_failure_lists_the_frames():
    frames = "Frame base_link exists with parent odom.\n"
    assert failure_text(12.345, "no way", frames) == (
        "Failure at 12.345\nException thrown:no way\nThe current list of frames is:\n" + frames
    )


def test_two_or_three_arguments_or_the_usage(capsys):
    assert main(["map"]) == 1
    assert capsys.readouterr().out == USAGE + "\n"
    assert USAGE.splitlines()[3] == "to the coordinate frame of the target_frame. "


def test_a_rate_must_be_a_positive_number(capsys):
    for rate, code in (("foo", 2), ("1.0foo", 3)):
        assert main(["map", "odom", rate]) == code
        assert capsys.readouterr().err == f"Failed to convert rate argument '{rate}' to a floating-point number\n"
    assert main(["map", "odom", "0"]) == -6
    assert "what():  rate must be greater than 0" in capsys.readouterr().err
