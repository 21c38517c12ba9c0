"""Is a whole order the other way round, or does all of it stand one place off?  Seen from all places together.

    first, second, third     wanted  names, tree, mount
                             given   mount, tree, names      the other way round
                             given   wait, names, tree       one place too late: "wait" stands before it
                             given   tree, mount, names      one place too early
    and of more              given   rates, names, tree, mount      "rates" alone is out of its place

Place by place three answers are wrong; together it is one mistake.  So it is where
edges are asked for by the frame below, and each was named by the frame above.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import permutations
from typing import Any

from ...text import Text, Texts
from ..answers.form import Form
from ..answers.forms import Choice
from ..answers.values import Plain
from .confused import word_of
from .edges import parents_named
from .together import Found

__all__ = ["named_twice", "of_orders", "of_places"]

TEXTS = Texts(__file__)

FEWEST = 3  # places, for an order to be more than two words that are exchanged

Row = Sequence[Any]

ORDERS: dict[str, Callable[[Row, Row], bool]] = {
    "order reversed": lambda given, want: given == want[::-1],
    "one place too late": lambda given, want: given[1:] == want[:-1],
    "one place too early": lambda given, want: given[:-1] == want[1:],
}
MOST_PLACES = 5  # of a list: with more of them there are too many orders
ORDINALS = {"first", "second", "third", "fourth", "fifth", "sixth", "seventh", "last"}


def of_orders(
    forms: Mapping[str, Form],
    given: Mapping[str, Sequence[Plain]],
    wanted: Mapping[str, Sequence[Plain]],
    means: Mapping[str, Text] | None = None,
) -> list[Found]:
    """Return what is wrong with places that are filled from the same words, all of them together.

    Args:
        means: what is said of a word, by the word.
    """
    found = []
    for names in _asked_in_order(forms):
        if len(given[names[0]]) != 1:  # a function: its words are confused, and no places
            continue
        want = [word_of(forms[name], wanted[name][0]) for name in names]
        have = [word_of(forms[name], given[name][0]) for name in names]
        wrong = [name for name, one, other in zip(names, have, want, strict=True) if one != other]
        is_order = len(names) >= FEWEST and len(set(want)) == len(want) and ORDINALS.issuperset(names)
        order = _of_an_order(have, want, means or {}) if wrong and is_order else None
        if order is not None:
            found.append(Found.of(*order, *wrong))
        else:
            found += parents_named(forms, {name: given[name][0] for name in wrong}, dict(zip(names, want, strict=True)))
    return found


def _of_an_order(have: Row, want: Row, means: Mapping[str, Text]) -> tuple[str, Text] | None:
    """Return what is wrong with an order as a whole, and what to say; None if it is not one thing."""
    for name, fits in ORDERS.items():
        if fits(have, want):
            return name, TEXTS[name]
    moved = _out_of_place(have, want, means)
    return ("one out of place", moved) if moved else None


def _out_of_place(have: Row, want: Row, means: Mapping[str, Text]) -> Text | None:
    """Return which one word stands elsewhere than it should, by two places or more, while the others are in order."""
    if sorted(map(str, have)) != sorted(map(str, want)):
        return None
    for at, word in enumerate(have):
        place = want.index(word)
        others = ([one for one in row if one != word] for row in (have, want))
        if abs(place - at) > 1 and next(others) == next(others):
            return Text.joined(
                TEXTS["comes_earlier" if place < at else "comes_later"].filled(word=word), means.get(word)
            )
    return None


def of_places(
    forms: Mapping[str, Form], given: Mapping[str, Sequence[Plain]], wanted: Mapping[str, Sequence[Plain]]
) -> list[Found]:
    """Return that each of several lists is right once its members are put in one other order, the same for all."""
    rows = _lists_of_words(forms, given)
    if len(rows) < FEWEST or len({len(row) for row in rows}) > 1 or len(rows[0]) > MOST_PLACES:
        return []
    want, have = ([[word_of(forms[name], held[name][0]) for name in row] for row in rows] for held in (wanted, given))
    order = _order_of(want, have)
    wrong = [row[place] for row in rows for place, at in enumerate(order) if place != at]
    return [Found.of("places exchanged", TEXTS["places"], *wrong)] if wrong else []


def _order_of(want: list[Row], have: list[Row]) -> tuple[int, ...]:
    """Return in which order the members of each list were put, the first way that fits all; nothing if none does."""
    orders = permutations(range(len(want[0])))  # as it is comes first
    return next((order for order in orders if [[row[place] for place in order] for row in want] == have), ())


def _lists_of_words(forms: Mapping[str, Form], given: Mapping[str, Sequence[Plain]]) -> list[list[str]]:
    """Return the names of the members of each list of choices that a value holds."""
    lists: dict[str, list[str]] = {}
    for name in forms:
        if "[" in name and isinstance(forms[name], Choice) and len(given[name]) == 1:
            lists.setdefault(name.partition("[")[0], []).append(name)
    return list(lists.values())


def named_twice(
    forms: Mapping[str, Form], given: Mapping[str, Sequence[Plain]], wanted: Mapping[str, Sequence[Plain]], name: str
) -> Text | None:
    """Return that a part's word stands in other places, too, where each place has a word of its own; None if not."""
    form = forms[name]
    names = next((names for names in _asked_in_order(forms) if name in names), [])
    if not isinstance(form, Choice) or len(names) < FEWEST or not ORDINALS.issuperset(names):
        return None  # where no order is asked for, a word may come twice
    want, have = ([word_of(form, held[one][0]) for one in names] for held in (wanted, given))
    word = word_of(form, given[name][0])
    if word is None or len(set(want)) < len(want) or have.count(word) < 2:
        return None
    return TEXTS["named_twice"].filled(word=word, count=have.count(word))


def _asked_in_order(forms: Mapping[str, Form]) -> Iterator[list[str]]:
    """Yield the names of the parts that are choices between the same words."""
    alike: dict[tuple[str, ...], list[str]] = {}
    for name, form in forms.items():
        if isinstance(form, Choice) and form.options:
            alike.setdefault(form.options, []).append(name)
    yield from alike.values()
