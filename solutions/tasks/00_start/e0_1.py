"""E0.1: Fifteen questions, before; form A of the test, whose items stand in solutions/inventory.yaml."""

from __future__ import annotations

from tflab.workbook.inventory.replies import FORM
from tflab.workbook.tasks import PARTICIPATION, Task, Text

TASK = Task(
    id="E0.1",
    kind="M",
    points=1,
    title=Text(en="Fifteen questions, before", ko="열다섯 문제, 처음"),
    answer="before",
    form=FORM,
    hints=(),
    counts=PARTICIPATION,
)
