"""What is an explanation?  Slips by name, what to say of them, and what only follows from them.

    Explanation({"late": ..., "far": ...}, Text("Two things together give ..."), follows=("ahead_m",))

Slips that were made together are told as what gives this answer, for another mistake may come to the same numbers;
what was seen of itself, as in `and_then`, is told as it is.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from ...text import Text, Texts, begun
from ..answers.values import Plain
from ..mistakes.fitting import words_of
from ..tasks.case_types import Case, Feedback, TaskCases

__all__ = ["Explains", "Explanation", "and_then", "said_of"]

TEXTS = Texts(__file__)


class Explanation(NamedTuple):
    """How an answer came about.

    Attributes:
        slips: by name, the first in the work first, and what is said of each.
        said: what to say of them.
        follows: parts that are wrong only because of an earlier one.
        shows: the number of the call in which it is plain to see; None: the first that goes wrong.
    """

    slips: dict[str, Feedback]
    said: Text
    follows: tuple[str, ...] = ()
    shows: int | None = None

    @classmethod
    def of(cls, name: str, said: Text) -> Explanation:
        """Return that of one mistake which no task has to know."""
        return cls({name: Feedback(said, "")}, said)


Explains = Callable[[TaskCases, Sequence[Case], Sequence[Plain]], Explanation | None]


def and_then(first: Explanation, then: Explanation) -> Explanation:
    """Return both as one: what comes first, and what is wrong besides."""
    said = (
        TEXTS["and_then"].filled(first=first.said, then=then.said)
        if len(first.slips) == 1
        else _in_a_row(first.said, then.said)
    )
    return Explanation(first.slips | then.slips, said, first.follows)


def said_of(task: TaskCases, names: Sequence[str]) -> Text:
    """Return what to say of one slip, or of two or three in the order of the work."""
    said = [words_of(task, name).reply for name in names]
    if len(said) == 1:
        return said[0]
    if len(said) == 2:
        return TEXTS["two_together"].filled(first=said[0], then=said[1])
    return TEXTS["three_together"].filled(first=said[0], then=said[1], last=said[2])


def _in_a_row(first: Text, then: Text) -> Text:
    return Text(f"{first.en} {begun(then.en)}", f"{first.ko} {then.ko}")
