"""Are these outcomes just what a mistake gives?  In every case, or in some while the others are right.

    outcomes   [-1.5, 2.0, 0.0]
    expected   [ 1.5, 2.0, 0.0]     "sign"?  not in all: without it, 2.0 would be -2.0
                                    "sign, in some": yes, and that is said

A name is given only where it explains all that is wrong, and where what is right would
be right with it, too.  Read `certain.py` next.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..answers import sealed
from ..answers.form import Form, inside, member, numbers_of
from ..answers.forms import Message, Name, Number, Parts, Quaternion, Vector
from ..answers.values import Plain, is_raised
from ..words import Words
from .case import TaskCases, TwinWords
from .universal import PLAIN_TO_SEE, UNIVERSAL, by_comparison, undone

__all__ = [
    "ANY_BUG",
    "IN_SOME",
    "alike",
    "all_alike",
    "in_some",
    "row_of",
    "section",
    "sections",
    "undone_to",
    "words_of",
]

# A function that stops with one of these has some bug or other: nobody can say that it is this mistake.
ANY_BUG = {"AttributeError", "IndexError", "KeyError", "NameError", "NotImplementedError", "TypeError", "ValueError"}
UNIT = Words(en="right, if it were in {unit}.", ko="{unit} 단위라면 맞습니다.")
GIVEN = Words(en="this is `{name}` as it was given, unchanged.", ko="주어진 `{name}`의 값 그대로입니다.")
SOME = Words(
    en="In some calls, not in all: {said} What do these calls have in common?",
    ko="모든 호출이 아니라 일부에서 그렇습니다. {said} 이 호출들의 공통점은 무엇입니까?",
)
IN_SOME = "in some: "


def row_of(form: Form, given: Plain, wanted: Plain) -> list[bool]:
    """Return for each probe of `wanted` whether `given` has it; either may be anything."""
    try:
        return sealed.judge(form, given, wanted)
    except ValueError:  # a mistake need not be of the form at all
        return [given == wanted]


def alike(form: Form, given: Plain, wanted: Plain) -> bool:
    """Return whether an outcome is what is wanted, and not some bug that looks like it."""
    if isinstance(given, dict) and given.get("raises") in ANY_BUG:
        return False
    return all(row_of(form, given, wanted))


def all_alike(form: Form, outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> bool:
    """Return whether all outcomes are what is wanted."""
    return all(alike(form, given, want) for given, want in zip(outcomes, wanted, strict=True))


def undone_to(
    form: Form, outcomes: Sequence[Plain], wanted: Sequence[Plain], *, only_plain_to_see: bool = False
) -> Iterator[str]:
    """Yield the universal mistakes without which the outcomes would be what is wanted."""
    values = _values(form, outcomes, wanted)
    wrong = next((given for given, want in values if not alike(form, given, want)), None)
    if wrong is None:
        return
    for name, unit in dict.fromkeys(way[:2] for way in undone(form, wrong)):
        if only_plain_to_see and name not in PLAIN_TO_SEE:
            continue
        if all(_fits(form, name, unit, *pair) for pair in values):
            yield f"{name} {unit}".strip()
    if not only_plain_to_see:
        yield from by_comparison(form, *map(list, zip(*values, strict=True)))


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
    if 0 < len(wrong) < len(outcomes) and not any(is_raised(want) for _, want in wrong):
        yield from (IN_SOME + name for name in undone_to(form, *map(list, zip(*wrong, strict=True))))


def _fits(form: Form, name: str, unit: str, given: Plain, wanted: Plain) -> bool:
    """Return whether an answer without this mistake is what is wanted; what cannot have it has to be right."""
    ways = [way.left for way in undone(form, given) if way[:2] == (name, unit)]
    return any(alike(form, left, wanted) for left in ways) if ways else alike(form, given, wanted)


def words_of(task: TaskCases, name: str) -> TwinWords:
    """Return what is said of a slip, the task's or one that any answer can have, and what is behind it."""
    if name in task.twins:
        return task.twins[name]
    if name.startswith(IN_SOME):
        words = words_of(task, name.removeprefix(IN_SOME))
        said = Words(SOME.say("en", said=words.reply.en), SOME.say("ko", said=words.reply.ko))
        return TwinWords(said, words.misconception)
    for start, words in (("unit ", UNIT), ("given ", GIVEN)):
        if name.startswith(start):
            rest = name.removeprefix(start)
            return TwinWords(Words(*(words.say(tongue, unit=rest, name=rest) for tongue in ("en", "ko"))), "")
    return TwinWords(UNIVERSAL[name].reply, UNIVERSAL[name].misconception)


# -- parts of a dict, fields of a message -------------------------------------------------


def sections(form: Form, like: Plain) -> dict[str, Form]:
    """Return the parts of an answer that are judged each on its own; of a message its fields, as `like` has them."""
    if isinstance(form, Parts):
        return dict(form.parts)
    if isinstance(form, Message):
        held = {path: section(form, like, number, path) for number, path in enumerate(form.fields)}
        return {path: _form_of_field(path, field, form.tolerance) for path, field in held.items()}
    return {}


def section(form: Form, plain: Plain, number: int, name: str) -> Plain:
    """Return one of an answer's parts, the `number`th; of something else, None."""
    if sealed.is_sealed(plain) or isinstance(form, Parts):
        held = inside(plain)
        return sealed.part_of(plain, number, name) if sealed.is_sealed(plain) or isinstance(held, dict) else None
    return member(plain, *name.split("."))


def _form_of_field(path: str, held: Plain, tolerance: float) -> Form:
    """Return the form of a message's field: its numbers are metres, its rotation a quaternion, its texts words."""
    if numbers_of(held, 4) is not None or path.endswith("rotation"):
        return Quaternion(tolerance)
    if numbers_of(held, 3) is not None or path.endswith(("translation", "point", "position")):
        return Vector(3, "m", "", tolerance)
    return Number("", tolerance) if numbers_of(held, None) is not None else Name()
