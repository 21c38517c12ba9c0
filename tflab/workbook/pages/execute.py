"""Run a page once in a kernel and a workbook of its own, and make its outputs storable.

    page --cells, in order--> kernel --outputs--> merged, nothing of this machine in them --> {cell name: [output, ...]}
                                 |
                                 +--> faults: an error, a warning, a picture without words ...

The kernel starts in a temporary workbook that stands for tflab's own, so a page sees its tasks as they are being
built, and no option of the author's shell reaches it.  `running_kernel` ends the kernel with its block and leaves
Ctrl-C to Python, which nbclient's own context does not.
"""

from __future__ import annotations

import asyncio
import base64
import json
import os
import re
import subprocess
import warnings
from collections.abc import AsyncIterator, Coroutine, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from .source import Page, PageFault, SourceCell

__all__ = ["LARGEST_PNG", "Outputs", "being_cancelled", "merged_streams", "run_page", "running_kernel", "wait_for"]


@asynccontextmanager
async def running_kernel(client: Any, env: Mapping[str, str]) -> AsyncIterator[None]:
    """Start the kernel of an nbclient `NotebookClient`, with this environment, and end it with the context."""
    from nbclient.exceptions import DeadKernelError

    kernel = client.create_kernel_manager()
    try:
        # A kernel's own remarks on how it is connected are nothing to whoever waits for a page.
        await client.async_start_new_kernel(env=dict(env), stderr=subprocess.DEVNULL)
        await client.async_start_new_kernel_client()
        yield
    except DeadKernelError:
        if being_cancelled():  # nbclient takes that for the kernel's death
            raise asyncio.CancelledError from None
        raise
    finally:
        if client.kc is not None:
            client.kc.stop_channels()
        if kernel.has_kernel:
            await kernel.shutdown_kernel(now=True)
        await kernel.cleanup_resources()


def being_cancelled() -> bool:
    """Return whether this task is being cancelled; Python 3.10 does not tell, and reports the kernel's death."""
    task = asyncio.current_task()
    return hasattr(task, "cancelling") and task.cancelling() > 0


def wait_for(work: Coroutine) -> Any:
    """Run a coroutine to its end and return its result, beside somebody else's event loop if there is one."""
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return _run_coroutine(work)
    with ThreadPoolExecutor(1) as thread:  # the loop is Jupyter's, or that of a browser that is steered
        return thread.submit(_run_coroutine, work).result()


def _run_coroutine(work: Coroutine) -> Any:
    with warnings.catch_warnings():  # on Windows pyzmq says that it helps itself with a thread: nobody has to act
        warnings.filterwarnings("ignore", "Proactor event loop", RuntimeWarning)
        return asyncio.run(work)


SECONDS_FOR_A_CELL = 120
LARGEST_PNG = 60_000
ADDRESS = re.compile(r"\b0x[0-9a-fA-F]{6,}\b")
WIDGET = "application/vnd.jupyter.widget-view+json"
Outputs = dict[str, list[dict]]


async def run_page(page: Page, folder: str, beside: Mapping[str, bytes] = {}) -> tuple[Outputs, list[PageFault]]:
    """Run a page's code once; return what its cells store, and what is wrong with that.

    Args:
        folder: where the page stands in a workbook, such as "notebooks/en".
        beside: files to put beside it in the workbook, by path.
    """
    with TemporaryDirectory(prefix="tflab-page-", ignore_cleanup_errors=True) as name:
        root = Path(name).resolve()
        _lay_workbook(root, folder, beside)
        ran = await _run(page, root, folder)
    outputs = {cell: [_storable(output) for output in merged_streams(made)] for cell, made in ran.items()}
    found = [fault for cell in page.code for fault in _output_faults(page, cell, outputs[cell.name], str(root))]
    found += _figures(page, outputs)
    for cell, following in zip(page.code, (*page.code[1:], None), strict=False):
        if "interactive" in cell.tags:
            is_drawn = following is not None and "static" in following.tags
            outputs[cell.name] = outputs.pop(following.name) if is_drawn else []
    return outputs, found


def _lay_workbook(root: Path, folder: str, beside: Mapping[str, bytes]) -> None:
    (root / folder).mkdir(parents=True)
    for name, content in beside.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_bytes(content)


async def _run(page: Page, root: Path, folder: str) -> Outputs:
    """Run the code cells in a fresh kernel, which ends with this call, however it ends."""
    import nbformat
    from nbclient import NotebookClient

    cells = [nbformat.v4.new_code_cell(cell.source, id=f"c{i}") for i, cell in enumerate(page.code)]
    notebook = nbformat.v4.new_notebook(cells=cells)
    where = {"metadata": {"path": str(root / folder)}}
    client = NotebookClient(
        notebook, kernel_name="python3", timeout=SECONDS_FOR_A_CELL, allow_errors=True, resources=where
    )
    env = {name: value for name, value in os.environ.items() if not name.startswith("TFLAB_")}
    env |= {"TFLAB_WORKBOOK": str(root), "IPYTHONDIR": str(root / "ipython"), "PYTHONHASHSEED": "0"}
    async with running_kernel(client, env):
        await _run_cells(client, cells)
    return {written.name: list(cell.outputs) for cell, written in zip(cells, page.code, strict=True)}


