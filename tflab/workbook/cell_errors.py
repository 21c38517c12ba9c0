"""Explain why a cell failed, and hide the engine's own lines from its traceback.

    NameError: name 'base_p_corner' is not defined
    base_p_corner: Not there yet. Run the cell above with your answer, then this one again.

The tips that `check` has for Python's own TypeErrors are given here, too.

An error is shown as far as the reader's own code goes: what the engine was at is
left out, unless somebody asks for everything (`%xmode Verbose`).  An answer's cell
that fails leaves no older answer behind for `check` to speak of.
`%load_ext tflab` sees to it.
"""

from __future__ import annotations

import difflib
import os
import re
import sysconfig
from collections.abc import Mapping
from pathlib import Path
from types import SimpleNamespace, TracebackType
from typing import Any

from ..text import Texts
from .diagnosis.python_errors import python_error_hint
from .paths import language_here
from .reply_card import show_reply

__all__ = ["register", "source_of"]

MAKES = re.compile(r"^(?:def\s+(\w+)|(\w+)\s*=(?!=))", re.MULTILINE)
CHECKS = re.compile(r"^\s*check\(", re.MULTILINE)
OF_THE_WORKBOOK = ("check", "hint", "lesson", "solution", "task")  # a page's first cell brings one or more
OURS = ("graph", *OF_THE_WORKBOOK)
NEAR = 0.75  # share of letters that two names have in common
TEXTS = Texts(__file__)
OF_ORDER = {
    "Context.init() must only be called once": TEXTS["begun_twice"],
    "Context must be initialized before it can be shutdown": TEXTS["not_there_to_end"],
}
OURS_IS = str(Path(__file__).parents[1]) + os.sep  # and not tflab_workbook beside it
NOT_A_READERS = (OURS_IS, *{str(Path(sysconfig.get_path(name))) + os.sep for name in ("stdlib", "purelib", "platlib")})


def register(ipython: Any) -> None:
    """Let a shell say what a reader can do about an error, unless it treats errors of its own; drop stale answers."""
    ipython.events.register("post_run_cell", _drop_stale)
    if not ipython.custom_exceptions:
        ipython.set_custom_exc((Exception,), _show)


_sources: dict[str, str] = {}  # of the answers' cells that ran, by what they make
_stopped: set[str] = set()  # what answers' cells would have made that failed when they were run last


def _drop_stale(result: Any) -> None:
    """Forget what an answer's cell made before, if it has failed now."""
    from IPython import get_ipython

    shell = get_ipython()
    if shell is None or not str(result.info.cell_id or "").endswith("-answer"):
        return
    made = {function or value for function, value in MAKES.findall(result.info.raw_cell)}
    if result.success:
        _stopped.difference_update(made)
        _sources.update(dict.fromkeys(made, result.info.raw_cell))
        return
    _stopped.update(made)
    for name in made:
        shell.user_ns.pop(name, None)


def source_of(name: str) -> str:
    """Return the text of the answer's cell that made a value last, "" if it is not known."""
    return _sources.get(name, "")


def _show(shell: Any, kind: type, error: Exception, traceback: Any, tb_offset: int | None = None) -> None:
    if shell.InteractiveTB.mode != "Verbose":
        for each in _with_those_before(error):
            each.__traceback__ = reader_traceback(each.__traceback__)
            each.__suppress_context__ |= each.__context__ is not None and not _is_readers(each.__context__)
        traceback = error.__traceback__
    shell.showtraceback((kind, error, traceback), tb_offset=tb_offset)
    if kind is NameError and error.name:
        show_reply(error.name, _said(error.name, shell.user_ns))
    elif kind is TypeError and (tip := python_error_hint("TypeError", str(error)).say(language_here())):
        show_reply("TypeError", tip)
    elif kind is AttributeError and type(error.obj) is SimpleNamespace:
        show_reply("AttributeError", _said_of_given(error, shell.user_ns))
    elif kind is RuntimeError and str(error) in OF_ORDER:
        show_reply("rclpy", OF_ORDER[str(error)].say(language_here()))


def reader_traceback(traceback: TracebackType | None) -> TracebackType | None:
    """Return a traceback without what lies below our own code, up to where the reader's begins again."""
    kept, is_below = [], False
    while traceback is not None:
        file = traceback.tb_frame.f_code.co_filename
        is_below = file.startswith(OURS_IS) or (is_below and file.startswith(NOT_A_READERS))
        if not is_below:
            kept.append(traceback)
        traceback = traceback.tb_next
    shown = None
    for each in reversed(kept):
        shown = TracebackType(shown, each.tb_frame, each.tb_lasti, each.tb_lineno)
    return shown


def _with_those_before(error: BaseException) -> list[BaseException]:
    """Return an error, and those that led to it."""
    chain: list[BaseException] = []
    while error is not None and not any(error is each for each in chain):
        chain.append(error)
        error = error.__cause__ or error.__context__
    return chain


def _is_readers(error: BaseException) -> bool:
    """Return whether an error came from a reader's own lines."""
    return reader_traceback(error.__traceback__) is not None


def _said(name: str, space: Mapping[str, Any]) -> str:
    """Return what a reader can do about a name that is not there."""
    if name in OF_THE_WORKBOOK and any(each in space for each in OF_THE_WORKBOOK):
        return TEXTS["not_of_this_page"].say(language_here(), name=name)
    if name in OURS:
        return TEXTS["not_begun"].say(language_here())
    if name in _stopped:
        return TEXTS["stopped"].say(language_here())
    for holder, held in space.items():
        if type(held) is SimpleNamespace and name in vars(held) and not holder.startswith("_"):
            return TEXTS["given"].say(language_here(), holder=holder, name=name)
    if near := difflib.get_close_matches(name, OURS, 1, NEAR):
        return TEXTS["nearly"].say(language_here(), name=near[0])
    return (TEXTS["no_answer"] if CHECKS.search(space["In"][-1]) else TEXTS["not_yet"]).say(language_here())


def _said_of_given(error: AttributeError, space: Mapping[str, Any]) -> str:
    """Return what a task gives, in place of what was asked of it."""
    given = vars(error.obj)
    holder = next((name for name, held in space.items() if held is error.obj and not name.startswith("_")), "…")
    near = difflib.get_close_matches(error.name, given, 1)
    said = TEXTS["misspelt"] if near else TEXTS["not_given"]
    names = ", ".join(f"`{holder}.{name}`" for name in given)
    return said.say(language_here(), holder=holder, name=error.name, near=near[0] if near else "", names=names)
