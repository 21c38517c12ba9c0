"""Run cells in an ordinary kernel without a sandbox, on a machine whose owner wrote them.

Only `tflab check` uses it, on systems other than Linux, or where no kernel of the
grader's starts: what runs is the learner's own notebook on the learner's own machine.
"""

from __future__ import annotations

import subprocess
import time
from collections.abc import Callable, Sequence
from queue import Empty
from typing import TYPE_CHECKING

from ..kernels.limits import Limits
from ..kernels.probe_answer import PROBE_TYPE
from .job import CellOutcome, Run, RunCell

if TYPE_CHECKING:
    from jupyter_client.blocking import BlockingKernelClient

__all__ = ["run_plainly"]

LOOK_S = 0.5  # between two looks whether the kernel is alive


def run_plainly(cells: Sequence[RunCell], limits: Limits) -> Run:
    """Run cells in a kernel of Jupyter's; one that does not end within its time is the last."""
    from jupyter_client.manager import start_new_kernel

    manager, client = start_new_kernel(kernel_name="python3", stderr=subprocess.DEVNULL)
    began = time.monotonic()
    outcomes: list[CellOutcome] = []
    stopped = None
    try:
        for cell in cells:
            try:
                outcomes.append(_run(client, cell, limits.cell_s, manager.is_alive))
            except Empty:
                stopped = "timed out" if manager.is_alive() else "kernel died"
                outcomes.append(CellOutcome(trouble=stopped))
                break
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)
    return Run(outcomes, time.monotonic() - began, stopped)


def _run(client: BlockingKernelClient, cell: RunCell, cell_s: float, is_alive: Callable[[], bool]) -> CellOutcome:
    """Run one cell; raises Empty if it does not end within its time, or if the kernel dies."""
    end = time.monotonic() + cell_s
    asked = client.execute(cell.source, store_history=False, stop_on_error=False)
    value, trouble = None, None
    while True:
        try:
            message = client.get_iopub_msg(timeout=min(LOOK_S, max(0.0, end - time.monotonic())))
        except Empty:
            if time.monotonic() < end and is_alive():
                continue
            raise
        if message["parent_header"].get("msg_id") != asked:
            continue
        kind, content = message["msg_type"], message["content"]
        if kind == "error":
            trouble = f"error: {content['ename']}: {content['evalue']}"
        if kind == "display_data" and PROBE_TYPE in content["data"]:
            said = content["data"][PROBE_TYPE]
            value = said.get("v") if isinstance(said, dict) and said.get("id") == cell.probe else value
        if kind == "status" and content["execution_state"] == "idle":
            return CellOutcome(value, trouble)
