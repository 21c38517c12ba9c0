"""A library of what people hand in: hostile, broken, and odd but right.

Each entry is a recipe: an honest notebook of chapter 03 goes in, what is handed in
comes out.  `spoils` names the task whose answer the recipe replaces by an attack
("function", "value", or "" for none): it must get nothing.  `keeps` says which
honest points have to survive: "all" of them, the "others" (all but the spoilt
task's), or "none" where there is nothing left to read.
"""

from __future__ import annotations

import copy
import json
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

__all__ = ["RECIPES", "Honest", "Recipe"]

Notebook = dict[str, Any]


@dataclass(frozen=True)
class Honest:
    """An honest notebook, and the names of what can be attacked in it.

    Attributes:
        notebook: every task answered rightly.
        function_task, function: a task whose answer is a function that turns a pose round, and its name.
        value_task, value: a task whose answer is a dict of points, and its name.
    """

    notebook: Notebook
    function_task: str
    function: str
    value_task: str
    value: str

    def fresh(self) -> Notebook:
        """Return a copy to spoil."""
        return copy.deepcopy(self.notebook)

    def cell(self, notebook: Notebook, task: str, role: str = "answer") -> dict[str, Any]:
        """Return a task's cell in a notebook."""
        name = f"{task.lower().replace('.', '-')}-{role}"
        return next(cell for cell in notebook["cells"] if cell["id"] == name)

    def with_function(self, body: str) -> Notebook:
        """Return the notebook with the function's answer cell replaced; `F` is the function's name."""
        notebook = self.fresh()
        self.cell(notebook, self.function_task)["source"] = named(body, "F", self.function)
        return notebook

    def with_value(self, body: str) -> Notebook:
        """Return the notebook with the value's answer cell replaced; `V` is the value's name."""
        notebook = self.fresh()
        self.cell(notebook, self.value_task)["source"] = named(body, "V", self.value)
        return notebook

    def with_cell(self, source: str, before: str, role: str = "answer") -> Notebook:
        """Return the notebook with a cell of the learner's own put before a task's cell."""
        notebook = self.fresh()
        place = notebook["cells"].index(self.cell(notebook, before, role))
        notebook["cells"].insert(place, own_cell(named(source, "F", self.function)))
        return notebook


@dataclass(frozen=True)
class Recipe:
    """How to make one submission: see the top of this page."""

    name: str
    kind: str
    make: Callable[[Honest], Notebook | bytes]
    spoils: str = ""
    keeps: str = "all"


# What is right for exercise 3.3: a pose in the plane, turned back first.
RIGHT = """{
        'x': -(math.cos(transform['yaw']) * transform['x'] + math.sin(transform['yaw']) * transform['y']),
        'y': math.sin(transform['yaw']) * transform['x'] - math.cos(transform['yaw']) * transform['y'],
        'yaw': -transform['yaw'],
    }"""


def named(body: str, letter: str, name: str) -> str:
    """Return a recipe's code with the answer's real name in place of its letter, and what is right in place of RIGHT."""
    return re.sub(rf"\b{letter}\b", name, body).replace("RIGHT", RIGHT)


def own_cell(source: str, name: str = "my-own") -> dict[str, Any]:
    """Return a code cell as JupyterLab would add it."""
    return {
        "cell_type": "code", "execution_count": None, "id": name, "metadata": {}, "outputs": [], "source": source,
    }  # fmt: skip


def as_bytes(notebook: Notebook, encoding: str = "utf-8") -> bytes:
    """Return a notebook as a file has it."""
    return json.dumps(notebook, ensure_ascii=False).encode(encoding, "replace" if encoding == "cp949" else "strict")


def function(name: str, kind: str, body: str, keeps: str = "others") -> Recipe:
    """Return an attack that stands where a function should."""
    return Recipe(name, kind, lambda honest: honest.with_function(body), "function", keeps)


def value(name: str, kind: str, body: str, keeps: str = "others") -> Recipe:
    """Return an attack that stands where three numbers should."""
    return Recipe(name, kind, lambda honest: honest.with_value(body), "value", keeps)


def edited(
    name: str, kind: str, edit: Callable[[Notebook, Honest], Any], spoils: str = "", keeps: str = "all"
) -> Recipe:
    """Return a recipe that changes a notebook in place."""

    def make(honest: Honest) -> Notebook:
        notebook = honest.fresh()
        edit(notebook, honest)
        return notebook

    return Recipe(name, kind, make, spoils, keeps)


WRONG = "def F(transform):\n    return None\n"

# -- forging ------------------------------------------------------------------------------

FORGING = [
    function("prints the line of a pass", "forging", WRONG + "print('E3.3 ✓ 6/6')"),
    function("replaces check", "forging", WRONG + "import tflab.workbook\ntflab.workbook.check = check = print"),
    function(
        "replaces the judge",
        "forging",
        WRONG
        + """
import tflab.workbook.answers.form, tflab.workbook.answers.sealed
tflab.workbook.answers.form.Form.judge = lambda *a: [True] * 6
tflab.workbook.answers.sealed.judge = lambda *a: [True] * 6
""",
    ),
    function(
        "replaces numpy's comparisons",
        "forging",
        WRONG
        + """
import numpy, math, builtins
numpy.allclose = numpy.isclose = math.isclose = lambda *a, **k: True
builtins.abs = lambda x: 0
""",
    ),
    function(
        "an object equal to everything",
        "forging",
        """
class Yes:
    def __eq__(self, other): return True
    def __hash__(self): return 0
    def __float__(self): return 7.25
    def __getattr__(self, name): return self
def F(transform):
    return Yes()
""",
    ),
    function(
        "sends probes of its own",
        "forging",
        WRONG
        + """
from IPython.display import display
for identity in ('E3.3', '', 'e3-3-check', None, 1):
    display({'application/vnd.tflab.probe+json': {'id': identity, 'v': [True] * 9}}, raw=True)
""",
    ),
    function(
        "sends every probe twice",
        "forging",
        WRONG
        + """
import IPython.display as d
_display = d.display
def twice(*a, **k):
    _display(*a, **k); _display(*a, **k)
d.display = twice
""",
    ),
    function(
        "says true to every probe",
        "forging",
        WRONG
        + """
import tflab.grading.inside as inside
_send = inside._send
inside._send = lambda identity, plain: _send(identity, [True] * len(plain))
""",
    ),
    function(
        "sends nan, bool and endless numbers",
        "forging",
        """
def F(transform):
    return [float('nan'), True, 10 ** 5000]
""",
    ),
    *(
        function(
            f"sends {depth} lists in one another",
            "forging",
            f"""
import tflab.grading.inside as inside
_send = inside._send
def deep(identity, plain):
    for _ in range({depth}): plain = [plain]
    _send(identity, plain)
inside._send = deep
def F(transform):
    return None
""",
            keeps="any",
        )
        for depth in (150, 400, 900, 3000)
    ),
    function(
        "forges with the kernel's own session",
        "forging",
        WRONG
        + """
kernel = get_ipython().kernel
session, socket = kernel.session, kernel.iopub_socket
for _ in range(20):
    session.send(socket, 'status', {'execution_state': 'idle'}, parent={})
    session.send(socket, 'execute_reply', {'status': 'ok'}, parent={})
    session.send(socket, 'display_data', {'data': {'application/vnd.tflab.probe+json': 3}, 'metadata': {}}, parent={})
""",
        keeps="any",
    ),
    function(
        "sends torn frames",
        "forging",
        WRONG
        + """
kernel = get_ipython().kernel
for frames in ([b'x'], [b'<IDS|MSG>', b'no', b'{', b'', b'', b''], [b''] * 9):
    try: kernel.iopub_socket.send_multipart(frames)
    except Exception: pass
""",
        keeps="any",
    ),
    function(
        "a hook after every cell",
        "forging",
        WRONG
        + """
def after(*a):
    get_ipython().user_ns['check'] = print
    print('✓' * 10)
get_ipython().events.register('post_run_cell', after)
""",
    ),
    function(
        "replaces the shell's run_cell",
        "forging",
        WRONG
        + """
type(get_ipython()).run_cell = lambda *a, **k: None
""",
        keeps="any",
    ),
    function(
        "shadows tflab with a file",
        "forging",
        WRONG
        + """
import os, pathlib
os.makedirs('tflab', exist_ok=True)
pathlib.Path('tflab/__init__.py').write_text('raise SystemExit')
pathlib.Path('sitecustomize.py').write_text('raise SystemExit')
""",
    ),
    function(
        "writes results of its own",
        "forging",
        WRONG
        + """
import pathlib
for name in ('results.json', 'grades.csv', '../results.json', '../../results.json', '/results.json'):
    try: pathlib.Path(name).write_text('{"points": 100}')
    except OSError: pass
""",
    ),
    function("exits as if all were well", "forging", WRONG + "import os\nos._exit(0)"),
    function("raises SystemExit", "forging", WRONG + "raise SystemExit(0)"),
    function(
        "asks the kernel to exit", "forging", WRONG + "get_ipython().kernel.do_shutdown(False); exit()", keeps="any"
    ),
    function("raises from within a call", "forging", "def F(transform):\n    raise SystemExit(0)\n"),
    function(
        "raises KeyboardInterrupt from within a call", "forging", "def F(transform):\n    raise KeyboardInterrupt\n"
    ),
    function(
        "says that it is not answered, loudly",
        "forging",
        "def F(transform):\n    raise NotImplementedError('your turn')",
    ),
    value("a string of the numbers", "forging", "V = '(0.1, 2.0, 0.15)'"),
    value("all truths", "forging", "V = (True, True, True)"),
    value("a function in place of numbers", "forging", "V = lambda *a: (0, 0, 0)"),
    value("infinite numbers", "forging", "V = (float('inf'),) * 3"),
]

