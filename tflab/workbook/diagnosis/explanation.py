"""Hold what explains an answer, and merge what explains its parts."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from ...text import Text, Texts, capitalized
from ..tasks.case_types import Feedback, TaskCases
from .matching import feedback_of

__all__ = ["Explanation", "PartFound", "combine_explanations", "describe", "merge_found", "without_overlaps"]

TEXTS = Texts(__file__)


class Explanation(NamedTuple):
    """How an answer came about.

    Attributes:
        mistakes: by name, the first in the work first, and what is said of each.
        said: what to say of them.
        follows: parts that are wrong only because of an earlier one.
        shows: the number of the call in which it is plain to see; None: the first that goes wrong.
        asked: of an answer in parts, who was asked: the part or "" for several, the row's name, whether it explained.
    """

    mistakes: dict[str, Feedback]
    said: Text
    follows: tuple[str, ...] = ()
    shows: int | None = None
    asked: tuple[tuple[str, str, bool], ...] = ()

    @classmethod
    def of(cls, name: str, said: Text) -> Explanation:
        """Return that of one mistake which no task has to know."""
        return cls({name: Feedback(said, "")}, said)


def combine_explanations(first: Explanation, then: Explanation) -> Explanation:
    """Return both as one: what comes first, and what is wrong besides."""
    besides = TEXTS["sign_too"] if set(then.mistakes) == {"sign"} else then.said  # the size is not right any more
    said = (
        TEXTS["and_then"].filled(first=first.said, then=besides)
        if len(first.mistakes) == 1
        else _in_a_row(first.said, besides)
    )
    return Explanation(first.mistakes | then.mistakes, said, first.follows, asked=first.asked)


def describe(task: TaskCases, names: Sequence[str]) -> Text:
    """Return what to say of one mistake, or of two or three in the order of the work."""
    said = [feedback_of(task, name).reply for name in names]
    if len(said) == 1:
        return said[0]
    said[1:] = [TEXTS["sign_too"] if name == "sign" else words for name, words in zip(names[1:], said[1:], strict=True)]
    if len(said) == 2:
        return TEXTS["two_together"].filled(first=said[0], then=said[1])
    return TEXTS["three_together"].filled(first=said[0], then=said[1], last=said[2])


def _in_a_row(first: Text, then: Text) -> Text:
    return Text(f"{first.en} {capitalized(then.en)}", f"{first.ko} {then.ko}")


MOST_TOLD = 4  # causes; who reads more than that at once corrects none


class PartFound(NamedTuple):
    """What explains some parts: the mistakes by name, what to say, whether the rest of it shows, and whether it is only
    a fact about words.
    """

    mistakes: dict[str, Feedback]
    said: Text
    parts: set[str]
    is_whole: bool = False
    is_of_words: bool = False

    @classmethod
    def of(cls, name: str, said: Text, *parts: str) -> PartFound:
        """Return that of one mistake which no task has to know."""
        return cls({name: Feedback(said, "")}, said, set(parts))


def without_overlaps(causes: Sequence[PartFound], wrong: set[str]) -> list[PartFound]:
    """Return the causes that explain parts which none before them explains."""
    left, found = set(wrong), []
    for cause in causes:
        if cause.parts <= left:
            found.append(cause)
            left -= cause.parts
    return found


def merge_found(found: Sequence[PartFound], left: Mapping[str, Text | None], names: Sequence[str]) -> Explanation:
    """Return one explanation of what was found in several parts.

    Args:
        left: the parts that nothing explains, and what is certain of each.
        names: of all parts, in the order of the work.
    """
    found = sorted(_merged(found), key=lambda cause: (cause.is_of_words, min(map(names.index, cause.parts))))
    told = found[:MOST_TOLD] if len(found) > MOST_TOLD + 1 else found
    said = [cause.said if cause.parts == set(names) else _where(cause.said, cause.parts, names) for cause in told]
    if rest := {name for cause in found[len(told) :] for name in cause.parts}:
        said.append(_where(TEXTS["later"], rest, names))
    said += [_where(words, parts, names) for words, parts in _looks(left).items()]
    mistakes = {name: words for cause in found for name, words in cause.mistakes.items()}
    follows = set() if left else {name for cause in found for name in _follows(cause)}
    return Explanation(mistakes, Text.joined(*said), tuple(sorted(follows)))


def _looks(left: Mapping[str, Text | None]) -> dict[Text, set[str]]:
    """Return what to say of the parts that are left, and of which."""
    looks: dict[Text, set[str]] = {}
    for name, certain in left.items():
        looks.setdefault(TEXTS["wrong_and_how"].filled(certain=certain) if certain else TEXTS["wrong"], set()).add(name)
    return looks


def _merged(found: Sequence[PartFound]) -> list[PartFound]:
    """Return what was found with each reply once, for all parts that it is given to."""
    merged: dict[Text, PartFound] = {}
    for cause in found:
        held = merged.get(cause.said)
        both = (
            cause
            if held is None
            else held._replace(mistakes=held.mistakes | cause.mistakes, parts=held.parts | cause.parts)
        )
        merged[cause.said] = both
    return list(merged.values())


def _follows(found: PartFound) -> set[str]:
    """Return the parts that are wrong only because of a mistake in another part."""
    made_in = {words.part for words in found.mistakes.values()}
    is_placed = "" not in made_in  # a mistake of no certain part is made in each of them
    return found.parts - made_in if found.is_whole and is_placed and made_in & found.parts else set()


def _where(words: Text, parts: set[str], names: Sequence[str]) -> Text:
    """Say in which parts it is; a list by its name where it is in all of its members."""
    lists = {name.partition("[")[0] for name in names}
    whole = {name for name in lists if {held for held in names if held.partition("[")[0] == name} <= parts}
    called = [name.partition("[")[0] if name.partition("[")[0] in whole else name for name in names if name in parts]
    called = list(dict.fromkeys(called))
    where = ", ".join(f'"{name}"' for name in called)
    said = [_without_its_name(text, called[0]) if len(called) == 1 else text for text in (words.en, words.ko)]
    return Text(*(f"{where}: {text}" for text in said))


def _without_its_name(text: str, name: str) -> str:
    """Return what is said of one part without its name, which stands before all of it."""
    first, *others = re.split(rf"(?<=[.?!] ){re.escape(name)}: ", text.removeprefix(f"{name}: "))
    return first + "".join(map(capitalized, others))
