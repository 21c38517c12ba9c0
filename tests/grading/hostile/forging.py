"""Attacks that claim a point: forged messages, objects that equal everything, answers that replace the judge."""

from __future__ import annotations

from .recipe import WIRE, WRONG, function, value

__all__ = ["FORGING"]

WRITE = "import os, struct\nwire = get_ipython().kernel.session.wire.fileno()\n"


FORGING = [
    function("prints the line of a pass", WRONG + "print('E3.3 ✓ 6/6')"),
    function("replaces check", WRONG + "import tflab.workbook\ntflab.workbook.check = check = print"),
    function("replaces the judge", WRONG + """
import tflab.workbook.answers.form
tflab.workbook.answers.form.Form.judge = lambda *a: [True] * 6
"""),
    function("replaces numpy's comparisons", WRONG + """
import numpy, math, builtins
numpy.allclose = numpy.isclose = math.isclose = lambda *a, **k: True
builtins.abs = lambda x: 0
"""),
    function("an object equal to everything", """
class Yes:
    def __eq__(self, other): return True
    def __hash__(self): return 0
    def __float__(self): return 7.25
    def __getattr__(self, name): return self
def F(transform):
    return Yes()
"""),
    function("sends probes of its own", WRONG + """
from IPython.display import display
for identity in ('E3.3', '', 'e3-3-check', None, 1):
    display({'application/vnd.tflab.probe+json': {'id': identity, 'v': [True] * 9}}, raw=True)
"""),
    function("sends every probe twice", WRONG + """
import IPython.display as d
_display = d.display
def twice(*a, **k):
    _display(*a, **k); _display(*a, **k)
d.display = twice
"""),
    function("says true to every probe", WRONG + """
import tflab.grading.kernels.probe_answer as inside
_send = inside._send
inside._send = lambda identity, plain: _send(identity, [True] * len(plain))
"""),
    function("sends nan, bool and endless numbers", """
def F(transform):
    return [float('nan'), True, 10 ** 5000]
"""),
    *(
        function(
            f"sends {depth} lists in one another",
            f"""
import tflab.grading.kernels.probe_answer as inside
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
        for depth in (150, 900)
    ),
    function("forges with the kernel's own session", WRONG + """
kernel = get_ipython().kernel
session, socket = kernel.session, kernel.iopub_socket
for _ in range(20):
    session.send(socket, 'status', {'execution_state': 'idle'}, parent={})
    session.send(socket, 'execute_reply', {'status': 'ok'}, parent={})
    session.send(socket, 'display_data', {'data': {'application/vnd.tflab.probe+json': 3}, 'metadata': {}}, parent={})
""", keeps="any"),
    function("sends torn frames", WRONG + """
kernel = get_ipython().kernel
for frames in ([b'x'], [b'<IDS|MSG>', b'no', b'{', b'', b'', b''], [b''] * 9):
    try: kernel.iopub_socket.send_multipart(frames)
    except Exception: pass
""", keeps="any"),
    function("a hook after every cell", WRONG + """
def after(*a):
    get_ipython().user_ns['check'] = print
    print('✓' * 10)
get_ipython().events.register('post_run_cell', after)
"""),
    function("replaces the shell's run_cell", WRONG + """
type(get_ipython()).run_cell = lambda *a, **k: None
""", keeps="any"),
    function("shadows tflab with a file", WRONG + """
import os, pathlib
os.makedirs('tflab', exist_ok=True)
pathlib.Path('tflab/__init__.py').write_text('raise SystemExit')
pathlib.Path('sitecustomize.py').write_text('raise SystemExit')
"""),
    function("writes results of its own", WRONG + """
import pathlib
for name in ('results.json', 'grades.csv', '../results.json', '../../results.json', '/results.json'):
    try: pathlib.Path(name).write_text('{"points": 100}')
    except OSError: pass
"""),
    function("exits as if all were well", WRONG + "import os\nos._exit(0)"),
    function("raises SystemExit", WRONG + "raise SystemExit(0)"),
    function("asks the kernel to exit", WRONG + "get_ipython().kernel.do_shutdown(False); exit()", keeps="any"),
    function("raises from within a call", "def F(transform):\n    raise SystemExit(0)\n"),
    function("raises KeyboardInterrupt from within a call", "def F(transform):\n    raise KeyboardInterrupt\n"),
    function("says that it is not answered, loudly", "def F(transform):\n    raise NotImplementedError('your turn')"),
    value("a string of the numbers", "V = '(0.1, 2.0, 0.15)'"),
    value("all truths", "V = (True, True, True)"),
    value("a function in place of numbers", "V = lambda *a: (0, 0, 0)"),
    value("infinite numbers", "V = (float('inf'),) * 3"),
    function("an error of a name nested deep", WIRE + "raw(b'{\"channel\": \"iopub\", \"msg_type\": \"error\", \"parent_header\": {\"msg_id\": \"' + parent.encode() + b'\"}, \"content\": {\"ename\": ' + b'[' * 900 + b']' * 900 + b', \"evalue\": 1}}')", keeps="any"),
    function("a frame of four gigabytes, announced", WIRE + "wire.end.setblocking(True); wire.end.sendall(b'\\xff\\xff\\xff\\xff' + b'x' * 100)", keeps="any"),
    function("half a frame, and then nothing", WIRE + "wire.end.setblocking(True); wire.end.sendall(b'\\0\\0\\x10\\0{'); import time; time.sleep(600)"),
    function("frames that are no JSON", WIRE + "for body in (b'\\xff\\xfe', b'NaN', b'[]', b'1' * 9000, b'', b'{\"a\":' * 5000): raw(body)", keeps="any"),
    function("says ready, done and idle before its time", WIRE + "raw(json.dumps({'ready': True, 'fault': 'x'}).encode())\nfor to in (parent, None, [], {}, 3): say('status', {'execution_state': 'idle'}, to)", keeps="any"),
    function("messages of every wrong shape", WIRE + """
for content in (None, [], 3, {'data': None}, {'data': {PROBE: None}}, {'data': {PROBE: {'id': [], 'v': {}}}}, {'execution_state': []}):
    for kind in ('display_data', 'status', 'error', 'execute_result', 'stream', None, 3):
        say(kind, content)
""", keeps="any"),
    function("answers for its probe with every shape there is", """
import tflab.grading.kernels.probe_answer as inside
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
    function("takes the next request off the wire", WIRE + """
import threading
def steal():
    while True:
        got = wire.receive(0.05)
        if got: say('status', {'execution_state': 'idle'}, got['msg_id'])
threading.Thread(target=steal, daemon=True).start()
""", keeps="any"),
    function("numbers that equal whatever they are compared with", """
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
    function("another answer each time it is read", """
import random
class Turning(dict):
    def items(self): return {k: random.uniform(-9, 9) for k in ('x', 'y', 'yaw')}.items()
def F(transform):
    return Turning(x=5, y=5, yaw=1)
"""),
    function("an error whose name says what was asked", """
def F(transform):
    raise type('asked_' + repr(sorted(transform.items())), (Exception,), {})(repr(transform))
"""),
    function("a result of a class named by what was asked", """
def F(transform):
    return type('asked_' + repr(sorted(transform.items())), (), {})()
"""),
    function("every part of the answer named by what was asked", "def F(transform):\n    return {repr(transform): 1.0, 'x': repr(transform), 'y': transform, 'yaw': [transform]}"),
    function("a class that lies about its class", """
import itertools
class Liar:
    __class__ = Transform
    translation = rotation = itertools.count()
def F(transform):
    return Liar()
"""),
    function("a class that ends Python when it is asked what it is", """
class Liar:
    @property
    def __class__(self): raise SystemExit
def F(transform):
    return Liar()
"""),
    function("an array whose list lies", """
import numpy as np
class Liar(np.ndarray):
    def tolist(self): return type('Yes', (float,), {'__eq__': lambda *a: True, '__sub__': lambda *a: 0.0})()
def F(transform):
    return {name: np.zeros(3).view(Liar) for name in ('x', 'y', 'yaw')}
"""),
    function("an error that ends Python when it is read", """
class Liar(Exception):
    def __str__(self): raise SystemExit
    __repr__ = __str__
def F(transform):
    raise Liar
"""),
    function("a mock that is everything", "from unittest.mock import MagicMock\nF = MagicMock()"),
    function("every module forgotten", WRONG + "import sys\nsys.modules.clear()"),
    function("builtins deleted", WRONG + "import builtins\nfor n in ('print', 'len', 'isinstance', 'type', '__import__'): delattr(builtins, n)"),
    function("an audit hook that ends Python", WRONG + "import os, sys\nsys.addaudithook(lambda event, args: os._exit(3) if event == 'compile' else None)"),
    function("a transformer that makes every call 1", WRONG + "import ast\nclass One(ast.NodeTransformer):\n    def visit_Call(self, node): return ast.Constant(1)\nget_ipython().ast_transformers.append(One())"),
    function("a probe that asks its neighbour", WRONG + "import tflab.grading.kernels.probe_answer as inside\n_p = inside.probe_answer\ninside.probe_answer = lambda identity, answer, args: _p(identity, lambda: compose, args)"),
    function("nothing and no one published", WRONG + "get_ipython().display_pub.publish = lambda *a, **k: None"),
    function("every descriptor closed", WRONG + "import os\nos.closerange(0, 256)"),
    function("half a frame on the wire", WRONG + WRITE + "os.write(wire, b'\\0\\0\\0\\xff{')"),
    function("a frame of brackets on the wire", WRONG + WRITE + "os.write(wire, struct.pack('!I', 100000) + b'[' * 100000)"),
    function("every task of the loop cancelled", WRONG + "import asyncio\nfor task in asyncio.all_tasks(): task.cancel()"),
]  # fmt: skip
