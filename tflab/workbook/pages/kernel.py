"""How does a kernel live just as long as it is needed?  A context holds it, and Ctrl-C ends both.

    async with running_kernel(client, env):      nbclient's client; its kernel is there
        await client.async_execute_cell(...)
                                                 here it is gone, however the block ended

nbclient's own context takes Ctrl-C for itself and stumbles over it; this one leaves
it to Python.
"""

from __future__ import annotations

import asyncio
import subprocess
import warnings
from collections.abc import AsyncIterator, Coroutine, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager
from typing import Any

__all__ = ["being_cancelled", "running_kernel", "wait_for"]


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
        return _run(work)
    with ThreadPoolExecutor(1) as thread:  # the loop is Jupyter's, or that of a browser that is steered
        return thread.submit(_run, work).result()


def _run(work: Coroutine) -> Any:
    with warnings.catch_warnings():  # on Windows pyzmq says that it helps itself with a thread: nobody has to act
        warnings.filterwarnings("ignore", "Proactor event loop", RuntimeWarning)
        return asyncio.run(work)
