"""What do the calls have in common in which a function goes wrong?  Looked for in their arguments.

    wrong   keep([3, 1], 2)   keep([5, 4], 0)      "argument 1 is not in rising order", in both
    right   keep([1, 3], 2)   keep([], 1)          and in neither of these

It is a decision tree of one question (a *stump*): said where it parts the calls that are
wrong from those that are right, or where all that are wrong share what few others have.
It tells what is so, and no cause.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import NamedTuple

from ...text import Text
from ..answers.form import Form, inside, is_number, member
from ..answers.values import Plain
from ..mistakes.fitting import alike
from ..mistakes.losses import stamp_of, time_of

__all__ = ["calls_in_common", "in_common"]

FEWEST = 2  # calls on either side: of one call everything is true
SELDOM = 1 / 3  # of the calls that are right, at most, may share it, too
LONGEST = 30  # letters of a text that is quoted

JUST_THERE = Text(
    en="It goes wrong in just the calls in which {fact}.",
    ko="{fact} 호출에서만 틀립니다.",
)
IN_ALL = Text(
    en="In all calls that go wrong {fact}.",
    ko="틀리는 호출은 모두 {fact} 호출입니다.",
)
FACTS = {  # the plainest first; the Korean ones stand before a noun
    "empty": Text("argument {at} is empty", "{at}번째 인자가 비어 있는"),
    "zero": Text("argument {at} is 0", "{at}번째 인자가 0인"),
    "zero time": Text("argument {at} is a time of 0", "{at}번째 인자가 시각 0인"),
    "no frame": Text("the header of argument {at} names no frame", "{at}번째 인자의 헤더에 좌표계가 없는"),
    "no stamp": Text("the stamp in the header of argument {at} is zero", "{at}번째 인자의 헤더에 있는 시각이 0인"),
    "later": Text(
        "the stamp in the header of argument {at} is later than argument {of}",
        "{at}번째 인자의 헤더에 있는 시각이 {of}번째 인자보다 늦은",
    ),
    "earlier": Text(
        "the stamp in the header of argument {at} is earlier than argument {of}",
        "{at}번째 인자의 헤더에 있는 시각이 {of}번째 인자보다 이른",
    ),
    "at once": Text(
        "the stamp in the header of argument {at} is just argument {of}",
        "{at}번째 인자의 헤더에 있는 시각이 {of}번째 인자와 같은",
    ),
    "no sec": Text(
        "the stamp in the header of argument {at} has a sec of 0", "{at}번째 인자의 헤더에 있는 시각의 sec이 0인"
    ),
    "no nanosec": Text(
        "the stamp in the header of argument {at} has a nanosec of 0",
        "{at}번째 인자의 헤더에 있는 시각의 nanosec이 0인",
    ),
    "one": Text("argument {at} has a single member", "{at}번째 인자의 원소가 하나뿐인"),
    "twice": Text("argument {at} holds a member twice", "{at}번째 인자에 같은 원소가 두 번 든"),
    "unsorted": Text("argument {at} is not in rising order", "{at}번째 인자가 커지는 순서가 아닌"),
    "slash": Text("argument {at} begins with a slash", "{at}번째 인자가 슬래시로 시작하는"),
    "slash of a frame": Text(
        "the frame in the header of argument {at} begins with a slash",
        "{at}번째 인자의 헤더에 있는 좌표계가 슬래시로 시작하는",
    ),
    "negative": Text("argument {at} is below 0", "{at}번째 인자가 0보다 작은"),
    "member negative": Text("argument {at}[{of}] is below 0", "{at}번째 인자의 [{of}]가 0보다 작은"),
    "some negative": Text("argument {at} holds a number below 0", "{at}번째 인자에 0보다 작은 수가 든"),
    "equal": Text("arguments {at} and {of} are the same", "{at}번째 인자와 {of}번째 인자가 같은"),
    "larger": Text("argument {at} is larger than argument {of}", "{at}번째 인자가 {of}번째 인자보다 큰"),
    "is": Text("argument {at} is {of}", "{at}번째 인자가 {of}인"),
    "frame": Text("the frame in the header of argument {at} is {of}", "{at}번째 인자의 헤더에 있는 좌표계가 {of}인"),
    "key": Text("argument {at} has the key {of}", "{at}번째 인자에 {of} 키가 있는"),
    "no key": Text("argument {at} has no key {of}", "{at}번째 인자에 {of} 키가 없는"),
    "holds": Text("argument {at} holds {of}", "{at}번째 인자에 {of}도 든"),
    "member zero": Text("argument {at}[{of}] is 0", "{at}번째 인자의 [{of}]가 0인"),
}
ONLY_JUST_THERE = {"no sec", "no nanosec", "member negative", "member zero"}  # of many, one is shared by chance
MOST_MEMBERS = 4  # of a tuple of numbers that are looked at one by one


class Fact(NamedTuple):
    """Something that is so in a call: of which kind, of which argument (from 1), and what it is."""

    kind: str
    at: int
    of: str = ""


def calls_in_common(
    form: Form, args: Sequence[list[Plain] | None], outcomes: Sequence[Plain], wanted: Sequence[Plain]
) -> Text | None:
    """Return what the arguments of the calls that go wrong have in common; None if nothing that others have not."""
    rows = [(call or [], alike(form, *pair)) for call, *pair in zip(args, outcomes, wanted, strict=True)]
    return in_common(*([call for call, is_right in rows if is_right is side] for side in (False, True)))


def in_common(wrong: Sequence[list[Plain]], right: Sequence[list[Plain]]) -> Text | None:
    """Return what the arguments of calls that go wrong have in common, and those of others have not; None if nothing.

    Args:
        wrong: the arguments of each call that goes wrong.
        right: of each that does not.
    """
    if len(wrong) < FEWEST or len(right) < FEWEST:
        return None
    keys = _keys([*wrong, *right])
    shared = set.intersection(*(set(_facts(args, keys)) for args in wrong))
    often = {fact: sum(fact in set(_facts(args, keys)) for args in right) for fact in shared}
    often = {fact: count for fact, count in often.items() if not count or fact.kind not in ONLY_JUST_THERE}
    order = list(FACTS)
    ranked = sorted(often, key=lambda fact: (often[fact] > 0, order.index(fact.kind), often[fact], fact))
    if not ranked or often[ranked[0]] > SELDOM * len(right):
        return None
    fact = ranked[0]
    words = IN_ALL if often[fact] else JUST_THERE
    return words.filled(fact=FACTS[fact.kind].filled(at=fact.at, of=fact.of))


def _keys(calls: Sequence[list[Plain]]) -> dict[int, set[str]]:
    """Return the keys that a dict has in any call, by the argument's number."""
    found: dict[int, set[str]] = {}
    for args in calls:
        for at, plain in enumerate(args, start=1):
            if isinstance(plain, dict) and isinstance(held := plain.get("dict"), dict):
                found.setdefault(at, set()).update(held)
    return found


