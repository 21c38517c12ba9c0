"""What was lost, and cannot be put back?  Digits, zeros, an order, half a stamp: seen by comparing, not by undoing.

    answer (1.2, 2.3, 3.4)     expected (1.234, 2.345, 3.456)     rounded
    answer (1.0, 2.0, 0.0)     expected (1.0, 2.0, 3.0)           left at zero
    answer [b, a, c]           expected [a, b, c]                 another order
    answer 12.000000000        expected 12.345000000              a stamp of whole seconds

Only where the right answer is open.  Read `shell_words.py` next.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterator

from ..answers import sealed
from ..answers.form import Row as Marks
from ..answers.form import inside, member, numbers_of
from ..answers.forms import Angle, Command, Form, Name, Number, Quaternion, Sequence, Set, Tree, Vector
from ..answers.members import members_of
from ..answers.values import Plain
from ..words import Words
from .shell_words import LINES, told_of_a_line, wrong_in
from .trees import TREES, of_trees, told_of_a_tree
from .universal import OF_FORM

__all__ = ["LOSSES", "TOLD", "by_comparison", "stamp_of", "time_of", "words_of_loss"]

Numbers = tuple[float, ...]
TOLD = " | "  # between the name of a loss and what is told of it: names that stand in the answer

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
    "members once": Words(
        en="the right members, each of them once; a member counts as often as it comes.",
        ko="원소는 맞지만 한 번씩만 있습니다. 같은 원소도 나온 횟수만큼 있어야 합니다.",
    ),
    "members once, in another order": Words(
        en="the right members, but each of them once and in another order; a member counts as often as it comes.",
        ko="원소는 맞지만 한 번씩만 있고 순서도 다릅니다. 같은 원소도 나온 횟수만큼 있어야 합니다.",
    ),
    "members missing": Words(
        en="what is there belongs there, in this order; members are missing.",
        ko="있는 원소와 그 순서는 맞지만 빠진 원소가 있습니다.",
    ),
    "members too many": Words(
        en="all members that are asked for are there, in their order, and others among them.",
        ko="필요한 원소가 순서대로 다 있지만 들어가면 안 되는 원소도 섞여 있습니다.",
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
    **TREES,
    **LINES,
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
        yield from _told(of_trees(form, answers, wanted))
    elif isinstance(form, Name | Command):
        yield from _of_stamps(answers, wanted) if isinstance(form, Name) else _of_lines(form, answers, wanted)
    elif type(form) in OF_FORM and all(form.read(answer) is not None for answer in answers):
        size = form.size if isinstance(form, Vector) else 4 if isinstance(form, Quaternion) else None
        rows = [(numbers_of(given, size), numbers_of(want, size)) for given, want in zip(answers, wanted, strict=True)]
        yield from _lost(form, rows)


def words_of_loss(name: str) -> Words | None:
    """Return what is said of a loss, and what is told of it; None if this is the name of none."""
    kind, _, told = name.partition(TOLD)
    if kind not in LOSSES:
        return None
    more = (told_of_a_tree if kind in TREES else told_of_a_line)(kind, told) if told else None
    words = LOSSES[kind]
    return Words(f"{words.en} {more.en}", f"{words.ko} {more.ko}") if more else words


def _told(rows: Iterator[tuple[str, str]]) -> Iterator[str]:
    yield from (kind + TOLD + told if told else kind for kind, told in rows)


def _lost(form: Form, rows: list[tuple[Numbers, Numbers]]) -> Iterator[str]:
    if None in sum(rows, ()):
        return
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
    if not any(None in pair for pair in pairs) and any(given for given, _ in pairs):
        yield from (name for name, fits in LISTS.items() if all(fits(given, want) for given, want in pairs))


def _is_within(few: list[str], many: list[str]) -> bool:
    """Return whether these members stand among those, in the same order."""
    rest = iter(many)
    return all(member in rest for member in few)


LISTS: dict[str, Callable[[list[str], list[str]], bool]] = {
    "other order": lambda given, want: given in (want, want[::-1]),
    "another order": lambda given, want: sorted(given) == sorted(want),
    "members twice": lambda given, want: list(dict.fromkeys(given)) == want,
    "members once": lambda given, want: list(dict.fromkeys(want)) == given,
    "members once, in another order": lambda given, want: sorted(set(want)) == sorted(given),
    "members missing": lambda given, want: _is_within(given, want),
    "members too many": lambda given, want: _is_within(want, given),
}


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


def _of_lines(form: Command, answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    given, right = form.read(answers[0]), None if sealed.is_sealed(wanted[0]) else form.read(wanted[0])
    if given and right and len(answers) == 1:
        lines = ([mark.value for mark in probes[0][0]] for probes in (given, right))
        typed = {word.removeprefix("/"): word for word in str(answers[0]).split()}  # a topic is read without its slash
        yield from _told((kind, re.sub(r"(?<=`)[^`,]+(?=`)", lambda word: typed.get(word[0], word[0]), told))
                         for kind, told in wrong_in(*lines))  # fmt: skip


def _of_stamps(answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    rows = [(stamp_of(answer), stamp_of(want)) for answer, want in zip(answers, wanted, strict=True)]
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


def stamp_of(plain: Plain) -> tuple[int, int] | None:
    """Return the seconds and nanoseconds of a stamp, None if this is none."""
    sec, nanosec = member(plain, "sec"), member(plain, "nanosec")
    return (sec, nanosec) if isinstance(sec, int) and isinstance(nanosec, int) else None


def time_of(plain: Plain) -> tuple[int, int] | None:
    """Return the seconds and nanoseconds of a Time, None if this is none."""
    held = plain.get("Time") if isinstance(plain, dict) else None
    return divmod(held[0], 10**9) if held else None
