"""Transform point clouds: tf2_sensor_msgs, and sensor_msgs_py's point_cloud2.

    PointCloud2.data   |x...y...z...i...|x...y...z...i...|     point_step bytes each
                            |  read_points: a view, one named column per field
                            v
                       x, y, z  -- transform_points -->  x, y, z
                            |  create_cloud
                            v
    PointCloud2        header: the cloud's stamp, the transform's frame

A cloud has one stamp, but a turning scanner needs a tenth of a second for it.
"""

from __future__ import annotations

import sys
from array import array
from collections import namedtuple
from collections.abc import Iterable, Sequence

import numpy as np
from numpy.lib.recfunctions import structured_to_unstructured, unstructured_to_structured

from ..messages.geometry_msgs import Transform, TransformStamped
from ..messages.sensor_msgs import PointCloud2, PointField
from ..messages.std_msgs import Header
from .geometry import from_msg_msg, rotation_matrix, to_msg_msg
from .interface import ConvertRegistration, TransformRegistration

__all__ = [
    "create_cloud",
    "create_cloud_xyz32",
    "do_transform_cloud",
    "dtype_from_fields",
    "from_msg_msg",
    "read_points",
    "read_points_list",
    "read_points_numpy",
    "register_point_clouds",
    "to_msg_msg",
    "transform_points",
]

_DATATYPES = {
    PointField.INT8: np.dtype(np.int8),
    PointField.UINT8: np.dtype(np.uint8),
    PointField.INT16: np.dtype(np.int16),
    PointField.UINT16: np.dtype(np.uint16),
    PointField.INT32: np.dtype(np.int32),
    PointField.UINT32: np.dtype(np.uint32),
    PointField.FLOAT32: np.dtype(np.float32),
    PointField.FLOAT64: np.dtype(np.float64),
}


# tf2_sensor_msgs ------------------------------------------------------------------


def do_transform_cloud(cloud: PointCloud2, transform: Transform | TransformStamped) -> PointCloud2:
    """Return the cloud with x, y, z transformed and every other field as it was.

    The result has the cloud's stamp and the transform's frame (the cloud's, if
    the transform is a bare one), one row, and `is_dense` False.

    Raises:
        AssertionError: the cloud lacks x, y or z.
    """
    if not {"x", "y", "z"} <= {field.name for field in cloud.fields}:
        raise AssertionError("Point cloud needs the fields x, y, and z for the transformation")
    points = read_points(cloud).copy()
    moved = transform_points(structured_to_unstructured(points[["x", "y", "z"]]), transform)
    for column, name in enumerate("xyz"):
        points[name] = moved[:, column]
    header = Header(stamp=cloud.header.stamp, frame_id=cloud.header.frame_id)
    if isinstance(transform, TransformStamped):
        header.frame_id = transform.header.frame_id
    return create_cloud(header, cloud.fields, points, cloud.point_step)


def transform_points(point_cloud: np.ndarray, transform: Transform | TransformStamped) -> np.ndarray:
    """Return points, shape (n, 3), turned, then moved."""
    if isinstance(transform, TransformStamped):
        transform = transform.transform
    step = transform.translation
    return np.asarray(point_cloud) @ rotation_matrix(transform.rotation).T + (step.x, step.y, step.z)


# sensor_msgs_py.point_cloud2 ------------------------------------------------------


