"""Serve `isolated.py`: judge each large answer in a forked process with CPU and memory limits.

    python -m tflab.grading.judging.isolated_server 7      serve what comes over descriptor 7

The server has imported what judging needs and looks at nothing itself: it reads bytes,
forks, and says so if the child ended otherwise than by itself (a preforking server
under `setrlimit`).
"""

from __future__ import annotations

import contextlib
import gc
import os
import pickle
import resource
import signal
import sys
from multiprocessing.connection import Connection
from typing import NoReturn

from ..kernels.rlimits import virtual_memory
from .isolated import WORK, OverLimit

__all__ = ["main"]

FOR_THE_WAY_BACK_S = 5


def main(descriptor: int) -> None:
    """Serve until the grader hangs up."""
    line = Connection(descriptor)
    gc.freeze()  # what is here now stays shared
    while True:
        try:
            cpu_s, memory = line.recv()
            order = line.recv_bytes()
        except EOFError:
            return
        child = os.fork()
        if not child:
            look(order, line, cpu_s, memory)
        _, status = os.waitpid(child, 0)
        if status:
            line.send((False, OverLimit()))


def look(order: bytes, line: Connection, cpu_s: int, memory: int) -> NoReturn:
    """Do what is asked within the limits, send what came of it, and end."""
    status = 1
    with contextlib.suppress(MemoryError):
        resource.setrlimit(resource.RLIMIT_CPU, (cpu_s, cpu_s + FOR_THE_WAY_BACK_S))
        most = virtual_memory() + memory
        resource.setrlimit(resource.RLIMIT_AS, (most, most))
        work, arguments = pickle.loads(order)
        del order
        try:
            said = (True, WORK[work](*arguments))
        except Exception as error:
            said = (False, RuntimeError(type(error).__name__) if not isinstance(error, MemoryError) else OverLimit())
        signal.signal(signal.SIGXCPU, signal.SIG_IGN)  # half an answer would be the end of the line
        line.send(said)
        status = 0
    os._exit(status)


if __name__ == "__main__":
    main(int(sys.argv[1]))