# -- peeking ------------------------------------------------------------------------------

FIND_FILES = """
import glob, os, json
found = []
for root in ('/', os.path.expanduser('~'), os.getcwd(), '..', '/tmp', '/root', '/home', '/mnt', '/srv'):
    for pattern in ('pack.json', '*/pack.json', '*/*/pack.json', '*/*/*/pack.json', '*/instructor/*', '*/hidden/*.json'):
        found += glob.glob(os.path.join(root, pattern))
"""
PEEKING = [
    function(
        "the solution that comes with tflab",
        "peeking",
        """
import json
from tflab.workbook.places import workbook_data
cells = []
for path in sorted(workbook_data().glob('solutions/*/03*.ipynb')) + sorted(workbook_data().glob('solutions/src/03*')):
    text = path.read_text()
    cells += [''.join(c['source']) for c in json.loads(text)['cells']] if path.suffix == '.ipynb' else text.split('# %%')
    for cell in cells:
        if 'def F(' in cell:
            exec(cell[cell.index('def F('):])
if not cells: raise FileNotFoundError
""",
    ),
    value(
        "the public cases",
        "peeking",
        """
import json
from tflab.workbook.places import workbook_data
V = (0.0, 0.0, 0.0)
for path in workbook_data().glob('exercises/cases/03*.json'):
    task = json.loads(path.read_text())['tasks']['E3.2']
    V = list(task['variants'][0]['cases'][0]['expected'].values())[0]
""",
    ),
    value(
        "the pack, wherever it may be",
        "peeking",
        FIND_FILES
        + """
V = (0.0, 0.0, 0.0)
for path in found:
    V = list(json.load(open(path))['tasks']['E3.2'].values())[0]
""",
    ),
    value(
        "other processes' memory",
        "peeking",
        """
import os
V = (0.0, 0.0, 0.0)
others = [name for name in os.listdir('/proc') if name.isdigit() and int(name) != os.getpid()]
for name in others:
    for part in ('environ', 'cmdline', 'maps', 'mem'):
        try: open(f'/proc/{name}/{part}', 'rb').read(100)
        except OSError: pass
""",
    ),
    value(
        "the frames that called it",
        "peeking",
        """
import inspect, gc
V = (0.0, 0.0, 0.0)
for frame in inspect.stack():
    if 'expected' in frame.frame.f_locals or 'expected' in frame.frame.f_globals: V = frame.frame.f_locals['expected']
for thing in gc.get_objects():
    if type(thing) is dict and 'expected' in thing and 'twins' in thing:
        V = list(thing['expected'].values())[0]
        break
""",
    ),
    function(
        "traces until it sees the expected",
        "peeking",
        """
import sys
seen = []
def trace(frame, event, arg):
    if 'expected' in frame.f_locals: seen.append(frame.f_locals['expected'])
    return trace
sys.settrace(trace)
def F(transform):
    return seen[-1] if seen else None
""",
    ),
    value(
        "makes the cases itself, with likely seeds",
        "peeking",
        """
V = (0.0, 0.0, 0.0)
from tflab.workbook import cases
from tflab.workbook.places import workbook_data
for seed in ('public', 'secret', '', 'hidden'):
    made = cases.make_cases('03_target_and_source', seed, solutions=workbook_data() / 'solutions')
    V = list(made['tasks']['E3.2']['variants'][0]['cases'][0]['expected'].values())[0]
""",
    ),
    value(
        "asks the network",
        "peeking",
        """
import socket
V = (0.0, 0.0, 0.0)
for address in (('127.0.0.1', 8888), ('1.1.1.1', 53), ('example.com', 80)):
    try: socket.create_connection(address, timeout=0.2); V = 'reached'
    except OSError: pass
""",
    ),
    value(
        "asks the grader's modules",
        "peeking",
        """
V = (0.0, 0.0, 0.0)
import sys, importlib
for name in [n for n in sys.modules if n.startswith('tflab')]:
    for key, thing in list(vars(sys.modules[name]).items()):
        if 'expected' in key.lower() or 'secret' in key.lower() and isinstance(thing, (dict, list, str, bytes)): V = thing
""",
    ),
    value("reads its environment", "peeking", "import os\nV = tuple(os.environ.items())[:3]"),
]

# -- exhaustion ---------------------------------------------------------------------------

