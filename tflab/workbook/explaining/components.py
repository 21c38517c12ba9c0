"""Recognise a point that was put together from the numbers of a given one, in other places or with other signs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from ...text import Text, Texts
from ..answers.form import Form, numbers_of, pose_of
from ..answers.forms import Vector
from ..answers.values import Plain
from ..mistakes.by_place import LETTERS
from .givens import leaves

__all__ = ["put_together"]

TEXTS = Texts(__file__)

CLOSE = 1e-6


def put_together(form: Form, answer: Plain, expected: Plain, given: dict[str, Plain] | None) -> tuple[str, Text] | None:
    """Return in which places and with which signs the numbers of a point that was given stand in an answer; else None.

    Only where no two of them are alike in size, and none is 0: then it is no chance.
    """
    have = numbers_of(answer, form.size) if isinstance(form, Vector) and form.size == len(LETTERS) else None
    for name, row in _points(len(LETTERS), given or {}) if have else ():
        if _are_distinct(row, form.tolerance) and (places := _order(have, row)):
            want = numbers_of(expected, form.size)
            judged = _judged(have, want, form.tolerance) if want else TEXTS["asked"]
            said = TEXTS["put"].filled(name=name, places=places, judged=judged)
            return f"put together: {places}", Text.joined(said, _stands_twice(places))
    return None


def _stands_twice(places: str) -> Text | None:
    """Return that a letter stands in two places, whatever its sign; None if none does."""
    letters = places.replace("-", "").split(", ")
    letter = next((one for one in letters if letters.count(one) == 2), None)
    return TEXTS["twice"].filled(letter=letter) if letter else None


def _judged(have: Sequence[float], want: Sequence[float], tolerance: float) -> Text:
    """Return which numbers are right, which have only the wrong sign, and which stand where another belongs."""
    found: dict[Text, list[str]] = {TEXTS["right"]: [], TEXTS["other_sign"]: [], TEXTS["other_number"]: []}
    for letter, number, wanted in zip(LETTERS, have, want, strict=True):
        is_right, is_turned = abs(number - wanted) <= tolerance, abs(number + wanted) <= tolerance
        found[TEXTS["right"] if is_right else TEXTS["other_sign"] if is_turned else TEXTS["other_number"]].append(
            letter
        )
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


def _points(size: int, given: dict[str, Plain]) -> Iterator[tuple[str, tuple[float, ...]]]:
    for name, leaf in leaves(given):
        parts = pose_of(leaf)
        row = numbers_of(leaf, size) if parts is None else parts[2][:size]
        if row is not None:
            yield (name if parts is None else f"{name}.translation"), tuple(row)
