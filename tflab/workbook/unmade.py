"""Why is a name not there?  Its cell was not run yet: below Python's error, a line says so.

    NameError: name 'base_p_corner' is not defined
    base_p_corner: Not there yet. Run the cell above with your answer, then this one again.

An answer's cell that fails leaves no older answer behind for `check` to speak of.
`%load_ext tflab` sees to both.  Read `progress.py` next.
"""

from __future__ import annotations

import re
from typing import Any

from .places import WorkbookError, read_workbook
from .reply import show_reply
from .words import Words

__all__ = ["register"]

MAKES = re.compile(r"^(?:def\s+(\w+)|(\w+)\s*=(?!=))", re.MULTILINE)
CHECKS = re.compile(r"^\s*check\(", re.MULTILINE)
OURS = ("check", "graph", "hint", "lesson", "solution", "task")
NOT_BEGUN = Words(
    "Not there yet. Run the page's first cells, then this one again.",
    "아직 없습니다. 페이지의 첫 셀들을 먼저 실행한 다음 이 셀을 다시 실행하십시오.",
)
NO_ANSWER = Words(
    "Not there yet. Run the cell above with your answer, then this one again.",
    "아직 없습니다. 답을 쓴 위의 셀을 먼저 실행한 다음 이 셀을 다시 실행하십시오.",
)
NOT_YET = Words(
    "Not there yet. If a cell above makes it, run that one first (Run → Run All Above Selected Cell), "
    "then this one again; if none does, look how it is spelt.",
    "아직 없습니다. 위의 셀에서 만드는 이름이라면 그 셀을 먼저 실행한 다음(Run → Run All Above Selected Cell) "
    "이 셀을 다시 실행하십시오. 그런 셀이 없다면 철자를 확인하십시오.",
)


def register(ipython: Any) -> None:
    """Let a shell explain a name that is not there, unless it already treats errors of its own; drop stale answers."""
    ipython.events.register("post_run_cell", _drop_stale)
    if not ipython.custom_exceptions:
        ipython.set_custom_exc((NameError,), _show)


def _drop_stale(result: Any) -> None:
    """Forget what an answer's cell made before, if it has failed now."""
    from IPython import get_ipython

    shell = get_ipython()
    if result.success or shell is None or not str(result.info.cell_id or "").endswith("-answer"):
        return
    for function, value in MAKES.findall(result.info.raw_cell):
        shell.user_ns.pop(function or value, None)


def _show(shell: Any, kind: type, error: NameError, traceback: Any, tb_offset: int | None = None) -> None:
    shell.showtraceback((kind, error, traceback), tb_offset=tb_offset)
    if kind is NameError and error.name:
        show_reply(error.name, _said(error.name, shell.user_ns["In"][-1]).say(_language()))


def _said(name: str, cell: str) -> Words:
    if name in OURS:
        return NOT_BEGUN
    return NO_ANSWER if CHECKS.search(cell) else NOT_YET


def _language() -> str:
    try:
        return read_workbook().language
    except WorkbookError:  # said wherever a task is asked for
        return "en"
