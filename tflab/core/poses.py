"""Compose and invert poses, as plain tuples (x, y, z, qx, qy, qz, qw).

    (x, y, z, qx, qy, qz, qw)        a translation [m] and a unit quaternion

    map_T_base = compose(map_T_odom, odom_T_base)
    odom_T_map = invert(map_T_odom)

`Transform` is the public class of these numbers. The engine passes them as a plain
tuple, because a lookup may touch thousands of them. (The rigid motions SE(3).)
"""

from __future__ import annotations

from math import sqrt

from . import quaternions

__all__ = [
    "A_BIT",
    "HALF_AND_A_BIT",
    "IDENTITY_POSE",
    "Pose",
    "Sent",
    "are_ordinary_numbers",
    "canonical_pose",
    "compose",
    "invert",
    "through_matrix",
    "unit_pose",
]

Pose = tuple[float, float, float, float, float, float, float]  # x, y, z [m], then qx, qy, qz, qw
Sent = tuple[float, ...]  # the same seven, as somebody sent them: they are stored unread

IDENTITY_POSE: Pose = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)

A_BIT = 1e-7  # closer than this, rounding may decide between q and -q
HALF_AND_A_BIT = 0.5 + A_BIT


def compose(outer: Pose, inner: Pose) -> Pose:
    """Return the pose "first `inner`, then `outer`", both of unit rotation."""
    x, y, z, qx, qy, qz, qw = inner
    tx, ty, tz, ax, ay, az, aw = outer
    # outer's rotation of (x, y, z), as in quaternions.rotate ...
    cx = ay * z - az * y
    cy = az * x - ax * z
    cz = ax * y - ay * x
    cx, cy, cz = cx + cx, cy + cy, cz + cz
    return (
        x + aw * cx + ay * cz - az * cy + tx,
        y + aw * cy + az * cx - ax * cz + ty,
        z + aw * cz + ax * cy - ay * cx + tz,
        # ... and the product of both rotations, as in quaternions.multiply
        aw * qx + ax * qw + ay * qz - az * qy,
        aw * qy + ay * qw + az * qx - ax * qz,
        aw * qz + az * qw + ax * qy - ay * qx,
        aw * qw - ax * qx - ay * qy - az * qz,
    )


def invert(pose: Pose) -> Pose:
    """Return the opposite of a pose of unit rotation: turn back, then undo the step along the turned axes."""
    x, y, z, qx, qy, qz, qw = pose
    # quaternions.rotate of (-x, -y, -z) by (-qx, -qy, -qz, qw), in which two signs cancel
    cx = qy * z - qz * y
    cy = qz * x - qx * z
    cz = qx * y - qy * x
    cx, cy, cz = cx + cx, cy + cy, cz + cz
    return (
        -x + qw * cx - qy * cz + qz * cy,
        -y + qw * cy - qz * cx + qx * cz,
        -z + qw * cz - qx * cy + qy * cx,
        -qx,
        -qy,
        -qz,
        qw,
    )


def are_ordinary_numbers(pose: Pose) -> bool:
    """Return whether seven numbers need no closer look: finite, and the quaternion has a direction."""
    x, y, z, qx, qy, qz, qw = pose
    squared_length = qx * qx + qy * qy + qz * qz + qw * qw
    total = x + y + z + squared_length  # not finite if any of them is not
    return 1e-300 < squared_length < 1e300 and total - total == 0.0


def through_matrix(pose: Sent) -> Pose:
    """Return a pose as tf2 stores it, to the last digit: its rotation made a matrix, and that a quaternion."""
    x, y, z, qx, qy, qz, qw = pose
    return (x, y, z, *quaternions.canonical((qx, qy, qz, qw)))


def unit_pose(pose: Pose) -> Pose:
    """Return a pose with its rotation scaled to length one; tf2's way for a length out of all proportion."""
    x, y, z, qx, qy, qz, qw = pose
    squared_length = qx * qx + qy * qy + qz * qz + qw * qw
    if not 1e-300 < squared_length < 1e300:
        return through_matrix(pose)
    scale = 1.0 / sqrt(squared_length)
    return (x, y, z, qx * scale, qy * scale, qz * scale, qw * scale)


def canonical_pose(pose: Pose) -> Pose:
    """Return a pose of unit rotation with the sign of the quaternion that tf2 would print.

    The rule is that of `quaternions.from_matrix`: w decides if the turn is less
    than 120 degrees, else the largest of x, y, z.  Where two are so close that the
    last digit decides, the pose goes tf2's way, through a matrix and back.
    """
    if pose[6] > HALF_AND_A_BIT:
        return pose
    x, y, z, qx, qy, qz, qw = pose
    if qw < -HALF_AND_A_BIT:
        return (x, y, z, -qx, -qy, -qz, -qw)
    _, middle, largest = sorted((abs(qx), abs(qy), abs(qz)))
    if abs(qw) > 0.5 - A_BIT or largest - middle < A_BIT:
        return through_matrix(pose)
    is_positive = largest in (qx, qy, qz)
    return pose if is_positive else (x, y, z, -qx, -qy, -qz, -qw)
