"""What was lost, and cannot be put back?  Digits, zeros, an order, half a stamp: seen by comparing, not by undoing.

    answer (1.2, 2.3, 3.4)     expected (1.234, 2.345, 3.456)     rounded
    answer (1.0, 2.0, 0.0)     expected (1.0, 2.0, 3.0)           left at zero
    answer [b, a, c]           expected [a, b, c]                 another order
    answer 12.000000000        expected 12.345000000              a stamp of whole seconds

Only where the right answer is open; a tree's edges are found where it is sealed, too.
Read `fields.py` next.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator

from ..answers import sealed
from ..answers.form import Row as Marks
from ..answers.form import inside, member, numbers_of
from ..answers.forms import Angle, Form, Name, Number, Quaternion, Sequence, Set, Tree, Vector
from ..answers.members import edges_of, members_of
from ..answers.values import Plain
from ..words import Words
from .universal import OF_FORM

__all__ = ["LOSSES", "by_comparison"]

Numbers = tuple[float, ...]

LOSSES = {
    "empty": Words(en="this is still empty.", ko="아직 비어 있습니다."),
    "left at zero": Words(
        en="what is not 0 is right; a number that is still 0 is missing.",
        ko="0이 아닌 숫자는 맞습니다. 아직 0인 숫자가 빠졌습니다.",
    ),
    "zero": Words(
        en="0 would say that there is nothing of it, and there is.",
        ko="0이라면 아무것도 없다는 뜻인데, 없지 않습니다.",
    ),
    "rounded": Words(
        en="digits were cut off: hand over the number as it was computed, without rounding.",
        ko="자릿수를 잘라 냈습니다. 반올림하지 말고 계산한 그대로 넘기십시오.",
    ),
    "other order": Words(en="the right members, in the opposite order.", ko="원소는 맞지만 순서가 거꾸로입니다."),
    "another order": Words(
        en="the right members, and not in the order that is asked for.",
        ko="원소는 맞지만 요구한 순서가 아닙니다.",
    ),
    "members twice": Words(
        en="the right members, and some of them more than once.", ko="원소는 맞지만 두 번 이상 든 것이 있습니다."
    ),
    "parent for child": Words(
        en="parents and children have changed places. Each child has one parent, so the child is the key: "
        "child -> parent.",
        ko="부모와 자식의 자리가 바뀌었습니다. 자식의 부모는 하나뿐이므로 자식이 키입니다: 자식 -> 부모.",
    ),
    "stamp: seconds alone": Words(
        en="only `sec` is right: the nanoseconds are missing. `.to_msg()` of a Time writes both.",
        ko="`sec`만 맞고 나노초가 빠졌습니다. Time의 `.to_msg()`가 둘 다 씁니다.",
    ),
    "stamp: nanoseconds alone": Words(
        en="only `nanosec` is right: the whole seconds are missing. `.to_msg()` of a Time writes both.",
        ko="`nanosec`만 맞고 초가 빠졌습니다. Time의 `.to_msg()`가 둘 다 씁니다.",
    ),
    "stamp: zero": Words(
        en="the stamp is still zero: nobody has written it.", ko="시각이 아직 0입니다. 아무도 쓰지 않았습니다."
    ),
    "stamp: written": Words(
        en="a stamp was written, and here it is to be left as it is, zero.",
        ko="시각을 썼습니다. 여기서는 0인 그대로 두어야 합니다.",
    ),
}


def by_comparison(form: Form, answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    """Yield the mistakes that lose something and cannot be undone."""
    if answers == [""] * len(answers):
        yield "empty"
    elif isinstance(form, Sequence):
        yield from _of_lists(form, answers, wanted)
    elif isinstance(form, Set) and form.once and all(map(_is_held_twice, [form] * len(wanted), answers, wanted)):
        yield "members twice"
    elif isinstance(form, Tree):
        yield from _of_trees(form, answers, wanted)
    elif isinstance(form, Name):
        yield from _of_stamps(answers, wanted)
    elif type(form) in OF_FORM and all(form.read(answer) is not None for answer in answers):
        size = form.size if isinstance(form, Vector) else 4 if isinstance(form, Quaternion) else None
        rows = [(numbers_of(given, size), numbers_of(want, size)) for given, want in zip(answers, wanted, strict=True)]
        if None not in sum(rows, ()):
            yield from _lost(form, rows)


def _lost(form: Form, rows: list[tuple[Numbers, Numbers]]) -> Iterator[str]:
    is_empty = not any(any(given) for given, _ in rows)
    if isinstance(form, Vector) and all(_left_at_zero(*row, form.tolerance) for row in rows):
        yield "empty" if is_empty else "left at zero"
    elif is_empty and isinstance(form, Number | Angle):
        yield "zero"
    if not is_empty and any(all(_rounded(*row, digits) for row in rows) for digits in (0, 1, 2, 3)):
        yield "rounded"


def _left_at_zero(given: Numbers, wanted: Numbers, tolerance: float) -> bool:
    return all(number == 0.0 or abs(number - want) <= tolerance for number, want in zip(given, wanted, strict=True))


def _rounded(given: Numbers, wanted: Numbers, digits: int) -> bool:
    """Return whether each number was rounded to so many digits, or cut there."""
    scale = 10**digits
    return all(
        any(abs(number - cut / scale) < 1e-9 for cut in (round(want * scale), math.trunc(want * scale)))
        for number, want in zip(given, wanted, strict=True)
    )


def _of_lists(form: Sequence, answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    pairs = [(_ways(form, answer), _ways(form, want)) for answer, want in zip(answers, wanted, strict=True)]
    if any(None in pair for pair in pairs):
        return
    if all(given == want or given == want[::-1] for given, want in pairs):
        yield "other order"
    if all(sorted(given) == sorted(want) for given, want in pairs):
        yield "another order"
    if all(list(dict.fromkeys(given)) == want for given, want in pairs):
        yield "members twice"


def _ways(form: Sequence, plain: Plain) -> list[str] | None:
    """Return each member of a list as one word that says how it can be written; None if it is no such list."""
    held = inside(plain)
    if sealed.is_sealed(plain) or not isinstance(held, list):
        return None
    read = [form.of.read(one) for one in held]
    return None if None in read else [json.dumps([_plain(row) for probe in probes for row in probe]) for probes in read]


def _plain(row: Marks) -> list[float | str]:
    return [mark.value if isinstance(mark.value, str) else round(mark.value, 9) + 0.0 for mark in row]


def _is_held_twice(form: Set, answer: Plain, wanted: Plain) -> bool:
    """Return whether an answer is right once each of its members counts once, or right as it is."""
    members = members_of(answer)
    return members is not None and all(sealed.judge(Set(form.of), members, wanted))


def _of_trees(form: Tree, answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    """Yield that an answer has its edges the wrong way round; a dict by parents has lost some of them."""
    for answer, want in zip(answers, wanted, strict=True):
        edges = edges_of(answer) or []
        turned = [[child, parent] for child, parent in edges]  # a Tree takes pairs (parent, child)
        if len(edges) < 2 or not all(sealed.belongs(form, turned, want)):
            return
    yield "parent for child"


def _of_stamps(answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    rows = [(_stamp(answer), _stamp(want)) for answer, want in zip(answers, wanted, strict=True)]
    if any(None in row for row in rows):
        return
    if all(want == (0, 0) for _, want in rows):
        yield "stamp: written"
    elif all(given == (0, 0) for given, _ in rows):
        yield "stamp: zero"
    elif all(given == (sec, 0) for given, (sec, _) in rows):
        yield "stamp: seconds alone"
    elif all(given == (0, nanosec) for given, (_, nanosec) in rows):
        yield "stamp: nanoseconds alone"


def _stamp(plain: Plain) -> tuple[int, int] | None:
    sec, nanosec = member(plain, "sec"), member(plain, "nanosec")
    return (sec, nanosec) if isinstance(sec, int) and isinstance(nanosec, int) else None
