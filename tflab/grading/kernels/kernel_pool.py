"""Hand out sandboxed kernels; the next one is always started in advance.

    kernels = Kernels(choose_sandbox())
    kernel = kernels.take(Limits())       # milliseconds: it was waiting
    kernel.wire.send({...}); kernel.close()

One `Kernels` belongs to one process; `for_this_process` keeps one for each sandbox.
"""

from __future__ import annotations

import atexit
import contextlib
import json
import os
import socket
import subprocess
import sys
import tempfile
import threading
from dataclasses import asdict, dataclass

from . import landlock, namespaces
from .bubblewrap import WITHOUT_THIS_FOLDER
from .limits import Limits
from .sandbox import LEVELS, Sandbox
from .wire import Wire, WireClosed, WireFault

__all__ = ["Kernel", "KernelError", "Kernels", "choose_sandbox", "for_this_process"]

START_S = 60.0
PR_SET_DUMPABLE = 4
MOST_ENDING = 3  # kernels that were hung up on and may not be quite gone
PASSED_ON = ("TFLAB_ROS_DISTRO",)  # of the grader's environment


class KernelError(RuntimeError):
    """There is no kernel to be had this way."""


@dataclass(eq=False)
class Kernel:
    """A kernel that runs: say something on its wire; drop its leash and it is gone."""

    wire: Wire
    leash: socket.socket
    hung_up: bool = False

    def await_ready(self) -> None:
        """Return when it serves; raise KernelError with the reason if it never will."""
        try:
            hello = self.wire.receive(START_S)
        except (WireClosed, WireFault) as fault:
            raise KernelError(self.close() or f"the kernel did not start: {fault}") from None
        if hello is None or hello.get("ready") is not True:
            self.close()
            reason = "it took too long" if hello is None else hello.get("fault", "it talks nonsense")
            raise KernelError(f"the kernel did not start: {reason}")

    def hang_up(self) -> None:
        """Have it ended, and all it started; do not wait until all are gone."""
        if not self.hung_up:
            self.hung_up = True
            with contextlib.suppress(OSError):
                self.leash.shutdown(socket.SHUT_WR)
            self.wire.close()

    def close(self) -> str | None:
        """Have it ended, and all it started; return what its supervisor says about the end, once all are gone."""
        if self.leash.fileno() == -1:
            return None
        self.hang_up()
        said = b""
        with contextlib.suppress(OSError):
            self.leash.settimeout(START_S)
            while part := self.leash.recv(4096):
                said += part
        self.leash.close()
        return json.loads(said).get("fault") if said else None


