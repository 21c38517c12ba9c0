"""How is somebody's function called again, edited?  On copies, with an end, and only if it is plain.

    written_by(fresh)                  its text, its first line and its tree; None of what is better left alone
    edited_as(edit, fresh, tree, end)  the edited one, for calls until `end`

What its cell holds beside it, lists and dicts, is copied for each edit: nothing of a
learner's is changed, and no edit sees what another left.  An edit may make a loop feed
itself, so lines are counted.
"""

from __future__ import annotations

import ast
import copy
import inspect
import sys
import textwrap
import time
from collections.abc import Callable, Iterator
from types import CodeType, FrameType, FunctionType
from typing import Any

from .edits import Edit

__all__ = ["edited_as", "text_of", "with_its_own", "written_by"]

MOST_LINES = 20_000  # of a call
MOST_HELD = 1_000  # members of a list beside the function
FORBIDDEN = (ast.While, ast.Await, ast.Yield, ast.YieldFrom, ast.Import, ast.ImportFrom, ast.Global, ast.Nonlocal)
TOUCHY = {"open", "input", "exec", "eval", "os", "shutil", "subprocess", "sleep", "pathlib", "Path"}


def text_of(function: Any) -> tuple[str, int, ast.Module] | None:
    """Return a function's text, its first line in its cell, and its tree; None where it cannot be read."""
    if not isinstance(function, FunctionType):
        return None
    try:
        lines, first = inspect.getsourcelines(function)
        tree = ast.parse(text := textwrap.dedent("".join(lines)))
    except (OSError, TypeError, SyntaxError, ValueError):
        return None
    return text, max(first, 1), tree


def written_by(function: Any) -> tuple[str, int, ast.Module] | None:
    """Return the same, and None where it is better not called again."""
    written = None if getattr(function, "__closure__", None) else text_of(function)
    if written is None or not _is_plain(written[2]):
        return None
    if any(len(held) > MOST_HELD for held in _beside(function).values() if not isinstance(held, FunctionType)):
        return None
    return written


def with_its_own(function: Any) -> list[Any]:
    """Return a function, and those of its cells that it calls."""
    beside = _beside(function) if isinstance(function, FunctionType) else {}
    return [function, *(held for held in beside.values() if isinstance(held, FunctionType) and held is not function)]


def _is_plain(tree: ast.Module) -> bool:
    """Return whether this is one function and no more, which comes to an end and touches nothing outside."""
    nodes = list(ast.walk(tree))
    touched = {node.id for node in nodes if isinstance(node, ast.Name)}
    touched |= {node.attr for node in nodes if isinstance(node, ast.Attribute)}
    is_one = len(tree.body) == 1 and isinstance(tree.body[0], ast.FunctionDef) and not tree.body[0].decorator_list
    return is_one and not touched & TOUCHY and not any(isinstance(node, FORBIDDEN) for node in nodes)


def edited_as(edit: Edit, function: FunctionType, tree: ast.Module, end: float) -> Callable[..., Any] | None:
    """Return the function as edited, to be called until `end` (of `time.monotonic`); None where that is no Python."""
    beside = _beside(function)
    try:
        held = {name: value for name, value in beside.items() if not isinstance(value, FunctionType)}
        names = function.__globals__ | copy.deepcopy(held)
        names |= {name: _with_names(value, names) for name, value in beside.items() if name not in held}
        with edit.made():
            exec(compile(ast.fix_missing_locations(tree), "<edited>", "exec"), names)
    except Exception:  # or what cannot be copied, or a default that cannot be computed
        return None
    edited = names.get(function.__name__)
    return _bounded(edited, names, end) if callable(edited) else None


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


def _with_names(function: FunctionType, names: dict[str, Any]) -> FunctionType:
    return FunctionType(function.__code__, names, function.__name__, function.__defaults__, function.__closure__)


def _bounded(function: Callable[..., Any], names: dict[str, Any], end: float) -> Callable[..., Any]:
    """Return a function that raises RuntimeError after so many lines of its own, or past the end."""

    def called(*args: Any) -> Any:
        left = MOST_LINES

        def at_line(_frame: FrameType, _event: str, _arg: Any) -> Any:
            nonlocal left
            left -= 1
            if left < 0:
                raise _TooLongError
            return at_line

        def at_call(frame: FrameType, _event: str, _arg: Any) -> Any:
            return at_line if frame.f_globals is names else None

        if time.monotonic() > end:
            raise RuntimeError("too late")
        before = sys.gettrace()
        sys.settrace(at_call)
        try:
            return function(*args)
        except _TooLongError:
            raise RuntimeError("too long") from None
        finally:
            sys.settrace(before)

    return called


class _TooLongError(BaseException):
    """What `except Exception` in a learner's function does not catch."""
