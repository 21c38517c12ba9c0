"""In which box does each idea lie?  Five boxes, the later the longer it stays away; what is due is marked.

    1 task, 1 h    4, 1 d    12, 3 d    36, 7 d    108, 21 d
    +---------+   +-------+  +-------+  +------+   +-------+
    | M3 *    |   |  M9   |  |       |  |  M1  |   |       |
    +---------+   +-------+  +-------+  +------+   +-------+

Leitner's boxes; the star is due, and drawn darker.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from . import style
from .picture import Picture

__all__ = ["describe_boxes", "draw_boxes"]

HEIGHT_PX, MARGIN_PX, HEAD_PX, FOOT_PX = 210, 16, 30, 26
GAP_PX, ROW_PX = 12, 22
TO_A_ROW = 2


def describe_boxes(lying: Mapping[str, int], waits: Sequence[str], due: Collection[str] = ()) -> str:
    """Return the same in words: a line for each box."""
    lines = []
    for box, wait in enumerate(waits, start=1):
        names = [f"{name} *" if name in due else name for name, where in lying.items() if where == box]
        lines.append(f"box {box} ({wait}): {', '.join(names) or '-'}")
    return "\n".join(lines)


def draw_boxes(lying: Mapping[str, int], waits: Sequence[str], due: Collection[str] = ()) -> Picture:
    """Draw boxes with names in them.

    Args:
        lying: the box, from 1, in which each name lies.
        waits: of each box how long it stays away, in a few letters.
        due: the names whose time has come.
    """
    names = [[name for name, where in lying.items() if where == box] for box in range(1, len(waits) + 1)]
    rows = max(-(-len(held) // TO_A_ROW) for held in names)
    height_px = max(HEIGHT_PX, HEAD_PX + FOOT_PX + ROW_PX * (rows + 1))
    picture = Picture((style.WIDE[0], height_px / style.SCREEN_DPI))
    picture.text = describe_boxes(lying, waits, due)
    width_px = style.WIDE[0] * style.SCREEN_DPI
    box_px = (width_px - 2 * MARGIN_PX - GAP_PX * (len(waits) - 1)) / len(waits)
    with style.our_settings():
        ax = picture.figure.add_axes((0, 0, 1, 1))
        ax.set_axis_off()
        ax.set_xlim(0, width_px)
        ax.set_ylim(height_px, 0)
        for number, (wait, held) in enumerate(zip(waits, names, strict=True)):
            left = MARGIN_PX + number * (box_px + GAP_PX)
            bottom = height_px - FOOT_PX
            ax.plot([left, left, left + box_px, left + box_px], [HEAD_PX, bottom, bottom, HEAD_PX], color=style.GREY)
            ax.text(left + box_px / 2, HEAD_PX / 2, wait, ha="center", va="center", fontsize=style.SMALL_PT)
            ax.text(left + box_px / 2, bottom + FOOT_PX / 2, str(number + 1), ha="center", va="center",
                    color=style.GREY)  # fmt: skip
            for place, name in enumerate(held):
                row, column = divmod(place, TO_A_ROW)
                is_due = name in due
                ax.text(left + box_px * (column + 0.5) / TO_A_ROW, bottom - ROW_PX * (row + 0.7),
                        f"{name} ★" if is_due else name, ha="center", va="center", fontsize=style.SMALL_PT,
                        color=style.ACCENT if is_due else style.INK)  # fmt: skip
    return picture
