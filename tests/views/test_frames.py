"""A frame on paper: where its arrows go, and how they are told apart."""

import math

import numpy as np
import pytest

from tflab.core import Transform
from tflab.views import style
from tflab.views.frames import draw_arrow, draw_frames, draw_scene
from tflab.views.projection import FROM_ABOVE, eye_at


@pytest.fixture(name="ax")
def ax_fixture():
    ax = style.figure((4.0, 4.0)).add_axes((0, 0, 1, 1))
    ax.set(xlim=(-1, 3), ylim=(-1, 3))
    return ax


def place(line):
    return (float(line.get_xdata()[0]), float(line.get_ydata()[0]))


def test_from_above_it_is_as_on_a_map_from_the_front_left_is_right_and_directions_are_at_right_angles():
    assert FROM_ABOVE.on_paper((1.0, 2.0, 3.0)).tolist() == [1.0, 2.0]
    assert FROM_ABOVE.nearness((1.0, 2.0, 3.0)) == 3.0
    assert eye_at(0.0, 0.0).on_paper((5.0, 2.0, 3.0)) == pytest.approx([2.0, 3.0])
    eye = eye_at(math.radians(-125), math.radians(28))
    directions = np.array((eye.right, eye.up, eye.towards))
    assert directions @ directions.T == pytest.approx(np.eye(3))
    assert np.linalg.det(directions) == pytest.approx(1.0)


def test_an_arrow_points_along_its_axis_and_its_letter_stands_beyond_its_tip(ax):
    pose = Transform.from_rpy(yaw=math.pi / 2, translation=(1.0, 2.0, 0.0))
    drawn = draw_frames(ax, {"base_link": pose}, FROM_ABOVE, length_m=1.0)["base_link"]
    assert drawn.axes["x"].head.get_xy()[1] == pytest.approx((1.0, 3.0))  # the tip: x points up on paper
    assert drawn.axes["y"].head.get_xy()[1] == pytest.approx((0.0, 2.0))  # and y to the left
    assert place(drawn.axes["x"].letter) == pytest.approx((1.0, 3.15))


def test_letters_of_two_axes_that_point_the_same_way_stand_one_behind_the_other(ax):
    turned = Transform.from_rpy(roll=math.pi / 2)  # x stays, and y points out of the paper
    one, other = draw_frames(ax, {"one": Transform(), "other": turned}, FROM_ABOVE, length_m=1.0).values()
    assert place(one.axes["x"].letter) == pytest.approx((1.15, 0.0))
    assert place(other.axes["x"].letter) == pytest.approx((1.35, 0.0))


def test_an_axis_seen_end_on_is_a_dot_if_it_comes_out_of_the_paper_and_a_cross_if_it_goes_in(ax):
    up, down = Transform(), Transform.from_rpy(roll=math.pi)
    drawn = draw_frames(ax, {"up": up, "down": down}, FROM_ABOVE)
    assert [drawn[name].axes["z"].sign.get_marker() for name in ("up", "down")] == ["o", "x"]
    for frame in drawn.values():
        assert frame.axes["z"].ring.get_visible() and not frame.axes["z"].shaft.get_visible()
        assert frame.axes["x"].shaft.get_visible() and not frame.axes["x"].ring.get_visible()


def test_axes_are_told_apart_by_letter_colour_and_line(ax):
    drawn = draw_frames(ax, {"base_link": Transform()}, FROM_ABOVE)["base_link"]
    shafts = [drawn.axes[axis].shaft for axis in "xyz"]
    assert [shaft.get_color() for shaft in shafts] == ["#D55E00", "#009E73", "#0072B2"]
    assert len({str(shaft._unscaled_dash_pattern) for shaft in shafts}) == 3
    assert [drawn.axes[axis].letter.get_gid() for axis in "xyz"] == ["x", "y", "z"]
    ghost = draw_frames(ax, {"wrong": Transform()}, FROM_ABOVE, is_ghost=True)["wrong"]
    assert {ghost.axes[axis].shaft.get_color() for axis in "xyz"} == {style.GREY}
    assert ghost.label.text.get_fontstyle() == "italic"


