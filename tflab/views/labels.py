"""Where may a name stand?  Beside its thing, and on nothing else.

        [name]               eight places around a thing, then eight farther away:
    [name] o [name]          the first that covers no line and no other name, and is on the paper
        [name]

Every name tries its places in the same order, so a figure is the same each time.

Read `axes.py` next.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from . import style

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Place = tuple[float, float]

NEAR_PT, FAR_PT = 8.0, 26.0  # between a thing and its name; a far name gets a thin line
# below right, below left, above right, above left, right, left, below, above
WAYS = np.array([(1, -1), (-1, -1), (1, 1), (-1, 1), (1.4, 0), (-1.4, 0), (0, -1.4), (0, 1.4)])


@dataclass(eq=False)
class Label:
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
            arrowprops={"arrowstyle": "-", "color": style.FAINT, "linewidth": 0.8, "shrinkA": 1.0, "shrinkB": 5.0},
            zorder=100,
        )  # fmt: skip
        self._measured = ("", (0.0, 0.0))

    def size_pt(self) -> tuple[float, float]:
        """Return width and height [points] of the name, measured once for each text."""
        text = self.text.get_text()
        if self._measured[0] != text:
            extent = self.text.get_window_extent()
            scale = 72.0 / self.ax.figure.dpi
            self._measured = (text, (extent.width * scale, extent.height * scale))
        return self._measured[1]

    def stand(self, place: Place, is_far: bool) -> None:
        """Write the name at this place [points from the anchor], with a thin line if it is far."""
        self.text.xy = self.anchor
        self.text.set_position(place)
        self.text.arrow_patch.set_visible(is_far)


def place_labels(labels: Sequence[Label]) -> None:
    """Find a place for each label of one axes, so that none covers a line, a mark or another name."""
    labels = [label for label in labels if label.text.get_text()]
    if not labels:
        return
    ax = labels[0].ax
    points_per_pixel = 72.0 / ax.figure.dpi
    paper = np.array(ax.get_window_extent().extents) * points_per_pixel

    def on_page(place: Place) -> np.ndarray:
        return ax.transData.transform(place) * points_per_pixel

    lines = [np.linspace(on_page(a), on_page(b), 24) for label in labels for a, b in label.keep_off]
    taken = np.vstack([*lines, *(on_page(label.anchor)[None] for label in labels)])
    boxes: list[np.ndarray] = []
    for label in labels:
        half = np.array(label.size_pt()) / 2
        anchor = on_page(label.anchor)
        choices = np.vstack([gap * WAYS + np.sign(WAYS) * half for gap in (NEAR_PT, FAR_PT)])
        faults = [_faults(anchor + choice, half, taken, boxes, paper) for choice in choices]
        best = int(np.argmin(faults))
        label.stand(tuple(choices[best]), is_far=best >= len(WAYS))
        boxes.append(_box(anchor + choices[best], half))


def _faults(middle: np.ndarray, half: np.ndarray, taken: np.ndarray, boxes: list[np.ndarray], paper: np.ndarray) -> int:
    """Return how much a box would cover: points of lines, and, worse, names and the edge of the paper."""
    box = _box(middle, half)
    inside = ((taken >= box[:2]) & (taken <= box[2:])).all(axis=1)
    covered = sum(bool((box[:2] < other[2:]).all() and (other[:2] < box[2:]).all()) for other in boxes)
    is_outside = bool((box[:2] < paper[:2]).any() or (box[2:] > paper[2:]).any())
    return int(inside.sum()) + 50 * covered + 50 * is_outside


def _box(middle: np.ndarray, half: np.ndarray) -> np.ndarray:
    return np.concatenate((middle - half, middle + half))
