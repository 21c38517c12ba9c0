"""Draw lengths as on a ruler and tool poses for several tasks of chapter 07."""

from __future__ import annotations

from tflab.core import Transform


def draw_centimetres(rng, low, high, not_these=()):
    """Draw a whole number of centimetres that is none of `not_these`."""
    while True:
        drawn = int(rng.integers(low, high))
        if drawn not in not_these:
            return drawn


def draw_sign(rng):
    return float(rng.choice([-1.0, 1.0]))


def draw_tool_pose(rng):
    """Draw the pose of a tool's flange: ahead of the robot, rotated about all three axes."""
    x, y, z = rng.uniform(0.3, 0.7), draw_sign(rng) * rng.uniform(0.1, 0.3), rng.uniform(0.2, 0.6)
    roll, pitch, yaw = (draw_sign(rng) * rng.uniform(0.3, 1.2) for _ in range(3))
    place = (round(float(x), 3), round(float(y), 3), round(float(z), 3))
    return Transform.from_rpy(round(float(roll), 2), round(float(pitch), 2), round(float(yaw), 2), place)


def rotation_about(axis, angle_rad):
    """Return a rotation about "x", "y" or "z" [rad]."""
    return Transform.from_rpy(**{{"x": "roll", "y": "pitch", "z": "yaw"}[axis]: angle_rad})
