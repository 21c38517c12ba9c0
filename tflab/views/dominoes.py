"""Does this product of transforms fit?  Each transform is a domino, and neighbours must match.

    [ map | odom ][ odom | base_link ][ base_link | laser_frame ]
         =  [ map | laser_frame ]

A domino is `target_T_source`: left what the data is wanted in, right what it is
written in.  Where two halves that meet carry one name they cancel, and what is
left is the two ends.  Where they do not, the product is a number without a
meaning, and no computer will say so.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from . import style
from .frames import clear_paper
from .picture import Picture

__all__ = ["describe_dominoes", "draw_dominoes", "mismatches"]

Tile = tuple[str, str]  # target, source

HEIGHT, PAD, LETTER, GAP = 34.0, 12.0, 6.3, 30.0  # of a tile, beside a name, of a letter, where two do not fit [pt]
WIDTH_PT = 72.0 * style.WIDE[0]
TALL, TOP, BELOW = 1.75, 88.0, 34.0  # of the card [inch]; of the row and of what it comes to [pt]


def mismatches(tiles: Sequence[Tile]) -> list[int]:
    """Return after which tiles, from 0, the next one does not fit."""
    return [i for i, (left, right) in enumerate(pairwise(tiles)) if left[1] != right[0]]


def describe_dominoes(tiles: Sequence[Tile]) -> str:
    """Return the same in words: the row, the product, and what is left or what does not fit."""
    row = "".join(f"[{target}|{source}]" for target, source in tiles)
    product = " @ ".join(f"{target}_T_{source}" for target, source in tiles)
    apart = [f"{tiles[i][1]} is not {tiles[i + 1][0]}" for i in mismatches(tiles)]
    if apart:
        return f"{row}\n{product}\ndoes not fit: {', '.join(apart)}"
    target, source = tiles[0][0], tiles[-1][1]
    return f"{row}\n{product}\nfits: {target}_T_{source}"


def draw_dominoes(*tiles: Tile) -> Picture:
    """Draw transforms, each (target, source), as a row of dominoes, and below it what they come to.

    Raises:
        ValueError: there is no tile.
    """
    if not tiles:
        raise ValueError('a row of dominoes needs at least one, such as draw_dominoes(("map", "odom"))')
    apart = mismatches(tiles)
    widths = [_half(target) + _half(source) for target, source in tiles]
    total = sum(widths) + GAP * len(apart)
    scale = min(1.0, (WIDTH_PT - 40.0) / total)
    picture = Picture((style.WIDE[0], TALL))
    with style.our_settings():
        ax = clear_paper(picture.figure.add_axes((0.0, 0.0, 1.0, 1.0)))
        ax.set_xlim(0.0, WIDTH_PT)
        ax.set_ylim(0.0, 72.0 * TALL)
        x = 0.5 * (WIDTH_PT - scale * total)
        for i, tile in enumerate(tiles):
            _draw_tile(ax, x, TOP, tile, scale)
            x += scale * widths[i]
            if i in apart:
                _write(ax, x + 0.5 * scale * GAP, TOP, "≠", style.ACCENT, 16.0)
                x += scale * GAP
            elif i + 1 < len(tiles):
                ax.plot([x], [TOP], "o", color=style.ACCENT, markersize=5, zorder=20)
        if apart:
            said = ", ".join(f"{tiles[i][1]} is not {tiles[i + 1][0]}" for i in apart)
            _write(ax, 0.5 * WIDTH_PT, BELOW, said, style.ACCENT, style.TITLE_PT)
        else:
            end = (tiles[0][0], tiles[-1][1])
            width = _half(end[0]) + _half(end[1])
            _write(ax, 0.5 * (WIDTH_PT - width) - 14.0, BELOW, "=", style.INK, 13.0)
            _draw_tile(ax, 0.5 * (WIDTH_PT - width), BELOW, end, 1.0)
    picture.text = describe_dominoes(tiles)
    return picture


def _half(name: str) -> float:
    """Return how wide the half of a tile with this name is [pt]."""
    return 2.0 * PAD + LETTER * len(name)


def _draw_tile(ax, x: float, y: float, tile: Tile, scale: float) -> None:
    from matplotlib.patches import FancyBboxPatch

    left, right = (scale * _half(name) for name in tile)
    ax.add_patch(
        FancyBboxPatch((x + 1.5, y - HEIGHT / 2), left + right - 3.0, HEIGHT, boxstyle="round,pad=0,rounding_size=6",
                       facecolor=style.SHADE, edgecolor=style.INK, linewidth=1.3, zorder=5)
    )  # fmt: skip
    ax.plot([x + left] * 2, [y - HEIGHT / 2 + 5, y + HEIGHT / 2 - 5], color=style.INK, linewidth=1.0, zorder=6)
    for name, middle in zip(tile, (x + left / 2, x + left + right / 2), strict=True):
        _write(ax, middle, y, name, style.INK, scale * (style.TITLE_PT - 0.5))


def _write(ax, x: float, y: float, text: str, colour: str, size: float) -> None:
    ax.text(x, y, text, ha="center", va="center", color=colour, fontsize=size, zorder=10)