EXHAUSTION = [
    function("a loop without end", "exhaustion", "def F(transform):\n    while True: pass\n"),
    value("a loop without end in the cell", "exhaustion", "while True: pass\nV = (0, 0, 0)"),
    function("sleeps for ever", "exhaustion", "import time\ndef F(transform):\n    time.sleep(10**6)\n"),
    function("holds the interpreter", "exhaustion", "def F(transform):\n    return 7 ** 10 ** 8\n"),
    function(
        "a regex without end",
        "exhaustion",
        "import re\ndef F(transform):\n    return re.match('(a+)+$', 'a' * 60 + 'b')\n",
    ),
    value(
        "memory without end",
        "exhaustion",
        "hoard = []\nwhile True: hoard.append(bytearray(50_000_000))\nV = 1",
        keeps="others",
    ),
    value("one huge block", "exhaustion", "V = [0] * 10 ** 11"),
    value(
        "a fork bomb",
        "exhaustion",
        "import os\nwhile True:\n    try: os.fork()\n    except OSError: pass\nV = 1",
        keeps="any",
    ),
    value(
        "threads without end",
        "exhaustion",
        """
import threading, time
V = 1
try:
    while True: threading.Thread(target=time.sleep, args=(600,), daemon=True).start()
except Exception: pass
""",
        keeps="any",
    ),
    value("prints without end", "exhaustion", "while True: print('x' * 1000)\nV = 1"),
    value(
        "drips messages without end",
        "exhaustion",
        "import time\nwhile True:\n    print('.', flush=True); time.sleep(0.05)\nV = 1",
    ),
    value(
        "fills the disk",
        "exhaustion",
        """
V = 1
with open('big', 'wb') as big:
    while True: big.write(bytes(1_000_000))
""",
    ),
    value(
        "opens files without end",
        "exhaustion",
        "V = 1\nkept = []\nwhile True: kept.append(open('/dev/null'))",
        keeps="any",
    ),
    value("a list that holds itself", "exhaustion", "V = [1]\nV.append(V)"),
    value("ten million numbers", "exhaustion", "V = list(range(10 ** 7))"),
    value("an endless generator", "exhaustion", "import itertools\nV = itertools.count()"),
    function("recursion without end", "exhaustion", "def F(transform):\n    return F(transform)\n"),
    function("a crash in C", "exhaustion", "import ctypes\ndef F(transform):\n    ctypes.string_at(0)\n"),
    value("a crash in C in the cell", "exhaustion", "import ctypes\nctypes.string_at(0)\nV = 1"),
    value("stops itself", "exhaustion", "import os, signal\nos.kill(os.getpid(), signal.SIGSTOP)\nV = 1"),
    value(
        "does not listen to signals",
        "exhaustion",
        """
import signal
for number in range(1, 32):
    try: signal.signal(number, signal.SIG_IGN)
    except (OSError, ValueError): pass
while True: pass
V = 1
""",
    ),
    value("waits for the keyboard", "exhaustion", "V = input('how far? ')"),
    value("waits in a debugger", "exhaustion", "breakpoint()\nV = 1", keeps="any"),
]

# -- survival, and what belongs to others ---------------------------------------------------

SURVIVAL = [
    value(
        "a daemon of its own",
        "survival",
        """
import os, sys, time
V = (0, 0, 0)
if os.fork() == 0:
    os.setsid()
    if os.fork() == 0:
        time.sleep(3600)
    os._exit(0)
""",
    ),
    value(
        "a shell that stays",
        "survival",
        """
import subprocess
subprocess.Popen(['sh', '-c', 'nohup setsid sleep 3600 &'], start_new_session=True)
V = (0, 0, 0)
""",
    ),
    value(
        "a thread that stays",
        "survival",
        """
import threading, time
threading.Thread(target=time.sleep, args=(3600,)).start()
V = (0, 0, 0)
""",
    ),
    value(
        "kills its parent and everyone",
        "survival",
        """
import os, signal
V = (0, 0, 0)
for process in (os.getppid(), -1):
    try: os.kill(process, signal.SIGKILL)
    except OSError: pass
""",
        keeps="any",
    ),
    value(
        "kills whatever it can see",
        "survival",
        """
import os
V = (0, 0, 0)
for process in range(2, 40000):
    if process != os.getpid():
        try: os.kill(process, 9)
        except OSError: pass
""",
        keeps="any",
    ),
    value(
        "removes everything",
        "others' files",
        "import subprocess\nsubprocess.run('rm -rf / ~ . .. 2>/dev/null', shell=True)\nV = 1",
        keeps="any",
    ),
    value(
        "overwrites tflab",
        "others' files",
        """
import tflab, pathlib
V = (0, 0, 0)
for path in pathlib.Path(tflab.__file__).parent.rglob('*.py'):
    try: path.write_text('raise SystemExit')
    except OSError: pass
""",
    ),
    value(
        "writes to its neighbours",
        "others' files",
        """
import pathlib
V = (0, 0, 0)
for folder in list(pathlib.Path('..').glob('*')) + [pathlib.Path('/tmp'), pathlib.Path('/dev/shm'), pathlib.Path.home()]:
    try: (folder / 'was-here-tflab').write_text('x')
    except OSError: pass
""",
    ),
    value(
        "leaves a start-up file",
        "others' files",
        """
import pathlib
V = (0, 0, 0)
for name in ('.bashrc', '.ipython/profile_default/startup/x.py', '.local/lib/python3.11/site-packages/usercustomize.py'):
    path = pathlib.Path.home() / name
    try: path.parent.mkdir(parents=True, exist_ok=True); path.write_text('x')
    except OSError: pass
""",
    ),
    value(
        "mounts", "others' files", "import subprocess\nsubprocess.run(['mount', '-t', 'tmpfs', 'none', '/usr'])\nV = 1"
    ),
]

# -- tampering with the notebook --------------------------------------------------------------


def _all_points(notebook: Notebook, honest: Honest) -> None:
    for cell in notebook["cells"]:
        cell["metadata"].setdefault("nbgrader", {})["points"] = 1000


def _forged_outputs(notebook: Notebook, honest: Honest) -> None:
    honest.cell(notebook, honest.function_task)["source"] = named(WRONG, "F", honest.function)
    check = honest.cell(notebook, honest.function_task, "check")
    check["outputs"] = [{"name": "stdout", "output_type": "stream", "text": f"{honest.function_task} ✓ 6/6\n"}]


def _changed_check(notebook: Notebook, honest: Honest) -> None:
    honest.cell(notebook, honest.function_task)["source"] = named(WRONG, "F", honest.function)
    honest.cell(notebook, honest.function_task, "check")["source"] = f"print('{honest.function_task} ✓ 6/6')"


def _changed_given(notebook: Notebook, honest: Honest) -> None:
    name = honest.value_task.lower().replace(".", "_")
    honest.cell(notebook, honest.value_task, "given")["source"] = (
        f"from types import SimpleNamespace\n{name} = SimpleNamespace(easy={{'base_link': (1.0, 2.0, 3.0), 'map': (3.0, 2.0, 1.0)}})"
    )
    honest.cell(notebook, honest.value_task)["source"] = f"{honest.value} = {name}.easy"


def _two_different(notebook: Notebook, honest: Honest) -> None:
    second = copy.deepcopy(honest.cell(notebook, honest.function_task))
    second["source"] = named(WRONG, "F", honest.function)
    notebook["cells"].append(second)


def _wrong_places(notebook: Notebook, honest: Honest) -> None:
    cell = honest.cell(notebook, honest.value_task)
    cell["source"] = honest.cell(notebook, honest.function_task)["source"]


def _stub(notebook: Notebook, honest: Honest) -> None:
    honest.cell(notebook, honest.value_task)["source"] = f"{honest.value} = ..."


