"""In which order was it asked, and when was it clear?  A bar of minutes for each question, and who was left after it.

    minutes 0        2        4        6
    rviz     |===|                            9 left
    view_frames  |===========|                9 left     three minutes, and nobody struck
    delay /scan              |===|            1 left  *

What comes after the star told nothing.  Two ways of asking stand side by side as
two such pictures, or as a line of minutes for each patient: `draw_minutes`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from . import style
from .picture import Picture

__all__ = ["Question", "describe_minutes", "describe_order", "draw_minutes", "draw_order"]

ROW_PX, TOP_PX, BOTTOM_PX, RIGHT_PX = 28, 20, 46, 96
HATCHES = ("", "////", "xxxx")


class Question(NamedTuple):
    """One question: which check, how long it took [min], and how many suspects were left after it."""

    check: str
    minutes: float
    left: int


def describe_order(log: Sequence[Question]) -> str:
    """Return the same in words: a line for each question, and when one suspect was left."""
    lines, minutes, is_done = [], 0.0, False
    for number, (check, takes, left) in enumerate(log, start=1):
        minutes += takes
        note = "  told nothing more" if is_done else "  one suspect left" if left <= 1 else ""
        lines.append(f"{number}. {check}: {takes:g} min, {minutes:g} in all, {left} left{note}")
        is_done = is_done or left <= 1
    return "\n".join(lines) or "nothing was asked"


def draw_order(log: Sequence[Question]) -> Picture:
    """Draw the questions of a visit one after the other."""
    log = [Question(*question) for question in log]
    height_px = TOP_PX + BOTTOM_PX + ROW_PX * max(len(log), 1)
    picture = Picture((style.WIDE[0], height_px / style.SCREEN_DPI))
    picture.text = describe_order(log)
    left_px, width_px = style.room_px([question.check for question in log]), style.WIDE[0] * style.SCREEN_DPI
    with style.our_settings():
        ax = picture.figure.add_axes((
            left_px / width_px, BOTTOM_PX / height_px,
            1 - (left_px + RIGHT_PX) / width_px, 1 - (TOP_PX + BOTTOM_PX) / height_px,
        ))  # fmt: skip
        _bare(ax)
        begin, is_done = 0.0, False
        for row, (_, takes, left) in enumerate(log):
            colour = style.FAINT if is_done else style.ACCENT
            ax.barh(
                row,
                takes,
                left=begin,
                height=0.62,
                color=colour,
                hatch="////" if is_done else "",
                edgecolor=style.PAPER,
            )
            begin += takes
            star = " ★" if left <= 1 and not is_done else ""
            ax.text(begin, row, f"  {left} left{star}", va="center", color=style.INK, fontsize=style.SMALL_PT)
            is_done = is_done or left <= 1
        ax.set_yticks(range(len(log)), [question.check for question in log])
        ax.set_ylim(max(len(log), 1) - 0.4, -0.6)
        ax.set_xlim(0, max(begin, 1.0))
        ax.set_xlabel("minutes", loc="right")
    return picture


def describe_minutes(ways: Mapping[str, Mapping[str, float]], budget_min: float) -> str:
    """Return in words how long each way took: mean, worst, and in how many cases it kept to the budget."""
    width = max(map(len, ways))
    lines = []
    for way, minutes in ways.items():
        values = list(minutes.values())
        kept = sum(value <= budget_min for value in values)
        mean = sum(values) / len(values)
        lines.append(
            f"{way:<{width}}  mean {mean:.1f} min, worst {max(values):g}, {kept} of {len(values)} within {budget_min:g}"
        )
    return "\n".join(lines)


def draw_minutes(ways: Mapping[str, Mapping[str, float]], budget_min: float) -> Picture:
    """Draw how long each way of asking takes until one suspect is left.

    Args:
        ways: by name, at most three; of each the minutes for each suspect, the same suspects for all.
        budget_min: how long a visit may take [min].
    """
    suspects = list(next(iter(ways.values())))
    row_px = 10 * len(ways) + 12
    height_px = TOP_PX + BOTTOM_PX + 30 + row_px * len(suspects)
    picture = Picture((style.WIDE[0], height_px / style.SCREEN_DPI))
    picture.text = describe_minutes(ways, budget_min)
    left_px, width_px = style.room_px(suspects), style.WIDE[0] * style.SCREEN_DPI
    colours = (style.ACCENT, style.FAINT, style.AXIS_COLOURS["z"])
    with style.our_settings():
        ax = picture.figure.add_axes((
            left_px / width_px, BOTTOM_PX / height_px,
            1 - (left_px + 24) / width_px, 1 - (TOP_PX + BOTTOM_PX + 30) / height_px,
        ))  # fmt: skip
        _bare(ax)
        thick = 0.8 / len(ways)
        for number, (way, minutes) in enumerate(ways.items()):
            places = [row - 0.4 + (number + 0.5) * thick for row in range(len(suspects))]
            ax.barh(places, [minutes[name] for name in suspects], height=0.9 * thick, color=colours[number % 3],
                    hatch=HATCHES[number % 3], edgecolor=style.PAPER, label=way)  # fmt: skip
        ax.axvline(budget_min, color=style.GREY, linestyle=(0, (8.0, 3.0)), linewidth=1.2)
        ax.annotate(f"{budget_min:g} min", (budget_min, 1.0), (3, -2), xycoords=("data", "axes fraction"),
                    textcoords="offset points", va="top", color=style.GREY, fontsize=style.SMALL_PT)  # fmt: skip
        ax.set_yticks(range(len(suspects)), suspects)
        ax.set_ylim(len(suspects) - 0.4, -0.6)
        ax.set_xlabel("minutes", loc="right")
        picture.figure.legend(loc="upper left", ncols=len(ways), frameon=False, borderaxespad=0.6)
    return picture


def _bare(ax) -> None:
    for side in ("right", "top", "left"):
        ax.spines[side].set_visible(False)
    ax.tick_params(left=False)
    ax.grid(axis="x", color=style.HAIR)
    ax.set_axisbelow(True)
