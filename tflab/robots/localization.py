"""How is drift cured?  A localiser corrects map -> odom, and leaves odom -> base alone.

    map ---- corrected now and then ---> odom ---- smooth, drifting ---> base_footprint

    map_T_odom = map_T_base (measured) @ odom_T_base (at the same stamp).inverse()

A localiser compares the scan with the map and finds `map_T_base`.  It may not
publish that: base_footprint already has a parent.  So it publishes the one edge
that makes the sum come out right, and every correction is a jump of `odom` in
`map` (REP-105).  Between corrections the last one stays in force.

AMCL and SLAM work like this.
"""

from __future__ import annotations

import numpy as np

from tflab.core import seconds

from .chance import chance
from .motion import Drive, PlanarPose
from .odometry import WheelOdometry

__all__ = ["Localizer"]


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
        error = chance(self._seed, "localization", scan_ns).standard_normal(3) * self._sigmas
        return PlanarPose(*(np.array(truth) + error).tolist())