def _facts(args: list[Plain], keys: dict[int, set[str]]) -> Iterator[Fact]:
    """Yield what is so in a call."""
    for at, plain in enumerate(args, start=1):
        if isinstance(plain, bool | str) or plain is None:
            yield from _of_a_word(at, plain)
        elif is_number(plain):
            yield from _that_are(at, zero=plain == 0, negative=plain < 0)
        elif isinstance(held := inside(plain), list):
            yield from _of_a_list(at, held)
        elif isinstance(plain, dict) and isinstance(held := plain.get("dict"), dict):
            yield from _of_a_dict(at, held, keys.get(at, set()))
        else:
            yield from _of_an_object(at, plain)
    yield from _of_two(args)
    yield from _of_times(args)


def _of_times(args: list[Plain]) -> Iterator[Fact]:
    """Yield what is so of the stamp in a header, alone and beside a Time."""
    for at, plain in enumerate(args, start=1):
        stamp = stamp_of(member(plain, "header", "stamp"))
        if stamp is None:
            continue
        yield from _that_are(at, no_stamp=stamp == (0, 0), no_sec=stamp[0] == 0, no_nanosec=stamp[1] == 0)
        for of, other in enumerate(args, start=1):
            time = time_of(other)
            if time is not None:
                yield Fact("later" if stamp > time else "earlier" if stamp < time else "at once", at, str(of))


def _that_are(at: int, **facts: bool) -> Iterator[Fact]:
    yield from (Fact(kind.replace("_", " "), at) for kind, is_so in facts.items() if is_so)


def _of_two(args: list[Plain]) -> Iterator[Fact]:
    for (one, a), (other, b) in combinations(enumerate(args, start=1), 2):
        if is_number(a) and is_number(b) and a == b:
            yield Fact("equal", one, str(other))
        elif is_number(a) and is_number(b):
            yield Fact("larger", one, str(other)) if a > b else Fact("larger", other, str(one))


def _of_a_dict(at: int, held: dict[str, Plain], keys: set[str]) -> Iterator[Fact]:
    yield from _that_are(at, empty=not held)
    yield from (Fact("key" if key in held else "no key", at, _quoted(key)) for key in keys)


def _of_a_word(at: int, plain: Plain) -> Iterator[Fact]:
    if plain == "":
        yield Fact("empty", at)
    elif not isinstance(plain, str) or len(plain) <= LONGEST:
        yield Fact("is", at, _quoted(plain))
    if isinstance(plain, str) and plain.startswith("/"):
        yield Fact("slash", at)


def _of_a_list(at: int, held: list[Plain]) -> Iterator[Fact]:
    is_twice = any(one in held[:place] for place, one in enumerate(held))
    yield from _that_are(at, empty=not held, one=len(held) == 1, twice=is_twice)
    numbers = [one[0] if isinstance(one := inside(each), list) and one else one for each in held]
    yield from _of_each_member(at, held)
    if numbers and all(map(is_number, numbers)):
        yield from _that_are(at, unsorted=numbers != sorted(numbers), some_negative=min(numbers) < 0)
    yield from (Fact("holds", at, _quoted(each)) for each in held if isinstance(each, str) and len(each) <= LONGEST)


def _of_each_member(at: int, held: list[Plain]) -> Iterator[Fact]:
    """Yield what is so of each number of a short list by its place."""
    if len(held) <= MOST_MEMBERS and all(map(is_number, held)):
        yield from (Fact("member negative", at, str(of)) for of, number in enumerate(held) if number < 0)
        yield from (Fact("member zero", at, str(of)) for of, number in enumerate(held) if number == 0)


def _of_an_object(at: int, plain: Plain) -> Iterator[Fact]:
    """Yield what is so of a Time, or of a message with a header."""
    time = plain.get("Time") if isinstance(plain, dict) else None
    if isinstance(time, list) and time and time[0] == 0:
        yield Fact("zero time", at)
    frame = member(plain, "header", "frame_id")
    if frame == "":
        yield Fact("no frame", at)
    elif isinstance(frame, str):
        yield Fact("frame", at, _quoted(frame))
        yield from (Fact("slash of a frame", at),) if frame.startswith("/") else ()


def _quoted(plain: Plain) -> str:
    return f'"{plain}"' if isinstance(plain, str) else str(plain)
