"""Find the mistakes of a task that explain some parts of an answer, and what follows from them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from ...text import Text, Texts
from ..answers.form import Form
from ..answers.forms import Message
from ..answers.values import Plain, is_raised
from ..tasks.case_types import AND, Feedback, TaskCases
from .explanation import PartFound, describe, without_overlaps
from .generic import TOLD
from .matching import (
    ONE,
    TWO,
    alike,
    all_alike,
    expand_lists,
    feedback_of,
    matches_closely,
    matching_corrections,
)
from .question import Question

__all__ = ["AnswerPart", "Table", "consequence_of", "is_something", "mistakes_in_parts"]

TEXTS = Texts(__file__)

LABELS = ("header.", "child_frame_id")  # fields of a message that say what its numbers are


class Table(NamedTuple):
    """A question by the parts of its answer: the form of each, what came out in each case, and what was wanted."""

    question: Question
    task: TaskCases
    forms: dict[str, Form]
    given: dict[str, list[Plain]]
    wanted: dict[str, list[Plain]]

    @classmethod
    def of(cls, question: Question) -> Table:
        """Return the table of a question whose outcomes can all be read."""
        form, outcomes, expected = question.form, question.outcomes, question.expected
        forms = expand_lists(form, form.forms_of_parts(expected[0]), [*outcomes, *expected])
        given, wanted = ({name: [form.part_of(plain, name) for plain in row] for name in forms}
                         for row in (outcomes, expected))  # fmt: skip
        return cls(question, question.task, forms, given, wanted)

    @property
    def wrong(self) -> set[str]:
        """The parts that are wrong in some case."""
        return {name for name, form in self.forms.items() if not all_alike(form, self.given[name], self.wanted[name])}

    def part(self, name: str, found: Sequence[PartFound] = ()) -> AnswerPart:
        """Return one wrong part, after what was found before it."""
        return AnswerPart(self, name, self.forms[name], self.given[name], self.wanted[name], found)

    def part_of(self, answers: Sequence[Plain], name: str) -> list[Plain]:
        """Return one part of what a mistake gives, case by case."""
        return [self.question.form.part_of(answer, name) for answer in answers]


class AnswerPart(NamedTuple):
    """What every explanation of one wrong part is asked about.

    Attributes:
        table: all parts.
        name: of this one; then its form, what came out of each case, and what is right.
        found: what was found in the parts before this one.
    """

    table: Table
    name: str
    form: Form
    outcomes: list[Plain]
    expected: list[Plain]
    found: Sequence[PartFound]

    @property
    def is_function(self) -> bool:
        """Whether there are several cases to compare."""
        return len(self.outcomes) > 1

    def explained(self, key: str, said: Text) -> PartFound:
        """Return the explanation of this part by one mistake which no task has to know."""
        return PartFound.of(key, said, self.name)

    def explained_by(self, *mistakes: str) -> PartFound:
        """Return the explanation of this part by mistakes of the task, or by those that any answer can have."""
        words = {mistake.partition(TOLD)[0]: feedback_of(self.table.task, mistake) for mistake in mistakes}
        return PartFound(words, describe(self.table.task, mistakes), {self.name})


def mistakes_in_parts(table: Table, wrong: set[str]) -> list[PartFound]:
    """Return what mistakes explain, most parts and fewest mistakes first; pairs, unless one or two explain all."""
    found = _in_order(_causes(table, wrong, table.question.single_mistakes))
    if table.task.pairs is None or _is_explained(found, wrong):
        return found
    both = _causes(table, wrong, _pairs(table, wrong))
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
    kept = [cause for cause in found if len(cause.mistakes) == 1 or not _falls_apart(cause, found)]
    return sorted(kept, key=lambda cause: (-len(cause.parts), len(cause.mistakes), not cause.is_whole))


def _is_explained(found: list[PartFound], wrong: set[str]) -> bool:
    """Return whether one or two mistakes explain all wrong parts."""
    causes = without_overlaps(found, wrong)
    return wrong <= set().union(*(cause.parts for cause in causes)) and len(causes) <= 2


def _pairs(table: Table, wrong: set[str]) -> dict[str, list[Plain]]:
    """Return what those two mistakes give, case by case, that give one of the wrong parts at least."""
    cases = table.question.cases
    assert table.task.pairs is not None
    parts = [name for name in table.forms if name in wrong]

    def reproduced_by(case: int, value: Plain) -> list[str]:
        if is_raised(value):
            return []
        rows = [(name, table.forms[name], table.given[name][case]) for name in parts]
        return [
            name
            for name, form, given in rows
            if not (len(cases) == 1 and form.is_short(given))
            and matches_closely(form, [given], table.part_of([value], name), TWO)
        ]

    def is_right(case: int) -> bool:
        return all(alike(table.forms[name], table.given[name][case], table.wanted[name][case]) for name in parts)

    order = sorted(range(len(cases)), key=is_right)
    return table.task.pairs.matching(cases, order, reproduced_by, dict(table.question.inputs))


def _causes(table: Table, wrong: set[str], rows: dict[str, list[Plain]]) -> list[PartFound]:
    """Return what each mistake, or each two, explain of the wrong parts."""
    task, found = table.task, []
    for key, answers in rows.items():
        mistakes = {name: feedback_of(task, name) for name in key.split(AND)}
        said = describe(task, list(mistakes))
        changed, same = _shown(table, answers, TWO if AND in key else ONE)
        same = _explain_whole_lists(same, changed)
        if changed and changed <= same & wrong and not wrong & _cancelled(table, mistakes, changed):
            found.append(PartFound(mistakes, said, changed, is_whole=True))
        elif same & changed & wrong and all(_is_partly(table, *row) for row in mistakes.items()):
            found.append(PartFound(mistakes, said, same & changed & wrong))
        elif len(mistakes) == 1 and (made_in := mistakes[key].part) in same & changed & wrong:
            found.append(PartFound(mistakes, said, {made_in}))
        elif len(mistakes) == 1 and (values := _without_labels(table, changed, same & wrong)):
            found.append(PartFound(mistakes, said, values))
    return found


def _cancelled(table: Table, mistakes: Iterable[str], changed: set[str]) -> set[str]:
    """Return the parts that one of two mistakes changes and the other sets right again."""
    rows = ([case.wrong.get(name) for case in table.question.cases] for name in mistakes)
    return set().union(*(_shown(table, row, ONE)[0] for row in rows)) - changed


def _explain_whole_lists(same: set[str], changed: set[str]) -> set[str]:
    """Return the parts without members of lists of which another member is not what the mistake gives."""
    others = {name.partition("[")[0] for name in changed - same if "[" in name}
    return {name for name in same if name.partition("[")[0] not in others}


def _is_partly(table: Table, name: str, words: Feedback) -> bool:
    """Return whether a mistake's reply is true of some parts alone: it says so, or it shows in a single one anyway."""
    answers = [case.wrong.get(name) for case in table.question.cases]
    return words.partly or (bool(words.part) and _shown(table, answers, ONE)[0] == {words.part})


