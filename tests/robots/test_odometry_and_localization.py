"""Odometry is smooth and drifts; localization jumps and does not drift (REP-105)."""

import itertools
import math

import pytest

from tflab.core import seconds
from tflab.robots.motion import Drive, Leg
from tflab.robots.odometry import TRACK_M, WHEEL_RADIUS_M, Localizer, WheelOdometry


def off_m(a, b) -> float:
    return math.hypot(a.x - b.x, a.y - b.y)


def test_perfect_wheels_give_the_true_path():
    drive = Drive()
    wheels = WheelOdometry(drive, bias=0.0, slip=0.0)
    for t in (1.0, 5.0, 9.0, 25.0):
        believed = drive.start.then(wheels.pose_at(seconds(t)))
        assert off_m(believed, drive.pose_at(seconds(t))) < 1e-3


def test_wheels_turn_by_way_over_radius():
    drive = Drive([Leg(2.0, speed_mps=0.5)])
    wheels = WheelOdometry(drive, bias=0.0, slip=0.0)
    assert wheels.wheel_angles_at(seconds(3.0)) == pytest.approx((1.0 / WHEEL_RADIUS_M, 1.0 / WHEEL_RADIUS_M))
    assert wheels.twist_at(seconds(2.0)) == pytest.approx((0.5, 0.0))


def test_a_larger_right_wheel_bends_a_straight_path_to_the_left():
    drive = Drive([Leg(10.0, speed_mps=1.0)])
    wheels = WheelOdometry(drive, bias=0.003, slip=0.0)
    # 10 m with wheels that differ by 0.006 of the way: 0.06 m over a track of 0.3 m.
    assert wheels.pose_at(drive.end_ns).yaw == pytest.approx(0.06 / TRACK_M)


def test_odometry_drifts_but_never_jumps():
    drive = Drive()
    wheels = WheelOdometry(drive, seed=4)
    stamps = [seconds(1.0 + 0.05 * k) for k in range(2000)]
    poses = [wheels.pose_at(stamp) for stamp in stamps]
    assert max(off_m(a, b) for a, b in itertools.pairwise(poses)) < 0.05
    assert off_m(drive.start.then(poses[-1]), drive.pose_at(stamps[-1])) > 0.2
    again, other = (WheelOdometry(drive, seed=seed).pose_at(stamps[-1]) for seed in (4, 5))
    assert poses[-1] == again != other


def test_with_the_correction_the_robot_is_where_the_scan_saw_it():
    drive = Drive()
    wheels = WheelOdometry(drive)
    localizer = Localizer(drive, wheels, period_s=2.0, delay_s=0.1)
    scan_ns = seconds(41.0)
    in_force_ns = scan_ns + seconds(0.2)
    corrected = localizer.map_T_odom_at(in_force_ns).then(wheels.pose_at(scan_ns))
    assert corrected == pytest.approx(localizer.measured_at(scan_ns))
    assert off_m(corrected, drive.pose_at(scan_ns)) < 0.05


def test_a_correction_takes_effect_after_its_delay_and_stays_in_force():
    drive = Drive()
    localizer = Localizer(drive, WheelOdometry(drive), period_s=2.0, delay_s=0.1)
    before, after, later = (localizer.map_T_odom_at(seconds(t)) for t in (41.09, 41.11, 43.05))
    assert before != after
    assert after == later
    assert localizer.map_T_odom_at(drive.start_ns) == drive.start
