"""Search the pairs of a task's mistakes that together give an answer.

The mistakes of a task are alternatives at the steps of its model, so two at different
steps compose.  A task with forty has hundreds of pairs.  They are computed only for an
answer that nothing simpler explains, and by narrowing: each pair on one wrong case, those
that fit on the next, until few are left or none (model tracing, as in BUGGY).
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Collection, Sequence
from functools import cached_property, partial
from itertools import combinations
from typing import Any

from ..answers.equal_answers import EqualAnswers
from ..answers.forms import Form
from ..answers.values import Plain, from_plain
from .case_types import AND, Case, values_of
from .reference import in_process_ros
from .task import Task, WrongStep

__all__ = ["PairSearch", "ReproducedBy", "combinable"]

ReproducedBy = Callable[[int, Plain], Collection[str]]  # the number of a case, a value -> its parts


def combinable(task: Task) -> list[tuple[WrongStep, WrongStep]]:
    """Return the pairs of mistakes at different steps of the model, the earlier step first."""
    steps = list(inspect.signature(task.model).parameters) if task.model else []
    mistakes = [mistake for mistake in task.mistakes if isinstance(mistake, WrongStep)]
    mistakes.sort(key=lambda mistake: min(map(steps.index, mistake.at)))
    return [(first, then) for first, then in combinations(mistakes, 2) if not set(first.at) & set(then.at)]


class PairSearch:
    """The pairs of one task.

    Args:
        load: returns the task, or None where it is not here; called when pairs are searched for the first time.
    """

    def __init__(self, load: Callable[[], Task | None]) -> None:
        self._load = load

    @cached_property
    def _task(self) -> Task | None:
        return self._load()

    @cached_property
    def _answers(self) -> dict[str, Any]:
        """The model with two mistakes made in it, for each pair, by the names of both."""
        if self._task is None:
            return {}
        model: Any = self._task.model
        pairs = combinable(self._task)
        return {first.name + AND + then.name: partial(model, **first.at, **then.at) for first, then in pairs}

    def matching(
        self, cases: Sequence[Case], order: Sequence[int], reproduced_by: ReproducedBy, given: dict[str, Plain] | None
    ) -> dict[str, list[Plain]]:
        """Return the pairs that reproduce the answer or a part of it in every case, and what each gives case by case.

        A pair whose values are the right ones, or those of one mistake, is left out; pairs with the same values have
        the name of the mistake that they share.

        Args:
            order: the numbers of all cases, the wrong ones first.
            reproduced_by: for the number of a case and a value, the parts of the answer that this value reproduces.
            given: what the learner was shown.
        """
        if not self._answers:
            return {}
        shown = {name: from_plain(value) for name, value in (given or {}).items()}
        alive = dict(self._answers)
        common: dict[str, set[str]] = {}
        rows: dict[str, dict[int, Plain]] = {name: {} for name in alive}
        with in_process_ros():
            for number in order:
                for name, value in values_of(alive, cases[number], shown).items():
                    rows[name][number] = value
                    has = set(reproduced_by(number, value))
                    common[name] = common[name] & has if name in common else has
                alive = {name: answer for name, answer in alive.items() if common[name]}
                if not alive:
                    return {}
        return _distinct(self._task.form, cases, {name: [rows[name][n] for n in range(len(cases))] for name in alive})


def _distinct(form: Form, cases: Sequence[Case], rows: dict[str, list[Plain]]) -> dict[str, list[Plain]]:
    """Return the pairs without those that look like something simpler.

    Of pairs that look alike nobody knows which it was: only the mistake that they have in common is kept.
    """
    simple = [[case.expected for case in cases], *([case.wrong[name] for case in cases] for name in cases[0].wrong)]
    equal_answers = EqualAnswers(form, [*simple, *rows.values()])
    groups: dict[int, list[str]] = {}  # the number of the first of some pairs that look alike: all their names
    for number, name in enumerate(rows, start=len(simple)):
        if not equal_answers.has_equal(range(len(simple)), number):
            first = next((first for first in groups if equal_answers.has_equal([first], number)), number)
            groups.setdefault(first, []).append(name)
    certain = {names[0]: _in_common(names) for names in groups.values()}
    return {AND.join(known): rows[name] for name, known in certain.items() if known}


def _in_common(pairs: Sequence[str]) -> list[str]:
    """Return the mistakes that are in each of these pairs, in their order."""
    return [name for name in pairs[0].split(AND) if all(name in pair.split(AND) for pair in pairs)]
