"""Points, vectors, poses and covariances in another frame, as tf2_geometry_msgs computes them."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tflab.core import quaternions
from tflab.ros.messages import copy_message
from tflab.ros.messages.geometry_msgs import (
    Point,
    Point32,
    PointStamped,
    PolygonStamped,
    Pose,
    PoseStamped,
    PoseWithCovarianceStamped,
    Quaternion,
    TransformStamped,
    Vector3,
    Vector3Stamped,
)
from tflab.ros.tf2 import geometry
from tflab.ros.tf2.geometry import (
    TRANSFORMS,
    do_transform_point,
    do_transform_polygon_stamped,
    do_transform_pose,
    do_transform_pose_with_covariance_stamped,
    do_transform_vector3,
    transform_covariance,
)

HALF = math.sqrt(0.5)

#   A quarter turn left, then (10, 20, 30):   (1, 2, 3) -> (-2, 1, 3) -> (8, 21, 33)
QUARTER_LEFT = {"z": HALF, "w": HALF}


def transform(xyz=(10.0, 20.0, 30.0), rotation=QUARTER_LEFT):
    result = TransformStamped(child_frame_id="base_link")
    result.header.frame_id = "map"
    result.header.stamp.sec = 7
    result.transform.translation = Vector3(x=xyz[0], y=xyz[1], z=xyz[2])
    result.transform.rotation = Quaternion(**{"x": 0.0, "y": 0.0, "z": 0.0, "w": 0.0, **rotation})
    return result


def stamped(cls, **fields):
    message = cls(**fields)
    message.header.frame_id = "base_link"
    message.header.stamp.sec = 5
    return message


def xyz(message):
    return (message.x, message.y, message.z)


def wxyz(q):
    return (q.w, q.x, q.y, q.z)


# One worked example each ----------------------------------------------------------


def test_a_point_is_rotated_then_translated():
    result = do_transform_point(stamped(PointStamped, point=Point(x=1.0, y=2.0, z=3.0)), transform())
    assert xyz(result.point) == pytest.approx((8.0, 21.0, 33.0))
    half_turn_about_x = transform((1.0, 0.0, 0.0), {"x": 1.0})
    result = do_transform_point(stamped(PointStamped, point=Point(x=1.0, y=2.0, z=3.0)), half_turn_about_x)
    assert xyz(result.point) == (2.0, -2.0, -3.0)  # exactly


def test_a_pose_is_rotated_and_translated_with_its_orientation():
    pose = Pose(position=Point(x=1.0, y=2.0, z=3.0), orientation=Quaternion(**QUARTER_LEFT))
    result = do_transform_pose(pose, transform())
    assert isinstance(result, Pose)
    assert xyz(result.position) == pytest.approx((8.0, 21.0, 33.0))
    assert wxyz(result.orientation) == pytest.approx((0.0, 0.0, 0.0, 1.0))  # two quarters make a half
    assert all(type(value) is float for value in xyz(result.position) + wxyz(result.orientation))
    with pytest.raises(AttributeError, match="'PoseStamped' object has no attribute 'position'"):
        do_transform_pose(PoseStamped(), transform())


def test_each_point_of_a_polygon_is_rotated_and_translated():
    polygon = stamped(PolygonStamped)
    polygon.polygon.points = [Point32(x=1.0, y=2.0, z=3.0), Point32()]
    result = do_transform_polygon_stamped(polygon, transform())
    assert [xyz(point) for point in result.polygon.points] == [
        pytest.approx((8.0, 21.0, 33.0)),
        pytest.approx((10.0, 20.0, 30.0)),
    ]
    assert all(isinstance(point, Point32) for point in result.polygon.points)


def test_a_quarter_turn_swaps_the_variances_of_x_and_y_of_position_and_turn():
    pose = stamped(PoseWithCovarianceStamped)
    pose.pose.covariance = np.diag([1.0, 4.0, 9.0, 0.1, 0.2, 0.3]).reshape(36)
    result = do_transform_pose_with_covariance_stamped(pose, transform())
    assert result.pose.covariance.shape == (36,)
    assert np.diag(result.pose.covariance.reshape(6, 6)).tolist() == pytest.approx([4.0, 1.0, 9.0, 0.2, 0.1, 0.3])


# Headers --------------------------------------------------------------------------


@pytest.mark.parametrize("cls", list(TRANSFORMS), ids=lambda cls: cls.__name__)
def test_the_result_has_the_very_header_of_the_transform_and_the_input_is_not_changed(cls):
    through, message = transform(), stamped(cls)
    before = copy_message(message)
    result = TRANSFORMS[cls](message, through)
    assert message == before
    assert type(result) is cls
    assert result.header is through.header
    assert (result.header.frame_id, result.header.stamp.sec) == ("map", 7)


# Surprises ------------------------------------------------------------------------


def test_a_vector_is_only_rotated_and_zeroes_the_translation_of_the_transform_as_upstream_does(monkeypatch):
    for zeroes, left in ((True, (0.0, 0.0, 0.0)), (False, (10.0, 20.0, 30.0))):
        monkeypatch.setattr(geometry, "VECTOR3_ZEROES_TRANSLATION", zeroes)
        through = transform()
        result = do_transform_vector3(stamped(Vector3Stamped, vector=Vector3(x=1.0, y=2.0, z=3.0)), through)
        assert xyz(result.vector) == pytest.approx((-2.0, 1.0, 3.0))
        assert xyz(through.transform.translation) == left


def test_a_quaternion_of_zeros_counts_as_no_rotation_and_a_long_one_is_scaled():
    nowhere = transform((1.0, 0.0, 0.0), {})
    assert xyz(do_transform_point(stamped(PointStamped, point=Point(y=2.0)), nowhere).point) == (1.0, 2.0, 0.0)
    long = transform((0.0, 0.0, 0.0), {"z": 3.0, "w": 3.0})
    assert xyz(do_transform_point(stamped(PointStamped, point=Point(x=1.0)), long).point) == pytest.approx(
        (0.0, 1.0, 0.0)
    )


def test_a_resulting_quaternion_never_has_a_negative_w():
    pose = Pose(orientation=Quaternion(z=-HALF, w=-HALF))  # the same quarter turn, written the other way
    assert wxyz(do_transform_pose(pose, transform(rotation={"w": 1.0})).orientation) == pytest.approx(
        (HALF, 0.0, 0.0, HALF)
    )


# Laws -----------------------------------------------------------------------------

coordinates = st.floats(-100.0, 100.0)
points = st.tuples(coordinates, coordinates, coordinates)
rotations = (
    st.tuples(*[st.floats(-1.0, 1.0)] * 4).filter(lambda q: sum(v * v for v in q) > 0.01).map(quaternions.normalized)
)


@st.composite
def transforms(draw):
    q = draw(rotations)
    return transform(draw(points), dict(zip("xyzw", q, strict=True)))


def inverse(of):
    """Return the transform back, by hand: the conjugate rotation, and minus the step in turned axes."""
    r, t = of.transform.rotation, of.transform.translation
    back = quaternions.conjugate((r.x, r.y, r.z, r.w))
    return transform(quaternions.rotate(back, (-t.x, -t.y, -t.z)), dict(zip("xyzw", back, strict=True)))


@given(points, transforms())
def test_the_inverse_returns_a_point_to_its_position(position, there):
    point = stamped(PointStamped, point=Point(x=position[0], y=position[1], z=position[2]))
    back = do_transform_point(do_transform_point(point, there), inverse(there))
    assert xyz(back.point) == pytest.approx(position, abs=1e-9)


@given(points, rotations, transforms())
def test_the_inverse_returns_a_pose_to_its_position(position, q, there):
    pose = Pose(
        position=Point(x=position[0], y=position[1], z=position[2]),
        orientation=Quaternion(x=q[0], y=q[1], z=q[2], w=q[3]),
    )
    back = do_transform_pose(do_transform_pose(pose, there), inverse(there))
    o = back.orientation
    assert xyz(back.position) == pytest.approx(position, abs=1e-9)
    assert quaternions.angle((o.x, o.y, o.z, o.w), q) == pytest.approx(0.0, abs=1e-6)
    assert o.w >= 0.0


@given(points, transforms())
def test_a_vector_keeps_its_length(components, there):
    vector = stamped(Vector3Stamped, vector=Vector3(x=components[0], y=components[1], z=components[2]))
    turned = do_transform_vector3(vector, there).vector
    assert math.hypot(*xyz(turned)) == pytest.approx(math.hypot(*components), abs=1e-9)


@given(st.lists(st.floats(-5.0, 5.0), min_size=36, max_size=36), transforms())
def test_each_block_of_a_covariance_becomes_r_b_rt(values, there):
    r = there.transform.rotation
    turn = np.array(quaternions.to_matrix((r.x, r.y, r.z, r.w)))
    before = np.array(values).reshape(6, 6)
    after = transform_covariance(values, there).reshape(6, 6)
    for rows in (slice(0, 3), slice(3, 6)):
        for columns in (slice(0, 3), slice(3, 6)):
            assert after[rows, columns] == pytest.approx(turn @ before[rows, columns] @ turn.T, abs=1e-9)


@given(rotations)
def test_matrix_and_quaternion_conversions_are_inverse(q):
    matrix = geometry._get_mat_from_quat(np.array(quaternions.wxyz_from_xyzw(q)))
    again = quaternions.xyzw_from_wxyz(geometry._get_quat_from_mat(matrix).tolist())
    assert quaternions.angle(again, q) == pytest.approx(0.0, abs=1e-6)
