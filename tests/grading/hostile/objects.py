"""Objects that are not what they say: equal to all, other at each look, with side effects, of classes of classes."""

from __future__ import annotations

from .recipe import WRONG, function, right, value

__all__ = ["OBJECTS"]

# What a function or a value is made of: a class `Odd`, and an answer made with it.
MAKES = {
    "a text whose equals lies": ("class Odd(str):\n    def __eq__(self, o): return True\n    def __ne__(self, o): return False\n    def __hash__(self): return 0", "{Odd('x'): Odd('1'), Odd('y'): Odd('1'), Odd('yaw'): Odd('1')}"),
    "a text that turns into a number": ("class Odd(str):\n    def __float__(self): return 1.25\n    def __index__(self): return 1\n    __int__ = __index__", "dict.fromkeys(('x', 'y', 'yaw'), Odd('1'))"),
    "a float with side effects": ("import os\nclass Odd(float):\n    def __float__(self): os._exit(0)\n    def __repr__(self): os._exit(0)\n    __str__ = __repr__", "dict.fromkeys(('x', 'y', 'yaw'), Odd(1))"),
    "a float that changes at each look": ("class Odd(float):\n    n = 0\n    def __float__(self):\n        Odd.n += 1\n        return float(Odd.n)\n    def __round__(self, *a): return float(self)\n    __abs__ = __neg__ = __pos__ = __float__", "dict.fromkeys(('x', 'y', 'yaw'), Odd(1))"),
    "an int whose bits lie": ("class Odd(int):\n    def __index__(self): return 7\n    def bit_length(self): return 10**9\n    def __float__(self): return float('nan')", "dict.fromkeys(('x', 'y', 'yaw'), Odd(1))"),
    "a complex number": ("", "dict.fromkeys(('x', 'y', 'yaw'), 1 + 0j)"),
    "a bool of NumPy": ("import numpy as np", "dict.fromkeys(('x', 'y', 'yaw'), np.bool_(True))"),
    "a dict that has everything": ("class Odd(dict):\n    def __missing__(self, key): return 0.5\n    def __contains__(self, key): return True\n    def get(self, key, default=None): return 0.5", "Odd()"),
    "a dict of other items at each look": ("class Odd(dict):\n    n = 0\n    def items(self):\n        Odd.n += 1\n        return [(k, float(Odd.n)) for k in ('x', 'y', 'yaw')]\n    def __iter__(self): return iter(('x', 'y', 'yaw', 'z')[:Odd.n % 5])\n    def __len__(self): return Odd.n", "Odd(x=1)"),
    "a dict that grows as it is read": ("class Odd(dict):\n    def __iter__(self):\n        for key in ('x', 'y', 'yaw'):\n            self[len(self)] = key\n            yield key", "Odd(x=1, y=1, yaw=1)"),
    "a mapping that never ends": ("import collections.abc, itertools\nclass Odd(collections.abc.Mapping):\n    def __getitem__(self, key): return 0.5\n    def __iter__(self): return itertools.cycle(('x', 'y', 'yaw'))\n    def __len__(self): return 3", "Odd()"),
    "a list whose length lies": ("class Odd(list):\n    def __len__(self): return 10**9\n    def __iter__(self): return iter((1.0,) * 3)", "Odd([1.0])"),
    "a sequence by numbers only": ("class Odd:\n    def __getitem__(self, n): return 0.5\n    def __len__(self): return 3", "Odd()"),
    "an array by its interface": ("import numpy as np\nclass Odd:\n    def __array__(self, dtype=None, copy=None): return np.full(3, 0.5)", "Odd()"),
    "an array by an interface of wild memory": ("class Odd:\n    __array_interface__ = {'shape': (3,), 'typestr': '<f8', 'data': (8, True), 'version': 3}", "Odd()"),
    "an array by C of wild memory": ("import numpy as np", "np.ctypeslib.as_array(__import__('ctypes').cast(64, __import__('ctypes').POINTER(__import__('ctypes').c_double)), (3,))"),
    "a ufunc that says yes": ("import numpy as np\nclass Odd(np.ndarray):\n    def __array_ufunc__(self, *a, **k): return np.bool_(True)\n    def __array_function__(self, *a, **k): return True", "{k: np.zeros(1).view(Odd) for k in ('x', 'y', 'yaw')}"),
    "arrays of objects that run code": ("import numpy as np\nclass Odd:\n    def __float__(self): raise SystemExit\n    __repr__ = __str__ = __eq__ = __hash__ = __float__", "{k: np.array([Odd()], dtype=object) for k in ('x', 'y', 'yaw')}"),
    "a structured array": ("import numpy as np", "np.array([(1.0, 2.0, 3.0)], dtype=[('x', 'f8'), ('y', 'f8'), ('yaw', 'f8')])[0]"),
    "a masked array": ("import numpy as np", "{k: np.ma.masked for k in ('x', 'y', 'yaw')}"),
    "a date for a number": ("import numpy as np", "{k: np.datetime64('2020-01-01') for k in ('x', 'y', 'yaw')}"),
    "a memoryview": ("", "{k: memoryview(b'\\0' * 24).cast('d') for k in ('x', 'y', 'yaw')}"),
    "a weak reference": ("import weakref\nclass Odd(dict): pass\nheld = Odd(x=1.0, y=1.0, yaw=1.0)", "weakref.proxy(held)"),
    "a weak reference to what is gone": ("import weakref\nclass Odd(dict): pass", "weakref.proxy(Odd(x=1.0))"),
    "a descriptor that changes": ("import itertools\nclass Odd:\n    turn = itertools.count()\n    x = y = yaw = property(lambda self: float(next(Odd.turn)))", "Odd()"),
    "slots without values": ("class Odd:\n    __slots__ = ('x', 'y', 'yaw')", "Odd()"),
    "a class of a class that is everything": ("class Meta(type):\n    def __instancecheck__(cls, o): return True\n    def __subclasscheck__(cls, o): return True\n    def __eq__(cls, o): return True\n    def __hash__(cls): return hash(dict)\nclass Odd(dict, metaclass=Meta): pass", "Odd(x=1.0, y=1.0, yaw=1.0)"),
    "a class and no object": ("class Odd:\n    x = y = yaw = 0.5", "Odd"),
    "a class whose order of bases lies": ("class Meta(type):\n    def mro(cls): return [cls, dict, object]\nclass Odd(dict, metaclass=Meta): pass", "Odd(x=0.5, y=0.5, yaw=0.5)"),
    "a dataclass whose fields are made up": ("class Odd:\n    __dataclass_fields__ = {'x': None, 'y': 3, 'yaw': 'float'}\n    x = y = yaw = 0.5", "Odd()"),
    "a dataclass that holds itself": ("import dataclasses\n@dataclasses.dataclass\nclass Odd:\n    x: object = 0.0\n    y: object = 0.0\n    yaw: object = 0.0\nheld = Odd(); held.x = held.y = held.yaw = held", "held"),
    "a named tuple with fields of its own": ("class Odd(tuple):\n    _fields = ('x', 'y', 'yaw') * 10**4", "Odd((0.5,) * 3)"),
    "a pickle that runs code": ("import os\nclass Odd:\n    def __reduce_ex__(self, protocol): return (os._exit, (0,))\n    __getstate__ = __copy__ = lambda self: os._exit(0)\n    def __deepcopy__(self, memo): os._exit(0)", "Odd()"),
    "a lazy value": ("class Odd:\n    def __getattribute__(self, name):\n        if name == '__class__': return dict\n        return lambda *a, **k: {'x': 0.5, 'y': 0.5, 'yaw': 0.5}.items()", "Odd()"),
    "an object without a class to speak of": ("class Odd:\n    @property\n    def __class__(self): raise RuntimeError('no')\n    @property\n    def __dict__(self): raise RuntimeError('no')", "Odd()"),
    "a coroutine": ("async def odd(): return {'x': 0.5}", "odd()"),
    "a future": ("import asyncio, concurrent.futures", "concurrent.futures.Future()"),
    "a module": ("import math", "math"),
    "a frame": ("import sys", "sys._getframe()"),
    "an exception": ("", "ValueError({'x': 0.5})"),
    "what stands for what came out": ("", "{'raises': 'ValueError', 'text': ''}"),
    "what stands for nothing": ("", "{'unanswered': True}"),
    "what stands for an object": ("", "{'object': 'nothing', 'dict': {'x': 0.5, 'y': 0.5, 'yaw': 0.5}}"),
    "what stands for a dict": ("", "{'dict': {'x': 0.5, 'y': 0.5, 'yaw': 0.5}}"),
    "what is sealed": ("", "{'sealed': 'x', 'salt': '', 'probes': [[]]}"),
    "candidates for each number": ("", "{k: [n / 100 for n in range(-500, 500)] for k in ('x', 'y', 'yaw')}"),
    "a set of candidates": ("", "{k: frozenset(n / 100 for n in range(-500, 500)) for k in ('x', 'y', 'yaw')}"),
    "a range": ("", "{k: range(-5, 5) for k in ('x', 'y', 'yaw')}"),
    "numbers as texts of numbers": ("", "{k: '0.5' for k in ('x', 'y', 'yaw')}"),
    "fractions of nothing": ("import fractions, decimal", "{'x': decimal.Decimal('sNaN'), 'y': decimal.Decimal('1e999999'), 'yaw': fractions.Fraction(10**400, 3)}"),
}  # fmt: skip

