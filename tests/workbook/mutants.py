"""Corrupt a solution in one place after the other, and return what passes (mutation testing).

    abs(length - 1) > 0.01    -->    abs(length - 1) >= 0.01     passes?  then no input stands at the bound
                              -->    abs(length + 1) > 0.01      refused, as it should be
                              -->    abs(length - 1) > 0.0101    passes?  then no input is just past it

A *mutant* that passes is a *survivor*, and shows an input that is missing.  Some mean the
same as the solution; those stand with the task as `equivalent`, each with its reason.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

from tflab.workbook.answers.values import from_plain, outcome_of
from tflab.workbook.tasks.case_types import Variant
from tflab.workbook.tasks.reference import Solution, answer_cell_name
from tflab.workbook.tasks.task import Task, TaskError

__all__ = ["mutants_of", "survivors"]

EDGES = {ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt}
SIDES = {ast.Lt: ast.Gt, ast.LtE: ast.GtE, ast.Gt: ast.Lt, ast.GtE: ast.LtE}
OPPOSITES = {ast.Eq: ast.NotEq, ast.NotEq: ast.Eq, ast.In: ast.NotIn, ast.NotIn: ast.In}
COMPUTED = {ast.Add: ast.Sub, ast.Sub: ast.Add} | {ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult}
SYMMETRIC = {"min", "max", "hypot"}  # the same whichever argument comes first
CALLED = {"sin": "cos", "cos": "sin", "min": "max", "max": "min", "any": "all", "all": "any"}


class Mutant(NamedTuple):
    """A solution corrupted in one place: the name of the change, and the whole cell."""

    name: str
    source: str


def mutants_of(source: str, hair: float = 1e-3) -> list[Mutant]:
    """Return the mutants of a cell, each changed in one place; numbers by a part `hair` of theirs."""
    tree = ast.parse(source)
    whole = ast.unparse(tree)
    made: dict[str, Mutant] = {}
    for owner, field, place, node in list(_locations(tree)):
        held = getattr(owner, field)
        for new in _changes(node, hair):
            after_all = [new] if new is not None else []
            replaced = new if place is None else [*held[:place], *after_all, *held[place + 1 :]] or [ast.Pass()]
            setattr(owner, field, replaced)
            after = ast.unparse(ast.fix_missing_locations(tree))
            setattr(owner, field, held)
            if after != whole:
                made.setdefault(after, Mutant(_name(tree, node, new), after))
    return list(made.values())


def _locations(tree: ast.AST) -> Iterator[tuple[ast.AST, str, int | None, ast.AST]]:
    """Yield each node with its owner, the owner's field, and its place if that is a list, level by level."""
    for owner in ast.walk(tree):
        for field, held in ast.iter_fields(owner):
            if isinstance(held, ast.AST):
                yield owner, field, None, held
            elif isinstance(held, list):
                yield from ((owner, field, place, node) for place, node in enumerate(held) if isinstance(node, ast.AST))


def _name(tree: ast.AST, node: ast.AST, new: ast.AST | None) -> str:
    """Return what is changed, and in which statement if that is not too long to say."""
    if new is None:
        return f"without: {_short(node)}"
    statement = _statement(tree, node)
    return f"{_short(node)} -> {_short(new)}" + (f" in: {statement}" if len(statement) < 60 else "")


def survivors(task: Task, variants: Sequence[Variant], solution: Solution, choose: Callable = list) -> list[str]:
    """Return the names of the mutants that pass: functions in any variant, values in all, for a value may be right.

    Args:
        choose: returns the mutants to try.
    """
    mutants = choose(_mutants(task, solution))
    enough = any if task.inputs else all
    return [
        mutant.name for mutant in mutants if enough(_passes(task, variant, solution, mutant) for variant in variants)
    ]


def _mutants(task: Task, solution: Solution) -> list[Mutant]:
    """Return the mutants of a task's answer: a function's by a hair, a value's by more than its tolerance."""
    return mutants_of(solution.source(answer_cell_name(task.id)), 1e-3 if task.inputs else 0.1)


def _passes(task: Task, variant: Variant, solution: Solution, mutant: Mutant) -> bool:
    given = variant.given
    held = {name: from_plain(value) for name, value in given.items()} if given is not None else None
    try:
        answer = solution.answer(task, held, mutant.source)
    except TaskError:
        return False
    for case in variant.cases:
        outcome = outcome_of(answer, case.args) if case.args is not None else outcome_of(lambda: answer, ())
        if not task.form.same(outcome, case.expected):
            return False
    return True


