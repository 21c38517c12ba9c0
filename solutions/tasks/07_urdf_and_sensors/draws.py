"""What several tasks of this chapter draw: measures in the units of a ruler, and poses of a tool."""

from __future__ import annotations

from tflab.core import Transform


def centimetres(rng, low, high, not_these=()):
    """Return a whole number of centimetres that none of `not_these` is, so that no two places can be exchanged."""
    while True:
        drawn = int(rng.integers(low, high))
        if drawn not in not_these:
            return drawn


def either(rng):
    return float(rng.choice([-1.0, 1.0]))


def tool_pose(rng):
    """Return where a tool's flange is: ahead of the robot, and turned about all three axes, never a half turn."""
    x, y, z = rng.uniform(0.3, 0.7), either(rng) * rng.uniform(0.1, 0.3), rng.uniform(0.2, 0.6)
    roll, pitch, yaw = (either(rng) * rng.uniform(0.3, 1.2) for _ in range(3))
    place = (round(float(x), 3), round(float(y), 3), round(float(z), 3))
    return Transform.from_rpy(round(float(roll), 2), round(float(pitch), 2), round(float(yaw), 2), place)


def turned_about(axis, angle_rad):
    """Return a turn about "x", "y" or "z" [rad]."""
    return Transform.from_rpy(**{{"x": "roll", "y": "pitch", "z": "yaw"}[axis]: angle_rad})
