"""Draw how old data is when it is used: a message's way through its steps, and age over time.

    message      stamped      sent        received      transformed
    /scan 12        o-----------|>------------[]--------------<>
                     processing    transport       waiting

The stamp is the time of the measurement, and the time to look transforms up at. If `received`
comes before `sent`, two clocks disagree. `ros2 topic delay` prints received minus stamped.
`draw_ages` draws any such duration over time, with the limit that a robot sets.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from . import style
from .picture import Picture

COLOURS = (style.ACCENT, style.INK, style.AXIS_COLOURS["z"], style.AXIS_COLOURS["x"])
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
    """Return the figure's text: where each curve begins, its largest value, where it ends."""
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


def draw_ages(curves: Sequence[Curve], what: str = "age", limit_s: float | None = None) -> Picture:
    """Draw how old something is as time goes by [s]; `limit_s` is what a robot allows."""
    picture = Picture(style.wide(HEIGHT_PX))
    picture.text = describe_ages(curves, what, limit_s)
    inside_px = (style.WIDE[0] * style.SCREEN_DPI - LEFT_PX - RIGHT_PX, HEIGHT_PX - TOP_PX - BOTTOM_PX)
    with style.our_settings():
        ax = picture.add_axes_px(LEFT_PX, BOTTOM_PX, *inside_px)
        style.hide_spines(ax, "right", "top")
        ax.grid(axis="y", color=style.HAIR)
        for i, curve in enumerate(curves):
            ax.plot(curve.times_s, curve.values_s, label=curve.name, color=COLOURS[i % 4], linestyle=LINES[i % 4],
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
        picture.figure.legend(loc="upper left", ncols=len(curves), frameon=False, borderaxespad=0.8)
    return picture


STEPS = ("stamped", "sent", "received", "transformed")
STEP_MARKS = {"stamped": "o", "sent": ">", "received": "s", "transformed": "D"}
AGE_PX, LANE_PX, KEY_PX, SCALE_PX = 60, 40, 46, 58


class Journey(NamedTuple):
    """One message: when each step happened [ns], each by the clock of the computer where it happened.

    Attributes:
        name: which message it is.
        transformed_ns: None if it never was, because it was dropped.
    """

    name: str
    stamped_ns: int
    sent_ns: int
    received_ns: int
    transformed_ns: int | None = None

    @property
    def moments_ns(self) -> dict[str, int]:
        """The steps that happened, in order."""
        moments = zip(STEPS, (self.stamped_ns, self.sent_ns, self.received_ns, self.transformed_ns), strict=True)
        return {step: moment for step, moment in moments if moment is not None}

    @property
    def age_ns(self) -> int:
        """How old the measurement was at the last step [ns]."""
        return list(self.moments_ns.values())[-1] - self.stamped_ns


def describe_journeys(journeys: Sequence[Journey]) -> str:
    """Return the figure's text: the stamp, and how long after it each other step came."""
    width = max(len("message"), *(len(journey.name) for journey in journeys))
    lines = [f"{'message':<{width}} {'stamped':>12} {'sent':>12} {'received':>12} {'transformed':>12}"]
    for journey in journeys:
        cells = [f"{style.fmt_stamp(journey.stamped_ns):>12}"]
        for step in STEPS[1:]:
            moment = journey.moments_ns.get(step)
            cell = "never" if moment is None else _plus_ms(moment - journey.stamped_ns)
            cells.append(f"{cell:>12}")
        lines.append(f"{journey.name:<{width}} {' '.join(cells)}")
    for journey in journeys:
        if journey.received_ns < journey.sent_ns:
            early_ms = style.fmt((journey.sent_ns - journey.received_ns) / 1e6, "ms", 1)
            lines.append(f"{journey.name} was received {early_ms} before it was sent: two clocks disagree.")
    return "\n".join(lines)


def draw_journeys(journeys: Sequence[Journey], clocks: Mapping[str, str] | None = None) -> Picture:
    """Draw messages from the time each was stamped to the time it was transformed.

    Args:
        clocks: whose clock gave the time of each step that is shown, such as {"sent": "robot's clock"}.
    """
    picture = Picture(style.wide(KEY_PX + LANE_PX * len(journeys) + SCALE_PX))
    picture.text = describe_journeys(journeys)
    name_px = style.names_width_px(journey.name for journey in journeys)
    inside_px = style.WIDE[0] * style.SCREEN_DPI - name_px - AGE_PX
    moments = [moment for journey in journeys for moment in journey.moments_ns.values()]
    first_ns, last_ns = min(moments), max(moments)
    margin_s = max((last_ns - first_ns) / 1e9 * 0.08, 0.005)
    with style.our_settings():
        ax = picture.add_axes_px(name_px, SCALE_PX, inside_px, LANE_PX * len(journeys))
        ax.set_xlim(-margin_s, (last_ns - first_ns) / 1e9 + 1.6 * margin_s)
        style.label_rows(ax, [journey.name for journey in journeys])
        reading = ", on each clock" if clocks else ""
        ax.set_xlabel(f"seconds after {style.fmt_stamp(first_ns)}{reading}", loc="right")
        for row, journey in enumerate(journeys):
            _draw_journey(ax, row, journey, first_ns)
        labels = {step: f"{step} ({clock})" for step, clock in (clocks or {}).items()}
        _draw_key(picture.figure, labels or dict(zip(STEPS, STEPS, strict=True)))
    return picture


def _draw_journey(ax, row: int, journey: Journey, first_ns: int) -> None:
    """Draw one row: a line, a mark for each step, and the age at the last one."""
    places = {step: (moment - first_ns) / 1e9 for step, moment in journey.moments_ns.items()}
    is_late_clock = journey.received_ns < journey.sent_ns
    ax.plot(
        [min(places.values()), max(places.values())], [row, row], linewidth=1.4, zorder=1,
        color=style.ACCENT if is_late_clock else style.FAINT, linestyle=(0, (3, 2)) if is_late_clock else "-",
    )  # fmt: skip
    for step, place in places.items():
        ax.plot([place], [row], markersize=9, zorder=3, gid=f"{journey.name} {step}", **_mark(step))
    age = style.fmt(journey.age_ns / 1e6, "ms", 0) + (", dropped" if journey.transformed_ns is None else "")
    ax.annotate(age, (max(places.values()), row), (12, 0), textcoords="offset points", va="center",
                color=style.GREY, fontsize=style.SMALL_PT)  # fmt: skip


def _draw_key(figure, labels: Mapping[str, str]) -> None:
    """Write what the marks mean, above the rows."""
    from matplotlib.lines import Line2D

    marks = [
        Line2D([], [], linestyle="none", markersize=8, label=label, **_mark(step)) for step, label in labels.items()
    ]
    figure.legend(handles=marks, loc="upper left", ncols=len(marks), frameon=False, borderaxespad=0.8,
                  handletextpad=0.2, columnspacing=1.6)  # fmt: skip


def _mark(step: str) -> dict:
    colour = style.ACCENT if step == "stamped" else style.INK
    face = style.ACCENT if step == "stamped" else style.PAPER
    return {"marker": STEP_MARKS[step], "color": colour, "markerfacecolor": face, "markeredgewidth": 1.6}


def _plus_ms(duration_ns: int) -> str:
    sign = "+" if duration_ns >= 0 else ""
    return f"{sign}{style.fmt(duration_ns / 1e6, 'ms', 1)}"
