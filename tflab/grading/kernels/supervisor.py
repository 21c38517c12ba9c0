"""Watch one kernel from outside the sandbox, and end it with everything that it started.

    grader ----- wire ------> kernel        what to run, what came of it
       \\----- leash -----> supervisor -> kernel   hang up, or die, and all of it is killed

The supervisor is outside the sandbox, where the learner's code cannot see it.  It adopts what loses its
parent (a subreaper), waits for the end of the kernel or of the leash, looks five times a second at
the memory of all the kernel's processes together, and at last says on the leash how it ended.  When
the first process of a namespace is killed, so are all others in it: no daemon survives.
"""

from __future__ import annotations

import contextlib
import errno
import json
import os
import select
import shutil
import signal
import socket
import stat
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from . import bubblewrap, landlock, namespaces, rlimits, seccomp
from .limits import Limits
from .wire import Wire

__all__ = ["supervise"]

TICK_S = 0.2
SHARED = "/dev/zero (deleted)"  # how maps call memory that forks share
FREE_SOCKETS, BYTES_OF_A_SOCKET = 32, 400 << 10
BYTES_OF_A_MAPPING = 256  # that the system keeps for it
MANY_TABLES = 4 << 20  # of a process that looks into memory in many pieces
LONGEST_LOOK_S = 0.5  # of processor time, at all processes; sixty that share much take a tenth of that
MOST_FILES = 4096
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
    "PIP_NO_INDEX": "1",  # `!pip install` fails at once: there is no network to wait for
    "PIP_RETRIES": "0",
    "PIP_DISABLE_PIP_VERSION_CHECK": "1",
}


@dataclass(frozen=True)
class KernelLaunch:
    """Which kernel to start, and with what ends in its hands."""

    level: str
    limits: Limits
    shown: list[str]
    hidden: list[str]
    environment: dict[str, str]
    uid: int
    folder: str  # of the kernel, where it has no file system of its own
    reserved: socket.socket  # whose name says that the user is taken
    wire: socket.socket
    leash: socket.socket
    serve: Callable[[socket.socket], None]


def supervise(said: dict[str, Any], wire: socket.socket, leash: socket.socket, serve: Callable[[Any], None]) -> None:
    """Start a kernel as requested and stay until it has ended."""
    namespaces.libc.prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    folder = tempfile.mkdtemp(prefix="tflab-kernel-") if said["level"] == "limits" else ""
    try:
        uid, reserved = reserve_user_id()
        of_its_own = {"uid": uid, "reserved": reserved, "folder": folder}
        of_its_own |= {"limits": Limits(**said["limits"]), "environment": ENVIRONMENT | said["environment"]}
        launch = KernelLaunch(**said | of_its_own, wire=wire, leash=leash, serve=serve)
        pid = START[launch.level](launch)
        wire.close()
        end = watch(pid, launch)
    except OSError as fault:
        end = {"fault": str(fault)}
    finally:
        if folder:
            shutil.rmtree(folder, ignore_errors=True)
    with contextlib.suppress(OSError):
        leash.sendall(json.dumps(end).encode())


def reserve_user_id() -> tuple[int, socket.socket]:
    """Return a user id that no other supervisor has reserved, and the socket that reserves it while it is open.

    At its kernel's end a supervisor kills whoever runs as this user.  A name of the abstract kind is taken by
    one socket at a time and is free when its process is gone, however that ended.

    Raises:
        OSError: all are taken.
    """
    reserved = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    for number in range(UIDS):
        uid = FIRST_UID + (os.getpid() + number) % UIDS
        try:
            reserved.bind(f"\0tflab-kernel-user-{uid}")
            return uid, reserved
        except OSError as fault:
            if fault.errno != errno.EADDRINUSE:
                raise
    raise OSError(f"no user from {FIRST_UID} to {FIRST_UID + UIDS - 1} is free for a kernel")


# Three ways to start it.


def in_namespaces(launch: KernelLaunch) -> int:
    """Fork a kernel that is the first process of its own small machine."""

    def enter() -> None:
        uid = launch.uid if os.getuid() == 0 else namespaces.LEARNER_UID
        namespaces.mount_file_system(launch.shown, launch.hidden, launch.limits.file_bytes, uid)
        rlimits.apply(launch.limits)
        namespaces.drop_privileges(launch.uid)

    namespaces.unshare_namespaces()
    return os.fork() or become_kernel(launch, enter)


