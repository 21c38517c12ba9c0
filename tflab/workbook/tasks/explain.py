"""How did this wrong answer come about?  The simplest slips that give just it: one, or two, in the order of the work.

    answer --> one slip of the task?  one that any answer can have?  two slips?  a slip, and then a universal one?
    a dict --> the same for each part that is wrong, and what only follows from an earlier slip costs nothing

The combinations were computed when the cases were made (`cases.py`).  In the field:
a *bug library* whose bugs compose (BUGGY, DEBUGGY), searched by model tracing; what
follows from a slip is *error carried forward*.  A name is given only where the
whole of the answer, or of a part, is what that slip gives.  Read `verdict.py` next.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from ..answers import sealed
from ..answers.form import Form, inside
from ..answers.forms import Parts
from ..answers.values import Plain, is_raised
from ..words import Words
from .case import AND, Case, TaskCases, TwinWords
from .universal import UNIVERSAL, undone

__all__ = ["ANY_BUG", "Explanation", "explained"]

# A function that stops with one of these has some bug or other: nobody can say that it is this mistake.
ANY_BUG = {"AttributeError", "IndexError", "KeyError", "NameError", "NotImplementedError", "TypeError", "ValueError"}
AND_THEN = Words(en="Two things. First: {first} Then: {then}", ko="두 가지입니다. 먼저, {first} 다음으로, {then}")
UNIT = Words(en="right, if it were in {unit}.", ko="{unit} 단위라면 맞습니다.")
LOOK = Words(en="look again.", ko="다시 보십시오.")


class Explanation(NamedTuple):
    """How an answer came about.

    Attributes:
        slips: by name, the first in the work first, and what is said of each.
        said: what to say of them.
        follows: parts that are wrong only because of an earlier one.
    """

    slips: dict[str, TwinWords]
    said: Words
    follows: tuple[str, ...] = ()


def explained(
    task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain], rights: Sequence[list[bool]]
) -> Explanation | None:
    """Return how an answer came about, or None if nothing that is known gives it."""
    if isinstance(task.form, Parts) and not task.is_function:
        return _of_parts(task, task.form, cases[0], outcomes[0], rights[0])
    names = next(_ways(task, cases, outcomes), None)
    return Explanation({name: words_of(task, name) for name in names}, _said(task, names)) if names else None


def _ways(task: TaskCases, cases: Sequence[Case], outcomes: Sequence[Plain]) -> Iterator[tuple[str, ...]]:
    """Yield the combinations that give these outcomes, the simplest first."""
    gives = {name: [case.twins.get(name) for case in cases] for name in cases[0].twins}
    single = {name: row for name, row in gives.items() if AND not in name}
    double = {name: row for name, row in gives.items() if AND in name}
    yield from ((name,) for name, row in single.items() if _all_alike(task.form, outcomes, row))
    yield from ((name,) for name in _undone_to(task.form, outcomes, [case.expected for case in cases]))
    yield from (tuple(name.split(AND)) for name, row in double.items() if _all_alike(task.form, outcomes, row))
    yield from ((first, then) for first, row in single.items() for then in _undone_to(task.form, outcomes, row))


def _undone_to(form: Form, outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> Iterator[str]:
    """Yield the universal mistakes without which the outcomes would be what is wanted."""
    pairs = list(zip(outcomes, wanted, strict=True))
    values = [(given, want) for given, want in pairs if not is_raised(want)]
    if not values or not all(_alike(form, given, want) for given, want in pairs if is_raised(want)):
        return
    if _all_alike(form, outcomes, wanted):
        return
    made = dict.fromkeys(way[:2] for way in undone(form, values[0][0]))
    yield from (
        f"{name} {unit}".strip() for name, unit in made if all(_fits(form, name, unit, *pair) for pair in values)
    )


def _fits(form: Form, name: str, unit: str, given: Plain, wanted: Plain) -> bool:
    """Return whether an answer without this mistake, or one that looks the same with it, is what is wanted."""
    if _alike(form, given, wanted):
        return True
    return any(way[:2] == (name, unit) and _alike(form, way.left, wanted) for way in undone(form, given))


def _all_alike(form: Form, outcomes: Sequence[Plain], wanted: Sequence[Plain]) -> bool:
    return all(_alike(form, given, want) for given, want in zip(outcomes, wanted, strict=True))


def _alike(form: Form, given: Plain, wanted: Plain) -> bool:
    if isinstance(given, dict) and given.get("raises") in ANY_BUG:
        return False
    return all(_row(form, given, wanted))


def _row(form: Form, given: Plain, wanted: Plain) -> list[bool]:
    try:
        return sealed.judge(form, given, wanted)
    except ValueError:  # a mistake need not be of the form at all
        return [given == wanted]


# -- a dict of parts -------------------------------------------------------------------


class _Found(NamedTuple):
    """What explains some parts: the slips by name, what to say, and whether the rest of it shows, too."""

    slips: dict[str, TwinWords]
    said: Words
    parts: set[str]
    is_whole: bool = False


def _of_parts(task: TaskCases, form: Parts, case: Case, outcome: Plain, rights: list[bool]) -> Explanation | None:
    names = list(form.parts)
    if len(rights) != len(names) or not isinstance(inside(outcome), dict):
        return None
    wrong = {name for name, right in zip(names, rights, strict=True) if not right}
    left, found = set(wrong), []
    for slipped in _slips_in_parts(task, form, case, outcome, wrong):
        if slipped.parts <= left:
            found.append(slipped)
            left -= slipped.parts
    for number, name in enumerate(names):
        if name in left:
            found += _by_itself(task, form, case, outcome, number)
    left -= {name for cause in found for name in cause.parts}
    return _together(found, left, names) if found else None


def _together(found: list[_Found], left: set[str], names: list[str]) -> Explanation:
    """Return one explanation of what was found in several parts, and of those `left` that nothing explains."""
    found = sorted(found, key=lambda cause: min(map(names.index, cause.parts)))
    said = [cause.said if cause.parts == set(names) else _where(cause.said, cause.parts, names) for cause in found]
    said += [_where(LOOK, left, names)] if left else []
    slips = {name: words for cause in found for name, words in cause.slips.items()}
    follows = set() if left else {name for cause in found for name in _follows(cause)}
    return Explanation(slips, Words(*(" ".join(row) for row in zip(*said, strict=True))), tuple(sorted(follows)))


def _follows(found: _Found) -> set[str]:
    """Return the parts that are wrong only because of a slip in another part."""
    made_in = {words.part for words in found.slips.values()} - {""}
    return found.parts - made_in if found.is_whole and made_in & found.parts else set()


def _by_itself(task: TaskCases, form: Parts, case: Case, outcome: Plain, number: int) -> Iterator[_Found]:
    """Yield what explains one part alone: what its option would mean, or a mistake that any answer can have."""
    name = list(form.parts)[number]
    answer, want = inside(outcome).get(name), sealed.part_of(case.expected, number, name)
    words = _choice(task, name, answer)
    if words is not None:
        yield _Found({f"{name}: {answer}": TwinWords(words, "")}, words, {name})
        return
    words = form.parts[name].remark(answer, inside(outcome))
    if words is not None:
        yield _Found({f"{name}: no proof": TwinWords(words, "")}, words, {name})
        return
    for way in _undone_to(form.parts[name], [answer], [want]):
        yield _Found({way: words_of(task, way)}, words_of(task, way).reply, {name})
        return


def _slips_in_parts(task: TaskCases, form: Parts, case: Case, outcome: Plain, wrong: set[str]) -> list[_Found]:
    """Return what slips explain, most parts and fewest slips first."""
    found = []
    for key, twin in case.twins.items():
        row = _row(form, outcome, twin)
        if len(row) != len(form.parts):
            continue
        alike = {name for name, same in zip(form.parts, row, strict=True) if same} & wrong
        changed = _changed(form, twin, case.expected)
        slips = {name: words_of(task, name) for name in key.split(AND)}
        if changed and changed <= alike:
            found.append(_Found(slips, _said(task, list(slips)), changed, is_whole=True))
        elif all(words.partly for words in slips.values()) and alike & changed:
            found.append(_Found(slips, _said(task, list(slips)), alike & changed))
    return sorted(found, key=lambda cause: (-len(cause.parts), len(cause.slips), not cause.is_whole))


def _changed(form: Parts, twin: Plain, expected: Plain) -> set[str]:
    """Return the parts in which a mistake gives something else than what is right."""
    changed = set()
    for number, (name, part) in enumerate(form.parts.items()):
        given, wanted = sealed.part_of(twin, number, name), sealed.part_of(expected, number, name)
        if not (given == wanted if sealed.is_sealed(wanted) else part.alike(given, wanted)):
            changed.add(name)
    return changed


def _choice(task: TaskCases, part: str, answer: Plain) -> Words | None:
    """Return what an option would mean, and what the part shows: why one is not the other."""
    means = task.means.get(answer) if isinstance(answer, str) else None
    shows = task.shows.get(part)
    if means is None and shows is None:
        return None
    return Words(*(" ".join(row) for row in zip(*filter(None, (means, shows)), strict=True)))


# -- words ------------------------------------------------------------------------------


def _said(task: TaskCases, names: Sequence[str]) -> Words:
    said = [words_of(task, name).reply for name in names]
    if len(said) == 1:
        return said[0]
    first, then = said
    return Words(AND_THEN.say("en", first=first.en, then=then.en), AND_THEN.say("ko", first=first.ko, then=then.ko))


def words_of(task: TaskCases, name: str) -> TwinWords:
    """Return what is said of a slip, the task's or one that any answer can have, and what is behind it."""
    if name in task.twins:
        return task.twins[name]
    if name.startswith("unit "):
        unit = name.removeprefix("unit ")
        return TwinWords(Words(UNIT.say("en", unit=unit), UNIT.say("ko", unit=unit)), "")
    return TwinWords(UNIVERSAL[name].reply, UNIVERSAL[name].misconception)


def _where(words: Words, parts: set[str], names: Sequence[str]) -> Words:
    """Say in which parts it is."""
    where = ", ".join(f'"{name}"' for name in names if name in parts)
    return Words(f"{where}: {words.en}", f"{where}: {words.ko}")
