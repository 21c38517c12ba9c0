"""Draw what a buffer holds between two frames over time, and the answer to a query.

    map -> odom          |  [o====o====o====o]     |   a window, a mark for each sample
    odom -> base_link    |     [ooooooooooooooo]   |
    base_link -> laser   |<=======================>|   static: valid at any time
    all of them          |     [-----------]       |   the common interval
    query                |          ^              |   inside: there is an answer

Each edge of the path must cover the time of a lookup. Inside the common interval there is an
answer, between two samples too; outside it tf2 raises, and its text stands in the picture. LATEST
is the end of the common interval; static edges do not count. tf2 calls a lane a TimeCache.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from textwrap import wrap
from typing import NamedTuple

from tflab.core import LATEST, NSEC_PER_SEC, History, StampedTransform, TransformException

from . import style
from .picture import Picture

Ask = Callable[[str, str, int], StampedTransform]

TEXT_COLUMNS = 48  # how wide a lane is in words
RIGHT_PX = 24  # what stands right of a lane
LANE_PX, TOP_PX = 34, 30
AXIS_PX, HEADLINE_PX, ROW_PX, FOOT_PX = 58, 22, 20.5, 10  # below the lanes: stamps, a headline, a row, the rim
BODY_COLUMNS, BODY_ROWS = 88, 4  # how many letters go side by side on the card, and rows below each other
LONG_STAMP_NS = 100_000 * NSEC_PER_SEC
QUERY_ROW = -0.75  # above the lanes
MOST_MARKS = 120  # a lane with more samples is drawn as a band
MOST_TICKS, TICK_STEPS = 9, (1, 2, 5, 10)  # people count in these


class Lane(NamedTuple):
    """One edge through time.

    Attributes:
        parent, child: the edge.
        stamps_ns: when it was measured, ascending [ns]; of no meaning if it is static.
        is_static: whether it is good for any time.
    """

    parent: str
    child: str
    stamps_ns: tuple[int, ...]
    is_static: bool = False

    @property
    def name(self) -> str:
        return f"{self.parent} -> {self.child}"


class Answer(NamedTuple):
    """What came back for a query.

    Attributes:
        asked_ns: the moment asked for [ns], maybe LATEST.
        stamped: the transform, or None if there is none.
        exception: the name of the exception's class, "" if there is an answer.
        text: tf2's text to the letter, "" if there is an answer.
    """

    asked_ns: int
    stamped: StampedTransform | None
    exception: str
    text: str

    @property
    def moment_ns(self) -> int:
        """The moment meant [ns]: if LATEST was answered, the one that it turned out to be."""
        return self.stamped.stamp_ns if self.stamped is not None else self.asked_ns

    @property
    def moment(self) -> str:
        """The same in words."""
        moment = style.fmt_stamp(self.moment_ns)
        if self.asked_ns != LATEST:
            return moment
        return f"LATEST: {moment}" if self.moment_ns != LATEST else "LATEST"


@dataclass(frozen=True, slots=True)
class Timeline:
    """The edges between two frames, in the order in which a lookup walks them."""

    target_frame: str
    source_frame: str
    lanes: tuple[Lane, ...]

    @property
    def common_ns(self) -> tuple[int, int] | None:
        """From when until when every lane has data [ns]; None if never, or if all are static."""
        moving = [lane.stamps_ns for lane in self.lanes if not lane.is_static]
        if not moving or not all(moving):
            return None
        start_ns, end_ns = max(stamps[0] for stamps in moving), min(stamps[-1] for stamps in moving)
        return (start_ns, end_ns) if start_ns <= end_ns else None

    @property
    def shown_ns(self) -> tuple[int, int]:
        """From when until when to draw [ns]: all there is, and a sixth more on either side."""
        stamps = [stamp for lane in self.lanes if not lane.is_static for stamp in lane.stamps_ns]
        if not stamps:
            return (0, 1_000_000_000)
        oldest, newest = min(stamps), max(stamps)
        margin = max((newest - oldest) // 6, 50_000_000)
        return (oldest - margin, newest + margin)


def lane_from_history(history: History) -> Lane:
    """Return the lane of one child, under its newest parent."""
    return Lane(history.parents[-1], history.frame, tuple(history.stamps_ns), history.is_static)


def answer(timeline: Timeline, ask: Ask, stamp_ns: int) -> Answer:
    """Ask for the transform at `stamp_ns` [ns], and keep what came back, refusals too."""
    try:
        return Answer(stamp_ns, ask(timeline.target_frame, timeline.source_frame, stamp_ns), "", "")
    except TransformException as refused:
        return Answer(stamp_ns, None, type(refused).__name__, str(refused))


def describe_answer(timeline: Timeline, reply: Answer) -> list[str]:
    """Return what came back in words: the pose, or tf2's exception and its text to the letter."""
    if reply.stamped is None:
        return [reply.exception, reply.text]
    transform = reply.stamped.transform
    return [
        f"{timeline.source_frame} in {timeline.target_frame} at {style.fmt_stamp(reply.stamped.stamp_ns)}",
        f"translation {style.fmt_all(transform.translation)}",
        f"roll, pitch, yaw {style.fmt_all(transform.rpy(), 'rad')}",
    ]


