"""Point clouds are read and made as by sensor_msgs_py and transformed as by tf2_sensor_msgs."""

import math

import numpy as np
import pytest

from tflab.ros.messages.geometry_msgs import Quaternion, Transform, TransformStamped, Vector3
from tflab.ros.messages.sensor_msgs import PointCloud2, PointField
from tflab.ros.messages.std_msgs import Header
from tflab.ros.tf2.clouds import (
    create_cloud,
    create_cloud_xyz32,
    do_transform_cloud,
    dtype_from_fields,
    read_points,
    read_points_list,
    read_points_numpy,
    transform_points,
)

POINTS = [(1.0, 2.0, 3.0), (-1.0, 0.0, 0.5)]
HALF = math.sqrt(0.5)


def header():
    result = Header(frame_id="laser_frame")
    result.stamp.sec = 5
    return result


def field(name, offset, datatype, count=1):
    return PointField(name=name, offset=offset, datatype=datatype, count=count)


def lidar_cloud():
    """Return a cloud as a lidar driver makes it: x, y, z, then an integer ring, and a gap of two bytes."""
    fields = [field(name, 4 * i, PointField.FLOAT32) for i, name in enumerate("xyz")]
    fields.append(field("ring", 12, PointField.UINT16))
    return create_cloud(header(), fields, [(1.0, 2.0, 3.0, 7), (-1.0, 0.0, 0.5, 65535)], step=16)


def quarter_left_then_up():
    """(1, 2, 3) -> (-2, 1, 3) -> (-2, 1, 13)"""
    transform = TransformStamped(
        header=Header(frame_id="map"),
        transform=Transform(translation=Vector3(z=10.0), rotation=Quaternion(z=HALF, w=HALF)),
    )
    transform.header.stamp.sec = 99
    return transform


# Making and reading ---------------------------------------------------------------


def test_a_cloud_of_xyz_is_one_row_of_twelve_bytes_a_point():
    cloud = create_cloud_xyz32(header(), POINTS)
    assert (cloud.height, cloud.width, cloud.point_step, cloud.row_step) == (1, 2, 12, 24)
    assert (cloud.is_dense, cloud.is_bigendian) == (False, False)
    assert [(f.name, f.offset, f.datatype, f.count) for f in cloud.fields] == [
        ("x", 0, PointField.FLOAT32, 1),
        ("y", 4, PointField.FLOAT32, 1),
        ("z", 8, PointField.FLOAT32, 1),
    ]
    assert bytes(cloud.data) == np.array(POINTS, dtype="<f4").tobytes()


@pytest.mark.parametrize("points", [POINTS, np.array(POINTS, dtype=np.float32), np.array(POINTS)])
def test_points_are_read_as_they_were_written(points):
    cloud = create_cloud_xyz32(header(), points)
    assert read_points_numpy(cloud).tolist() == [list(point) for point in POINTS]
    assert read_points_numpy(cloud, field_names=["z", "x"]).tolist() == [[3.0, 1.0], [0.5, -1.0]]
    assert read_points_list(cloud) == POINTS
    assert read_points_list(cloud)[0].z == 3.0
    assert read_points_list(cloud, uvs=[1]) == [POINTS[1]]
    assert read_points(cloud)["y"].tolist() == [2.0, 0.0]
    read_points(cloud)["x"][0] = 9.0
    assert read_points(cloud)["x"][0] == 9.0  # in place


def test_columns_of_several_types_and_gaps_are_read():
    cloud = lidar_cloud()
    assert cloud.point_step == 16
    assert read_points(cloud)["ring"].tolist() == [7, 65535]
    assert read_points_list(cloud, ["x", "ring"]) == [(1.0, 7), (-1.0, 65535)]


def test_points_with_nan_are_left_out_only_on_request_and_only_of_clouds_that_are_not_dense():
    cloud = create_cloud_xyz32(header(), [*POINTS, (math.nan, 0.0, 0.0)])
    assert len(read_points(cloud)) == 3
    assert len(read_points(cloud, skip_nans=True)) == 2
    assert len(read_points(cloud, field_names=["y"], skip_nans=True)) == 3
    cloud.is_dense = True
    assert len(read_points(cloud, skip_nans=True)) == 3


