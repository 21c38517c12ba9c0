"""E12.6: The wall that smears."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

ORDER = ("fixed frame", "tree", "mount", "rates", "header", "publishers")
CARDS = (*ORDER, "new sensor", "longer timeout")
RIGHT = dict(zip(("first", "second", "third", "fourth", "fifth", "sixth"), ORDER, strict=True))

TASK = define_task(__file__, kind="D", points=3, answer="steps", form=Parts({place: Choice(CARDS) for place in RIGHT}))
