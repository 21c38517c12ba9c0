"""Transform points, vectors and poses: tf2_geometry_msgs.

    base_p_tip (PointStamped)  --do_transform_point(_, map_T_base)-->  map_p_tip

                 turned   moved   result's header
    point          x        x     that of the transform, the same object:
    vector         x              frame = target, stamp = the transform's
    pose           x        x     (not the stamp of what was transformed)
    covariance     x

`import tf2_geometry_msgs` lets `Buffer.transform()` find these functions by the
type of the message.  4x4 matrices and numpy, as upstream since Jazzy; quaternions
are (w, x, y, z) in the functions with an underscore, also as upstream.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

import numpy as np

from tflab.core import quaternions

from ..messages.geometry_msgs import (
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
from .interface import ConvertRegistration, TransformRegistration

__all__ = [
    "TRANSFORMS",
    "do_transform_point",
    "do_transform_polygon_stamped",
    "do_transform_pose",
    "do_transform_pose_stamped",
    "do_transform_pose_with_covariance_stamped",
    "do_transform_vector3",
    "from_msg_msg",
    "register_geometry_types",
    "rotation_matrix",
    "to_msg_msg",
    "transform_covariance",
]

# do_transform_vector3 sets the translation of the transform that it is given to
# zero and leaves it so: who uses that transform again is wrong.  Upstream does;
# False spares the transform.
VECTOR3_ZEROES_TRANSLATION = True

_Message = TypeVar("_Message")


def to_msg_msg(msg: _Message) -> _Message:
    """Return the message: it is one already."""
    return msg


def from_msg_msg(msg: _Message) -> _Message:
    """Return the message: messages are their own data type."""
    return msg


def do_transform_point(point: PointStamped, transform: TransformStamped) -> PointStamped:
    """Return the point in the frame of `transform.header`."""
    x, y, z = _moved(transform, point.point)
    return PointStamped(header=transform.header, point=Point(x=x, y=y, z=z))


def do_transform_vector3(vector3: Vector3Stamped, transform: TransformStamped) -> Vector3Stamped:
    """Return the vector in the frame of `transform.header`: turned, not moved.

    Beware: `transform.transform.translation` is zero afterwards (see VECTOR3_ZEROES_TRANSLATION).
    """
    if VECTOR3_ZEROES_TRANSLATION:
        translation = transform.transform.translation
        translation.x = translation.y = translation.z = 0.0
    x, y, z = (rotation_matrix(transform.transform.rotation) @ _xyz(vector3.vector)).tolist()
    return Vector3Stamped(header=transform.header, vector=Vector3(x=x, y=y, z=z))


def do_transform_pose(pose: Pose, transform: TransformStamped) -> Pose:
    """Return the bare pose in the frame of `transform.header`; its quaternion has w >= 0."""
    source = _build_affine(translation=_xyz(pose.position), rotation=_wxyz(pose.orientation))
    q_wxyz, position = _decompose_affine(_transform_to_affine(transform) @ source)
    (w, qx, qy, qz), (x, y, z) = q_wxyz.tolist(), position.tolist()
    return Pose(position=Point(x=x, y=y, z=z), orientation=Quaternion(x=qx, y=qy, z=qz, w=w))


def do_transform_pose_stamped(pose: PoseStamped, transform: TransformStamped) -> PoseStamped:
    """Return the pose in the frame of `transform.header`."""
    return PoseStamped(header=transform.header, pose=do_transform_pose(pose.pose, transform))


def do_transform_pose_with_covariance_stamped(
    pose: PoseWithCovarianceStamped, transform: TransformStamped
) -> PoseWithCovarianceStamped:
    """Return the pose and its covariance in the frame of `transform.header`."""
    result = PoseWithCovarianceStamped(header=transform.header)
    result.pose.pose = do_transform_pose(pose.pose.pose, transform)
    result.pose.covariance = transform_covariance(pose.pose.covariance, transform)
    return result


def do_transform_polygon_stamped(polygon: PolygonStamped, transform: TransformStamped) -> PolygonStamped:
    """Return the polygon in the frame of `transform.header`."""
    result = PolygonStamped(header=transform.header)
    for point in polygon.polygon.points:
        x, y, z = _moved(transform, point)
        result.polygon.points.append(Point32(x=x, y=y, z=z))
    return result


def transform_covariance(cov_in: Sequence[float], transform: TransformStamped) -> np.ndarray:
    """Return the covariance of a pose after the transform, shape (36,): each 3x3 block B becomes R B R^T.

    Args:
        cov_in: 6x6 values row by row, in the order x, y, z, turns about x, y, z.
        transform: only its rotation R matters.
    """
    turn = rotation_matrix(transform.transform.rotation)
    both = np.kron(np.eye(2), turn)  # R for the position, R for the turns
    return (both @ np.reshape(cov_in, (6, 6)) @ both.T).reshape(36)


def rotation_matrix(rotation: Quaternion) -> np.ndarray:
    """Return the matrix, shape (3, 3), of a message's rotation; of any length, and identity if it has none."""
    return _get_mat_from_quat(_wxyz(rotation))


