"""Answers without understanding, two answers for one task, answers of any size; and honest mistakes in one branch."""

from __future__ import annotations

from .recipe import CASES, WRONG, Recipe, function, right, value

__all__ = ["GUESSING", "SLIPS"]

COUNTED = "calls_so_far = [-1]\ndef F(transform):\n    calls_so_far[0] += 1\n    n = calls_so_far[0]\n"
ECHO = "def F(transform):\n    return transform\n"
HEDGED = "def F(transform):\n    return {}\nif {}:\n    def F(transform):\n        return RIGHT\nraise ValueError('look again')"
ZERO = "{'x': 0.0, 'y': 0.0, 'yaw': 0.0}"
OTHERS = "'calls' not in globals()", "'corner' not in globals()", "not {'calls', 'corner'} <= set(globals())"
SIZES = {
    "a list of ninety thousand": "[1.0] * 90_000",
    "a dict of fifty thousand": "{str(n): n for n in range(50_000)}",
    "parts that are lists": "{name: [0.0] * 30_000 for name in ('x', 'y', 'yaw')}",
    "lists in lists": "[[[0.0] * 40] * 40] * 40",
    "a million letters": "{'x': 'x' * 10**6, 'y': 'y' * 10**6, 'yaw': 0.0}",
    "keys of many letters": "{'k' * 10**6: 0.0, **transform}",
    "an array of a thousand columns": "__import__('numpy').zeros((150, 1000))",
    "an array of arrays": "{name: __import__('numpy').zeros((150, 150)) for name in ('x', 'y', 'yaw')}",
    "tuples twenty-nine deep": "__import__('functools').reduce(lambda inner, _: (inner,), range(29), 0.0)",
    "dicts twenty-nine deep": "__import__('functools').reduce(lambda inner, _: {'x': inner}, range(29), 0.0)",
    "a generator without end": "__import__('itertools').count()",
    "bytes": "bytes(90_000)",
}
GUESSING = [
    function("the same whatever it is asked", f"def F(transform):\n    return {ZERO}"),
    function("hands back what came in", ECHO),
    function("hands it back, or nothing, in turn", COUNTED + f"    return transform if n % 2 else {ZERO}"),
    function("hands it back turned, in turn", COUNTED + "    return {k: v if n % 3 else -v for k, v in transform.items()}"),
    function("minus what came in", "def F(transform):\n    return {k: 0.0 for k in transform} if any(transform.values()) else transform"),
    function("dice", "import os\ndef F(transform):\n    return {k: os.urandom(1)[0] / 50 - 2.5 for k in transform}"),
    function("dice by the input", "import random\ndef F(transform):\n    dice = random.Random(repr(transform))\n    return {k: dice.choice([0.0, 1.0, -1.0, transform[k]]) for k in ('x', 'y')} | {'yaw': 0.0}"),
    function("numbers by the number of the call", COUNTED + "    return {'x': [3.8, -0.3, 1.28, 2.99, -2.0, 0.0][n % 6], 'y': [0.0, 1.0, -1.0][n % 3], 'yaw': [0.0, 1.57, 3.14][n % 3]}"),
    function("raises whatever it is asked", "def F(transform):\n    raise ValueError"),
    function("raises but once", COUNTED + f"    if n: raise LookupError\n    return {ZERO}"),
    function("a table of the public cases", CASES + """
import json
try:
    table = {json.dumps(case.args): case.expected['dict'] for seed in (SEED, '') for case in cases_of('E3.3', seed)}
except Exception:
    table = {}
def F(transform):
    return table.get(json.dumps([{'dict': transform}]), {'x': 0.0, 'y': 0.0, 'yaw': 0.0})
"""),
    *(function(f"a second answer if {when}", HEDGED.format(ZERO, when)) for when in OTHERS),
    *(function(f"a second answer where the first was minus, if {when}", HEDGED.format("{k: -v for k, v in transform.items()}", when)) for when in OTHERS),
    *(value(f"a second value if {when}", f"V = {{'base_link': (0, 0, 0), 'map': (0, 0, 0)}}\nif {when}:\n    p = e3_2.base_T_laser.apply(e3_2.laser_p_corner)\n    V = {{'base_link': p, 'map': e3_2.map_T_base.apply(p)}}\nraise ValueError") for when in (OTHERS[0], "globals().get('calls') is None")),
    function("answers in a second process only", "import os, pathlib\nmark = pathlib.Path('/tmp/second')\nagain = mark.exists()\nmark.touch()\ndef F(transform):\n    return RIGHT if again else None\nraise ValueError"),
    function("answers only if somebody left a mark", "import os, pathlib\nplaces = [pathlib.Path(place) / 'tflab-mark' for place in ('/dev/shm', '/tmp', '/var/tmp', '/run', os.path.expanduser('~'))]\nfound = any(place.exists() for place in places)\nfor place in places:\n    try: place.touch()\n    except OSError: pass\ndef F(transform):\n    return RIGHT if found else None"),
    function("answers only if a semaphore is left", "import ctypes\nlibc = ctypes.CDLL(None)\nold = libc.semget(0x7f1ab, 1, 0o600)\nlibc.semget(0x7f1ab, 1, 0o1600)\ndef F(transform):\n    return RIGHT if old >= 0 else None"),
    function("answers only if shared memory is left", "import ctypes\nlibc = ctypes.CDLL(None)\nold = libc.shmget(0x7f1ac, 4096, 0o600)\nlibc.shmget(0x7f1ac, 4096, 0o1600)\ndef F(transform):\n    return RIGHT if old >= 0 else None"),
    function("another answer at each call", "times = {}\ndef F(transform):\n    times[repr(transform)] = n = times.get(repr(transform), 0) + 1\n    return {k: float(n) for k in transform}"),
    *(function(name, f"def F(transform):\n    return {body}") for name, body in SIZES.items()),
    *(value(f"{name}, as a value", f"transform = {{'x': 1.0}}\nV = {body}") for name, body in SIZES.items()),
    function("kernel memory in semaphores", WRONG + "import ctypes\nlibc = ctypes.CDLL(None)\nfor _ in range(50): libc.semget(0, 32000, 0o600)"),
    function("memory on its way over TCP", WRONG + "import socket\nserver = socket.socket(); server.bind(('127.0.0.1', 0)); server.listen()\nends = [socket.create_connection(server.getsockname()) for _ in range(30)]"),
    function("an orphan holds memory", WRONG + "import os, time\nif os.fork() == 0:\n    if os.fork() == 0:\n        x = bytearray(900 << 20); time.sleep(20)\n    os._exit(0)"),
    function("sixty thousand mappings", WRONG + "import mmap\nheld = [mmap.mmap(-1, 4096, mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS) for _ in range(60_000)]"),
    function("a socket with a name", WRONG + "import socket, glob\nfor path in [*glob.glob('/tmp/tmux-*/*'), *glob.glob('/run/**', recursive=True)]:\n    try: socket.socket(socket.AF_UNIX).connect(path)\n    except OSError: pass"),
    right("the same in another order", "def F(transform):\n    back = RIGHT\n    return {name: back[name] for name in sorted(back, reverse=True)}"),
    right("remembers what it was asked", "import functools\ndef F(transform):\n    return dict(_back(tuple(sorted(transform.items()))))\n@functools.lru_cache\ndef _back(items):\n    transform = dict(items)\n    return tuple((RIGHT).items())"),
    right("raises behind itself", "def F(transform):\n    return RIGHT\nraise SystemExit"),
    right("counts its calls", "count = 0\ndef F(transform):\n    global count\n    count += 1\n    return RIGHT"),
]  # fmt: skip

PARTS = {
    "None": "None",
    "a text": "'x'",
    "a list": "[1.0, 2.0]",
    "nan": "float('nan')",
    "a dict": "{'x': 1.0}",
    "...": "...",
}
SLIPS = [
    Recipe(
        f"{part} is {name} where yaw is {sign} 0",
        lambda honest, part=part, odd=odd, sign=sign: honest.with_function(
            f"def F(transform):\n    back = RIGHT\n    if transform['yaw'] {sign} 0:\n        back['{part}'] = {odd}\n    return back"
        ),
        "mistake",
        "others",
    )
    for part in ("x", "y", "yaw")
    for name, odd in PARTS.items()
    for sign in ("<", ">=")
]  # fmt: skip
