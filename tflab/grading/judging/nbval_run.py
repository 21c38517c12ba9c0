"""Run cells by nbval on a sandboxed kernel, each within its limits.

    cells in order  ->  run_cells  ->  Run(outcomes, seconds, why it stopped)

An error in a cell stops nothing. A cell past its deadline, too much output or the
death of the kernel stops the run: the outcomes end with that cell.

    nbval                  here                      what is different
    RunningKernel          WiredKernel               a wire instead of sockets; deadlines, caps, liveness
    IPyNbFile              AnswerFile                cells from memory, never a learner's file
    IPyNbCell              AnswerCell                only probes are compared, by value; nothing is shown

The comparison happens here, in nbval's process; expected values are known only here.
"""

from __future__ import annotations

import contextlib
import json
import os
import secrets
import sys
import threading
import time
from collections import defaultdict, deque
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest

from ..kernels.kernel_pool import Kernel, for_this_process
from ..kernels.limits import Limits
from ..kernels.probe_answer import PROBE_TYPE
from ..kernels.sandbox import Sandbox
from ..kernels.wire import WireClosed, WireFault
from .job import CellOutcome, Run, RunCell

# nbval imports nbformat, that jsonschema, and that 38 grammars of addresses, which take two seconds
# and which nobody asks for here: jsonschema does without what it cannot import.
sys.modules.setdefault("rfc3987_syntax", None)  # type: ignore[arg-type]
from nbformat.notebooknode import from_dict  # noqa: E402
from nbval.kernel import RunningKernel  # noqa: E402
from nbval.plugin import IPyNbCell, IPyNbFile, NbCellError  # noqa: E402

if sys.modules["rfc3987_syntax"] is None:
    del sys.modules["rfc3987_syntax"]

__all__ = ["WiredKernel", "nbval_session", "run_cells"]

# A cell before its source is in it; without a count nbval compares nothing.
EMPTY = {"cell_type": "code", "execution_count": 1, "metadata": {}, "outputs": []}
LIVENESS_S = 0.2
LONGEST_TROUBLE = 300


class Stopped(Exception):
    """The kernel was stopped: "timed out", "output limit", "kernel died", "memory limit"."""


class WiredKernel(RunningKernel):
    """nbval's kernel over a wire, with a deadline for each cell and for all, and with caps on what it says."""

    def __init__(self, kernel: Kernel, limits: Limits) -> None:
        self.kernel = kernel
        self.limits = limits
        self.stopped: str | None = None
        self._end = self._cell_end = time.monotonic() + limits.notebook_s
        self._ends: dict[str, float] = {}  # of cells that share their time
        self._queues: dict[str, deque[dict[str, Any]]] = {"iopub": deque(), "shell": deque()}
        self._messages = self._bytes = 0

    def start_clock(self, cell: RunCell) -> None:
        """Set the deadline of the cell that comes next."""
        end = time.monotonic() + cell.part * self.limits.cell_s
        if cell.shared:
            end = self._ends.setdefault(cell.shared, end)
        self._cell_end = min(self._end, end)

    def execute_cell_input(self, cell_input: str, allow_stdin: bool | None = None) -> str:
        self._messages, self._bytes = 0, self.kernel.wire.taken
        for queue in self._queues.values():
            queue.clear()
        message_id = secrets.token_hex(8)
        try:
            self.kernel.wire.send({"msg_id": message_id, "code": cell_input}, self._cell_end)
        except TimeoutError:
            self._stop("timed out")
        except WireClosed:
            self._stop("kernel died")
        return message_id

    def get_message(self, stream: str, timeout: float | None = None) -> dict[str, Any]:
        """Return the next message of a stream; the deadlines count, not nbval's timeout for each message."""
        queue = self._queues[stream]
        while not queue:
            left = self._cell_end - time.monotonic()
            if left <= 0:
                self._stop("timed out")
            try:
                message = self.kernel.wire.receive(min(LIVENESS_S, left))
            except WireClosed:
                self._stop("kernel died")
            except WireFault:
                self._stop("unreadable output")
            if message is None:
                continue
            self._messages += 1
            if self._messages > self.limits.messages:
                self._stop("output limit")
            if self.kernel.wire.taken - self._bytes > self.limits.output_bytes:
                self._stop("output limit")
            if (known := well_formed(message)) is not None:
                self._queues[known.pop("channel")].append(known)
        return queue.popleft()

    def _stop(self, reason: str) -> None:
        said = self.kernel.close()
        self.stopped = said or reason
        raise Stopped(self.stopped)

    def is_alive(self) -> bool:
        return self.stopped is None

    def interrupt(self) -> None:
        """Do nothing: past its deadline the kernel is killed."""

    def stop(self) -> None:
        if self.stopped is None:
            self.stopped = "closed"
            self.kernel.hang_up()


