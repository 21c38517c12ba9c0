"""How much does a kernel grow when a page is run again and again?  Megabytes after five more times.

    python benchmarks/rerun.py            all pages
    python benchmarks/rerun.py 02 08      these

A kernel runs every code cell of a page from its first to its last, as *Run All Cells*
does, with the cells' own names; then five times more.  Printed is the memory that is
resident after the first time and after the last, and what lies between them.
"""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

import nbformat
import psutil
from jupyter_client.manager import start_new_kernel

from tflab.workbook.copy.lay_out import lay_out

GOAL_MB = 30.0
AGAIN = 5


def main(chapters: Sequence[str]) -> None:
    """Print a line for each page."""
    os.environ.setdefault("JUPYTER_PREFER_ENV_PATH", "1")
    print(f"{'page':<34} {'first':>8} {'last':>8} {'grown':>8}   MB, goal {GOAL_MB:.0f}")
    with tempfile.TemporaryDirectory() as home:
        copy = lay_out(Path(home) / "copy", "en")
        for path in sorted((copy / "notebooks" / "en").glob("[01]*.ipynb")):
            if not chapters or path.name[:2] in chapters:
                sizes = sizes_of(path)
                print(f"{path.stem:<34} {sizes[0]:8.1f} {sizes[-1]:8.1f} {sizes[-1] - sizes[0]:8.1f}", flush=True)


def sizes_of(path: Path) -> list[float]:
    """Return what is resident after each time [MB]."""
    cells = [cell for cell in nbformat.read(path, 4).cells if cell.cell_type == "code" and cell.source.strip()]
    manager, client = start_new_kernel(kernel_name="python3", cwd=str(path.parent))
    try:
        kernel = psutil.Process(manager.provisioner.pid)
        return [size_after(client, cells, kernel) for _ in range(1 + AGAIN)]
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)


def size_after(client, cells: Sequence, kernel: psutil.Process) -> float:
    """Run all cells, and return what is resident then [MB]."""
    for cell in cells:
        content = {
            "code": cell.source, "silent": False, "store_history": True, "user_expressions": {},
            "allow_stdin": False, "stop_on_error": False,
        }  # fmt: skip
        message = client.session.msg("execute_request", content, metadata={"cellId": cell.id})
        client.shell_channel.send(message)
        while client.get_shell_msg(timeout=300)["parent_header"].get("msg_id") != message["header"]["msg_id"]:
            pass
        while client.iopub_channel.msg_ready():
            client.get_iopub_msg(timeout=1)
    return kernel.memory_info().rss / 1e6


if __name__ == "__main__":
    main(sys.argv[1:])
