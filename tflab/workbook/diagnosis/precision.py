"""Recognise lost information in an answer: rounded digits, zeros, missing members, another order."""

from __future__ import annotations

import json
import math
import re
from collections import Counter
from collections.abc import Callable, Iterator

from ...text import Text, Texts
from ..answers.form import Row as Marks
from ..answers.form import inside, member
from ..answers.forms import Angle, Command, Form, Number, Quaternion, Sequence, Set
from ..answers.members import members_of
from ..answers.values import Plain, is_raised
from . import command_lines, trees
from .generic import TOLD, Recogniser, holds_angles

__all__ = ["LISTS", "LOST", "TEXTS", "describe_loss"]

TEXTS = Texts(__file__)

Numbers = tuple[float, ...]
Rows = list[tuple[Numbers, Numbers]]  # of each call: what is given, and what is wanted

TOO_MANY = ("members twice", "members too many")
MOST_TOLD = 3
BRACES = re.compile(r"(?<!\$)\{[A-Za-z_][^{}:\"\s]*(?:\s[-+*/]\s?[^{}:\"\s]+)*(?::(?:[.\d]*[a-z]|\.\d+))?\}")


def describe_loss(name: str) -> Text | None:
    """Return what is said of a loss, and what is told of it; None if this is the name of none."""
    kind, _, told = name.partition(TOLD)
    if kind == "nothing filled in":
        return TEXTS[kind].filled(text=told)
    if kind in TEXTS:
        return Text.joined(TEXTS[kind], TEXTS["shows_at"].filled(told=told) if told else None)
    for texts, explain in ((trees.TEXTS, trees.describe_tree), (command_lines.TEXTS, command_lines.describe_line)):
        if kind in texts:
            return Text.joined(texts[kind], explain(kind, told) if told else None)
    return None


def _with_details(rows: Iterator[tuple[str, str]]) -> Iterator[str]:
    yield from (kind + TOLD + told if told else kind for kind, told in rows)


