"""Compute what a class learnt between the two forms of the test: gain and misconceptions.

    matched     who answered all of form A and all of form B; everybody else is a line, and counts nowhere
    gain        g = (mean after - mean before) / (15 - mean before), of the class's means: 6.2 -> 12.1 is 0.67
    believed    for each misconception how many chose an option that shows it, and how many of these were sure

The gain is never the mean of each one's own: fifteen items are too few to measure one
person.  A misconception is counted only on items on which both forms offer it, so that it
has as many chances before as after.  The field calls g the *normalised gain* (Hake).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from statistics import mean
from typing import Any, NamedTuple

from tflab.text import Text, Texts
from tflab.workbook.inventory.items import FORMS, Item
from tflab.workbook.inventory.replies import Reply, replies_to
from tflab.workbook.tasks.misconceptions import MISCONCEPTIONS

from ..submissions.remarks import Remark

__all__ = [
    "BY_GUESSING",
    "ClassGain",
    "MisconceptionCount",
    "PairedAnswers",
    "band",
    "class_gain",
    "misconception_counts",
    "normalised_gain",
    "uninformative_items",
    "unused_options",
]

TEXTS = Texts(__file__)
ONLY = {"A": "only_a", "B": "only_b"}
BY_GUESSING = 3.75  # of 15, with four options each
LOW, HIGH = 0.3, 0.7
HARDEST, EASIEST, FEWEST_CHOOSE = 0.2, 0.8, 0.05  # of a class, before: else an item tells nothing
MOST_NAMES = 12


class PairedAnswers(NamedTuple):
    """A learner who answered both forms, and what they said to each item."""

    learner: str
    before: list[Reply]
    after: list[Reply]


class ClassGain(NamedTuple):
    """Who is matched, and a line for everything else."""

    matched: tuple[PairedAnswers, ...]
    lines: tuple[Text, ...]

    def right(self) -> tuple[list[int], list[int]]:
        """Return how many each of the matched has right, before and after."""
        sides = ([one.before for one in self.matched], [one.after for one in self.matched])
        before, after = ([sum(reply.is_right for reply in replies) for replies in side] for side in sides)
        return before, after

    def means(self) -> tuple[float, float]:
        """Return how many are right on average, before and after."""
        before, after = self.right()
        return mean(before), mean(after)


class MisconceptionCount(NamedTuple):
    """How many learners chose an option that shows a misconception, before and after; and how many were sure."""

    misconception: str
    before: int
    after: int
    sure_before: int
    sure_after: int


def class_gain(records: Sequence[Mapping[str, Any]], items: Sequence[Item]) -> ClassGain | None:
    """Return what a class's records say of the test; None where nobody was asked either form."""
    if not items or not any(_row(record, form) for record in records for form in FORMS):
        return None
    answers = {record["learner"]: {form: _answers(record, form) for form in FORMS} for record in records}
    matched = [
        PairedAnswers(learner, replies_to(items, "A", both["A"]), replies_to(items, "B", both["B"]))
        for learner, both in answers.items()
        if all(both.values())
    ]
    return ClassGain(tuple(matched), tuple(_lines(records, answers)))


def normalised_gain(before: float, after: float, of: int) -> float | None:
    """Return the gain as a share of what was left to gain; None if nothing was left."""
    return (after - before) / (of - before) if before < of else None


def band(gain: float) -> Text:
    """Return in which of the three bands a gain is."""
    return TEXTS["low" if round(gain, 6) < LOW else "medium" if round(gain, 6) <= HIGH else "high"]


def misconception_counts(items: Sequence[Item], matched: Sequence[PairedAnswers]) -> list[MisconceptionCount]:
    """Return every misconception; those that grew first, at most three, then the others in their order."""
    rows = [_believed(name, _chances(items, name), matched) for name in MISCONCEPTIONS]
    grew = sorted((row for row in rows if row.after > row.before), key=lambda row: row.before - row.after)[:3]
    return [*grew, *(row for row in rows if row not in grew)]


def _chances(items: Sequence[Item], misconception: str) -> list[int]:
    """Return the places of the items on which both forms offer an option that shows a misconception."""
    return [
        place
        for place, item in enumerate(items)
        if all(misconception in {option.shows for option in item.forms[form].options.values()} for form in FORMS)
    ]


