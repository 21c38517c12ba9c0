"""Publish a robot that drives a circle, with the lecture's wrong heading and with the right one.

    theta grows by 0.01 rad, twenty times a second: 0.2 rad/s, and at 1 m radius 0.2 m/s

    as written: yaw = theta            as meant: yaw = theta + pi/2

           ^  way it goes                     ^ x   way it goes, and looks
           |                                  |
           +--> x  where it looks        y <--+

On a circle the way forward is square to the radius.  With yaw = theta the robot
looks along the radius, outwards, and slides to its own left: nothing that tf2
could complain about, and wrong all the same.  `body_velocity` shows it.

The lecture's node is `main`; `main_forward` is the same with the right heading.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress

from tflab.core import NSEC_PER_SEC, BufferCore, StampedTransform, Transform, seconds
from tflab.core.quaternions import Vector3
from tflab.ros import client_library as rclpy
from tflab.ros.convert import msg_from_stamped
from tflab.ros.executors import ExternalShutdownException
from tflab.ros.node import Node
from tflab.ros.tf2.topics import TransformBroadcaster

__all__ = ["FORWARD", "SIDEWAYS", "CircleBroadcaster", "body_velocity", "buffer", "main", "main_forward", "pose"]

PERIOD_NS = NSEC_PER_SEC // 20
STEP_RAD = 0.01

SIDEWAYS = 0.0  # the lecture's heading, added to theta [rad]
FORWARD = math.pi / 2.0  # the heading that drives forward


def pose(theta: float, heading: float = SIDEWAYS) -> Transform:
    """Return `odom_T_base_link` at the angle `theta` [rad] of the circle, looking `heading` [rad] off the radius."""
    return Transform.from_rpy(yaw=theta + heading, translation=(math.cos(theta), math.sin(theta), 0.0))


def body_velocity(heading: float = SIDEWAYS) -> Vector3:
    """Return how fast the robot moves along its own axes [m/s]: forward, to its left, up."""
    speed = STEP_RAD / (PERIOD_NS / NSEC_PER_SEC)  # at 1 m radius
    return (speed * math.sin(heading), speed * math.cos(heading), 0.0)


def buffer(until_s: float, heading: float = SIDEWAYS) -> BufferCore:
    """Return a buffer that heard the circle until `until_s` [s]; the first sample is at 1.05 s."""
    core = BufferCore()
    ticks = (seconds(until_s) - NSEC_PER_SEC) // PERIOD_NS
    for tick in range(1, ticks + 1):
        stamp_ns = NSEC_PER_SEC + tick * PERIOD_NS
        core.set_transform(StampedTransform("odom", "base_link", stamp_ns, pose(tick * STEP_RAD, heading)))
    return core


class CircleBroadcaster(Node):
    """Publishes odom -> base_link on a circle, twenty times a second."""

    def __init__(self, heading: float = SIDEWAYS) -> None:
        super().__init__("moving_robot_broadcaster")
        self._broadcaster = TransformBroadcaster(self)
        self._heading = heading
        self._theta = 0.0
        self.create_timer(PERIOD_NS / NSEC_PER_SEC, self._tick)

    def _tick(self) -> None:
        self._theta += STEP_RAD
        now_ns = self.get_clock().now().nanoseconds
        stamped = StampedTransform("odom", "base_link", now_ns, pose(self._theta, self._heading))
        self._broadcaster.sendTransform(msg_from_stamped(stamped))


def main(args: Sequence[str] | None = None) -> None:
    """Run the lecture's circle until it is interrupted."""
    _run(SIDEWAYS, args)


def main_forward(args: Sequence[str] | None = None) -> None:
    """Run the circle that drives forward until it is interrupted."""
    _run(FORWARD, args)


def _run(heading: float, args: Sequence[str] | None) -> None:
    rclpy.init(args=args)
    with suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(CircleBroadcaster(heading))
    rclpy.try_shutdown()
