"""Draw when each callback was busy and when events happened, one row each.

    on_scan      [##########]      [##########]     busy
    /tf sent      o  o  o  o  o  o  o  o  o  o      events
    /tf stored                o                o    the same events, when the executor got to them

An executor with one thread runs one callback at a time. A callback that waits blocks it, and what
it waits for stands in the same queue behind it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from . import style
from .picture import Picture

COLUMNS = 60  # how wide a row is in words
ROW_PX, TOP_PX, BOTTOM_PX, RIGHT_PX = 46, 20, 52, 24
BAR = 0.5  # of a row's height


class Work(NamedTuple):
    """One row: what somebody did.

    Attributes:
        name: who.
        spans_ns: from when until when busy [ns].
        moments_ns: when something happened [ns].
    """

    name: str
    spans_ns: tuple[tuple[int, int], ...] = ()
    moments_ns: tuple[int, ...] = ()


def describe_work(rows: Sequence[Work], start_ns: int, end_ns: int) -> str:
    """Return the figure's text: `#` for busy, `o` for a moment."""
    width = max(len(row.name) for row in rows)

    def column(moment_ns: int) -> int:
        return min(max((moment_ns - start_ns) * COLUMNS // (end_ns - start_ns), 0), COLUMNS - 1)

    lines = [f"from {style.fmt_stamp(start_ns)} to {style.fmt_stamp(end_ns)}"]
    for row in (_within(row, start_ns, end_ns) for row in rows):
        cells = [" "] * COLUMNS
        for first, last in row.spans_ns:
            for at in range(column(first), column(last) + 1):
                cells[at] = "#"
        for moment in row.moments_ns:
            cells[column(moment)] = "o"
        lines.append(f"{row.name:<{width}} |{''.join(cells)}| {_remark(row)}")
    return "\n".join(lines)


def _within(row: Work, start_ns: int, end_ns: int) -> Work:
    spans = tuple((max(a, start_ns), min(b, end_ns)) for a, b in row.spans_ns if a < end_ns and b > start_ns)
    return Work(row.name, spans, tuple(m for m in row.moments_ns if start_ns <= m <= end_ns))


def _remark(row: Work) -> str:
    parts = []
    if row.spans_ns:
        busy_ns = sum(last - first for first, last in row.spans_ns)
        parts.append(f"busy {style.fmt_stamp(busy_ns)}")
    if row.moments_ns or not row.spans_ns:
        parts.append(f"{len(row.moments_ns)} moments")
    return ", ".join(parts)


def draw_work(rows: Sequence[Work], start_ns: int, end_ns: int) -> Picture:
    """Draw who was busy, and what happened, from `start_ns` to `end_ns` [ns]."""
    picture = Picture(style.wide(TOP_PX + ROW_PX * len(rows) + BOTTOM_PX))
    picture.text = describe_work(rows, start_ns, end_ns)
    name_px = style.names_width_px(row.name for row in rows)
    inside_px = style.WIDE[0] * style.SCREEN_DPI - name_px - RIGHT_PX
    with style.our_settings():
        ax = picture.add_axes_px(name_px, BOTTOM_PX, inside_px, ROW_PX * len(rows))
        ax.set_xlim(start_ns / 1e9, end_ns / 1e9)
        style.label_rows(ax, [row.name for row in rows])
        ax.set_xlabel("time [s]", loc="right")
        for i, row in enumerate(_within(row, start_ns, end_ns) for row in rows):
            ax.axhline(i, color=style.HAIR, linewidth=1.0, zorder=0)
            ax.broken_barh(
                [(first / 1e9, (last - first) / 1e9) for first, last in row.spans_ns], (i - BAR / 2, BAR),
                facecolor=style.SHADE, edgecolor=style.ACCENT, linewidth=1.4, hatch="////", zorder=1,
            )  # fmt: skip
            moments = [moment / 1e9 for moment in row.moments_ns]
            ax.plot(moments, [i] * len(moments), color=style.INK, linestyle="none", marker="o", markersize=5.5,
                    markerfacecolor=style.PAPER, markeredgewidth=1.5, zorder=3, clip_on=False,
                    gid=row.name)  # fmt: skip
    return picture
