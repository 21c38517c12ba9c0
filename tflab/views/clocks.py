"""Draw what each node's clock shows while a bag is played.

    86 401 s |----------------------  detector   on wall time: a day away from the bag
             //
        16 s |      .-'|      .-'     rviz2      use_sim_time: the bag's time, back at the start in a loop
         0 s |......................  detector   use_sim_time, and nobody publishes /clock: stopped
             +----------------------> seconds of playing

A lookup at "now" uses the node's own clock. A stopped clock shows 0, and 0 means "latest" to tf2.
ROS time is system time unless `use_sim_time` selects /clock.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tflab.text import Texts

from . import style
from .picture import Picture

LINES = ("solid", (0, (4.0, 1.6)), (0, (1.0, 1.1)))
WIDTHS = (7.0, 2.4, 1.6)  # wide and pale below, narrow on top: clocks that agree lie on each other
ALPHAS = (0.45, 1.0, 1.0)
COLOURS = (style.ACCENT, style.INK, style.AXIS_COLOURS["z"])
MARKS = ("o", "s", "D")
PASSES = 2.0  # how many lengths of the bag the picture is wide, at the usual rate
SAMPLES = 401
BETWEEN_PASSES_S = 0.01  # a player opens its files again
HEIGHT_PX, ROW_PX = 380, 24
LEFT_PX, RIGHT_PX, TOP_PX, WALL_PX, GAP_PX, BOTTOM_PX = 82, 24, 54, 64, 26, 52

TEXTS = Texts(__file__)


@dataclass(frozen=True)
class Play:
    """How a bag is played, and when.

    Attributes:
        begin_s, length_s: of the bag [s].
        rate: as `--rate` says.
        loops: `--loop`.
        publishes_clock: `--clock`.
        wall_s: what the machine's clock shows when the playing begins [s].
        tf_behind_s: how old the newest transform of the chain is when it is heard [s].
        cache_s: how long a buffer keeps transforms [s].
    """

    begin_s: float = 1.0
    length_s: float = 15.0
    rate: float = 1.0
    loops: bool = False
    publishes_clock: bool = True
    wall_s: float = 86401.0
    tf_behind_s: float = 0.01
    cache_s: float = 10.0

    def __post_init__(self) -> None:
        if self.length_s <= 0.0 or self.rate <= 0.0:
            raise ValueError(f"a bag has a length, and a rate is above 0: {self.length_s} s, {self.rate}")


class NowAnswer(NamedTuple):
    """What comes back when a node asks for its own now.

    Attributes:
        kind: "answered", "latest", or refused because it lies in the "future" or the "past".
        gap_s: how far beyond what the buffer has [s].
    """

    kind: str
    gap_s: float = 0.0


def bag_time(play: Play, played_s: float) -> float:
    """Return which moment of the bag is being played [s]."""
    along_s = played_s * play.rate
    if play.loops:
        return play.begin_s + min(along_s % (play.length_s + BETWEEN_PASSES_S * play.rate), play.length_s)
    return play.begin_s + min(along_s, play.length_s)


def clock_of(play: Play, follows_clock: bool, played_s: float) -> float:
    """Return what a node's clock shows [s]; `follows_clock` is its use_sim_time."""
    if not follows_clock:
        return play.wall_s + played_s
    return bag_time(play, played_s) if play.publishes_clock else 0.0


def newest_tf(play: Play, played_s: float) -> float:
    """Return the stamp of the newest transform that was heard in this pass [s]."""
    return max(bag_time(play, played_s) - play.tf_behind_s, play.begin_s)


def asked_now(play: Play, follows_clock: bool, played_s: float) -> NowAnswer:
    """Return what a buffer says to a node that asks for its own now."""
    now_s, newest_s = clock_of(play, follows_clock, played_s), newest_tf(play, played_s)
    oldest_s = max(play.begin_s, newest_s - play.cache_s)
    if now_s == 0.0:
        return NowAnswer("latest")
    if now_s > newest_s:
        return NowAnswer("future", now_s - newest_s)
    return NowAnswer("past", oldest_s - now_s) if now_s < oldest_s else NowAnswer("answered")


