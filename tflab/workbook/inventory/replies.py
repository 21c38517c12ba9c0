"""Which options did somebody choose, and how sure were they?  Letters, and a "?" where they guessed.

    {"1": "b", "2": "c?", "3": "e"}     1: b, sure     2: c, guessed     3: does not know

Sure and wrong is a misconception; guessed and wrong is only a gap.  Capitals and
spaces say nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from ..answers.forms import Choice, Form, Parts
from ..answers.values import Plain
from .items import LETTERS, Item

__all__ = ["FORM", "Reply", "chosen", "replies_to"]

FORM = Parts({str(number): Choice(("a", "b", "c", "d", "e", "a?", "b?", "c?", "d?", "e?")) for number in range(1, 16)})


class Reply(NamedTuple):
    """What somebody said to one question: a letter, whether it is right, what it shows, whether they were sure."""

    letter: str
    is_right: bool
    shows: str
    is_sure: bool

    @property
    def kind(self) -> str:
        """Return "right", "guessed right", "gap" or "wrong": what is only guessed, or not known, is a gap."""
        if self.is_right:
            return "right" if self.is_sure else "guessed right"
        return "wrong" if self.is_sure else "gap"


def chosen(form: Form, outcome: Plain) -> dict[str, str]:
    """Return the option of each part, as the form writes it; {} if a part has none."""
    rows = form.read(outcome) if isinstance(form, Parts) else None
    if not rows or not all(rows):
        return {}
    return {name: str(row[0][0].value) for name, row in zip(form.parts, rows, strict=True)}


def replies_to(items: Sequence[Item], form: str, answers: Mapping[str, str]) -> list[Reply]:
    """Return what somebody said to each item of a form; what is missing or strange is not known."""
    return [_reply(item, form, answers.get(str(number), "")) for number, item in enumerate(items, start=1)]


def _reply(item: Item, form: str, answer: str) -> Reply:
    letter = answer[:1] if answer[:1] in tuple(LETTERS) else ""
    is_sure = bool(letter) and not answer.endswith("?")
    return Reply(letter, bool(letter) and letter == item.forms[form].right, item.shown_by(form, letter), is_sure)
