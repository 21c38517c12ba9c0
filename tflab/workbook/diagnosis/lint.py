"""Find what is wrong in the text of a function by Python's own rules."""

from __future__ import annotations

import ast
import builtins
import inspect
import re
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import pairwise
from types import CodeType, FunctionType
from typing import Any

from ...text import Text, Texts

__all__ = ["describe_cell_text", "describe_function_text"]

TEXTS = Texts(__file__)

Found = Iterator[tuple[ast.AST, Text]]

LONGEST_LINE = 70
ENDS = (ast.Return, ast.Raise, ast.Continue, ast.Break)
NEW_EACH_TIME = {"sorted", "reversed", "str", "float", "int", "round", "abs"}
METHODS_OF_NEW = {"replace", "strip", "lstrip", "rstrip", "lower", "upper", "removeprefix", "removesuffix", "inverse"}
NANS = {"nan", "math.nan", "np.nan", "numpy.nan", "float('nan')"}
MEASURED = re.compile(r"\w+_(s|ms|m|mm|cm|hz|deg|rad|mps|radps|degps)|yaw|pitch|roll|angle|theta|slope")
STRIPS = {"strip", "lstrip", "rstrip"}
IN_PLACE = {"append", "extend", "sort", "reverse"}
OF_NUMPY = {"np", "numpy"}


def describe_function_text(function: Any) -> Text | None:
    """Return what is plain to see first in the text of a function, or of one of its cell that it calls; else None."""
    return next(filter(None, map(_said_of, _with_its_own(function))), None)


def describe_cell_text(source: str, given: str = "") -> Text | None:
    """Return what is plain to see first in the text of an answer's cell, or that it does not use what is given."""
    try:
        tree = ast.parse(source)
    except SyntaxError:
        return None
    shown = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None  # a notebook shows its value
    said = _first_of(source, 1, tree, vars(builtins))
    nodes = [*ast.walk(tree), *(ast.walk(shown) if shown else ())]
    if said is None and given and not any(isinstance(node, ast.Name) and node.id == given for node in nodes):
        return TEXTS["given_unused"].filled(name=given)
    return said


def _said_of(function: Any) -> Text | None:
    written = _text_of(function)
    return _first_of(*written, vars(builtins) | function.__globals__) if written else None


def _first_of(text: str, first: int, tree: ast.Module, names: Mapping[str, Any]) -> Text | None:
    found = sorted(_found(tree, names), key=lambda row: (not isinstance(row[0], ast.Return), row[0].lineno))
    for node, said in found[:1]:  # what is returned, or else the first line
        line = first + node.lineno - 1
        return TEXTS["in_line"].filled(line=line, text=_quoted(text, tree, node).rstrip(":"), said=said)
    return None


def _found(tree: ast.Module, names: Mapping[str, Any]) -> Found:
    tests = _tests(tree)
    for node in ast.walk(tree):
        yield from _after_an_end(node)
        for look in LOOKS.get(type(node), ()):
            yield from look(node, names)
        if isinstance(node, ast.BoolOp):
            yield from _joined(node, tests)
        elif node in tests and isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "find":
            yield node, TEXTS["found_nowhere"]


def _tests(tree: ast.Module) -> set[ast.AST]:
    """Return what is only asked whether it counts as true."""
    tests = {test for node in ast.walk(tree) if isinstance(test := getattr(node, "test", None), ast.expr)}
    tests |= {test for node in ast.walk(tree) if isinstance(node, ast.comprehension) for test in node.ifs}
    asked = list(tests)
    for node in asked:  # which grows
        if isinstance(node, ast.BoolOp):
            asked += node.values
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            asked.append(node.operand)
    return set(asked)


def _joined(node: ast.BoolOp, tests: set[ast.AST]) -> Found:
    """Yield that a side of `or` or `and` is a constant."""
    held = [value for value in node.values if isinstance(value, ast.Constant) and value.value]
    inner = [value for value in held if value is not node.values[-1]]
    if isinstance(node.op, ast.And) and inner:
        yield node, TEXTS["asks_nothing"].filled(word=_word(inner[0]))
    elif isinstance(node.op, ast.Or) and held and node in tests:
        yield node, TEXTS["holds_always"].filled(word=_word(held[0]))
    elif isinstance(node.op, ast.Or) and inner and inner[0] is node.values[0]:
        yield node, TEXTS["one_always"].filled(word=_word(inner[0]))


def _word(node: ast.Constant) -> str:
    return f'"{node.value}"' if isinstance(node.value, str) else str(node.value)


def _after_an_end(node: ast.AST) -> Found:
    """Yield what stands behind a `return` in the same block, but for the `raise` that a blank answer has."""
    blocks = [getattr(node, name, None) for name in ("body", "orelse", "finalbody")]
    for block in (held for held in blocks if isinstance(held, list)):
        for one, then in pairwise(block):
            if isinstance(one, ENDS) and not isinstance(then, ast.Raise):
                yield then, TEXTS["after_the_end"]


