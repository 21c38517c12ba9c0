"""What static_transform_publisher makes of its arguments, and says: to the letter."""

import math

import pytest

from tflab.tools.cpp_numbers import general, stod
from tflab.tools.static_transform_publisher import OLD_STYLE, USAGE, Request, UsageError, parse

NAMES = ["--frame-id", "base_link", "--child-frame-id", "laser_frame"]


def fault(words):
    with pytest.raises(UsageError) as caught:
        parse(words)
    return str(caught.value)


def test_named_arguments_in_any_order():
    words = ["--child-frame-id", "laser_frame", "--z", "0.15", "--x", "0.20", "--frame-id", "base_link"]
    assert parse(words) == Request((0.20, 0.0, 0.15), (0.0, 0.0, 0.0, 1.0), "base_link", "laser_frame")
    assert parse(NAMES) == Request((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), "base_link", "laser_frame")
    assert parse(["--x", "-0.5", "--y", "1abc", *NAMES]).translation == (-0.5, 1.0, 0.0)
    half = math.sqrt(0.5)
    assert parse(["--yaw", str(math.pi / 2), *NAMES]).rotation == pytest.approx((0.0, 0.0, half, half))
    zeros = ["--qx", "0", "--qy", "0", "--qz", "0", "--qw", "0", *NAMES]
    assert parse(zeros).rotation == (0.0, 0.0, 0.0, 0.0)  # as it is
    assert parse(["--qz", "1", *NAMES]).rotation == (0.0, 0.0, 1.0, 1.0)


def test_eight_bare_arguments_are_yaw_first_and_deprecated():
    said = []
    request = parse(["1", "2", "3", str(math.pi), "0", "0", "map", "odom"], warn=said.append)
    assert request.translation == (1.0, 2.0, 3.0)
    assert request.rotation == pytest.approx((0.0, 0.0, 1.0, 0.0), abs=1e-15)
    assert (request.frame_id, request.child_frame_id) == ("map", "odom")
    assert said == [OLD_STYLE] == ["Old-style arguments are deprecated; see --help for new-style arguments"]
    request = parse(["1", "2", "3", "0", "0", "0", "1", "map", "odom"])  # nine: a quaternion
    assert request == Request((1.0, 2.0, 3.0), (0.0, 0.0, 0.0, 1.0), "map", "odom")


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["--x"], "Not enough arguments for --x"),
        ([*NAMES, "--yaw"], "Not enough arguments for --yaw"),
        (["--x", "abc", "--y"], "Failed to parse --x argument as float"),
        (["--yaw", "1", "--qz", "1", *NAMES], "Cannot specify both quaternion and Euler rotations"),
        (["--x", "1", *["1", "2", "3", "0", "0", "0", "map", "odom"]],
         "Cannot specify both new-style (flags) and old-style (arguments)"),
        (["--x=1", *NAMES], "Extra unparsed arguments on command-line"),
        ([], "Frame id must not be empty"),
        (["--frame-id", "", "--child-frame-id", "odom"], "Frame id must not be empty"),
        (["a", "2", "3", "0", "0", "0", "map", "odom"], "Failed to parse x argument as float"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said_in_upstreams_words(words, text):
    assert fault(words) == text


def test_help_wins_over_what_is_missing():
    assert parse(["-h"]).help
    assert parse(["--x", "1", "--help"]).help
    assert USAGE.startswith("usage: static_transform_publisher [--x X] [--y Y] [--z Z] [--qx QX] ")
    assert USAGE.splitlines()[2] == "A command line utility for manually sending a static transform."


@pytest.mark.parametrize(
    ("text", "number", "is_all"),
    [("1.0", 1.0, True), ("1abc", 1.0, False), (" -2e1x", -20.0, False), (".5", 0.5, True), ("5.", 5.0, True),
     ("0x10", 16.0, True), ("1e", 1.0, False), ("infx", math.inf, False)],
)  # fmt: skip
def test_a_number_is_read_as_far_as_it_goes(text, number, is_all):
    assert stod(text) == (number, is_all)


def test_what_does_not_begin_with_a_number_is_none():
    with pytest.raises(ValueError, match="no number"):
        stod("abc")


@pytest.mark.parametrize(
    ("value", "text"), [(0.000334, "0.000334"), (1e8, "1e+08"), (20.0512, "20.0512"), (0.0, "0"), (812.8564, "812.856")]
)
def test_a_number_is_printed_as_cout_prints_it(value, text):
    assert general(value) == text
