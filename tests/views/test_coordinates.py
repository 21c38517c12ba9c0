"""One point in the coordinates of several frames, and of a robot at several times."""

import math

import numpy as np
import pytest

from tflab.core import Transform
from tflab.views.coordinates import beside, describe_moments, describe_rulers, draw_moments, draw_rulers, readings_of
from tflab.views.panels import rulers_panel

# map --(6.2, -1.7, 0.10)--> base_link --(0.20, 0, 0.15)--> laser_frame, and a thing 2 m ahead of the laser
MAP_T_BASE = Transform(translation=(6.2, -1.7, 0.10))
POSES = {
    "map": Transform(),
    "base_link": MAP_T_BASE,
    "laser_frame": MAP_T_BASE @ Transform(translation=(0.20, 0, 0.15)),
}
THING = (8.4, -1.7, 0.25)


def test_each_frame_has_its_own_three_numbers_for_one_thing():
    readings = readings_of(POSES, THING)
    assert readings["map"] == pytest.approx((8.4, -1.7, 0.25))
    assert readings["base_link"] == pytest.approx((2.2, 0.0, 0.15))
    assert readings["laser_frame"] == pytest.approx((2.0, 0.0, 0.0))


def test_the_same_three_numbers_lead_to_another_position_in_each_frame():
    places = {frame: pose.apply((2.0, 0.0, 0.0)) for frame, pose in POSES.items()}
    picture = draw_rulers(POSES, places)
    assert [line.partition("(")[2] for line in picture.text.splitlines()[1:]] == ["2.00, 0.00, 0.00) m"] * 3
    ends = [line.get_xydata()[1] for ax in picture.figure.axes for line in ax.lines[:1]]  # of each leg along x
    assert np.allclose(ends, [(2.0, 0.0), (8.2, -1.7), (8.4, -1.7)])


def test_a_thing_that_rests_keeps_its_numbers_in_map_alone_when_the_robot_drives():
    driven = {"map": Transform(), "base_link": Transform(translation=(7.2, -1.7, 0.10))}
    words = describe_rulers(driven, THING, "ball", before=readings_of(POSES, THING))
    assert words.splitlines() == [
        "ball, measured from each frame:",
        "  map        (8.40, -1.70, 0.25) m  same",
        "  base_link  (1.20, 0.00, 0.15) m  changed",
    ]


def test_the_two_legs_lie_along_the_frames_own_axes_and_end_at_the_thing():
    turned = Transform.from_rpy(yaw=math.pi / 2, translation=(1.0, 2.0, 0.0))  # its x is map's y, its y is map's -x
    picture = draw_rulers({"turned": turned}, (-2.0, 6.0, 0.0))
    x_leg, y_leg = (line.get_xydata() for line in picture.figure.axes[0].lines if line.get_zorder() == 30)
    assert np.allclose(x_leg, [(1.0, 2.0), (1.0, 6.0)])
    assert np.allclose(y_leg, [(1.0, 6.0), (-2.0, 6.0)])


def test_a_robot_that_turns_keeps_what_is_on_its_tray_and_a_slider_that_moves_nothing_is_grey():
    panel = rulers_panel()
    of_the_thing = [panel.controls[name] for name in ("thing x [m]", "thing y [m]")]
    panel.controls["rests on"].value = "tray"
    panel.controls["robot yaw [rad]"].value = 1.0
    panel.controls["robot x [m]"].value = 4.0
    assert [line.split()[-1] for line in panel.text.splitlines()[1:]] == ["changed", "same", "same"]
    assert [each.disabled for each in of_the_thing] == [True, True]
    panel.controls["rests on"].value = "floor"
    assert [each.disabled for each in of_the_thing] == [False, False]
    before = panel.text
    of_the_thing[0].value = 3.0
    assert panel.text != before
    panel.close()


def test_a_number_at_the_edge_of_a_map_stands_on_the_other_side_of_its_leg() -> None:
    poses = {"far": Transform((-6.0, 0.0, 0.0)), "base_link": Transform.from_rpy(yaw=math.pi / 2)}
    picture = draw_rulers(poses, (0.0, 2.0, 0.0))
    picture.figure.canvas.draw()
    for ruler in picture._maps.values():
        label = ruler.legs["x"].label
        if label.get_visible():
            assert label.get_window_extent().x1 <= picture.figure.bbox.x1


# The object rests at (3, 1).  First the robot looks along x; then it stands at (3, 0) and looks along y.
MOMENTS_POSES = {"then": Transform(), "now": Transform.from_rpy(yaw=math.pi / 2, translation=(3.0, 0.0, 0.0))}


def test_a_place_is_said_as_the_robot_sees_it():
    assert beside((4.64, -1.64, 0.0)) == "4.64 m ahead, 1.64 m to the right"
    assert beside((-2.0, 0.5, 0.0)) == "2.00 m behind, 0.50 m to the left"
    assert describe_moments(MOMENTS_POSES, (3.0, 1.0, 0.0)).splitlines() == [
        "then  3.00 m ahead, 1.00 m to the left",
        "now   1.00 m ahead",
    ]


def test_each_moment_has_a_panel_at_the_same_scale():
    picture = draw_moments(MOMENTS_POSES, (3.0, 1.0, 0.0), "ball")
    then, now = picture.figure.axes
    assert (then.get_xlim(), then.get_ylim()) == (now.get_xlim(), now.get_ylim())
    assert [text.get_text() for text in picture.figure.texts][:4:2] == ["then", "now"]


def test_the_line_to_the_object_stands_at_right_angles_to_the_way_forward():
    turned = Transform.from_rpy(yaw=0.4, translation=(1.0, -1.0, 0.0))
    picture = draw_moments({"turned": turned}, (4.0, 2.0, 0.0))
    forward, aside = (line.get_xydata() for line in picture.figure.axes[0].lines if line.get_zorder() in (3, 4))
    assert (forward[1] - forward[0]) @ (aside[1] - aside[0]) == pytest.approx(0.0, abs=1e-9)
    assert tuple(aside[1]) == (4.0, 2.0)
