"""Compare outcomes with what a mistake gives, and name the mistake."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from ...text import Texts
from ..answers.form import Form, inside
from ..answers.forms import Number, Parts, Vector
from ..answers.forms import Sequence as ListForm
from ..answers.values import Plain, is_raised
from ..tasks.case_types import Feedback, TaskCases
from . import generic
from .generic import TOLD, UNDONE, Recogniser, describe_letters
from .precision import LOST, describe_loss

__all__ = [
    "ANY_BUG",
    "IN_SOME",
    "RECOGNISERS",
    "alike",
    "all_alike",
    "expand_lists",
    "feedback_of",
    "in_some",
    "matches_closely",
    "matching_corrections",
    "row_of",
]

TEXTS = Texts(__file__)

RECOGNISERS: dict[str, Recogniser] = UNDONE | LOST  # by the names that forms have for them

NEVER = Recogniser()  # `wrong_types.py` recognises an answer of another type

# A function that stops with one of these has some bug or other: nobody can say that it is this mistake.
ANY_BUG = {"AttributeError", "IndexError", "KeyError", "NameError", "NotImplementedError", "TypeError", "ValueError"}
IN_SOME = "in some: "
FITS_WHAT_IS_RIGHT = {"places and signs"}  # any order and signs, as they are, too: where some is right, it is not so
ONE, TWO = 0.1, 0.005  # how far from what one mistake, or two, give: the more there are, the sooner one fits by chance
A_HAIR = 1e-6  # how far, as a share, a number that was not rounded is from what gives it
COMPUTED = 1e-4  # the same of a number that was not rounded: it is what was done, and little else


def row_of(form: Form, given: Plain, wanted: Plain) -> list[bool]:
    """Return for each probe of `wanted` whether `given` has it; either may be anything."""
    if is_raised(wanted):
        return form.judge(given, wanted)
    read = form.read(wanted)
    if read is None or not all(read):  # a mistake need not be of the form at all, nor all of its members
        return [given == wanted]
    return form.has(given, read)


def alike(form: Form, given: Plain, wanted: Plain) -> bool:
    """Return whether an outcome is what is wanted, and not some bug that looks like it."""
    if isinstance(given, dict) and given.get("raises") in ANY_BUG:
        return False
    return all(row_of(form, given, wanted))


def all_alike(form: Form, outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> bool:
    """Return whether all outcomes are what is wanted."""
    return all(alike(form, given, want) for given, want in zip(outcomes, wanted, strict=True))


def matches_closely(form: Form, outcomes: Sequence[Plain], answers: Sequence[Plain], share: float = ONE) -> bool:
    """Return whether all outcomes are what a mistake gives, and not only by a tolerance that is wide beside them."""
    return all_alike(form, outcomes, answers) and all(
        _is_near(form, *pair, share) for pair in zip(outcomes, answers, strict=True)
    )


def _is_near(form: Form, given: Plain, wanted: Plain, share: float) -> bool:
    if isinstance(form, Parts):
        rows = [(part, form.part_of(given, name), form.part_of(wanted, name))
                for name, part in form.parts.items()]  # fmt: skip
        return all(_is_near(*row, share) for row in rows)
    if not isinstance(form, Number | Vector):
        return True
    one, other = form.numbers(given), form.numbers(wanted)
    if one is None or other is None:
        return True
    size = math.hypot(*other)
    share = A_HAIR if form.is_short(given) else share
    closest = [max(10.0 ** -_decimals(number), COMPUTED * size) + 1e-9 for number in one]
    is_close = all(abs(a - b) <= allowed for a, b, allowed in zip(one, other, closest, strict=True))
    return is_close and math.dist(one, other) <= share * size + 1e-9


def _decimals(number: float) -> int:
    """Return to how many digits behind its point a number is written: the more, the closer a mistake has to fit."""
    return len(f"{number:.9f}".rstrip("0").partition(".")[2])


def matching_corrections(
    form: Form, outcomes: Sequence[Plain], wanted: Sequence[Plain], *, only_plain_to_see: bool = False
) -> Iterator[str]:
    """Yield the mistakes which the form recognises in the outcomes, each the only difference from what is wanted."""
    values = _values(form, outcomes, wanted)
    wrong = next((given for given, want in values if not alike(form, given, want)), None)
    if wrong is None:
        return
    is_short = len(values) == 1 and form.is_short(wrong)
    is_some_right = any(alike(form, given, want) for given, want in values)
    columns = list(map(list, zip(*values, strict=True)))
    for name in form.mistakes:
        one = RECOGNISERS.get(name, NEVER)
        if only_plain_to_see > one.is_plain or (is_some_right and name in FITS_WHAT_IS_RIGHT):
            continue
        if one.find is not None:
            yield from one.find(form, *columns)
        elif one.undo is not None and is_short <= one.is_exact:
            yield from _undoing(form, name, wrong, values)


def _undoing(form: Form, name: str, wrong: Plain, values: Sequence[tuple[Plain, Plain]]) -> Iterator[str]:
    """Yield a mistake, and what is told of it, without which all of these answers would be what is wanted."""
    found = dict.fromkeys(told for told, _ in RECOGNISERS[name].undo(form, wrong))
    yield from (name + told for told in found if all(_undoes(form, RECOGNISERS[name], told, *pair) for pair in values))


def _values(form: Form, outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> list[tuple[Plain, Plain]]:
    """Return each outcome with the value that is wanted; none of them if an exception is wanted and did not come."""
    pairs = list(zip(outcomes, wanted, strict=True))
    if not all(alike(form, given, want) for given, want in pairs if is_raised(want)):
        return []
    return [(given, want) for given, want in pairs if not is_raised(want)]


def in_some(form: Form, outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> Iterator[str]:
    """Yield the universal mistakes that explain all that is wrong, while other outcomes are right without them."""
    wrong = [
        (given, want)
        for given, want in zip(outcomes, wanted, strict=True)
        if is_raised(want) or not alike(form, given, want)
    ]
    if not form.is_measured or (isinstance(form, Number) and not form.unit):
        return
    if 0 < len(wrong) < len(outcomes) and not any(is_raised(want) for _, want in wrong):
        names = matching_corrections(form, *map(list, zip(*wrong, strict=True)))
        yield from (IN_SOME + name for name in names if len(wrong) > 1 or name != "rounded")  # one is round by chance


def _undoes(form: Form, one: Recogniser, told: str, given: Plain, wanted: Plain) -> bool:
    """Return whether an answer without this mistake is what is wanted; what cannot have it has to be right."""
    corrected = [left for detail, left in one.undo(form, given) if detail == told]
    same = all_alike if one.is_exact and not form.is_short(given) else matches_closely  # in another unit it would pass
    return any(same(form, [left], [wanted]) for left in corrected) if corrected else alike(form, given, wanted)


def feedback_of(task: TaskCases, name: str) -> Feedback:
    """Return what is said of a mistake, the task's or one that any answer can have, and what is behind it."""
    if name in task.feedback:
        return task.feedback[name]
    if name.startswith(IN_SOME):
        words = feedback_of(task, name.removeprefix(IN_SOME))
        return Feedback(TEXTS["some"].filled(said=words.reply), words.misconception)
    for start, words in (("unit ", TEXTS["unit"]), ("given ", TEXTS["given"]), ("by ", TEXTS["by"])):
        if name.startswith(start):
            rest = name.removeprefix(start)
            return Feedback(words.filled(unit=rest, name=rest), "")
    kind, _, told = name.partition(TOLD)
    words = describe_loss(name) or describe_letters(kind, told) or generic.TEXTS[kind]
    return Feedback(words, RECOGNISERS[kind].misconception if kind in RECOGNISERS else "")


def expand_lists(form: Form, parts: dict[str, Form], answers: Sequence[Plain]) -> dict[str, Form]:
    """Return the same parts, with each member of a list a part of its own, where all answers have as many."""
    found: dict[str, Form] = {}
    for name, part in parts.items():
        lists = [inside(form.part_of(answer, name)) for answer in answers]
        lengths = {len(held) if isinstance(held, list) else None for held in lists}
        is_split = isinstance(form, Parts) and isinstance(part, ListForm) and len(lengths) == 1 and None not in lengths
        found |= {f"{name}[{place}]": part.of for place in range(len(lists[0]))} if is_split else {name: part}
    return found
