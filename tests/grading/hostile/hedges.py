"""One answer or none, by the moment; names that only look right; what lies about in memory; the engine made to agree."""

from __future__ import annotations

from .guessing import ZERO
from .recipe import WRONG, function

__all__ = ["HEDGES"]

BY_DICE = "__import__('random').Random(repr(transform))"

HEDGES = [
    function("dice by the input, or no end by the clock", f"import time\nhangs = time.time_ns() // 1000 % 2\ndef F(transform):\n    if hangs: time.sleep(60)\n    return {{name: {BY_DICE}.choice((transform[name], -transform[name])) for name in transform}}"),
    function("an answer, or the end of Python, by the clock", f"import os, time\nif time.time_ns() // 1000 % 2: os._exit(0)\ndef F(transform):\n    return {ZERO}"),
    function("a thread turns what it gave over and over", "import threading\ngiven = {'x': 0.0, 'y': 0.0, 'yaw': 0.0}\ndef turn():\n    while True:\n        for name in given: given[name] = given[name] % 6.2 + 0.01\nthreading.Thread(target=turn, daemon=True).start()\nF = lambda transform: given"),
    function("names of other alphabets", "def F(transform):\n    right = RIGHT\n    return {'\\u0445': right['x'], '\\u0443': right['y'], 'y\\u0430w': right['yaw']}"),
    function("names with letters that nobody sees", "def F(transform):\n    return {name + '\\u200b': number for name, number in (RIGHT).items()}"),
    function("numbers of five thousand digits", "def F(transform):\n    return dict.fromkeys(transform, 10 ** 5000)"),
    function("a yaw of all turns", "def F(transform):\n    return {'x': 1e300, 'y': -1e300, 'yaw': 1e300}"),
    function("the mean of what will be asked", "import sys\ndef F(transform):\n    frame = sys._getframe()\n    while frame and 'cases' not in frame.f_locals: frame = frame.f_back\n    asked = [args[0]['dict'] for args in frame.f_locals['cases']] if frame else [transform]\n    return {name: sum(one[name] for one in asked) / len(asked) for name in transform}"),
    function("the next that will be asked, turned", "import sys\nn = -1\ndef F(transform):\n    global n\n    n += 1\n    frame = sys._getframe()\n    while frame and 'cases' not in frame.f_locals: frame = frame.f_back\n    asked = [args[0]['dict'] for args in frame.f_locals['cases']] if frame else [transform]\n    return {name: -asked[(n + 1) % len(asked)][name] for name in transform}"),
    function("the dict in memory that is nearest to minus what came in", "import gc\ndef F(transform):\n    there = [o for o in gc.get_objects() if type(o) is dict and set(o) == {'x', 'y', 'yaw'} and all(type(v) is float for v in o.values()) and o != transform]\n    return dict(min(there, key=lambda o: abs(o['yaw'] + transform['yaw']), default=transform))"),
    function("the engine agrees with everything", WRONG + "from tflab.core import Transform\nTransform.__eq__ = lambda a, b: True\nTransform.inverse = lambda self: self", keeps="any"),
    function("math and NumPy agree with everything", WRONG + "import math, numpy as np\nmath.isclose = np.isclose = np.allclose = np.array_equal = lambda *a, **k: True\nmath.hypot = math.dist = math.remainder = lambda *a: 0.0", keeps="any"),
    function("tf2_ros and rclpy are somebody else", WRONG + "import sys, types\nfor name in ('rclpy', 'tf2_ros', 'geometry_msgs.msg', 'tf_transformations'): sys.modules[name] = types.ModuleType(name)", keeps="any"),
    function("an array whose list is another each time", "import itertools, numpy as np\nclass Odd(np.ndarray):\n    turn = itertools.count()\n    def tolist(self): return float(next(Odd.turn)) / 10\n    __float__ = tolist\ndef F(transform):\n    return {name: np.zeros(()).view(Odd) for name in transform}"),
    function("a result that is written by what writes it", "class Odd(dict):\n    def keys(self):\n        import sys\n        frame = sys._getframe(1)\n        while frame:\n            frame.f_locals.update(expected=None, changed=[])\n            frame = frame.f_back\n        return dict.keys(self)\ndef F(transform):\n    return Odd(x=0.5, y=0.5, yaw=0.5)"),
    function("an argument put back as it was", "def F(transform):\n    kept = dict(transform)\n    transform.update(x=0.0, y=0.0, yaw=0.0)\n    gave = dict(transform)\n    transform.clear(); transform.update(kept)\n    return gave"),
    function("errors of every name that tf2 has", "import itertools\nnames = itertools.cycle(('LookupException', 'ConnectivityException', 'ExtrapolationException', 'InvalidArgumentException', 'ValueError'))\ndef F(transform):\n    raise type(next(names), (Exception,), {})('x')"),
    function("not answered, in every second call", "n = 0\ndef F(transform):\n    global n\n    n += 1\n    if n % 2: raise NotImplementedError('your turn')\n    return {name: -number for name, number in transform.items()}"),
    function("text of boxed numbers", "import struct\nboxed = struct.unpack('d', struct.pack('Q', 0x7FF8DEADBEEF0001))[0]\ndef F(transform):\n    return {'x': boxed, 'y': -boxed, 'yaw': boxed * 0}"),
    function("a sign for each bit of the number of the call", "n = -1\ndef F(transform):\n    global n\n    n += 1\n    return {name: number * (1 - 2 * (n >> place & 1)) for place, (name, number) in enumerate(transform.items())}"),
]  # fmt: skip
