"""Every task of the chapters there are, for tests that are run with each."""

import pytest

from tflab.workbook.places import workbook_data
from tflab.workbook.tasks.task import read_tasks

SOLUTIONS = workbook_data() / "solutions"
STEMS = sorted(path.name for path in (SOLUTIONS / "tasks").glob("[0-9]*"))
TASKS = [(stem, task) for stem in STEMS for task in read_tasks(SOLUTIONS / "tasks" / stem)]
each_task = pytest.mark.parametrize(("stem", "task"), TASKS, ids=[task.id for _, task in TASKS])
