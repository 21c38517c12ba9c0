"""Simulate turtlesim without its window.

    turtle1/cmd_vel --> turtle1 --> turtle1/pose, turtle1/color_sensor      62.5 times a second
    turtle1/set_pen, turtle1/teleport_absolute, turtle1/teleport_relative   services of each turtle
    spawn, kill, clear, reset                                               services of the node

The field is a square of 500 pixels, 45 a metre; its origin is the lower left corner. A turtle stops
at the walls, and one second after its last command. The action rotate_absolute has no server.

upstream: ros_tutorials, turtlesim/src/turtle.cpp and turtle_frame.cpp.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from itertools import count
from types import SimpleNamespace
from typing import Any

import numpy as np

from tflab.core import NSEC_PER_SEC
from tflab.ros import client_library as rclpy
from tflab.ros.distro import current
from tflab.ros.executors import ExternalShutdownException
from tflab.ros.messages.geometry_msgs import Twist
from tflab.ros.messages.packages import ros_package
from tflab.ros.node import Node
from tflab.ros.qos import QoSProfile
from tflab.ros.service import Service

__all__ = ["SIZE_M", "Turtle", "TurtleSim", "main"]

PIXELS, PIXELS_PER_M = 500, 45
SIZE_M = float(np.float32((PIXELS - 1) / PIXELS_PER_M))  # 11.088889
PERIOD_S = 0.016
BACKGROUND, PEN, PEN_PX = (0x45, 0x56, 0xFF), (0xB3, 0xB8, 0xFF), 3
CLEAR = (255, 255, 255, 0)  # red, green, blue, opacity
QOS = QoSProfile(depth=7)
TYPES = SimpleNamespace(**ros_package(current().turtlesim_messages), **ros_package("std_srvs"))


class Turtle:
    """One turtle: its pose x, y, theta [m, rad], its topics and its services."""

    def __init__(self, sim: TurtleSim, name: str, x: float, y: float, theta: float) -> None:
        self.x, self.y, self.theta, self._sim = x, y, theta, sim
        self._pen, self._pen_px = PEN, PEN_PX
        self._command, self._commanded = Twist(), sim.get_clock().now()
        self._poses = sim.create_publisher(TYPES.Pose, f"{name}/pose", QOS)
        self._colours = sim.create_publisher(TYPES.Color, f"{name}/color_sensor", QOS)
        self._others = [
            sim.create_subscription(Twist, f"{name}/cmd_vel", self._on_command, QOS),
            sim.serve(TYPES.SetPen, f"{name}/set_pen", self._set_pen),
            sim.serve(TYPES.TeleportAbsolute, f"{name}/teleport_absolute", self._teleport_absolute),
            sim.serve(TYPES.TeleportRelative, f"{name}/teleport_relative", self._teleport_relative),
        ]

    def destroy(self) -> None:
        """Take its topics and services out of the graph."""
        for each in (self._poses, self._colours, *self._others):
            each.destroy()

    def update(self) -> None:
        """Drive for one period, then publish the pose and the colour of the field there."""
        if (self._sim.get_clock().now() - self._commanded).nanoseconds > NSEC_PER_SEC:
            self._command = Twist()
        speed, turn = self._command.linear.x, self._command.angular.z
        self.theta = (self.theta + turn * PERIOD_S + math.pi) % math.tau - math.pi
        x = self.x + math.cos(self.theta) * speed * PERIOD_S
        y = self.y + math.sin(self.theta) * speed * PERIOD_S
        inside = min(max(x, 0.0), SIZE_M), min(max(y, 0.0), SIZE_M)
        if (x, y) != inside:  # here upstream counts y from the upper edge
            self._sim.get_logger().warning(f"Oh no! I hit the wall! (Clamping from [x={x:f}, y={SIZE_M - y:f}])")
        red, green, blue, _ = self._sim.canvas[tuple(_pixels(inside))].tolist()
        self._move(*inside)
        x, y, theta, speed, turn = np.float32([*inside, self.theta, abs(speed), turn]).tolist()
        self._poses.publish(TYPES.Pose(x=x, y=y, theta=theta, linear_velocity=speed, angular_velocity=turn))
        self._colours.publish(TYPES.Color(r=red, g=green, b=blue))

    def _move(self, x: float, y: float) -> None:
        """Move to a point, and draw a line there unless the pen is off."""
        steps = math.ceil(max(abs(x - self.x), abs(y - self.y)) * PIXELS_PER_M)
        if steps and self._pen_px:
            square = np.indices((self._pen_px, self._pen_px)).reshape(2, -1) - self._pen_px // 2
            rows, columns = _pixels(np.linspace((self.x, self.y), (x, y), steps + 1))[..., None] + square[:, None]
            self._sim.canvas[rows.clip(0, PIXELS - 1), columns.clip(0, PIXELS - 1)] = (*self._pen, 255)
        self.x, self.y = x, y

    def _on_command(self, command: Twist) -> None:
        self._command, self._commanded = command, self._sim.get_clock().now()

    def _set_pen(self, request: Any) -> None:
        self._pen = self._pen if request.off else (request.r, request.g, request.b)
        self._pen_px = 0 if request.off else request.width or 1

    def _teleport_absolute(self, request: Any) -> None:
        self.theta = request.theta
        self._move(request.x, min(request.y, SIZE_M))

    def _teleport_relative(self, request: Any) -> None:
        self.theta += request.angular
        self._move(self.x + math.cos(self.theta) * request.linear, self.y + math.sin(self.theta) * request.linear)


def _pixels(points: Any) -> np.ndarray:
    """Return the rows and the columns, (2, ...), of points (..., 2) on the field [m]."""
    x, y = np.moveaxis(np.asarray(points), -1, 0)
    return np.rint(np.stack((SIZE_M - y, x)) * PIXELS_PER_M).astype(int)


class TurtleSim(Node):
    """The node: its turtles by name, and what their pens have drawn, (500, 500, 4) of red, green, blue, opacity."""

    def __init__(self) -> None:
        super().__init__("turtlesim")
        for letter, value in zip("rgb", BACKGROUND, strict=True):
            self.declare_parameter(f"background_{letter}", value)
        self.serve(TYPES.Empty, "clear", self._clear)
        self.serve(TYPES.Empty, "reset", self._reset)
        self.serve(TYPES.Spawn, "spawn", self._spawn)
        self.serve(TYPES.Kill, "kill", self._kill)
        self.get_logger().info(f"Starting turtlesim with node name {self.get_fully_qualified_name()}")
        self.turtles: dict[str, Turtle] = {}
        self._begin()
        self.create_timer(PERIOD_S, lambda: [turtle.update() for turtle in self.turtles.values()])

    @property
    def background(self) -> list[int]:
        """The colour of the field: red, green, blue."""
        return [self.get_parameter(f"background_{letter}").value for letter in "rgb"]

    def serve(self, srv_type: type, name: str, act: Callable[[Any], Any]) -> Service:
        """Offer a service; `act` takes the request, and may return the response."""
        return self.create_service(srv_type, name, lambda request, response: act(request) or response)

    def _begin(self) -> None:
        """Empty the field, and put one turtle in its middle."""
        self.canvas = np.full((PIXELS, PIXELS, 4), CLEAR, dtype=np.uint8)
        self._numbers = count(1)
        while self.turtles:
            self.turtles.popitem()[1].destroy()
        self._add("", SIZE_M / 2, SIZE_M / 2, 0.0)

    def _add(self, name: str, x: float, y: float, theta: float) -> str:
        """Add a turtle at a pose [m, rad], and return its name; for "" it is the next that is free."""
        name = name or next(each for each in map("turtle{}".format, self._numbers) if each not in self.turtles)
        self.turtles[name] = Turtle(self, name, x, y, theta)
        pose = f"x=[{np.float32(x):f}], y=[{np.float32(y):f}], theta=[{theta:f}]"
        self.get_logger().info(f"Spawning turtle [{name}] at {pose}")
        return name

    def _spawn(self, request: Any) -> Any:
        if request.name not in self.turtles:
            return TYPES.Spawn.Response(name=self._add(request.name, request.x, request.y, request.theta))
        self.get_logger().error(f"A turtle named [{request.name}] already exists")
        return None

    def _kill(self, request: Any) -> None:
        if request.name in self.turtles:
            self.turtles.pop(request.name).destroy()
        else:
            self.get_logger().error(f"Tried to kill turtle [{request.name}], which does not exist")

    def _clear(self, request: Any) -> None:
        self.get_logger().info("Clearing turtlesim.")
        self.canvas[:] = CLEAR

    def _reset(self, request: Any) -> None:
        self.get_logger().info("Resetting turtlesim.")
        self._begin()


def main(arguments: Sequence[str] = ()) -> int:
    """Run the node until it is interrupted; return the exit code."""
    rclpy.init()
    with suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(TurtleSim())
    rclpy.try_shutdown()
    return 0