def test_an_organized_cloud_keeps_its_rows():
    grid = np.arange(18, dtype=np.float32).reshape(2, 3, 3)  # 2 rows of 3 points
    cloud = create_cloud_xyz32(header(), grid)
    assert (cloud.height, cloud.width, cloud.row_step) == (2, 3, 36)
    assert read_points(cloud, reshape_organized_cloud=True)["x"].tolist() == [[0.0, 3.0, 6.0], [9.0, 12.0, 15.0]]


def test_a_big_endian_cloud_is_read_right_and_left_as_it_is():
    cloud = create_cloud_xyz32(header(), POINTS)
    cloud.data = np.array(POINTS, dtype=">f4").tobytes()
    cloud.is_bigendian = True
    before = bytes(cloud.data)
    assert read_points_numpy(cloud).tolist() == [list(point) for point in POINTS]
    assert bytes(cloud.data) == before


def test_a_field_of_several_values_becomes_several_columns_and_one_without_a_name_gets_one():
    fields = [field("normal", 0, PointField.FLOAT32, 3), field("", 12, PointField.UINT8)]
    assert dtype_from_fields(fields).names == ("normal_0", "normal_1", "normal_2", "unnamed_field_1")
    assert dtype_from_fields(fields, point_step=20).itemsize == 20


@pytest.mark.parametrize(
    ("attempt", "text"),
    [
        (lambda: read_points("cloud"), "Cloud is not a sensor_msgs.msg.PointCloud2"),
        (lambda: read_points_list("cloud"), "cloud is not a sensor_msgs.msg.PointCloud2"),
        (lambda: read_points(lidar_cloud(), ["intensity"]), "Requests field is not in the fields of the PointCloud!"),
        (
            lambda: read_points_numpy(lidar_cloud()),
            "All fields need to have the same datatype. Use `read_points()` otherwise.",
        ),
        (
            lambda: dtype_from_fields([field("x", 0, PointField.FLOAT32), field("x", 4, PointField.FLOAT32)]),
            "Duplicate field names are not allowed!",
        ),
        (
            lambda: create_cloud(header(), lidar_cloud().fields, np.zeros((2, 4))),
            "All fields need to have the same datatype. Pass a structured NumPy array with multiple dtypes otherwise.",
        ),
        (
            lambda: create_cloud(header(), lidar_cloud().fields, read_points(create_cloud_xyz32(header(), POINTS))),
            "PointFields and structured NumPy array dtype do not match for all fields! "
            "Check their field order, names and types.",
        ),
        (
            lambda: do_transform_cloud(
                create_cloud(header(), [field("x", 0, PointField.FLOAT32)], [(1.0,)]), Transform()
            ),
            "Point cloud needs the fields x, y, and z for the transformation",
        ),
    ],
)
def test_invalid_arguments_raise_with_upstreams_text(attempt, text):
    with pytest.raises(AssertionError) as refusal:
        attempt()
    assert str(refusal.value) == text


# Moving ---------------------------------------------------------------------------


def test_a_transformed_cloud_has_its_own_stamp_other_columns_and_the_transforms_frame():
    cloud, transform = lidar_cloud(), quarter_left_then_up()
    result = do_transform_cloud(cloud, transform)
    assert cloud == lidar_cloud()
    assert (result.header.frame_id, result.header.stamp.sec) == ("map", 5)
    assert read_points_numpy(result, ["x", "y", "z"]).tolist() == [
        pytest.approx([-2.0, 1.0, 13.0]),
        pytest.approx([0.0, -1.0, 10.5], abs=1e-6),
    ]
    assert (read_points(result)["ring"].tolist(), result.point_step) == ([7, 65535], 16)
    assert do_transform_cloud(cloud, transform.transform).header == header()
    assert transform_points([[1.0, 2.0, 3.0]], transform).tolist() == [pytest.approx([-2.0, 1.0, 13.0])]
    empty = do_transform_cloud(create_cloud_xyz32(header(), []), transform)
    assert isinstance(empty, PointCloud2)
    assert (empty.width, len(empty.data)) == (0, 0)


def test_a_transformed_cloud_has_one_row():
    cloud = create_cloud_xyz32(header(), np.zeros((2, 3, 3), dtype=np.float32))
    cloud.is_dense = True
    result = do_transform_cloud(cloud, quarter_left_then_up())
    assert (result.height, result.width, result.is_dense) == (1, 6, False)
