"""E0.1: Fifteen questions, before: form A of the test. Its items are in solutions/inventory.yaml."""

from __future__ import annotations

from tflab.workbook.inventory.replies import FORM
from tflab.workbook.tasks import PARTICIPATION, define_task

TASK = define_task(__file__, kind="M", points=1, answer="before", form=FORM, counts=PARTICIPATION)
