"""E12.8: Fifteen questions, after; form B of the test, whose items stand in solutions/inventory.yaml."""

from __future__ import annotations

from tflab.workbook.inventory.replies import FORM
from tflab.workbook.tasks import PARTICIPATION, Task, Text

TASK = Task(
    id="E12.8",
    kind="M",
    points=1,
    title=Text(en="Fifteen questions, after", ko="열다섯 문제, 끝"),
    answer="after",
    form=FORM,
    hints=(),
    counts=PARTICIPATION,
)
