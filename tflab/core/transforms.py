"""Define a rigid transform, a transform with frames and stamp, and a transform as received.

    target_T_source = Transform(translation, rotation)

It gives the pose of source in target, and it converts coordinates from source to
target: p_target = R p_source + t. In a message, target is the parent
(`header.frame_id`) and source is the child (`child_frame_id`). Neighbouring frame
names must match:

    map_T_base = map_T_odom @ odom_T_base
    map_p_tip = map_T_base.apply(base_p_tip)

A `TransformRecord` is a transform as it arrived, valid or not: with slashes in names,
zero quaternions or stamps that go backwards. Its `stamped.stamp_ns` is the time of the
transform by the publisher's clock; its `receive_ns` is the time of arrival by the
listener's clock. A stream is a `list[TransformRecord]` in the order of arrival.
(REP-103 axes; geometry_msgs/Transform.)
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from . import quaternions
from .poses import Pose, compose, invert
from .quaternions import Quaternion, Vector3

__all__ = ["StampedTransform", "Transform", "TransformRecord"]


@dataclass(frozen=True, slots=True)
class Transform:
    """A turn and a step: `target_T_source`.

    Attributes:
        translation: (x, y, z) [m] of source's origin in target.
        rotation: unit quaternion (x, y, z, w) of source's axes in target.

    The rotation is kept as given.  Whether it is a rotation at all is judged by
    whoever uses it: a buffer refuses a bad one as tf2 does, and the methods here
    raise ValueError if it has no direction (and scale it to length one if it has).
    """

    translation: Vector3 = (0.0, 0.0, 0.0)
    rotation: Quaternion = (0.0, 0.0, 0.0, 1.0)

    def __post_init__(self) -> None:
        object.__setattr__(self, "translation", _floats(self.translation, 3, "translation (x, y, z)"))
        object.__setattr__(self, "rotation", _floats(self.rotation, 4, "rotation (x, y, z, w)"))

    @classmethod
    def from_rpy(
        cls, roll: float = 0.0, pitch: float = 0.0, yaw: float = 0.0, translation: Sequence[float] = (0.0, 0.0, 0.0)
    ) -> Transform:
        """Return the turn by roll, then pitch, then yaw [rad] about the fixed axes, with a `translation` [m]."""
        x, y, z = _floats(translation, 3, "translation (x, y, z)")
        return cls((x, y, z), quaternions.from_rpy(roll, pitch, yaw))

    @classmethod
    def from_matrix(cls, matrix: np.ndarray) -> Transform:
        """Return the transform of a homogeneous matrix, shape (4, 4).

        Raises:
            ValueError: wrong shape, last row not (0, 0, 0, 1), or the 3x3 block not a
                rotation (orthonormal and right-handed, to 1e-6).
        """
        m = np.asarray(matrix, dtype=float)
        if m.shape != (4, 4):
            raise ValueError(f"a homogeneous matrix has shape (4, 4), this one has {m.shape}")
        if not np.allclose(m[3], (0.0, 0.0, 0.0, 1.0), atol=1e-9):
            raise ValueError(f"the last row must be (0, 0, 0, 1), here it is {tuple(m[3].tolist())}")
        block = m[:3, :3]
        if not np.allclose(block @ block.T, np.eye(3), atol=1e-6):
            raise ValueError("the 3x3 block is not a rotation: its rows are not of length one and at right angles")
        if np.linalg.det(block) < 0.0:
            raise ValueError("the 3x3 block is a mirror, not a rotation: REP-103 axes are right-handed")
        rotation = quaternions.from_matrix(block.tolist())
        x, y, z = m[:3, 3].tolist()
        return cls((x, y, z), quaternions.normalized(rotation))

    def matrix(self) -> np.ndarray:
        """Return the homogeneous matrix, shape (4, 4), that moves columns (x, y, z, 1) from source to target."""
        matrix = np.eye(4)
        matrix[:3, :3] = quaternions.to_matrix(quaternions.normalized(self.rotation))
        matrix[:3, 3] = self.translation
        return matrix

    def rpy(self) -> Vector3:
        """Return (roll, pitch, yaw) [rad] about the fixed axes."""
        return quaternions.to_rpy(quaternions.normalized(self.rotation))

    def __matmul__(self, other: Transform) -> Transform:
        """Return `a_T_c = a_T_b @ b_T_c`."""
        if isinstance(other, tuple | list | np.ndarray):
            raise TypeError("@ joins two transforms; a point is moved by apply: a_p = a_T_b.apply(b_p)")
        if not isinstance(other, Transform):
            return NotImplemented
        return transform_from_pose(compose(pose_from_transform(self), pose_from_transform(other)))

    def inverse(self) -> Transform:
        """Return `b_T_a` of `a_T_b`: turn back first, then undo the step along the turned axes."""
        return transform_from_pose(invert(pose_from_transform(self)))

    def apply(self, points: Sequence[float] | np.ndarray) -> Vector3 | np.ndarray:
        """Move a point (x, y, z) [m], or an array of points of shape (..., 3), from source to target.

        A tuple or list gives a tuple, an array gives an array of the same shape.
        """
        if isinstance(points, np.ndarray):
            if points.shape[-1:] != (3,):
                raise ValueError(f"points must have shape (..., 3), not {points.shape}")
            matrix = self.matrix()
            moved: np.ndarray = points @ matrix[:3, :3].T + matrix[:3, 3]
            return moved
        x, y, z = quaternions.rotate(quaternions.normalized(self.rotation), _floats(points, 3, "point (x, y, z)"))
        tx, ty, tz = self.translation
        return (x + tx, y + ty, z + tz)

    def interpolate(self, other: Transform, ratio: float) -> Transform:
        """Return the transform `ratio` of the way to `other`: a straight line, and the shorter arc.

        This is what tf2 does between two samples.  `ratio` is not limited to
        [0, 1], but tf2 never asks for more.
        """
        (ax, ay, az), (bx, by, bz) = self.translation, other.translation
        start = quaternions.normalized(self.rotation)
        end = quaternions.normalized(other.rotation)
        back = 1.0 - ratio
        return Transform(
            (back * ax + ratio * bx, back * ay + ratio * by, back * az + ratio * bz),
            quaternions.slerp(start, end, ratio),
        )


@dataclass(frozen=True, slots=True)
class StampedTransform:
    """A transform that says between which frames, and when: geometry_msgs/TransformStamped.

    Attributes:
        frame_id: the parent, or the target of a lookup.
        child_frame_id: the child, or the source of a lookup.
        stamp_ns: when it holds [ns].
        transform: `parent_T_child`.
    """

    frame_id: str
    child_frame_id: str
    stamp_ns: int
    transform: Transform


def pose_from_transform(transform: Transform) -> Pose:
    """Return the seven numbers of a transform, its rotation scaled to length one.

    Raises:
        ValueError: the rotation has no direction.
    """
    return (*transform.translation, *quaternions.normalized(transform.rotation))


# A frozen dataclass fills its fields through object.__setattr__, a slow call for each, and `Transform` looks at
# each number again.  The engine's own results need no looking at, so the two functions below fill the same slots
# directly: 0.3 us instead of 0.5 (through object.__setattr__) or 1.5 (through the class), of the 1.5 us of a lookup.
_new = object.__new__
_set_translation = Transform.translation.__set__  # type: ignore[attr-defined, misc]
_set_rotation = Transform.rotation.__set__  # type: ignore[attr-defined, misc]
_set_frame_id = StampedTransform.frame_id.__set__  # type: ignore[attr-defined, misc]
_set_child_frame_id = StampedTransform.child_frame_id.__set__  # type: ignore[attr-defined, misc]
_set_stamp_ns = StampedTransform.stamp_ns.__set__  # type: ignore[attr-defined, misc]
_set_transform = StampedTransform.transform.__set__  # type: ignore[attr-defined, misc]


def transform_from_pose(pose: Pose) -> Transform:
    """Return the transform with these seven numbers."""
    transform = _new(Transform)
    _set_translation(transform, pose[:3])
    _set_rotation(transform, pose[3:])
    return transform


def stamped_from_pose(frame_id: str, child_frame_id: str, stamp_ns: int, pose: Pose) -> StampedTransform:
    """Return the stamped transform with these seven numbers."""
    stamped = _new(StampedTransform)
    _set_frame_id(stamped, frame_id)
    _set_child_frame_id(stamped, child_frame_id)
    _set_stamp_ns(stamped, stamp_ns)
    _set_transform(stamped, transform_from_pose(pose))
    return stamped


def _floats(values: Sequence[float], count: int, what: str) -> tuple[float, ...]:
    """Return `values` as a tuple of `count` floats, or say what was expected.

    Raises:
        TypeError: not a sequence of numbers.
        ValueError: not `count` of them.
    """
    try:
        floats = tuple(map(float, values))
    except (TypeError, ValueError):
        raise TypeError(f"{what} needs {count} numbers, not {values!r}") from None
    if len(floats) != count:
        raise ValueError(f"{what} needs {count} numbers, not {len(floats)}: {values!r}")
    return floats


class TransformRecord(NamedTuple):
    """One transform of one message.

    Attributes:
        topic: as recorded, "/tf" or "/robot1/tf_static".
        receive_ns: when it was heard [ns], by the listener's clock.
        publisher: full name of the node, "/wheel_odometry"; "" if it is not known.
        stamped: frame names, stamp and numbers exactly as sent, valid or not.
        is_static: whether it came as a static transform: on a `/tf_static` topic.
    """

    topic: str
    receive_ns: int
    publisher: str
    stamped: StampedTransform
    is_static: bool