TAMPERING = [
    edited("a thousand points for each cell", "tampering", _all_points),
    edited("outputs that say passed", "tampering", _forged_outputs, "function", "others"),
    edited("a check that always passes", "tampering", _changed_check, "function", "others"),
    edited("a given that suits the answer", "tampering", _changed_given, "value", "others"),
    edited("two different cells of one name", "tampering", _two_different, "function", "others"),
    edited("one answer in another's place", "tampering", _wrong_places, "value", "others"),
    edited("an answer left out", "tampering", _stub, "value", "others"),
    edited(
        "a stamp of another learner",
        "tampering",
        lambda n, h: n["metadata"].setdefault("tflab", {}).update(learner="somebody"),
    ),
    edited(
        "checks removed",
        "tampering",
        lambda n, h: n.update(cells=[c for c in n["cells"] if not c["id"].endswith("-check")]),
    ),
    edited(
        "givens removed",
        "tampering",
        lambda n, h: n.update(cells=[c for c in n["cells"] if not c["id"].endswith("-given")]),
    ),
    edited(
        "a check of a task that does not exist",
        "tampering",
        lambda n, h: n["cells"].append(own_cell('check("E3.99", 1)')),
    ),
]

# -- broken, old, foreign ------------------------------------------------------------------


def _third_format(notebook: Notebook) -> Notebook:
    cells = []
    for cell in notebook["cells"]:
        old = {"cell_type": cell["cell_type"], "metadata": {**cell["metadata"], "name": cell["id"]}}
        text = cell["source"] if isinstance(cell["source"], str) else "".join(cell["source"])
        old |= {"input": text, "language": "python", "outputs": []} if cell["cell_type"] == "code" else {"source": text}
        cells.append(old)
    return {
        "metadata": {"name": ""},
        "nbformat": 3,
        "nbformat_minor": 0,
        "worksheets": [{"cells": cells, "metadata": {}}],
    }


def _without_ids(notebook: Notebook, honest: Honest) -> None:
    for cell in notebook["cells"]:
        del cell["id"]
    notebook["nbformat_minor"] = 4


def _lists(notebook: Notebook, honest: Honest) -> None:
    for cell in notebook["cells"]:
        text = cell["source"] if isinstance(cell["source"], str) else "".join(cell["source"])
        cell["source"] = text.splitlines(keepends=True)


def _broken_metadata(notebook: Notebook, honest: Honest) -> None:
    notebook["metadata"] = []
    notebook["cells"][0]["metadata"] = "none"
    notebook["cells"].insert(1, {"cell_type": 3})
    notebook["cells"].insert(2, None)


def _comment(notebook: Notebook, honest: Honest, text: str) -> None:
    cell = honest.cell(notebook, honest.function_task)
    cell["source"] = f"# {text}\n" + "".join(cell["source"])


def _in_korean(honest: Honest) -> Notebook:
    notebook = honest.fresh()
    _comment(notebook, honest, "역변환을 구합니다")
    return notebook


def raw(name: str, kind: str, make: Callable[[Honest], bytes], keeps: str = "none") -> Recipe:
    """Return a recipe of bytes."""
    return Recipe(name, kind, make, "", keeps)


BROKEN = [
    raw("an empty file", "broken", lambda h: b""),
    raw("half a file", "broken", lambda h: as_bytes(h.notebook)[:400]),
    raw("a picture", "broken", lambda h: b"\x89PNG\r\n\x1a\n" + bytes(range(256))),
    raw("a list", "broken", lambda h: b"[]"),
    raw("JSON of no notebook", "broken", lambda h: b'{"cells": {"a": 1}, "nbformat": 4}'),
    raw("a hundred thousand brackets", "broken", lambda h: b"[" * 100_000),
    raw("a number of a million digits", "broken", lambda h: b'{"nbformat": ' + b"9" * 1_000_000 + b"}"),
    raw("a web page", "broken", lambda h: b"<!DOCTYPE html><html><body>Please log in</body></html>"),
    raw("far too large", "broken", lambda h: as_bytes(h.notebook) + b" " * 40_000_000),
    raw("a byte order mark", "encoding", lambda h: b"\xef\xbb\xbf" + as_bytes(h.notebook), "all"),
    raw("UTF-16", "encoding", lambda h: as_bytes(h.notebook, "utf-16"), "all"),
    raw("code page 949", "encoding", lambda h: as_bytes(_in_korean(h), "cp949"), "all"),
    raw(
        "Windows line ends",
        "encoding",
        lambda h: json.dumps(h.notebook, indent=1).replace("\n", "\r\n").encode(),
        "all",
    ),
    raw("blanks before and after", "encoding", lambda h: b"\n\n  " + as_bytes(h.notebook) + b"\n\n", "all"),
    raw("escaped letters", "encoding", lambda h: json.dumps(_in_korean(h), ensure_ascii=True).encode(), "all"),
    Recipe("the third format", "old format", lambda h: _third_format(h.fresh())),
    edited("cells without ids", "old format", _without_ids),
    edited("sources as lists of lines", "old format", _lists),
    edited("metadata of the wrong type", "broken", _broken_metadata),
    edited(
        "a kernel for Julia",
        "old format",
        lambda n, h: n["metadata"].update(kernelspec={"name": "julia-1.10", "language": "julia"}),
    ),
    edited("no kernel at all", "old format", lambda n, h: n["metadata"].pop("kernelspec", None)),
    edited("a letter that is half a pair", "encoding", lambda n, h: n["cells"].append(own_cell("# \ud800")) and None),
    edited("a NUL in a comment of its own", "encoding", lambda n, h: n["cells"].append(own_cell("# \x00"))),
]

# -- helper cells, and odd but right -----------------------------------------------------------


def _own_helper(honest: Honest) -> Notebook:
    notebook = honest.with_cell("def my_inverse(transform):\n    return (RIGHT)", honest.function_task)
    honest.cell(notebook, honest.function_task)["source"] = (
        f"def {honest.function}(transform):\n    return my_inverse(transform)"
    )
    return notebook


def _answer_in_the_next_cell(honest: Honest) -> Notebook:
    notebook = honest.fresh()
    cell = honest.cell(notebook, honest.function_task)
    answer, cell["source"] = cell["source"], "# see below"
    notebook["cells"].insert(notebook["cells"].index(cell) + 1, own_cell(answer))
    return notebook


def right(name: str, body: str, kind: str = "odd but right") -> Recipe:
    """Return a right answer, oddly written, where a function should stand."""
    return Recipe(name, kind, lambda honest: honest.with_function(body))