def describe_timeline(timeline: Timeline, reply: Answer) -> str:
    """Return the figure's text: every lane in letters, its window, and the answer."""
    left_ns, right_ns = timeline.shown_ns
    names = [lane.name for lane in timeline.lanes] + ["all of them", "query"]
    width = max(map(len, names))

    def column(moment_ns: int) -> int:
        moment_ns = min(max(moment_ns, left_ns), right_ns)
        return round((moment_ns - left_ns) * (TEXT_COLUMNS - 1) / (right_ns - left_ns))

    def row(name: str, cells: str, remark: str) -> str:
        return f"{name:<{width}} |{cells}| {remark}".rstrip()

    lines = [f"lookup_transform('{timeline.target_frame}', '{timeline.source_frame}', {reply.moment})"]
    for lane in timeline.lanes:
        lines.append(row(lane.name, _lane_cells(lane, column), _lane_remark(lane)))
    common = timeline.common_ns
    if common is not None:
        first, last = column(common[0]), column(common[1])
        cells = " " * first + "-" * (last - first + 1)
        remark = f"{style.fmt_stamp(common[0])} to {style.fmt_stamp(common[1])}"
    else:
        all_static = all(lane.is_static for lane in timeline.lanes)
        cells, remark = ("-" * TEXT_COLUMNS, "any time") if all_static else ("", "no common time")
    lines.append(row("all of them", f"{cells:<{TEXT_COLUMNS}}", remark))
    lines.append(row("query", f"{' ' * column(reply.moment_ns) + '^':<{TEXT_COLUMNS}}", reply.moment))
    return "\n".join((*lines, *describe_answer(timeline, reply)))


def _lane_cells(lane: Lane, column: Callable[[int], int]) -> str:
    if lane.is_static:
        return f"<{'=' * (TEXT_COLUMNS - 2)}>"
    if not lane.stamps_ns:
        return " " * TEXT_COLUMNS
    first, last = column(lane.stamps_ns[0]), column(lane.stamps_ns[-1])
    cells = [" "] * first + ["="] * (last - first + 1) + [" "] * (TEXT_COLUMNS - 1 - last)
    for stamp in lane.stamps_ns:
        cells[column(stamp)] = "o"
    return "".join(cells)


def _lane_remark(lane: Lane) -> str:
    if lane.is_static:
        return "static"
    if not lane.stamps_ns:
        return "no data"
    window = f"{style.fmt_stamp(lane.stamps_ns[0])} to {style.fmt_stamp(lane.stamps_ns[-1])}"
    return f"{window}, {len(lane.stamps_ns)} samples"