def _believed(misconception: str, places: Sequence[int], matched: Sequence[PairedAnswers]) -> MisconceptionCount:
    counts = []
    for when in ("before", "after"):
        chose = [[getattr(one, when)[place] for place in places] for one in matched]
        shown = [[reply for reply in replies if reply.shows == misconception] for replies in chose]
        counts.append((sum(map(bool, shown)), sum(any(reply.is_sure for reply in replies) for replies in shown)))
    (before, sure_before), (after, sure_after) = counts
    return MisconceptionCount(misconception, before, after, sure_before, sure_after)


def uninformative_items(matched: Sequence[PairedAnswers]) -> list[int]:
    """Return the numbers of the items that hardly anybody or nearly everybody had right before (facility)."""
    columns = zip(*(one.before for one in matched), strict=True)
    shares = [mean(reply.is_right for reply in column) for column in columns]
    return [number for number, share in enumerate(shares, start=1) if not HARDEST <= share <= EASIEST]


def unused_options(items: Sequence[Item], matched: Sequence[PairedAnswers]) -> list[str]:
    """Return the wrong options that next to nobody chose before, as "3b": idle distractors."""
    found = []
    for number, (item, column) in enumerate(
        zip(items, zip(*(one.before for one in matched), strict=True), strict=True), 1
    ):
        wording = item.forms["A"]
        for letter in wording.options:
            share = mean(reply.letter == letter for reply in column)
            if letter != wording.right and share < FEWEST_CHOOSE:
                found.append(f"{number}{letter}")
    return found


# -- what the records hold ---------------------------------------------------------------------


def _chapter(record: Mapping[str, Any], form: str) -> Mapping[str, Any]:
    """Return the chapter of a record that has a form's task; {} if none has."""
    chapters = record["chapters"].values()
    return next((chapter for chapter in chapters if FORMS[form] in chapter["tasks"]), {})


def _row(record: Mapping[str, Any], form: str) -> Mapping[str, Any]:
    return _chapter(record, form).get("tasks", {}).get(FORMS[form], {})


def _answers(record: Mapping[str, Any], form: str) -> Mapping[str, str]:
    return _row(record, form).get("answers", {})


def _lines(records: Sequence[Mapping[str, Any]], answers: Mapping[str, Mapping[str, Any]]) -> list[Text]:
    """Return a line for whoever is not matched, and for what is odd about those who are."""
    kinds = ("incomplete", *ONLY.values(), "neither", "other_language")
    found: dict[Text, list[str]] = {TEXTS[kind]: [] for kind in kinds}
    for record in records:
        words = _why_not_matched(record, answers[record["learner"]])
        if words is not None:
            found[words].append(record["learner"])
        if _is_in_another_language(record):
            found[TEXTS["other_language"]].append(record["learner"])
    lines = [_line(words, who) for words, who in found.items() if who]
    return lines + [line for record in records for line in _twice(record)]


def _why_not_matched(record: Mapping[str, Any], both: Mapping[str, Any]) -> Text | None:
    if all(both.values()):
        return None
    if any(_row(record, form).get("passed") and not both[form] for form in FORMS):
        return TEXTS["incomplete"]
    return next((TEXTS[ONLY[form]] for form in FORMS if both[form]), TEXTS["neither"])


def _line(words: Text, who: Sequence[str]) -> Text:
    names, more = ", ".join(who[:MOST_NAMES]), len(who) - MOST_NAMES
    return words.filled(who=TEXTS["and_more"].filled(names=names, more=more) if more > 0 else names)


def _is_in_another_language(record: Mapping[str, Any]) -> bool:
    written_in = {_chapter(record, form).get("language", "") for form in FORMS if _answers(record, form)}
    return bool(written_in - {"", record["language"]})


def _twice(record: Mapping[str, Any]) -> list[Text]:
    remarks = [remark for form in FORMS for remark in _chapter(record, form).get("remarks", ())]
    said = [Remark.from_plain(remark) for remark in remarks if remark["kind"] == "several"]
    names = {"learner": record["learner"]}
    return [
        Text(*(TEXTS["twice"].say(tongue, said=one.say(tongue), **names) for tongue in ("en", "ko"))) for one in said
    ]
