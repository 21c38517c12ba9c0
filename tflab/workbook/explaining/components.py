"""Which number of a point was computed of what?  Where the others are right, and it differs from them in one thing.

    asked for   mount + seen     (m[0] + s[0], m[1] + s[1], m[2] + s[2])
    given       x, y right; z is     m[1] + s[2]       one index stands twice, or one term is missing, or has a minus

How the right answer is the sum of points that were given is found first; then one change
is tried in each number that is wrong.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import combinations, product
from typing import NamedTuple

from ...text import Text
from ..answers.form import Form, numbers_of, pose_of
from ..answers.forms import Vector
from ..answers.values import Plain
from ..mistakes.by_place import LETTERS
from .arithmetic import as_written, leaves

__all__ = ["of_components", "place_by_place", "put_together"]

MOST_POINTS = 6
CLOSE = 1e-6
RIGHT = Text(en="{names}: right", ko="{names}: 맞음")
PUT = Text(
    en="these are the numbers of `{name}`, put together as ({places}). {judged}",
    ko="`{name}`의 숫자를 ({places})로 늘어놓은 값입니다. {judged}",
)
ASKED = Text(
    en="Ask of each: does it stand where it belongs, and with which sign?",
    ko="하나씩 확인하십시오. 제자리에 있고 부호가 맞습니까?",
)
OTHER_SIGN = Text(en="{names}: the right number with the wrong sign", ko="{names}: 숫자는 맞고 부호가 반대")
TWICE = Text(
    en="{letter} stands twice: was a place written over before it was read, or a line copied?",
    ko="{letter}이(가) 두 번 나옵니다. 읽기 전에 덮어썼거나 줄을 복사하지 않았습니까?",
)
OTHER_NUMBER = Text(en="{names}: another of the numbers belongs there", ko="{names}: 다른 숫자가 올 자리")
GIVES = Text(en="{name}: this is what `{sum}` gives", ko="{name}: `{sum}`의 값입니다")


_Signed = tuple[float, str, tuple[float, ...]]  # how often a point counts, its name, its numbers


class _Term(NamedTuple):
    """One number in a sum: how often it counts, and the point and the place that it comes from."""

    factor: float
    name: str
    row: tuple[float, ...]
    place: int

    @property
    def value(self) -> float:
        return self.factor * self.row[self.place]

    @property
    def text(self) -> str:
        """The term as one writes it, without its sign."""
        often = "" if abs(self.factor) == 1.0 else f"{abs(self.factor):g} * "
        return f"{often}{self.name}[{self.place}]"


def of_components(
    form: Form, answer: Plain, expected: Plain, given: dict[str, Plain] | None
) -> tuple[str, Text] | None:
    """Return what the wrong numbers of a point were computed by, and what to say; None if not all are known."""
    both = _compared(form, answer, expected) if isinstance(form, Vector) and form.size <= len(LETTERS) else None
    if both is None:
        return None
    have, want, wrong = both
    way = _way(form, want, given or {}) if 0 < len(wrong) < form.size else None
    return _said_of(form, {place: _changed(way, place, have[place]) for place in wrong} if way else {})


def place_by_place(
    form: Vector, answer: Plain, expected: Plain, found: Callable[[float, int], str]
) -> tuple[str, Text] | None:
    """Return what `found` says of each wrong number of a point, and what to say; None if it says nothing of one."""
    both = _compared(form, answer, expected)
    if both is None:
        return None
    have, _, wrong = both
    return _said_of(form, {place: found(have[place], place) for place in wrong})


def _compared(
    form: Vector, answer: Plain, expected: Plain
) -> tuple[Sequence[float], Sequence[float], list[int]] | None:
    """Return the numbers of both points, and the places where they differ; None where they cannot be compared."""
    have = numbers_of(answer, form.size)
    want = numbers_of(expected, form.size)
    if have is None or want is None:
        return None
    return have, want, [place for place in range(form.size) if abs(have[place] - want[place]) > form.tolerance]


def _said_of(form: Vector, sums: dict[int, str]) -> tuple[str, Text] | None:
    return _said(form.size, sums) if sums and all(sums.values()) else None


def _said(size: int, sums: dict[int, str]) -> tuple[str, Text]:
    right = [LETTERS[place] for place in range(size) if place not in sums]
    said = [RIGHT.filled(names=", ".join(right))] if right else []
    said += [GIVES.filled(name=LETTERS[place], sum=text) for place, text in sums.items()]
    return f"computed: {'; '.join(sums.values())}", Text(*(f"{text}." for text in Text.joined(*said, between="; ")))


def put_together(form: Form, answer: Plain, expected: Plain, given: dict[str, Plain] | None) -> tuple[str, Text] | None:
    """Return in which places and with which signs the numbers of a point that was given stand in an answer; else None.

    Only where no two of them are alike in size, and none is 0: then it is no chance.
    """
    have = numbers_of(answer, form.size) if isinstance(form, Vector) and form.size == len(LETTERS) else None
    for name, row in _points(len(LETTERS), given or {}) if have else ():
        if _are_distinct(row, form.tolerance) and (places := _order(have, row)):
            want = numbers_of(expected, form.size)
            judged = _judged(have, want, form.tolerance) if want else ASKED
            said = PUT.filled(name=name, places=places, judged=judged)
            return f"put together: {places}", Text.joined(said, _stands_twice(places))
    return None


def _stands_twice(places: str) -> Text | None:
    """Return that a letter stands in two places, whatever its sign; None if none does."""
    letters = places.replace("-", "").split(", ")
    letter = next((one for one in letters if letters.count(one) == 2), None)
    return TWICE.filled(letter=letter) if letter else None


def _judged(have: Sequence[float], want: Sequence[float], tolerance: float) -> Text:
    """Return which numbers are right, which have only the wrong sign, and which stand where another belongs."""
    found: dict[Text, list[str]] = {RIGHT: [], OTHER_SIGN: [], OTHER_NUMBER: []}
    for letter, number, wanted in zip(LETTERS, have, want, strict=True):
        is_right, is_turned = abs(number - wanted) <= tolerance, abs(number + wanted) <= tolerance
        found[RIGHT if is_right else OTHER_SIGN if is_turned else OTHER_NUMBER].append(letter)
    said = (words.filled(names=", ".join(letters)) for words, letters in found.items() if letters)
    return Text(*(f"{text}." for text in Text.joined(*said, between="; ")))


def _are_distinct(row: Sequence[float], tolerance: float) -> bool:
    sizes = [0.0, *map(abs, row)]
    return min(abs(a - b) for a, b in combinations(sizes, 2)) > 2 * tolerance


def _order(have: Sequence[float], row: Sequence[float]) -> str:
    """Return the letters of a point's numbers as they stand, with their signs, some perhaps twice; "" if not all do."""
    places = [_place(number, row) for number in have]
    return ", ".join(places) if all(places) else ""


