"""Offer what people use of tf_transformations: 4x4 matrices, and quaternions (x, y, z, w).

    "sxyz"   rotate about the fixed axes x, then y, then z: roll, pitch, yaw (the default)
    "rzyx"   rotate about the moving axes z, then y, then x: yaw, pitch, roll

`packages.yaml` adds those functions that NumPy or the engine has under another name.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import reduce

import numpy as np

from tflab.core import quaternions

EPSILON = 4.0 * np.finfo(float).eps


def translation_matrix(direction: Sequence[float]) -> np.ndarray:
    """Return the matrix of a translation."""
    matrix = np.identity(4)
    matrix[:3, 3] = direction[:3]
    return matrix


def translation_from_matrix(matrix: np.ndarray) -> np.ndarray:
    """Return the translation of a matrix."""
    return np.array(matrix, dtype=float)[:3, 3]


def concatenate_matrices(*matrices: np.ndarray) -> np.ndarray:
    """Return the product of matrices."""
    return reduce(np.dot, matrices, np.identity(4))


def euler_matrix(ai: float, aj: float, ak: float, axes: str = "sxyz") -> np.ndarray:
    """Return the matrix of three rotations [rad]."""
    return quaternion_matrix(quaternion_from_euler(ai, aj, ak, axes))


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: str = "sxyz") -> quaternions.Quaternion:
    """Return the quaternion of three rotations [rad]."""
    units = [np.identity(3)["xyz".index(axis)] for axis in axes[1:]]
    turns = list(map(quaternion_about_axis, (ai, aj, ak), units))
    return reduce(quaternions.multiply, turns if axes[0] == "r" else turns[::-1])


def euler_from_quaternion(quaternion: Sequence[float], axes: str = "sxyz") -> tuple[float, float, float]:
    """Return the three rotations [rad] of a quaternion."""
    return euler_from_matrix(quaternion_matrix(quaternion), axes)


def euler_from_matrix(matrix: np.ndarray, axes: str = "sxyz") -> tuple[float, float, float]:
    """Return the three rotations [rad] of a matrix; the last one is 0 where only their sum is known."""
    i, j, last = ("xyz".index(axis) for axis in (axes[1:] if axes[0] == "s" else axes[:0:-1]))
    k, m = 3 - i - j, np.asarray(matrix, dtype=float)
    if last == i:  # as in "szxz"
        size = math.hypot(m[i, j], m[i, k])
        pairs = [(m[i, j], m[i, k]), (size, m[i, i]), (m[j, i], -m[k, i])]
    else:
        size = math.hypot(m[i, i], m[j, i])
        pairs = [(m[k, j], m[k, k]), (-m[k, i], size), (m[j, i], m[i, i])]
    if size < EPSILON:
        pairs = [(-m[j, k], m[j, j]), pairs[1], (0.0, 1.0)]
    sign = 1.0 if (j - i) % 3 == 1 else -1.0  # whether i, j follow one another as x, y, z do
    angles = tuple(sign * math.atan2(*pair) for pair in pairs)
    return angles if axes[0] == "s" else angles[::-1]


def quaternion_about_axis(angle: float, axis: Sequence[float]) -> quaternions.Quaternion:
    """Return the quaternion of a rotation [rad] about an axis."""
    return quaternions.from_axis_angle(axis, angle)


def quaternion_matrix(quaternion: Sequence[float]) -> np.ndarray:
    """Return the matrix of a quaternion."""
    matrix = np.identity(4)
    if np.dot(quaternion, quaternion) > EPSILON:
        matrix[:3, :3] = quaternions.to_matrix(quaternion)
    return matrix


def quaternion_from_matrix(matrix: np.ndarray) -> quaternions.Quaternion:
    """Return the quaternion of a matrix; its w is not negative."""
    quaternion = quaternions.from_matrix(np.asarray(matrix)[:3, :3].tolist())
    return tuple(-value for value in quaternion) if quaternion[3] < 0.0 else quaternion


def quaternion_conjugate(quaternion: Sequence[float]) -> np.ndarray:
    """Return the conjugate of a quaternion."""
    return np.multiply(quaternion, (-1.0, -1.0, -1.0, 1.0))


def quaternion_inverse(quaternion: Sequence[float]) -> np.ndarray:
    """Return the inverse of a quaternion of any length."""
    return quaternion_conjugate(quaternion) / np.dot(quaternion, quaternion)


def quaternion_slerp(
    quat0: Sequence[float], quat1: Sequence[float], fraction: float, spin: int = 0, shortestpath: bool = True
) -> np.ndarray:
    """Return the rotation between two others, with `spin` half turns more."""
    begin, end = (np.divide(each, np.linalg.norm(each)) for each in (quat0, quat1))
    cosine = float(np.dot(begin, end))
    if fraction in (0.0, 1.0) or 1.0 - abs(cosine) < EPSILON:
        return end if fraction == 1.0 else begin
    sign = -1.0 if shortestpath and cosine < 0.0 else 1.0
    angle = math.acos(sign * cosine) + spin * math.pi
    return (math.sin((1.0 - fraction) * angle) * begin + math.sin(fraction * angle) * sign * end) / math.sin(angle)
