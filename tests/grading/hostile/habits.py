"""What honest people do besides answering: plots, logs, tests, timings, another kind of callable; it costs nothing."""

from __future__ import annotations

from .recipe import Recipe, right

__all__ = ["HABITS"]

# The function itself, right, in a form that somebody likes.
FUNCTIONS = {
    "logs to a list and to a logger": "import logging\nlogging.basicConfig(level=logging.DEBUG)\nlog = []\ndef F(transform):\n    log.append(transform)\n    logging.debug('call %d of %s', len(log), transform)\n    return RIGHT",
    "sleeps as long as the dice say": "import random, time\ndef F(transform):\n    time.sleep(random.random() / 100)\n    return RIGHT",
    "a cache behind it": "import functools\n@functools.lru_cache(maxsize=None)\ndef cached(x, y, yaw):\n    transform = {'x': x, 'y': y, 'yaw': yaw}\n    return RIGHT\ndef F(transform):\n    return cached(**transform)",
    "one dict for all results": "result = {}\ndef F(transform):\n    result.clear()\n    result.update(RIGHT)\n    return result",
    "a timing decorator": "import functools, time\ndef timed(f):\n    @functools.wraps(f)\n    def inner(*args, **named):\n        began = time.perf_counter()\n        try: return f(*args, **named)\n        finally: print(f.__name__, time.perf_counter() - began)\n    return inner\n@timed\ndef F(transform):\n    return RIGHT",
    "a lambda": "F = lambda transform: RIGHT",
    "made by eval": "F = eval('''lambda transform: RIGHT''')",
    "only where it is the main program": "if __name__ == '__main__':\n    def F(transform):\n        return RIGHT",
    "a static method": "class Tools:\n    @staticmethod\n    def turned_back(transform):\n        return RIGHT\nF = Tools.turned_back",
    "a dataclass that can be called": "from dataclasses import dataclass\n@dataclass\nclass Inverter:\n    calls: int = 0\n    def __call__(self, transform):\n        self.calls += 1\n        return RIGHT\nF = Inverter()",
    "a user's dict": "from collections import UserDict\ndef F(transform):\n    return UserDict(RIGHT)",
    "a dict that counts": "from collections import defaultdict\ndef F(transform):\n    return defaultdict(float, RIGHT)",
    "a copy that it changes": "import copy\ndef F(transform):\n    given, transform = transform, copy.deepcopy(transform)\n    back = RIGHT\n    transform.clear()\n    return back",
    "unpacked and matched": "def F(transform):\n    match transform:\n        case {'x': _, 'y': _, 'yaw': _}:\n            return RIGHT",
    "an alarm of its own, taken back": "import signal\ndef F(transform):\n    signal.alarm(1)\n    try: return RIGHT\n    finally: signal.alarm(0)",
    "clears what is shown": "from IPython.display import clear_output\ndef F(transform):\n    print('one moment'); clear_output(wait=True)\n    return RIGHT",
    "figures left open": "import matplotlib.pyplot as plt\ndef F(transform):\n    plt.figure(); plt.plot([0, transform['x']])\n    return RIGHT",
    "results kept in a file": "import shelve\ndef F(transform):\n    with shelve.open('results') as kept:\n        return kept.setdefault(repr(transform), RIGHT)",
    "many returns in a try": "def F(transform):\n    try:\n        return RIGHT\n    except KeyError:\n        return None\n    finally:\n        print('done')",
    "numbers of NumPy in half the digits": "import numpy as np\ndef F(transform):\n    x, y, yaw = np.array([(RIGHT)[name] for name in ('x', 'y', 'yaw')], dtype=np.float32)\n    return dict(x=x, y=y, yaw=yaw)",
}  # fmt: skip

# What stands in a cell before the answer to another task.
CELLS = {
    "thirty figures left open": "import matplotlib.pyplot as plt\nfor _ in range(30): plt.figure(); plt.plot([0, 1])",
    "fifty megabytes printed": "for _ in range(500): print('x' * 100_000)",
    "a question at the keyboard": "name = input('your name? ')",
    "an await of its own": "import asyncio\nasync def soon(): await asyncio.sleep(0.01); return 1\nawait soon()",
    "everything from NumPy": "from numpy import *",
    "a test that ends with SystemExit": "import unittest\nclass T(unittest.TestCase):\n    def test(self): self.assertTrue(True)\nunittest.main(argv=['x'])",
    "an exit": "exit()",
    "a stop by sys.exit": "import sys\nsys.exit('stop here')",
    "a timing magic": "%timeit -n 3 -r 2 sum(range(100))",
    "a profile": "%prun -q sum(range(100))",
    "what is captured": "%%capture out\nprint('quiet')",
    "a list of names": "%whos",
    "modules loaded anew": "%load_ext autoreload\n%autoreload 2",
    "another folder": "import os, tempfile\nos.chdir(tempfile.mkdtemp())",
    "a slider": "import ipywidgets\nipywidgets.interact(lambda yaw: yaw, yaw=(-3.0, 3.0))",
    "a doctest": "import doctest\ndoctest.testmod()",
    "dice with a seed": "import random, numpy as np\nrandom.seed(1); np.random.seed(1)",
    "letters in full width and a picture": "print('ａ한글😀\\u202e' * 100)",
}  # fmt: skip

HABITS = [
    *(right(name, body) for name, body in FUNCTIONS.items()),
    *(Recipe(f"{name}, in a cell of its own", lambda h, code=code: h.with_cell(code, h.value_task)) for name, code in CELLS.items()),
]  # fmt: skip
