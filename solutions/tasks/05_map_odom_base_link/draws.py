"""What several tasks of this chapter draw: poses on the floor that turn."""

from __future__ import annotations

from tflab.core import Transform


def on_the_floor(rng, reach_m=4.0):
    """Return a pose (x, y, yaw) whose turn is neither small nor near a half turn."""
    way = float(rng.choice([-1.0, 1.0]))
    x, y = (float(rng.choice([-1.0, 1.0])) * float(rng.uniform(0.5, reach_m)) for _ in range(2))
    yaw = way * float(rng.uniform(0.5, 2.4))
    return Transform.from_rpy(yaw=round(yaw, 2), translation=(round(x, 2), round(y, 2), 0.0))


def on_a_slope(rng):
    """Return a pose with height, roll and pitch besides: a robot on a ramp."""
    here = on_the_floor(rng)
    z, roll, pitch = (float(rng.choice([-1.0, 1.0])) * float(rng.uniform(0.08, 0.3)) for _ in range(3))
    lifted = Transform(translation=(0.0, 0.0, round(z, 2)))
    return lifted @ here @ Transform.from_rpy(roll=round(roll, 2), pitch=round(pitch, 2))


def yaw_of(pose):
    return pose.rpy()[2]


def by_parts(one, other):
    """Return what subtracting steps and yaws gives: no transform of anything."""
    steps = [a - b for a, b in zip(one.translation, other.translation, strict=True)]
    return Transform.from_rpy(yaw=yaw_of(one) - yaw_of(other), translation=tuple(steps))


def turned_round(pose, way):
    """Return an inverse; or what is left of one whose step is only negated, the turn kept or turned back; or the pose."""
    negated = [-number for number in pose.translation]
    return {
        "turned round": pose.inverse(),
        "step negated": Transform(negated, pose.rotation),
        "turned back, step negated": Transform(negated, pose.inverse().rotation),
    }.get(way, pose)
