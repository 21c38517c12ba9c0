"""Which way does it turn?  Sliders in front of `axes`.

The pure functions behind it are `Transform.from_rpy` and
`tflab.views.axes.optical_from_body`.
"""

from __future__ import annotations

import math

from ..axes import CamerasPicture, RotationPicture
from .drawn_ahead import At
from .panel import STEP_RAD, Panel, slider


def rotation_panel(roll_rad: float = 0.0, pitch_rad: float = 0.0, yaw_rad: float = 0.0, language: str = "en") -> Panel:
    """Return a panel that turns a robot by roll, pitch and yaw [rad] and shows its quaternion and its matrix."""
    roll = slider("roll", roll_rad, -math.pi, math.pi, STEP_RAD, "rad")
    pitch = slider("pitch", pitch_rad, -math.pi, math.pi, STEP_RAD, "rad")
    yaw = slider("yaw", yaw_rad, -math.pi, math.pi, STEP_RAD, "rad")
    picture = RotationPicture()

    def move(at: At) -> None:
        picture.show(at(roll), at(pitch), at(yaw))

    return Panel("A robot turned by roll, pitch and yaw", picture, (roll, pitch, yaw), move, language=language)


def cameras_panel(forward_m: float = 2.0, left_m: float = 0.0, up_m: float = 0.0, language: str = "en") -> Panel:
    """Return a panel that moves a point in front of a camera and shows it in the body and in the optical frame."""
    forward = slider("forward", forward_m, 0.5, 4.0, 0.05, "m", language)
    left = slider("left", left_m, -1.5, 1.5, 0.05, "m", language)
    up = slider("up", up_m, -1.0, 1.0, 0.05, "m", language)
    picture = CamerasPicture()

    def move(at: At) -> None:
        picture.show((at(forward), at(left), at(up)))

    title = "One camera with its body frame and its optical frame"
    return Panel(title, picture, (forward, left, up), move, language=language)