ODD = [
    Recipe("a helper in a cell of its own", "helper cells", _own_helper),
    Recipe("the answer in the next cell", "helper cells", _answer_in_the_next_cell),
    Recipe("an import at the top", "helper cells", lambda h: h.with_cell("import itertools, collections", h.value_task)),
    Recipe("a helper that fails", "helper cells", lambda h: h.with_cell("this_name_is_unknown", h.function_task)),
    Recipe("a helper that does not parse", "helper cells", lambda h: h.with_cell("def (", h.function_task)),
    Recipe("installs something", "helper cells", lambda h: h.with_cell("!pip install nothing-of-that-name", h.value_task)),
    Recipe("times itself", "helper cells", lambda h: h.with_cell("%timeit -n1 -r1 sum(range(10))", h.value_task)),
    Recipe("a plot", "helper cells", lambda h: h.with_cell("import matplotlib.pyplot as plt\nplt.plot([1, 2]); plt.show()", h.function_task)),
    Recipe("a shell command", "helper cells", lambda h: h.with_cell("!echo hello", h.value_task)),
    Recipe("another cell magic", "helper cells", lambda h: h.with_cell("%%bash\necho hello", h.value_task)),
    right("prints a lot", "def F(transform):\n    print('thinking ' * 20000)\n    return RIGHT"),
    right("warns", "import warnings\ndef F(transform):\n    warnings.warn('careful')\n    return RIGHT"),
    right("writes to stderr", "import sys\ndef F(transform):\n    print('careful', file=sys.stderr)\n    return RIGHT"),
    right("returns numbers of NumPy", """
import numpy as np
def F(transform):
    return {name: np.float64(number) for name, number in (RIGHT).items()}
"""),
    right("returns arrays without dimensions", """
import numpy as np
def F(transform):
    return {name: np.array(number) for name, number in (RIGHT).items()}
"""),
    right("a whole turn more", """
def F(transform):
    back = RIGHT
    back['yaw'] += 2 * math.pi
    return back
"""),
    right("something besides", "def F(transform):\n    return {**RIGHT, 'note': 'turned back first'}"),
    right("another kind of dict", "import collections\ndef F(transform):\n    return collections.OrderedDict(RIGHT)"),
    right("a class that can be called", """
class Inverter:
    def __call__(self, transform):
        return RIGHT
F = Inverter()
"""),
    right("a partial function", "import functools\ndef _f(power, transform):\n    return RIGHT\nF = functools.partial(_f, -1)"),
    right("remembers earlier calls", """
seen = {}
def F(transform):
    key = tuple(transform.values())
    return seen.setdefault(key, RIGHT)
"""),
    right("changes its argument", "def F(transform):\n    transform.update(RIGHT)\n    return transform"),
    right("defines itself twice", "def F(transform):\n    return None\ndef F(transform):\n    return RIGHT"),
    right("annotated to the teeth", "def F(transform: 'Transform') -> 'Transform':\n    '''Return the inverse.'''\n    return RIGHT"),
    right("a generator inside", "def F(transform):\n    return next(RIGHT for transform in [transform])"),
    right("plots as it works", """
import matplotlib.pyplot as plt
def F(transform):
    plt.figure(); plt.plot([0, 1]); plt.close()
    return RIGHT
"""),
    right("calls check itself", "def F(transform):\n    return RIGHT\nfrom tflab.workbook import check\ncheck('E3.3', F)"),
    right("waits a little", "import time\ndef F(transform):\n    time.sleep(0.02)\n    return RIGHT"),
    right("uses a thread", """
from concurrent.futures import ThreadPoolExecutor
def F(transform):
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(lambda: RIGHT).result()
"""),
]  # fmt: skip

# -- closer to the wall: what the libraries above do not try ------------------------------------

