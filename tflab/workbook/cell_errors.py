"""Why did a cell fail?  Its own lines say so, without ours below them; and if it was run too early, a line more.

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

from ..text import Text
from .diagnosis.python_errors import tip_for
from .paths import language_here
from .reply import show_reply

__all__ = ["register"]

MAKES = re.compile(r"^(?:def\s+(\w+)|(\w+)\s*=(?!=))", re.MULTILINE)
CHECKS = re.compile(r"^\s*check\(", re.MULTILINE)
OF_THE_WORKBOOK = ("check", "hint", "lesson", "solution", "task")  # a page's first cell brings one or more
OURS = ("graph", *OF_THE_WORKBOOK)
NEAR = 0.75  # share of letters that two names have in common
NOT_BEGUN = Text(
    "Not there yet. Run the page's first cells, then this one again.",
    "아직 없습니다. 페이지의 첫 셀들을 먼저 실행한 다음 이 셀을 다시 실행하십시오.",
)
NOT_OF_THIS_PAGE = Text(
    "This page does not bring it along: `from tflab.workbook import {name}` does. Run that, then this cell again.",
    "이 페이지의 첫 셀은 이 이름을 가져오지 않습니다. `from tflab.workbook import {name}`를 실행한 다음 "
    "이 셀을 다시 실행하십시오.",
)
NO_ANSWER = Text(
    "Not there yet. Run the cell above with your answer, then this one again.",
    "아직 없습니다. 답을 쓴 위의 셀을 먼저 실행한 다음 이 셀을 다시 실행하십시오.",
)
STOPPED = Text(
    "The cell that makes it stopped with an error. Mend what the error names, run that cell, then this one again.",
    "이 값을 만드는 셀이 오류로 멈췄습니다. 오류가 가리키는 곳을 고쳐 그 셀을 실행한 다음 이 셀을 다시 실행하십시오.",
)
NOT_YET = Text(
    "Not there yet. If a cell above makes it, run that one first (Run → Run All Above Selected Cell), "
    "then this one again; if none does, look how it is spelt.",
    "아직 없습니다. 위의 셀에서 만드는 이름이라면 그 셀을 먼저 실행한 다음(Run → Run All Above Selected Cell) "
    "이 셀을 다시 실행하십시오. 그런 셀이 없다면 철자를 확인하십시오.",
)
GIVEN = Text(
    "That is given with the task, and stands in what you called {holder}: `{holder}.{name}`.",
    "과제에서 주어진 값이고, {holder} 안에 있습니다. `{holder}.{name}`라고 쓰십시오.",
)
MISSPELT = Text(
    "`{holder}.{name}` is not given. Did you mean `{holder}.{near}`?",
    "주어진 값이 아닙니다: `{holder}.{name}`. 혹시 `{holder}.{near}`입니까?",
)
NOT_GIVEN = Text(
    "`{holder}.{name}` is not given. What is given: {names}.",
    "주어진 값이 아닙니다: `{holder}.{name}`. 주어진 것: {names}.",
)
NEARLY = Text("Did you mean `{name}`?", "혹시 `{name}`입니까?")
BEGUN_TWICE = Text(
    "rclpy has begun already, in another cell. `rclpy.try_shutdown()` ends it; then run this cell again.",
    "다른 셀에서 이미 rclpy를 시작했습니다. `rclpy.try_shutdown()`으로 끝낸 다음 이 셀을 다시 실행하십시오.",
)
NOT_THERE_TO_END = Text(
    "rclpy has not begun, or another cell has ended it already: there is nothing left to end.",
    "rclpy를 아직 시작하지 않았거나 다른 셀에서 이미 끝냈습니다. 더 끝낼 것이 없습니다.",
)
OF_ORDER = {
    "Context.init() must only be called once": BEGUN_TWICE,
    "Context must be initialized before it can be shutdown": NOT_THERE_TO_END,
}
OURS_IS = str(Path(__file__).parents[1]) + os.sep  # and not tflab_workbook beside it
NOT_A_READERS = (OURS_IS, *{str(Path(sysconfig.get_path(name))) + os.sep for name in ("stdlib", "purelib", "platlib")})


def register(ipython: Any) -> None:
    """Let a shell say what a reader can do about an error, unless it treats errors of its own; drop stale answers."""
    ipython.events.register("post_run_cell", _drop_stale)
    if not ipython.custom_exceptions:
        ipython.set_custom_exc((Exception,), _show)


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
        return
    _stopped.update(made)
    for name in made:
        shell.user_ns.pop(name, None)


def _show(shell: Any, kind: type, error: Exception, traceback: Any, tb_offset: int | None = None) -> None:
    if shell.InteractiveTB.mode != "Verbose":
        for each in _with_those_before(error):
            each.__traceback__ = of_the_reader(each.__traceback__)
            each.__suppress_context__ |= each.__context__ is not None and not _is_readers(each.__context__)
        traceback = error.__traceback__
    shell.showtraceback((kind, error, traceback), tb_offset=tb_offset)
    if kind is NameError and error.name:
        show_reply(error.name, _said(error.name, shell.user_ns))
    elif kind is TypeError and (tip := tip_for("TypeError", str(error)).say(language_here())):
        show_reply("TypeError", tip)
    elif kind is AttributeError and type(error.obj) is SimpleNamespace:
        show_reply("AttributeError", _said_of_given(error, shell.user_ns))
    elif kind is RuntimeError and str(error) in OF_ORDER:
        show_reply("rclpy", OF_ORDER[str(error)].say(language_here()))


def of_the_reader(traceback: TracebackType | None) -> TracebackType | None:
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
    return of_the_reader(error.__traceback__) is not None


def _said(name: str, space: Mapping[str, Any]) -> str:
    """Return what a reader can do about a name that is not there."""
    if name in OF_THE_WORKBOOK and any(each in space for each in OF_THE_WORKBOOK):
        return NOT_OF_THIS_PAGE.say(language_here(), name=name)
    if name in OURS:
        return NOT_BEGUN.say(language_here())
    if name in _stopped:
        return STOPPED.say(language_here())
    for holder, held in space.items():
        if type(held) is SimpleNamespace and name in vars(held) and not holder.startswith("_"):
            return GIVEN.say(language_here(), holder=holder, name=name)
    if near := difflib.get_close_matches(name, OURS, 1, NEAR):
        return NEARLY.say(language_here(), name=near[0])
    return (NO_ANSWER if CHECKS.search(space["In"][-1]) else NOT_YET).say(language_here())


def _said_of_given(error: AttributeError, space: Mapping[str, Any]) -> str:
    """Return what a task gives, in place of what was asked of it."""
    given = vars(error.obj)
    holder = next((name for name, held in space.items() if held is error.obj and not name.startswith("_")), "…")
    near = difflib.get_close_matches(error.name, given, 1)
    said = MISSPELT if near else NOT_GIVEN
    names = ", ".join(f"`{holder}.{name}`" for name in given)
    return said.say(language_here(), holder=holder, name=error.name, near=near[0] if near else "", names=names)
