"""Often enough?  What TF knows of a bend between two samples: the chord, where the robot drives the arc.

              ___-----___            arc    the robot's way from one sample to the next
         o---------------------o     chord  TF's way between the same two: a straight line
         |<------- v/f ------->|     gap    (v/w)(1 - cos(w / 2f)), at worst, in the middle

On the straight there is no gap, at any rate.  What a slow edge costs everywhere is
waiting: a message can be placed only when the next sample has come.  In the field
the gap is called sagitta.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from . import style
from .picture import Picture

__all__ = ["Bend", "BendPicture", "deepest", "describe_bend", "draw_bend", "gap_m", "wait_s"]

NEARLY_STRAIGHT = 1e-9  # [rad/s]
POINTS = 60
CHORD_PX, LEGEND_PX, RIM_PX, LEAST_PX = 380, 34, 26, 160  # a chord, what stands above and below, a card's height


class Bend(NamedTuple):
    """A robot in a bend, and how often it says where it is.

    Attributes:
        speed_mps: how fast it drives [m/s].
        yaw_rate_radps: how fast it turns, positive to the left [rad/s].
        rate_hz: how often the transform comes [Hz].
    """

    speed_mps: float = 0.5
    yaw_rate_radps: float = 1.0
    rate_hz: float = 2.0


def gap_m(bend: Bend) -> float:
    """Return how far the chord is from the arc at worst [m]."""
    speed, turn, rate = bend
    if abs(turn) < NEARLY_STRAIGHT:
        return 0.0
    return abs(speed / turn) * (1.0 - math.cos(turn / (2.0 * rate)))


def wait_s(bend: Bend, transform_travels_s: float = 0.004, scan_travels_s: float = 0.105) -> float:
    """Return how long a scan that has arrived has to wait for the next transform, at worst [s]."""
    return max(0.0, 1.0 / bend.rate_hz + transform_travels_s - scan_travels_s)


def describe_bend(bend: Bend) -> str:
    """Return the same in words: what happens between two samples, the gap, and the wait."""
    between = f"{style.fmt(bend.speed_mps / bend.rate_hz)} driven, {bend.yaw_rate_radps / bend.rate_hz:.3f} rad turned"
    return "\n".join(
        (
            f"between two samples {between}",
            f"gap between arc and chord {style.fmt(1000 * gap_m(bend), 'mm', 2)} at worst",
            f"wait {style.fmt(wait_s(bend), 's')} at worst",
        )
    )


class BendPicture(Picture):
    """Arc and chord between two samples, as large as the paper; the three numbers beside them."""

    def __init__(self, lowest: float, highest: float) -> None:
        """Make room for arcs that reach from `lowest` to `highest`, in chords, 0 being the chord itself."""
        arc_px = CHORD_PX * (highest - lowest)
        height_px = max(LEGEND_PX + arc_px + 2 * RIM_PX, LEAST_PX)
        super().__init__((style.WIDE[0], height_px / style.SCREEN_DPI))
        width_px = self.size_px[0]
        middle, half = (lowest + highest) / 2, (height_px - LEGEND_PX) / CHORD_PX / 2
        box = (0.04, 0.0, 1.24 * CHORD_PX / width_px, 1.0 - LEGEND_PX / height_px)
        with style.our_settings():
            self.ax = self.figure.add_axes(box)
            self.ax.set_axis_off()
            self.ax.set_xlim(-0.62, 0.62)
            self.ax.set_ylim(middle - half, middle + half)
            (self._arc,) = self.ax.plot([], [], color=style.INK, linewidth=2.2, label="arc")
            dashes = (0, (4.0, 1.6))
            (self._chord,) = self.ax.plot([], [], color=style.ACCENT, linewidth=1.8, linestyle=dashes, label="chord")
            (self._gap,) = self.ax.plot([], [], color=style.AXIS_COLOURS["x"], linewidth=2.6, label="gap")
            (self._samples,) = self.ax.plot([], [], "o", color=style.INK, markersize=7, label="samples")
            self.figure.legend(loc="upper left", bbox_to_anchor=(0.03, 1.0 - 10 / height_px), ncols=4, frameon=False,
                               fontsize=style.SMALL_PT, borderaxespad=0.0)  # fmt: skip
            self._numbers = self.figure.text(0.70, 0.5, "", va="center", linespacing=1.9)
        self.moving = [self._arc, self._chord, self._gap, self._samples, self._numbers]

    def show(self, bend: Bend) -> None:
        """Draw one period of this bend, enlarged so that the chord fills the paper."""
        arc = _arc_of(bend)
        middle, chord = len(arc) // 2, arc[-1] - arc[0]
        self._arc.set_data(*arc.T)
        self._chord.set_data(*arc[[0, -1]].T)
        self._gap.set_data(*np.array([arc[middle], arc[0] + chord / 2]).T)
        self._samples.set_data(*arc[[0, -1]].T)
        self._numbers.set_text(
            f"v/f    {style.fmt(bend.speed_mps / bend.rate_hz)}\n"
            f"gap    {style.fmt(1000 * gap_m(bend), 'mm', 2)}\n"
            f"wait   {style.fmt(wait_s(bend), 's')}"
        )
        self.text = describe_bend(bend)


def draw_bend(bend: Bend) -> BendPicture:
    """Draw what TF knows of a bend between two samples."""
    heights = _arc_of(bend)[:, 1]
    picture = BendPicture(float(heights.min()), float(heights.max()))
    picture.show(bend)
    return picture


def deepest(turn_rad: float) -> float:
    """Return how far the arc of a period in which the robot turns so far [rad] is from its chord, in chords."""
    return math.tan(abs(turn_rad) / 4.0) / 2.0


def _arc_of(bend: Bend) -> np.ndarray:
    """Return the arc of one period, its chord from (-0.5, 0) to (0.5, 0), shape (POINTS + 1, 2)."""
    turn = bend.yaw_rate_radps / bend.rate_hz
    share = np.linspace(0.0, 1.0, POINTS + 1)
    if abs(turn) < NEARLY_STRAIGHT:
        return np.column_stack([share - 0.5, np.zeros(POINTS + 1)])
    angle = turn * (share - 0.5)  # of the way's direction against the chord
    scale = 0.5 / math.sin(turn / 2.0)
    return np.column_stack([np.sin(angle) * scale, (math.cos(turn / 2.0) - np.cos(angle)) * scale])
