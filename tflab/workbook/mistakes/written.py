"""Which place holds the number of another?  It was written over, or the number stands twice.

asked for  (1, 2, 3)     given  (1, 3, 0)     "written over"    y holds z's number, and z is new
                         given  (1, 3, 3)     "stands twice"    y holds z's number, and z has it too
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

from ...text import Texts

__all__ = ["NEW", "TEXTS", "misplaced"]

TEXTS = Texts(__file__)

Numbers = tuple[float, ...]

NEW = {3: (0.0, 0.0, 0.0), 4: (0.0, 0.0, 0.0, 1.0)}  # what a message holds before anybody writes into it


def misplaced(rows: list[tuple[Numbers, Numbers]], tolerance: float) -> Iterator[tuple[str, str]]:
    """Yield which place holds the number of which other, in all of these points, where nothing else is wrong."""
    size = len(rows[0][1])
    for place, of in permutations(range(size), 2):
        twice: list[int | None] = [of if one == place else one for one in range(size)]
        over = [None if one == of else held for one, held in enumerate(twice)]
        for kind, held in (("written over", over), ("stands twice", twice)):
            if all(_holds(given, want, held, tolerance) for given, want in rows):
                yield kind, f"{'xyzw'[place]}, {'xyzw'[of]}"


def _holds(given: Numbers, wanted: Numbers, held: list[int | None], tolerance: float) -> bool:
    """Return whether each place holds the wanted number of the place that is named, or what it is new with."""
    new = NEW[len(wanted)]
    want = [new[place] if of is None else wanted[of] for place, of in enumerate(held)]
    return all(abs(one - other) <= tolerance for one, other in zip(given, want, strict=True))
