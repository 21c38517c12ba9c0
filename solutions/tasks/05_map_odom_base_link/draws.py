"""Draw poses on the floor for several tasks of chapter 05."""

from __future__ import annotations

from tflab.core import Transform


def draw_planar_pose(rng, reach_m=4.0):
    """Draw a pose (x, y, yaw) whose yaw is neither small nor near half a turn."""
    way = float(rng.choice([-1.0, 1.0]))
    x, y = (float(rng.choice([-1.0, 1.0])) * float(rng.uniform(0.5, reach_m)) for _ in range(2))
    yaw = way * float(rng.uniform(0.5, 2.4))
    return Transform.from_rpy(yaw=round(yaw, 2), translation=(round(x, 2), round(y, 2), 0.0))


def draw_sloped_pose(rng):
    """Draw a pose with height, roll and pitch: a robot on a ramp."""
    here = draw_planar_pose(rng)
    z, roll, pitch = (float(rng.choice([-1.0, 1.0])) * float(rng.uniform(0.08, 0.3)) for _ in range(3))
    lifted = Transform(translation=(0.0, 0.0, round(z, 2)))
    return lifted @ here @ Transform.from_rpy(roll=round(roll, 2), pitch=round(pitch, 2))


def yaw_of(pose):
    return pose.rpy()[2]


def subtract_by_component(one, other):
    """Return the differences of translations and yaws, which is no valid transform."""
    steps = [a - b for a, b in zip(one.translation, other.translation, strict=True)]
    return Transform.from_rpy(yaw=yaw_of(one) - yaw_of(other), translation=tuple(steps))


def invert(pose, way):
    """Return the inverse of a pose, a wrong inverse, or the pose itself."""
    negated = [-number for number in pose.translation]
    return {
        "turned round": pose.inverse(),
        "step negated": Transform(negated, pose.rotation),
        "turned back, step negated": Transform(negated, pose.inverse().rotation),
    }.get(way, pose)
