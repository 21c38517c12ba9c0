"""What a notebook sets for its whole process: the kernel's end of the wire, the process, Python itself."""

from __future__ import annotations

from typing import Any

from .recipe import WIRE, WRONG, Honest, Notebook, Recipe, edited, function, right

__all__ = ["SETTINGS"]

LIBC = "import ctypes\nlibc = ctypes.CDLL(None, use_errno=True)\n"


def set_before(name: str, source: str) -> Recipe:
    """Return an honest notebook with a cell of its own, before everything, that sets something for all that follows."""
    return Recipe(name, lambda honest: honest.with_cell(source, "E3.1"))


def _breaks_of_every_kind(notebook: Notebook, honest: Honest) -> None:
    cell: dict[str, Any] = honest.cell(notebook, honest.function_task)
    cell["source"] = "# a page\x0c# a line\u2028# a paragraph\u2029# the next\x85\n" + cell["source"].replace(
        "    ", "\t"
    )


SETTINGS = [
    function("urgent bytes on the wire", WIRE + "import socket\nfor _ in range(50):\n    try: wire.end.send(b'!', socket.MSG_OOB)\n    except OSError: break", keeps="any"),
    function("descriptors for the grader, over the wire", WIRE + "import os, socket\ntry: socket.send_fds(wire.end, [struct.pack('!I', 2) + b'{}'], [os.open('/', os.O_PATH) for _ in range(200)])\nexcept OSError: pass", keeps="any"),
    function("a wire that signals whoever owns it", WIRE + "import fcntl, os\nfor pid in (os.getppid(), -os.getpgid(0), 1):\n    try:\n        fcntl.fcntl(wire.end, fcntl.F_SETOWN, pid); fcntl.fcntl(wire.end, 10, 9)\n        fcntl.fcntl(wire.end, fcntl.F_SETFL, fcntl.fcntl(wire.end, fcntl.F_GETFL) | os.O_ASYNC)\n    except OSError: pass", keeps="any"),
    function("buffers of the wire as small as can be", WIRE + "import socket\nfor what in (socket.SO_SNDBUF, socket.SO_RCVBUF): wire.end.setsockopt(socket.SOL_SOCKET, what, 1)\nwire.end.setsockopt(socket.SOL_SOCKET, socket.SO_RCVTIMEO, struct.pack('ll', 0, 1))", keeps="any"),
    function("a process called as a line of /proc is read", WRONG + LIBC + "import os\nfor name in (b') Z 1 1 (', b'\\n) R 0', b'kworker/0:0'):\n    libc.prctl(15, name)\n    if not os.fork(): libc.prctl(15, name); os._exit(0)"),
    function("a process that nobody may look into, with a gigabyte", WRONG + LIBC + "import mmap\nlibc.prctl(4, 0)\nheld = []\nfor _ in range(1024):\n    page = mmap.mmap(-1, 1 << 20); page.write(b'x' * (1 << 20)); held.append(page)", keeps="any"),
    function("every signal blocked, and a loop without end", "import signal\ndef F(transform):\n    signal.pthread_sigmask(signal.SIG_BLOCK, set(signal.Signals))\n    while True: pass"),
    function("the signals of timers and children left to nobody", WRONG + "import signal\nfor number in set(signal.Signals) - {signal.SIGKILL, signal.SIGSTOP}:\n    try: signal.signal(number, signal.SIG_IGN)\n    except (OSError, ValueError): pass"),
    function("numbers that JSON writes as others", WRONG + "import json\njson.encoder.c_make_encoder = None\njson.encoder.encode_basestring_ascii = json.encoder.py_encode_basestring_ascii = lambda text: '\"x\"'", keeps="any"),
    function("a recursion limit of sixty", WRONG + "import sys\ntry: sys.setrecursionlimit(60)\nexcept RecursionError: pass", keeps="any"),
    set_before("a recursion limit without end", "import sys\nsys.setrecursionlimit(2**31 - 1)"),
    set_before("every warning is an error", "import warnings\nwarnings.simplefilter('error')"),
    set_before("NumPy raises at what it rounds to nothing", "import numpy as np\nnp.seterr(all='raise')"),
    set_before("a mask that lets nobody read", "import os\nos.umask(0o777)"),
    set_before("a working folder in /proc", "import os\nos.chdir('/proc')"),
    set_before("no environment", "import os\nos.environ.clear()"),
    set_before("threads that never change", "import sys\nsys.setswitchinterval(3600)"),
    set_before("garbage that is kept", "import gc\ngc.disable(); gc.set_debug(gc.DEBUG_SAVEALL); gc.freeze()"),
    set_before("the last of all priorities", "import os\nos.nice(19)\nos.sched_setscheduler(0, os.SCHED_BATCH, os.sched_param(0))"),
    set_before("decimals that trap everything", "import decimal\ndecimal.getcontext().prec = 1\nfor trap in decimal.getcontext().traps: decimal.getcontext().traps[trap] = True"),
    set_before("a clock that stands still", "import time\ntime.time = time.monotonic = time.perf_counter = lambda: 0.0"),
    set_before("names by chance that are all the same", "import os, random, uuid\nrandom.seed(0)\nos.urandom = lambda count: bytes(count)\nuuid.uuid4 = lambda: uuid.UUID(int=0)"),
    set_before("few digits, many threads", "import numpy as np, os\nnp.set_printoptions(precision=1, suppress=True)\nos.environ['OMP_NUM_THREADS'] = '999'"),
    set_before("every message of a log, at every level", "import logging\nlogging.basicConfig(level=0, force=True)\nlogging.raiseExceptions = True"),
    right("a name in full-width letters", "def ｉｎｖｅｒｔ(transform):\n    return RIGHT"),
    right("dispatched by its kind", "import functools\n@functools.singledispatch\ndef F(transform):\n    return RIGHT"),
    right("a method bound to nobody", "import types\ndef _f(self, transform):\n    return RIGHT\nF = types.MethodType(_f, object())"),
    edited("line breaks of every kind, and tabs", _breaks_of_every_kind),
]  # fmt: skip
