"""Find mistakes of which each shows in some calls of a function: two or three at the same step of the work.

    asked   "", odom   red/, odom   red, map   red/, map
    given   /odom      red//odom    red/map    red//map      slash after nothing: shows alone in the first call,
                                                             slashes kept: in the second, map prefixed: in the third

Each wrong call has to be what one of them gives, and each has to show alone in some call.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import combinations

from ..answers.form import Form
from ..answers.values import Plain
from ..mistakes.fitting import alike, is_just

__all__ = ["side_by_side"]

MOST = 3  # that are looked for


def side_by_side(
    form: Form, outcomes: Sequence[Plain], expected: Sequence[Plain], gives: dict[str, list[Plain]]
) -> Iterator[tuple[str, ...]]:
    """Yield two or three slips of which each shows alone in some call, and that give together what came out.

    Args:
        gives: what each slip gives, call by call.
    """
    wrong = _calls(not alike(form, *pair) for pair in zip(outcomes, expected, strict=True))
    shown = partial(_shown, form.comparing(), expected)
    shows = {name: shown(row) for name, row in gives.items()}
    within = [name for name, seen in shows.items() if seen and not seen & ~wrong]
    for chosen in (slips for count in range(2, MOST + 1) for slips in combinations(within, count)):
        if _covers(shows, chosen, wrong) and _fit(form, outcomes, gives, shows, chosen):
            yield chosen


def _calls(marks: Iterator[bool]) -> int:
    """Return the calls that are marked, as the bits of a number."""
    return sum(1 << number for number, mark in enumerate(marks) if mark)


def _shown(is_alike: Callable[[Plain, Plain], bool], expected: Sequence[Plain], row: Sequence[Plain]) -> int:
    """Return the calls in which what a slip gives is not what is right."""
    return _calls(not is_alike(*pair) for pair in zip(row, expected, strict=True))


def _covers(shows: dict[str, int], chosen: tuple[str, ...], wrong: int) -> bool:
    """Return whether the slips show in just the calls that are wrong, and each alone in one of them."""
    seen = once = 0
    for name in chosen:
        once = (once & ~shows[name]) | (shows[name] & ~seen)
        seen |= shows[name]
    return seen == wrong and all(shows[name] & once for name in chosen)


def _fit(
    form: Form, outcomes: Sequence[Plain], gives: dict[str, list[Plain]], shows: dict[str, int], chosen: Sequence[str]
) -> bool:
    """Return whether each call that is wrong gives what one of the slips gives that show in it."""
    for number, outcome in enumerate(outcomes):
        seen = [name for name in chosen if shows[name] >> number & 1]
        if seen and not any(is_just(form, [outcome], [gives[name][number]]) for name in seen):
            return False
    return True