def _without_labels(table: Table, changed: set[str], same: set[str]) -> set[str]:
    """Return the parts that a mistake explains in a message whose labels were corrected by hand; none of others."""
    values = {part for part in changed if not part.startswith(LABELS)}
    is_more = {part for part in same if any(is_something(table.forms[part], value) for value in table.given[part])}
    return values if isinstance(table.question.form, Message) and values <= is_more else set()


def _falls_apart(both: PartFound, found: Sequence[PartFound]) -> bool:
    """Return whether each of two mistakes, and no other, explains parts of its own: then each is said of those."""
    single = [cause for cause in found if len(cause.mistakes) == 1]
    alone = [cause.parts for cause in single if cause.mistakes.keys() <= both.mistakes.keys()]
    if len(alone) < len(both.mistakes) or set.intersection(*alone) or not both.parts <= set.union(*alone):
        return False
    return all(sum(cause.parts == parts for cause in single) == 1 for parts in alone)


def _shown(table: Table, answers: Sequence[Plain], share: float) -> tuple[set[str], set[str]]:
    """Return in which parts a mistake gives something else than what is right, and in which it gives what came out."""
    changed: set[str] = set()
    same: set[str] = set()
    if any(map(is_raised, answers)) or any(answer is None for answer in answers):
        return changed, same
    for name, part in table.forms.items():
        row = table.part_of(answers, name)
        if not all(map(part.alike, row, table.wanted[name])):
            changed.add(name)
        if matches_closely(part, table.given[name], row, share):
            same.add(name)
    return changed, same


def is_something(form: Form, value: Plain) -> bool:
    """Return whether a value is more than zeros, which many answers are."""
    row = form.numbers(value)
    return row is None or any(row)


def consequence_of(part: AnswerPart, made_in: str, row: Sequence[Plain]) -> PartFound | None:
    """Return what a part is beside a mistake that another part shows; None if it is none of it.

    Args:
        made_in: the part in which the mistake was made.
        row: what the mistake gives in this part, case by case.
    """
    if any(value is None for value in row):
        return None
    if matches_closely(part.form, part.outcomes, row):
        return _only_follows(part.name, made_in)
    fix = next(matching_corrections(part.form, part.outcomes, row, only_plain_to_see=True), None)
    return part.explained_by(fix) if fix else None


def _only_follows(name: str, made_in: str) -> PartFound:
    """Return that a part is wrong only because of another; a cause comes first."""
    return PartFound.of(f"{name} follows", TEXTS["only_follows"].filled(part=made_in), name)._replace(is_of_words=True)
