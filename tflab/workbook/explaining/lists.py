"""What is wrong with the members of a list?  Each is looked at as an answer of its own, all of them together.

    asked for  [message, message]  [message]      given  [message, message]  [message]
               -> three messages, three answers: "header.stamp": the stamp is still zero

Where a list is too long or too short, nobody knows which member stands for which, and
`certain.py` says how far the two agree.
"""

from __future__ import annotations

from collections.abc import Sequence

from ..answers.form import inside
from ..answers.forms import Message
from ..answers.forms import Sequence as ListForm
from ..answers.values import Plain, is_raised
from ..tasks.case_types import Case, TaskCases
from .explanation import Explanation
from .members import of_members

__all__ = ["of_lists"]


def of_lists(task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain]) -> Explanation | None:
    """Return what all members of lists of messages have wrong; None if nothing explains it."""
    form = task.form
    if not isinstance(form, ListForm) or not isinstance(form.of, Message):
        return None
    wanted = [None if is_raised(case.expected) else inside(case.expected) for case in cases]
    given = [inside(outcome) for outcome in outcomes]
    for members in (*wanted, *given):
        if not isinstance(members, list):
            return None
    if list(map(len, wanted)) != list(map(len, given)):
        return None
    flat = [Case([], member, {}) for members in wanted for member in members]
    answers = [member for members in given for member in members]
    if not flat:
        return None
    return of_members(task._replace(form=form.of, feedback={}), flat, answers, None)