def well_formed(message: dict[str, Any]) -> dict[str, Any] | None:
    """Return the same message in the shape nbval expects, whatever else was in it; None if it has no such shape."""
    parent, content, kind = message.get("parent_header"), message.get("content"), message.get("msg_type")
    if not (isinstance(parent, dict) and isinstance(content, dict) and isinstance(kind, str)):
        return None
    known: dict[str, Any]
    if message.get("channel") == "shell" and kind == "execute_reply":
        channel, known = "shell", {"status": "ok"}
    elif message.get("channel") != "iopub":
        return None
    elif kind == "status" and content.get("execution_state") in ("busy", "idle"):
        channel, known = "iopub", {"execution_state": content["execution_state"]}
    elif kind == "display_data" and isinstance(content.get("data"), dict):
        channel, known = "iopub", {"data": content["data"], "metadata": {}}
    elif kind == "error":
        words = {name: str(content.get(name))[:LONGEST_TROUBLE] for name in ("ename", "evalue")}
        channel, known = "iopub", words | {"traceback": []}
    else:
        return None
    return {"channel": channel, "msg_type": kind, "parent_header": {"msg_id": parent.get("msg_id")}, "content": known}


class AnswerFile(IPyNbFile):
    """A notebook of cells in memory; `take_kernel` is asked for a kernel when the first is run."""

    def __init__(
        self,
        *,
        cells: Sequence[RunCell],
        take_kernel: Callable[[Limits], Kernel],
        limits: Limits,
        **of_pytest: Any,
    ) -> None:
        super().__init__(**of_pytest)
        self.cells = cells
        self.take_kernel = take_kernel
        self.limits = limits

    def setup(self) -> None:
        self.kernel = WiredKernel(self.take_kernel(self.limits), self.limits)

    def collect(self) -> Iterator[AnswerCell]:
        for number, cell in enumerate(self.cells):
            node = from_dict(EMPTY | {"source": cell.source})  # not validated: it is ours
            options = defaultdict(bool, check=cell.probe is not None)
            name = f"{number + 1}-{cell.name}"
            yield AnswerCell.from_parent(self, name=name, cell_num=number, cell=node, options=options, known=cell)

    def teardown(self) -> None:
        if self.kernel is not None:
            self.kernel.stop()


class AnswerCell(IPyNbCell):
    """A cell that is run; if it is a probe, its one value is kept."""

    def __init__(self, *, known: RunCell, **of_nbval: Any) -> None:
        super().__init__(**of_nbval)
        self.known = known
        self.value: Any = None
        self.trouble: str | None = None

    def setup(self) -> None:
        """No cell is expected to fail: what a stopped notebook leaves undone is not done."""

    def runtest(self) -> None:
        kernel = self.parent.kernel
        if kernel.stopped:
            self.trouble = kernel.stopped
            pytest.fail(self.trouble, pytrace=False)
        kernel.start_clock(self.known)
        try:
            super().runtest()
        except NbCellError as fault:
            self.trouble = self.trouble or self._what_was_raised()
            raise fault from None
        except Stopped as stopped:
            self.trouble = str(stopped)
            pytest.fail(self.trouble, pytrace=False)

    def _what_was_raised(self) -> str:
        raised = [output for output in self.test_outputs or () if output.output_type == "error"]
        if not raised:
            return "error"
        if self.known.probe is not None:  # its words could tell what was asked
            return f"error: {raised[-1]['ename']}"
        return f"error: {raised[-1]['ename']}: {raised[-1]['evalue']}"[:LONGEST_TROUBLE]

    def compare_outputs(self, test: Any, ref: Any, skip_compare: Any = None) -> bool:
        """Take the value of the one message with the right id; there is no stored output to compare with."""
        self.comparison_traceback = []  # what nbval would show
        said = [output["data"][PROBE_TYPE] for output in test if PROBE_TYPE in output.get("data", ())]
        mine = [message for message in said if isinstance(message, dict) and message.get("id") == self.known.probe]
        if len(said) != 1 or len(mine) != 1 or "v" not in mine[0]:
            self.trouble = "no answer came" if not said else "something else than one answer came"
            return False
        self.value = json.loads(json.dumps(mine[0]["v"]))  # nbformat has made nodes of it, slow to hand on
        return True

    def repr_failure(self, excinfo: Any) -> str:
        """Say what went wrong, but neither source nor values: hidden inputs are in them."""
        return f"{self.name}: {self.trouble or excinfo.typename}"

    def reportinfo(self) -> tuple[Any, int, str]:
        return self.path, 0, self.name


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


class EmptyPytestSession:
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


_only = EmptyPytestSession()
_lock = threading.Lock()


def nbval_session() -> pytest.Session:
    """Return this process's session for nbval's items, made at the first call."""
    with _lock:
        if _only.session is None:
            arguments = ["-p", "no:terminal", "-p", "no:cacheprovider", "-p", "no:faulthandler", "-p", "nbval.plugin"]
            arguments += ["--noconftest", "-c", os.devnull, "--rootdir", "/", "--capture=no"]
            with disable_other_plugins():
                pytest.main(arguments, plugins=[_only])
        assert _only.session is not None
        return _only.session


@contextlib.contextmanager
def disable_other_plugins() -> Any:
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
