"""Where in a piece of Python can something else stand?  At each node of its tree, put there for a while.

    if age < limit:         spots   `age < limit`, `age`, `<`, `limit`, the `if` itself
    with held_in(owner, field, spot.with_(new)):   the tree has the other one, and then it is as it was

What is often written for what is in the tables, in both directions: who spoils a
solution asks for it, and who looks for the one wrong place in an answer, too.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

__all__ = ["EDGES", "OPPOSITES", "SIDES", "SIGNS", "Spot", "held_in", "spots_of"]

EDGES = {ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt}
SIDES = {ast.Lt: ast.Gt, ast.LtE: ast.GtE, ast.Gt: ast.Lt, ast.GtE: ast.LtE}
OPPOSITES = {ast.Eq: ast.NotEq, ast.NotEq: ast.Eq, ast.In: ast.NotIn, ast.NotIn: ast.In}
SIGNS = {ast.Add: ast.Sub, ast.Sub: ast.Add}


class Spot(NamedTuple):
    """A node, and where it stands: in a field of its owner, or at a place of the list that the field holds."""

    owner: ast.AST
    field: str
    place: int | None
    node: ast.AST

    def with_(self, *new: ast.AST) -> Any:
        """Return what the field holds with other nodes in this one's stead; a list without any has `pass`."""
        if self.place is None:
            return new[0] if new else None
        held = getattr(self.owner, self.field)
        return [*held[: self.place], *new, *held[self.place + 1 :]] or [ast.Pass()]


def spots_of(tree: ast.AST) -> list[Spot]:
    """Return the spots below a node, level by level."""
    return list(_spots(tree))


def _spots(tree: ast.AST) -> Iterator[Spot]:
    for owner in ast.walk(tree):
        for field, held in ast.iter_fields(owner):
            if isinstance(held, ast.AST):
                yield Spot(owner, field, None, held)
            elif isinstance(held, list):
                yield from (
                    Spot(owner, field, place, node) for place, node in enumerate(held) if isinstance(node, ast.AST)
                )


@contextmanager
def held_in(owner: ast.AST, field: str, value: Any) -> Iterator[None]:
    """Let a node's field hold something else, for as long as this lasts."""
    before = getattr(owner, field)
    setattr(owner, field, value)
    try:
        yield
    finally:
        setattr(owner, field, before)
