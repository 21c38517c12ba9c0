"""Release the widgets of a cell when the cell runs again, so that memory does not grow.

IPython keeps every result in `Out` and ipywidgets every widget for as long as the kernel lives.
Only views of this package are freed; a learner's own results stay.
"""

from __future__ import annotations

import ctypes
import gc
import sys
from itertools import count
from typing import Any

PACKAGE = __name__.rpartition(".")[0]

SWEEP_AFTER = 5  # views; a figure is in many circles, which only a sweep finds, and a sweep takes a tenth of a second

_shown: dict[str, int] = {}  # by cell: the number of its result, if that is a view
_let_go = count(1)


def register(ipython: Any) -> None:
    """Let views go when the cell that showed them runs again; a second call only sweeps up what a page has left."""
    _sweep()
    ipython.events.register("pre_run_cell", _forget)
    ipython.events.register("post_run_cell", _remember)


def _forget(info: Any) -> None:
    number = _shown.pop(cell_key(info), None)
    shell = _shell()
    if number is None or shell is None:
        return
    view = shell.user_ns.get("_oh", {}).pop(number, None)
    for names in (shell.user_ns, shell.user_ns_hidden):
        names.pop(f"_{number}", None)
    close = getattr(view, "close_with_its_cell", None)
    if close is not None:
        close()
    del view, close
    if next(_let_go) % SWEEP_AFTER == 0:
        _sweep()


def _sweep() -> None:
    """Free what nothing holds any more, and where the C library keeps freed memory (glibc), have it given back."""
    gc.collect()
    if sys.platform == "linux":
        trim = getattr(ctypes.CDLL(None), "malloc_trim", None)
        if trim is not None:
            trim(0)


def _remember(result: Any) -> None:
    if type(result.result).__module__.startswith(f"{PACKAGE}."):
        _shown[cell_key(result.info)] = result.execution_count


def cell_key(info: Any) -> str:
    """Return what a cell is known by: its id, or where nothing gives one, its text."""
    return info.cell_id or info.raw_cell


def _shell() -> Any:
    from IPython.core.getipython import get_ipython

    return get_ipython()
