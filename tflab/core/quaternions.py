"""Compute with quaternions (x, y, z, w).

    (x, y, z) = axis * sin(angle / 2)        w = cos(angle / 2)

    (0, 0, 0, 1)                no rotation
    (0, 0, 0, 0)                nothing at all: not a rotation
    (0, 0, sin(a/2), cos(a/2))  turn left by a: a yaw
    q and -q                    the same rotation

The axes are those of REP-103: right-handed, x forward, y left, z up; angles in
radians, positive by the right-hand rule, so a positive yaw turns left.  Roll,
pitch and yaw turn about the *fixed* x, y and z axes, in that order.

Every function is plain arithmetic on tuples of floats.  Where tf2's rounding
can be seen (`to_matrix`, `from_matrix`, `slerp`), the order of operations is
that of tf2/LinearMath.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from math import acos, atan2, cos, sin, sqrt

__all__ = [
    "IDENTITY",
    "Matrix3",
    "Quaternion",
    "Vector3",
    "angle",
    "canonical",
    "conjugate",
    "from_axis_angle",
    "from_matrix",
    "from_rpy",
    "multiply",
    "normalized",
    "rotate",
    "slerp",
    "to_matrix",
    "to_rpy",
    "wxyz_from_xyzw",
    "xyzw_from_wxyz",
]

Vector3 = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]  # x, y, z, w
Matrix3 = tuple[Vector3, Vector3, Vector3]  # three rows

IDENTITY: Quaternion = (0.0, 0.0, 0.0, 1.0)
_NAN: Quaternion = (math.nan, math.nan, math.nan, math.nan)


def multiply(a: Quaternion, b: Quaternion) -> Quaternion:
    """Return the rotation "first `b`, then `a`"."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by + ay * bw + az * bx - ax * bz,
        aw * bz + az * bw + ax * by - ay * bx,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def conjugate(q: Quaternion) -> Quaternion:
    """Return the opposite rotation of the unit quaternion `q`."""
    x, y, z, w = q
    return (-x, -y, -z, w)


def rotate(q: Quaternion, v: Sequence[float]) -> Vector3:
    """Turn the vector `v` [any unit], shape (3,), by the unit quaternion `q`."""
    qx, qy, qz, qw = q
    x, y, z = v
    # v + 2w (u x v) + 2 u x (u x v), where u = (qx, qy, qz)
    cx = qy * z - qz * y
    cy = qz * x - qx * z
    cz = qx * y - qy * x
    cx, cy, cz = cx + cx, cy + cy, cz + cz
    return (
        x + qw * cx + qy * cz - qz * cy,
        y + qw * cy + qz * cx - qx * cz,
        z + qw * cz + qx * cy - qy * cx,
    )


def normalized(q: Sequence[float]) -> Quaternion:
    """Return `q` scaled to length one.

    Raises:
        ValueError: `q` has no direction: all zeros, NaN or infinite.
    """
    x, y, z, w = q
    length = math.hypot(x, y, z, w)
    if not 0.0 < length < math.inf:
        raise ValueError(
            f"({x}, {y}, {z}, {w}) is not a rotation: a quaternion (x, y, z, w) needs a finite length "
            "above zero. 'No rotation' is (0, 0, 0, 1)"
        )
    return (x / length, y / length, z / length, w / length)


