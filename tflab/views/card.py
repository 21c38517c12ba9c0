"""What goes into the pocket of a lab coat?  The axes, the turns and the quaternions, on one card.

    +--------------+--------------+-----------------+
    | body axes    | optical axes | (x, y, z, w)    |
    +--------------+--------------+  the sentences  |
    | roll | pitch | yaw          |  to remember    |
    +-----------------------------+-----------------+

`draw_card().png()` is the file to print.
"""

from __future__ import annotations

import math

from tflab.core import Transform

from . import style
from .axes import BODY_T_OPTICAL, BODY_WORDS, FROM_FRONT, OPTICAL_WORDS, TURNS, draw_turn
from .bodies import RobotArtists
from .eye import SLANTING
from .frames import FrameArtists, clear_paper, draw_frames, write_caption
from .picture import Picture

__all__ = ["draw_card"]

SENTENCES = (
    "right hand",
    "  x to y with the fingers,",
    "  z is the thumb",
    "",
    "positive turns",
    "  roll   left side up",
    "  pitch  nose down",
    "  yaw    nose left",
    "",
    "(x, y, z, w)",
    "  0 0 0 1   no rotation",
    "  0 0 0 0   nothing at all",
    "  q and -q  the same",
    "  yaw a     (0, 0, sin a/2, cos a/2)",
    "",
    "link to optical",
    "  rpy   (-pi/2, 0, -pi/2)",
    "  xyzw  (-0.5, 0.5, -0.5, 0.5)",
)


def draw_card() -> Picture:
    """Draw the card: both conventions of axes, the positive turns, and what to know of a quaternion."""
    picture = Picture((style.WIDE[0], 4.3))
    sides = {"base_link, camera_link": (Transform(), BODY_WORDS), "..._optical_frame": (BODY_T_OPTICAL, OPTICAL_WORDS)}
    with style.our_settings():
        for column, (caption, (pose, words)) in enumerate(sides.items()):
            ax = clear_paper(picture.figure.add_axes((0.01 + 0.305 * column, 0.43, 0.30, 0.55)))
            if column == 0:
                RobotArtists(ax, SLANTING, style.GREY, scale=1.4).move(Transform())
            _write_beyond(ax, draw_frames(ax, {"": pose}, SLANTING, length_m=1.0)[""], words)
            _limits(ax, caption)
        for column, (name, axis) in enumerate(TURNS.items()):
            ax = clear_paper(picture.figure.add_axes((0.01 + 0.2 * column, 0.02, 0.19, 0.38)))
            draw_frames(ax, {"": Transform()}, FROM_FRONT, length_m=1.0)
            draw_turn(ax, axis)
            _limits(ax, f"+ {name}")
        picture.figure.text(0.665, 0.94, "\n".join(SENTENCES), va="top", family="monospace",
                            fontsize=style.SMALL_PT - 0.5, linespacing=1.4)  # fmt: skip
    axes = (f"{name}: {', '.join(' '.join(pair) for pair in words.items())}" for name, (_, words) in sides.items())
    picture.text = "\n".join(("The card:", *axes, *SENTENCES))
    return picture


def _write_beyond(ax, frame: FrameArtists, words: dict[str, str]) -> None:
    """Write what each axis means beyond its letter."""
    for axis, word in words.items():
        x, y = frame.axes[axis].letter_place
        far = math.hypot(x, y)
        side = "center" if abs(x) < 0.4 * far else "left" if x > 0 else "right"
        shift = (0.0, math.copysign(14.0, y)) if side == "center" else (math.copysign(8.0, x), 0.0)
        ax.annotate(word, (x, y), shift, textcoords="offset points", ha=side, va="center",
                    color=style.AXIS_COLOURS[axis])  # fmt: skip


def _limits(ax, caption: str) -> None:
    ax.set_xlim(-1.5, 1.5)
    ax.set_ylim(-1.15, 1.6)
    write_caption(ax, caption)
