"""Fork kernels from one process that has imported everything.

    python -m tflab.grading.kernels.forkserver 7           serve requests that come over descriptor 7
    python -m tflab.grading.kernels.forkserver --one 7     be one kernel (inside bubblewrap)

It is executed afresh, with an environment of its own, and never sees a submission, a pack or an
expected value: what a kernel inherits from it is Python with the libraries loaded, nothing else.
A request is a frame of JSON with two descriptors: the kernel's end of the wire and the supervisor's of the leash.
"""

from __future__ import annotations

import contextlib
import gc
import importlib
import io
import json
import os
import random
import signal
import socket
import sys
from typing import Any

__all__ = ["main"]

# What answers and probes use, and what IPython would load at its first cell.
PRELOADED = (
    "asyncio", "concurrent.futures.thread", "ctypes.util", "multiprocessing", "numpy", "matplotlib.pyplot",
    "IPython.core.magics", "IPython.core.magics.execution", "IPython.core.magics.extension", "IPython.core.magics.osm",
    "IPython.core.completer", "IPython.core.pylabtools", "IPython.display", "pexpect",
    "ipywidgets", "comm", "tornado.platform.asyncio", "pygments.styles", "pygments.formatters",
    "tflab.core", "tflab.ros", "tflab.ros.activation", "tflab.tools.magic", "tflab.workbook", "tflab.workbook.checks",
    "tflab.workbook.answers.forms", "tflab.workbook.tasks.task", "tflab.workbook.answers.values",
    "tflab.grading.kernels.probe_answer",
)  # fmt: skip
LONGEST_ORDER = 1 << 16


def main(arguments: list[str]) -> None:
    """Serve requests, or be the one kernel of a bubblewrap."""
    if arguments[0] == "--one":
        run_single_kernel(socket.socket(fileno=int(arguments[1])), json.loads(arguments[2]))
    else:
        serve_requests(socket.socket(fileno=int(arguments[0])))


def serve_requests(requests: socket.socket) -> None:
    from . import ipython as shell
    from . import supervisor  # all that is needed is here before the first fork

    kernel = prepare()
    silence()
    shell.warm_up(kernel)
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # nobody waits for supervisors: the leash tells
    gc.collect()
    gc.freeze()  # what is here now is never moved or looked at again, so it stays shared
    requests.send(b"ready")
    while True:
        said, ends, _, _ = socket.recv_fds(requests, LONGEST_ORDER, 2)
        if not said:
            return
        wire, leash = (socket.socket(fileno=end) for end in ends)
        if fork_or_none() == 0:
            with contextlib.suppress(BaseException):
                requests.close()
                os.setsid()
                supervisor.supervise(json.loads(said), wire, leash, lambda end: serve(kernel, end))
            os._exit(0)
        wire.close()
        leash.close()


def fork_or_none() -> int | None:
    """Fork, or return None where the machine has no room for one more: who ordered it sees its wire closed."""
    try:
        return os.fork()
    except OSError:
        return None


def run_single_kernel(wire: socket.socket, request: dict[str, Any]) -> None:
    from . import namespaces, rlimits, seccomp
    from .limits import Limits

    kernel = prepare()
    silence()
    rlimits.apply(Limits(**request["limits"]))
    namespaces.drop_privileges(request["uid"])
    seccomp.refuse_dangerous_calls()
    serve(kernel, wire)


def prepare() -> Any:
    """Import everything and build the kernel that will be forked."""
    sys.modules["debugpy"] = None  # type: ignore[assignment]  # 70 ms, and it patches what it finds
    for name in PRELOADED:
        with contextlib.suppress(ImportError):
            importlib.import_module(name)
    from . import ipython as shell

    kernel = shell.build()
    # Loaded only when first used; `-P` keeps the folder of whoever called out of the path, pages have theirs in it.
    sys.path.insert(0, "")
    return kernel


def silence() -> None:
    """Let all output go nowhere: what matters goes over the wire."""
    null = os.open(os.devnull, os.O_RDWR)
    for standard in (0, 1, 2):
        os.dup2(null, standard)
    os.close(null)
    sys.stdout, sys.stderr = (io.TextIOWrapper(NullStream(standard), encoding="utf-8") for standard in (1, 2))


class NullStream(io.RawIOBase):
    """What is printed to: as in JupyterLab no descriptor, so that a print works whatever becomes of that."""

    def __init__(self, descriptor: int) -> None:
        self._descriptor = descriptor

    def writable(self) -> bool:
        return True

    def write(self, text: Any) -> int:
        return len(text)

    def fileno(self) -> int:
        return self._descriptor


def serve(kernel: Any, wire: socket.socket) -> None:
    import numpy

    from . import ipython as shell

    gc.set_threshold(50_000, 20, 20)  # a kernel lives for moments
    random.seed(0)  # whatever an answer draws, it draws the same every time
    numpy.random.seed(0)
    os.umask(0o022)
    os.closerange(3, wire.fileno())
    os.closerange(wire.fileno() + 1, 256)
    shell.serve(kernel, wire)


if __name__ == "__main__":
    main(sys.argv[1:])
