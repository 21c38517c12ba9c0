"""Quaternions (x, y, z, w): REP-103's signs by hand, and the laws of rotations."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tflab.core import quaternions as q

HALF, QUARTER = math.sqrt(0.5), math.pi / 2
numbers = st.floats(-1, 1).map(lambda c: round(c, 6))
rotations = st.tuples(numbers, numbers, numbers, numbers).filter(lambda r: math.hypot(*r) > 0.1).map(q.normalized)
angles = st.floats(-3.1, 3.1)


def same_rotation(a: q.Quaternion, b: q.Quaternion) -> bool:
    return q.angle(a, b) < 1e-7


@pytest.mark.parametrize(
    ("rpy", "before", "after"),
    [
        ((0, 0, QUARTER), (1, 0, 0), (0, 1, 0)),  # yaw turns forward to the left
        ((0, QUARTER, 0), (1, 0, 0), (0, 0, -1)),  # pitch turns the nose down
        ((QUARTER, 0, 0), (0, 1, 0), (0, 0, 1)),  # roll turns left to up
        ((QUARTER, QUARTER, QUARTER), (0, 1, 0), (0, 1, 0)),  # roll takes y to z, then pitch to x, then yaw to y
    ],
)
def test_roll_pitch_and_yaw_turn_about_fixed_axes_in_that_order(rpy, before, after) -> None:
    assert q.rotate(q.from_rpy(*rpy), before) == pytest.approx(after)


def test_the_optical_frame_looks_along_z_with_x_to_the_right_and_y_down() -> None:
    optical = q.from_rpy(-math.pi / 2, 0, -math.pi / 2)
    assert optical == pytest.approx((-0.5, 0.5, -0.5, 0.5))
    assert q.rotate(optical, (0, 0, 1)) == pytest.approx((1, 0, 0))
    assert q.rotate(optical, (1, 0, 0)) == pytest.approx((0, -1, 0))
    assert q.rotate(optical, (0, 1, 0)) == pytest.approx((0, 0, -1))


@given(rotations, rotations, st.tuples(numbers, numbers, numbers))
def test_a_product_turns_by_the_right_factor_first(a, b, v) -> None:
    assert q.rotate(q.multiply(a, b), v) == pytest.approx(q.rotate(a, q.rotate(b, v)), abs=1e-12)


@given(rotations)
def test_a_rotation_survives_matrix_and_angles(r) -> None:
    assert same_rotation(q.from_matrix(q.to_matrix(r)), r)
    assert same_rotation(q.from_rpy(*q.to_rpy(r)), r)


@given(angles, st.sampled_from([math.pi / 2, -math.pi / 2]), angles)
def test_angles_are_recovered_as_a_rotation_even_when_looking_straight_up_or_down(roll, pitch, yaw) -> None:
    r = q.from_rpy(roll, pitch, yaw)
    assert same_rotation(q.from_rpy(*q.to_rpy(r)), r)


@given(rotations, rotations, st.floats(0, 1))
def test_slerp_is_the_same_from_q_and_from_minus_q(a, b, ratio) -> None:
    if abs(sum(x * y for x, y in zip(a, b, strict=True))) < 1e-6:
        return  # half a turn apart: both ways round are equally short
    minus_b = tuple(-c for c in b)
    assert same_rotation(q.slerp(a, b, ratio), q.slerp(a, minus_b, ratio))
    assert q.angle(a, q.slerp(a, b, ratio)) == pytest.approx(ratio * q.angle(a, b), abs=1e-6)


def test_scaling_and_sign_are_canonical() -> None:
    assert q.canonical((0, 0, 0, -2)) == (0, 0, 0, 1)
    assert q.canonical((0, 0, -1, 0)) == (0, 0, 1, 0)
    assert all(map(math.isnan, q.canonical((0, 0, 0, 0))))
    for bad in ((0, 0, 0, 0), (math.nan, 0, 0, 1), (math.inf, 0, 0, 0)):
        with pytest.raises(ValueError, match=r"'No rotation' is \(0, 0, 0, 1\)"):
            q.normalized(bad)


def test_order_is_changed_by_name_at_the_border() -> None:
    assert q.xyzw_from_wxyz((1, 2, 3, 4)) == (2, 3, 4, 1)
    assert q.wxyz_from_xyzw((2, 3, 4, 1)) == (1, 2, 3, 4)


def test_a_rotation_from_axis_and_angle() -> None:
    assert q.from_axis_angle((0, 0, 9), math.pi / 2) == pytest.approx((0, 0, HALF, HALF))
    assert q.angle(q.from_axis_angle((1, 1, 0), 0.3)) == pytest.approx(0.3)
    with pytest.raises(ValueError, match="no direction"):
        q.from_axis_angle((0, 0, 0), 1.0)
