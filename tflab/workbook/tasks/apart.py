"""Which slips made these words wrong, each in words of its own?  Where together they look like no slip at all.

    nodes in a file      a     b     c        d
    asked for            sim   wall  refused  wall
    said                 sim   sim   sim      wall       b: text read as true; c: unset is sim

The members of lists of words are looked at one by one.  Where no few slips give them all,
the one is told that gives most, if it gives just what was said wherever it shows.
Read `stops.py` next.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from ..answers import sealed
from ..answers.form import inside
from ..answers.forms import Choice
from ..answers.forms import Sequence as ListForm
from ..answers.values import Plain, is_raised
from ..words import Words
from .beside import side_by_side
from .case import AND, Case, TaskCases
from .explanation import Explanation, said_of
from .fitting import words_of

__all__ = ["of_words_apart"]

FEWEST = 2  # places in which a slip has to show, if it does not explain all
SHARE = 0.4  # of what is wrong, at least
MOST = 3  # slips that are told at once
SO_FAR = Words(
    en="{said} That explains {some} of the {all} words that are wrong; then look at the others.",
    ko="{said} 틀린 낱말 {all}개 가운데 {some}개가 이 때문입니다. 그다음에 나머지를 보십시오.",
)


AND_MORE = Words(en="Something else is wrong beside it.", ko="그 밖에도 틀린 것이 있습니다.")


class _Place(NamedTuple):
    """One word: what was said, what is asked for, and what each mistake gives."""

    said: Plain
    wanted: Plain
    twins: dict[str, Plain]


def of_words_apart(task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain]) -> Explanation | None:
    """Return which slips give the words of a function, all of them or most; None if none does."""
    form = task.form.of if isinstance(task.form, ListForm) else task.form
    places = _places(task.form, cases, outcomes)
    if not isinstance(form, Choice) or not places:
        return None
    said, wanted = [place.said for place in places], [place.wanted for place in places]
    gives = {name: [place.twins[name] for place in places] for name in places[0].twins}
    if isinstance(task.form, ListForm):  # of single words, some fit any three slips by chance
        ways = list(side_by_side(form, said, wanted, gives))
        ways = [way for way in ways if len(way) == len(ways[0])]  # of several, what all have in common is sure
        sure = [name for name in ways[0] if all(name in way for way in ways)] if ways else []
        if sure:
            slips = {name: words_of(task, name) for name in sure}
            told = said_of(task, sure)
            return Explanation(
                slips, told if len(ways) == 1 else Words(*map(" ".join, zip(told, AND_MORE, strict=True)))
            )
    return _of_most(task, form, places, {name: row for name, row in gives.items() if AND not in name})


def _of_most(
    task: TaskCases, form: Choice, places: Sequence[_Place], gives: dict[str, list[Plain]]
) -> Explanation | None:
    """Return the slip that gives most of what is wrong, and what was said in every place in which it shows."""
    wrong = {number for number, place in enumerate(places) if not form.alike(place.said, place.wanted)}
    explained = {}
    for name, row in gives.items():
        shows = {number for number, place in enumerate(places) if not form.alike(row[number], place.wanted)}
        if len(shows) >= FEWEST and shows <= wrong and all(form.alike(places[n].said, row[n]) for n in shows):
            explained[name] = shows
    if not explained:
        return None
    best, *others = sorted(explained, key=lambda name: -len(explained[name]))
    if len(explained[best]) < SHARE * len(wrong) or (others and explained[others[0]] & explained[best]):
        return None  # little is explained by it, or as well by another
    words = words_of(task, best)
    counts = {"some": len(explained[best]), "all": len(wrong)}
    said = Words(*(SO_FAR.say(tongue, said=words.reply.say(tongue), **counts) for tongue in ("en", "ko")))
    return Explanation({best: words}, said)


def _places(form: Choice | ListForm, cases: Sequence[Case], outcomes: Sequence[Plain]) -> list[_Place]:
    """Return each word on its own; nothing if lists differ in length, or something is no answer or sealed."""
    if any(sealed.is_sealed(case.expected) or is_raised(case.expected) for case in cases):
        return []
    if isinstance(form, Choice):
        return [_Place(outcome, case.expected, case.twins) for case, outcome in zip(cases, outcomes, strict=True)]
    found = []
    for case, outcome in zip(cases, outcomes, strict=True):
        said, wanted = inside(outcome), inside(case.expected)
        twins = {name: inside(twin) for name, twin in case.twins.items()}
        if not all(isinstance(held, list) and len(held) == len(wanted) for held in (said, *twins.values())):
            return []
        found += [_Place(said[place], wanted[place], {name: twin[place] for name, twin in twins.items()})
                  for place in range(len(wanted))]  # fmt: skip
    return found
