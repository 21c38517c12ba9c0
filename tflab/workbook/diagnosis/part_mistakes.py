"""Find the mistakes of a task that explain some parts of an answer, and what follows from them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import combinations
from typing import NamedTuple

from ...text import Texts
from ..answers.form import Form, numbers_of
from ..answers.forms import Angle, Message, Number, Parts
from ..answers.values import Plain, is_raised
from ..tasks.case_types import AND, Case, Feedback, TaskCases
from .explanation import PartFound, describe, without_overlaps
from .matching import ONE, TWO, alike, feedback_of, matches_closely, matching_corrections

__all__ = ["Table", "consequence_of", "followers", "is_something", "mistakes_in_parts", "only_follows"]

TEXTS = Texts(__file__)

LABELS = ("header.", "child_frame_id")  # fields of a message that say what its numbers are


class Table(NamedTuple):
    """An answer by its parts: the form of each, what came out in each case, what was wanted, and the arguments."""

    forms: dict[str, Form]
    given: dict[str, list[Plain]]
    wanted: dict[str, list[Plain]]
    args: list[list[Plain]]


def mistakes_in_parts(
    task: TaskCases, table: Table, cases: Sequence[Case], wrong: set[str], given: dict[str, Plain] | None
) -> list[PartFound]:
    """Return what mistakes explain, most parts and fewest mistakes first; pairs, unless one or two explain all."""
    single = {name: [case.wrong[name] for case in cases] for name in cases[0].wrong}
    found = _in_order(_causes(task, table, cases, wrong, single))
    if task.pairs is None or _is_explained(found, wrong):
        return found
    both = _causes(task, table, cases, wrong, _pairs(task, table, cases, wrong, given))
    return _in_order(found + [cause for cause in (_without_others(cause, found) for cause in both) if cause.parts])


def _without_others(cause: PartFound, found: Sequence[PartFound]) -> PartFound:
    """Return a mistake that several pairs share without the parts that another one explains alone."""
    if len(cause.mistakes) > 1:
        return cause
    others = [
        other.parts for other in found if len(other.mistakes) == 1 and other.mistakes.keys() != cause.mistakes.keys()
    ]
    return cause._replace(parts=cause.parts.difference(*others))


def _in_order(found: list[PartFound]) -> list[PartFound]:
    return sorted(_held_together(found), key=lambda cause: (-len(cause.parts), len(cause.mistakes), not cause.is_whole))


def _is_explained(found: list[PartFound], wrong: set[str]) -> bool:
    """Return whether one or two mistakes explain all wrong parts."""
    causes = without_overlaps(found, wrong)
    return wrong <= set().union(*(cause.parts for cause in causes)) and len(causes) <= 2


def _pairs(
    task: TaskCases, table: Table, cases: Sequence[Case], wrong: set[str], given: dict[str, Plain] | None
) -> dict[str, list[Plain]]:
    """Return what those two mistakes give, case by case, that give one of the wrong parts at least."""
    assert task.pairs is not None
    parts = [name for name in table.forms if name in wrong]

    def reproduced_by(case: int, value: Plain) -> list[str]:
        if is_raised(value):
            return []
        return [
            name
            for name in parts
            if not (len(cases) == 1 and table.forms[name].is_short(table.given[name][0]))
            and matches_closely(table.forms[name], [table.given[name][case]], [task.form.part_of(value, name)], TWO)
        ]

    def is_right(case: int) -> bool:
        return all(alike(table.forms[name], table.given[name][case], table.wanted[name][case]) for name in parts)

    return task.pairs.matching(cases, sorted(range(len(cases)), key=is_right), reproduced_by, given)


def _causes(
    task: TaskCases, table: Table, cases: Sequence[Case], wrong: set[str], rows: dict[str, list[Plain]]
) -> list[PartFound]:
    """Return what each mistake, or each two, explain of the wrong parts."""
    found = []
    for key, answers in rows.items():
        mistakes = {name: feedback_of(task, name) for name in key.split(AND)}
        changed, same = _shown(task.form, table, answers, TWO if AND in key else ONE)
        same = _explain_whole_lists(same, changed)
        if changed and changed <= same & wrong:
            found.append(PartFound(mistakes, describe(task, list(mistakes)), changed, is_whole=True))
        elif same & changed & wrong and all(_is_partly(task.form, table, cases, *row) for row in mistakes.items()):
            found.append(PartFound(mistakes, describe(task, list(mistakes)), same & changed & wrong))
        elif len(mistakes) == 1 and (made_in := mistakes[key].part) in same & changed & wrong:
            found.append(PartFound(mistakes, describe(task, list(mistakes)), {made_in}))
        elif len(mistakes) == 1:
            found += _explain_one_mistake(task.form, table, key, mistakes[key], changed, same & wrong, wrong)
    return found


def _explain_whole_lists(same: set[str], changed: set[str]) -> set[str]:
    """Return the parts without members of lists of which another member is not what the mistake gives."""
    others = {name.partition("[")[0] for name in changed - same if "[" in name}
    return {name for name in same if name.partition("[")[0] not in others}


def _is_partly(form: Form, table: Table, cases: Sequence[Case], name: str, words: Feedback) -> bool:
    """Return whether a mistake's reply is true of some parts alone: it says so, or it shows in a single one anyway."""
    return words.partly or (
        bool(words.part) and _shown(form, table, [case.wrong.get(name) for case in cases], ONE)[0] == {words.part}
    )


