"""What does a turned mount do to two mistakes?  A slider in front of `mount`.

The pure function behind it is `tflab.views.mount.seen_from`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ..mount import LASER_AT, MountPicture
from .drawn_ahead import At
from .panel import STEP_RAD, Panel, slider


def mount_panel(
    yaw_rad: float = math.pi / 2,
    laser_p: Sequence[float] = (2.0, 0.0, 0.0),
    laser_at: Sequence[float] = LASER_AT,
    language: str = "en",
) -> Panel:
    """Return a panel that turns a laser on its robot by yaw [rad], and shows a corner and two wrong answers."""
    yaw = slider("mount yaw", yaw_rad, -math.pi, math.pi, STEP_RAD, "rad", language)
    picture = MountPicture(laser_p, laser_at)

    def move(at: At) -> None:
        picture.show(at(yaw))

    title = "A turned laser, the corner that it sees, and two wrong answers"
    return Panel(title, picture, (yaw,), move, language=language)
