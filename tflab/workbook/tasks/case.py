"""What does a file of cases hold?  Chapters of tasks, their variants, and the cases of each: values, not dictionaries.

    ChapterCases                                     {"format": 1, "chapter": "03_...", "tasks": {
      tasks["E3.2"]: TaskCases    <-from_plain--       "E3.2": {"points": 4, "form": {...}, "variants": [
        variants[2]: Variant       --plain()-->          {"given": {...}, "cases": [
          cases[0]: Case                                   {"args": null, "expected": ..., "twins": {...}}]}]}}}

What an answer is compared with stays plain JSON (`values.py`), open or sealed: it
is never turned back into an object where an answer is judged.  Read `cases.py` next.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from ..answers.forms import Form, form_from_plain
from ..answers.values import Plain
from ..words import Words

__all__ = ["AND", "FORMAT", "Case", "ChapterCases", "TaskCases", "TwinWords", "Variant"]

FORMAT = 2
AND = " + "  # between the names of two slips that were made together


class Case(NamedTuple):
    """One trial: the arguments (None for a value), what is right, and what each mistake gives."""

    args: list[Plain] | None
    expected: Plain
    twins: dict[str, Plain]

    def plain(self) -> dict[str, Plain]:
        """Return the case as JSON has it."""
        return self._asdict()

    @classmethod
    def from_plain(cls, plain: dict[str, Plain]) -> Case:
        """Return the case that `plain` wrote."""
        return cls(plain["args"], plain["expected"], plain["twins"])


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


class TwinWords(NamedTuple):
    """What is said of a mistake, which of the course's misconceptions is behind it, and in which part it is made."""

    reply: Words
    misconception: str
    part: str = ""
    partly: bool = False

    def plain(self) -> dict[str, Plain]:
        """Return both as JSON has them."""
        return self._asdict() | {"reply": self.reply.plain()}

    @classmethod
    def from_plain(cls, plain: dict[str, Plain]) -> TwinWords:
        """Return the words that `plain` wrote."""
        return cls(Words(**plain["reply"]), plain["misconception"], plain["part"], plain["partly"])


class TaskCases(NamedTuple):
    """A task without its solution: its words, the form of its answer, and what an answer is tried on."""

    kind: str
    points: float
    answer: str
    is_function: bool
    title: Words
    form: Form
    hints: tuple[Words, ...]
    cures: tuple[str, ...]
    twins: dict[str, TwinWords]
    variants: tuple[Variant, ...]
    means: dict[str, Words] = {}  # noqa: RUF012  what each option would mean
    shows: dict[str, Words] = {}  # noqa: RUF012  what each part shows instead
    seen: dict[str, Words] = {}  # noqa: RUF012  what there is to see where an option is right
    counts: str = ""  # as of a Task

    def plain(self) -> dict[str, Plain]:
        """Return the task as JSON has it; what counts only where it is not being right, what is seen only if said."""
        held = self._asdict() | {"seen": {name: words.plain() for name, words in self.seen.items()}}
        for name in ("counts", "seen"):
            if not held[name]:
                del held[name]
        return held | {
            "title": self.title.plain(),
            "form": self.form.plain(),
            "hints": [hint.plain() for hint in self.hints],
            "cures": list(self.cures),
            "twins": {name: twin.plain() for name, twin in self.twins.items()},
            "means": {name: words.plain() for name, words in self.means.items()},
            "shows": {name: words.plain() for name, words in self.shows.items()},
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
            title=Words(**plain["title"]),
            form=form_from_plain(plain["form"]),
            hints=tuple(Words(**hint) for hint in plain["hints"]),
            cures=tuple(plain["cures"]),
            twins={name: TwinWords.from_plain(twin) for name, twin in plain["twins"].items()},
            variants=tuple(map(Variant.from_plain, plain["variants"])),
            means={name: Words(**words) for name, words in plain["means"].items()},
            shows={name: Words(**words) for name, words in plain["shows"].items()},
            seen={name: Words(**words) for name, words in plain.get("seen", {}).items()},
            counts=plain.get("counts", ""),
        )

    @classmethod
    def of_a_learner(cls, plain: dict[str, Any]) -> TaskCases:
        """Return the task that a learner is graded on: its only variant stands among its other members."""
        return cls.from_plain(plain | {"variants": [{"given": plain["given"], "cases": plain["cases"]}]})


class ChapterCases(NamedTuple):
    """The cases of a chapter, by task."""

    chapter: str
    tasks: dict[str, TaskCases]

    def plain(self) -> dict[str, Plain]:
        """Return the chapter as JSON has it."""
        tasks = {name: task.plain() for name, task in self.tasks.items()}
        return {"format": FORMAT, "chapter": self.chapter, "tasks": tasks}

    @classmethod
    def from_plain(cls, plain: dict[str, Plain]) -> ChapterCases:
        """Return the chapter that `plain` wrote."""
        return cls(plain["chapter"], {name: TaskCases.from_plain(task) for name, task in plain["tasks"].items()})
