"""Read JSON of limited depth, whatever Python's own limit is.

    [[[[ ... ]]]]    TooDeep, and not a RecursionError somewhere behind the reading

Python reads lists some thousand deep (how many depends on its version), and then whoever
walks through them runs out of stack.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

__all__ = ["DEEPEST", "TooDeep", "read"]

DEEPEST = 200  # an answer has 66 at most, a notebook's outputs some 30


class TooDeep(ValueError):
    """Lists in lists in lists."""


def read(text: str | bytes, **options: Any) -> Any:
    """Return what a JSON text holds; `options` are those of `json.loads`.

    Raises:
        TooDeep: more than DEEPEST lists or objects stand in one another.
        ValueError: it is not JSON.
    """
    try:
        held = json.loads(text, **options)
    except RecursionError:
        raise TooDeep("lists are nested too deep") from None
    level = _containers([held])
    for _ in range(DEEPEST):
        if not level:
            return held
        level = _containers(
            inner for outer in level for inner in (outer.values() if isinstance(outer, dict) else outer)
        )
    raise TooDeep("lists are nested too deep")


def _containers(values: Iterable[Any]) -> list[Any]:
    return [value for value in values if isinstance(value, list | dict)]
