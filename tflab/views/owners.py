"""Who says so?  For each edge its owner, the data it is made of, the switch, and how often it comes.

    edge                    owner             source        switch         rate
    map -> odom             localization      scan, map     tf_broadcast   10.2 Hz
    odom -> base_footprint  wheel_odometry    wheels        publish_tf     20.2 Hz
    odom -> base_footprint  ekf_filter_node   wheels, imu   publish_tf     30.1 Hz   ! a second owner
    base_link -> tool0      nobody                                                   ! nobody

An owner is a node, a source of data and a switch.  None is a hole in the tree, two are
two truths by turns.  The field calls it the authority of a transform.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

from . import style
from .picture import Picture

__all__ = ["Owner", "describe_owners", "draw_owners"]

ROW_PX, HEAD_PX, BORDER_PX = 30, 44, 16
COLUMNS = (("edge", 0.0), ("owner", 0.29), ("source", 0.50), ("switch", 0.67), ("rate", 0.83))


class Owner(NamedTuple):
    """Who says one edge.

    Attributes:
        edge: "parent -> child".
        node: who; "" if nobody does.
        source: of which data it is made.
        switch: what turns it off; "" if nothing does.
        rate: how often it comes, "20.2 Hz" or "static".
    """

    edge: str
    node: str
    source: str = ""
    switch: str = ""
    rate: str = ""


def describe_owners(owners: Sequence[Owner]) -> str:
    """Return the table in words: a line for each owner, and what is wrong with it."""
    rows = [[*_cells(owner), _fault(owner, owners)] for owner in owners]
    widths = [max(len(row[column]) for row in rows) for column in range(6)]
    return "\n".join(
        "  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows
    )


def draw_owners(owners: Sequence[Owner | tuple[str, ...]]) -> Picture:
    """Draw the table of owners.

    Args:
        owners: a row for each that says an edge, and one without a node for an edge that nobody says.

    Raises:
        ValueError: there are no rows.
    """
    if not owners:
        raise ValueError(
            "a table of owners needs a row, such as ('map -> odom', 'amcl', 'scan', 'tf_broadcast', '10 Hz')"
        )
    owners = [Owner(*owner) for owner in owners]
    height_px = HEAD_PX + ROW_PX * len(owners) + BORDER_PX
    picture = Picture((style.WIDE[0], height_px / style.SCREEN_DPI))
    picture.text = describe_owners(owners)
    width_px = style.WIDE[0] * style.SCREEN_DPI
    with style.our_settings():
        ax = picture.figure.add_axes((BORDER_PX / width_px, 0.0, 1.0 - 2 * BORDER_PX / width_px, 1.0))
        ax.set_axis_off()
        ax.set_xlim(0.0, 1.0)
        ax.set_ylim(height_px, 0.0)
        for name, x in COLUMNS:
            ax.text(x, HEAD_PX / 2, name, va="center", color=style.GREY, fontsize=style.SMALL_PT)
        for number, owner in enumerate(owners):
            y, fault = HEAD_PX + (number + 0.5) * ROW_PX, _fault(owner, owners)
            ax.plot([0.0, 1.0], [y - ROW_PX / 2] * 2, color=style.HAIR, linewidth=0.8)
            colour = style.ACCENT if fault else style.INK
            for cell, (_, x) in zip(_cells(owner), COLUMNS, strict=True):
                ax.text(
                    x, y, cell, va="center", color=colour, weight="bold" if fault else "normal", fontsize=style.SMALL_PT
                )
            ax.text(1.0, y, fault, va="center", ha="right", color=style.ACCENT, weight="bold", fontsize=style.SMALL_PT)
    return picture


def _cells(owner: Owner) -> tuple[str, ...]:
    return (owner.edge, owner.node or "nobody", owner.source or "-", owner.switch or "-", owner.rate or "-")


def _fault(owner: Owner, owners: Sequence[Owner]) -> str:
    if not owner.node:
        return "! 0"
    count = Counter(other.edge for other in owners)[owner.edge]
    return f"! {count}" if count > 1 else ""
