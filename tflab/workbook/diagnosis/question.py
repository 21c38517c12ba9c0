"""Hold what an explanation starts from, and what a row of a table of explanations is."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal, NamedTuple

from ..answers.form import Form
from ..answers.values import Plain, is_raised
from ..tasks.case_types import Case, TaskCases
from .explanation import Explanation, PartFound
from .matching import alike

__all__ = ["Explainer", "PartialExplanation", "Question"]


@dataclass(frozen=True)
class Question:
    """What every explanation is asked about.

    Attributes:
        task: the texts, the form of the answer and the known mistakes.
        cases: the calls of a function, or the one case of a value.
        outcomes: what came out of each case, as plain JSON.
        inputs: what the learner was shown, by name.
    """

    task: TaskCases
    cases: Sequence[Case]
    outcomes: Sequence[Plain]
    inputs: Mapping[str, Plain] = field(default_factory=dict)

    @property
    def form(self) -> Form:
        """The form of the answer."""
        return self.task.form

    @property
    def is_function(self) -> bool:
        """Whether a function is asked for."""
        return self.task.is_function

    @property
    def expected(self) -> list[Plain]:
        """What is right in each case."""
        return [case.expected for case in self.cases]

    @property
    def single_mistakes(self) -> dict[str, list[Plain]]:
        """What each mistake of the task gives, case by case."""
        return {name: [case.wrong.get(name) for case in self.cases] for name in self.cases[0].wrong}

    @property
    def is_right(self) -> list[bool]:
        """Whether each outcome is right."""
        return [alike(self.form, *pair) for pair in zip(self.outcomes, self.expected, strict=True)]

    def calls(self, is_asked: Iterable[bool]) -> Question:
        """Return the same question about some of the calls."""
        pairs = zip(self.cases, self.outcomes, is_asked, strict=True)
        chosen = [(case, outcome) for case, outcome, is_one in pairs if is_one]
        return replace(self, cases=[case for case, _ in chosen], outcomes=[outcome for _, outcome in chosen])

    def with_outcomes(self, outcomes: Sequence[Plain]) -> Question:
        """Return the same question about other outcomes."""
        return replace(self, outcomes=outcomes)

    def calls_that_raise(self) -> list[bool]:
        """Return for each call whether an exception is expected."""
        return [is_raised(case.expected) for case in self.cases]


class PartialExplanation(NamedTuple):
    """One thing that is wrong, and what is left to explain without it.

    Attributes:
        then: what is wrong, said after what explains the rest.
        question: what is left; None if all of it is right.
        is_enough: whether it is said alone where nothing explains the rest.
    """

    then: Explanation
    question: Question | None
    is_enough: bool = False


class Explainer(NamedTuple):
    """One way to explain an answer, or a part of one.

    Attributes:
        name: what is looked for; when it is true stands under this name in `conditions.yaml`.
        explain: returns the explanation; or one thing that is wrong and the rest of the question; or None.
        of: which answers are asked about.
        forms: the forms that it applies to; all if empty.
        is_measured: whether it applies to measured forms alone.
        is_last: whether no later row is asked where this one's condition holds.
        condition: when it is asked, beside `of` and `forms`.
    """

    name: str
    explain: Callable[[Any], Explanation | PartialExplanation | PartFound | None]
    of: Literal["value", "function", "any"] = "any"
    forms: tuple[type[Form], ...] = ()
    is_measured: bool = False
    is_last: bool = False
    condition: Callable[[Any], bool] | None = None

    def applies(self, question: Any) -> bool:
        """Return whether this row is asked about a question, or about a part."""
        is_of = self.of == "any" or (self.of == "function") is question.is_function
        is_form = isinstance(question.form, self.forms or Form)
        is_form &= question.form.is_measured or not self.is_measured
        return is_of and is_form and (self.condition is None or self.condition(question))