async def _run_cells(client: Any, cells: Sequence[Any]) -> None:
    from nbclient.exceptions import CellTimeoutError, DeadKernelError

    for number, cell in enumerate(cells):
        try:
            await client.async_execute_cell(cell, number)
        except CellTimeoutError:
            cell.outputs.append(_error("TimeoutError", f"not done after {SECONDS_FOR_A_CELL} s"))
            return
        except DeadKernelError:
            if being_cancelled():
                raise
            cell.outputs.append(_error("DeadKernelError", "the kernel died"))
            return


def _error(name: str, text: str) -> dict:
    return {"output_type": "error", "ename": name, "evalue": text, "traceback": []}


def merged_streams(outputs: list[dict]) -> Iterator[dict]:
    """Yield outputs with the chunks of one stream joined."""
    before: dict | None = None
    for output in outputs:
        if before is not None and output["output_type"] == "stream" and output["name"] == before.get("name"):
            before = {**before, "text": before["text"] + output["text"]}
            continue
        if before is not None:
            yield before
        before = dict(output)
    if before is not None:
        yield before


def _storable(output: dict) -> dict:
    """Return an output as a notebook's file has it, without what is different every time."""
    kind = output["output_type"]
    if kind == "stream":
        return {"name": output["name"], "output_type": kind, "text": output["text"].splitlines(keepends=True)}
    if kind == "error":
        return {"ename": output["ename"], "evalue": output["evalue"], "output_type": kind, "traceback": []}
    data = {
        mime: value.splitlines(keepends=True) if mime.startswith("text/") or mime == "image/svg+xml" else value
        for mime, value in output["data"].items()
    }
    return {"data": data, "metadata": json.loads(json.dumps(output["metadata"])), "output_type": kind}


def _output_faults(page: Page, cell: SourceCell, outputs: list[dict], root: str) -> Iterator[PageFault]:
    """Find what a cell must not have put out."""
    yield from _raising_faults(page, cell, outputs)
    for output in outputs:
        if output.get("name") == "stderr":
            wrong = f"wrote to stderr: {''.join(_texts(output)).strip()[:200]}"
            yield page.fault(cell, wrong, "a page writes no warnings")
        if "interactive" not in cell.tags:
            yield from _text_faults(page, cell, "".join(_texts(output)), root)
            yield from _picture_faults(page, cell, output.get("data", {}))


def _raising_faults(page: Page, cell: SourceCell, outputs: list[dict]) -> Iterator[PageFault]:
    raised = [output for output in outputs if output["output_type"] == "error"]
    meant = "raises-exception" in cell.tags
    for output in raised:
        if not meant:
            wrong = f"raised {output['ename']}: {output['evalue']}"
            yield page.fault(cell, wrong, 'correct it, or tag the cell "raises-exception" if it is meant')
    if meant and not raised:
        yield page.fault(cell, "raises nothing", 'take the tag "raises-exception" off, or let it fail')


def _text_faults(page: Page, cell: SourceCell, text: str, root: str) -> Iterator[PageFault]:
    if found := ADDRESS.search(text):
        yield page.fault(cell, f"prints an address ({found[0]})", "print what is the same every time")
    if root in text:
        yield page.fault(cell, "prints where it was run", "print no paths")


def _picture_faults(page: Page, cell: SourceCell, data: dict) -> Iterator[PageFault]:
    if WIDGET in data:
        yield page.fault(cell, "shows a widget", 'tag the cell "interactive", and let a figure follow')
    if any(mime.startswith("image/") for mime in data) and not _words(data):
        yield page.fault(cell, "shows an image without words", "let the cell end with a Picture: it has a text")
    size = len(base64.b64decode(data.get("image/png", "")))
    if size > LARGEST_PNG:
        wrong = f"shows an image of {size / 1000:.0f} kB"
        yield page.fault(cell, wrong, f"at most {LARGEST_PNG // 1000} kB: draw less of it")


def _figures(page: Page, outputs: Outputs) -> Iterator[PageFault]:
    """Find interactive cells whose next cell draws nothing."""
    for cell, following in pairwise(page.code):
        if "interactive" in cell.tags and "interactive" not in following.tags:
            drawn = [output for output in outputs[following.name] if "image/png" in output.get("data", {})]
            if not drawn:
                wrong = f'the next code cell, "{following.name}", shows no figure'
                yield page.fault(cell, wrong, "let it draw the same as a static figure")


def _texts(output: dict) -> list[str]:
    if output["output_type"] == "stream":
        return output["text"]
    if output["output_type"] == "error":
        return [output["evalue"]]
    return [line for mime, value in output["data"].items() if mime.startswith("text/") for line in value]


def _words(data: dict) -> bool:
    text = "".join(data.get("text/plain", [])).strip()
    return bool(text) and not text.startswith("<")