def in_bubblewrap(launch: KernelLaunch) -> int:
    words = bubblewrap.command(launch.shown, launch.hidden, launch.limits.file_bytes, launch.environment)
    return bubblewrap.start(words, launch.wire, {"limits": asdict(launch.limits), "uid": launch.uid})


def in_limits(launch: KernelLaunch) -> int:
    """Fork a kernel that has a folder and, from root, a user of its own."""

    def enter() -> None:
        uid = launch.uid if gets_a_user() else None
        if uid is not None:
            os.chown(launch.folder, uid, uid)
        os.chdir(launch.folder)
        os.environ.update(HOME=launch.folder, TMPDIR=launch.folder, MPLCONFIGDIR=launch.folder)
        tempfile.tempdir = None
        rlimits.apply(launch.limits, others=0 if uid is not None else rlimits.tasks_of(os.getuid()))
        namespaces.drop_privileges(uid, right_to_python() if uid is not None else None)
        landlock.confine(launch.shown, launch.hidden, launch.folder)

    return os.fork() or become_kernel(launch, enter)


START: dict[str, Callable[[KernelLaunch], int]] = {
    "namespaces": in_namespaces,
    "bubblewrap": in_bubblewrap,
    "limits": in_limits,
}


def gets_a_user() -> bool:
    """Return whether a kernel that sees all files can be a user of its own: it must be able to read Python.

    A user of its own has a limit of processes, which root has not, and nobody else's processes to signal.
    """
    return os.getuid() == 0 and (is_python_open() or right_to_python() is not None)


def is_python_open() -> bool:
    """Return whether everybody can read Python: some lie in a closed home."""
    places = {Path(place).resolve() for place in (sys.prefix, sys.base_prefix, __file__)}
    folders = {folder for place in places for folder in (place, *place.parents) if folder.is_dir()}
    return all(folder.stat().st_mode & 0o5 == 0o5 for folder in folders)


def right_to_python() -> int | None:
    """Return the right that somebody who is not root needs to read Python, the smallest that is there; None if none.

    It opens no more than root has, and less where Landlock confines.
    """
    if is_python_open():
        return None
    status = Path("/proc/self/status").read_text()
    held = next(int(line.split()[1], 16) for line in status.splitlines() if line.startswith("CapEff:"))
    rights = [namespaces.READ_ALL, *([namespaces.WRITE_ALL] if landlock.abi() >= landlock.CONFINES else [])]
    return next((right for right in rights if held >> right & 1), None)


