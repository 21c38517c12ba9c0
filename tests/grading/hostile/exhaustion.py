"""Attacks on time and memory: what does not end, what shouts, what takes all there is."""

from __future__ import annotations

import copy
from collections.abc import Callable

from .recipe import WIRE, WRONG, Honest, Notebook, edited, function, own_cell, value

__all__ = ["EXHAUSTION"]


def _in_two_answers(text: str) -> Callable[[Notebook, Honest], None]:
    """Return an edit that makes the grader itself parse a text."""

    def edit(notebook: Notebook, honest: Honest) -> None:
        cell = honest.cell(notebook, honest.function_task)
        cell["source"] = text
        notebook["cells"] += [copy.deepcopy(cell) | {"id": "two", "source": text + "\n#"}, own_cell(text)]

    return edit


BOMBS = {"members of members": "x" + ".a" * 90_000, "a long sum": "+".join("1" * 90_000), "signs": "-" * 150_000 + "1",
         "brackets": "(" * 90_000 + ")" * 90_000, "lambdas": "lambda:" * 25_000 + "0"}  # fmt: skip


EXHAUSTION = [
    function("changes its argument", "def F(transform):\n    transform.update(RIGHT)\n    return transform"),
    function("a loop without end", "def F(transform):\n    while True: pass\n"),
    value("a loop without end in the cell", "while True: pass\nV = (0, 0, 0)"),
    function("sleeps for ever", "import time\ndef F(transform):\n    time.sleep(10**6)\n"),
    function("holds the interpreter", "def F(transform):\n    return 7 ** 10 ** 8\n"),
    function("a regex without end", "import re\ndef F(transform):\n    return re.match('(a+)+$', 'a' * 60 + 'b')\n"),
    value("memory without end", "hoard = []\nwhile True: hoard.append(bytearray(50_000_000))\nV = 1", keeps="others"),
    value("one huge block", "V = [0] * 10 ** 11"),
    value("a fork bomb", "import os\nwhile True:\n    try: os.fork()\n    except OSError: pass\nV = 1", keeps="any"),
    value("threads without end", """
import threading, time
V = 1
try:
    while True: threading.Thread(target=time.sleep, args=(600,), daemon=True).start()
except Exception: pass
""", keeps="any"),
    value("prints without end", "while True: print('x' * 1000)\nV = 1"),
    value(
        "drips messages without end",
        "import time\nwhile True:\n    print('.', flush=True); time.sleep(0.05)\nV = 1",
    ),
    value("fills the disk", """
V = 1
with open('big', 'wb') as big:
    while True: big.write(bytes(1_000_000))
"""),
    value("opens files without end", "V = 1\nkept = []\nwhile True: kept.append(open('/dev/null'))", keeps="any"),
    value("a list that holds itself", "V = [1]\nV.append(V)"),
    value("ten million numbers", "V = list(range(10 ** 7))"),
    value("an endless generator", "import itertools\nV = itertools.count()"),
    function("recursion without end", "def F(transform):\n    return F(transform)\n"),
    function("a crash in C", "import ctypes\ndef F(transform):\n    ctypes.string_at(0)\n"),
    value("a crash in C in the cell", "import ctypes\nctypes.string_at(0)\nV = 1"),
    value("stops itself", "import os, signal\nos.kill(os.getpid(), signal.SIGSTOP)\nV = 1"),
    value("does not listen to signals", """
import signal
for number in range(1, 32):
    try: signal.signal(number, signal.SIG_IGN)
    except (OSError, ValueError): pass
while True: pass
V = 1
"""),
    value("waits for the keyboard", "V = input('how far? ')"),
    value("waits in a debugger", "breakpoint()\nV = 1", keeps="any"),
    function("memory that forks share", """
import mmap, os, time
for _ in range(20):
    if os.fork() == 0:
        m = mmap.mmap(-1, 200 << 20)
        for at in range(0, len(m), 4096): m[at] = 1
        time.sleep(600)
time.sleep(600)
"""),
    function("a zero device, mapped and let go of", """
import mmap, os, time
device = os.open('/dev/zero', os.O_RDWR)
while True:
    m = mmap.mmap(device, 64 << 20, mmap.MAP_SHARED)
    m.write(b'x' * len(m))
"""),
    function("full buffers of sockets", """
import os, socket, time
for _ in range(40):
    if os.fork() == 0:
        kept = []
        try:
            while True:
                pair = socket.socketpair(); kept += pair
                for end in pair:
                    end.setblocking(False)
                    try:
                        while True: end.send(bytes(60000))
                    except BlockingIOError: pass
        except OSError: pass
        time.sleep(600)
time.sleep(600)
"""),
    function("sixty processes of three hundred megabytes", "import os, time\nfor _ in range(60):\n    if os.fork() == 0:\n        x = b'x' * (300 << 20); time.sleep(600)\ntime.sleep(600)"),
    function("full pipes", """
import fcntl, os, time
for _ in range(120):
    r, w = os.pipe()
    try: fcntl.fcntl(w, 1031, 1 << 20)
    except OSError: pass
    os.set_blocking(w, False)
    try:
        while True: os.write(w, bytes(65536))
    except BlockingIOError: pass
time.sleep(600)
"""),
    function("files without number", WRONG + "import os\ntry:\n    for n in range(10 ** 5): open(f'/tmp/f{n}', 'w').close()\nexcept OSError: pass"),
    function("folders without end", WRONG + "import os\ntry:\n    for n in range(4000): os.mkdir('d'); os.chdir('d')\nexcept OSError: pass"),
    function("widgets and comms without end", "import ipywidgets\nwhile True: ipywidgets.IntSlider()\n"),
    function("a flood of errors", WIRE + "while True: say('error', {'ename': 'x' * 1000, 'evalue': 'y' * 1000})"),
    function("a flood of probes", "from IPython.display import display\nwhile True: display({'application/vnd.tflab.probe+json': {'id': '', 'v': [0] * 1000}}, raw=True)\n"),
    function("an object that never ends being written", """
class Endless(dict):
    def items(self):
        while True: yield ('x', 1.0)
    def keys(self): return iter(lambda: 'x', None)
    def __len__(self): return 3
def F(transform):
    return Endless(x=1)
"""),
    function("limits of its own: nothing", WRONG + "import resource as r\nfor what in (r.RLIMIT_NOFILE, r.RLIMIT_AS, r.RLIMIT_FSIZE, r.RLIMIT_NPROC): r.setrlimit(what, (0, 0))"),
    function("hangs at its second call", "n = 0\ndef F(transform):\n    global n\n    n += 1\n    while n > 1: pass"),
    value("waits for what never comes", "import asyncio\nawait asyncio.Event().wait()\nV = 1"),
    *(edited(f"the grader parses {name}", _in_two_answers(text), "function", "others") for name, text in BOMBS.items()),
]  # fmt: skip
