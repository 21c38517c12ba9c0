"""E1.2: Which message can be used?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

OPTIONS = ("usable", "no frame", "no stamp", "label contradicts numbers")
RIGHT = {
    "a": "usable",
    "b": "no frame",
    "c": "no stamp",
    "d": "usable",
    "e": "label contradicts numbers",
    "f": "usable",
}

TASK = define_task(
    __file__, kind="M", points=3, answer="verdicts", form=Parts({name: Choice(OPTIONS) for name in RIGHT})
)