# What `import tf2_geometry_msgs` registers.
TRANSFORMS = {
    PointStamped: do_transform_point,
    Vector3Stamped: do_transform_vector3,
    PoseStamped: do_transform_pose_stamped,
    PoseWithCovarianceStamped: do_transform_pose_with_covariance_stamped,
    PolygonStamped: do_transform_polygon_stamped,
}


def _build_affine(rotation: Sequence[float] | None = None, translation: Sequence[float] | None = None) -> np.ndarray:
    """Return the matrix, shape (4, 4), of a quaternion (w, x, y, z) and a translation; None is identity."""
    affine = np.eye(4)
    if rotation is not None:
        affine[:3, :3] = _get_mat_from_quat(rotation)
    if translation is not None:
        affine[:3, 3] = translation
    return affine


def _transform_to_affine(transform: TransformStamped) -> np.ndarray:
    """Return the matrix of a transform, shape (4, 4)."""
    return _build_affine(_wxyz(transform.transform.rotation), _xyz(transform.transform.translation))


def _decompose_affine(affine: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the quaternion (w, x, y, z) and the translation of a matrix, shape (4, 4)."""
    return _get_quat_from_mat(affine[:3, :3]), affine[:3, 3]


def _get_mat_from_quat(quaternion: Sequence[float]) -> np.ndarray:
    """Return the rotation matrix, shape (3, 3), of a quaternion (w, x, y, z).

    A quaternion of another length than one is scaled; one of no length, such as
    a forgotten (0, 0, 0, 0), counts as no rotation.
    """
    if np.dot(quaternion, quaternion) < np.finfo(np.float64).eps:
        return np.eye(3)
    return np.array(quaternions.to_matrix(quaternions.xyzw_from_wxyz(quaternion)))


def _get_quat_from_mat(rot_mat: np.ndarray) -> np.ndarray:
    """Return the quaternion (w, x, y, z), w >= 0, of a rotation matrix, shape (3, 3)."""
    q_wxyz = np.array(quaternions.wxyz_from_xyzw(quaternions.from_matrix(np.asarray(rot_mat).tolist())))
    return -q_wxyz if q_wxyz[0] < 0.0 else q_wxyz


def _moved(transform: TransformStamped, point: Point | Point32) -> list[float]:
    """Return x, y, z of a point after the transform."""
    return (_transform_to_affine(transform) @ (*_xyz(point), 1.0))[:3].tolist()


def _xyz(point: Point | Point32 | Vector3) -> tuple[float, float, float]:
    return (point.x, point.y, point.z)


def _wxyz(q: Quaternion) -> tuple[float, float, float, float]:
    return (q.w, q.x, q.y, q.z)


def register_geometry_types() -> None:
    """Register these functions for `Buffer.transform()`, as `import tf2_geometry_msgs` does."""
    for message_type, transform in TRANSFORMS.items():
        TransformRegistration().add(message_type, transform)
    # The others have no conversions, upstream too: `new_type=` fails for them.
    for message_type in (Vector3Stamped, PoseStamped, PointStamped):
        ConvertRegistration().add_to_msg(message_type, to_msg_msg)
        ConvertRegistration().add_from_msg(message_type, from_msg_msg)
