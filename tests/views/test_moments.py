"""One resting object, as a robot has it at several moments."""

import math

import pytest

from tflab.core import Transform
from tflab.views.coordinates import beside, describe_moments, draw_moments

# The object rests at (3, 1).  First the robot looks along x; then it stands at (3, 0) and looks along y.
POSES = {"then": Transform(), "now": Transform.from_rpy(yaw=math.pi / 2, translation=(3.0, 0.0, 0.0))}


@pytest.mark.parametrize(
    ("point", "words"),
    [
        ((4.64, -1.64, 0.0), "4.64 m ahead, 1.64 m to the right"),
        ((-2.0, 0.5, 0.0), "2.00 m behind, 0.50 m to the left"),
        ((1.0, -0.001, 0.0), "1.00 m ahead"),
    ],
)
def test_a_place_is_said_as_the_robot_sees_it(point, words):
    assert beside(point) == words


def test_the_words_follow_the_robot_not_the_object():
    assert describe_moments(POSES, (3.0, 1.0, 0.0)).splitlines() == [
        "then  3.00 m ahead, 1.00 m to the left",
        "now   1.00 m ahead",
    ]


def test_each_moment_has_a_panel_at_the_same_scale():
    picture = draw_moments(POSES, (3.0, 1.0, 0.0), "ball")
    then, now = picture.figure.axes
    assert (then.get_xlim(), then.get_ylim()) == (now.get_xlim(), now.get_ylim())
    assert [text.get_text() for text in picture.figure.texts][:4:2] == ["then", "now"]


def test_the_line_to_the_object_stands_at_right_angles_to_the_way_forward():
    turned = Transform.from_rpy(yaw=0.4, translation=(1.0, -1.0, 0.0))
    picture = draw_moments({"turned": turned}, (4.0, 2.0, 0.0))
    forward, aside = (line.get_xydata() for line in picture.figure.axes[0].lines if line.get_zorder() in (3, 4))
    assert (forward[1] - forward[0]) @ (aside[1] - aside[0]) == pytest.approx(0.0, abs=1e-9)
    assert tuple(aside[1]) == (4.0, 2.0)


def test_the_picture_is_small_and_the_same_bytes_every_time():
    first, again = (draw_moments(POSES, (3.0, 1.0, 0.0)).png() for _ in range(2))
    assert first == again
    assert len(first) < 60_000
