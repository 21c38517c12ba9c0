"""E3.7: Three nodes, one swap."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

NODES = ("node_a", "node_b", "node_c")

ROBOTS = (
    "stops for the wrong things",
    "is drawn where it is not",
    "stops with an exception",
    "drives to another place",
)

HIDDEN = ("it stands on the map's origin, not turned", "it stands still", "the goal is far away")

TASK = define_task(
    __file__,
    kind="D",
    points=3,
    answer="verdict",
    form=Parts({"node": Choice(NODES), "robot": Choice(ROBOTS), "hidden_while": Choice(HIDDEN)}),
)
