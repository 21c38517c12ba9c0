"""What do these cells give?  They are run on nbval, behind the sandbox, each within its limits.

    cells in order  ->  run_cells  ->  Run(outcomes, seconds, why it stopped)

An error in a cell stops nothing.  A cell past its deadline, too much output or the
death of the kernel stops the run: the outcomes end with that cell.
"""

from __future__ import annotations

import contextlib
import os
import threading
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from ..kernels.kernel_pool import for_this_process
from ..kernels.limits import Limits
from ..kernels.sandbox import Sandbox
from .nbval_items import AnswerCell, AnswerFile, NbCellError
from .run import CellOutcome, Run, RunCell

__all__ = ["nbval_session", "run_cells"]


def run_cells(cells: Sequence[RunCell], *, limits: Limits, sandbox: Sandbox) -> Run:
    """Run cells in a fresh kernel.

    Raises:
        KernelError: no kernel could be started.
    """
    file = AnswerFile.from_parent(
        nbval_session(),
        path=Path("/answers.ipynb"),
        cells=cells,
        take_kernel=for_this_process(sandbox).take,
        limits=limits,
    )
    file.setup()
    begin = time.monotonic()
    outcomes = []
    try:
        for item in file.collect():
            outcomes.append(outcome_of(item))
            if file.kernel.stopped:
                break
        stopped = file.kernel.stopped
    finally:
        file.teardown()
    seconds = time.monotonic() - begin
    return Run(tuple(outcomes), seconds, stopped)


def outcome_of(item: AnswerCell) -> CellOutcome:
    """Run one cell as nbval does, and return its outcome."""
    with contextlib.suppress(NbCellError, pytest.fail.Exception):  # it is in item.trouble
        item.runtest()
    return CellOutcome(item.value, item.trouble)


class OnlyASession:
    """A pytest that collects nothing and runs nothing: nbval's classes want one above them."""

    session: pytest.Session | None = None

    def pytest_addoption(self, parser: pytest.Parser) -> None:
        parser.addoption("--color", default="no")  # of the terminal's, which is not loaded; nbval asks for it

    def pytest_sessionstart(self, session: pytest.Session) -> None:
        self.session = session

    @pytest.hookimpl(tryfirst=True)
    def pytest_collection(self, session: pytest.Session) -> bool:
        return True

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        return True


_only = OnlyASession()
_lock = threading.Lock()


def nbval_session() -> pytest.Session:
    """Return this process's session for nbval's items, made at the first call."""
    with _lock:
        if _only.session is None:
            arguments = ["-p", "no:terminal", "-p", "no:cacheprovider", "-p", "no:faulthandler", "-p", "nbval.plugin"]
            arguments += ["--noconftest", "-c", os.devnull, "--rootdir", "/", "--capture=no"]
            with no_other_plugins():
                pytest.main(arguments, plugins=[_only])
        assert _only.session is not None
        return _only.session


@contextlib.contextmanager
def no_other_plugins() -> Any:
    """Keep pytest from loading plugins and options of whoever started this process."""
    names = ("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "PYTEST_ADDOPTS", "PYTEST_PLUGINS", "PYTEST_CURRENT_TEST")
    before = {name: os.environ.get(name) for name in names}
    os.environ["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"
    for name in names[1:]:
        os.environ.pop(name, None)
    try:
        yield
    finally:
        for name, value in before.items():
            os.environ.pop(name, None)
            if value is not None:
                os.environ[name] = value
