"""How often is often enough?  Sliders for speed, yaw rate and rate in front of `bend`.

The pure function behind it is `tflab.views.bend.gap_m`.
"""

from __future__ import annotations

from ..bend import Bend, BendPicture, deepest
from .drawn_ahead import At
from .panel import Panel, slider

SLOWEST_HZ, FASTEST_RADPS = 1.0, 1.5


def rate_panel(bend: Bend | None = None, language: str = "en") -> Panel:
    """Return a panel that shows what TF's straight line misses of a bend, starting from `bend`."""
    start = bend or Bend()
    rate = slider("rate", start.rate_hz, SLOWEST_HZ, 20.0, 0.5, "Hz", language)
    speed = slider("speed", start.speed_mps, 0.0, 2.0, 0.05, "m/s", language)
    yaw_rate = slider("yaw rate", start.yaw_rate_radps, -FASTEST_RADPS, FASTEST_RADPS, 0.05, "rad/s", language)
    room = deepest(FASTEST_RADPS / SLOWEST_HZ)
    picture = BendPicture(-room, room)

    def move(at: At) -> None:
        picture.show(Bend(at(speed), at(yaw_rate), at(rate)))

    title = "The arc that a robot drives and the chord that TF draws"
    return Panel(title, picture, (rate, speed, yaw_rate), move, language=language)
