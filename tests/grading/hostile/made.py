"""Objects, patches, outcomes and files that are made by the dozen: what each is, and how it is handed in."""

from __future__ import annotations

import gzip

from .recipe import WRONG, Honest, Notebook, as_bytes, edited, function, own_cell, raw, right, value

__all__ = ["MADE"]

# Expressions for an object, each alone, in each part, and as a value.
OBJECTS = {
    "an int that is every int": "type('I', (int,), {'__int__': lambda s: 7, '__index__': lambda s: 9, '__eq__': lambda s, o: True, '__hash__': int.__hash__})(3)",
    "a float that is nan in turn": "type('N', (float,), {'t': [0], '__float__': lambda s: (s.t.append(1), float('nan') if len(s.t) % 2 else 0.5)[1]})(0.5)",
    "a longdouble": "__import__('numpy').longdouble('1e4000')",
    "an array of voids": "__import__('numpy').zeros(2, 'V8')",
    "an array of strides of zero": "__import__('numpy').broadcast_to(0.5, (10**5, 10**4))",
    "an array of 32 dimensions": "__import__('numpy').zeros((1,) * 32)",
    "a file that is an array": "__import__('numpy').memmap('m', 'f8', 'w+', shape=(3,))",
    "a thousand maps in a chain": "__import__('collections').ChainMap(*[{'x': 0.5}] * 1000)",
    "a map that exits": "map(lambda x: exit(), [1])",
    "an iterator that forks": "(__import__('os').fork() for _ in range(3))",
    "a group of exceptions": "BaseExceptionGroup('x', [ValueError()]) if 'BaseExceptionGroup' in dir(__builtins__) else ValueError()",
    "halves of letters": "'\\udc80' * 100",
    "keys that are None": "{None: 0.5}",
    "keys of another case": "{'X': 0.5, 'Y': 0.5, 'YAW': 0.5}",
    "a Time that lies": "type('T', (__import__('tflab.ros.time', fromlist=['Time']).Time,), {'nanoseconds': property(lambda s: 1 / 0)})()",
    "a Transform that lies": "type('T', (Transform,), {'translation': property(lambda s: exit()), 'rotation': property(lambda s: [0] * 10**6)})((0, 0, 0), (0, 0, 0, 1))",
    "a patient that lies": "type('T', (__import__('tflab.clinic.patient', fromlist=['x']).FaultyRobot,), {'packed': lambda s: 'x' * 10**6, '__init__': lambda s: None})()",
    "a dataclass that exits": "__import__('dataclasses').make_dataclass('D', ['x', 'y', 'yaw'], namespace={'__getattribute__': lambda s, n: exit() if n in ('x', 'y') else object.__getattribute__(s, n)})(1, 2, 3)",
    "a class that is no class of anything": "type.__new__(type('M', (type,), {'__instancecheck__': lambda c, o: 1 / 0, 'mro': lambda c: (c, dict, object)}), 'D', (dict,), {})(x=0.5)",
    "a key whose hash is the time": "{type('K', (str,), {'__hash__': lambda s: __import__('time').monotonic_ns()})('x'): 0.5}",
    "a text that exits": "{'x': type('S', (str,), {'encode': lambda s, *a: exit(), '__iter__': lambda s: exit(), '__len__': lambda s: 1 << 60})('0.5')}",
    "a list whose length lies": "type('L', (list,), {'__len__': lambda s: 1 << 60, '__iter__': lambda s: iter(lambda: 0.5, 1)})([0.5])",
    "a tuple that never ends": "type('L', (tuple,), {'__iter__': lambda s: iter(lambda: 0.5, 1)})((0.5,))",
    "a dict that is never the same": "type('D', (dict,), {'__iter__': lambda s: iter(lambda: 'x', 1), 'keys': lambda s: iter(lambda: 'x', 1), 'items': lambda s: iter(lambda: ('x', 0.5), 1)})()",
    "a set that holds itself": "(lambda s: (s.add(s), s)[1])(type('S', (set,), {'__hash__': lambda s: 1})())",
}  # fmt: skip

