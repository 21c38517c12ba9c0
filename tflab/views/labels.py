"""Place names beside their things, so that they cover no line and no other name.

Every name tries eight positions around its thing, then eight farther away, and so on, always in
the same order, so that a figure is the same each time.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from . import style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.path import Path as MarkerPath

Place = tuple[float, float]

LETTER_PT = 11.0  # of an axis
AIR_PT = 2.5  # between a name and what it must not cover
GAPS_PT = (8.0, 26.0, 48.0, 72.0)  # between a thing and its name; from the second on with a thin line
IN_A_CROWD = 10  # what it costs to stand farther than that: less than to cover a name, more than a few lines
# below right, below left, above right, above left, right, left, below, above
WAYS = np.array([(1, -1), (-1, -1), (1, 1), (-1, 1), (1.4, 0), (-1.4, 0), (0, -1.4), (0, 1.4)])


@dataclass(eq=False)
class FloatingLabel:
    """A name that has yet to find its place.

    Attributes:
        anchor: where the named thing is, in the data coordinates of `ax`.
        keep_off: lines that no name may cover, each from (x, y) to (x, y).
    """

    ax: Axes
    name: str
    colour: str = style.INK
    is_italic: bool = False
    anchor: Place = (0.0, 0.0)
    keep_off: list[tuple[Place, Place]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.text = self.ax.annotate(
            self.name, (0, 0), (0, 0), textcoords="offset points", ha="center", va="center", color=self.colour,
            fontsize=style.TEXT_PT, fontstyle="italic" if self.is_italic else "normal", annotation_clip=False,
            zorder=100,
        )  # fmt: skip
        (self.leader,) = self.ax.plot([], [], color=style.FAINT, linewidth=0.8, zorder=99)
        self.artists = [self.leader, self.text]
        self._measured = ("", (0.0, 0.0))

    def size_pt(self) -> tuple[float, float]:
        """Return width and height [points] of the name, measured once for each text."""
        text = self.text.get_text()
        if self._measured[0] != text:
            extent = self.text.get_window_extent()
            scale = 72.0 / self.ax.figure.dpi
            self._measured = (text, (extent.width * scale, extent.height * scale))
        return self._measured[1]

    def follow(self, anchor: Place) -> None:
        """Move along with the named thing, keeping the place beside it until a better one is found."""
        self.anchor = (float(anchor[0]), float(anchor[1]))
        self.text.xy = self.anchor
        self.leader.set_visible(False)

    def stand(self, place: Place, is_far: bool = False) -> None:
        """Write the name with its middle at this place [points from the anchor], with a thin line if it is far."""
        self.text.xy = self.anchor
        self.text.set_position(place)
        self.leader.set_visible(is_far)
        if is_far:
            pixels_per_point = self.ax.figure.dpi / 72.0
            half = np.array(self.size_pt()) / 2
            edge = np.array(place) - np.sign(place) * np.minimum(half, np.abs(place))
            start = self.ax.transData.transform(self.anchor)
            end = self.ax.transData.inverted().transform(start + 0.9 * edge * pixels_per_point)
            self.leader.set_data(*zip(self.anchor, end, strict=True))


def place_labels(labels: Sequence[FloatingLabel]) -> None:
    """Find a place for each label of one axes, so that none covers a line, a mark or another name."""
    if not labels:
        return
    ax = labels[0].ax
    points_per_pixel = 72.0 / ax.figure.dpi
    paper = np.array(ax.get_window_extent().extents) * points_per_pixel

    def on_page(places: Sequence[Place] | np.ndarray) -> np.ndarray:
        return ax.transData.transform(places) * points_per_pixel

    anchors = on_page([label.anchor for label in labels])
    ends = [line for label in labels for line in label.keep_off] or [(labels[0].anchor, labels[0].anchor)]
    starts, stops = on_page(np.array(ends).reshape(-1, 2)).reshape(-1, 2, 2).swapaxes(0, 1)
    taken = np.vstack((np.linspace(starts, stops, 48).reshape(-1, 2), anchors))
    boxes = np.empty((0, 4))
    for label, anchor in zip(labels, anchors, strict=True):
        if not label.text.get_text():
            continue
        half = np.array(label.size_pt()) / 2
        choices = np.vstack([gap * WAYS + np.sign(WAYS) * half for gap in GAPS_PT])
        middles = anchor + choices
        candidates = np.hstack((middles - half, middles + half))
        crowded = IN_A_CROWD * np.repeat(np.arange(len(GAPS_PT)) - 1, len(WAYS)).clip(0)
        best = int(np.argmin(_faults(candidates, taken, boxes, paper) + crowded))
        label.stand(tuple(choices[best]), best >= len(WAYS))
        boxes = np.vstack((boxes, candidates[best]))


def _faults(candidates: np.ndarray, taken: np.ndarray, boxes: np.ndarray, paper: np.ndarray) -> np.ndarray:
    """Return how much each box, shape (n, 4), would cover: points of lines, and, worse, names and the paper's edge."""
    low, high = candidates[:, None, :2], candidates[:, None, 2:]
    points = ((taken >= low - AIR_PT) & (taken <= high + AIR_PT)).all(axis=2).sum(axis=1)
    names = ((low < boxes[:, 2:]) & (boxes[:, :2] < high)).all(axis=2).sum(axis=1)
    is_outside = (candidates[:, :2] < paper[:2]).any(axis=1) | (candidates[:, 2:] > paper[2:]).any(axis=1)
    return points + 50 * names + 50 * is_outside


@cache
def letter_outline(axis: str) -> MarkerPath:
    """Return the letter of an axis as the outline of a marker: many times quicker to redraw than a text."""
    from matplotlib.path import Path
    from matplotlib.textpath import TextPath

    outline = TextPath((0.0, 0.0), axis, size=LETTER_PT, prop={"family": "DejaVu Sans", "weight": "bold"})
    middle = (outline.vertices.min(axis=0) + outline.vertices.max(axis=0)) / 2
    return Path(outline.vertices - middle, outline.codes)


def letter_size_pt(axis: str) -> float:
    """Return the marker size [points] at which a letter has its own size: matplotlib scales outlines to one."""
    return 2.0 * float(abs(letter_outline(axis).vertices).max())