class TimelinePicture(Picture):
    """The lanes, the common interval, and a query that can be moved."""

    def __init__(self, timeline: Timeline, ask: Ask, rows: int = BODY_ROWS) -> None:
        """Draw the lanes, with space for `rows` rows of an answer below them."""
        self.timeline, self._ask, self._rows = timeline, ask, rows
        self._answer_px = AXIS_PX + HEADLINE_PX + ROW_PX * rows + FOOT_PX
        height_px = TOP_PX + LANE_PX * (len(timeline.lanes) + 1) + self._answer_px
        width_px = style.WIDE[0] * style.SCREEN_DPI
        super().__init__(style.wide(height_px))
        lanes_px = height_px - TOP_PX - self._answer_px
        name_px = style.names_width_px(lane.name for lane in timeline.lanes)
        with style.our_settings():
            self.ax = self.add_axes_px(name_px, self._answer_px, width_px - name_px - RIGHT_PX, lanes_px)
            self._draw_lanes()
            self._draw_query()
        self.moving = [self.query, self.handle, self.moment, self.headline, self.body]

    def show(self, stamp_ns: int, reply: Answer | None = None) -> TimelinePicture:
        """Move the query to `stamp_ns` [ns], and return the picture; `reply` if it has been asked already."""
        reply = reply or answer(self.timeline, self._ask, stamp_ns)
        lines = describe_answer(self.timeline, reply)
        refused = reply.stamped is None
        left_ns, right_ns = self.timeline.shown_ns
        at = (min(max(reply.moment_ns, left_ns), right_ns) - left_ns) / 1e9
        with style.our_settings():
            self.query.set_data([at, at], [QUERY_ROW, len(self.timeline.lanes) + 0.5])
            self.query.set_linestyle((0, (3.0, 2.0)) if refused else "solid")
            self.handle.set_data([at], [QUERY_ROW])
            self.handle.set_marker("X" if refused else "o")
            self.moment.xy = (at, QUERY_ROW)
            self.moment.set_text(reply.moment)
            is_near_end = at > 0.75 * self.ax.get_xlim()[1]
            self.moment.set_position((-9, 0) if is_near_end else (9, 0))
            self.moment.set_horizontalalignment("right" if is_near_end else "left")
            self.headline.set_text(lines[0])
            self.body.write("\n".join(_fitting(lines[1:], self._rows)))
        self.text = describe_timeline(self.timeline, reply)
        return self

    def _draw_lanes(self) -> None:
        lanes = self.timeline.lanes
        left_ns, right_ns = self.timeline.shown_ns
        ax, rows = self.ax, len(lanes)
        ax.set_xlim(0.0, (right_ns - left_ns) / 1e9)
        ax.set_ylim(rows + 0.5, -0.5)
        style.hide_spines(ax, "left", "right", "top")
        ax.set_yticks([*range(rows), rows], [*(lane.name for lane in lanes), "all of them"])
        ax.tick_params(axis="y", length=0, pad=10, labelcolor=style.INK, labelsize=style.TEXT_PT)
        _label_time(ax, left_ns, right_ns)
        for row, lane in enumerate(lanes):
            self._draw_lane(row, lane, left_ns, right_ns)
        common = self.timeline.common_ns
        if common is not None:
            start, end = ((moment - left_ns) / 1e9 for moment in common)
            ax.axvspan(start, end, facecolor=style.SHADE, zorder=-10)
            ax.plot([start, end], [rows, rows], color=style.INK, linewidth=1.4, marker="|", markersize=11, zorder=2)
        elif all(lane.is_static for lane in lanes):
            ax.plot(ax.get_xlim(), [rows, rows], color=style.INK, linewidth=1.4, zorder=2)

    def _draw_lane(self, row: int, lane: Lane, left_ns: int, right_ns: int) -> None:
        ax = self.ax
        if lane.is_static:
            end = (right_ns - left_ns) / 1e9
            ax.plot([0.0, end], [row, row], color=style.GREY, linewidth=2.4, linestyle=(0, (5.0, 2.0)), zorder=1)
            ax.plot([0.0], [row], marker="<", color=style.GREY, clip_on=False)
            ax.plot([end], [row], marker=">", color=style.GREY, clip_on=False)
            return
        if not lane.stamps_ns:
            return
        times = [(stamp - left_ns) / 1e9 for stamp in lane.stamps_ns]
        ax.plot([times[0], times[-1]], [row, row], color=style.FAINT, linewidth=7.0, zorder=1)
        ax.plot([times[0], times[-1]], [row, row], color=style.INK, linestyle="none", marker="|", markersize=13,
                markeredgewidth=1.6, zorder=2)  # fmt: skip
        if len(times) <= MOST_MARKS:
            ax.plot(times, [row] * len(times), color=style.INK, linestyle="none", marker="o", markersize=3.5, zorder=3)

    def _draw_query(self) -> None:
        ax = self.ax
        (self.query,) = ax.plot([], [], color=style.ACCENT, linewidth=2.0, zorder=10, clip_on=False)
        (self.handle,) = ax.plot([], [], color=style.ACCENT, marker="o", markersize=10, zorder=11, clip_on=False,
                                 markerfacecolor=style.PAPER, markeredgewidth=2.0)  # fmt: skip
        self.moment = ax.annotate("", (0.0, QUERY_ROW), (9, 0), textcoords="offset points", va="center",
                                  color=style.ACCENT, annotation_clip=False)  # fmt: skip
        _, height = self.size_px
        head, body = self._answer_px - AXIS_PX, self._answer_px - AXIS_PX - HEADLINE_PX
        self.headline = self.figure.text(0.025, head / height, "", fontsize=style.TITLE_PT, fontweight="bold", va="top",
                                         color=style.ACCENT)  # fmt: skip
        self.body = self.add_number_table(0.025, body / height)