def _unfilled(_form: Form, answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    """Yield the first text in whose braces nothing was filled in, where the right answer has no braces."""
    for answer, want in zip(answers, wanted, strict=True):
        found = next(filter(None, map(BRACES.search, _texts_in(answer))), None)
        if found and not any(map(BRACES.search, _texts_in(want))):
            yield f"nothing filled in{TOLD}{found[0]}"
            return


def _texts_in(plain: Plain) -> Iterator[str]:
    if isinstance(plain, str):
        yield plain
    elif isinstance(plain, list | dict) and not is_raised(plain):
        members = [*plain, *plain.values()] if isinstance(plain, dict) else plain
        yield from (text for member in members for text in _texts_in(member))


# -- numbers --------------------------------------------------------------------------------


def _rows(look: Callable[[Form, Rows], Iterator[str]]) -> Callable[[Form, list[Plain], list[Plain]], Iterator[str]]:
    """Return what looks at the numbers of all answers, each beside those that are wanted."""

    def find(form: Form, answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
        rows = [(form.numbers(given), form.numbers(want)) for given, want in zip(answers, wanted, strict=True)]
        if None not in sum(rows, ()) and all(form.read(answer) is not None for answer in answers):
            yield from look(form, rows)

    return find


def _zeros(form: Form, rows: Rows) -> Iterator[str]:
    """Yield that all numbers are 0, or all that are wrong, each place in all rows."""
    is_empty = not any(any(given) for given, _ in rows)
    if isinstance(form, Number | Angle):
        yield from ["zero"] * is_empty
    elif _left_at_zero(rows, form.tolerance):
        yield "empty" if is_empty else "left at zero"


def _counts(form: Form, rows: Rows) -> Iterator[str]:
    off = {given - want for (given,), (want,) in rows}
    if not form.unit and len(rows) > 1 and off in ({1}, {-1}):
        yield "one too many" if off == {1} else "one too few"


def _signs(form: Form, rows: Rows) -> Iterator[str]:
    pairs = [(given, want) for (given,), (want,) in rows]
    sizes_fit = all(abs(abs(given) - abs(want)) <= form.tolerance for given, want in pairs)
    wanted = [want for _, want in pairs]
    if sizes_fit and min(wanted) < 0 < max(wanted) and all(given >= 0 for given, _ in pairs):
        yield "no sign"


def _w_left(form: Form, rows: Rows) -> Iterator[str]:
    """Yield that x, y and z are right, and w is 1, as in a new message."""
    axes = [(given[:3], want[:3]) for given, want in rows]
    if all(given[3] == 1.0 for given, _ in rows) and all(any(a) and _is_near(a, b, form.tolerance) for a, b in axes):
        yield "w left at 1"


def _is_near(given: Numbers, wanted: Numbers, tolerance: float) -> bool:
    """Return whether numbers are those wanted, or all of them with the other sign."""
    return any(all(abs(a - sign * b) <= tolerance for a, b in zip(given, wanted, strict=True)) for sign in (1, -1))


def _angles(_form: Form, rows: Rows) -> Iterator[str]:
    if all(holds_angles(*row) for row in rows):
        yield "angles for a quaternion"


def _left_at_zero(rows: Rows, tolerance: float) -> bool:
    """Return whether each place is right in all rows, or 0 in all of them."""
    places = zip(*(zip(*row, strict=True) for row in rows), strict=True)
    return all(
        not any(number for number, _ in pairs) or all(abs(number - want) <= tolerance for number, want in pairs)
        for pairs in map(list, places)
    )


def _all_rounded(form: Form, rows: Rows) -> Iterator[str]:
    """Yield that all were rounded to as many digits; in a quaternion 0 and 1 are near everything.

    One number alone has to have two digits, and not to be cut: else it is near to too many.
    """
    is_alone = isinstance(form, Number) and len(rows) == 1
    is_empty = not any(any(given) for given, _ in rows)
    if is_empty or (is_alone and len(f"{rows[0][0][0]:g}".replace(".", "").strip("-0")) < 2):
        return
    places = range(1 if isinstance(form, Quaternion) else -2 if is_alone else 0, 4)
    if any(all(_rounded(*row, digits, not is_alone) for row in rows) for digits in places):
        yield "rounded"


def _rounded(given: Numbers, wanted: Numbers, digits: int, or_cut: bool) -> bool:
    """Return whether each number was rounded to so many digits, up or down from a half, or cut there."""
    half, step = 0.5 * 10.0**-digits, 10**digits
    return all(
        abs(number * step - round(number * step)) < 1e-6
        and (abs(number - want) <= half + 1e-9 or (or_cut and abs(number - math.trunc(want * step) / step) < 1e-9))
        for number, want in zip(given, wanted, strict=True)
    )


# -- lists, sets and lines ------------------------------------------------------------------


def _compare_lists(form: Sequence, answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    """Yield what is wrong with all of these lists, and the members of the first in which it shows."""
    pairs = [(_ways(form, answer), _ways(form, want)) for answer, want in zip(answers, wanted, strict=True)]
    if any(None in pair for pair in pairs) or not any(given for given, _ in pairs):
        return
    place = next((place for place, (given, want) in enumerate(pairs) if given != want), 0)
    ends = ENDS if len(pairs) > 1 and max(len(want) for _, want in pairs) > 2 else {}
    for name, fits in (ends | LISTS).items():
        if all(fits(given, want) for given, want in pairs):
            yield name + (_too_many(answers[place], *pairs[place]) if name in TOO_MANY else "")


def _too_many(answer: Plain, given: list[str], want: list[str]) -> str:
    """Return the members of a list that nobody asked for, or not so often, as they are written; nothing of others."""
    lacking, found = Counter(want), []
    for plain, text in zip(inside(answer), given, strict=True):
        lacking[text] -= 1
        if lacking[text] < 0:
            found.append(_written(plain))
    return TOLD + ", ".join(list(dict.fromkeys(found))[:MOST_TOLD]) if found and all(found) else ""


def _written(plain: Plain) -> str:
    """Return a member as it is written in Python: a word, or words that belong together; nothing of anything else."""
    held = inside(plain)
    if isinstance(held, str):
        return f'"{held}"'
    is_row = isinstance(held, list) and all(isinstance(one, str) for one in held)
    return "(" + ", ".join(f'"{one}"' for one in held) + ")" if is_row else ""


def _is_within(few: list[str], many: list[str]) -> bool:
    """Return whether these members stand among those, in the same order."""
    rest = iter(many)
    return all(member in rest for member in few)


def _row(member: str) -> list[float | str]:
    """Return the numbers and words of a member, the first of its ways; `member` is the JSON that `_ways` wrote."""
    return next(iter(json.loads(member)), [])


ENDS: dict[str, Callable[[list[str], list[str]], bool]] = {  # of a function: one list may miss anything
    "first alone": lambda given, want: given == want[:1],
    "last alone": lambda given, want: given == want[-1:],
    "all but the last": lambda given, want: given == want[:-1],
    "all but the first": lambda given, want: given == want[1:],
}
LISTS: dict[str, Callable[[list[str], list[str]], bool]] = {
    "other order": lambda given, want: given in (want, want[::-1]),
    "unsorted": lambda given, want: want == sorted(want, key=_row) == sorted(given, key=_row),
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
    if not isinstance(held, list):
        return None
    read = [form.of.read(one) for one in held]
    return None if None in read else [json.dumps([_plain(row) for probe in probes for row in probe]) for probes in read]


def _plain(row: Marks) -> list[float | str]:
    return [mark.value if isinstance(mark.value, str) else round(mark.value, 9) + 0.0 for mark in row]


def _held_twice(form: Set, answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    """Yield that answers are right once each of their members counts once, or right as they are."""
    rows = [(members_of(answer), want) for answer, want in zip(answers, wanted, strict=True)]
    if form.once and all(members is not None and Set(form.of).same(members, want) for members, want in rows):
        yield "members twice"


def _compare_lines(form: Command, answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    given, right = form.read(answers[0]), form.read(wanted[0])
    if given and right and len(answers) == 1:
        lines = ([mark.value for mark in probes[0][0]] for probes in (given, right))
        typed = {word.removeprefix("/"): word for word in str(answers[0]).split()}  # a topic is read without its slash
        yield from _with_details((kind, re.sub(r"(?<=`)[^`,]+(?=`)", lambda word: typed.get(word[0], word[0]), told))
                         for kind, told in command_lines.wrong_in(*lines))  # fmt: skip


def _compare_stamps(_form: Form, answers: list[Plain], wanted: list[Plain]) -> Iterator[str]:
    rows = [(_stamp_of(answer), _stamp_of(want)) for answer, want in zip(answers, wanted, strict=True)]
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


def _stamp_of(plain: Plain) -> tuple[int, int] | None:
    """Return the seconds and nanoseconds of a stamp, None if this is none."""
    sec, nanosec = member(plain, "sec"), member(plain, "nanosec")
    return (sec, nanosec) if isinstance(sec, int) and isinstance(nanosec, int) else None


def _empty(_form: Form, answers: list[Plain], _wanted: list[Plain]) -> Iterator[str]:
    if answers == [""] * len(answers):
        yield "empty"


LOST = {
    "nothing filled in": Recogniser(find=_unfilled, is_plain=True),
    "empty": Recogniser(find=_empty),
    "zeros": Recogniser(find=_rows(_zeros)),
    "count": Recogniser(find=_rows(_counts)),
    "no sign": Recogniser(find=_rows(_signs)),
    "w left at 1": Recogniser(find=_rows(_w_left)),
    "angles for a quaternion": Recogniser(find=_rows(_angles)),
    "rounded": Recogniser(find=_rows(_all_rounded)),
    "list": Recogniser(find=_compare_lists),
    "members twice": Recogniser(find=_held_twice),
    "tree": Recogniser(find=lambda _, answers, wanted: _with_details(trees.compare_trees(answers, wanted))),
    "line": Recogniser(find=_compare_lines),
    "stamp": Recogniser(find=_compare_stamps),
}
