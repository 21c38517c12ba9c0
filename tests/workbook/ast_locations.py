"""Find the nodes of a syntax tree that can be replaced, and replace one for a while.

    if age < limit:      locations   `age < limit`, `age`, `<`, `limit`, the `if` itself
    with replaced_field(owner, field, location.with_(new)):   the tree holds `new` in this block

The tables name what is often written for what, in both directions.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

__all__ = ["EDGES", "OPPOSITES", "SIDES", "SIGNS", "Location", "locations_in", "replaced_field"]

EDGES = {ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt}
SIDES = {ast.Lt: ast.Gt, ast.LtE: ast.GtE, ast.Gt: ast.Lt, ast.GtE: ast.LtE}
OPPOSITES = {ast.Eq: ast.NotEq, ast.NotEq: ast.Eq, ast.In: ast.NotIn, ast.NotIn: ast.In}
SIGNS = {ast.Add: ast.Sub, ast.Sub: ast.Add}


class Location(NamedTuple):
    """A node in a field of its owner, or at `place` in the list that the field holds."""

    owner: ast.AST
    field: str
    place: int | None
    node: ast.AST

    def with_(self, *new: ast.AST) -> Any:
        """Return the value of the field with other nodes in place of this one; an empty list becomes `pass`."""
        if self.place is None:
            return new[0] if new else None
        held = getattr(self.owner, self.field)
        return [*held[: self.place], *new, *held[self.place + 1 :]] or [ast.Pass()]


def locations_in(tree: ast.AST) -> list[Location]:
    """Return the locations below a node, level by level."""
    return list(_locations(tree))


def _locations(tree: ast.AST) -> Iterator[Location]:
    for owner in ast.walk(tree):
        for field, held in ast.iter_fields(owner):
            if isinstance(held, ast.AST):
                yield Location(owner, field, None, held)
            elif isinstance(held, list):
                yield from (
                    Location(owner, field, place, node) for place, node in enumerate(held) if isinstance(node, ast.AST)
                )


@contextmanager
def replaced_field(owner: ast.AST, field: str, value: Any) -> Iterator[None]:
    """Replace the value of a node's field inside a `with` block."""
    before = getattr(owner, field)
    setattr(owner, field, value)
    try:
        yield
    finally:
        setattr(owner, field, before)
