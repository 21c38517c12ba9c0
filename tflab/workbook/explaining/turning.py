"""How was a point turned in the plane?  Of a function of poses (x, y, yaw): which terms its number has.

    asked for   x + u·cos α - v·sin α
    given       x + u·cos α + v·sin α        found in every call, so that is what the function computes

The terms are x, y and the distance of a pose, alone and times the sine or cosine of a yaw or of
two; up to three of them, added or taken off.  Read `formulas.py` next.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, product

import numpy as np

from ..answers.form import Form, inside, numbers_of
from ..answers.forms import Number
from ..answers.values import Plain
from ..words import Words
from .arithmetic import as_written

__all__ = ["sum_of", "turned_in_all"]

FEWEST_CALLS = 4  # more than there are terms: so many numbers are no luck
MOST_POSES = 2
CLOSE = 1e-6
PLANAR = ("x", "y", "yaw")
SAID = Words(
    en="in every call this is what `{sum}` gives. Compare it, term by term, with what has to be computed.",
    ko="어느 호출에서나 `{sum}`의 값입니다. 구해야 할 식과 한 항씩 비교하십시오.",
)


def turned_in_all(form: Form, args: Sequence[list[Plain]], answers: Sequence[Plain]) -> tuple[str, Words] | None:
    """Return which terms a function's number has in every call, and what to say; None if no few terms give it."""
    rows = [numbers_of(answer, None) for answer in answers] if isinstance(form, Number) else []
    if len(rows) < FEWEST_CALLS or None in rows:
        return None
    terms = list(_terms(args))
    wanted = np.array([row[0] for row in rows])
    found = sum_of(terms, wanted) if terms and np.ptp(wanted) > CLOSE else ""
    return (f"computed: {found}", SAID.filled(sum=found)) if found else None


def _terms(args: Sequence[list[Plain]]) -> Iterator[tuple[str, np.ndarray]]:
    """Yield what may stand in the formula, with what it is in each call."""
    poses = {at: held for at in range(min(map(len, args))) if (held := _poses([call[at] for call in args])) is not None}
    if not 0 < len(poses) <= MOST_POSES:
        return
    angles = {f"argument {at + 1}: yaw": pose["yaw"] for at, pose in poses.items()}
    if len(angles) == MOST_POSES:
        angles |= {" + ".join(angles): sum(angles.values())}
    for at, pose in poses.items():
        x, y = (f"argument {at + 1}: {name}" for name in PLANAR[:2])
        for text, number in ((x, pose["x"]), (y, pose["y"]), (f"hypot({x}, {y})", np.hypot(pose["x"], pose["y"]))):
            yield text, number
            for angle, value in angles.items():
                yield f"{text} * cos({angle})", number * np.cos(value)
                yield f"{text} * sin({angle})", number * np.sin(value)


def _poses(plains: Sequence[Plain]) -> dict[str, np.ndarray] | None:
    """Return x, y and yaw of an argument, call by call; None if it is no pose in the plane."""
    held = [inside(plain) for plain in plains]
    if not all(isinstance(pose, dict) and set(PLANAR) <= pose.keys() for pose in held):
        return None
    rows = {name: [numbers_of(pose[name], None) for pose in held] for name in PLANAR}
    if any(None in row for row in rows.values()):
        return None
    return {name: np.array([number[0] for number in row]) for name, row in rows.items()}


def sum_of(terms: Sequence[tuple[str, np.ndarray]], wanted: np.ndarray, before: int = 2, close: float = CLOSE) -> str:
    """Return the fewest terms that give these numbers, as they are written; "" if none do.

    Args:
        before: how many terms there may be before the last one.
        close: how far from the numbers their sum may be.
    """
    values = np.array([value for _, value in terms])
    for count in range(before + 1):
        for chosen in combinations(range(len(terms)), count):
            for signs in product((1.0, -1.0), repeat=count):
                rest = wanted - sum((sign * values[at] for sign, at in zip(signs, chosen, strict=True)), 0.0)
                for sign in (1.0, -1.0):
                    off = np.max(np.abs(sign * values - rest), axis=1)
                    last = int(np.argmin(off))
                    if off[last] <= close and last not in chosen:
                        found = {**dict(zip(chosen, signs, strict=True)), last: sign}
                        return as_written((found[at], terms[at][0]) for at in sorted(found))
    return ""