# -- what is changed ---------------------------------------------------------------------


def _changes(node: ast.AST, hair: float) -> list[ast.AST | None]:
    """Return what may stand in a node's place; None for nothing at all."""
    change = CHANGES.get(type(node))
    return change(node, hair) if change else []


def _compared(node: ast.Compare, _hair: float) -> list[ast.AST]:
    return [
        ast.Compare(node.left, [*node.ops[:n], other(), *node.ops[n + 1 :]], node.comparators)
        for n, op in enumerate(node.ops)
        for other in (others[type(op)] for others in (EDGES, SIDES, OPPOSITES) if type(op) in others)
    ]


def _computed(node: ast.BinOp, _hair: float) -> list[ast.AST]:
    swapped: list[ast.AST] = []
    if isinstance(node.op, ast.MatMult | ast.Sub):
        swapped.append(ast.BinOp(node.right, node.op, node.left))
    if isinstance(node.op, ast.Div) and not isinstance(node.right, ast.Constant):
        swapped.append(ast.Call(ast.Name("round", ast.Load()), [node, ast.Constant(2)], []))
    other = COMPUTED.get(type(node.op))
    return swapped + ([ast.BinOp(node.left, other(), node.right)] if other else [])


def _joined(node: ast.BoolOp, _hair: float) -> list[ast.AST]:
    return [ast.BoolOp(ast.Or() if isinstance(node.op, ast.And) else ast.And(), node.values)]


def _signed(node: ast.UnaryOp, _hair: float) -> list[ast.AST]:
    return [node.operand] if isinstance(node.op, ast.USub | ast.Not) else []


def _constant(node: ast.Constant, hair: float) -> list[ast.AST]:
    return [ast.Constant(value) for value in _others(node.value, hair)]


def _branch(node: ast.If, _hair: float) -> list[ast.AST]:
    return [ast.If(ast.Constant(value), node.body, node.orelse) for value in (True, False)]


def _dropped(node: ast.Assign | ast.AugAssign, _hair: float) -> list[None]:
    return [] if isinstance(node.value, ast.Dict) else [None]


def _others(value: Any, hair: float) -> list[Any]:
    if isinstance(value, bool):
        return [not value]
    if isinstance(value, int):
        return [value + 1, value - 1]
    if isinstance(value, float):
        return [value * (1.0 + hair), value * (1.0 - hair)] if value else [10 * hair, -10 * hair]
    return []


def _called(node: ast.Call, _hair: float) -> list[ast.AST]:
    made: list[ast.AST] = []
    if isinstance(node.func, ast.Attribute) and node.func.attr in CALLED:
        made.append(
            ast.Call(ast.Attribute(node.func.value, CALLED[node.func.attr], ast.Load()), node.args, node.keywords)
        )
    if isinstance(node.func, ast.Name) and node.func.id in CALLED:
        made.append(ast.Call(ast.Name(CALLED[node.func.id], ast.Load()), node.args, node.keywords))
    if len(node.args) > 1 and ast.unparse(node.func).rpartition(".")[2] not in SYMMETRIC:
        made.append(ast.Call(node.func, [node.args[1], node.args[0], *node.args[2:]], node.keywords))
    if len(node.args) == 1 and not node.keywords and not isinstance(node.args[0], ast.Starred | ast.GeneratorExp):
        made.append(node.args[0])  # f(x) -> x
    if not node.args and isinstance(node.func, ast.Attribute):
        made.append(node.func.value)  # x.f() -> x
    return made


CHANGES: dict[type, Callable[[Any, float], list]] = {
    ast.Compare: _compared, ast.BinOp: _computed, ast.BoolOp: _joined, ast.UnaryOp: _signed, ast.Constant: _constant,
    ast.Call: _called, ast.If: _branch, ast.Assign: _dropped, ast.AugAssign: _dropped,
}  # fmt: skip


def _statement(tree: ast.AST, node: ast.AST) -> str:
    """Return the smallest statement that holds a node, in a line."""
    around = [part for part in ast.walk(tree) if isinstance(part, ast.stmt) and any(n is node for n in ast.walk(part))]
    return _short(min(around, key=lambda statement: sum(1 for _ in ast.walk(statement))))


def _short(node: ast.AST) -> str:
    return ast.unparse(node).partition("\n")[0]
