"""How far off?  Sliders for speed, yaw rate, range and delay in front of `latency`.

The pure function behind it is `tflab.views.latency.latency_error`.
"""

from __future__ import annotations

from tflab.core import seconds

from ..latency import LatencyPicture, Sight
from .drawn_ahead import At
from .panel import Panel, slider


def latency_panel(sight: Sight | None = None, language: str = "en") -> Panel:
    """Return a panel in which a robot's motion and its delay can be changed, starting from `sight`."""
    start = sight or Sight()
    speed = slider("speed", start.speed_mps, 0.0, 3.0, 0.05, "m/s", language)
    yaw_rate = slider("yaw rate", start.yaw_rate_radps, -1.0, 1.0, 0.05, "rad/s", language)
    range_ = slider("range", start.range_m, 1.0, 10.0, 0.1, "m", language)
    delay = slider("delay", start.delay_s, 0.0, 0.5, 0.01, "s", language)
    picture = LatencyPicture()

    def move(at: At) -> None:
        picture.show(Sight(at(speed), at(yaw_rate), at(range_), seconds(at(delay))))

    title = "An object drawn with the pose at the stamp and now"
    return Panel(title, picture, (speed, yaw_rate, range_, delay), move, language=language)
