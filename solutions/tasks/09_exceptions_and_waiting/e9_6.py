"""E9.6: Where may I wait?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

OUTCOMES = ("works", "waits in vain", "waits for ever")

TASK = define_task(
    __file__, kind="M", points=2, answer="outcomes", form=Parts({name: Choice(OUTCOMES) for name in "abcdefgh"})
)
