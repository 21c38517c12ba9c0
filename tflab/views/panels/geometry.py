"""Panels for poses: rotate a robot, move a point, turn a sensor, measure from three frames, move an arm."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from tflab.core import Transform
from tflab.core.quaternions import Vector3
from tflab.text import Texts

from ..axes import CamerasPicture, RotationPicture
from ..coordinates import RulersPicture, readings_of
from ..transform_chain import JointsPicture, Step
from ..wrong_frames import MountPicture
from .panel import STEP_RAD, Panel, menu, say, slider
from .prefetch import Controls

TEXTS = Texts(__file__)

BASE_T_LASER = Transform(translation=(0.20, 0.0, 0.15))
ROBOT_X_M, THING_AT = 1.0, (6.5, -1.5)  # at first, in map [m]
ON_THE_TRAY = (-0.10, 0.0, 0.20)  # in base_link [m]
IN_SIGHT = np.array([(-0.5, -0.7), (8.0, 0.7)])  # of the map's ground [m]


def rotation_panel(roll_rad: float = 0.0, pitch_rad: float = 0.0, yaw_rad: float = 0.0) -> Panel:
    """Return a panel that turns a robot by roll, pitch and yaw [rad] and shows its quaternion and its matrix."""
    angles = {"roll": roll_rad, "pitch": pitch_rad, "yaw": yaw_rad}
    sliders = [slider(name, angle, -math.pi, math.pi, STEP_RAD, "rad") for name, angle in angles.items()]
    picture = RotationPicture()
    title = "A robot turned by roll, pitch and yaw"
    return Panel(title, picture, sliders, lambda at: picture.show(*map(at, sliders)))


def cameras_panel(forward_m: float = 2.0, left_m: float = 0.0, up_m: float = 0.0) -> Panel:
    """Return a panel that moves a point in front of a camera and shows it in the body and in the optical frame."""
    forward = slider(TEXTS["forward"], forward_m, 0.5, 4.0, 0.05, "m")
    left = slider(TEXTS["left"], left_m, -1.5, 1.5, 0.05, "m")
    up = slider(TEXTS["up"], up_m, -1.0, 1.0, 0.05, "m")
    picture, sliders = CamerasPicture(), (forward, left, up)
    title = "One camera with its body frame and its optical frame"
    return Panel(title, picture, sliders, lambda at: picture.show(tuple(map(at, sliders))))


def mount_panel() -> Panel:
    """Return a panel that turns a laser on its robot by yaw [rad], and shows a corner and two wrong answers."""
    yaw = slider(TEXTS["mount yaw"], math.pi / 2, -math.pi, math.pi, STEP_RAD, "rad")
    picture = MountPicture()
    title = "A turned laser, the corner that it sees, and two wrong answers"
    return Panel(title, picture, (yaw,), lambda at: picture.show(at(yaw)))


def rulers_panel() -> Panel:
    """Return a panel that moves a robot and a thing, and shows in which frame the thing's numbers stay the same."""
    half_turn = round(math.pi, 2)
    robot_x = slider(TEXTS["robot x"], ROBOT_X_M, 0.0, 5.0, 0.05, "m")
    yaw = slider(TEXTS["robot yaw"], 0.0, -half_turn, half_turn, 0.01, "rad")
    thing_x = slider(TEXTS["thing x"], THING_AT[0], 0.0, 7.5, 0.05, "m")
    thing_y = slider(TEXTS["thing y"], THING_AT[1], -2.0, 2.0, 0.05, "m")
    options = [(say(TEXTS["floor"]), "floor"), (say(TEXTS["tray"]), "tray")]
    rests_on = menu(TEXTS["rests on"], options)
    picture = RulersPicture(("map", "base_link", "laser_frame"), "thing", keep=IN_SIGHT)

    def thing(poses: dict[str, Transform], on: str, on_the_floor: tuple[float, float]) -> Vector3:
        return poses["base_link"].apply(ON_THE_TRAY) if on == "tray" else (*on_the_floor, 0.0)

    def move(at: Controls) -> None:
        first, poses = _three_frames(ROBOT_X_M, 0.0), _three_frames(at(robot_x), at(yaw))
        before = readings_of(first, thing(first, at(rests_on), THING_AT))
        picture.show(poses, thing(poses, at(rests_on), (at(thing_x), at(thing_y))), before)

    def disable_thing(change: dict[str, object]) -> None:
        thing_x.disabled = thing_y.disabled = change["new"] == "tray"

    rests_on.observe(disable_thing, names="value")
    controls = (robot_x, yaw, thing_x, thing_y, rests_on)
    return Panel("A thing, measured from three frames", picture, controls, move)


def _three_frames(robot_x_m: float, yaw_rad: float) -> dict[str, Transform]:
    """Return `map_T_frame` of the three frames, for a robot at (x, 0) [m] that is turned by yaw [rad]."""
    map_T_base = Transform.from_rpy(yaw=yaw_rad, translation=(robot_x_m, 0.0, 0.0))
    return {"map": Transform(), "base_link": map_T_base, "laser_frame": map_T_base @ BASE_T_LASER}


class Travel(NamedTuple):
    """The range of a joint, and its position at first [unit]."""

    joint: str
    low: float
    high: float
    start: float = 0.0
    unit: str = "rad"


def joints_panel(chain: Callable[[Mapping[str, float]], Sequence[Step]], travels: Sequence[Travel]) -> Panel:
    """Return a panel with a slider for each joint that moves.

    Args:
        chain: the steps from the base to the tip, for joint positions by name [rad or m].
        travels: of the joints, in the order of the chain.

    Raises:
        ValueError: no joint moves.
    """
    if not travels:
        raise ValueError("no joint of this chain moves, so there is nothing to slide")
    sliders = {t.joint: slider(t.joint, t.start, t.low, t.high, 0.05, t.unit) for t in travels}
    for control in sliders.values():
        control.style.description_width = "160px"
    picture = JointsPicture(chain({t.joint: t.start for t in travels}))

    def move(at: Controls) -> None:
        touched = next(name for name, control in sliders.items() if control is at.moved)
        picture.show(chain({name: at(control) for name, control in sliders.items()}), touched)

    return Panel("An arm, joint by joint", picture, list(sliders.values()), move)
