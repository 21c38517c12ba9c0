"""E12.6: The wall that smears."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

PLACES = ("first", "second", "third", "fourth", "fifth", "sixth")
ORDER = ("header", "rates", "publishers", "mount", "tree", "fixed frame")
CARDS = Choice((*ORDER, "new sensor", "longer timeout"))

TASK = define_task(__file__, kind="D", points=3, answer="steps", form=Parts(dict.fromkeys(PLACES, CARDS)))