def read_points(
    cloud: PointCloud2,
    field_names: Sequence[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable | None = None,
    reshape_organized_cloud: bool = False,
) -> np.ndarray:
    """Return the points as a structured array, one named column per field: `points["x"]`.

    It is a view on the cloud's data, unless points are left out or bytes swapped.

    Args:
        field_names: the columns wanted; None for all.
        skip_nans: leave out points with a nan in a wanted column, unless the cloud says it is dense.
        uvs: indices of the points wanted.
        reshape_organized_cloud: return shape (height, width) instead of (n,).
    """
    if not isinstance(cloud, PointCloud2):
        raise AssertionError("Cloud is not a sensor_msgs.msg.PointCloud2")
    dtype = dtype_from_fields(cloud.fields, cloud.point_step)
    points = np.ndarray(shape=(cloud.width * cloud.height,), dtype=dtype, buffer=cloud.data)
    if field_names is not None:
        if not set(field_names) <= set(dtype.names):
            raise AssertionError("Requests field is not in the fields of the PointCloud!")
        points = points[list(field_names)]
    if cloud.is_bigendian != (sys.byteorder == "big"):
        points = points.byteswap()  # upstream swaps inside the message; a reader should not change what it reads
    if skip_nans and not cloud.is_dense:
        whole = np.ones(len(points), dtype=bool)
        for name in points.dtype.names:
            whole &= ~np.isnan(points[name])
        points = points[whole]
    if uvs is not None:
        points = points[uvs if isinstance(uvs, np.ndarray) else np.fromiter(uvs, int)]
    if reshape_organized_cloud and cloud.height > 1:
        points = points.reshape(cloud.height, cloud.width)
    return points


def read_points_numpy(
    cloud: PointCloud2,
    field_names: Sequence[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable | None = None,
    reshape_organized_cloud: bool = False,
) -> np.ndarray:
    """Return equally typed fields as a plain array, shape (n, fields); for the arguments see `read_points`."""
    wanted = [field.datatype for field in cloud.fields if field_names is None or field.name in field_names]
    if len(set(wanted)) > 1:
        raise AssertionError("All fields need to have the same datatype. Use `read_points()` otherwise.")
    return structured_to_unstructured(read_points(cloud, field_names, skip_nans, uvs, reshape_organized_cloud))


def read_points_list(
    cloud: PointCloud2,
    field_names: Sequence[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable | None = None,
) -> list[tuple]:
    """Return the points as named tuples: `points[0].x`.  Slow; for the arguments see `read_points`."""
    if not isinstance(cloud, PointCloud2):
        raise AssertionError("cloud is not a sensor_msgs.msg.PointCloud2")
    names = [field.name for field in cloud.fields] if field_names is None else field_names
    point_class = namedtuple("Point", names)
    return [point_class._make(point) for point in read_points(cloud, names, skip_nans, uvs)]


def create_cloud(
    header: Header, fields: Sequence[PointField], points: Iterable, step: int | None = None
) -> PointCloud2:
    """Return a cloud of `points`.

    Args:
        header: kept, not copied.
        fields: what each point has, in this order.
        points: one tuple for each point, an array of shape (n, fields) if all fields are of one
            type, or a structured array; shape (height, width) makes an organized cloud.
        step: bytes from one point to the next; None for no gap.
    """
    dtype = dtype_from_fields(fields, step)
    if not isinstance(points, np.ndarray):
        points = np.array(list(map(tuple, points)), dtype=dtype)
    elif points.dtype.names is None:
        if len({field.datatype for field in fields}) > 1:
            raise AssertionError(
                "All fields need to have the same datatype. "
                "Pass a structured NumPy array with multiple dtypes otherwise."
            )
        points = unstructured_to_structured(points, dtype=dtype)
    elif points.dtype != dtype:
        raise AssertionError(
            "PointFields and structured NumPy array dtype do not match for all fields! "
            "Check their field order, names and types."
        )
    if points.ndim > 2:
        raise AssertionError(
            "Too many dimensions for organized cloud! Points can only be organized in max. two dimensional space"
        )
    height, width = points.shape if points.ndim == 2 else (1, len(points))
    cloud = PointCloud2(
        header=header,
        height=height,
        width=width,
        is_dense=False,
        is_bigendian=sys.byteorder != "little",
        fields=fields,
        point_step=dtype.itemsize,
        row_step=dtype.itemsize * width,
    )
    cloud.data = array("B", points.tobytes())
    return cloud


def create_cloud_xyz32(header: Header, points: Iterable, step: int | None = None) -> PointCloud2:
    """Return a cloud with the fields x, y, z, all float32; for the arguments see `create_cloud`."""
    fields = [
        PointField(name=name, offset=4 * column, datatype=PointField.FLOAT32, count=1)
        for column, name in enumerate("xyz")
    ]
    return create_cloud(header, fields, points, step)


def dtype_from_fields(fields: Sequence[PointField], point_step: int | None = None) -> np.dtype:
    """Return numpy's structured type of one point; a field of several values becomes name_0, name_1, …"""
    names, formats, offsets = [], [], []
    for i, field in enumerate(fields):
        datatype = _DATATYPES[field.datatype]
        name = field.name or f"unnamed_field_{i}"
        for k in range(field.count):
            names.append(f"{name}_{k}" if field.count > 1 else name)
            formats.append(datatype.str)
            offsets.append(field.offset + k * datatype.itemsize)
    if len(set(names)) < len(names):
        raise AssertionError("Duplicate field names are not allowed!")
    layout = {"names": names, "formats": formats, "offsets": offsets}
    return np.dtype(layout if point_step is None else layout | {"itemsize": point_step})


def register_point_clouds() -> None:
    """Register these functions for `Buffer.transform()`, as `import tf2_sensor_msgs` does."""
    TransformRegistration().add(PointCloud2, do_transform_cloud)
    ConvertRegistration().add_to_msg(PointCloud2, to_msg_msg)
    ConvertRegistration().add_from_msg(PointCloud2, from_msg_msg)
