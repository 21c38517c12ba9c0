"""Which of a point's numbers has the wrong sign, and which two have changed places?  Told where it is sure.

    asked for  (1, 2, 3)     given  (1, -2, 3)      "one sign"          y
                             given  (2, 1, 3)       "exchanged"         x, y
                             given  (1, 3, -2)      "places and signs"  x is right

Names of numbers, never their values.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...text import Text, Texts

__all__ = ["LETTERS", "letters_told", "said_of_letters"]

TEXTS = Texts(__file__)

LETTERS = "xyz"


def letters_told(name: str, given: Sequence[float], left: Sequence[float]) -> str:
    """Return which numbers of a point this mistake is about, as they are named; nothing where that is not sure.

    Args:
        name: of the mistake, as of `universal.py`.
        given: the numbers of the answer.
        left: the same without the mistake.
    """
    if name not in TEXTS or len(given) > len(LETTERS):
        return ""
    pairs = zip(LETTERS, given, left, strict=False)
    moved, kept = [], []
    for letter, one, other in pairs:
        (kept if one == other else moved).append(letter)
    if name == "places and signs":
        return kept[0] if len(kept) == 1 and len(moved) == 2 else ""
    if name == "one sign":
        return moved[0] if len(moved) == 1 else ""
    return ", ".join(moved) if len(moved) == 2 else ""


def said_of_letters(name: str, told: str) -> Text | None:
    """Return what is said of a mistake and of these numbers; None of another mistake."""
    if name not in TEXTS or not told:
        return None
    one, _, other = told.partition(", ")
    return TEXTS[name].filled(told=Text(f"{one} and {other}", f"{one}와 {other}") if other else told)