class Kernels:
    """A forkserver, and the kernels it makes."""

    def __init__(self, sandbox: Sandbox, *, ahead: int = 1) -> None:
        self.sandbox = sandbox
        self.ahead = ahead
        self._ready: list[tuple[Limits, Kernel]] = []
        self._ending: list[Kernel] = []  # given away, and not known to be gone
        self._lock = threading.Lock()
        self._shown, self._hidden = sandbox.shown(), sandbox.hidden()
        if sandbox.level == "limits" and landlock.abi() < landlock.CONFINES:
            namespaces.libc.prctl(PR_SET_DUMPABLE, 0, 0, 0, 0)  # at least nobody reads this process's memory
        self._server: subprocess.Popen[bytes] | None = None
        self._requests: socket.socket | None = None

    def take(self, limits: Limits) -> Kernel:
        """Return a kernel that serves; it is the caller's to close."""
        with self._lock:
            kernel = next((kernel for made_for, kernel in self._ready if made_for == limits), None)
            self._ready = [(made_for, other) for made_for, other in self._ready if other is not kernel]
            if kernel is None:
                kernel = self._request(limits)
            self._ending.append(kernel)
            in_use = sum(not other.hung_up for other in self._ending)  # by so many threads
            while len(self._ready) < self.ahead * in_use:
                self._ready.append((limits, self._request(limits)))
            ended = [other for other in self._ending[:-MOST_ENDING] if other.hung_up]
            self._ending = [other for other in self._ending if other not in ended]
        for other in ended:
            other.close()
        try:
            kernel.await_ready()
        except KernelError:  # its forkserver may be gone, or the machine was out of room for a moment
            with self._lock:
                kernel = self._request(limits)
                self._ending.append(kernel)
            kernel.await_ready()
        return kernel

    def _request(self, limits: Limits) -> Kernel:
        request = {
            "level": self.sandbox.level,
            "limits": asdict(limits),
            "shown": self._shown,
            "hidden": self._hidden,
            "environment": {name: os.environ[name] for name in PASSED_ON if name in os.environ},
        }
        wire, wire_end = socket.socketpair()
        leash, leash_end = socket.socketpair()
        ends = [wire_end.fileno(), leash_end.fileno()]
        try:
            for attempt in (1, 2):
                try:
                    socket.send_fds(self._server_socket(), [json.dumps(request).encode()], ends)
                    break
                except OSError:  # it has died, of memory perhaps
                    self._stop_server()
                    if attempt == 2:
                        raise
        finally:
            wire_end.close()
            leash_end.close()
        return Kernel(Wire(wire, longest=limits.output_bytes), leash)

    def _server_socket(self) -> socket.socket:
        """Return where the forkserver takes requests; start it if there is none."""
        if self._requests is not None:
            return self._requests
        self._requests, its = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with tempfile.TemporaryFile() as words:  # it may have warnings; they matter only if it fails
            with its:
                self._server = subprocess.Popen(
                    [sys.executable, *WITHOUT_THIS_FOLDER, "-m", "tflab.grading.kernels.forkserver", str(its.fileno())],
                    pass_fds=[its.fileno()],
                    start_new_session=True,  # Ctrl-C is for the grader
                    stdin=subprocess.DEVNULL,
                    stdout=subprocess.DEVNULL,
                    stderr=words,
                    cwd="/",
                    env=environment_of_the_server(),
                )
            self._requests.settimeout(START_S)
            if self._requests.recv(16) != b"ready":
                self._stop_server()
                words.seek(0)
                last = words.read().decode(errors="replace").strip().splitlines()[-1:]
                raise KernelError(f"the forkserver did not start: {' '.join(last)}")
        return self._requests

    def _stop_server(self) -> None:
        if self._requests is not None:
            self._requests.close()
            self._requests = None
        if self._server is not None:
            with contextlib.suppress(subprocess.TimeoutExpired):
                self._server.wait(5)
            if self._server.returncode is None:
                self._server.kill()
                self._server.wait()
            self._server = None

    def settle(self) -> None:
        """Wait until all kernels that were hung up on are gone."""
        with self._lock:
            ended = [kernel for kernel in self._ending if kernel.hung_up]
            self._ending = [kernel for kernel in self._ending if not kernel.hung_up]
        for kernel in ended:
            kernel.close()

    def close(self) -> None:
        """End the kernels that were forked ahead, and the forkserver."""
        self.settle()
        with self._lock:
            for _, kernel in self._ready:
                kernel.close()
            self._ready = []
            self._stop_server()


def environment_of_the_server() -> dict[str, str]:
    """Return what the forkserver sees of the grader's environment: where Python and its fonts are."""
    kept = {name: os.environ[name] for name in ("HOME", "PYTHONPATH", "LD_LIBRARY_PATH") if name in os.environ}
    one_thread = dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"), "1")  # before a fork
    return kept | one_thread | {"LANG": "C.UTF-8", "PATH": os.defpath, "PYTHONHASHSEED": "0", "MPLBACKEND": "agg"}


def choose_sandbox(hide: tuple[str, ...] = ()) -> Sandbox:
    """Return the best sandbox that works on this machine, tried out."""
    reasons: list[str] = []
    for level in LEVELS:
        sandbox = Sandbox(level, hide, refused=tuple(reasons))
        try:
            for_this_process(sandbox).take(Limits()).close()
            return sandbox
        except (KernelError, OSError) as fault:
            reasons.append(f"no {level}: {fault}")
            forget(sandbox)
    raise KernelError("no kernel can be started here; " + "; ".join(reasons))


_of_this_process: dict[tuple[int, Sandbox], Kernels] = {}
_lock = threading.Lock()


def for_this_process(sandbox: Sandbox) -> Kernels:
    """Return the kernels of this process; a forked process gets its own."""
    here = (os.getpid(), sandbox)
    with _lock:
        if here not in _of_this_process:
            _of_this_process[here] = Kernels(sandbox)
        return _of_this_process[here]


def forget(sandbox: Sandbox) -> None:
    """End what this process has started in this kind of sandbox."""
    with _lock:
        kernels = _of_this_process.pop((os.getpid(), sandbox), None)
    if kernels is not None:
        kernels.close()


@atexit.register
def forget_all() -> None:
    for pid, sandbox in list(_of_this_process):
        if pid == os.getpid():
            forget(sandbox)
