"""Draw the record of a diagnosis: the steps of a visit, and the order of its checks.

    minutes                                       ahead   late   slow
    |      1 RViz             into the future       |       |      |
    |==|   2 delay /scan      -0.285 s              |       x      x
       |=| 3 timeout of 1 s   all Ok, 0.47 m        |                     the symptom is gone

A bar is the time of a check, a line that ends is a suspect that was ruled out. The field calls
such a record a *trace* of a diagnosis.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from . import style
from .picture import Picture

ROW_PX, HEAD_PX, FOOT_PX, EDGE_PX = 58, 104, 34, 18
CLOCK_PX, SLANT_PX, LANE_PX, STROKE_PX = 150, 96, 46, 7
MOST_NAMES, LONGEST = 6, 52  # of lanes that bear a name; letters of a row
HATCH = "////"


class VisitStep(NamedTuple):
    """One step of a visit.

    Attributes:
        name: the check, or the fix.
        minutes: how long it took [min].
        said: what it said, or what was seen after it.
        beside: what to compare that with.
        left: the suspects that are left after it.
        is_fix: whether something was done, and not asked.
    """

    name: str
    minutes: float
    said: str
    beside: str
    left: tuple[str, ...]
    is_fix: bool = False


def describe_visit(steps: Sequence[VisitStep], at: int | None = None) -> str:
    """Return the steps in words, up to one of them (counted from 0): a line each, and who was struck."""
    lines, left, minutes = [], steps[0].left, 0.0
    for number, step in enumerate(steps[: len(steps) if at is None else at + 1], start=1):
        minutes += step.minutes
        took = f" ({step.minutes:g} min, {minutes:g} in all)" if step.minutes else ""
        lines.append(f"{number}. {step.name}{took}: {step.said}" + (f"; {step.beside}" if step.beside else ""))
        if struck := [name for name in left if name not in step.left]:
            lines.append(f"   struck: {', '.join(struck)}")
        if number == 1 or struck:
            lines.append(f"   left: {', '.join(step.left) or 'nobody'}")
        left = step.left
    return "\n".join(lines)


class VisitPicture(Picture):
    """The rows of a visit; `show(at)` tells it up to one of them.

    Args:
        steps: what was asked and done; the first is the complaint.
        budget_min: how long a visit may take [min].
    """

    def __init__(self, steps: Sequence[VisitStep], budget_min: float) -> None:
        self._steps, self._suspects, self._budget_min = tuple(steps), steps[0].left, budget_min
        super().__init__(style.wide(HEAD_PX + ROW_PX * len(steps) + FOOT_PX))
        with style.our_settings():
            self.ax = self.figure.add_axes((0.0, 0.0, 1.0, 1.0))
        self.show(len(steps) - 1)

    def show(self, at: int) -> None:
        """Show the visit up to a step, counted from 0."""
        from matplotlib.patches import Rectangle

        self.text = describe_visit(self._steps, at)
        with style.our_settings():
            style.pixel_paper(self.ax)
            band = Rectangle((4, HEAD_PX + at * ROW_PX), self.size_px[0] - 8, ROW_PX, facecolor=style.SHADE, zorder=0)
            self.ax.add_patch(band)
            self._draw_clock(at)
            self._draw_lanes(at)
            for row, step in enumerate(self._steps[: at + 1]):
                self._draw_words(row, step)
        self.redraw_all()

    def _draw_clock(self, at: int) -> None:
        from matplotlib.patches import Rectangle

        whole = max(self._budget_min, sum(step.minutes for step in self._steps))
        bottom, px = HEAD_PX + ROW_PX * len(self._steps), CLOCK_PX / whole
        for minutes, colour in ((0.0, style.FAINT), (self._budget_min, style.GREY)):
            x = EDGE_PX + minutes * px
            self.ax.plot([x, x], [HEAD_PX, bottom], color=colour, linewidth=1.0, linestyle=(0, (6.0, 3.0)), zorder=1)
        self._write(EDGE_PX + self._budget_min * px, bottom + 6, f"{self._budget_min:g} min", "center", "top")
        self._write(EDGE_PX, bottom + 6, "0", "center", "top")
        begin = 0.0
        for row, step in enumerate(self._steps[: at + 1]):
            y = HEAD_PX + (row + 0.5) * ROW_PX
            bar = Rectangle((EDGE_PX + begin * px, y - 8), step.minutes * px, 16, zorder=2,
                            facecolor=style.FAINT if step.is_fix else style.ACCENT, hatch=HATCH if step.is_fix else "",
                            edgecolor=style.PAPER if step.is_fix else "none")  # fmt: skip
            self.ax.add_patch(bar)
            begin += step.minutes

    def _draw_words(self, row: int, step: VisitStep) -> None:
        x, y = EDGE_PX + CLOCK_PX + 22, HEAD_PX + row * ROW_PX
        took = f"   {step.minutes:g} min" if step.minutes else ""
        self.ax.text(x, y + 13, f"{row + 1}  {step.name}{took}", va="center", weight="bold", color=style.INK)
        for line, colour, below in ((step.said, style.INK, 31), (step.beside, style.GREY, 47)):
            self.ax.text(x, y + below, _short(line), va="center", fontsize=style.SMALL_PT, color=colour)

    def _draw_lanes(self, at: int) -> None:
        left = self._steps[at].left
        named = self._suspects if len(self._suspects) <= MOST_NAMES else left if len(left) <= MOST_NAMES else ()
        lane_px = min(LANE_PX, 150 / len(self._suspects))
        first_px = self.size_px[0] - SLANT_PX - lane_px * (len(self._suspects) - 0.5)
        for number, name in enumerate(self._suspects):
            x = first_px + number * lane_px
            until = next((row for row, step in enumerate(self._steps[: at + 1]) if name not in step.left), None)
            end = HEAD_PX + ((until + 0.5) if until is not None else (at + 1.0)) * ROW_PX
            colour = style.ACCENT if until is None else style.GREY
            self.ax.plot([x, x], [HEAD_PX, end], color=colour, linewidth=3.0 if until is None else 1.6, zorder=2)
            if until is not None:
                self.ax.plot([x], [end], marker="x", markersize=STROKE_PX, markeredgewidth=2.0, color=colour, zorder=3)
            if name in named:
                weight = "bold" if len(left) == 1 and until is None else "normal"
                colour = style.INK if until is None else style.GREY
                style.write_slanted(self.ax, x, HEAD_PX - 8, name, color=colour, weight=weight)

    def _write(self, x: float, y: float, text: str, ha: str, va: str) -> None:
        self.ax.text(x, y, text, ha=ha, va=va, fontsize=style.SMALL_PT, color=style.GREY)


def draw_visit(steps: Sequence[VisitStep], budget_min: float) -> VisitPicture:
    """Draw a visit, step by step.

    Raises:
        ValueError: there are no steps.
    """
    if not steps:
        raise ValueError("there is no step to draw, not even the door")
    return VisitPicture(steps, budget_min)


def _short(text: str) -> str:
    return text if len(text) <= LONGEST else text[: LONGEST - 2] + " …"


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
        note = "  told nothing more" if is_done else "  one suspect left" if left <= 1 else ""
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
