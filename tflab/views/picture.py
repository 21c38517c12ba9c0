"""Hold a figure together with its text, and show it in Jupyter.

    picture            in a page     the card, sharp, at its size
    picture.text       anywhere      what a screen reader, a terminal or nbval gets
    picture.png()      a file        the same bytes every time
    picture.figure     matplotlib    everything that was drawn

A view makes its artists once and then only moves them, so the printed figure and the one that
follows a slider are the same.
"""

from __future__ import annotations

from io import BytesIO
from typing import TYPE_CHECKING

import numpy as np

from tflab.extras import require

from . import style

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from .number_table import NumberTable

require("matplotlib", "PIL")


class Picture:
    """A figure that can be shown, moved, and read aloud.

    Attributes:
        figure: the matplotlib figure.
        text: what it shows, in words.
        moving: the artists that a view moves; the others stand still and, while a slider
            is dragged, are drawn only once.
    """

    def __init__(self, size_inch: tuple[float, float] = style.WIDE) -> None:
        self.figure = style.figure(size_inch)
        self.text = ""
        self.moving: list[Artist] = []
        self._still = None  # the pixels of what stands still

    @property
    def size_px(self) -> tuple[int, int]:
        """How large it stands on the page: width, height."""
        width, height = self.figure.get_size_inches()
        return round(width * style.SCREEN_DPI), round(height * style.SCREEN_DPI)

    def add_axes_px(self, left: float, bottom: float, width: float, height: float) -> Axes:
        """Return new axes with this lower left corner and this size [screen pixels]."""
        full_width, full_height = self.figure.get_size_inches() * style.SCREEN_DPI
        return self.figure.add_axes((left / full_width, bottom / full_height, width / full_width, height / full_height))

    def add_number_table(self, x: float, y: float, colour: str = style.INK) -> NumberTable:
        """Return an empty block of numbers whose upper left corner is at (x, y), in parts of the figure."""
        from .number_table import NumberTable

        return NumberTable(self.figure, x, y, colour)

    def png(self) -> bytes:
        """Return the picture as a PNG of at most 256 colours: small, and the same bytes every time."""
        self.redraw_all()
        self.figure.set_dpi(style.PRINT_DPI)
        with style.our_settings():
            self.figure.canvas.draw()
        return self._encoded(compress_level=9)

    def live_png(self) -> bytes:
        """Return the picture as a PNG that is made quickly, for a slider to redraw."""
        canvas = self.figure.canvas
        with style.our_settings():
            if self._still is None:
                self._still = self._draw_still()
            canvas.restore_region(self._still)
            for artist in sorted(self.moving, key=lambda artist: artist.get_zorder()):
                artist.draw(canvas.get_renderer())
        return self._encoded(compress_level=1)

    def redraw_all(self) -> None:
        """Forget what stands still; to be called when it changes, or when limits do."""
        self._still = None

    def _draw_still(self):
        """Draw everything but what moves, and return the pixels."""
        self.figure.set_dpi(style.LIVE_DPI)
        for artist in self.moving:
            artist.set_animated(True)
        self.figure.canvas.draw()
        for artist in self.moving:
            artist.set_animated(False)
        return self.figure.canvas.copy_from_bbox(self.figure.bbox)

    def _encoded(self, compress_level: int) -> bytes:
        """Return what the canvas holds now as a PNG."""
        from PIL import Image

        image = Image.fromarray(np.asarray(self.figure.canvas.buffer_rgba()))
        image = image.quantize(256, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
        out = BytesIO()
        image.save(out, format="PNG", compress_level=compress_level)
        return out.getvalue()

    def _repr_mimebundle_(self, include=None, exclude=None) -> tuple[dict, dict]:
        width, height = self.size_px
        data = {"image/png": self.png(), "text/plain": self.text}
        self._let_pixels_go()
        return data, {"image/png": {"width": width, "height": height}}

    def _let_pixels_go(self) -> None:
        """Keep next to none of what was drawn, which is 4 MB or more: a notebook's `Out` keeps the picture for ever."""
        dpi = self.figure.get_dpi()
        self.figure.set_dpi(style.SMALLEST_DPI)
        self.figure.canvas.draw()  # every text holds on to the canvas that it was last drawn on: it is a small one now
        self.figure.set_dpi(dpi)

    def __repr__(self) -> str:
        return self.text
