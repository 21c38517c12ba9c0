"""Draw a block of monospaced text as one outline, which redraws quickly.

matplotlib lays a text out again each time it is drawn. Numbers that follow a slider would spend
most of their time on that; an outline takes a tenth of it.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.path import Path
from matplotlib.textpath import TextPath
from matplotlib.transforms import Affine2D, ScaledTranslation

from . import style

LETTER_WIDTH = 0.602  # of DejaVu Sans Mono, in parts of its size
ROW_HEIGHT = 1.55
POINTS_PER_INCH = 72.0


class NumberTable(PathPatch):
    """Rows of letters of one width, hanging from their upper left corner.

    Attributes:
        text: what is written.
    """

    def __init__(self, figure: Figure, x: float, y: float, colour: str = style.INK) -> None:
        """Hang an empty block at (x, y), in parts of the figure's width and height."""
        points = Affine2D().scale(1.0 / POINTS_PER_INCH) + figure.dpi_scale_trans
        place = points + ScaledTranslation(x, y, figure.transFigure)
        super().__init__(_outline(""), facecolor=colour, linewidth=0.0, transform=place)
        self.text = ""
        figure.add_artist(self)

    def write(self, text: str) -> None:
        """Write these rows instead of what was there."""
        self.text = text
        self.set_path(_outline(text))


def _outline(text: str) -> Path:
    """Return rows of text as one outline [points], its upper left corner at (0, 0)."""
    vertices, codes = [np.empty((0, 2))], [np.empty(0, dtype=Path.code_type)]
    for row, line in enumerate(text.split("\n")):
        for column, letter in enumerate(line):
            if letter != " ":
                letter_vertices, letter_codes = _letter(letter)
                place = (column * LETTER_WIDTH * style.TEXT_PT, -(row * ROW_HEIGHT + 1.0) * style.TEXT_PT)
                vertices.append(letter_vertices + place)
                codes.append(letter_codes)
    return Path(np.concatenate(vertices), np.concatenate(codes))


@cache
def _letter(letter: str) -> tuple[np.ndarray, np.ndarray]:
    """Return the outline of one letter: vertices [points], shape (n, 2), and matplotlib's codes, shape (n,)."""
    outline = TextPath((0.0, 0.0), letter, size=style.TEXT_PT, prop={"family": "DejaVu Sans Mono"})
    return outline.vertices, outline.codes
