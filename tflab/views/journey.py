"""What happened to a message on its way?  Four moments, and the gaps between them.

    message      stamped      sent        received      transformed
    /scan 12        o-----------|>------------[]--------------<>
                     processing    transport       waiting

The stamp says when the world was measured.  It stays with the message, and it is
the moment to look transforms up at; sent, received and transformed are about
computers, not about the world.  If `received` comes before `sent`, two clocks
disagree: no message arrives before it leaves.

`ros2 topic delay` prints received minus stamped.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from . import style
from .picture import Picture

STEPS = ("stamped", "sent", "received", "transformed")
MARKS = {"stamped": "o", "sent": ">", "received": "s", "transformed": "D"}
RIGHT_PX, LANE_PX, TOP_PX, BOTTOM_PX = 60, 40, 46, 58


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
    """Return the same in words: the stamp, and how long after it each other step came."""
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


class JourneyPicture(Picture):
    """One row for each message, one mark for each step."""

    def __init__(self, journeys: Sequence[Journey]) -> None:
        width_px = style.WIDE[0] * style.SCREEN_DPI
        height_px = TOP_PX + LANE_PX * len(journeys) + BOTTOM_PX
        super().__init__((style.WIDE[0], height_px / style.SCREEN_DPI))
        self.text = describe_journeys(journeys)
        name_px = style.room_px(journey.name for journey in journeys)
        with style.our_settings():
            self.ax = self.figure.add_axes((
                name_px / width_px, BOTTOM_PX / height_px,
                1 - (name_px + RIGHT_PX) / width_px, LANE_PX * len(journeys) / height_px,
            ))  # fmt: skip
            self._draw(journeys)

    def _draw(self, journeys: Sequence[Journey]) -> None:
        ax = self.ax
        moments = [moment for journey in journeys for moment in journey.moments_ns.values()]
        first_ns, last_ns = min(moments), max(moments)
        margin_s = max((last_ns - first_ns) / 1e9 * 0.08, 0.005)
        ax.set_xlim(-margin_s, (last_ns - first_ns) / 1e9 + 1.6 * margin_s)
        ax.set_ylim(len(journeys) - 0.5, -0.5)
        for side in ("left", "right", "top"):
            ax.spines[side].set_visible(False)
        ax.set_yticks(range(len(journeys)), [journey.name for journey in journeys])
        ax.tick_params(axis="y", length=0, pad=10, labelcolor=style.INK, labelsize=style.TEXT_PT)
        ax.set_xlabel(f"seconds after {style.fmt_stamp(first_ns)}", loc="right")
        for row, journey in enumerate(journeys):
            places = {step: (moment - first_ns) / 1e9 for step, moment in journey.moments_ns.items()}
            is_late_clock = journey.received_ns < journey.sent_ns
            ax.plot(
                [min(places.values()), max(places.values())], [row, row], linewidth=1.4, zorder=1,
                color=style.ACCENT if is_late_clock else style.FAINT, linestyle=(0, (3, 2)) if is_late_clock else "-",
            )  # fmt: skip
            for step, place in places.items():
                is_stamp = step == "stamped"
                ax.plot([place], [row], MARKS[step], color=style.ACCENT if is_stamp else style.INK, markersize=9,
                        markerfacecolor=style.ACCENT if is_stamp else style.PAPER, markeredgewidth=1.6,
                        zorder=3, gid=f"{journey.name} {step}")  # fmt: skip
            age = style.fmt(journey.age_ns / 1e6, "ms", 0) + (", dropped" if journey.transformed_ns is None else "")
            ax.annotate(age, (max(places.values()), row), (12, 0), textcoords="offset points", va="center",
                        color=style.GREY, fontsize=style.SMALL_PT)  # fmt: skip
        self._draw_key()

    def _draw_key(self) -> None:
        """Write what the marks mean, above the rows."""
        from matplotlib.lines import Line2D

        marks = [
            Line2D([], [], linestyle="none", marker=MARKS[step], markersize=8, markeredgewidth=1.6,
                   color=style.ACCENT if step == "stamped" else style.INK,
                   markerfacecolor=style.ACCENT if step == "stamped" else style.PAPER, label=step)
            for step in STEPS
        ]  # fmt: skip
        self.figure.legend(handles=marks, loc="upper left", ncols=len(STEPS), frameon=False, borderaxespad=0.8,
                           handletextpad=0.2, columnspacing=1.6)  # fmt: skip


def draw_journeys(journeys: Sequence[Journey]) -> JourneyPicture:
    """Draw messages from the moment each was stamped to the moment it was transformed."""
    return JourneyPicture(journeys)


def _plus_ms(duration_ns: int) -> str:
    sign = "+" if duration_ns >= 0 else ""
    return f"{sign}{style.fmt(duration_ns / 1e6, 'ms', 1)}"
