"""Do the two forms weigh the same?  Whatever is out of balance is a fault, and the build says it.

```
one right option an item                        a form in which "b" is always right is soon seen through
every wrong option shows a misconception        what shows nothing teaches nobody anything
an item looks for one misconception, in A as in B, and each of the fifteen has its item
at most five right options of one letter
```
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from .items import FORMS, LETTERS, RIGHT, Item

__all__ = ["MISCONCEPTIONS_ASKED", "MOST_OF_A_LETTER", "imbalances"]

MISCONCEPTIONS_ASKED = tuple(f"M{number}" for number in range(1, 16))
MOST_OF_A_LETTER = 5


def imbalances(items: Sequence[Item], form: str) -> Iterator[str]:
    """Yield what is out of balance in a form, and where it is no match for the other."""
    asked = tuple(item.misconception for item in items)
    if asked != MISCONCEPTIONS_ASKED:
        yield f"its items look for {', '.join(asked)}, and one for each of M1 to M15 is wanted, in this order"
    for number, item in enumerate(items, start=1):
        yield from (f"form {form}, item {number}: {fault}" for fault in _of_item(item, form))
    letters = Counter(item.forms[form].right for item in items)
    for letter, count in sorted(letters.items()):
        if count > MOST_OF_A_LETTER:
            yield f'form {form}: "{letter}" is right {count} times, more than {MOST_OF_A_LETTER}'


def _of_item(item: Item, form: str) -> Iterator[str]:
    options = item.forms[form].options
    right = [letter for letter, option in options.items() if option.shows == RIGHT]
    if "".join(options) != LETTERS:
        yield f"it has the options {', '.join(options)}, not {', '.join(LETTERS)}"
    if len(right) != 1:
        yield f"{len(right)} options are right ({', '.join(right) or 'none'}), and one has to be"
    for letter, option in options.items():
        if option.shows != RIGHT and option.shows not in MISCONCEPTIONS_ASKED:
            yield f'option "{letter}" shows no misconception of M1 to M15 ("{option.shows}")'
    for other in FORMS:
        shown = {option.shows for option in item.forms[other].options.values()}
        if item.misconception not in shown:
            yield f"it looks for {item.misconception}, which no option of form {other} shows"
