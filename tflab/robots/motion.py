"""Define the true motion of a robot: its pose as a function of time.

    Leg(4 s, 0.5 m/s straight)  Leg(2 s, turning left)  ...
    start o------------------------.
                                    \\      pose_at(stamp_ns) -> (x, y, yaw) in map
                                     |

A leg keeps its speed and its yaw rate, so the robot follows straight lines and
arcs, and where it is at any moment can be worked out with a pencil.  Nothing is
integrated step by step: the same stamp always gives the same pose, however often
and in whichever order you ask.  No sensor ever sees this pose as it is.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tflab.core import NSEC_PER_SEC, Transform, seconds

__all__ = ["LAP", "START", "Drive", "Leg", "PlanarPose"]


class PlanarPose(NamedTuple):
    """A pose on the floor: x, y [m] and yaw [rad], x forward and y left (REP-103)."""

    x: float
    y: float
    yaw: float

    def transform(self) -> Transform:
        """Return the same in three dimensions."""
        return Transform.from_rpy(yaw=self.yaw, translation=(self.x, self.y, 0.0))

    def then(self, step: PlanarPose) -> PlanarPose:
        """Return `a_T_c` from this `a_T_b` and the step `b_T_c`."""
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        return PlanarPose(
            self.x + c * step.x - s * step.y,
            self.y + s * step.x + c * step.y,
            self.yaw + step.yaw,
        )

    def back(self) -> PlanarPose:
        """Return the opposite, `b_T_a` of `a_T_b`."""
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        return PlanarPose(-c * self.x - s * self.y, s * self.x - c * self.y, -self.yaw)


class Leg(NamedTuple):
    """Part of a drive: how long [s], how fast forward [m/s], and how fast it turns left [rad/s]."""

    duration_s: float
    speed_mps: float = 0.0
    yaw_rate_radps: float = 0.0


# One lap around the pillar: 3 m, a quarter turn of 0.5 m radius, 1 m, a quarter turn, and again.
CORNER = Leg(math.pi / 2.0, 0.5, 1.0)
LAP = (Leg(6.0, 0.5), CORNER, Leg(2.0, 0.5), CORNER, Leg(6.0, 0.5), CORNER, Leg(2.0, 0.5), CORNER)
START = PlanarPose(1.0, -1.0, 0.0)


class Drive:
    """A plan of legs, and where it leads.

    Args:
        legs: one after the other; before and after them the robot stands.
        start: `map_T_base_footprint` at the beginning.
        start_ns: when the first leg begins [ns].
    """

    def __init__(
        self,
        legs: Sequence[Leg] = (Leg(1.0), *LAP * 20),
        start: PlanarPose = START,
        start_ns: int = NSEC_PER_SEC,
    ) -> None:
        if not legs or any(leg.duration_s <= 0.0 for leg in legs):
            raise ValueError("a drive needs at least one leg, and every leg a duration above zero")
        self.start, self.start_ns = start, start_ns
        begins_s, poses = [0.0], [start]
        for leg in legs:
            x, y, yaw = _after(leg.duration_s, leg.speed_mps, leg.yaw_rate_radps)
            begins_s.append(begins_s[-1] + leg.duration_s)
            poses.append(poses[-1].then(PlanarPose(float(x), float(y), float(yaw))))
        self._begins_s, self._poses = np.array(begins_s), np.array(poses)
        each = np.array([(leg.speed_mps * leg.duration_s, leg.yaw_rate_radps * leg.duration_s) for leg in legs])
        self._rolled = np.pad(np.cumsum(each, axis=0), ((1, 0), (0, 0)))
        # After the last leg comes one without motion, which has no end.
        self._twists = np.array([(leg.speed_mps, leg.yaw_rate_radps) for leg in legs] + [(0.0, 0.0)])

    @property
    def end_ns(self) -> int:
        """When the last leg ends [ns]."""
        return self.start_ns + seconds(float(self._begins_s[-1]))

    def pose_at(self, stamp_ns: int) -> PlanarPose:
        """Return the true `map_T_base_footprint`."""
        return PlanarPose(*self.poses_at(np.array([stamp_ns]))[0].tolist())

    def twist_at(self, stamp_ns: int) -> tuple[float, float]:
        """Return the true (forward speed [m/s], yaw rate [rad/s])."""
        speed, yaw_rate = self.twists_at(np.array([stamp_ns]))[0].tolist()
        return speed, yaw_rate

    def poses_at(self, stamps_ns: np.ndarray) -> np.ndarray:
        """Return (x, y, yaw) at each of `stamps_ns`, shape (N,) [ns], as an array of shape (N, 3)."""
        legs, since_s = self._place(stamps_ns)
        speed, yaw_rate = self._twists[legs].T
        x, y, yaw = _after(since_s, speed, yaw_rate)
        x0, y0, yaw0 = self._poses[legs].T
        c, s = np.cos(yaw0), np.sin(yaw0)
        return np.stack([x0 + c * x - s * y, y0 + s * x + c * y, yaw0 + yaw], axis=1)

    def twists_at(self, stamps_ns: np.ndarray) -> np.ndarray:
        """Return (speed [m/s], yaw rate [rad/s]) at each of `stamps_ns`, shape (N,) [ns], shape (N, 2)."""
        return self._twists[self._place(stamps_ns)[0]] * (np.asarray(stamps_ns) >= self.start_ns)[:, None]

    def rolled_at(self, stamps_ns: np.ndarray) -> np.ndarray:
        """Return (way forward [m], turn to the left [rad]) since the start, shape (N, 2): what perfect wheels count."""
        legs, since_s = self._place(stamps_ns)
        return self._rolled[legs] + self._twists[legs] * since_s[:, None]

    def _place(self, stamps_ns: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return on which leg each stamp is, and for how long [s] it has been on it."""
        elapsed_s = np.maximum((np.asarray(stamps_ns, dtype=np.int64) - self.start_ns) / NSEC_PER_SEC, 0.0)
        legs = np.searchsorted(self._begins_s, elapsed_s, side="right") - 1
        return legs, elapsed_s - self._begins_s[legs]


def _after(elapsed_s, speed_mps, yaw_rate_radps):
    """Return (x, y, yaw) after driving an arc, or a straight line, from the origin; numbers or arrays."""
    yaw = yaw_rate_radps * elapsed_s
    # The chord of an arc is shorter than the arc by sin(a) / a, and points along half the turn.
    chord = speed_mps * elapsed_s * np.sinc(yaw / (2.0 * np.pi))
    return chord * np.cos(yaw / 2.0), chord * np.sin(yaw / 2.0), yaw