def _only_printed(node: ast.Try, _names: Mapping[str, Any]) -> Found:
    """Yield a handler that prints a word where another one returns its own."""
    if not any(isinstance(handler.body[-1], ast.Return) for handler in node.handlers):
        return
    yield from ((held, TEXTS["only_printed"]) for held, _ in _prints_alone(handler.body for handler in node.handlers))


def _printed_in_an_if(node: ast.If, _names: Mapping[str, Any]) -> Found:
    """Yield a way of an `if` that prints a word where another way returns its own."""
    chain = _chain(node)
    branches = [*(one.body for one in chain), chain[-1].orelse]
    if any(isinstance(branch[-1], ast.Return) for branch in branches if branch):
        for held, call in _prints_alone(branches):
            if all(isinstance(one, ast.Constant) for one in call.args):
                yield held, TEXTS["only_printed"]


def _prints_alone(blocks: Iterable[list[ast.stmt]]) -> Iterator[tuple[ast.stmt, ast.Call]]:
    """Yield the line of each block that does nothing but print, and its call."""
    for (held,) in (block for block in blocks if len(block) == 1):
        call = held.value if isinstance(held, ast.Expr) and isinstance(held.value, ast.Call) else None
        if call and getattr(call.func, "id", "") == "print":
            yield held, call


def _chain(node: ast.If) -> list[ast.If]:
    """Return an `if` with its `elif`s."""
    chain = [node]
    while len(chain[-1].orelse) == 1 and isinstance(chain[-1].orelse[0], ast.If):
        chain.append(chain[-1].orelse[0])
    return chain


def _look_at_handlers(node: ast.Try, names: Mapping[str, Any]) -> Found:
    """Yield handlers that others stand before, and a `return` that goes over all others."""
    before: list[tuple[str, type]] = []
    for handler in node.handlers:
        classes = _classes(handler.type, names)
        takers = [next((name for name, one in before if issubclass(other, one)), None) for _, other in classes]
        if classes and all(takers):
            yield handler, TEXTS["never_reached"].filled(name=takers[0])
        before += classes
        if isinstance(handler.type, ast.BoolOp) and isinstance(handler.type.op, ast.Or):
            yield handler, TEXTS["first_class_alone"]
    yield from ((last, TEXTS["goes_over_all"]) for last in node.finalbody if isinstance(last, ast.Return))


def _classes(node: ast.expr | None, names: Mapping[str, Any]) -> list[tuple[str, type]]:
    """Return the exceptions that a handler names; none where one of them is not known."""
    members = node.elts if isinstance(node, ast.Tuple) else [node]
    held = [(one.id, names.get(one.id)) for one in members if isinstance(one, ast.Name)]
    return held if len(held) == len(members) and all(map(_is_exception, held)) else []


def _is_exception(named: tuple[str, Any]) -> bool:
    return isinstance(named[1], type) and issubclass(named[1], BaseException)


def _look_at_a_comparison(node: ast.Compare, _names: Mapping[str, Any]) -> Found:
    """Yield a chain with `in`, and a comparison with NaN or with the text of a bool, which says always the same."""
    if len(node.ops) > 1 and any(isinstance(op, ast.In | ast.NotIn) for op in node.ops):
        yield node, TEXTS["a_chain"]
    if any(map(_is_by_identity, node.ops, node.comparators)):
        yield node, TEXTS["same_object"]
    sides = [held for side in (node.left, *node.comparators) for held in getattr(side, "elts", [side])]
    if any(ast.unparse(held).lower() in NANS for held in sides):
        yield node, TEXTS["equals_nothing"]
    texts = [held.value for held in sides if isinstance(held, ast.Constant) and held.value in ("True", "False")]
    if texts and len(node.ops) == 1 and isinstance(node.ops[0], ast.Eq | ast.NotEq):
        yield node, TEXTS["text_of_a_bool"].filled(word=texts[0])


def _is_by_identity(op: ast.cmpop, right: ast.expr) -> bool:
    return (
        isinstance(op, ast.Is | ast.IsNot)
        and isinstance(getattr(right, "value", None), str | int | float)
        and not isinstance(right.value, bool)
    )


def _look_at_a_division(node: ast.BinOp, _names: Mapping[str, Any]) -> Found:
    """Yield that `//` drops the fraction of a measured number."""
    words = [getattr(side, "attr", getattr(side, "id", "")) for side in (node.left, node.right)]
    if isinstance(node.op, ast.FloorDiv) and any(MEASURED.fullmatch(word) for word in words):
        yield node, TEXTS["drops_fraction"]


def _look_at_an_if(node: ast.If, _names: Mapping[str, Any]) -> Found:
    """Yield an `elif` that asks what was asked before it."""
    asked = ast.dump(node.test)
    yield from ((other, TEXTS["asked_above"]) for other in _chain(node)[1:] if ast.dump(other.test) == asked)


