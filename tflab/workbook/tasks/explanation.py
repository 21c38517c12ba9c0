"""What is an explanation?  Slips by name, what to say of them, and what only follows from them.

    Explanation({"late": ..., "far": ...}, Words("Two things. First: ... Then: ..."), follows=("ahead_m",))

Read `confused.py` next.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from ..words import Words
from .case import TaskCases, TwinWords
from .fitting import words_of

__all__ = ["Explanation", "said_of"]

AND_THEN = Words(en="Two things. First: {first} Then: {then}", ko="두 가지입니다. 먼저, {first} 다음으로, {then}")


class Explanation(NamedTuple):
    """How an answer came about.

    Attributes:
        slips: by name, the first in the work first, and what is said of each.
        said: what to say of them.
        follows: parts that are wrong only because of an earlier one.
    """

    slips: dict[str, TwinWords]
    said: Words
    follows: tuple[str, ...] = ()


def said_of(task: TaskCases, names: Sequence[str]) -> Words:
    """Return what to say of one slip, or of two in the order of the work."""
    said = [words_of(task, name).reply for name in names]
    if len(said) == 1:
        return said[0]
    first, then = said
    return Words(AND_THEN.say("en", first=first.en, then=then.en), AND_THEN.say("ko", first=first.ko, then=then.ko))