AS_A_VALUE = ("a text whose equals lies", "a float that changes at each look", "a dict that has everything", "a mapping that never ends",
              "an array by an interface of wild memory", "a class of a class that is everything", "a pickle that runs code",
              "what stands for what came out", "what is sealed", "candidates for each number")  # fmt: skip

OBJECTS = [
    *(function(name, f"{made}\ndef F(transform):\n    return {answer}") for name, (made, answer) in MAKES.items()),
    *(value(f"{name}, as a value", f"{MAKES[name][0]}\nodd = {MAKES[name][1]}\nV = {{'base_link': odd, 'map': odd}}") for name in AS_A_VALUE),
    function("an object that is its own function", "class Odd(dict):\n    def __call__(self, transform): return self\nF = Odd(x=0.5, y=0.5, yaw=0.5)"),
    function("a function that looks like another", WRONG + "F.__code__ = compose.__code__ if 'compose' in globals() else F.__code__"),
    function("a function that is replaced when it is called", "def F(transform):\n    global F\n    F = lambda transform: dict(transform)\n    return None"),
    function("changes what it was asked, to fit", "def F(transform):\n    transform.clear()\n    transform.update(x=0.0, y=0.0, yaw=0.0)\n    return {'x': 0.0, 'y': 0.0, 'yaw': 0.0}"),
    right("a dict of its own kind with a view", "import types\ndef F(transform):\n    return types.MappingProxyType(RIGHT)"),
    right("chained dicts", "import collections\ndef F(transform):\n    return collections.ChainMap({}, RIGHT)"),
    right("arrays of one number", "import numpy as np\ndef F(transform):\n    return {name: np.array([number])[0] for name, number in (RIGHT).items()}"),
    right("half the digits", "import numpy as np\ndef F(transform):\n    return {name: np.float32(number) for name, number in (RIGHT).items()}"),
    right("rounded to the millimetre", "def F(transform):\n    return {name: round(number, 4) for name, number in (RIGHT).items()}"),
    right("a float of its own kind", "class Metres(float):\n    unit = 'm'\ndef F(transform):\n    return {name: Metres(number) for name, number in (RIGHT).items()}"),
]  # fmt: skip
