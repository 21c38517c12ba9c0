"""Name the line of a learner's function in which an exception was raised, and the values that the line used.

    def frame_name(prefix, name):
        if prefix[0] == "/": ...           IndexError: string index out of range

    error_line(frame_name, args).said      'The error is in line 2, `prefix[0]`. There, `prefix` = `""`.'

All of it comes from the traceback, so it is certain.
"""

from __future__ import annotations

import ast
import linecache
import sys
import traceback
from collections.abc import Callable, Iterator, Sequence
from types import CodeType, FrameType
from typing import Any, NamedTuple

from ...text import Text, Texts
from ..answers.showing import show_in_a_line
from ..answers.values import Plain, from_plain
from ..call_limits import CALL_S, call_limits

__all__ = ["ErrorLine", "error_line", "hidden_error"]

TEXTS = Texts(__file__)

BUGS = (AttributeError, IndexError, KeyError, NameError, TypeError, ValueError, ZeroDivisionError)
BROAD = {"Exception", "BaseException"}
MOST_VALUES = 3
LONGEST_VALUE = 60  # characters


class ErrorLine(NamedTuple):
    """Where a function stopped: what to say of it, whether a `raise` of the learner did it, and whether that is all."""

    said: Text
    is_own_raise: bool = False
    is_cause: bool = False


def error_line(function: Callable[..., Any], args: Sequence[Plain]) -> ErrorLine | None:
    """Call a function once more and return where it stops; None if it does not, or where its text is not known."""
    try:
        with call_limits(CALL_S):
            function(*[from_plain(arg) for arg in args])
    except Exception as error:
        return _describe(function, error)
    except BaseException:
        return None
    return None


def hidden_error(function: Callable[..., Any], args: Sequence[Plain]) -> Text | None:
    """Call a function once more and return which bug its own `except` hides: a broad one, or a bare one."""
    file = getattr(getattr(function, "__code__", None), "co_filename", "")
    found: list[Text] = []

    def trace(frame: FrameType, event: str, arg: Any) -> Any:
        if frame.f_code.co_filename != file or found:
            return None
        if event == "exception" and issubclass(arg[0], Exception):
            handler = _handler_around(frame.f_code, frame.f_lineno)
            is_hidden = handler is not None and (issubclass(arg[0], BUGS) or isinstance(handler.body[0], ast.Pass))
            if is_hidden and (handler.type is None or getattr(handler.type, "id", "") in BROAD):
                line, clause = (linecache.getline(file, number) for number in (frame.f_lineno, handler.lineno))
                names = {"error": arg[0].__name__, "why": arg[1], "clause": _quoted(clause).rstrip(":")}
                found.append(TEXTS["hidden"].filled(line=frame.f_lineno, text=_quoted(line), **names))
        return trace

    before = sys.gettrace()
    try:
        with call_limits(CALL_S):
            sys.settrace(trace)
            function(*[from_plain(arg) for arg in args])
    except BaseException:
        return None
    finally:
        sys.settrace(before)
    return found[0] if found else None


def _describe(function: Callable[..., Any], error: Exception) -> ErrorLine | None:
    file = getattr(getattr(function, "__code__", None), "co_filename", "")
    rows = zip(traceback.walk_tb(error.__traceback__), traceback.extract_tb(error.__traceback__), strict=True)
    stack = [(frame, summary) for (frame, _), summary in rows]
    frame, summary = next((row for row in reversed(stack) if row[1].filename == file), (None, None))
    if frame is None or not summary.line:
        return None
    segment = _segment(summary)
    if summary is stack[-1][1] and segment.startswith("raise"):
        return ErrorLine(TEXTS["own"].filled(line=summary.lineno, text=_quoted(summary.line)), True, True)
    said = TEXTS["line"].filled(line=summary.lineno, text=_quoted(segment))
    values = [f"`{name}` = `{_shown(value)}`" for name, value in _values(segment, frame.f_locals)]
    if values:
        said = Text.joined(said, TEXTS["values"].filled(values=", ".join(values[:MOST_VALUES])))
    is_refusal = type(error).__name__.endswith("Exception")  # as tf2 names its own
    clause = _passed_by(frame.f_code, summary.lineno) if is_refusal else None
    if clause is not None:
        said = Text.joined(said, TEXTS["passed_by"].filled(clause=_quoted(clause), error=type(error).__name__))
    return ErrorLine(said, is_cause=clause is not None)


def _segment(summary: traceback.FrameSummary) -> str:
    """Return the expression that raised; the whole line where Python (3.10) does not say which one it was."""
    start, end = getattr(summary, "colno", None), getattr(summary, "end_colno", None)
    if start is None or end is None or summary.end_lineno != summary.lineno:
        return summary.line
    line = linecache.getline(summary.filename, summary.lineno)
    return line.encode()[start:end].decode(errors="ignore")  # columns count bytes


def _values(segment: str, variables: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    """Yield the variables of an expression that hold a value, each once."""
    try:
        tree = ast.parse(segment.strip().rstrip(":"))
    except SyntaxError:  # half of a statement
        return
    names = dict.fromkeys(node.id for node in ast.walk(tree) if isinstance(node, ast.Name))
    yield from ((name, variables[name]) for name in names if name in variables and not callable(variables[name]))


def _shown(value: Any) -> str:
    try:
        text = show_in_a_line(value)
    except Exception:  # an object of the learner's own
        text = type(value).__name__
    return text if len(text) <= LONGEST_VALUE else text[: LONGEST_VALUE - 2] + " …"


def _passed_by(code: CodeType, line: int) -> str | None:
    """Return the `except` clause around a line, in the same function, that did not catch the exception."""
    handler = _handler_around(code, line)
    return None if handler is None else linecache.getline(code.co_filename, handler.lineno).strip().rstrip(":")


def _handler_around(code: CodeType, line: int) -> ast.ExceptHandler | None:
    """Return the last handler of the first `try` of a function around a line."""
    try:
        tree = ast.parse("".join(linecache.getlines(code.co_filename)))
    except SyntaxError:  # a cell with a magic
        return None
    for node in ast.walk(tree):
        is_guard = isinstance(node, ast.Try) and node.handlers and node.lineno >= code.co_firstlineno
        if is_guard and node.body[0].lineno <= line <= (node.body[-1].end_lineno or 0):
            return node.handlers[-1]
    return None


def _quoted(text: str) -> str:
    return text.strip().replace("`", "'")