def describe_clocks(nodes: Mapping[str, bool], play: Play, played_s: float, language: str = "en") -> str:
    """Return the figure's text: for each node its now, the newest transform, and what comes of asking for now."""
    head = tuple(TEXTS[key].say(language) for key in ("node", "now", "newest", "asked"))
    rows = [head, *_rows(nodes, play, played_s, language)]
    widths = [max(len(row[i]) for row in rows) for i in range(3)]
    lines = [TEXTS["after"].say(language, played=style.fmt(played_s, "s", 2))]
    for row in rows:
        cells = [
            f"{cell:<{width}}" if i == 0 else f"{cell:>{width}}"
            for i, (cell, width) in enumerate(zip(row, widths, strict=False))
        ]
        lines.append("  ".join([*cells, row[3]]))
    return "\n".join(lines)


def draw_clocks(nodes: Mapping[str, bool], play: Play | None = None, played_s: float = 0.0) -> ClocksPicture:
    """Draw what each node's clock shows while a bag is played.

    Args:
        nodes: by name, whether it has use_sim_time; at most three.
        play: how the bag is played.
        played_s: the time that is marked and described in the text [s].
    """
    picture = ClocksPicture(tuple(nodes))
    picture.show(nodes, play or Play(), played_s)
    return picture


class ClocksPicture(Picture):
    """Above the wall's time, below the bag's, one line for each node; under them a row of words for each."""

    def __init__(self, names: tuple[str, ...]) -> None:
        if not 1 <= len(names) <= len(LINES):
            raise ValueError(f"between one and {len(LINES)} clocks can be told apart, not {len(names)}")
        self.names = names
        width_px = style.WIDE[0] * style.SCREEN_DPI
        height_px = HEIGHT_PX + ROW_PX * (len(names) + 1)
        super().__init__(style.wide(height_px))
        table_px = ROW_PX * (len(names) + 1) + 6
        inside_px = width_px - LEFT_PX - RIGHT_PX
        bag_px = height_px - TOP_PX - WALL_PX - GAP_PX - BOTTOM_PX - table_px
        with style.our_settings():
            self.bag = self.add_axes_px(LEFT_PX, table_px + BOTTOM_PX, inside_px, bag_px)
            self.wall = self.add_axes_px(LEFT_PX, table_px + BOTTOM_PX + bag_px + GAP_PX, inside_px, WALL_PX)
            self._dress()
            self._make_lines()
            self._make_table(height_px, table_px)

    def _dress(self) -> None:
        """Write what stands at the axes; what moves is made afterwards."""
        for ax in (self.bag, self.wall):
            style.hide_spines(ax, "top", "right")
            ax.grid(axis="y", color=style.HAIR)
        self.wall.spines["bottom"].set_visible(False)
        self.wall.tick_params(axis="x", length=0, labelbottom=False)
        self.bag.set_xlabel("playing [s]", loc="right")
        self.wall.set_title("clock [s]", loc="left", fontsize=style.SMALL_PT, color=style.GREY, pad=6)
        for ax, at in ((self.bag, 1.0), (self.wall, 0.0)):  # the axis of time is broken between the two
            ax.plot([-0.008, 0.008], [at - 0.02, at + 0.02], transform=ax.transAxes, color=style.GREY, linewidth=1.2,
                    clip_on=False)  # fmt: skip

    def _make_lines(self) -> None:
        self.lines, self.dots = [], []
        for i, name in enumerate(self.names):
            how = {
                "color": COLOURS[i],
                "linestyle": LINES[i],
                "linewidth": WIDTHS[i],
                "alpha": ALPHAS[i],
                "zorder": 2 + i,
            }
            self.lines.append([ax.plot([], [], label=name, gid=name, **how)[0] for ax in (self.wall, self.bag)])
            mark = {"color": COLOURS[i], "marker": MARKS[i], "linestyle": "none", "markersize": 9.0 - 2.0 * i,
                    "markerfacecolor": style.PAPER, "markeredgewidth": 1.6, "zorder": 6 + i}  # fmt: skip
            self.dots.append([ax.plot([], [], **mark)[0] for ax in (self.wall, self.bag)])
        cursor = {"color": style.GREY, "linewidth": 1.0, "zorder": 1}
        self.cursors = [ax.axvline(0.0, **cursor) for ax in (self.wall, self.bag)]
        handles = [self.lines[i][1] for i in range(len(self.names))]
        self.figure.legend(handles=handles, loc="upper right", ncols=len(self.names), frameon=False, handlelength=3.2,
                           borderaxespad=0.8)  # fmt: skip
        self.moving += [artist for pair in (*self.lines, *self.dots) for artist in pair] + self.cursors

    def _make_table(self, height_px: float, table_px: float) -> None:
        """Make the cells below: which node, its now, the newest transform, and what comes of asking."""
        left = LEFT_PX / (style.WIDE[0] * style.SCREEN_DPI)
        columns = (0.03, left + 0.22, left + 0.40, left + 0.43)
        sides = ("left", "right", "right", "left")
        self.cells = []
        for row in range(len(self.names) + 1):
            y = (table_px - ROW_PX * (row + 0.5)) / height_px
            cells = [self.figure.text(x, y, "", ha=ha, va="center", fontsize=style.SMALL_PT,
                                      color=style.GREY if row == 0 else COLOURS[row - 1])
                     for x, ha in zip(columns, sides, strict=True)]  # fmt: skip
            self.cells.append(cells)
        for cell, text in zip(self.cells[0], ("node", "now", "newest TF", "lookup at now"), strict=True):
            cell.set_text(text)
        self.moving += [cell for row in self.cells[1:] for cell in row]

    def show(self, nodes: Mapping[str, bool], play: Play, played_s: float, language: str = "en") -> None:
        """Move everything to this way of playing, and to this moment [s]."""
        self._set_limits(play)
        times_s = np.linspace(0.0, PASSES * play.length_s, SAMPLES)
        for i, name in enumerate(self.names):
            shown = np.array([clock_of(play, nodes[name], time_s) for time_s in times_s])
            shown[1:][np.diff(shown) < 0.0] = np.nan  # back at the start: a gap, not a slope
            now_s = clock_of(play, nodes[name], played_s)
            for is_bag, line, dot in zip((False, True), self.lines[i], self.dots[i], strict=True):
                is_here = is_bag == nodes[name]
                line.set_data(times_s, shown if is_here else np.full_like(shown, np.nan))
                dot.set_data([played_s], [now_s if is_here else np.nan])
        for cursor in self.cursors:
            cursor.set_xdata([played_s, played_s])
        for cells, row in zip(self.cells[1:], _rows(nodes, play, played_s, "en"), strict=True):
            for cell, text in zip(cells, row, strict=True):
                cell.set_text(text)
        self.text = describe_clocks(nodes, play, played_s, language)

    def _set_limits(self, play: Play) -> None:
        limits = (PASSES * play.length_s, play.begin_s + play.length_s, play.wall_s)
        if limits == getattr(self, "_limits", None):
            return
        self._limits = limits
        for ax in (self.wall, self.bag):
            ax.set_xlim(0.0, limits[0])
        self.bag.set_ylim(-0.06 * limits[1], 1.06 * limits[1])
        self.wall.set_ylim(play.wall_s - 0.1 * limits[0], play.wall_s + 1.1 * limits[0])
        self.wall.set_yticks([play.wall_s], [f"{play.wall_s:,.0f}".replace(",", " ")])
        self.redraw_all()


def _rows(nodes: Mapping[str, bool], play: Play, played_s: float, language: str) -> list[tuple[str, str, str, str]]:
    rows = []
    for name, follows_clock in nodes.items():
        now_s, newest_s = clock_of(play, follows_clock, played_s), newest_tf(play, played_s)
        asked = asked_now(play, follows_clock, played_s)
        said = TEXTS[asked.kind].say(language, gap=style.fmt(asked.gap_s, "s"))
        rows.append((name, style.fmt(now_s, "s"), style.fmt(newest_s, "s"), said))
    return rows
