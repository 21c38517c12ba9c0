"""Axes of bodies and cameras, rotations, and the card of conventions."""

import math

import pytest

from tflab.views.axes import (
    BODY_T_OPTICAL,
    FROM_BEHIND,
    draw_body_axes,
    draw_cameras,
    draw_card,
    draw_right_hand,
    draw_rotation,
    optical_from_body,
    pixel_from_optical,
)


def test_optical_axes_are_right_down_forward():
    assert BODY_T_OPTICAL.rotation == pytest.approx((-0.5, 0.5, -0.5, 0.5))
    for body_p, optical_p in (
        ((2.0, 0.0, 0.0), (0.0, 0.0, 2.0)),
        ((0.0, 1.0, 0.0), (-1.0, 0.0, 0.0)),  # left is minus right
        ((0.0, 0.0, 1.0), (0.0, -1.0, 0.0)),  # up is minus down
    ):
        assert optical_from_body(body_p) == pytest.approx(optical_p, abs=1e-12)


def test_what_is_right_and_below_is_so_in_the_picture_and_what_is_behind_or_aside_is_not_in_it():
    assert pixel_from_optical((0.0, 0.0, 2.0)) == (0.0, 0.0)
    assert pixel_from_optical((0.4, 0.2, 2.0)) == pytest.approx((0.2, 0.1))
    for optical_p in ((0.0, 0.0, -1.0), (0.0, 0.0, 0.0), (2.0, 0.0, 2.0), (0.0, -1.0, 2.0)):
        assert pixel_from_optical(optical_p) is None
    assert FROM_BEHIND.on_paper((5.0, 1.0, 2.0)).tolist() == [-1.0, 2.0]  # left is left, and up is up


def test_both_cameras_see_the_same_and_write_it_differently():
    picture = draw_cameras((2.0, 0.5, 0.3))
    assert picture.text == (
        "One point, one camera, two frames:\n"
        "  in camera_link           (2.000, 0.500, 0.300) m  x forward, y left, z up\n"
        "  in camera_optical_frame  (-0.500, -0.300, 2.000) m  x right, y down, z forward\n"
        "  it is seen 0.250 left of and 0.150 above the middle of the picture, per metre of depth"
    )
    dots = [(float(side.dot.get_xdata()[0]), float(side.dot.get_ydata()[0])) for side in picture.sides]
    assert dots == [pytest.approx((-0.25, 0.15))] * 2
    assert [side.numbers.get_text() for side in picture.sides] == [
        "(2.000, 0.500, 0.300) m",
        "(-0.500, -0.300, 2.000) m",
    ]


def test_a_point_that_leaves_the_picture_loses_its_dot_and_may_come_back():
    picture = draw_cameras((2.0, 1.9, 0.0))
    assert not any(side.dot.get_visible() for side in picture.sides)
    assert picture.text.endswith("it is not in the picture")
    picture.show((2.0, 0.0, 0.0))
    assert all(side.dot.get_visible() for side in picture.sides)
    assert picture.text.endswith("it is seen in the middle of the picture")


def test_a_rotation_in_words():
    assert draw_rotation(0.0, 0.0, math.pi / 2).text == (
        "roll, pitch, yaw (0.000, 0.000, 1.571) rad\n"
        "quaternion (x, y, z, w) (0.000, 0.000, 0.707, 0.707)\n"
        "matrix\n"
        "    0.000  -1.000   0.000\n"
        "    1.000   0.000   0.000\n"
        "    0.000   0.000   1.000"
    )


def test_roll_pitch_yaw_turn_about_the_fixed_axes_in_that_order():
    # first roll a quarter, then yaw a quarter: y goes up to z and stays; x goes to y
    frame, fixed = draw_rotation(math.pi / 2, 0.0, math.pi / 2).frame, draw_rotation().frame
    for turned, at in (("y", "z"), ("x", "y")):
        assert frame.axes[turned].head.get_xy()[1] == pytest.approx(fixed.axes[at].head.get_xy()[1])


def test_the_words_at_the_axes_and_on_the_card_are_those_of_rep_103():
    words = {text.get_text() for text in draw_body_axes().figure.axes[0].texts}
    assert {"forward", "left", "up", "base_link"} <= words
    text = draw_card().text
    assert "base_link, camera_link: x forward, y left, z up" in text
    assert "..._optical_frame: x right, y down, z forward" in text
    assert "xyzw  (-0.5, 0.5, -0.5, 0.5)" in text


def test_the_right_hand_has_one_curl_for_each_turn():
    picture = draw_right_hand()
    assert "nose goes down" in picture.text and "left side goes up" in picture.text
    assert [ax.texts[-1].get_text() for ax in picture.figure.axes] == [
        "roll: about x",
        "pitch: about y",
        "yaw: about z",
    ]
    # each arrow ends near the axis that the right hand reaches: z, then x, then y
    for ax, (axis, end) in zip(picture.figure.axes, (("x", "z"), ("y", "x"), ("z", "y")), strict=True):
        arc = next(patch for patch in ax.patches if hasattr(patch, "get_arrowstyle"))
        letters = {line.get_gid(): line.get_xydata()[0] for line in ax.lines if line.get_gid()}
        last = arc._path_original.vertices[-1]
        apart = {name: float(((place / 1.15 - last) ** 2).sum()) for name, place in letters.items() if name != axis}
        assert min(apart, key=apart.get) == end