WIRE = (
    WRONG
    + """
import json, struct
wire = get_ipython().kernel.session.wire
parent = get_ipython().kernel.get_parent()['header']['msg_id']
PROBE = 'application/vnd.tflab.probe+json'
def raw(body):
    wire.end.setblocking(True)
    wire.end.sendall(struct.pack('!I', len(body)) + body)
def say(kind, content, to=parent):
    raw(json.dumps({'channel': 'iopub', 'msg_type': kind, 'parent_header': {'msg_id': to}, 'content': content}).encode())
"""
)
CLOSER = [
    function("an error of a name nested deep", "forging", WIRE + "raw(b'{\"channel\": \"iopub\", \"msg_type\": \"error\", \"parent_header\": {\"msg_id\": \"' + parent.encode() + b'\"}, \"content\": {\"ename\": ' + b'[' * 900 + b']' * 900 + b', \"evalue\": 1}}')", keeps="any"),
    function("a frame of four gigabytes, announced", "forging", WIRE + "wire.end.setblocking(True); wire.end.sendall(b'\\xff\\xff\\xff\\xff' + b'x' * 100)", keeps="any"),
    function("half a frame, and then nothing", "forging", WIRE + "wire.end.setblocking(True); wire.end.sendall(b'\\0\\0\\x10\\0{'); import time; time.sleep(600)"),
    function("frames that are no JSON", "forging", WIRE + "for body in (b'\\xff\\xfe', b'NaN', b'[]', b'1' * 9000, b'', b'{\"a\":' * 5000): raw(body)", keeps="any"),
    function("says ready, done and idle before its time", "forging", WIRE + "raw(json.dumps({'ready': True, 'fault': 'x'}).encode())\nfor to in (parent, None, [], {}, 3): say('status', {'execution_state': 'idle'}, to)", keeps="any"),
    function("messages of every wrong shape", "forging", WIRE + """
for content in (None, [], 3, {'data': None}, {'data': {PROBE: None}}, {'data': {PROBE: {'id': [], 'v': {}}}}, {'execution_state': []}):
    for kind in ('display_data', 'status', 'error', 'execute_result', 'stream', None, 3):
        say(kind, content)
""", keeps="any"),
    function("answers for its probe with every shape there is", "forging", """
import tflab.grading.inside as inside
_send, _shapes = inside._send, iter([
    [None] * 7, [{}] * 7, [[]] * 7, [{'dict': None}] * 7, [{'dict': {'x': {'tuple': [[]]}}}] * 7, [{'raises': {}}] * 7,
    [{'object': []}] * 7, [{'message': [[], {}]}] * 7, [{'dict': {'x': 1e999, 'y': {'float': 'nan'}, 'yaw': True}}] * 7,
    {'v': 1}, 'text', 7, [{'array': [[1, 2], 3]}] * 7, [{'unanswered': True}] * 7, [{'dict': []}] * 7])
def send(identity, plain):
    _send(identity, next(_shapes, None) if len(plain) == 7 else plain)
inside._send = send
def F(transform):
    return None
""", keeps="any"),
    function("takes the next request off the wire", "forging", WIRE + """
import threading
def steal():
    while True:
        got = wire.receive(0.05)
        if got: say('status', {'execution_state': 'idle'}, got['msg_id'])
threading.Thread(target=steal, daemon=True).start()
""", keeps="any"),
    function("numbers that equal whatever they are compared with", "forging", """
class Number(float):
    def __eq__(self, other): return True
    def __sub__(self, other): return 0.0
    __rsub__ = __sub__
    def __abs__(self): return 0.0
    def __float__(self): return 7.25
class Answer(dict):
    def __getitem__(self, name): return Number()
    def get(self, name, default=None): return Number()
    def items(self): return [('x', Number()), ('y', Number()), ('yaw', Number())]
def F(transform):
    return Answer(x=Number(), y=Number(), yaw=Number())
"""),
    function("another answer each time it is read", "forging", """
import random
class Turning(dict):
    def items(self): return {k: random.uniform(-9, 9) for k in ('x', 'y', 'yaw')}.items()
def F(transform):
    return Turning(x=5, y=5, yaw=1)
"""),
    function("an error whose name says what was asked", "forging", """
def F(transform):
    raise type('asked_' + repr(sorted(transform.items())), (Exception,), {})(repr(transform))
"""),
    function("a result of a class named by what was asked", "forging", """
def F(transform):
    return type('asked_' + repr(sorted(transform.items())), (), {})()
"""),
    function("every part of the answer named by what was asked", "forging", "def F(transform):\n    return {repr(transform): 1.0, 'x': repr(transform), 'y': transform, 'yaw': [transform]}"),
    function("reads every file for its own solution", "peeking", """
import os
found = []
for top, folders, files in os.walk('/'):
    if top.startswith(('/proc', '/sys')): folders.clear(); continue
    if 'tflab' not in top and 'workbook' not in top and 'solutions' not in top: continue
    for name in files:
        if name.endswith(('.py', '.pyc', '.ipynb', '.json')):
            try: text = open(os.path.join(top, name), 'rb').read()
            except OSError: continue
            if b'def F(' in text and b'return' in text and b'E3.3' in text: found.append(text)
            if b'"E3.3"' in text and b'"expected"' in text: found.append(text)
def F(transform):
    return RIGHT if found else None
"""),
    function("imports the solution by any name", "peeking", """
import importlib, sys
from tflab.workbook.places import workbook_data
sys.path[:0] = [str(workbook_data()), str(workbook_data() / 'solutions/tasks'), str(workbook_data() / 'solutions/src')]
solution = None
for name in ('03_target_and_source', 'solutions.tasks.03_target_and_source', 'tflab._workbook.solutions', 'solutions'):
    try: solution = importlib.import_module(name)
    except Exception: pass
def F(transform):
    return RIGHT if solution else None
"""),
    function("asks the reference module for the answer", "peeking", """
from tflab.workbook import cases, reference
from tflab.workbook.places import workbook_data
made = None
try: made = cases.make_cases('03_target_and_source', cases.PUBLIC_SEED, solutions=workbook_data() / 'solutions')
except Exception: pass
def F(transform):
    return RIGHT if made else None
"""),
    function("asks check whether it is right, many times", "peeking", """
import io, contextlib
from tflab.workbook.checks import check as really
told = io.StringIO()
with contextlib.redirect_stdout(told):
    try: really('E3.3', lambda transform: None)
    except Exception: pass
def F(transform):
    return RIGHT if '/' in told.getvalue() and 'E3.3' in told.getvalue() and '0/' not in told.getvalue() and 'no ' not in told.getvalue() else None
"""),
    function("every descriptor it was left", "peeking", """
import os, socket
wire = get_ipython().kernel.session.wire.fileno()
others = [int(n) for n in os.listdir('/proc/self/fd') if int(n) > 2 and int(n) != wire]
extra = []
for n in others:
    try:
        if 'socket' in os.readlink(f'/proc/self/fd/{n}'): socket.socket(fileno=os.dup(n)).getpeername(); extra.append(n)
    except OSError: pass
def F(transform):
    return None
"""),
    function("the other side of the wall through /proc", "peeking", """
import os
seen = []
for n in list(range(1, 400)) + ['self', 'thread-self']:
    for way in ('root', 'cwd', 'exe', 'fd/3', 'map_files'):
        try: path = os.readlink(f'/proc/{n}/{way}'); seen += [f for f in ('etc/shadow', 'etc/fstab', 'boot') if os.path.exists(f'/proc/{n}/root/{f}')]
        except OSError: pass
def F(transform):
    return RIGHT if seen else None
"""),
    function("namespaces, setuid programs and device files", "peeking", """
import ctypes, os, subprocess
libc = ctypes.CDLL(None, use_errno=True)
won = [libc.unshare(flag) for flag in (0x10000000, 0x20000, 0x20000000, 0x40000000)].count(0)
for program in (['unshare', '-Ur', 'id'], ['su', '-c', 'id'], ['sudo', '-n', 'id'], ['mount', '--bind', '/', '/tmp'], ['nsenter', '-t', '1', '-m', 'ls'], ['pkexec', 'id']):
    try: won += subprocess.run(program, capture_output=True, timeout=1, stdin=subprocess.DEVNULL).returncode == 0
    except (OSError, subprocess.SubprocessError): pass
for make in (lambda: os.mknod('d', 0o060666, os.makedev(8, 0)), lambda: os.setuid(0), lambda: os.chroot('/'), lambda: os.open('/dev/mem', 0)):
    try: make(); won += 1
    except OSError: pass
def F(transform):
    return RIGHT if won else None
"""),
    function("system calls that make room for others", "peeking", """
import ctypes
libc = ctypes.CDLL(None, use_errno=True)
libc.syscall.restype = ctypes.c_long
won = [n for n in (101, 155, 165, 250, 248, 249, 272, 278, 298, 304, 308, 310, 311, 319, 321, 323, 425, 428, 430, 435, 438, 447) if libc.syscall(n, 0, 0, 0, 0, 0) >= 0]
def F(transform):
    return RIGHT if won else None
"""),
    function("names of sockets that are in no folder", "peeking", """
import socket
names = [line.split()[-1] for line in open('/proc/net/unix') if '@' in line]
won = []
for name in names:
    try: s = socket.socket(socket.AF_UNIX); s.connect('\\0' + name[1:]); won.append(s)
    except OSError: pass
def F(transform):
    return RIGHT if won else None
"""),
    function("memory that forks share", "exhaustion", """
import mmap, os, time
for _ in range(20):
    if os.fork() == 0:
        m = mmap.mmap(-1, 200 << 20)
        for at in range(0, len(m), 4096): m[at] = 1
        time.sleep(600)
time.sleep(600)
"""),
    function("a zero device, mapped and let go of", "exhaustion", """
import mmap, os, time
device = os.open('/dev/zero', os.O_RDWR)
while True:
    m = mmap.mmap(device, 64 << 20, mmap.MAP_SHARED)
    m.write(b'x' * len(m))
"""),
    function("full buffers of sockets", "exhaustion", """
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
    function("sixty processes of three hundred megabytes", "exhaustion", "import os, time\nfor _ in range(60):\n    if os.fork() == 0:\n        x = b'x' * (300 << 20); time.sleep(600)\ntime.sleep(600)"),
    function("full pipes", "exhaustion", """
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
    function("files without number", "exhaustion", WRONG + "import os\ntry:\n    for n in range(10 ** 5): open(f'/tmp/f{n}', 'w').close()\nexcept OSError: pass"),
    function("folders without end", "exhaustion", WRONG + "import os\ntry:\n    for n in range(4000): os.mkdir('d'); os.chdir('d')\nexcept OSError: pass"),
    function("widgets and comms without end", "exhaustion", "import ipywidgets\nwhile True: ipywidgets.IntSlider()\n"),
    function("a flood of errors", "exhaustion", WIRE + "while True: say('error', {'ename': 'x' * 1000, 'evalue': 'y' * 1000})"),
    function("a flood of probes", "exhaustion", "from IPython.display import display\nwhile True: display({'application/vnd.tflab.probe+json': {'id': '', 'v': [0] * 1000}}, raw=True)\n"),
    function("an object that never ends being written", "exhaustion", """
class Endless(dict):
    def items(self):
        while True: yield ('x', 1.0)
    def keys(self): return iter(lambda: 'x', None)
    def __len__(self): return 3
def F(transform):
    return Endless(x=1)
"""),
    function("a task of the loop that stays", "survival", "import asyncio\nasync def stay():\n    while True: await asyncio.sleep(0)\nasyncio.get_event_loop().create_task(stay())\n" + WRONG, keeps="any"),
    function("a handler at exit, and one after every fork", "survival", "import atexit, os, time\natexit.register(time.sleep, 600)\nos.register_at_fork(after_in_child=lambda: time.sleep(600))\n" + WRONG),
    function("a hundred forks that answer too", "survival", "import os\nfor _ in range(5): os.fork()\n" + WRONG, keeps="any"),
    function("a daemon that listens", "survival", WRONG + "import os, socket, time\nif os.fork() == 0:\n    os.setsid()\n    s = socket.socket(socket.AF_UNIX); s.bind('\\0tflab-daemon'); s.listen(); time.sleep(600)"),
    edited("a name that leads out", "tampering", lambda n, h: [c["metadata"].update(name="../../" + c["id"]) for c in n["cells"]]),
    edited("a stamp of code", "tampering", lambda n, h: n["metadata"].setdefault("tflab", {}).update(learner="<script>alert(1)</script>", release="{0.__class__}", chapter="../../etc")),
    edited("an id that is a list", "tampering", lambda n, h: n["cells"].append({"id": ["e3-3-answer"], "cell_type": "code", "metadata": {"name": ["e3-3-answer"]}, "source": "1/0"})),
    edited("a thousand cells of its own", "tampering", lambda n, h: n["cells"].extend(own_cell(f"x{i} = {i}", f"own{i}") for i in range(1000))),
]  # fmt: skip


def _last_cell(notebook: Notebook, honest: Honest) -> None:
    """Move all answers to one cell at the end, and leave nothing where they stood."""
    answers = [cell for cell in notebook["cells"] if cell["id"].endswith("-answer")]
    notebook["cells"].append(own_cell("\n\n".join("".join(cell["source"]) for cell in answers), "all-in-one"))
    for cell in answers:
        cell["source"] = "# at the end"


def _as_colab(notebook: Notebook, honest: Honest) -> None:
    notebook["nbformat_minor"] = 0
    notebook["metadata"] = {"colab": {"provenance": []}, "kernelspec": {"name": "python3", "display_name": "Python 3"}}
    for number, cell in enumerate(notebook["cells"]):
        cell.pop("id", None)
        cell["metadata"] = {"id": f"aB{number}"}


def _as_vs_code(notebook: Notebook, honest: Honest) -> None:
    for number, cell in enumerate(notebook["cells"]):
        cell["id"] = f"{number:08x}"
        cell["metadata"] = {"vscode": {"languageId": "python"}}


ODD += [
    edited("all answers in one cell at the end", "helper cells", _last_cell),
    edited("saved by Colab", "old format", _as_colab),
    edited("saved by VS Code", "old format", _as_vs_code),
    edited("nothing but answers", "helper cells", lambda n, h: n.update(cells=[c for c in n["cells"] if c["id"].endswith("-answer")])),
    edited("the other way round", "helper cells", lambda n, h: n["cells"].reverse()),
    edited("a magic above every answer", "odd but right", lambda n, h: [c.update(source="%%time\n" + "".join(c["source"])) for c in n["cells"] if c["id"].endswith("-answer")]),
    right("starts processes, and waits for them", "import subprocess, sys\ndef F(transform):\n    subprocess.run([sys.executable, '-c', 'pass'], check=True)\n    return RIGHT"),
    right("writes files and reads them", "import json, tempfile, pathlib\ndef F(transform):\n    path = pathlib.Path(tempfile.mkdtemp()) / 'x.json'\n    path.write_text(json.dumps(RIGHT))\n    return json.loads(path.read_text())"),
    right("a pool of processes", "from multiprocessing import get_context\ndef one(n): return n\ndef F(transform):\n    with get_context('fork').Pool(2) as pool:\n        assert pool.map(one, [1, 2]) == [1, 2]\n    return RIGHT"),
]  # fmt: skip

# -- what a second look brought --------------------------------------------------------------


def answered(name: str, kind: str, task: str, body: str) -> Recipe:
    """Return a right answer to another task, oddly written."""

    def make(honest: Honest) -> Notebook:
        notebook = honest.fresh()
        honest.cell(notebook, task)["source"] = body
        return notebook

    return Recipe(name, kind, make)


def merged(*names: str, into: str) -> Callable[[Notebook, Honest], None]:
    """Return an edit that merges cells into one of them, as editors do: what it was called stays."""

    def edit(notebook: Notebook, honest: Honest) -> None:
        wanted = [cell for cell in notebook["cells"] if cell["id"] in names or (not names and is_code(cell))]
        kept = next(cell for cell in wanted if cell["id"] == into)
        kept["source"] = "\n\n".join("".join(cell["source"]) for cell in wanted)
        notebook["cells"] = [cell for cell in notebook["cells"] if cell is kept or cell not in wanted]

    return edit


def is_code(cell: dict[str, Any]) -> bool:
    return cell["cell_type"] == "code"


def copied(text: str, behind: str) -> Callable[[Notebook, Honest], None]:
    """Return an edit that copies the function's answer cell to try something in: a copy keeps its name."""

    def edit(notebook: Notebook, honest: Honest) -> None:
        copy_of = copy.deepcopy(honest.cell(notebook, honest.function_task))
        copy_of |= {"id": "copied", "source": named(text, "F", honest.function)}
        place = next(number for number, cell in enumerate(notebook["cells"]) if cell["id"] == behind)
        notebook["cells"].insert(place + 1, copy_of)

    return edit


def _split(notebook: Notebook, honest: Honest) -> None:
    """Split an answer, and try something between the halves."""
    cell = honest.cell(notebook, "E3.5")
    lines = "".join(cell["source"]).splitlines(keepends=True)
    cell["source"], rest = "".join(lines[:2]), copy.deepcopy(cell) | {"id": "half", "source": "".join(lines[2:])}
    place = notebook["cells"].index(cell) + 1
    notebook["cells"][place:place] = [own_cell("print(x, y, z)"), rest]


def _in_two_answers(text: str) -> Callable[[Notebook, Honest], None]:
    """Return an edit that makes the grader itself parse a text."""

    def edit(notebook: Notebook, honest: Honest) -> None:
        cell = honest.cell(notebook, honest.function_task)
        cell["source"] = text
        notebook["cells"] += [copy.deepcopy(cell) | {"id": "two", "source": text + "\n#"}, own_cell(text)]

    return edit


MOVED = "p = e3_2.base_T_laser.apply(e3_2.laser_p_corner)\nm = e3_2.map_T_base.apply(p)\n"
WRITE = "import os, struct\nwire = get_ipython().kernel.session.wire.fileno()\n"
BOMBS = {"members of members": "x" + ".a" * 90_000, "a long sum": "+".join("1" * 90_000), "signs": "-" * 150_000 + "1",
         "brackets": "(" * 90_000 + ")" * 90_000, "lambdas": "lambda:" * 25_000 + "0"}  # fmt: skip

AGAIN = [
    function("a class that lies about its class", "forging", """
import itertools
class Liar:
    __class__ = Transform
    translation = rotation = itertools.count()
def F(transform):
    return Liar()
"""),
    function("a class that ends Python when it is asked what it is", "forging", """
class Liar:
    @property
    def __class__(self): raise SystemExit
def F(transform):
    return Liar()
"""),
    function("an array whose list lies", "forging", """
import numpy as np
class Liar(np.ndarray):
    def tolist(self): return type('Yes', (float,), {'__eq__': lambda *a: True, '__sub__': lambda *a: 0.0})()
def F(transform):
    return {name: np.zeros(3).view(Liar) for name in ('x', 'y', 'yaw')}
"""),
    function("an error that ends Python when it is read", "forging", """
class Liar(Exception):
    def __str__(self): raise SystemExit
    __repr__ = __str__
def F(transform):
    raise Liar
"""),
    function("a mock that is everything", "forging", "from unittest.mock import MagicMock\nF = MagicMock()"),
    function("every module forgotten", "forging", WRONG + "import sys\nsys.modules.clear()"),
    function("builtins deleted", "forging", WRONG + "import builtins\nfor n in ('print', 'len', 'isinstance', 'type', '__import__'): delattr(builtins, n)"),
    function("an audit hook that ends Python", "forging", WRONG + "import os, sys\nsys.addaudithook(lambda event, args: os._exit(3) if event == 'compile' else None)"),
    function("a transformer that makes every call 1", "forging", WRONG + "import ast\nclass One(ast.NodeTransformer):\n    def visit_Call(self, node): return ast.Constant(1)\nget_ipython().ast_transformers.append(One())"),
    function("a probe that asks its neighbour", "forging", WRONG + "import tflab.grading.kernels.probe as inside\n_p = inside.probe\ninside.probe = lambda identity, answer, args: _p(identity, lambda: compose, args)"),
    function("nothing and no one published", "forging", WRONG + "get_ipython().display_pub.publish = lambda *a, **k: None"),
    function("every descriptor closed", "forging", WRONG + "import os\nos.closerange(0, 256)"),
    function("half a frame on the wire", "forging", WRONG + WRITE + "os.write(wire, b'\\0\\0\\0\\xff{')"),
    function("a frame of brackets on the wire", "forging", WRONG + WRITE + "os.write(wire, struct.pack('!I', 100000) + b'[' * 100000)"),
    function("every task of the loop cancelled", "forging", WRONG + "import asyncio\nfor task in asyncio.all_tasks(): task.cancel()"),
    function("limits of its own: nothing", "exhaustion", WRONG + "import resource as r\nfor what in (r.RLIMIT_NOFILE, r.RLIMIT_AS, r.RLIMIT_FSIZE, r.RLIMIT_NPROC): r.setrlimit(what, (0, 0))"),
    function("a finalizer that sleeps", "survival", WRONG + "import time\nclass Last:\n    def __del__(self): time.sleep(600)\nLast()"),
    function("hangs at its second call", "exhaustion", "n = 0\ndef F(transform):\n    global n\n    n += 1\n    while n > 1: pass"),
    function("memory searched for the reference", "peeking", WRONG + """
import re
with open('/proc/self/mem', 'rb', 0) as memory:
    for line in open('/proc/self/maps').readlines():
        if ' rw-p' in line:
            first, last = (int(number, 16) for number in line.split()[0].split('-'))
            try: memory.seek(first); held = memory.read(last - first)
            except (OSError, ValueError): continue
            if re.search(b'by_its[_]looks|against_the[_]arrow', held):  # which does not find itself
                F = lambda transform: RIGHT
"""),
    value("waits for what never comes", "exhaustion", "import asyncio\nawait asyncio.Event().wait()\nV = 1"),
    value("a command that stays in the background", "survival", "!nohup sleep 1000 &\nV = 1"),
    value("halves of letters", "encoding", "V = {'base_link': '\\ud800', 'map': '\\udfff', '\\ud800': 1}"),
    edited("given and answer merged", "helper cells", merged("e3-2-given", "e3-2-answer", into="e3-2-given")),
    edited("given, answer and check merged", "helper cells", merged("e3-2-given", "e3-2-answer", "e3-2-check", into="e3-2-given")),
    edited("answer and check merged", "helper cells", merged("e3-3-answer", "e3-3-check", into="e3-3-check")),
    edited("two answers merged", "helper cells", merged("e3-3-answer", "e3-3-check", "e3-4-answer", into="e3-3-answer")),
    edited("everything merged into the first cell", "helper cells", merged(into="load")),
    edited("everything merged into the last cell", "helper cells", merged(into="e3-7-check")),
    edited("a copy to try something in", "helper cells", copied("print(F({'x': 1, 'y': 2, 'yaw': 0.5}))", "e3-3-check")),
    edited("a copy that is a note", "helper cells", copied("# def F(transform): ...", "e3-5-check")),
    edited("a copy above that fails", "helper cells", copied("F(1, 2, 3)", "imports")),
    edited("an answer in two halves with a print between", "helper cells", _split),
    *(edited(f"the grader parses {name}", "exhaustion", _in_two_answers(text), "function", "others") for name, text in BOMBS.items()),
    Recipe("closes what it prints to", "helper cells", lambda h: h.with_cell("import sys\nsys.stdout.close()", "E3.1")),
    Recipe("has no place for errors", "helper cells", lambda h: h.with_cell("import sys\nsys.stderr = None", "E3.1")),
    Recipe("a shell in a shell", "helper cells", lambda h: h.with_cell("import IPython\nIPython.embed()", "E3.1")),
    Recipe("names of builtins taken", "helper cells", lambda h: h.with_cell("list = [1]\nstr = 'x'\nprint = None\nlen = 3\ndict = {}\ntype = 0", "E3.1")),
    Recipe("calls without brackets", "helper cells", lambda h: h.with_cell("%autocall 2", "E3.1")),
    Recipe("a debugger at every error", "helper cells", lambda h: h.with_cell("%pdb on\n1 / 0", "E3.1")),
    Recipe("undone at the end", "helper cells", lambda h: h.with_cell("del calls, corner, F, compose", "E3.7", "check")),
    right("a dataclass", "from dataclasses import dataclass\n@dataclass(frozen=True, slots=True)\nclass Place:\n    x: float\n    y: float\n    yaw: float\ndef F(transform):\n    return Place(**RIGHT)"),
    right("keys that are an Enum of texts", "import enum\nclass Key(str, enum.Enum):\n    X = 'x'\n    Y = 'y'\n    YAW = 'yaw'\ndef F(transform):\n    return {key: RIGHT[key.value] for key in Key}"),
    right("vectorized", "import numpy as np\n@np.vectorize\ndef F(transform):\n    return RIGHT"),
    right("arrays of objects", "import numpy as np\ndef F(transform):\n    return {name: np.array(number, dtype=object) for name, number in (RIGHT).items()}"),
    right("lines that end in CR", "def F(transform):\r    return RIGHT\r"),
    right("a question mark at the end", "def F(transform):\n    return RIGHT\nF??"),
    right("an error behind it", "def F(transform):\n    return RIGHT\nassert F(None)"),
    answered("texts in arrays", "odd but right", "E3.1", "import numpy as np\ncalls = {name: np.array(pair.split()) for name, pair in {'a': 'map laser_frame', 'b': 'base_link map', 'c': 'base_link camera_link', 'd': 'laser_frame base_link'}.items()}"),
    answered("iterators for lists", "odd but right", "E3.2", MOVED + "corner = {'base_link': map(float, p), 'map': (number for number in m)}"),
    answered("views for lists", "odd but right", "E3.2", MOVED + "corner = {'base_link': dict(zip('xyz', p)).values(), 'map': dict(zip('xyz', m))}"),
]  # fmt: skip

RECIPES = [*FORGING, *PEEKING, *EXHAUSTION, *SURVIVAL, *TAMPERING, *CLOSER, *BROKEN, *ODD, *AGAIN]
