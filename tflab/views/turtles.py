"""Draw the field of turtlesim: its turtles, and the lines that their pens have left."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from . import style
from .picture import Picture

ARROW = ((1.0, 0.0), (-0.8, 0.6), (-0.4, 0.0), (-0.8, -0.6), (1.0, 0.0))  # ahead is x


def draw_turtles(
    canvas: np.ndarray, background: Sequence[int], poses: Mapping[str, Sequence[float]], size_m: float
) -> Picture:
    """Draw turtles at their poses x, y, theta [m, rad], on a field with sides of `size_m` [m].

    `canvas` is what the pens have drawn: (rows, columns, 4) of red, green, blue and opacity.
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
            where = f"{style.fmt_all((x, y), digits=2)}, heading {style.fmt(theta, 'rad', 2)}"
            picture.text += f"{name} at {where}\n"
        ax.set_xticks(range(0, 12, 2), [*range(0, 10, 2), "10 m"])
        ax.set_yticks(range(0, 12, 2))
    return picture
