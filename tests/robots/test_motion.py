"""The true pose is a function of time, computed by hand."""

import math

import numpy as np
import pytest

from tflab.core import seconds
from tflab.robots.motion import LAP, Drive, Leg, PlanarPose


def test_a_straight_leg_and_a_turn_on_the_spot():
    drive = Drive([Leg(4.0, speed_mps=1.0), Leg(2.0, yaw_rate_radps=math.pi / 4)], start=PlanarPose(1.0, 2.0, 0.0))
    assert drive.pose_at(seconds(3.0)) == pytest.approx((3.0, 2.0, 0.0))  # 2 s after the start at 1 s
    assert drive.pose_at(seconds(7.0)) == pytest.approx((5.0, 2.0, math.pi / 2))


def test_an_arc_ends_where_its_circle_says():
    # A quarter of a circle of radius 2 m to the left, starting along y: from (0, 0) to (-2, 2).
    drive = Drive([Leg(10.0, 2.0 * math.pi / 20.0, math.pi / 20.0)], start=PlanarPose(0.0, 0.0, math.pi / 2))
    assert drive.pose_at(drive.end_ns) == pytest.approx((-2.0, 2.0, math.pi))


def test_before_the_start_and_after_the_end_the_robot_stands():
    drive = Drive([Leg(1.0, 1.0)], start=PlanarPose(0.0, 0.0, 0.0))
    assert drive.pose_at(0) == (0.0, 0.0, 0.0)
    assert drive.pose_at(seconds(100.0)) == pytest.approx((1.0, 0.0, 0.0))
    assert [drive.twist_at(seconds(t)) for t in (0.5, 1.5, 3.0)] == [(0.0, 0.0), (1.0, 0.0), (0.0, 0.0)]
    lap = Drive(LAP)
    assert lap.pose_at(lap.end_ns)[:2] == pytest.approx(lap.start[:2], abs=1e-9)


def test_many_poses_at_once_are_the_poses_one_by_one():
    drive = Drive()
    stamps = np.array([seconds(t) for t in (0.0, 1.5, 8.0, 8.7, 33.3)])
    assert drive.poses_at(stamps).tolist() == [list(drive.pose_at(stamp)) for stamp in stamps.tolist()]


def test_planar_steps_multiply_like_transforms_and_cancel():
    pose = PlanarPose(1.0, 2.0, 0.7)
    assert pose.then(pose.back()) == pytest.approx((0.0, 0.0, 0.0)) == pose.back().then(pose)
    a, b = PlanarPose(1.0, 2.0, 0.7), PlanarPose(-0.5, 0.3, 2.0)
    assert np.allclose(a.then(b).transform().matrix(), (a.transform() @ b.transform()).matrix())


@pytest.mark.parametrize("legs", [[], [Leg(0.0)], [Leg(1.0), Leg(-1.0)]])
def test_a_drive_without_a_leg_that_lasts_is_refused(legs):
    with pytest.raises(ValueError, match="at least one leg"):
        Drive(legs)
