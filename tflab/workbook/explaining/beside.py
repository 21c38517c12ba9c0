"""Which slips stand beside each other in a function?  Two that do not compose, or three: told from where each shows.

    asked   "", odom   red/, odom   red, map   red/, map
    given   /odom      red//odom    red/map    red//map      slash after nothing: shows alone in the first call,
                                                             slashes kept: in the second, map prefixed: in the third

Of three, only what each two give together was computed: each call has to be what some
two of them give, and each of them has to show alone somewhere.  Read `apart.py` next.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from functools import partial
from itertools import combinations

from ..answers.form import Form
from ..answers.values import Plain
from ..mistakes.fitting import alike, gives_what_is_right, is_just
from ..tasks.case import AND

__all__ = ["side_by_side"]

MOST = 3  # that are looked for


def side_by_side(
    form: Form, outcomes: Sequence[Plain], expected: Sequence[Plain], gives: dict[str, list[Plain]]
) -> Iterator[tuple[str, ...]]:
    """Yield two or three slips of which each shows alone in some call, and that give together what came out.

    Args:
        gives: what each slip gives, call by call, and each two together.
    """
    wrong = _calls(not alike(form, *pair) for pair in zip(outcomes, expected, strict=True))
    shown = partial(_shown, form.comparing(), expected)
    shows = {name: shown(row) for name, row in gives.items() if AND not in name}
    within = [name for name, seen in shows.items() if seen and not seen & ~wrong]
    pairs = {two: _in_either_order(gives, *two) for two in combinations(within, 2)}
    shows |= {name: shown(gives[name]) for names in pairs.values() for name in names}
    for chosen in (slips for count in range(2, MOST + 1) for slips in combinations(within, count)):
        ways = _ways(pairs, chosen)
        if _covers(shows, chosen, ways, wrong) and _fit(form, outcomes, gives, shows, ways):
            yield chosen


def _in_either_order(gives: Collection[str], one: str, other: str) -> list[str]:
    return [name for name in (one + AND + other, other + AND + one) if name in gives]


def _ways(pairs: dict[tuple[str, str], list[str]], chosen: tuple[str, ...]) -> list[str]:
    """Return what was computed of these slips: each two together, and those alone that are in no pair."""
    together = {two: pairs[two] for two in combinations(chosen, 2) if pairs[two]}
    paired = {name for two in together for name in two}
    return [way for ways in together.values() for way in ways] + [name for name in chosen if name not in paired]


def _calls(marks: Iterator[bool]) -> int:
    """Return the calls that are marked, as the bits of a number."""
    return sum(1 << number for number, mark in enumerate(marks) if mark)


def _shown(is_alike: Callable[[Plain, Plain], bool], expected: Sequence[Plain], row: Sequence[Plain]) -> int:
    """Return the calls in which what a slip gives is not what is right."""
    return _calls(not gives_what_is_right(is_alike, *pair) for pair in zip(row, expected, strict=True))


def _covers(shows: dict[str, int], chosen: tuple[str, ...], ways: Sequence[str], wrong: int) -> bool:
    """Return whether the slips show in just the calls that are wrong, and each alone in one of them."""
    seen = once = together = 0
    for way in ways:
        together |= shows[way]
    for name in chosen:
        once = (once & ~shows[name]) | (shows[name] & ~seen)
        seen |= shows[name]
    return together == wrong and all(shows[name] & once for name in chosen)


def _fit(
    form: Form, outcomes: Sequence[Plain], gives: dict[str, list[Plain]], shows: dict[str, int], ways: Sequence[str]
) -> bool:
    """Return whether each call that is wrong gives what one of the ways gives that show in it."""
    for number, outcome in enumerate(outcomes):
        seen = [way for way in ways if shows[way] >> number & 1]
        if seen and not any(is_just(form, [outcome], [gives[way][number]]) for way in seen):
            return False
    return True
