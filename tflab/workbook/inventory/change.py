"""What came of it between the two forms?  For each item cured, held, stuck or lost.

                 after right    after wrong
    before wrong    cured          stuck
    before right    held           lost

A learner is told no number but these: fifteen items are too few to measure one
person.  What they were sure of and had wrong, and have right now, stands first: that is
what was really learnt.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from tflab.views.slope_chart import state_of

from .items import Item
from .replies import Reply, replies_to

__all__ = ["ItemChange", "changes", "relearnt"]


class ItemChange(NamedTuple):
    """One item, and what somebody said to it in form A and in form B."""

    number: int
    item: Item
    before: Reply
    after: Reply

    @property
    def state(self) -> str:
        """Return "cured", "held", "stuck" or "lost"."""
        return state_of(self.before.kind, self.after.kind)


def changes(items: Sequence[Item], before: Mapping[str, str], after: Mapping[str, str]) -> list[ItemChange]:
    """Return what came of each item."""
    rows = zip(items, replies_to(items, "A", before), replies_to(items, "B", after), strict=True)
    return [ItemChange(number, *row) for number, row in enumerate(rows, start=1)]


def relearnt(all_of_them: Sequence[ItemChange]) -> list[ItemChange]:
    """Return the items that somebody was sure of and had wrong before, and has right now."""
    return [change for change in all_of_them if change.before.kind == "wrong" and change.after.is_right]
