"""What is a part, once a slip is known in another?  It follows from it, or has a mistake of its own on top.

    "stamp_s"   38.2      a slip of the task
    "speed"     0.54      what that slip gives here, too: it only follows
    "yaw_rate"  17.4      what it gives here, in degrees: a second mistake, and it is named

Read `members.py` next.
"""

from __future__ import annotations

from collections.abc import Sequence

from ..answers.form import Form
from ..answers.values import Plain
from ..mistakes.fitting import MEASURED, is_just, undone_to, words_of
from ..tasks.case import TaskCases
from ..words import Words
from .together import Found

__all__ = ["ONLY_FOLLOWS", "after_a_slip"]

ONLY_FOLLOWS = Words(
    en='this only follows from what is wrong in "{part}".',
    ko='"{part}"이(가) 틀렸기 때문에 함께 틀린 값입니다.',
)


def after_a_slip(
    task: TaskCases, name: str, form: Form, outcomes: Sequence[Plain], made_in: str, row: Sequence[Plain]
) -> list[Found]:
    """Return what a part is beside a slip that another part shows; nothing if it is none of it.

    Args:
        name: of the part, and its `form` and `outcomes`.
        made_in: the part in which the slip was made.
        row: what the slip gives in this part, case by case.
    """
    if not isinstance(form, MEASURED) or any(value is None for value in row):
        return []
    if is_just(form, outcomes, row):
        follows = Found.of(f"{name} follows", ONLY_FOLLOWS.filled(part=made_in), name)
        return [follows._replace(is_of_words=True)]  # a cause comes first
    way = next(undone_to(form, outcomes, row, only_plain_to_see=True), None)
    return [Found({way: words_of(task, way)}, words_of(task, way).reply, {name})] if way else []
