"""How can a sum differ from the one that was meant, as a whole?  By its brackets, or by whose numbers it takes.

    stamp - t0 / (t1 - t0)           (stamp - t0) / (t1 - t0)
    y = x0 + ratio * (x1 - x0)       y0 + ratio * (y1 - y0): the line of x, copied

Names go by their stem and their number: `x0`, `x1` are of one stem, and `y0`, `y1` of
another; fields by their letter, `a.x`; members by their place, `a[0]`.
"""

from __future__ import annotations

import ast
import copy
import re
from collections import Counter
from collections.abc import Iterator

__all__ = ["bracketed", "of_others"]

LETTERS = "xyzw"
PLACES = range(4)
STEM = re.compile(r"([A-Za-z_]+)(\d+)")
FEWEST = 2  # nodes that are of another at once: of one, another name is meant
PLUS = (ast.Add, ast.Sub)
TIMES = (ast.Mult, ast.Div)
Key = str | int


def bracketed(node: ast.BinOp) -> Iterator[ast.BinOp]:
    """Yield the sum with brackets around two terms that stand side by side in it."""
    op, left, right = node.op, node.left, node.right
    if isinstance(op, PLUS) and isinstance(right, ast.BinOp) and isinstance(right.op, TIMES):
        yield ast.BinOp(ast.BinOp(left, op, right.left), right.op, right.right)
    if isinstance(op, (*PLUS, ast.Mult)) and isinstance(left, ast.BinOp) and isinstance(left.op, TIMES):
        yield ast.BinOp(left.left, left.op, ast.BinOp(left.right, op, right))


def of_others(node: ast.BinOp, variables: set[str]) -> Iterator[ast.BinOp]:
    """Yield the sum with all that is of one stem, letter or place of another, where such others are known."""
    keys = Counter(key for inner in ast.walk(node) if (key := _key(inner)) is not None)
    stems = {match[1] for match in map(STEM.fullmatch, variables) if match}
    for key, count in keys.items():
        if count < FEWEST:
            continue
        others = PLACES if isinstance(key, int) else LETTERS if key.startswith(".") else sorted(stems)
        for other in others:
            new = other if isinstance(key, int) else f".{other}" if key.startswith(".") else other
            if new != key and (made := _with_key(node, key, new, variables)) is not None:
                yield made


def _key(node: ast.AST) -> Key | None:
    """Return the stem of a name, the letter of a field after its dot, the place of a member; None of all else."""
    if isinstance(node, ast.Name):
        match = STEM.fullmatch(node.id)
        return match[1] if match else None
    if isinstance(node, ast.Attribute):
        return f".{node.attr}" if node.attr in LETTERS else None
    if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant) and type(node.slice.value) is int:
        return node.slice.value
    return None


def _with_key(node: ast.BinOp, key: Key, new: Key, variables: set[str]) -> ast.BinOp | None:
    """Return a copy in which another stem, letter or place stands for this one; None if a name would be nobody's."""
    made = copy.deepcopy(node)
    for inner in [inner for inner in ast.walk(made) if _key(inner) == key]:
        if isinstance(inner, ast.Name):
            inner.id = f"{new}{inner.id.removeprefix(str(key))}"
            if inner.id not in variables:
                return None
        elif isinstance(inner, ast.Attribute):
            inner.attr = str(new).removeprefix(".")
        elif isinstance(inner, ast.Subscript):
            inner.slice = ast.Constant(new)
    return made
