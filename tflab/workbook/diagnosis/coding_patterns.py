"""Recognise results of common coding patterns: a loop that removes, a constant, the input itself."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from ...text import Text, Texts
from ..answers.form import Form, inside, is_number, numbers_of, pose_of
from ..answers.forms import Angle, Choice, Number, Parts, Pose, Quaternion, Set, Vector
from ..answers.forms import Sequence as ListForm
from ..answers.members import members_of
from ..answers.values import Plain, is_raised
from .matching import A_HAIR, alike

__all__ = ["constant_of", "find_coding_pattern", "find_input", "leaves"]

TEXTS = Texts(__file__)

FEWEST = 3  # calls with a result of their own, for it to be no luck


def find_coding_pattern(
    form: Form, args: Sequence[list[Plain]], outcomes: Sequence[Plain], wanted: Sequence[Plain]
) -> tuple[str, Text] | None:
    """Return the habit that gives what came out in every call, and what to say of it; None if none does."""
    if any(map(is_raised, outcomes)) or any(map(is_raised, wanted)):
        return None
    if isinstance(form, ListForm | Set) and _passes_over(form, args, outcomes, wanted):
        return "removed in the loop", TEXTS["passed_over"]
    return None


def constant_of(form: Form, outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> tuple[str, Text] | None:
    """Return that a part of what a function gives is the same in every call, though others are wanted; else None."""
    others = [want for want in wanted if not form.alike(want, wanted[0])]
    differs = any(not form.alike(want, others[0]) for want in others[1:])  # two values are no more than confused
    is_same = outcomes[0] is not None and all(form.alike(one, outcomes[0]) for one in outcomes[1:])
    if len(outcomes) < FEWEST or not differs or not is_same:
        return None
    word = inside(outcomes[0])
    is_word = isinstance(form, Choice) and isinstance(word, str)
    what = Text(f'"{word}"', f'"{word}"만') if is_word else Text("the same", "같은 결과만")
    if isinstance(form, Number | Angle) and (row := numbers_of(outcomes[0], None)) is not None:
        what = Text(f"{row[0]:g}", f"{row[0]:g}만")
    return "the same in every call", TEXTS["same"].filled(what=what)


def _passes_over(
    form: ListForm | Set, args: Sequence[list[Plain]], outcomes: Sequence[Plain], wanted: Sequence[Plain]
) -> bool:
    """Return whether some argument, removed from in a loop over itself, leaves in each call just what came out."""
    for at in range(min(map(len, args), default=0)):
        rows = [tuple(map(members_of, (row[at], one, other)))
                for row, one, other in zip(args, outcomes, wanted, strict=True)]  # fmt: skip
        if any(None in row for row in rows):
            continue
        left = [_removed_in_the_loop(came, want) for came, _, want in rows]
        shows = not all(_same(one, row[2]) for one, row in zip(left, rows, strict=True))
        is_so = all(_same(one, row[1]) for one, row in zip(left, rows, strict=True))
        if is_so and shows:
            return True
    return False


def _removed_in_the_loop(came: list[Plain], want: list[Plain]) -> list[Plain]:
    left, place = list(came), 0
    while place < len(left):
        if left[place] not in want:
            del left[place]
        place += 1
    return left


def _same(one: list[Plain], other: list[Plain]) -> bool:
    return sorted(map(str, one)) == sorted(map(str, other))


def find_input(form: Form, outcome: Plain, expected: Plain, given: Mapping[str, Plain] | None) -> str | None:
    """Return which input an answer is, or is multiplied by where it is to be divided by it, or the reverse."""
    if isinstance(form, Choice | Parts | ListForm) or alike(form, outcome, expected):
        return None
    held = list(leaves(given or {}))
    came = (f"given {name}" for name, leaf in held for one in _shaped(form, name, leaf) if alike(form, outcome, one))
    reverse = (f"by {name}" for name, leaf in held if _is_factor_reversed(form, outcome, expected, leaf))
    return next(came, None) or next(reverse, None)


def _is_factor_reversed(form: Form, outcome: Plain, expected: Plain, factor: Plain) -> bool:
    """Return whether a product with this number was taken for a quotient, or the reverse, to all digits."""
    if not isinstance(form, Number) or not is_number(factor) or abs(factor) in (0, 1) or form.is_short(outcome):
        return False
    (one,), (right,), square = form.numbers(outcome) or (0,), form.numbers(expected) or (0,), factor**2
    pairs = ((one * right, square), (one * square, right), (one, right * square))
    return any(math.isclose(*pair, rel_tol=A_HAIR) for pair in pairs)


def _shaped(form: Form, name: str, leaf: Plain) -> Iterator[Plain]:
    """Yield what was given as an answer of this form might have it; a number only if its name ends in the unit."""
    if isinstance(form, Pose) or (isinstance(form, Number | Angle) and name.endswith(f"_{form.unit}")):
        yield leaf
    parts = pose_of(leaf)
    if isinstance(form, Vector):
        yield from ([leaf] if parts is None else [list(parts[2])[: form.size]])
    elif isinstance(form, Quaternion):
        yield from ([leaf] if parts is None else [list(parts[3])])


def leaves(given: Mapping[str, Plain], before: str = "") -> Iterator[tuple[str, Plain]]:
    """Yield what was given, by name; of a dict its members, too."""
    for name, held in given.items():
        yield before + name, held
        if isinstance(inner := inside(held), dict) and "Transform" not in inner:
            yield from leaves(inner, f"{before}{name}: ")
