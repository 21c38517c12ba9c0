"""Run cells by nbval on a sandboxed kernel, each within its limits.

    cells in order  ->  run_cells  ->  Run(outcomes, seconds, why it stopped)

An error in a cell stops nothing. A cell past its deadline, too much output or the
death of the kernel stops the run: the outcomes end with that cell.

    nbval                  here                      what is different
    RunningKernel          WiredKernel               a wire instead of sockets; deadlines, caps, liveness
    IPyNbCell.runtest      AnswerCell                no pytest around it; only probes are compared, by value

The comparison happens here, in nbval's process; expected values are known only here.
"""

from __future__ import annotations

import json
import secrets
import sys
import time
from collections import defaultdict, deque
from collections.abc import Sequence
from types import SimpleNamespace
from typing import Any

from ..kernels.kernel_pool import Kernel, KernelError, for_this_process
from ..kernels.limits import Limits
from ..kernels.probe_answer import PROBE_TYPE
from ..kernels.sandbox import Sandbox
from ..kernels.wire import WireClosed, WireFault
from .job import CellOutcome, NotRun, Run, RunCell

# nbval imports nbformat, that jsonschema, and that 38 grammars of addresses, which take two seconds
# and which nobody asks for here: jsonschema does without what it cannot import.
sys.modules.setdefault("rfc3987_syntax", None)  # type: ignore[arg-type]
from nbval.kernel import RunningKernel  # noqa: E402
from nbval.plugin import IPyNbCell, NbCellError  # noqa: E402

if sys.modules["rfc3987_syntax"] is None:
    del sys.modules["rfc3987_syntax"]

__all__ = ["WiredKernel", "run_cells"]

NO_TIMEOUT = SimpleNamespace(option=SimpleNamespace(nbval_cell_timeout=None))  # the kernel has its own deadlines
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

    def get_output(self, timeout: float | None = None) -> dict[str, Any]:
        return self.get_message("iopub", timeout)

    def _stop(self, reason: str) -> None:
        said = self.kernel.close()
        self.stopped = said or reason
        raise Stopped(self.stopped)

    def is_alive(self) -> bool:
        return self.stopped is None


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


class AnswerCell:
    """A cell that nbval runs; if it is a probe, its one value is kept."""

    runtest = IPyNbCell.runtest
    raise_cell_error = IPyNbCell.raise_cell_error

    def __init__(self, known: RunCell, kernel: WiredKernel) -> None:
        self.known = known
        self.value: Any = None
        self.trouble: str | None = None
        # What `runtest` reads. It compares nothing if a cell has no count.
        self.cell_num, self.cell = 0, SimpleNamespace(source=known.source, outputs=[], execution_count=1)
        self.options = defaultdict(bool, check=known.probe is not None)
        self.parent = SimpleNamespace(kernel=kernel, timed_out=False, get_kernel_message=kernel.get_output)
        self.config, self.output_timeout = NO_TIMEOUT, None

    def outcome(self) -> CellOutcome:
        """Run the cell, and return its outcome."""
        self.parent.kernel.start_clock(self.known)
        try:
            self.runtest()
        except NbCellError:
            self.trouble = self.trouble or self._what_was_raised()
        except Stopped as stopped:
            self.trouble = str(stopped)
        return CellOutcome(self.value, self.trouble)

    def _what_was_raised(self) -> str:
        raised = [output for output in self.test_outputs if output.output_type == "error"]
        if not raised:
            return "error"
        if self.known.probe is not None:  # its words could tell what was asked
            return f"error: {raised[-1]['ename']}"
        return f"error: {raised[-1]['ename']}: {raised[-1]['evalue']}"[:LONGEST_TROUBLE]

    def compare_outputs(self, test: Any, ref: Any) -> bool:
        """Take the value of the one message with the right id; there is no stored output to compare with."""
        self.comparison_traceback: list[str] = []  # what nbval would show
        said = [output["data"][PROBE_TYPE] for output in test if PROBE_TYPE in output.get("data", ())]
        mine = [message for message in said if isinstance(message, dict) and message.get("id") == self.known.probe]
        if len(said) != 1 or len(mine) != 1 or "v" not in mine[0]:
            self.trouble = "no answer came" if not said else "something else than one answer came"
            return False
        self.value = json.loads(json.dumps(mine[0]["v"]))  # nbformat has made nodes of it, slow to hand on
        return True


def run_cells(cells: Sequence[RunCell], limits: Limits, sandbox: Sandbox) -> Run:
    """Run cells in a fresh kernel.

    Raises:
        NotRun: no kernel could be started.
    """
    try:
        kernel = WiredKernel(for_this_process(sandbox).take(limits), limits)
    except (KernelError, OSError) as error:
        raise NotRun(str(error)[:200]) from None
    begin = time.monotonic()
    outcomes = []
    try:
        for cell in cells:
            outcomes.append(AnswerCell(cell, kernel).outcome())
            if kernel.stopped:
                break
    finally:
        kernel.kernel.hang_up()
    return Run(tuple(outcomes), time.monotonic() - begin, kernel.stopped)