def _look_at_a_line(node: ast.Expr, _names: Mapping[str, Any]) -> Found:
    """Yield a line that stands for itself and does nothing."""
    held = node.value
    if isinstance(held, ast.Attribute):
        yield node, TEXTS["not_called"]
    elif isinstance(held, ast.Compare) and isinstance(held.ops[0], ast.Eq):
        yield node, TEXTS["not_set"]
    elif isinstance(held, ast.BinOp) or (isinstance(held, ast.Call) and _is_of_new(held.func)):
        yield node, TEXTS["not_kept"]


def _is_of_new(function: ast.expr) -> bool:
    if isinstance(function, ast.Attribute):
        is_sort = function.attr == "sort" and getattr(function.value, "id", "") in OF_NUMPY
        return is_sort or function.attr in METHODS_OF_NEW
    return isinstance(function, ast.Name) and function.id in NEW_EACH_TIME


def _look_at_what_is_kept(node: ast.Assign | ast.Return | ast.For, _names: Mapping[str, Any]) -> Found:
    """Yield a list that is changed in its place where a new one is meant."""
    held = node.iter if isinstance(node, ast.For) else node.value
    method = held.func if isinstance(held, ast.Call) and isinstance(held.func, ast.Attribute) else None
    if method and method.attr in IN_PLACE and getattr(method.value, "id", "") not in OF_NUMPY:
        yield node, TEXTS["gives_none"].filled(name=method.attr)


def _look_at_a_call(node: ast.Call, names: Mapping[str, Any]) -> Found:
    """Yield `str(LookupException)`, where the text of an error is meant, and `strip` of a whole word."""
    if getattr(node.func, "attr", "") in STRIPS and node.args and isinstance(node.args[0], ast.Constant):
        word = str(node.args[0].value)
        if len(set(word)) > 1 and any(map(str.isalpha, word)):
            yield node, TEXTS["strips_letters"].filled(method=node.func.attr, word=word)
    if getattr(node.func, "id", "") == "str" and len(node.args) == 1 and isinstance(node.args[0], ast.Name):
        name = node.args[0].id
        if _is_exception((name, names.get(name))):
            yield node, TEXTS["text_of_a_class"]


# -- reading a function ---------------------------------------------------------------------


def _text_of(function: Any) -> tuple[str, int, ast.Module] | None:
    """Return a function's text, its first line in its cell, and its tree; None where it cannot be read."""
    if not isinstance(function, FunctionType):
        return None
    try:
        lines, first = inspect.getsourcelines(function)
        tree = ast.parse(text := textwrap.dedent("".join(lines)))
    except (OSError, TypeError, SyntaxError, ValueError):
        return None
    return text, max(first, 1), tree


def _with_its_own(function: Any) -> list[Any]:
    """Return a function, and those of its cells that it calls."""
    beside = _beside(function) if isinstance(function, FunctionType) else {}
    return [function, *(held for held in beside.values() if isinstance(held, FunctionType) and held is not function)]


def _beside(function: FunctionType) -> dict[str, Any]:
    """Return what a function uses of its cells: other functions, what these use, and what can be changed in place."""
    found: dict[str, Any] = {}
    names = list(_names_in(function.__code__))
    for name in names:  # which grows
        held = function.__globals__.get(name)
        is_own = isinstance(held, FunctionType) and held.__globals__ is function.__globals__
        if name not in found and (is_own or type(held) in (list, dict, set)):
            found[name] = held
            names += _names_in(held.__code__) if is_own else ()
    return found


def _names_in(code: CodeType) -> Iterator[str]:
    yield from code.co_names
    for inner in code.co_consts:
        if isinstance(inner, CodeType):
            yield from _names_in(inner)


def _quoted(text: str, tree: ast.Module, node: ast.AST) -> str:
    """Return a line as it was written; of a long one the longest expression around the node that can be read."""
    line = getattr(node, "lineno", 1)
    whole = text.splitlines()[line - 1].strip()
    around = (ast.get_source_segment(text, other) or "" for other in ast.walk(tree) if _holds(other, node))
    parts = [part for part in around if len(part) <= LONGEST_LINE and "\n" not in part]
    short = whole if len(whole) <= LONGEST_LINE else max(parts, key=len, default=whole[:LONGEST_LINE])
    return short.replace("`", "'")


def _holds(other: ast.AST, node: ast.AST) -> bool:
    return isinstance(other, ast.expr) and any(inner is node for inner in ast.walk(other))


LOOKS: dict[type, tuple[Callable[[Any, Mapping[str, Any]], Found], ...]] = {
    ast.Try: (_look_at_handlers, _only_printed), ast.Compare: (_look_at_a_comparison,),
    ast.BinOp: (_look_at_a_division,), ast.If: (_look_at_an_if, _printed_in_an_if),
    ast.Expr: (_look_at_a_line,),
    ast.Assign: (_look_at_what_is_kept,), ast.Return: (_look_at_what_is_kept,), ast.For: (_look_at_what_is_kept,),
    ast.Call: (_look_at_a_call,),
}  # fmt: skip
