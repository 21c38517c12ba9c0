"""How far behind, as time goes by?  Curves of seconds over seconds, and the limit that a robot sets.

    4 s |              .-'  no limit      grows for as long as the robot runs
        |          .-'
        |      .-'
    1 s |--.-'--------------  limit
        |-'-'-'-'-'-'-'-'-'-  two at most  stays where it is
        +-------------------> time

The age of data when it is used, or the gap between what is asked for and what is
there: the picture is the same.  What matters is whether a curve comes back.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from . import style
from .picture import Picture

LINES = ("solid", (0, (4.0, 1.6)), (0, (1.0, 1.1)), (0, (6.0, 1.5, 1.0, 1.5)))
MARKS = ("o", "s", "D", "^")
LEFT_PX, RIGHT_PX, TOP_PX, BOTTOM_PX, HEIGHT_PX = 70, 24, 50, 52, 320


class Curve(NamedTuple):
    """One number through time.

    Attributes:
        name: of what.
        times_s: when [s].
        values_s: how much [s].
    """

    name: str
    times_s: tuple[float, ...]
    values_s: tuple[float, ...]


def describe_ages(curves: Sequence[Curve], what: str, limit_s: float | None) -> str:
    """Return the same in words: where each curve begins, its largest value, where it ends."""
    width = max(len("curve"), *(len(curve.name) for curve in curves))
    lines = [f"{what}", f"{'curve':<{width}} {'first':>10} {'largest':>10} {'last':>10}"]
    for curve in curves:
        figures = (curve.values_s[0], max(curve.values_s), curve.values_s[-1])
        cells = " ".join(f"{style.fmt(value, 's'):>10}" for value in figures)
        over = "" if limit_s is None else f"  over the limit: {sum(value > limit_s for value in curve.values_s)}"
        lines.append(f"{curve.name:<{width}} {cells}{over} of {len(curve.values_s)}" if over else
                     f"{curve.name:<{width}} {cells}")  # fmt: skip
    if limit_s is not None:
        lines.append(f"limit {style.fmt(limit_s, 's')}")
    return "\n".join(lines)


class AgesPicture(Picture):
    """Curves that differ in colour, line and mark, and a limit."""

    def __init__(self, curves: Sequence[Curve], what: str, limit_s: float | None) -> None:
        width_px = style.WIDE[0] * style.SCREEN_DPI
        super().__init__((style.WIDE[0], HEIGHT_PX / style.SCREEN_DPI))
        self.text = describe_ages(curves, what, limit_s)
        with style.our_settings():
            self.ax = self.figure.add_axes((
                LEFT_PX / width_px, BOTTOM_PX / HEIGHT_PX,
                1 - (LEFT_PX + RIGHT_PX) / width_px, 1 - (TOP_PX + BOTTOM_PX) / HEIGHT_PX,
            ))  # fmt: skip
            self._draw(curves, what, limit_s)

    def _draw(self, curves: Sequence[Curve], what: str, limit_s: float | None) -> None:
        ax = self.ax
        for side in ("right", "top"):
            ax.spines[side].set_visible(False)
        ax.grid(axis="y", color=style.HAIR)
        colours = (style.ACCENT, style.INK, style.AXIS_COLOURS["z"], style.AXIS_COLOURS["x"])
        for i, curve in enumerate(curves):
            ax.plot(curve.times_s, curve.values_s, label=curve.name, color=colours[i % 4], linestyle=LINES[i % 4],
                    linewidth=1.6, marker=MARKS[i % 4], markersize=4.5, markerfacecolor=style.PAPER,
                    markevery=max(len(curve.times_s) // 25, 1), gid=curve.name)  # fmt: skip
        values = [value for curve in curves for value in curve.values_s] + [limit_s or 0.0, 0.0]
        times = [time for curve in curves for time in curve.times_s]
        margin = 0.08 * (max(values) - min(values) or 1.0)
        ax.set_ylim(min(values) - margin, max(values) + margin)
        ax.set_xlim(min(times), max(times))
        if limit_s is not None:
            ax.axhline(limit_s, color=style.GREY, linewidth=1.2, linestyle=(0, (8.0, 3.0)), zorder=1)
            ax.annotate(f"limit {style.fmt(limit_s, 's')}", (1.0, limit_s), (-4, 4), xycoords=("axes fraction", "data"),
                        textcoords="offset points", ha="right", color=style.GREY, fontsize=style.SMALL_PT)  # fmt: skip
        ax.set_xlabel("time [s]", loc="right")
        ax.set_ylabel(f"{what} [s]", loc="top")
        self.figure.legend(loc="upper left", ncols=len(curves), frameon=False, borderaxespad=0.8)


def draw_ages(curves: Sequence[Curve], what: str = "age", limit_s: float | None = None) -> AgesPicture:
    """Draw how far behind something is as time goes by [s]; `limit_s` is what a robot allows."""
    return AgesPicture(curves, what, limit_s)
