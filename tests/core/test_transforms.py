"""Transforms: composition, inverse, points and interpolation."""

from __future__ import annotations

import dataclasses
import math
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tflab.core import StampedTransform, Transform

numbers = st.floats(-5, 5).map(lambda c: round(c, 6))
vectors = st.tuples(numbers, numbers, numbers)
transforms = st.builds(
    Transform, vectors, st.tuples(numbers, numbers, numbers, numbers).filter(lambda q: math.hypot(*q) > 0.1)
)


def test_a_laser_yawed_left_measures_ahead_what_is_left_of_the_robot_and_the_inverse_is_rotated_back() -> None:
    base_T_laser = Transform.from_rpy(yaw=math.pi / 2, translation=(0.20, 0.0, 0.15))
    assert base_T_laser.apply((2.0, 0.0, 0.0)) == pytest.approx((0.20, 2.0, 0.15))
    assert base_T_laser.inverse().translation == pytest.approx((0.0, 0.20, -0.15))


@given(transforms, transforms, vectors)
def test_a_product_applies_its_right_factor_first(a, b, point) -> None:
    assert (a @ b).apply(point) == pytest.approx(a.apply(b.apply(point)), abs=1e-9)
    assert np.allclose((a @ b).matrix(), a.matrix() @ b.matrix(), atol=1e-9)


@given(transforms, vectors)
def test_inverse_times_transform_is_identity(a, point) -> None:
    assert a.inverse().apply(a.apply(point)) == pytest.approx(point, abs=1e-9)
    assert np.allclose((a.inverse() @ a).matrix(), np.eye(4), atol=1e-9)
    assert np.allclose(Transform.from_matrix(a.matrix()).matrix(), a.matrix(), atol=1e-9)


def test_an_array_of_points_stays_an_array() -> None:
    lifted = Transform((0, 0, 1)).apply(np.zeros((5, 2, 3)))
    assert lifted.shape == (5, 2, 3)
    assert (lifted[..., 2] == 1).all()
    with pytest.raises(ValueError, match=r"shape \(\.\.\., 3\)"):
        Transform().apply(np.zeros((3, 4)))


def test_interpolation_is_linear_in_position_and_takes_the_shorter_arc() -> None:
    start, end = Transform((0, 0, 0)), Transform.from_rpy(yaw=3.0, translation=(2, 0, 0))
    halfway = start.interpolate(end, 0.5)
    assert halfway.translation == (1, 0, 0)
    assert halfway.rpy() == pytest.approx((0, 0, 1.5))
    back = Transform.from_rpy(yaw=3.0).interpolate(Transform.from_rpy(yaw=-3.0), 0.5)
    assert abs(back.rpy()[2]) == pytest.approx(math.pi)  # through pi, not through zero


def test_values_are_frozen_plain_and_comparable() -> None:
    transform = Transform(np.array([1, 2, 3]), [0, 0, 0, 1])
    assert transform == Transform((1.0, 2.0, 3.0))
    assert all(type(c) is float for c in transform.translation + transform.rotation)
    with pytest.raises(dataclasses.FrozenInstanceError):
        transform.translation = (0, 0, 0)
    stamped = StampedTransform("map", "odom", 5, transform)
    assert dataclasses.replace(stamped, stamp_ns=6).stamp_ns == 6
    assert pickle.loads(pickle.dumps(stamped)) == stamped
    assert hash(stamped) == hash(StampedTransform("map", "odom", 5, transform))


@pytest.mark.parametrize(
    ("make", "error", "text"),
    [
        (lambda: Transform((1, 2)), ValueError, "translation .* needs 3 numbers, not 2"),
        (lambda: Transform((1, 2, "three")), TypeError, "needs 3 numbers"),
        (lambda: Transform((0, 0, 0), (0, 0, 0)), ValueError, r"rotation \(x, y, z, w\) needs 4 numbers, not 3"),
        (lambda: Transform(rotation=(0, 0, 0, 0)).apply((1, 0, 0)), ValueError, "is not a rotation"),
        (lambda: Transform.from_matrix(np.eye(3)), ValueError, r"shape \(4, 4\)"),
        (lambda: Transform.from_matrix(2 * np.eye(4)), ValueError, "last row"),
        (lambda: Transform.from_matrix(np.diag([2, 1, 1, 1])), ValueError, "not a rotation"),
        (lambda: Transform.from_matrix(np.diag([1, 1, -1, 1])), ValueError, "mirror"),
        (lambda: Transform() @ (1, 2, 3), TypeError, r"a_p = a_T_b\.apply\(b_p\)"),
        (lambda: Transform() @ np.array([1.0, 2.0, 3.0]), TypeError, r"a_p = a_T_b\.apply\(b_p\)"),
    ],
)
def test_an_invalid_transform_is_refused_with_what_was_expected(make, error, text) -> None:
    with pytest.raises(error, match=text):
        make()
