"""Draw the field of turtlesim: its turtles, and the lines that their pens have left."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from . import style
from .picture import Picture

ARROW = ((1.0, 0.0), (-0.8, 0.6), (-0.4, 0.0), (-0.8, -0.6), (1.0, 0.0))  # ahead is x, a turtle is 2 long


def draw_turtles(
    canvas: np.ndarray, background: Sequence[int], poses: Mapping[str, tuple[float, float, float]], size_m: float
) -> Picture:
    """Draw turtles on their field.

    Args:
        canvas: what the pens have drawn, (rows, columns, 4) of red, green, blue and opacity.
        background: red, green, blue.
        poses: x, y, theta of each turtle [m, rad], from the lower left corner.
        size_m: the side of the field [m].
    """
    picture = Picture((4.2, 4.2))
    with style.our_settings():
        ax = picture.figure.add_axes((0.09, 0.08, 0.87, 0.87))
        ax.imshow(np.where(canvas[..., 3:] > 0, canvas[..., :3], np.uint8(background)), extent=(0, size_m, 0, size_m))
        for name, (x, y, theta) in poses.items():
            cos, sin = math.cos(theta), math.sin(theta)
            turtle = np.array(ARROW) @ ((cos, sin), (-sin, cos))
            ax.plot(x, y, marker=turtle, markersize=18, color=style.PAPER, markeredgecolor=style.INK)
            paper = {"facecolor": style.PAPER, "edgecolor": "none", "pad": 1.5}
            ax.annotate(name, (x, y), (0, 13), textcoords="offset points", ha="center", bbox=paper)
        ax.set_xticks(range(0, 12, 2), [*range(0, 10, 2), "10 m"])
        ax.set_yticks(range(0, 12, 2))
    picture.text = "\n".join(
        f"{name} at {style.fmt_all((x, y), digits=2)}, heading {style.fmt(theta, 'rad', 2)}"
        for name, (x, y, theta) in poses.items()
    )
    return picture