def become_kernel(launch: KernelLaunch, enter: Callable[[], None]) -> int:
    """Go behind the wall and serve there; never returns."""
    try:
        launch.leash.close()
        launch.reserved.close()
        namespaces.libc.prctl(PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
        os.setsid()
        os.nice(5)  # the supervisor and the grader come first
        os.environ.clear()
        os.environ.update(launch.environment)
        try:
            enter()
            seccomp.refuse_dangerous_calls(names_are_shared=launch.level == "limits")
        except Exception as fault:
            Wire(launch.wire, longest=0).send({"fault": f"{type(fault).__name__}: {fault}"})
            os._exit(1)
        launch.serve(launch.wire)
    finally:
        os._exit(0)  # nobody reads a traceback


# Until the end.


def watch(pid: int, launch: KernelLaunch) -> dict[str, Any]:
    """Wait for the end of the kernel, or bring it about; return how it ended."""
    ended = os.pidfd_open(pid)
    said: dict[str, Any] = {}
    poll = select.poll()
    poll.register(ended, select.POLLIN)
    poll.register(launch.leash, select.POLLIN)
    while not (ready := poll.poll(TICK_S * 1000)):
        processes = descendants(os.getpid())  # whoever has lost its parent is the supervisor's
        if len(processes) > 2 * launch.limits.processes:  # root has no limit of them
            said["fault"] = "process limit"
            break
        if memory_of_all(processes, launch.limits.memory_bytes) > launch.limits.memory_bytes:
            said["fault"] = "memory limit"
            break
        if launch.folder and disk_of(launch.folder, processes, launch.limits.file_bytes) > launch.limits.file_bytes:
            said["fault"] = "disk limit"
            break
    if not said and ready and ready[0][0] == ended:
        said["ended"] = True
    kill_all(pid, launch.uid if launch.level == "limits" and gets_a_user() else None)
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
            os.waitpid(-1, 0)  # orphans come to the supervisor
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass
        except ChildProcessError:
            return


def descendants(pid: int) -> list[int]:
    """Return the processes below `pid`, without_nested_paths first."""
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


def memory_of_all(processes: Sequence[int], enough: int) -> int:
    """Return what processes hold, in their own tables and outside of them [bytes]; exactly only above `enough`."""
    outside = behind_sockets(processes)
    rough = [rough_memory_of(process) for process in processes]
    if outside + sum(held + tables for held, tables in rough) <= enough:
        return outside + sum(held + tables for held, tables in rough)
    shared: dict[str, int] = {}
    total, begun = outside, time.thread_time()
    for process, (held, tables) in zip(processes, rough, strict=True):
        total += tables
        if tables > MANY_TABLES or time.thread_time() - begun > LONGEST_LOOK_S:  # not a page less than it may be
            total += held
        else:
            maps = mappings_of(process)
            total += memory_of(process) + len(maps) * BYTES_OF_A_MAPPING
            shared |= shared_memory_in(maps)
    return total + sum(shared.values())


def rough_memory_of(pid: int) -> tuple[int, int]:
    """Return what a process holds, with what it shares since its fork, and the tables for that; quickly [bytes]."""
    try:
        status = Path(f"/proc/{pid}/status").read_text(errors="replace")
    except OSError:
        return 0, 0
    sizes = {line.split(":")[0]: line.split()[1] for line in status.splitlines() if line.endswith(" kB")}
    return sum(int(sizes.get(name, 0)) * 1024 for name in ("RssAnon", "RssShmem")), int(sizes.get("VmPTE", 0)) * 1024


def disk_of(folder: str, processes: Sequence[int], enough: int) -> int:
    """Return what the files in a folder hold, and those that are open and in no folder any more [bytes]."""
    total = count = 0
    for place, _, files in os.walk(folder):
        for name in files:
            with contextlib.suppress(OSError):
                total += os.lstat(os.path.join(place, name)).st_blocks * 512
            count += 1
            if total > enough or count > MOST_FILES:
                return enough + 1
    for process in processes:
        total += sum(size_if_removed(f"/proc/{process}/fd/{number}") for number in descriptors(process))
    return total


def size_if_removed(descriptor: str) -> int:
    with contextlib.suppress(OSError):
        status = os.stat(descriptor)
        if stat.S_ISREG(status.st_mode) and status.st_nlink == 0:
            return status.st_blocks * 512
    return 0


def memory_of(pid: int) -> int:
    """Return what a process holds for itself [bytes]."""
    try:
        lines = Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines()
        return sum(int(line.split()[1]) * 1024 for line in lines if line.startswith("Pss_Anon:"))
    except OSError:
        return rough_memory_of(pid)[0]


def mappings_of(pid: int) -> list[str]:
    try:
        return Path(f"/proc/{pid}/maps").read_text(errors="replace").splitlines()
    except OSError:
        return []


def shared_memory_in(maps: Sequence[str]) -> dict[str, int]:
    """Return the sizes of memory that forks share, by its inode: pages dropped from all tables are kept, too."""
    sizes: dict[str, int] = {}
    for line in maps:
        if line.endswith(SHARED):
            span, _, offset, _, inode, *_ = line.split()
            begin, end = (int(number, 16) for number in span.split("-"))
            sizes[f"{inode}:{offset}"] = max(end - begin, sizes.get(f"{inode}:{offset}", 0))
    return sizes


def behind_sockets(processes: Sequence[int]) -> int:
    """Return the most that the system may hold in the buffers of processes' sockets and pipes [bytes]."""
    ends = {end for process in processes for end in ends_of(process)}
    return max(0, len(ends) - FREE_SOCKETS) * BYTES_OF_A_SOCKET


def ends_of(pid: int) -> set[str]:
    """Return the sockets and pipes of a process: what forks share has one name."""
    found = set()
    for number in descriptors(pid):
        with contextlib.suppress(OSError):
            name = os.readlink(f"/proc/{pid}/fd/{number}")
            if name.startswith(("socket:", "pipe:")):
                found.add(name)
    return found


def descriptors(pid: int) -> list[str]:
    try:
        return os.listdir(f"/proc/{pid}/fd")
    except OSError:
        return []
