"""E3.8: Rotation, translation, both or neither."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

APPLIES = ("both", "rotation", "neither")

VALUES = ("corner", "velocity", "gravity", "position", "orientation", "distance")

TASK = define_task(
    __file__,
    kind="M",
    points=3,
    answer="applies",
    form=Parts({value: Choice(APPLIES) for value in VALUES}),
)
