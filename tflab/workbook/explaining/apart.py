"""Which slips made these words wrong, each in words of its own?  Where together they look like no slip at all.

    nodes in a file      a     b     c        d
    asked for            sim   wall  refused  wall
    said                 sim   sim   sim      wall       b: text read as true; c: unset is sim

The members of lists of words are looked at one by one.  Where as few slips give them all
in several ways, nobody knows which it was: what all the ways have in common is told.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from ...text import Text, Texts
from ..answers.form import inside
from ..answers.forms import Choice
from ..answers.forms import Sequence as ListForm
from ..answers.values import Plain, is_raised
from ..mistakes.fitting import words_of
from ..tasks.case_types import Case, TaskCases
from .beside import side_by_side
from .explanation import Explanation, said_of

__all__ = ["of_words_apart"]

TEXTS = Texts(__file__)


class _Word(NamedTuple):
    """One word: what was said, what is asked for, and what each mistake gives."""

    said: Plain
    wanted: Plain
    wrong: dict[str, Plain]


def of_words_apart(task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain]) -> Explanation | None:
    """Return which slips give the words in a function's lists; None if no few of them do."""
    places = _places(cases, outcomes) if isinstance(task.form, ListForm) else []
    if not places or not isinstance(task.form.of, Choice):
        return None
    sure, is_all = _sure(task.form.of, places)
    if not sure:
        return None
    told, slips = said_of(task, sure), {name: words_of(task, name) for name in sure}
    return Explanation(slips, told if is_all else Text.joined(told, TEXTS["and_more"]))


def _sure(form: Choice, places: Sequence[_Word]) -> tuple[list[str], bool]:
    """Return the slips that all the simplest explanations have in common, and whether there is but one."""
    gives = {name: [place.wrong[name] for place in places] for name in places[0].wrong}
    found = list(side_by_side(form, [place.said for place in places], [place.wanted for place in places], gives))
    ways = [way for way in found if len(way) == len(found[0])]
    return [name for name in (ways or [()])[0] if all(name in way for way in ways)], len(ways) == 1


def _places(cases: Sequence[Case], outcomes: Sequence[Plain]) -> list[_Word]:
    """Return each word on its own; nothing if lists differ in length, or something is no answer."""
    if any(is_raised(case.expected) for case in cases):
        return []
    found = []
    for case, outcome in zip(cases, outcomes, strict=True):
        said, wanted = inside(outcome), inside(case.expected)
        wrong = {name: inside(answer) for name, answer in case.wrong.items()}
        if not all(isinstance(held, list) and len(held) == len(wanted) for held in (said, *wrong.values())):
            return []
        found += [_Word(said[place], wanted[place], {name: answer[place] for name, answer in wrong.items()})
                  for place in range(len(wanted))]  # fmt: skip
    return found
