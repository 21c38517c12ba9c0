"""Products of transforms as dominoes, and an arm as a chain of joints."""

import math
from itertools import pairwise

import pytest

from tflab.core import Transform
from tflab.views.transform_chain import (
    Step,
    describe_dominoes,
    describe_joints,
    draw_dominoes,
    draw_joints,
    mismatches,
    poses_along,
)


def words_in(picture):
    return [text.get_text() for text in picture.figure.axes[0].texts]


def test_a_row_that_fits_comes_down_to_its_two_ends():
    tiles = [("map", "odom"), ("odom", "base_link"), ("base_link", "laser_frame")]
    assert describe_dominoes(tiles) == (
        "[map|odom][odom|base_link][base_link|laser_frame]\n"
        "map_T_odom @ odom_T_base_link @ base_link_T_laser_frame\n"
        "fits: map_T_laser_frame"
    )
    words = words_in(draw_dominoes(*tiles))
    assert words[-2:] == ["map", "laser_frame"] and "≠" not in words


def test_a_row_in_the_wrong_order_says_which_halves_do_not_match():
    tiles = [("odom", "base_link"), ("map", "odom")]
    assert mismatches(tiles) == [0]
    assert describe_dominoes(tiles).endswith("does not fit: base_link is not map")
    words = words_in(draw_dominoes(("map", "odom"), ("base_link", "laser_frame"), ("odom", "base_link")))
    assert words.count("≠") == 2
    assert "odom is not base_link, laser_frame is not odom" in words
    with pytest.raises(ValueError, match="needs at least one, such as"):
        draw_dominoes()


def test_a_long_row_stays_on_the_card():
    names = ["map", "odom", "base_footprint", "base_link", "camera_link", "camera_optical_frame"]
    picture = draw_dominoes(*pairwise(names))
    ax = picture.figure.axes[0]
    assert all(0 < text.get_position()[0] < ax.get_xlim()[1] for text in ax.texts)
    assert picture.png() == draw_dominoes(*pairwise(names)).png()


UP = Transform((0.0, 0.0, 1.0))
AHEAD = Transform((2.0, 0.0, 0.0))


def arm(turn_rad):
    """A post of 1 m; on it a joint that nods by `turn_rad`; and at its end, 2 m ahead, a tool."""
    nods = Transform.from_rpy(pitch=turn_rad, translation=(0.0, 0.0, 1.0))
    return [
        Step("neck", "base", "arm", nods, turn_rad, "rad", '<joint name="neck"/>'),
        Step("weld", "arm", "tool", AHEAD),
    ]


def test_the_words_say_where_the_tip_is_and_what_each_joint_does():
    assert describe_joints(arm(0.0), "neck", {"forgotten": (0.0, 0.0, 3.0)}).splitlines() == [
        "tool in base: (2.000, 0.000, 1.000) m",
        "forgotten (ghost) at (0.000, 0.000, 3.000) m",
        "  neck    0.00 rad  base_T_arm: (0.000, 0.000, 1.000) m, rpy (0.000, 0.000, 0.000) rad",
        "  weld       fixed  arm_T_tool: (2.000, 0.000, 0.000) m, rpy (0.000, 0.000, 0.000) rad",
        '<joint name="neck"/>',
    ]


def test_a_joint_that_moves_has_a_hinge_and_the_touched_one_a_thick_edge():
    picture = draw_joints(arm(0.5), "neck")
    row = picture.figure.axes[-1]
    rings = [line for line in row.lines if line.get_marker() == "o"]
    assert len(rings) == 1
    edges = [patch for patch in row.patches if patch.get_linewidth() > 2.0]
    assert [edge.get_visible() for edge in edges] == [True, False]


def test_the_tip_is_the_same_from_above_and_from_the_side():
    # a quarter turn about y brings what was ahead down: the tool is 2 m below the neck
    assert poses_along(arm(math.pi / 2))["tool"].translation == pytest.approx((0.0, 0.0, -1.0))
    above, side, _ = draw_joints(arm(-math.pi / 2)).figure.axes
    # it points straight up now: over the neck, at 3 m
    for axes, place in ((above, (0.0, 0.0)), (side, (0.0, 3.0))):
        tips = [tuple(line.get_data()) for line in axes.lines if line.get_markersize() == 8.0]
        assert [[float(x[0]), float(y[0])] for x, y in tips] == [pytest.approx(place)]


def test_a_chain_that_does_not_hang_together_is_refused():
    loose = [Step("a", "base", "arm", UP), Step("b", "wrist", "tool", AHEAD)]
    with pytest.raises(ValueError, match='joint "b" hangs on "wrist", and before it comes "arm"'):
        draw_joints(loose)
    with pytest.raises(ValueError, match="at least one joint"):
        draw_joints([])