def angle(a: Quaternion, b: Quaternion = IDENTITY) -> float:
    """Return the angle [rad] between two rotations, in [0, pi]."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    distance = math.hypot(ax - bx, ay - by, az - bz, aw - bw)
    opposite = math.hypot(ax + bx, ay + by, az + bz, aw + bw)
    return 4.0 * atan2(min(distance, opposite), max(distance, opposite))


def slerp(a: Quaternion, b: Quaternion, ratio: float) -> Quaternion:
    """Return the rotation `ratio` of the way from `a` to `b`, along the shorter arc.

    Both are unit quaternions.  (tf2/LinearMath/Quaternion.hpp, slerp)
    """
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    dot = ax * bx + ay * by + az * bz + aw * bw
    if dot < 0.0:  # b and -b are one rotation: go the short way
        bx, by, bz, bw, dot = -bx, -by, -bz, -bw, -dot
    lengths = sqrt((ax * ax + ay * ay + az * az + aw * aw) * (bx * bx + by * by + bz * bz + bw * bw))
    theta = acos(min(1.0, dot / lengths))
    if theta == 0.0:
        return a
    scale = 1.0 / sin(theta)
    from_a = sin((1.0 - ratio) * theta)
    from_b = sin(ratio * theta)
    return (
        (from_a * ax + from_b * bx) * scale,
        (from_a * ay + from_b * by) * scale,
        (from_a * az + from_b * bz) * scale,
        (from_a * aw + from_b * bw) * scale,
    )


def to_matrix(q: Sequence[float]) -> Matrix3:
    """Return the rotation matrix (rows) of a quaternion of any length but zero."""
    x, y, z, w = q
    s = 2.0 / (x * x + y * y + z * z + w * w)
    xs, ys, zs = x * s, y * s, z * s
    wx, wy, wz = w * xs, w * ys, w * zs
    xx, xy, xz = x * xs, x * ys, x * zs
    yy, yz, zz = y * ys, y * zs, z * zs
    return (
        (1.0 - (yy + zz), xy - wz, xz + wy),
        (xy + wz, 1.0 - (xx + zz), yz - wx),
        (xz - wy, yz + wx, 1.0 - (xx + yy)),
    )


def from_matrix(matrix: Sequence[Sequence[float]]) -> Quaternion:
    """Return the unit quaternion of a rotation matrix (rows).

    Of q and -q, tf2 takes the one whose w is positive if the matrix has a
    positive trace, else the one whose largest of x, y, z is positive.
    """
    (m00, m01, m02), (m10, m11, m12), (m20, m21, m22) = matrix
    trace = m00 + m11 + m22
    if trace > 0.0:
        s = sqrt(trace + 1.0)
        w = s * 0.5
        s = 0.5 / s
        return ((m21 - m12) * s, (m02 - m20) * s, (m10 - m01) * s, w)
    i = (2 if m11 < m22 else 1) if m00 < m11 else (2 if m00 < m22 else 0)
    j, k = (i + 1) % 3, (i + 2) % 3
    s = sqrt(matrix[i][i] - matrix[j][j] - matrix[k][k] + 1.0)
    q = [0.0, 0.0, 0.0, 0.0]
    q[i] = s * 0.5
    s = 0.5 / s
    q[3] = (matrix[k][j] - matrix[j][k]) * s
    q[j] = (matrix[j][i] + matrix[i][j]) * s
    q[k] = (matrix[k][i] + matrix[i][k]) * s
    return (q[0], q[1], q[2], q[3])


def canonical(q: Sequence[float]) -> Quaternion:
    """Return `q` as tf2 stores it: through a matrix and back, so of length one and of one sign.

    A quaternion without direction (zeros, NaN, infinite) comes out as NaN.
    """
    x, y, z, w = q
    try:
        # from_matrix(to_matrix(q)), with only those elements that are needed if the trace is positive.
        s = 2.0 / (x * x + y * y + z * z + w * w)
        xs, ys, zs = x * s, y * s, z * s
        xx, yy, zz = x * xs, y * ys, z * zs
        trace = (1.0 - (yy + zz)) + (1.0 - (xx + zz)) + (1.0 - (xx + yy))
        if trace > 0.0:
            wx, wy, wz = w * xs, w * ys, w * zs
            xy, xz, yz = x * ys, x * zs, y * zs
            root = sqrt(trace + 1.0)
            s = 0.5 / root
            return (
                ((yz + wx) - (yz - wx)) * s,
                ((xz + wy) - (xz - wy)) * s,
                ((xy + wz) - (xy - wz)) * s,
                root * 0.5,
            )
        return from_matrix(to_matrix(q))
    except (ZeroDivisionError, ValueError):  # 2 / 0, or the root of a negative number
        return _NAN


def from_axis_angle(axis: Sequence[float], angle_rad: float) -> Quaternion:
    """Return the turn by `angle_rad` [rad] about `axis`, shape (3,), of any length but zero.

    Raises:
        ValueError: `axis` is all zeros, NaN or infinite.
    """
    x, y, z = axis
    length = math.hypot(x, y, z)
    if not 0.0 < length < math.inf:
        raise ValueError(f"axis ({x}, {y}, {z}) has no direction")
    s = sin(0.5 * angle_rad) / length
    return (x * s, y * s, z * s, cos(0.5 * angle_rad))


def from_rpy(roll: float, pitch: float, yaw: float) -> Quaternion:
    """Return the rotation by `roll`, then `pitch`, then `yaw` [rad] about the fixed x, y, z axes."""
    sr, cr = sin(0.5 * roll), cos(0.5 * roll)
    sp, cp = sin(0.5 * pitch), cos(0.5 * pitch)
    sy, cy = sin(0.5 * yaw), cos(0.5 * yaw)
    return (
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )


def to_rpy(q: Sequence[float]) -> Vector3:
    """Return (roll, pitch, yaw) [rad] about the fixed x, y, z axes, pitch in [-pi/2, pi/2].

    Looking straight up or down (|pitch| = pi/2), roll and yaw turn about the
    same line: like tf2 we call yaw zero there, and put the whole turn into roll.
    """
    (m00, _, _), (m10, m11, m12), (m20, m21, m22) = to_matrix(q)
    level = math.hypot(m00, m10)  # the cosine of pitch
    pitch = atan2(-m20, level)
    if level < 1e-12:
        return (atan2(-m12, m11), pitch, 0.0)
    return (atan2(m21, m22), pitch, atan2(m10, m00))


def xyzw_from_wxyz(q_wxyz: Sequence[float]) -> Quaternion:
    """Return (x, y, z, w) of a quaternion written w first, as Eigen's constructor or MuJoCo do."""
    w, x, y, z = q_wxyz
    return (x, y, z, w)


def wxyz_from_xyzw(q: Sequence[float]) -> Quaternion:
    """Return (w, x, y, z) of our (x, y, z, w)."""
    x, y, z, w = q
    return (w, x, y, z)
