"""Which habit of writing gives this?  A member for the whole list, a loop that removes from what it goes through.

    argument 1   [3, 9, 4]      gives   3     in each call its first member: a `return` inside the loop
    argument 1   [1, 2, 8, 9]   kept   [2, 9]  where nothing was to be kept: each that followed one that went

Only the outcomes are looked at, never the learner's text; so what is said is what they
are, in every call.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from ...text import Text
from ..answers.form import Form, inside, numbers_of
from ..answers.forms import Angle, Choice, Name, Number, Set
from ..answers.forms import Sequence as ListForm
from ..answers.members import members_of
from ..answers.values import Plain, is_raised
from ..mistakes.fitting import is_just

__all__ = ["constant_of", "habit_of"]

FEWEST = 3  # calls with a result of their own, for it to be no luck
ALWAYS = Text(
    en="in every call this is {what}, and no more.",
    ko="어느 호출에서나 {what}일 뿐입니다.",
)
OF_A_LIST: dict[str, tuple[Callable[[list], Plain], Text, Text]] = {
    "the first member": (
        lambda held: held[0],
        Text("the first member of argument {at}", "{at}번째 인자의 첫 원소"),
        Text(" Does a `return` stand inside the loop?", " 반복문 안에 `return`이 있지 않습니까?"),
    ),
    "the last member": (
        lambda held: held[-1],
        Text("the last member of argument {at}", "{at}번째 인자의 마지막 원소"),
        Text(" Does each round of the loop write over the one before?",
              " 반복문을 돌 때마다 앞의 결과를 덮어쓰지 않습니까?"),
    ),
    "the smallest": (min, Text("the smallest in argument {at}", "{at}번째 인자에서 가장 작은 것"), Text("", "")),
    "the largest": (max, Text("the largest in argument {at}", "{at}번째 인자에서 가장 큰 것"), Text("", "")),
    "the number of members": (
        len, Text("the number of members in argument {at}", "{at}번째 인자의 원소 수"), Text("", "")
    ),
    "the sum": (sum, Text("the sum of argument {at}", "{at}번째 인자의 합"), Text("", "")),
    "the mean": (
        lambda held: sum(held) / len(held), Text("the mean of argument {at}", "{at}번째 인자의 평균"), Text("", "")
    ),
}  # fmt: skip
SAME = Text(
    en="this is {what} in every call, and it should not be: what of the arguments does it depend on?",
    ko="모든 호출에서 {what} 나옵니다. 그래서는 안 됩니다. 인자의 무엇에 따라 달라져야 합니까?",
)
PASSED_OVER = Text(
    en="what is too much follows each time on something that went: whoever removes from the list that the loop goes "
    "through makes it pass over the next one. Build a new list, or loop over a copy.",
    ko="남으면 안 되는데 남은 것은 모두, 빠진 원소 바로 다음에 있던 것입니다. 반복문이 지나는 리스트에서 원소를 지우면 "
    "그다음 원소를 건너뜁니다. 새 리스트를 만들거나 사본으로 반복하십시오.",
)


def habit_of(
    form: Form, args: Sequence[list[Plain]], outcomes: Sequence[Plain], wanted: Sequence[Plain]
) -> tuple[str, Text] | None:
    """Return the habit that gives what came out in every call, and what to say of it; None if none does."""
    if any(map(is_raised, outcomes)) or any(map(is_raised, wanted)):
        return None
    if isinstance(form, ListForm | Set) and _passes_over(form, args, outcomes, wanted):
        return "removed in the loop", PASSED_OVER
    if not isinstance(form, Number | Angle | Name) or len({str(outcome) for outcome in outcomes}) < FEWEST:
        return None
    for name, what, asks, values in _candidates(args):
        if is_just(form, outcomes, values):
            return name, Text(*map("".join, zip(ALWAYS.filled(what=what), asks, strict=True)))
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
    return "the same in every call", SAME.filled(what=what)


def _candidates(args: Sequence[list[Plain]]) -> Iterator[tuple[str, Text, Text, list[Plain]]]:
    """Yield what may be made of arguments: a name, what it is, what to ask, and what it gives in each call."""
    count = min(map(len, args), default=0)
    for at in range(count):
        yield from _of_one(at, [inside(row[at]) for row in args])


def _of_one(at: int, held: list[Plain]) -> Iterator[tuple[str, Text, Text, list[Plain]]]:
    if not all(isinstance(each, list) and each for each in held):
        return
    for name, (make, what, asks) in OF_A_LIST.items():
        if (values := _made(make, held)) is not None:
            yield name, what.filled(at=at + 1), asks, values


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
