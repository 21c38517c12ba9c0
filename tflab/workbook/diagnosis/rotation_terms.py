"""Recognise which terms of a 2D rotation a function adds up.

right    x * cos(yaw) - y * sin(yaw)
given    x * cos(yaw)                   in every call: `argument 1: y` is missing
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np

from ...text import Text, Texts
from ..answers.form import Form, inside, numbers_of
from ..answers.forms import Number
from ..answers.values import Plain

__all__ = ["describe_terms"]

TEXTS = Texts(__file__)

FEWEST_CALLS = 4  # more than there are terms, so that no sum fits by chance
MOST_TERMS = 3
MOST_POSES = 2
CLOSE = 1e-6
PLANAR = ("x", "y", "yaw")
Sum = dict[str, str]  # signed terms, and the number that each is made of


def describe_terms(
    form: Form, args: Sequence[list[Plain]], answers: Sequence[Plain], wanted: Sequence[Plain]
) -> Text | None:
    """Return which terms of a function's number are wrong in every call; None if no few terms give it."""
    if not isinstance(form, Number) or len(args) < FEWEST_CALLS:
        return None
    terms = list(_terms(list(filter(None, (_pose(at, args) for at in range(min(map(len, args))))))))
    given, right = (_sum_of(terms, list(map(form.numbers, plains))) for plains in (answers, wanted))
    if not given or not right:
        return None
    missing = [what for what in dict.fromkeys(right.values()) if what not in given.values()]
    said = [TEXTS["missing"].filled(what=what) for what in missing]
    return Text.joined(*said, *(TEXTS["too_much"].filled(what=term) for term in given if term not in right))


def _pose(at: int, args: Sequence[list[Plain]]) -> dict[str, np.ndarray] | None:
    """Return x, y and yaw of an argument, by their names, call by call; None if it is no pose in the plane."""
    held = [inside(call[at]) for call in args]
    if not all(isinstance(pose, dict) and set(PLANAR) <= pose.keys() for pose in held):
        return None
    rows = {f"argument {at + 1}: {name}": [numbers_of(pose[name], None) for pose in held] for name in PLANAR}
    if any(None in row for row in rows.values()):
        return None
    return {name: np.array([number[0] for number in row]) for name, row in rows.items()}


def _terms(poses: Sequence[dict[str, np.ndarray]]) -> Iterator[tuple[str, str, np.ndarray]]:
    """Yield each signed term that may stand in the sum, the number that it is made of, and its values."""
    angles = dict(list(pose.items())[2] for pose in poses[:MOST_POSES])
    if len(angles) > 1:
        (one, a), (other, b) = angles.items()
        angles |= {f"{one} + {other}": a + b, f"{one} - {other}": a - b}
    for pose in poses[:MOST_POSES]:
        for number, values in list(pose.items())[:2]:
            factors = {"": values} | {f" * {name}": values * yaw for name, yaw in angles.items()}
            factors |= {f" * cos({name})": values * np.cos(yaw) for name, yaw in angles.items()}
            factors |= {f" * sin({name})": values * np.sin(yaw) for name, yaw in angles.items()}
            for factor, product in factors.items():
                yield from ((f"{sign}{number}{factor}", number, by * product) for sign, by in (("+ ", 1), ("- ", -1)))


def _sum_of(terms: Sequence[tuple[str, str, np.ndarray]], numbers: Sequence[tuple[float, ...] | None]) -> Sum:
    """Return the fewest terms that add up to these numbers; none if there are none, or the numbers are all the same."""
    wanted = np.array([] if None in numbers else numbers, dtype=float).reshape(-1)
    if not terms or len(wanted) == 0 or np.ptp(wanted) <= CLOSE:
        return {}
    values = np.array([value for *_, value in terms]).reshape(len(terms), len(wanted))
    for count in range(1, MOST_TERMS + 1):
        places = np.array(list(combinations(range(len(terms)), count)), dtype=int).reshape(-1, count)
        fits = np.abs(values[places].sum(axis=1) - wanted).max(axis=1, initial=0.0) <= CLOSE
        if fits.any():
            return {terms[at][0]: terms[at][1] for at in places[fits.argmax()]}
    return {}
