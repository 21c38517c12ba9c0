"""What is a part, once a slip is known in another?  It follows from it, or has a mistake of its own on top.

```
"stamp_s"   38.2      a slip of the task
"speed"     0.54      what that slip gives here, too: it only follows
"yaw_rate"  17.4      what it gives here, in degrees: a second mistake, and it is named
"length"    9.1       the hypotenuse of two other parts, as it has to be: it follows from the one that is wrong
```
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import combinations

from ...text import Texts
from ..answers.form import Form, numbers_of
from ..answers.forms import Angle, Number
from ..answers.values import Plain
from ..mistakes.fitting import MEASURED, is_just, undone_to, words_of
from ..tasks.case_types import TaskCases
from .together import Found

__all__ = ["after_a_slip", "followers", "only_follows"]

TEXTS = Texts(__file__)

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


def after_a_slip(
    task: TaskCases, name: str, form: Form, outcomes: Sequence[Plain], made_in: str, row: Sequence[Plain]
) -> list[Found]:
    """Return what a part is beside a slip that another part shows; nothing if it is none of it.

    Args:
        name: of the part, and its `form` and `outcomes`.
        made_in: the part in which the slip was made.
        row: what the slip gives in this part, case by case.
    """
    if not isinstance(form, MEASURED) or any(value is None for value in row):
        return []
    if is_just(form, outcomes, row):
        return [only_follows(name, made_in)]
    way = next(undone_to(form, outcomes, row, only_plain_to_see=True), None)
    return [Found({way: words_of(task, way)}, words_of(task, way).reply, {name})] if way else []


def only_follows(name: str, made_in: str) -> Found:
    """Return that a part is wrong only because of another; a cause comes first."""
    return Found.of(f"{name} follows", TEXTS["only_follows"].filled(part=made_in), name)._replace(is_of_words=True)


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
