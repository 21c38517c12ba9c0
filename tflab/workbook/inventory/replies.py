"""Read which options somebody chose and how sure they were, and compare the two forms.

    {"1": "b", "2": "c?", "3": "e"}     1: b, sure     2: c, guessed     3: does not know

A sure and wrong reply shows a misconception; a guessed wrong one is a gap.  Between the forms an item is

                 after right    after wrong
    before wrong    cured          stuck
    before right    held           lost
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from ..answers.forms import Choice, Form, Parts
from ..answers.values import Plain
from .items import LETTERS, Item

__all__ = ["FORM", "ItemChange", "Reply", "changes", "chosen", "fixed_items", "replies_to"]

STATES = {(False, True): "cured", (True, True): "held", (False, False): "stuck", (True, False): "lost"}
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


class ItemChange(NamedTuple):
    """One item, and what somebody said to it in form A and in form B."""

    number: int
    item: Item
    before: Reply
    after: Reply

    @property
    def state(self) -> str:
        """Return "cured", "held", "stuck" or "lost"."""
        return STATES[self.before.is_right, self.after.is_right]


def changes(items: Sequence[Item], before: Mapping[str, str], after: Mapping[str, str]) -> list[ItemChange]:
    """Return what came of each item."""
    rows = zip(items, replies_to(items, "A", before), replies_to(items, "B", after), strict=True)
    return [ItemChange(number, *row) for number, row in enumerate(rows, start=1)]


def fixed_items(all_of_them: Sequence[ItemChange]) -> list[ItemChange]:
    """Return the items that somebody was sure of and had wrong before, and has right now."""
    return [change for change in all_of_them if change.before.kind == "wrong" and change.after.is_right]
