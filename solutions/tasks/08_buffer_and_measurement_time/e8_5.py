"""E8.5: Six symptoms."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

SYMPTOMS = ("a", "b", "c", "d", "e", "f")

CAUSES = (
    "stamp overwritten", "odometry slow", "static mount wrong", "two clocks", "cache too short", "import missing",
)  # fmt: skip

TASK = define_task(
    __file__, kind="D", points=3, answer="causes", form=Parts({symptom: Choice(CAUSES) for symptom in SYMPTOMS})
)
