"""Recognise a constant, the input itself, and a factor that was reversed."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from ...text import Text, Texts
from ..answers.form import Form, inside, is_number, numbers_of, pose_of
from ..answers.forms import Angle, Choice, Number, Parts, Pose, Quaternion, Vector
from ..answers.forms import Sequence as ListForm
from ..answers.values import Plain
from .matching import A_HAIR, alike

__all__ = ["constant_of", "find_input"]

TEXTS = Texts(__file__)

FEWEST = 3  # calls with a result of their own, for it to be no luck


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


def find_input(form: Form, outcome: Plain, expected: Plain, given: Mapping[str, Plain] | None) -> str | None:
    """Return which input an answer is, or is multiplied by where it is to be divided by it, or the reverse."""
    if isinstance(form, Choice | Parts | ListForm) or alike(form, outcome, expected):
        return None
    held = list(_leaves(given or {}))
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


def _leaves(given: Mapping[str, Plain], before: str = "") -> Iterator[tuple[str, Plain]]:
    """Yield what was given, by name; of a dict its members, too."""
    for name, held in given.items():
        yield before + name, held
        if isinstance(inner := inside(held), dict) and "Transform" not in inner:
            yield from _leaves(inner, f"{before}{name}: ")
