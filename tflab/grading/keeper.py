"""Who sees to it that a kernel ends, and everything it started with it?  Its keeper: one small process each.

    grader ----- wire ------> kernel        what to run, what came of it
       \\----- leash -----> keeper -> kernel   hang up, or die, and all of it is killed

The keeper is outside the sandbox, where the learner's code cannot see it.  It waits for the end of
the kernel or of the leash, looks five times a second at the memory of all the kernel's
processes together, and at last says on the leash how it ended.  When the first process of a
namespace is killed, so are all others in it: no daemon survives.

Read `forkserver.py` next: who makes keepers.
"""

from __future__ import annotations

import contextlib
import json
import os
import select
import shutil
import signal
import socket
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from . import bubblewrap, namespaces, seccomp
from .limits import Limits

__all__ = ["keep"]

TICK_S = 0.2
PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36
FIRST_UID, UIDS = 61000, 4000  # above people and services, below what systemd gives away
ENVIRONMENT = {
    "HOME": namespaces.LEARNER_HOME,
    "LANG": "C.UTF-8",
    "PATH": f"{sys.prefix}/bin:/usr/local/bin:/usr/bin:/bin",
    "PYTHONHASHSEED": "0",
    "PYTHONDONTWRITEBYTECODE": "1",
    "MPLBACKEND": "agg",
    "MPLCONFIGDIR": "/tmp",
    "OPENBLAS_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "MKL_NUM_THREADS": "1",
    "USER": "learner",
}


def keep(
    order: dict[str, Any], wire: socket.socket, leash: socket.socket, serve: Callable[[socket.socket], None]
) -> None:
    """Start a kernel as ordered and stay until it has ended; never returns to the caller's work."""
    limits = Limits(**order["limits"])
    uid = FIRST_UID + os.getpid() % UIDS
    start = {"namespaces": in_namespaces, "bubblewrap": in_bubblewrap, "limits": in_limits}[order["level"]]
    namespaces.libc.prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    folder = tempfile.mkdtemp(prefix="tflab-kernel-") if order["level"] == "limits" else None
    try:
        pid = start(order, wire, leash, serve, limits, uid, folder)
        wire.close()
        said = watch(pid, leash, limits.memory_bytes, uid if order["level"] == "limits" and os.getuid() == 0 else None)
    except OSError as fault:
        said = {"fault": str(fault)}
    finally:
        if folder:
            shutil.rmtree(folder, ignore_errors=True)
    with contextlib.suppress(OSError):
        leash.sendall(json.dumps(said).encode())


# Three ways to start it.


def in_namespaces(
    order: dict[str, Any],
    wire: socket.socket,
    leash: socket.socket,
    serve: Callable[[socket.socket], None],
    limits: Limits,
    uid: int,
    folder: str | None,
) -> int:
    namespaces.leave()
    pid = os.fork()
    if pid:
        return pid

    def enter() -> None:
        inside = uid if os.getuid() == 0 else namespaces.LEARNER_UID
        namespaces.furnish(order["shown"], order["hidden"], limits.file_bytes, inside)
        limits.apply()
        namespaces.become_nobody(uid)
        seccomp.refuse_dangerous_calls()

    become_kernel(enter, wire, leash, serve, order)


def in_limits(
    order: dict[str, Any],
    wire: socket.socket,
    leash: socket.socket,
    serve: Callable[[socket.socket], None],
    limits: Limits,
    uid: int,
    folder: str | None,
) -> int:
    pid = os.fork()
    if pid:
        return pid

    def enter() -> None:
        if os.getuid() == 0:
            os.chown(folder, uid, uid)
        os.chdir(folder)
        limits.apply()
        namespaces.become_nobody(uid)
        seccomp.refuse_dangerous_calls()
        os.environ.update(HOME=folder, TMPDIR=folder, MPLCONFIGDIR=folder)

    become_kernel(enter, wire, leash, serve, order)


def in_bubblewrap(
    order: dict[str, Any],
    wire: socket.socket,
    leash: socket.socket,
    serve: Callable[[socket.socket], None],
    limits: Limits,
    uid: int,
    folder: str | None,
) -> int:
    return bubblewrap.start(order, wire, limits, uid, ENVIRONMENT | order["environment"])


def become_kernel(
    enter: Callable[[], None],
    wire: socket.socket,
    leash: socket.socket,
    serve: Callable[[socket.socket], None],
    order: dict[str, Any],
) -> None:
    """Go behind the wall and serve there; never returns."""
    try:
        leash.close()
        namespaces.libc.prctl(PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
        os.setsid()
        os.environ.clear()
        os.environ.update(ENVIRONMENT | order["environment"])
        try:
            enter()
        except Exception as fault:
            wire.sendall(frame({"fault": f"{type(fault).__name__}: {fault}"}))
            os._exit(1)
        serve(wire)
    except BaseException:
        os._exit(1)  # nobody reads a traceback
    os._exit(0)


def frame(message: dict[str, Any]) -> bytes:
    body = json.dumps(message).encode()
    return len(body).to_bytes(4, "big") + body


# Until the end.


def watch(pid: int, leash: socket.socket, memory_bytes: int, uid: int | None) -> dict[str, Any]:
    """Wait for the end of the kernel, or bring it about; return how it ended."""
    ended = os.pidfd_open(pid)
    said: dict[str, Any] = {}
    poll = select.poll()
    poll.register(ended, select.POLLIN)
    poll.register(leash, select.POLLIN)
    while not (ready := poll.poll(TICK_S * 1000)):
        if memory_of_all(pid) > memory_bytes:
            said["fault"] = "memory limit"
            break
    if not said and ready and ready[0][0] == ended:
        said["ended"] = True
    kill_all(pid, uid)
    os.close(ended)
    return said


def kill_all(pid: int, uid: int | None) -> None:
    """Kill the kernel and all that descends from it, and see them gone."""
    if uid is not None:  # this user is nobody else's: whoever runs as it was started by the kernel
        killer = os.fork()
        if not killer:
            with contextlib.suppress(BaseException):
                os.setresuid(uid, uid, uid)
                os.kill(-1, signal.SIGKILL)
            os._exit(0)
        os.waitpid(killer, 0)
    while True:
        # First the eldest: its death brings up the others, or ends them with their namespace.
        for descendant in (pid, *descendants(os.getpid())):
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.kill(descendant, signal.SIGKILL)
        try:
            os.waitpid(-1, 0)  # orphans come to the keeper
        except ChildProcessError:
            return


def descendants(pid: int) -> list[int]:
    """Return the processes below `pid`, outermost first."""
    found: list[int] = []
    todo = [pid]
    while todo:
        parent = todo.pop()
        for task in Path(f"/proc/{parent}/task").glob("*/children"):
            with contextlib.suppress(OSError):
                children = [int(word) for word in task.read_text().split()]
                found += children
                todo += children
    return found


def memory_of_all(pid: int) -> int:
    """Return what a process and its descendants hold for themselves [bytes]."""
    return sum(map(memory_of, (pid, *descendants(pid))))


def memory_of(pid: int) -> int:
    try:
        for line in Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines():
            if line.startswith("Pss_Anon:"):
                return int(line.split()[1]) * 1024
    except OSError:
        pass
    try:
        _, resident, shared, *_ = Path(f"/proc/{pid}/statm").read_text().split()
    except (OSError, ValueError):
        return 0
    return (int(resident) - int(shared)) * os.sysconf("SC_PAGE_SIZE")
