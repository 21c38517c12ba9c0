"""What does "from A to B" mean?  Two things, and they are opposites.

    where B sits, from A's place        what moves data from A to B
         A ------> B                         A ~~~~~~> B
         A_T_B                               B_T_A

A transform has one set of numbers and two readings: `A_T_B` says where B sits in
A, and it turns what is written in B into what is written in A.  Whoever says
"from A to B" may mean the place or the data, and the two need opposite transforms.
"""

from __future__ import annotations

import numpy as np

from tflab.core import Transform

from . import style
from .eye import SLANTING
from .frames import clear_paper, draw_arrow, draw_frames, draw_ground, show_all, write_caption
from .picture import Picture
from .sentence import matrix_rows

__all__ = ["describe_readings", "draw_readings"]

CAPTIONS = ("reading 1: where {b} sits in {a}", "reading 2: data of {a}, wanted in {b}")
DASHES = (0, (4.0, 2.0))


def describe_readings(a: str, b: str, a_T_b: Transform) -> str:
    """Return both readings of "from a to b" in words, with their matrices."""
    lines = [f'"from {a} to {b}"']
    for caption, name, transform in zip(CAPTIONS, _names(a, b), (a_T_b, a_T_b.inverse()), strict=True):
        lines += [f"{caption.format(a=a, b=b)}: {name}", *(f"  {row}" for row in matrix_rows(transform))]
    return "\n".join(lines)


def draw_readings(a: str, b: str, a_T_b: Transform) -> Picture:
    """Draw both readings of "from a to b" beside each other."""
    picture = Picture((style.WIDE[0], 3.3))
    span_m = float(np.abs(a_T_b.translation).max()) or 1.0
    places = np.array(((0.0, 0.0, 0.0), a_T_b.translation))
    length_m = 0.4 * span_m
    with style.our_settings():
        readings = zip(CAPTIONS, _names(a, b), (a_T_b, a_T_b.inverse()), (a, b), strict=True)
        for column, (caption, name, transform, axes_of) in enumerate(readings):
            ax = clear_paper(picture.figure.add_axes((0.015 + 0.495 * column, 0.15, 0.475, 0.81)))
            reach = length_m * np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (0, 1)])
            show_all(ax, SLANTING.on_paper((places[:, None] + reach).reshape(-1, 3)), margin_m=0.5 * length_m)
            draw_ground(ax, SLANTING, (-span_m, 2 * span_m), (-span_m, span_m), 0.5 * span_m)
            draw_frames(ax, {a: Transform(), b: a_T_b}, SLANTING, length_m)
            draw_arrow(ax, *places, curve=0.0 if column == 0 else 0.18, line="solid" if column == 0 else DASHES)
            write_caption(ax, caption.format(a=a, b=b))
            numbers = f"{style.fmt_all(transform.translation, digits=2)} along the axes of {axes_of}"
            middle = {"x": 0.25 + 0.495 * column, "ha": "center", "va": "center", "color": style.ACCENT}
            picture.figure.text(y=0.105, s=name, fontsize=style.TITLE_PT, family="monospace", **middle)
            picture.figure.text(y=0.04, s=numbers, fontsize=style.TEXT_PT, **middle)
    picture.text = describe_readings(a, b, a_T_b)
    return picture


def _names(a: str, b: str) -> tuple[str, str]:
    """Return the transforms of both readings."""
    return f"{a}_T_{b}", f"{b}_T_{a}"
