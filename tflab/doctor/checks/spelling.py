"""How alike are two names?  Case, prefix, a slip of the hand, or not at all.

    Base_link   base_link     case     the same letters
    r1/laser    laser         prefix   the same last word
    odm         odom          slip     one letter more, less, other, or two exchanged
    left_wheel  right_wheel   -        two honest names
    joint_1     joint_2       -

A slip is a Damerau-Levenshtein distance of one, of two in long names.  Sides and
numbers are what honest names differ in.
"""

from __future__ import annotations

import re

__all__ = ["differ_in_side", "endings_of", "is_slip", "letters_of", "likeness", "prefix_of", "remind_of_each_other"]

LONG_NAME = 12  # letters, from which on two slips are one misspelling
SIDES = {
    "left",
    "right",
    "front",
    "rear",
    "back",
    "upper",
    "lower",
    "top",
    "bottom",
    "inner",
    "outer",
    "master",
    "slave",
}
SHORT_WORD = 2  # letters: l, r, fl, x, ... tell honest names apart


def likeness(name: str, other: str) -> str:
    """Return how `name` is like `other`, but for a slip: "case", "prefix" or ""."""
    if letters_of(name) == letters_of(other):
        return "case"
    if name.rpartition("/")[2] == other.rpartition("/")[2] and ("/" in name) != ("/" in other):
        return "prefix"
    if name.endswith("_" + other) and not {*re.split(r"[_/\d]+", name[: -len(other)])} & SIDES:
        return "prefix"
    return ""


def remind_of_each_other(name: str, other: str) -> bool:
    """Return whether somebody may have written one name for the other: also laser for laser_frame."""
    longer, shorter = (name, other) if len(name) > len(other) else (other, name)
    return bool(likeness(longer, shorter)) or longer.startswith(f"{shorter}_") or is_slip(name, other)


def letters_of(name: str) -> str:
    """Return a name without case and without the characters that people put between words."""
    return "".join(letter for letter in name.lower() if letter.isalnum() or letter == "/")


def endings_of(name: str) -> list[str]:
    """Return what is left of a name without its first words: "base_link" and "link" of "r1/base_link"."""
    return [name[match.end() :] for match in re.finditer(r"[_/]", name)]


def prefix_of(name: str, other: str) -> str:
    """Return what one of two names has before the other."""
    longer, shorter = (name, other) if len(name) > len(other) else (other, name)
    return longer[: len(longer) - len(shorter)]


def differ_in_side(name: str, other: str) -> bool:
    """Return whether one of two names has a side that the other has not: parts of one robot have."""
    return bool(({*_words(name)} ^ {*_words(other)}) & SIDES)


def is_slip(name: str, other: str) -> bool:
    """Return whether one name is probably the other, misspelt."""
    most = 1 if min(len(name), len(other)) <= LONG_NAME else 2
    if abs(len(name) - len(other)) > most or name[:1] != other[:1] or _digits(name) != _digits(other):
        return False
    return not _differ_as_honest_names_do(name, other) and _distance(name, other) <= most


def _differ_as_honest_names_do(name: str, other: str) -> bool:
    """Return whether the words in which two names differ are sides, or too short to tell."""
    words, others = _words(name), _words(other)
    if len(words) != len(others):
        return False
    pairs = [(a, b) for a, b in zip(words, others, strict=True) if a != b]
    return any({a, b} <= SIDES or max(len(a), len(b)) <= SHORT_WORD for a, b in pairs)


def _distance(a: str, b: str) -> int:
    """Return how many letters to add, drop, change or exchange with their neighbour to make one word of the other."""
    before: list[int] = []
    last = list(range(len(b) + 1))
    for i, x in enumerate(a, 1):
        here = [i]
        for j, y in enumerate(b, 1):
            cost = min(last[j] + 1, here[j - 1] + 1, last[j - 1] + (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and a[i - 2] == y:
                cost = min(cost, before[j - 2] + 1)
            here.append(cost)
        before, last = last, here
    return last[-1]


def _words(name: str) -> list[str]:
    return [word.strip("0123456789") for word in re.split(r"[_/\-.]+", name.lower())]


def _digits(name: str) -> list[str]:
    return [letter for letter in name if letter.isdigit()]
