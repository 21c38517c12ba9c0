"""Find equal answers among many, quickly: compare fully only those whose numbers agree.

    what each gives, case by case      the numbers of its marks       alike?
    right     1.57   (0, 0)            1.57   0   0
    swapped   0.25   (0, 0)            0.25   0   0                   no: 0.25 is not 1.57
    the z     1.57   (0, 1e-9)         1.57   0   1e-9                perhaps: ask the form

A task with forty mistakes has hundreds of pairs of them, and each is compared with all
before it.  Only what all ways of writing an answer share decides (of a quaternion and
its negative, how large each number is), so nothing is called different here that the
form would call the same.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from .form import Form, Mark, Probe
from .values import Plain

__all__ = ["EqualAnswers"]

Place = tuple[int, int, int, str]  # of a mark: in which case, probe and column, and what of it
NO_SECOND = 1e-11  # of a number: `Mark.same` forgives less


class EqualAnswers:
    """Answers that are compared with one another, each by what it gives in every case.

    Args:
        rows: for each answer what it gives, as plain JSON, shape (answers, cases).
    """

    def __init__(self, form: Form, rows: Sequence[Sequence[Plain]]) -> None:
        self._rows = rows
        read = form.reading()
        self._is_alike = form.comparing(read)
        marks = [{} if form.in_any_order else dict(_marks_of(map(read, row))) for row in rows]
        self._numbers, self._tolerances = _columns(marks)

    def has_equal(self, others: Sequence[int], one: int) -> bool:
        """Return whether one of `others` is the same as `one`, all by their places among the rows."""
        return any(all(map(self._is_alike, self._rows[one], self._rows[other])) for other in self._near(others, one))

    def _near(self, others: Sequence[int], one: int) -> Sequence[int]:
        """Return those of `others` that are not apart from `one` in any number."""
        numbers, chosen = self._numbers[one], np.asarray(others, dtype=int)
        far = np.maximum(self._tolerances[one], self._tolerances[chosen]) + NO_SECOND * np.abs(numbers)
        apart = np.abs(self._numbers[chosen] - numbers) > far  # never so where one of the two has no number
        return chosen[~apart.any(axis=1)]


def _marks_of(cases: Iterator[list[Probe] | None]) -> Iterator[tuple[Place, Mark]]:
    """Yield what all ways of writing an answer share, each mark with its place."""
    for case, probes in enumerate(cases):
        for number, probe in enumerate(probes or ()):
            for column, alternatives in enumerate(zip(*probe, strict=False)):
                for what, mark in _shared(alternatives):
                    yield (case, number, column, what), mark


def _shared(alternatives: Sequence[Mark]) -> Iterator[tuple[str, Mark]]:
    values = {mark.value for mark in alternatives}
    if any(isinstance(value, str) for value in values):
        if len(values) == 1:
            yield "text", alternatives[0]
        return
    sizes = set(map(abs, values))
    if len(values) == 1:
        yield "number", alternatives[0]
    if len(sizes) == 1:
        yield "size", Mark(sizes.pop(), max(mark.tolerance for mark in alternatives))


def _columns(marks: Sequence[dict[Place, Mark]]) -> tuple[np.ndarray, np.ndarray]:
    """Return the marks' numbers and their tolerances, shape (answers, places); NaN where an answer has none."""
    places = {place: column for column, place in enumerate(dict.fromkeys(place for row in marks for place in row))}
    texts: dict[str, int] = {}
    numbers = np.full((len(marks), len(places)), np.nan)
    tolerances = np.zeros((len(marks), len(places)))
    for row, held in enumerate(marks):
        for place, mark in held.items():
            value = texts.setdefault(mark.value, len(texts)) if isinstance(mark.value, str) else mark.value
            numbers[row, places[place]] = value
            tolerances[row, places[place]] = mark.tolerance
    return numbers, tolerances