def _held_together(found: list[PartFound]) -> list[PartFound]:
    return [cause for cause in found if len(cause.mistakes) == 1 or not _falls_apart(cause, found)]


def _explain_one_mistake(
    form: Form,
    table: Table,
    name: str,
    words: Feedback,
    changed: set[str],
    same: set[str],
    wrong: set[str],
) -> list[PartFound]:
    """Return what a mistake explains whose labels were corrected by hand, or that was made in another part."""
    values = {part for part in changed if not part.startswith(LABELS)}
    same = _more_than_zero(table, same)
    if isinstance(form, Message) and values and values <= same:
        return [PartFound({name: words}, words.reply, values)]
    made_in, follow = words.part, {part for part in changed & same if table.forms[part].is_measured}
    if not isinstance(form, Parts) or not made_in or not follow or made_in in wrong or made_in not in changed:
        return []
    return [PartFound({name: words}, TEXTS["follows"].filled(part=made_in, said=words.reply), follow)]


def _falls_apart(both: PartFound, found: Sequence[PartFound]) -> bool:
    """Return whether each of two mistakes, and no other, explains parts of its own: then each is said of those."""
    single = [cause for cause in found if len(cause.mistakes) == 1]
    alone = [cause.parts for cause in single if cause.mistakes.keys() <= both.mistakes.keys()]
    if len(alone) < len(both.mistakes) or set.intersection(*alone) or not both.parts <= set.union(*alone):
        return False
    return all(sum(cause.parts == parts for cause in single) == 1 for parts in alone)


def _shown(form: Form, table: Table, answers: Sequence[Plain], share: float) -> tuple[set[str], set[str]]:
    """Return in which parts a mistake gives something else than what is right, and in which it gives what came out."""
    changed: set[str] = set()
    same: set[str] = set()
    if any(map(is_raised, answers)) or any(answer is None for answer in answers):
        return changed, same
    for name, part in table.forms.items():
        row = [form.part_of(answer, name) for answer in answers]
        if not all(map(part.alike, row, table.wanted[name])):
            changed.add(name)
        if matches_closely(part, table.given[name], row, share):
            same.add(name)
    return changed, same


def _more_than_zero(table: Table, parts: set[str]) -> set[str]:
    """Return those of the parts in which something else than zeros was given, which many mistakes come to."""
    return {part for part in parts if any(is_something(table.forms[part], value) for value in table.given[part])}


def is_something(form: Form, value: Plain) -> bool:
    """Return whether a value is more than zeros, which many answers are."""
    row = form.numbers(value)
    return row is None or any(row)


CLOSE = 1e-7  # as a share
JOINED: tuple[Callable[[float, float], float], ...] = (
    math.hypot,
    lambda a, b: a + b,
    lambda a, b: a - b,
    lambda a, b: b - a,
    lambda a, b: a * b,
    lambda a, b: a / b,
    lambda a, b: b / a,
)


def consequence_of(
    task: TaskCases, name: str, form: Form, outcomes: Sequence[Plain], made_in: str, row: Sequence[Plain]
) -> list[PartFound]:
    """Return what a part is beside a mistake that another part shows; nothing if it is none of it.

    Args:
        name: of the part, and its `form` and `outcomes`.
        made_in: the part in which the mistake was made.
        row: what the mistake gives in this part, case by case.
    """
    if not form.is_measured or any(value is None for value in row):
        return []
    if matches_closely(form, outcomes, row):
        return [only_follows(name, made_in)]
    fix = next(matching_corrections(form, outcomes, row, only_plain_to_see=True), None)
    return [PartFound({fix: feedback_of(task, fix)}, feedback_of(task, fix).reply, {name})] if fix else []


def only_follows(name: str, made_in: str) -> PartFound:
    """Return that a part is wrong only because of another; a cause comes first."""
    return PartFound.of(f"{name} follows", TEXTS["only_follows"].filled(part=made_in), name)._replace(is_of_words=True)


def followers(
    forms: dict[str, Form], given: dict[str, list[Plain]], wanted: dict[str, list[Plain]], wrong: set[str]
) -> dict[str, str]:
    """Return the wrong parts of a value that come of two before them as they have to, and which of those is wrong."""
    if any(len(row) > 1 for row in wanted.values()):
        return {}
    names = [name for name, form in forms.items() if isinstance(form, Number | Angle)]
    found: dict[str, str] = {}
    for *before, made in combinations(names, 3):
        first = next((name for name in before if name in wrong - found.keys()), None)
        if first and made in wrong and _is_made_alike(given, wanted, (*before, made)):
            found[made] = first
    return found


def _is_made_alike(given: dict[str, list[Plain]], wanted: dict[str, list[Plain]], names: Sequence[str]) -> bool:
    """Return whether the third of these parts comes of the first two in the answer as it does in what is right."""
    rows = [[numbers_of(held[name][0], None) for name in names] for held in (given, wanted)]
    return any(all(_comes_of(row, of) for row in rows) for of in JOINED)


def _comes_of(row: Sequence[tuple[float, ...] | None], of: Callable[[float, float], float]) -> bool:
    """Return whether the third number is made of the first two in this way; not where one is zero, or no number."""
    if not all(numbers and numbers[0] for numbers in row):
        return False
    one, other, made = (numbers[0] for numbers in row if numbers)
    return abs(of(one, other) - made) <= CLOSE * abs(made)