def _place(number: float, row: Sequence[float]) -> str:
    """Return the letter, and the sign, of the number of a point that this is; "" if it is none of them."""
    found = (letter for letter, one in zip(LETTERS, row, strict=True) if abs(abs(number) - abs(one)) <= CLOSE)
    letter = next(found, "")
    return f"-{letter}" if letter and number * row[LETTERS.index(letter)] < 0 else letter


def _way(form: Vector, want: Sequence[float], given: dict[str, Plain]) -> list[_Signed] | None:
    """Return the points that were given whose sum is right, each with its sign; None if no two or three of them are."""
    points = list(_points(form.size, given))[:MOST_POINTS]
    for count in (2, 3):
        for chosen in combinations(points, count):
            for signs in product((1.0, -1.0), repeat=count):
                sums = [sum(sign * row[place] for sign, (_, row) in zip(signs, chosen, strict=True))
                        for place in range(form.size)]  # fmt: skip
                if all(abs(one - other) <= form.tolerance for one, other in zip(sums, want, strict=True)):
                    return [(sign, *point) for sign, point in zip(signs, chosen, strict=True)]
    return None


def _points(size: int, given: dict[str, Plain]) -> Iterator[tuple[str, tuple[float, ...]]]:
    for name, leaf in leaves(given):
        parts = pose_of(leaf)
        row = numbers_of(leaf, size) if parts is None else parts[2][:size]
        if row is not None:
            yield (name if parts is None else f"{name}.translation"), tuple(row)


def _changed(way: Sequence[_Signed], place: int, number: float) -> str:
    """Return how a number was computed, where it is right but for one term, or for signs; "" if it was not."""
    terms = [_Term(sign, name, row, place) for sign, name, row in way]
    for row in _changes(terms):
        if abs(sum(one.value for one in row) - number) <= CLOSE:
            return as_written((one.factor, one.text) for one in row)
    return ""


def _changes(terms: list[_Term]) -> Iterator[list[_Term]]:
    """Yield the sum with another place in one term, without one, with one twice, and with other signs."""
    for at, term in enumerate(terms):
        others = [term._replace(place=other) for other in range(len(term.row)) if other != term.place]
        for change in (*others, term._replace(factor=2.0 * term.factor)):
            yield [*terms[:at], change, *terms[at + 1 :]]
        yield [*terms[:at], *terms[at + 1 :]]
        yield [term]
    for signs in product((1.0, -1.0), repeat=len(terms)):
        yield [term._replace(factor=sign * term.factor) for sign, term in zip(signs, terms, strict=True)]
