"""How can a function differ from the one that was meant, in one place?  Every way that is often met, by its kind.

    if age < max_age_s:    edge  <=      side  >      sign  -age      name  now_s

An edit is something else at one spot of the tree (`tasks/ast_locations.py`).  What people mean to
write and do not is what mutation testing does to a right program, backwards (Debroy and
Wong, "Using mutation to automatically suggest fixes for faulty programs", 2010).
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from contextlib import AbstractContextManager
from itertools import permutations
from typing import Any, NamedTuple

from ..tasks.ast_locations import EDGES, OPPOSITES, SIDES, SIGNS, Location, locations_in, replaced_field
from .sums import bracketed, of_others

__all__ = ["KINDS", "Edit", "edits_of"]

KINDS = ("through", "too much", "choice", "edge", "side", "brackets", "copied", "order", "sign", "opposite", "logic",
         "function", "inverse", "field", "member", "loop", "exception", "surplus", "call", "lines", "operation",
         "number", "name", "word", "missing")  # fmt: skip
NEGATED = OPPOSITES | {ast.Is: ast.IsNot, ast.IsNot: ast.Is}
OPERATIONS = {ast.Mult: ast.Div, ast.Div: ast.Mult, ast.FloorDiv: ast.Div}
IN_ORDER = (ast.Sub, ast.Div, ast.MatMult, ast.Mod)  # a - b is not b - a
EXCHANGED = [("sin", "cos"), ("min", "max"), ("any", "all"), ("degrees", "radians"), ("floor", "ceil"),
             ("asin", "acos"), ("pi", "tau")]  # fmt: skip
FUNCTIONS = {one: other for pair in EXCHANGED for one, other in (pair, pair[::-1])}
FIELDS = [{"x", "y", "z", "w"}, {"translation", "rotation"}, {"sec", "nanosec"}, {"frame_id", "child_frame_id"}]
EXCEPTIONS = {"ValueError", "LookupException", "ConnectivityException", "ExtrapolationException",
              "InvalidArgumentException", "TransformException"}  # fmt: skip
WRAPPED = ("abs", "list", "len", "float", "int", "str")
ORDERED = ("sorted", "reversed")
WRAPPED_IN_MATH = ("radians", "degrees", "sin", "cos", "sqrt")
FACTORS = (-1, 2, 0.5, 10, 0.1, 1e3, 1e-3, 1e6, 1e-6, 1e9, 1e-9)
MOST_INDEX = 3
MOST_UNPACKED = 4
NUMBERS = (ast.Name, ast.Attribute, ast.Subscript, ast.Call, ast.BinOp)  # what a sign may stand before
Other = tuple[str, ast.AST]  # a kind, and what is meant instead


class Edit(NamedTuple):
    """One thing written otherwise: of which kind, the node that stands there now, the field to be set, and what comes
    instead where that is one node.
    """

    kind: str
    node: ast.AST
    owner: ast.AST
    field: str
    value: Any
    new: ast.AST | None = None

    def made(self) -> AbstractContextManager[None]:
        """Make the edit in its tree, for as long as this lasts."""
        return replaced_field(self.owner, self.field, self.value)


def edits_of(tree: ast.Module) -> list[Edit]:
    """Return the edits of the functions in a tree, those of the likeliest kinds first."""
    used = _Used(tree)
    return sorted(_edits(tree, used), key=lambda edit: KINDS.index(edit.kind))


class _Used:
    """What a function speaks of, and might have meant in another place."""

    def __init__(self, tree: ast.Module) -> None:
        nodes = list(ast.walk(tree))
        stored = {node.id for node in nodes if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)}
        self.variables = stored | {node.arg for node in nodes if isinstance(node, ast.arg)}
        self.words = {node.value for node in nodes if isinstance(node, ast.Constant) and isinstance(node.value, str)}
        self.words = {word for word in self.words if len(word) < 40}


def _edits(tree: ast.Module, used: _Used) -> Iterator[Edit]:
    for spot in locations_in(tree):
        node, owner, field = spot.node, spot.owner, spot.field
        if field in ("annotation", "returns", "decorator_list"):
            continue
        others = _others(node, owner, field, used)
        yield from (Edit(kind, node, owner, field, spot.with_(new), new) for kind, new in others)
        if isinstance(node, ast.stmt | ast.ExceptHandler) and not isinstance(node, ast.FunctionDef):
            yield from _edits_of_lines(spot, node)


def _edits_of_lines(spot: Location, node: ast.stmt | ast.ExceptHandler) -> Iterator[Edit]:
    """Yield a statement left out, one way alone, a `return` after its loop, this and the next the other way round."""
    owner, field = spot.owner, spot.field
    if isinstance(node, ast.stmt):
        yield Edit("too much", node, owner, field, spot.with_())
    if isinstance(node, ast.Try):
        yield Edit("through", node, owner, field, spot.with_(*node.body, *node.orelse, *node.finalbody))
    if isinstance(node, ast.If):
        ways = (way for way in (node.body, node.orelse) if way)
        yield from (Edit("choice", node, owner, field, spot.with_(*way)) for way in ways)
    if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Tuple):
        yield from (Edit("order", node, node, "targets", [other]) for other in _unpacked_otherwise(node.targets[0]))
    if isinstance(node, ast.For) and len(node.body) > 1 and isinstance(last := node.body[-1], ast.Return):
        yield Edit(
            "loop", last, owner, field, spot.with_(ast.For(node.target, node.iter, node.body[:-1], node.orelse), last)
        )
    held = getattr(owner, field)
    if then := held[spot.place + 1 : spot.place + 2]:
        yield Edit("lines", node, owner, field, [*held[: spot.place], *then, node, *held[spot.place + 2 :]])


def _unpacked_otherwise(names: ast.Tuple) -> Iterator[ast.Tuple]:
    """Yield the same names in each other order: x, y, yaw for yaw, x, y."""
    orders = permutations(names.elts) if len(names.elts) <= MOST_UNPACKED else ()
    yield from (ast.Tuple(list(order), ast.Store()) for order in orders if list(order) != names.elts)


def _others(node: ast.AST, owner: ast.AST, field: str, used: _Used) -> Iterator[Other]:
    """Yield what might be meant where `node` stands, in a field of its owner."""
    if isinstance(getattr(node, "ctx", None), ast.Store | ast.Del):
        return
    change = CHANGES.get(type(node))
    if change is not None:
        yield from change(node, used)
    if isinstance(node, NUMBERS) and not isinstance(owner, ast.Attribute | ast.Expr) and field not in ("func", "exc"):
        yield "sign", ast.UnaryOp(ast.USub(), node)
        yield from (("missing", ast.Call(function, [node], [])) for function in _functions())
    yield from _in_its_place(node, owner, field)
    if isinstance(node, ast.BinOp) and not isinstance(owner, ast.BinOp):
        yield from (("copied", other) for other in of_others(node, used.variables))


def _in_its_place(node: ast.AST, owner: ast.AST, field: str) -> Iterator[Other]:
    """Yield what might be meant because of what the node is there for: a condition, an exception, a result."""
    if field == "test" and isinstance(owner, ast.If | ast.IfExp):
        yield "opposite", ast.UnaryOp(ast.Not(), node)
    if isinstance(owner, ast.ExceptHandler | ast.Raise) and field in ("type", "exc"):
        yield from _exceptions(node)
    if isinstance(owner, ast.Return | ast.Assign) and isinstance(node, (*NUMBERS, ast.Tuple, ast.List)):
        yield from (("order", ast.Call(ast.Name(name, ast.Load()), [node], [])) for name in ORDERED)
    is_of_product = isinstance(owner, ast.BinOp) and isinstance(owner.op, ast.MatMult)
    if is_of_product or (isinstance(owner, ast.Attribute) and owner.attr == "apply"):
        yield "inverse", ast.Call(ast.Attribute(node, "inverse", ast.Load()), [], [])


def _functions() -> list[ast.expr]:
    in_math = [ast.Attribute(ast.Name("math", ast.Load()), name, ast.Load()) for name in WRAPPED_IN_MATH]
    return [*(ast.Name(name, ast.Load()) for name in WRAPPED), *in_math]


def _exceptions(node: ast.AST) -> Iterator[Other]:
    named = node.func if isinstance(node, ast.Call) else node
    if isinstance(named, ast.Name):
        for name in sorted(EXCEPTIONS - {named.id}):
            new = ast.Name(name, ast.Load())
            yield "exception", ast.Call(new, node.args, node.keywords) if isinstance(node, ast.Call) else new


def _compared(node: ast.Compare, _used: _Used) -> Iterator[Other]:
    for kind, others in (("edge", EDGES), ("side", SIDES), ("opposite", NEGATED)):
        for place, op in enumerate(node.ops):
            if type(op) in others:
                ops = [*node.ops[:place], others[type(op)](), *node.ops[place + 1 :]]
                yield kind, ast.Compare(node.left, ops, node.comparators)


def _computed(node: ast.BinOp, _used: _Used) -> Iterator[Other]:
    if isinstance(node.op, IN_ORDER):
        yield "order", ast.BinOp(node.right, node.op, node.left)
    yield from (("brackets", other) for other in bracketed(node))
    yield from (("surplus", side) for side in (node.left, node.right))
    for kind, others in (("sign", SIGNS), ("operation", OPERATIONS)):
        if type(node.op) in others:
            yield kind, ast.BinOp(node.left, others[type(node.op)](), node.right)


def _chosen(node: ast.IfExp, _used: _Used) -> Iterator[Other]:
    yield from (("choice", way) for way in (node.body, node.orelse))


def _joined(node: ast.BoolOp, _used: _Used) -> Iterator[Other]:
    yield "logic", ast.BoolOp(ast.Or() if isinstance(node.op, ast.And) else ast.And(), node.values)


def _signed(node: ast.UnaryOp, _used: _Used) -> Iterator[Other]:
    if isinstance(node.op, ast.USub | ast.Not):
        yield ("sign" if isinstance(node.op, ast.USub) else "opposite"), node.operand


def _call(node: ast.Call, _used: _Used) -> Iterator[Other]:
    for place in range(len(node.args) - 1):
        args = [*node.args[:place], node.args[place + 1], node.args[place], *node.args[place + 2 :]]
        yield "order", ast.Call(node.func, args, node.keywords)
    if len(node.args) == 1 and not node.keywords and not isinstance(node.args[0], ast.Starred | ast.GeneratorExp):
        yield "call", node.args[0]  # f(x) -> x
        if isinstance(node.func, ast.Attribute):
            yield "order", ast.Call(ast.Attribute(node.args[0], node.func.attr, ast.Load()), [node.func.value], [])
    if not node.args and isinstance(node.func, ast.Attribute):
        yield "call", node.func.value  # x.f() -> x


def _named(node: ast.Name, used: _Used) -> Iterator[Other]:
    if node.id in FUNCTIONS:
        yield "function", ast.Name(FUNCTIONS[node.id], ast.Load())
    if node.id in used.variables:
        yield from (("name", ast.Name(name, ast.Load())) for name in sorted(used.variables - {node.id}))


def _attribute(node: ast.Attribute, _used: _Used) -> Iterator[Other]:
    if node.attr in FUNCTIONS:
        yield "function", ast.Attribute(node.value, FUNCTIONS[node.attr], ast.Load())
    for group in FIELDS:
        if node.attr in group:
            yield from (("field", ast.Attribute(node.value, name, ast.Load())) for name in sorted(group - {node.attr}))


def _indexed(node: ast.Subscript, used: _Used) -> Iterator[Other]:
    if not isinstance(node.slice, ast.Constant):
        return
    index = node.slice.value
    others = sorted(used.words - {index}) if isinstance(index, str) else [-1, *range(MOST_INDEX + 1)]
    yield from (
        ("member", ast.Subscript(node.value, ast.Constant(other), ast.Load())) for other in others if other != index
    )


def _constant(node: ast.Constant, used: _Used) -> Iterator[Other]:
    held = node.value
    if isinstance(held, bool) or held is None:
        if held is not None:
            yield "opposite", ast.Constant(not held)
    elif isinstance(held, int | float):
        near = (held + 1, held - 1, 0, 1) if isinstance(held, int) else ()
        others = [*near, *(held * factor for factor in FACTORS), *([1 / held] if held else [])]
        yield from (("number", ast.Constant(other)) for other in dict.fromkeys(others) if other != held)
    elif isinstance(held, str):
        yield from (("word", ast.Constant(word)) for word in sorted(used.words - {held}))


CHANGES: dict[type, Any] = {
    ast.Compare: _compared, ast.BinOp: _computed, ast.BoolOp: _joined, ast.UnaryOp: _signed, ast.Call: _call,
    ast.Name: _named, ast.Attribute: _attribute, ast.Subscript: _indexed, ast.Constant: _constant,
    ast.IfExp: _chosen,
}  # fmt: skip