def _fitting(lines: Sequence[str], most: int) -> list[str]:
    """Return lines broken to fit on the card; what does not fit is still in the words of the picture."""
    rows = [row for line in lines for row in wrap(line, BODY_COLUMNS)]
    return rows if len(rows) <= most else [*rows[: most - 1], "..."]


def _label_time(ax, left_ns: int, right_ns: int) -> None:
    """Write the stamps below a time axis that counts seconds from `left_ns` [ns].

    Stamps since 1970 have too many digits to stand side by side, so they are
    counted from a whole second that is named at the end of the axis.
    """
    from matplotlib.ticker import MaxNLocator

    base_ns = left_ns // NSEC_PER_SEC * NSEC_PER_SEC if left_ns >= LONG_STAMP_NS else 0
    first, last = (left_ns - base_ns) / 1e9, (right_ns - base_ns) / 1e9
    round_ones = MaxNLocator(MOST_TICKS, steps=TICK_STEPS).tick_values(first, last)
    ticks = [tick for tick in round_ones if first <= tick <= last]
    digits = 1 if round_ones[1] - round_ones[0] > 0.09 else 2
    ax.set_xticks([tick - first for tick in ticks], [style.fmt(tick, "", digits) for tick in ticks])
    ax.set_xlabel(f"stamp [s] after {base_ns // NSEC_PER_SEC}" if base_ns else "stamp [s]", loc="right")


def draw_timeline(
    target_frame: str, source_frame: str, lanes: Sequence[Lane], ask: Ask, stamp_ns: int
) -> TimelinePicture:
    """Draw the edges between two frames through time, and the answer to a query at `stamp_ns` [ns]."""
    timeline = Timeline(target_frame, source_frame, tuple(lanes))
    reply = answer(timeline, ask, stamp_ns)
    rows = len(_fitting(describe_answer(timeline, reply)[1:], BODY_ROWS))
    return TimelinePicture(timeline, ask, rows).show(stamp_ns, reply)
