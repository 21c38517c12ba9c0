"""A wrong answer that is somewhere in space is drawn beside the right one, whatever form it has."""

from __future__ import annotations

from tflab.ros.messages import geometry_msgs, std_msgs
from tflab.workbook.answers.forms import Angle, Choice, Message, Number, Parts, Vector
from tflab.workbook.answers.values import to_plain
from tflab.workbook.diagnosis.comparison import picture_of

POINTS = Parts({"base_link": Vector(3, "m", "base_link", 0.005), "map": Vector(3, "m", "map", 0.005)})
PLANAR = Parts({"x": Number("m", 0.001), "y": Number("m", 0.001), "yaw": Angle(0.001)})
HALF = Parts({"position": Vector(2, "m", "", 0.001), "yaw": Angle(0.001)})
MOUNT = Message("geometry_msgs/msg/TransformStamped", ("transform.translation", "transform.rotation"))
POINT = Message("geometry_msgs/msg/PointStamped", ("header.frame_id", "point"))


def drawn(form, answer, expected):
    picture = picture_of(form, to_plain(answer), to_plain(expected))
    return picture and picture.text


def test_of_several_points_the_first_wrong_one_is_drawn_in_its_own_frame():
    right = {"base_link": (1.0, 2.0, 0.0), "map": (5.0, 6.0, 0.0)}
    text = drawn(POINTS, right | {"map": (6.0, 5.0, 0.0)}, right)
    assert "As seen from map" in text
    assert "point expected at (5.000, 6.000, 0.000) m" in text
    assert "ghost point yours at (6.000, 5.000, 0.000) m" in text


def test_a_pose_in_the_plane_is_drawn_whichever_way_it_is_written():
    text = drawn(PLANAR, {"x": 1.0, "y": 2.0, "yaw": 0.5}, {"x": 1.0, "y": -2.0, "yaw": 0.5})
    assert "yours at (1.000, 2.000, 0.000) m, roll 0.000, pitch 0.000, yaw 0.500 rad" in text
    assert "expected at (1.000, -2.000, 0.000) m" in text
    assert drawn(HALF, {"position": (1.0, 2.0), "yaw": 0.5}, {"position": (0.0, 2.0), "yaw": 0.5})


def test_messages_are_drawn_by_what_they_hold():
    mount = geometry_msgs.TransformStamped(child_frame_id="camera_link")
    mount.transform.translation.x = 0.1
    assert "expected at (0.100, 0.000, 0.000) m" in drawn(MOUNT, geometry_msgs.TransformStamped(), mount)
    seen = geometry_msgs.PointStamped(header=std_msgs.Header(frame_id="map"), point=geometry_msgs.Point(x=2.0))
    assert "As seen from map" in drawn(POINT, geometry_msgs.PointStamped(), seen)


def test_what_is_nowhere_in_space_and_two_that_lie_on_each_other_are_not_drawn():
    assert drawn(Parts({"a": Choice(("left", "right"))}), {"a": "left"}, {"a": "right"}) is None
    assert drawn(PLANAR, {"x": "left"}, {"x": 1.0, "y": -2.0, "yaw": 0.5}) is None
    assert drawn(POINTS, {"map": (1e9, 0.0, 0.0)}, {"base_link": (1.0, 2.0, 0.0), "map": (5.0, 6.0, 0.0)}) is None
    mount = geometry_msgs.TransformStamped(child_frame_id="camera_link", header=std_msgs.Header(frame_id="base_link"))
    swapped = geometry_msgs.TransformStamped(child_frame_id="base_link", header=std_msgs.Header(frame_id="camera_link"))
    assert drawn(MOUNT, swapped, mount) is None
    here = geometry_msgs.PointStamped(header=std_msgs.Header(frame_id="map"))
    assert drawn(POINT, geometry_msgs.PointStamped(), here) is None
