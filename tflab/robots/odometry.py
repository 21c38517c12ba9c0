"""Where do the wheels think we are?  Counting turns, with slip and drift.

    encoder ticks --> how far each wheel rolled --> one small arc after another --> odom_T_base

    true path   o-----------.           odom   o----------.
                            |                             '.     smooth, never jumps,
                            |                               '.   and ever further off

Two errors are enough for what a robot does: one wheel is a little larger than the
other (a bias: the path bends), and the ground gives way by chance (slip).  Errors
are added up and never taken back, which is why `odom` drifts (REP-105).

Everything is worked out once, from a seed, when the object is made: the same stamp
always gives the same pose.
"""

from __future__ import annotations

import numpy as np

from tflab.core import NSEC_PER_SEC

from .chance import chance
from .motion import Drive, PlanarPose

__all__ = ["STEP_NS", "TRACK_M", "WHEEL_RADIUS_M", "WheelOdometry"]

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
        way, turned = np.diff(drive.rolled_at(drive.start_ns + STEP_NS * np.arange(steps + 1)), axis=0).T
        left, right = way - turned * TRACK_M / 2.0, way + turned * TRACK_M / 2.0
        slipped = chance(seed, "odometry").standard_normal((2, steps))
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
