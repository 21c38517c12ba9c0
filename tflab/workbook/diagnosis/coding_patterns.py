"""Recognise results of common coding patterns: the first member alone, a loop that removes, the input itself."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from ...text import Text, Texts
from ..answers.form import Form, inside, numbers_of, pose_of
from ..answers.forms import Angle, Choice, Name, Number, Parts, Pose, Quaternion, Set, Vector
from ..answers.forms import Sequence as ListForm
from ..answers.members import members_of
from ..answers.values import Plain, is_raised
from .matching import alike, matches_closely

__all__ = ["constant_of", "find_coding_pattern", "find_input", "leaves"]

TEXTS = Texts(__file__)

FEWEST = 3  # calls with a result of their own, for it to be no luck
OF_A_LIST: dict[str, Callable[[list], Plain]] = {
    "the first member": lambda held: held[0],
    "the last member": lambda held: held[-1],
    "the smallest": min,
    "the largest": max,
    "the number of members": len,
    "the sum": sum,
    "the mean": lambda held: sum(held) / len(held),
}


def find_coding_pattern(
    form: Form, args: Sequence[list[Plain]], outcomes: Sequence[Plain], wanted: Sequence[Plain]
) -> tuple[str, Text] | None:
    """Return the habit that gives what came out in every call, and what to say of it; None if none does."""
    if any(map(is_raised, outcomes)) or any(map(is_raised, wanted)):
        return None
    if isinstance(form, ListForm | Set) and _passes_over(form, args, outcomes, wanted):
        return "removed in the loop", TEXTS["passed_over"]
    if not isinstance(form, Number | Angle | Name) or len({str(outcome) for outcome in outcomes}) < FEWEST:
        return None
    for name, number, values in _candidates(args):
        if matches_closely(form, outcomes, values):
            return name, TEXTS[name].filled(at=number)
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
    what = Text(f'"{word}"', f'"{word}"이(가)') if is_word else Text("the same", "같은 것이")
    if isinstance(form, Number | Angle) and (row := numbers_of(outcomes[0], None)) is not None:
        what = Text(f"{row[0]:g}", f"{row[0]:g}이(가)")
    return "the same in every call", TEXTS["same"].filled(what=what)


def _candidates(args: Sequence[list[Plain]]) -> Iterator[tuple[str, int, list[Plain]]]:
    """Yield what may be made of an argument: a name, the argument's number, and what it gives in each call."""
    for at in range(min(map(len, args), default=0)):
        held = [inside(row[at]) for row in args]
        if all(isinstance(each, list) and each for each in held):
            for name, make in OF_A_LIST.items():
                if (values := _made(make, held)) is not None:
                    yield name, at + 1, values


def _made(make: Callable, held: Sequence) -> list[Plain] | None:
    try:
        return [make(each) for each in held]
    except (TypeError, ValueError, ZeroDivisionError):
        return None


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


def find_input(form: Form, outcome: Plain, expected: Plain, given: dict[str, Plain] | None) -> str | None:
    """Return under which name an answer was given, if it is nothing else than that."""
    if isinstance(form, Choice | Parts | ListForm) or alike(form, outcome, expected):
        return None
    for name, leaf in leaves(given or {}):
        for shaped in _shaped(form, name, leaf):
            if form.read(shaped) is not None and alike(form, outcome, shaped):
                return name
    return None


def _shaped(form: Form, name: str, leaf: Plain) -> Iterator[Plain]:
    """Yield what was given as an answer of this form might have it; a number only if its name ends in the unit."""
    if isinstance(form, Pose) or (isinstance(form, Number | Angle) and name.endswith(f"_{form.unit}")):
        yield leaf
    parts = pose_of(leaf)
    if isinstance(form, Vector):
        yield from ([leaf] if parts is None else [list(parts[2])[: form.size]])
    elif isinstance(form, Quaternion):
        yield from ([leaf] if parts is None else [list(parts[3])])


def leaves(given: dict[str, Plain], before: str = "") -> Iterator[tuple[str, Plain]]:
    """Yield what was given, by name; of a dict its members, too."""
    for name, held in given.items():
        yield before + name, held
        if isinstance(inner := inside(held), dict) and "Transform" not in inner:
            yield from leaves(inner, f"{before}{name}: ")