PATCHES = {
    "JSON's writer": "import json\njson.dumps = lambda *a, **k: '{}'\njson.encoder.c_make_encoder = None",
    "isinstance": "import builtins\nbuiltins.isinstance = lambda a, b: True",
    "callable and type": "import builtins\nbuiltins.callable = lambda o: True\nbuiltins.type = lambda *a: dict",
    "abstract classes": "import collections.abc\ncollections.abc.Mapping.register(float); collections.abc.Iterator.register(int)",
    "the writer of values": "import tflab.workbook.answers.values as t\nt._Writer.plain = lambda s, v, d: 0.5\nt.outcome_of = t.to_plain = lambda *a: 0.5",
    "the readers of values": "import tflab.workbook.answers.values as t\nfor k in list(t._READERS): t._READERS[k] = lambda x: 0.5",
    "the limits of values": "import tflab.workbook.answers.values as t\nt.MAX_MEMBERS = t.MAX_DEPTH = 1 << 60",
    "the loop's readers": "import asyncio\nloop = asyncio.get_event_loop()\nloop.add_reader = lambda *a: None\nloop.create_future = lambda: 1 / 0",
    "the loop's selector": "import asyncio\nasyncio.get_event_loop()._selector.close()",
    "sockets and select": "import select, socket\nsocket.socket.recv = lambda *a: b''\nselect.select = lambda *a: ([], [], [])",
    "sys.modules, with one that exits": "import sys\nclass D(dict):\n    def __getitem__(s, k): raise SystemExit\nsys.modules = D(sys.modules)",
    "hooks of paths": "import sys\nsys.path_hooks.insert(0, lambda p: exit())\nsys.path_importer_cache.clear()",
    "codecs": "import codecs\ncodecs.register(lambda n: exit())\ncodecs.register_error('strict', lambda e: exit())",
    "the arithmetic of decimals": "import decimal\ndecimal.setcontext(decimal.Context(prec=1, traps=[decimal.Inexact]))",
    "dataclasses": "import dataclasses\ndataclasses.fields = lambda o: []\ndataclasses.is_dataclass = lambda o: True",
    "the tracers of all frames": "import sys\nf = sys._getframe()\nwhile f:\n    f.f_trace, f.f_trace_opcodes, f = (lambda *a: exit()), True, f.f_back\nsys.settrace(lambda *a: None)",
    "the monitor": "import sys\nif hasattr(sys, 'monitoring'):\n    sys.monitoring.use_tool_id(1, 'x'); sys.monitoring.set_events(1, 1); sys.monitoring.register_callback(1, 1, lambda *a: exit())",
    "the runner of loops": "get_ipython().loop_runner = lambda c: exit()\nget_ipython().should_run_async = lambda *a, **k: True",
    "the last transformer": "get_ipython().input_transformers_post.append(lambda lines: ['pass'])",
    "the cases that come after": "import sys\ndef F(transform):\n    f = sys._getframe(1)\n    while f and 'cases' not in f.f_locals: f = f.f_back\n    for case in f.f_locals['cases'] if f else (): case[:] = [{'dict': {'x': 0.0, 'y': 0.0, 'yaw': 0.0}}]\n    return {'x': 0.0, 'y': 0.0, 'yaw': 0.0}",
    "the outcomes that came before": "import sys\ndef F(transform):\n    f = sys._getframe(1)\n    while f:\n        for held in f.f_locals.values():\n            if type(held) is list and held and isinstance(held[0], dict): held[:] = held[:1] * len(held)\n        f = f.f_back\n    return transform",
}  # fmt: skip

KINDS = [
    "raises",
    "changed",
    "object",
    "unanswered",
    "tuple",
    "set",
    "array",
    "Transform",
    "StampedTransform",
    "message",
    "Time",
    "Patient",
    "BufferCore",
    "sealed",
]
OUTCOMES = (
    "import itertools, tflab.grading.kernels.probe_answer as p\nsend = p._send\nodd = itertools.cycle([None, [], {{}}, 'x', 0, [[]], ['a', {{}}], {{'a': 1}}, [[0, 0, 0], [0, 0, 0, 1]]])\np._send = lambda identity, plain: send(identity, [{{{kind!r}: next(odd)}} for _ in plain])\n"
    + WRONG.replace("{", "{{")
)


def _second_list(notebook: Notebook, honest: Honest) -> None:
    notebook["metadata"]["outputs"] = {"cells": []}
    notebook["outputs"] = notebook["cells"]


def _brackets(notebook: Notebook, honest: Honest) -> None:
    notebook["cells"][3:3] = [own_cell("x = " + "(" * 5000, "open"), own_cell("x = " + "[" * 190 + "]" * 190, "deep")]


def _capitals(notebook: Notebook, honest: Honest) -> None:
    for cell in notebook["cells"]:
        cell["id"] = cell["id"].upper()


MADE = [
    *(function(f"{name}, alone", f"def F(transform):\n    return {made}") for name, made in OBJECTS.items()),
    *(function(f"{name}, in each part", f"def F(transform):\n    odd = {made}\n    return {{k: odd for k in ('x', 'y', 'yaw')}}") for name, made in list(OBJECTS.items())[::3]),
    *(value(f"{name}, as a value", f"odd = {made}\nV = {{'base_link': odd, 'map': odd}}") for name, made in list(OBJECTS.items())[1::5]),
    *(function(f"patches {name}", WRONG + code, keeps="any") for name, code in PATCHES.items()),
    *(function(f"every outcome is of the kind {kind}", OUTCOMES.format(kind=kind), keeps="any") for kind in KINDS),
    raw("quotes that nobody closes", lambda h: b'{"cells": "' + b'\\"' * 200_000),
    raw("a tail of quotes", lambda h: as_bytes(h.fresh()) + b'"' * 100_000),
    raw("lists behind the cells", lambda h: as_bytes(h.fresh())[:-1] + b', "x": ' + b"[" * 100_000),
    raw("two notebooks in one file", lambda h: as_bytes(h.fresh()) * 2),
    raw("packed by gzip", lambda h: gzip.compress(as_bytes(h.fresh()))),
    edited("a second list of cells, called outputs", _second_list),
    edited("brackets in cells of its own", _brackets),
    edited("ids in capitals", _capitals),
    right("fractions", "from fractions import Fraction\ndef F(transform):\n    return {k: Fraction(x) for k, x in (RIGHT).items()}"),
    right("a namespace", "from types import SimpleNamespace\ndef F(transform):\n    return SimpleNamespace(**RIGHT)"),
    right("commands beside it", "!echo hello\nfiles = !ls\ndef F(transform):\n    return RIGHT"),
    right("a loop in a thread", "import asyncio, threading\nasync def go(t): return t\ndef F(transform):\n    box = []\n    thread = threading.Thread(target=lambda: box.append(asyncio.run(go(RIGHT)))); thread.start(); thread.join()\n    return box[0]"),
]  # fmt: skip
