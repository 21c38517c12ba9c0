"""Hold the cases of a task: values that `check` and grading compare an answer with.

    TaskCases                the texts of a task, the form of its answer, feedback on its mistakes
      variants[2]: Variant   what some learners are given
        cases[0]: Case       arguments, the right answer, what each mistake gives

All values are plain JSON (`values.py`), and answers are judged as plain JSON.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from types import SimpleNamespace
from typing import Any, NamedTuple, Protocol

from ...text import Text
from ..answers.forms import Form, form_from_plain
from ..answers.values import Plain, is_raised, outcomes_of, to_plain

__all__ = [
    "AND",
    "Case",
    "Feedback",
    "PairFinder",
    "TaskCases",
    "Variant",
    "as_kept",
    "rounded",
    "values_of",
]  # fmt: skip

AND = " + "  # between the names of two mistakes that were made together
DIGITS = 12  # of a float in a case; the last ones differ between machines


class Case(NamedTuple):
    """One trial: the arguments (None for a value), what is right, and what each mistake gives instead."""

    args: list[Plain] | None
    expected: Plain
    wrong: dict[str, Plain]

    def plain(self) -> dict[str, Plain]:
        """Return the case as JSON has it."""
        return self._asdict()

    @classmethod
    def from_plain(cls, plain: dict[str, Plain]) -> Case:
        """Return the case that `plain` wrote."""
        return cls(plain["args"], plain["expected"], plain["wrong"])


class Variant(NamedTuple):
    """A task as some learners have it: what they are given (None if nothing varies), and its cases."""

    given: dict[str, Plain] | None
    cases: tuple[Case, ...]

    def plain(self) -> dict[str, Plain]:
        """Return the variant as JSON has it."""
        return {"given": self.given, "cases": [case.plain() for case in self.cases]}

    @classmethod
    def from_plain(cls, plain: dict[str, Plain]) -> Variant:
        """Return the variant that `plain` wrote."""
        return cls(plain["given"], tuple(map(Case.from_plain, plain["cases"])))


class Feedback(NamedTuple):
    """The reply to a mistake, its misconception, and the part in which it is made."""

    reply: Text
    misconception: str
    part: str = ""
    partly: bool = False

    def plain(self) -> dict[str, Plain]:
        """Return both as JSON has them."""
        return self._asdict() | {"reply": self.reply.plain()}

    @classmethod
    def from_plain(cls, plain: dict[str, Plain]) -> Feedback:
        """Return the feedback that `plain` wrote."""
        return cls(Text(**plain["reply"]), plain["misconception"], plain["part"], plain["partly"])


class PairFinder(Protocol):
    """What searches two mistakes that together give an answer: `pairs.PairSearch`."""

    def matching(
        self,
        cases: Sequence[Case],
        order: Sequence[int],
        reproduced_by: Callable[[int, Plain], Collection[str]],
        given: dict[str, Plain] | None,
    ) -> dict[str, list[Plain]]:
        """Return what each pair gives, case by case, of those that fit the answer."""


class TaskCases(NamedTuple):
    """A task without its solution: its texts, the form of its answer, and the cases."""

    kind: str
    points: float
    answer: str
    is_function: bool
    title: Text
    form: Form
    hints: tuple[Text, ...]
    misconceptions: tuple[str, ...]
    feedback: dict[str, Feedback]
    variants: tuple[Variant, ...]
    means: dict[str, Text] = {}  # noqa: RUF012  what each option would mean
    shows: dict[str, Text] = {}  # noqa: RUF012  what each part shows instead
    seen: dict[str, Text] = {}  # noqa: RUF012  what there is to see where an option is right
    counts: str = ""  # as of a Task
    pairs: PairFinder | None = None  # not part of the JSON

    def plain(self) -> dict[str, Plain]:
        """Return the task as JSON has it, `counts` and `seen` only if they are not empty."""
        held = self._asdict() | {"seen": {name: text.plain() for name, text in self.seen.items()}}
        for name in ("counts", "seen", "pairs"):
            if name == "pairs" or not held[name]:
                del held[name]
        return held | {
            "title": self.title.plain(),
            "form": self.form.plain(),
            "hints": [hint.plain() for hint in self.hints],
            "misconceptions": list(self.misconceptions),
            "feedback": {name: feedback.plain() for name, feedback in self.feedback.items()},
            "means": {name: text.plain() for name, text in self.means.items()},
            "shows": {name: text.plain() for name, text in self.shows.items()},
            "variants": [variant.plain() for variant in self.variants],
        }

    @classmethod
    def from_plain(cls, plain: dict[str, Plain]) -> TaskCases:
        """Return the task that `plain` wrote."""
        return cls(
            kind=plain["kind"],
            points=plain["points"],
            answer=plain["answer"],
            is_function=plain["is_function"],
            title=Text(**plain["title"]),
            form=form_from_plain(plain["form"]),
            hints=tuple(Text(**hint) for hint in plain["hints"]),
            misconceptions=tuple(plain["misconceptions"]),
            feedback={name: Feedback.from_plain(feedback) for name, feedback in plain["feedback"].items()},
            variants=tuple(map(Variant.from_plain, plain["variants"])),
            means={name: Text(**text) for name, text in plain["means"].items()},
            shows={name: Text(**text) for name, text in plain["shows"].items()},
            seen={name: Text(**text) for name, text in plain.get("seen", {}).items()},
            counts=plain.get("counts", ""),
        )

    @classmethod
    def of_a_learner(cls, plain: dict[str, Any]) -> TaskCases:
        """Return the task that a learner is graded on, whose JSON holds `given` and `cases` of the only variant."""
        return cls.from_plain(plain | {"variants": [{"given": plain["given"], "cases": plain["cases"]}]})


def values_of(answers: Mapping[str, Any], case: Case, given: Mapping[str, Any]) -> dict[str, Plain]:
    """Return what each answer gives in a case, a function from its arguments, a value from what was given."""
    if case.args is None:
        return {name: _value(answer, given) for name, answer in answers.items()}
    outcomes = outcomes_of(answers.values(), case.args)
    return {name: as_kept(outcome) for name, outcome in zip(answers, outcomes, strict=True)}


def _value(answer: Any, given: Mapping[str, Any]) -> Plain:
    return rounded(to_plain(answer(SimpleNamespace(**given)) if callable(answer) else answer))


def as_kept(outcome: Plain) -> Plain:
    """Return an outcome with its floats rounded; of an exception only its class."""
    return outcome | {"text": ""} if is_raised(outcome) else rounded(outcome)


def rounded(plain: Plain, digits: int = DIGITS) -> Plain:
    """Return JSON with its floats rounded, and no negative zero."""
    if isinstance(plain, float):
        return round(plain, digits) + 0.0
    if isinstance(plain, list):
        return [rounded(member, digits) for member in plain]
    if isinstance(plain, dict):
        return {key: rounded(value, digits) for key, value in plain.items()}
    return plain
