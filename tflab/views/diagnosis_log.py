"""Draw the order of the checks of a diagnosis, and how long different orders take.

node list   |==|               9 left         the bars: minutes, one check after the other
delay /scan    |====|          1 left ★       ★: one suspect is left
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from . import style
from .picture import Picture

BAR_PX, TOP_PX, BOTTOM_PX, RIGHT_PX = 28, 20, 46, 96
HATCHES = ("", "////", "xxxx")


class Question(NamedTuple):
    """One question: which check, how long it took [min], and how many suspects were left after it."""

    check: str
    minutes: float
    left: int


def describe_order(log: Sequence[Question]) -> str:
    """Return the figure's text: a line for each question, and when one suspect was left."""
    lines, minutes, is_done = [], 0.0, False
    for number, (check, takes, left) in enumerate(log, start=1):
        minutes += takes
        note = "  added nothing" if is_done else "  one suspect left" if left <= 1 else ""
        lines.append(f"{number}. {check}: {takes:g} min, {minutes:g} in all, {left} left{note}")
        is_done = is_done or left <= 1
    return "\n".join(lines) or "nothing was asked"


def draw_order(log: Sequence[Question]) -> Picture:
    """Draw the questions of a visit one after the other."""
    log = [Question(*question) for question in log]
    height_px = TOP_PX + BOTTOM_PX + BAR_PX * max(len(log), 1)
    picture = Picture(style.wide(height_px))
    picture.text = describe_order(log)
    left_px, width_px = style.names_width_px([question.check for question in log]), style.WIDE[0] * style.SCREEN_DPI
    with style.our_settings():
        ax = picture.add_axes_px(left_px, BOTTOM_PX, width_px - left_px - RIGHT_PX, height_px - TOP_PX - BOTTOM_PX)
        _bare(ax)
        begin, is_done = 0.0, False
        for row, (_, takes, left) in enumerate(log):
            colour = style.FAINT if is_done else style.ACCENT
            hatch = "////" if is_done else ""
            ax.barh(row, takes, left=begin, height=0.62, color=colour, hatch=hatch, edgecolor=style.PAPER)
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
    picture = Picture(style.wide(height_px))
    picture.text = describe_minutes(ways, budget_min)
    left_px, width_px = style.names_width_px(suspects), style.WIDE[0] * style.SCREEN_DPI
    colours = (style.ACCENT, style.FAINT, style.AXIS_COLOURS["z"])
    with style.our_settings():
        ax = picture.add_axes_px(left_px, BOTTOM_PX, width_px - left_px - 24, height_px - TOP_PX - BOTTOM_PX - 30)
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
    style.hide_spines(ax, "right", "top", "left")
    ax.tick_params(left=False)
    ax.grid(axis="x", color=style.HAIR)
    ax.set_axisbelow(True)
