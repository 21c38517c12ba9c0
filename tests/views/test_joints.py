"""An arm as a row of dominoes: where its tip is, which of them move, and what its file says."""

import math

import pytest

from tflab.core import Transform
from tflab.views.transform_chain import Step, describe_joints, draw_joints, poses_along

UP = Transform((0.0, 0.0, 1.0))
AHEAD = Transform((2.0, 0.0, 0.0))


def arm(turn_rad):
    """A post of 1 m; on it a joint that nods by `turn_rad`; and at its end, 2 m ahead, a tool."""
    nods = Transform.from_rpy(pitch=turn_rad, translation=(0.0, 0.0, 1.0))
    return [
        Step("neck", "base", "arm", nods, turn_rad, "rad", '<joint name="neck"/>'),
        Step("weld", "arm", "tool", AHEAD),
    ]


def test_the_tip_is_the_product_of_the_dominoes():
    # a quarter turn about y brings what was ahead down: the tool is 2 m below the neck
    assert poses_along(arm(math.pi / 2))["tool"].translation == pytest.approx((0.0, 0.0, -1.0))


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


def test_the_picture_is_small_and_the_same_bytes_every_time():
    first, again = (draw_joints(arm(0.3), "neck", {"wrong": (1.0, 1.0, 1.0)}).png() for _ in range(2))
    assert first == again
    assert len(first) < 60_000
