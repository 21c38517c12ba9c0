"""Imports of ROS packages find these messages and transforms, and register the transforms."""

import importlib.util

import pytest

import tflab.ros
from tflab.ros import messages
from tflab.ros.activation import PACKAGES
from tflab.ros.tf2 import clouds, filters, geometry


@pytest.fixture(autouse=True)
def in_process(monkeypatch):
    monkeypatch.delenv("TFLAB_ROS", raising=False)
    tflab.ros.activate("in-process")
    yield
    tflab.ros.deactivate()


TABLES = sorted(name for name in PACKAGES if importlib.util.find_spec(f"tflab.ros.messages.{name}"))


@pytest.mark.parametrize("package", TABLES)
def test_every_type_of_a_package_is_where_ros_has_it(package):
    table = importlib.import_module(f"tflab.ros.messages.{package}")
    types = {name: value for name, value in vars(table).items() if hasattr(value, "ROS_TYPE")}
    assert types
    for name, cls in types.items():
        kind = cls.ROS_TYPE.split("/")[1]
        assert getattr(importlib.import_module(f"{package}.{kind}"), name) is cls


def test_helper_packages_give_the_same_functions():
    import message_filters
    import tf2_geometry_msgs
    import tf2_sensor_msgs
    from sensor_msgs_py import point_cloud2
    from tf2_geometry_msgs.tf2_geometry_msgs import _get_mat_from_quat

    assert tf2_geometry_msgs.do_transform_point is geometry.do_transform_point
    assert tf2_geometry_msgs.PointStamped is messages.geometry_msgs.PointStamped
    assert _get_mat_from_quat is geometry._get_mat_from_quat
    assert tf2_sensor_msgs.do_transform_cloud is clouds.do_transform_cloud
    assert point_cloud2.read_points is clouds.read_points
    assert message_filters.TimeSynchronizer is filters.TimeSynchronizer


def quarter_turn_buffer():
    """map --(at 1 s: 10 m ahead, a quarter turn left)--> base_link"""
    from geometry_msgs.msg import TransformStamped
    from tf2_ros import Buffer

    transform = TransformStamped(child_frame_id="base_link")
    transform.header.frame_id = "map"
    transform.header.stamp.sec = 1
    transform.transform.translation.x = 10.0
    transform.transform.rotation.z = transform.transform.rotation.w = 0.5**0.5
    buffer = Buffer()
    buffer.set_transform(transform, "test")
    return buffer


def test_a_buffer_transforms_what_was_registered_and_the_stamp_is_that_of_tf():
    import tf2_geometry_msgs  # noqa: F401 - registers
    from geometry_msgs.msg import PointStamped

    point = PointStamped()  # stamp zero: the latest
    point.header.frame_id = "base_link"
    point.point.x = 1.0
    moved = quarter_turn_buffer().transform(point, "map")
    assert (moved.point.x, moved.point.y) == (pytest.approx(10.0), pytest.approx(1.0))
    assert (moved.header.frame_id, moved.header.stamp.sec) == ("map", 1)


def test_a_cloud_is_transformed_and_keeps_its_stamp():
    import tf2_sensor_msgs  # noqa: F401 - registers
    from sensor_msgs_py.point_cloud2 import create_cloud_xyz32, read_points_numpy
    from std_msgs.msg import Header

    moved = quarter_turn_buffer().transform(create_cloud_xyz32(Header(frame_id="base_link"), [(1.0, 0.0, 0.0)]), "map")
    assert read_points_numpy(moved)[0].tolist() == pytest.approx([10.0, 1.0, 0.0], abs=1e-6)
    assert (moved.header.frame_id, moved.header.stamp.sec) == ("map", 0)


def test_a_point_may_be_asked_for_as_its_own_type_but_a_pose_with_covariance_as_no_other():
    import tf2_geometry_msgs  # noqa: F401 - registers
    from geometry_msgs.msg import PointStamped, PoseStamped, PoseWithCovarianceStamped
    from tf2_ros import TypeException

    point, pose = PointStamped(), PoseWithCovarianceStamped()
    point.header.frame_id = pose.header.frame_id = "base_link"
    buffer = quarter_turn_buffer()
    assert isinstance(buffer.transform(point, "map", new_type=PointStamped), PointStamped)
    assert isinstance(buffer.transform(pose, "map", new_type=PoseWithCovarianceStamped), PoseWithCovarianceStamped)
    with pytest.raises(TypeException):
        buffer.transform(pose, "map", new_type=PoseStamped)