def test_a_frame_moves_with_its_name_and_adds_nothing_to_the_axes(ax):
    drawn = draw_frames(ax, {"base_link": Transform((1.0, 2.0, 0.0))}, FROM_ABOVE)["base_link"]
    before = len(ax.get_children())
    assert drawn.label.text.xy == (1.0, 2.0)
    drawn.move(Transform((2.0, 0.5, 0.0)))
    assert drawn.label.text.xy == (2.0, 0.5)
    assert drawn.axes["x"].head.get_xy()[1] == pytest.approx((2.3, 0.5))
    assert len(ax.get_children()) == before


def test_what_is_nearer_covers_what_is_farther_and_nothing_covers_a_name(ax):
    heights = {"far": -500.0, "middle": 0.0, "near": 500.0}
    drawn = draw_frames(ax, {name: Transform((0.0, 0.0, z)) for name, z in heights.items()}, FROM_ABOVE)
    levels = [drawn[name].axes["x"].shaft.get_zorder() for name in heights]
    assert sorted(levels) == levels
    assert levels[0] > 0 and levels[2] < drawn["far"].label.text.get_zorder()


def test_names_keep_off_the_curve_that_is_drawn(ax):
    arrow = draw_arrow(ax, (0, 0, 0), (2, 0, 0), "", FROM_ABOVE, curve=-0.5)
    drawn = arrow.arrow.get_path().cleaned(curves=False).vertices  # the curve as short straight pieces
    corners = np.array([start for start, _ in arrow.label.keep_off])
    assert np.hypot(*(drawn - corners[2]).T).min() < 0.05
    assert corners[4] == pytest.approx((1.0, 0.5))  # the middle, half way out to the bend at 1 m


def test_a_scene_in_words():
    picture = draw_scene(
        {"base_link": Transform.from_rpy(yaw=math.pi / 2, translation=(1.0, 2.0, 0.0))},
        points={"corner": (3.0, -0.0, 0.5)},
        ghosts={"swapped": Transform((-2.0, 1.0, 0.0))},
        ghost_points={"corner, swapped": (0.0, 1.0, 0.5)},
    )
    assert picture.text == (
        "As seen from map:\n"
        "  frame base_link at (1.000, 2.000, 0.000) m, roll 0.000, pitch 0.000, yaw 1.571 rad\n"
        "  ghost swapped at (-2.000, 1.000, 0.000) m, roll 0.000, pitch 0.000, yaw 0.000 rad\n"
        "  point corner at (3.000, 0.000, 0.500) m\n"
        "  ghost point corner, swapped at (0.000, 1.000, 0.500) m"
    )


def test_an_arrow_is_written_in_its_frames_own_axes_and_drawn_where_that_frame_points():
    # base_link is turned to the left by a quarter: what it calls left is backwards on the map
    poses = {"map": Transform(), "base_link": Transform.from_rpy(yaw=math.pi / 2, translation=(2.0, 1.0, 0.0))}
    picture = draw_scene(poses, eye=FROM_ABOVE, length_m=0.5, arrows={"slide": ("base_link", (0.0, 0.2, 0.0))})
    (arrow,) = [patch for patch in picture.figure.axes[0].patches if hasattr(patch, "get_arrowstyle")]
    (tail, head) = arrow._posA_posB
    assert tuple(tail) == pytest.approx((2.0, 1.0)) and tuple(head) == pytest.approx((1.2, 1.0))
    assert picture.text.splitlines()[-1] == "  arrow slide in base_link: forward 0.000, left 0.200, up 0.000"
    with pytest.raises(ValueError, match='arrow "slide" is of "base", which has no pose; there is map'):
        draw_scene({"map": Transform()}, arrows={"slide": ("base", (0.0, 0.2, 0.0))})
