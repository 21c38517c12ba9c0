"""E11.5: What does the Fixed Frame change?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

RIGHT = {
    "screen": "changes",
    "pose in odom": "stays",
    "ranges": "stays",
    "errors": "changes",
    "localiser": "stays",
    "planner": "stays",
}

TASK = define_task(
    __file__, kind="M", points=2, answer="changes", form=Parts({part: Choice(("changes", "stays")) for part in RIGHT})
)
