"""Simulate wheel odometry with slip and drift, and a localizer that corrects map -> odom.

    map ---- corrected now and then ---> odom ---- smooth, drifting ---> base_footprint

    encoder ticks --> distance of each wheel --> small arcs, added up --> odom_T_base
    map_T_odom = map_T_base (measured) @ odom_T_base (at the same stamp).inverse()

The odometry has two errors: one wheel is a little larger than the other, and the
wheels slip at random. Errors add up, so `odom` drifts and never jumps (REP-105).

A localizer, such as AMCL or SLAM, measures `map_T_base` from scans. It cannot publish
that edge, because base_footprint already has a parent, so it publishes map -> odom.
Each correction is a jump of `odom` in `map`.

Everything is computed from a seed when the object is made: the same stamp always
gives the same pose.
"""

from __future__ import annotations

import numpy as np

from tflab.core import NSEC_PER_SEC, seconds

from .motion import Drive, PlanarPose
from .seeded_rng import seeded_rng

__all__ = ["STEP_NS", "TRACK_M", "WHEEL_RADIUS_M", "Localizer", "WheelOdometry"]


WHEEL_RADIUS_M = 0.10
TRACK_M = 0.30  # from wheel to wheel
STEP_NS = NSEC_PER_SEC // 100  # the wheels are read a hundred times a second


class WheelOdometry:
    """What the wheels of a drive report.

    Args:
        bias: how much larger the right wheel seems than it is, as a fraction; the left one
            seems smaller by the same.
        slip: standard deviation of what a wheel loses or gains by chance, as a fraction of
            the way, for steps of one metre; over longer ways it averages out as chance does.
        seed: of the slip.
    """

    def __init__(self, drive: Drive, bias: float = 0.002, slip: float = 0.003, seed: int = 0) -> None:
        self._start_ns = drive.start_ns
        steps = -(-(drive.end_ns - drive.start_ns) // STEP_NS)
        moments_ns = drive.start_ns + STEP_NS * np.arange(steps + 1, dtype=np.int64)
        way, turned = np.diff(drive.rolled_at(moments_ns), axis=0).T
        left, right = way - turned * TRACK_M / 2.0, way + turned * TRACK_M / 2.0
        slipped = seeded_rng(seed, "odometry").standard_normal((2, steps))
        left = left * (1.0 - bias) + slip * np.sqrt(np.abs(left)) * slipped[0]
        right = right * (1.0 + bias) + slip * np.sqrt(np.abs(right)) * slipped[1]
        self._rolled = np.cumsum(np.pad(np.stack([left, right], axis=1), ((1, 0), (0, 0))), axis=0)
        forward, turn = (left + right) / 2.0, (right - left) / TRACK_M
        yaw = np.cumsum(turn)
        heading = yaw - turn / 2.0  # each small arc is driven along the middle of its turn
        path = np.stack([np.cumsum(forward * np.cos(heading)), np.cumsum(forward * np.sin(heading)), yaw], axis=1)
        self._path = np.pad(path, ((1, 0), (0, 0)))

    def pose_at(self, stamp_ns: int) -> PlanarPose:
        """Return `odom_T_base_footprint` as the wheels have it; it begins at (0, 0, 0)."""
        return PlanarPose(*_between(self._path, stamp_ns - self._start_ns))

    def twist_at(self, stamp_ns: int) -> tuple[float, float]:
        """Return (forward speed [m/s], yaw rate [rad/s]), averaged over the last 50 ms."""
        span_ns = 5 * STEP_NS
        now = self._rolled_at(stamp_ns)
        before = self._rolled_at(stamp_ns - span_ns)
        left, right = ((b - a) / (span_ns / NSEC_PER_SEC) for a, b in zip(before, now, strict=True))
        return (left + right) / 2.0, (right - left) / TRACK_M

    def wheel_angles_at(self, stamp_ns: int) -> tuple[float, float]:
        """Return how far the left and the right wheel have turned [rad]."""
        left, right = self._rolled_at(stamp_ns)
        return left / WHEEL_RADIUS_M, right / WHEEL_RADIUS_M

    def _rolled_at(self, stamp_ns: int) -> tuple[float, ...]:
        return _between(self._rolled, stamp_ns - self._start_ns)


def _between(table: np.ndarray, elapsed_ns: int) -> tuple[float, ...]:
    """Return a row of a table of one row a step, on the straight line between two; outside, its ends."""
    place = min(max(elapsed_ns / STEP_NS, 0.0), len(table) - 1.0)
    before = min(int(place), len(table) - 2)
    ratio = place - before
    return tuple(((1.0 - ratio) * table[before] + ratio * table[before + 1]).tolist())


class Localizer:
    """Corrects the drift of a wheel odometry.

    Args:
        period_s: time between corrections [s].
        delay_s: time from the scan to the correction that it leads to [s].
        sigma_m, sigma_rad: standard deviation of the measured position [m] and heading [rad].
        seed: of those errors.
    """

    def __init__(
        self,
        drive: Drive,
        odometry: WheelOdometry,
        period_s: float = 2.0,
        delay_s: float = 0.1,
        sigma_m: float = 0.01,
        sigma_rad: float = 0.003,
        seed: int = 0,
    ) -> None:
        self._drive, self._odometry = drive, odometry
        self._period_ns, self._delay_ns = seconds(period_s), seconds(delay_s)
        self._sigmas = np.array([sigma_m, sigma_m, sigma_rad])
        self._seed = seed

    def map_T_odom_at(self, stamp_ns: int) -> PlanarPose:
        """Return the correction in force at `stamp_ns` [ns]."""
        number = max((stamp_ns - self._delay_ns - self._drive.start_ns) // self._period_ns, 0)
        scan_ns = self._drive.start_ns + number * self._period_ns
        return self.measured_at(scan_ns).then(self._odometry.pose_at(scan_ns).back())

    def measured_at(self, scan_ns: int) -> PlanarPose:
        """Return `map_T_base_footprint` as a scan at `scan_ns` [ns] shows it: the truth, nearly.

        The first pose is given, as a person does by hand at the start, so it is exact.
        """
        truth = self._drive.pose_at(scan_ns)
        if scan_ns <= self._drive.start_ns:
            return truth
        error = seeded_rng(self._seed, "localization", scan_ns).standard_normal(3) * self._sigmas
        return PlanarPose(*(np.array(truth) + error).tolist())
