"""Answers by the number of the call, by which kernel it is, by clocks and machines: one submission, one answer."""

from __future__ import annotations

from .guessing import COUNTED, HEDGED, ZERO
from .recipe import CASES, function, value

__all__ = ["COUNTING"]

PUBLIC = (
    CASES
    + """
try:
    shown = [(case.args[0]['dict'], case.expected['dict']) for case in cases_of('E3.3')]
except Exception:
    shown = [({'x': 1.0, 'y': 0.0, 'yaw': 0.0}, {'x': 3.25, 'y': 4.5, 'yaw': 0.25})]
"""
)
BY_CALL = {
    "in their order": "shown[n % len(shown)][1]",
    "backwards": "shown[-1 - n % len(shown)][1]",
    "every other one": "shown[2 * n % len(shown)][1]",
    "each twice": "shown[n // 2 % len(shown)][1]",
    "the first once more at the end": "shown[n if n < len(shown) else 0][1]",
    "by a dice of its own": "__import__('random').Random(n).choice(shown)[1]",
    "by what came in, hashed": "shown[hash(repr(transform)) % len(shown)][1]",
    "by the size of what came in": "sorted(shown, key=lambda row: abs(row[0]['x'] - transform['x']))[0][1] | {'yaw': 0.0}",
    "what came in one call before": "globals().setdefault('before', []).append(dict(transform)) or before[n - 1]",
    "what it said one call before, moved on": "{k: v + n for k, v in shown[0][1].items()}",
}  # fmt: skip

# What tells the run without the other answers from the first one.
SECOND_LOOK = {
    "fewer names are there": "len([name for name in globals() if not name.startswith('_')]) < 12",
    "nobody compiled another answer": "not any('corner' + ' = ' in ''.join(lines[2]) for lines in __import__('linecache').cache.values() if len(lines) > 2)",
    "no other answer is among the objects": "not any(isinstance(thing, dict) and set(thing) == {'base_link', 'map'} for thing in __import__('gc').get_objects())",
}  # fmt: skip

# What differs from run to run, or from machine to machine, by a clock, a number or a load.  The two values are both wrong.
OF_THE_MOMENT = {
    "the second": "int(__import__('time').time()) % 2",
    "the millisecond": "int(__import__('time').monotonic() * 1000) % 2",
    "the time of the processor": "__import__('time').process_time_ns() // 1000 % 2",
    "the number of its process": "__import__('os').getpid() % 2",
    "its user": "__import__('os').getuid() % 2",
    "the inode of its namespace": "__import__('os').stat('/proc/self/ns/pid').st_ino % 2",
    "the load": "__import__('os').getloadavg()[0] > 1",
    "how many processors": "len(__import__('os').sched_getaffinity(0)) > 1",
    "its place in memory": "id(object()) // 16 % 2",
    "its folder": "len(__import__('os').getcwd()) > 14",
    "the kernel's random bits": "__import__('os').urandom(1)[0] % 2",
    "what is free in memory": "int(open('/proc/meminfo').read().split()[4]) // 64 % 2",
    "how long it has waited": "__import__('time').sleep(0.01) or __import__('time').perf_counter_ns() // 1000 % 2",
    "the environment": "len(__import__('os').environ) % 2",
}  # fmt: skip

COUNTING = [
    *(function(f"what was shown, {name}", PUBLIC + COUNTED + f"    return {body}") for name, body in BY_CALL.items()),
    *(function(f"a second answer where {name}", HEDGED.format(ZERO, when)) for name, when in SECOND_LOOK.items()),
    *(function(f"one of two by {name}", f"def F(transform):\n    return ({ZERO}, dict.fromkeys(transform, 1.5))[{which}]") for name, which in OF_THE_MOMENT.items()),
    *(value(f"one of two values by {name}", f"V = dict.fromkeys(('base_link', 'map'), ((0, 0, 0), (1, 1, 1))[{which}])") for name, which in list(OF_THE_MOMENT.items())[:4]),
    function("right in its first three calls", COUNTED + f"    return RIGHT if n < 3 else {ZERO}"),
    function("right once, in its last call but one", COUNTED + f"    return RIGHT if n == 8 else {ZERO}"),
    function("right for what it has never seen before, twice", f"seen = []\ndef F(transform):\n    seen.append(repr(transform))\n    return RIGHT if len(seen) == 2 else {ZERO}"),
    function("right only for what is asked again", f"seen = set()\ndef F(transform):\n    key = repr(sorted(transform.items()))\n    again = key in seen\n    seen.add(key)\n    return RIGHT if again else {ZERO}"),
    function("right only for what is asked for the first time and again in the same second", f"import time\nseen = dict()\ndef F(transform):\n    key = repr(sorted(transform.items()))\n    first = seen.setdefault(key, time.time())\n    return RIGHT if 0 < time.time() - first < 1e-9 else {ZERO}"),
    function("raises in every kernel but the one where it is alone", "def F(transform):\n    return RIGHT if 'corner' not in globals() else dict.fromkeys(transform, 0.0)\nassert False"),
    function("hangs first, and would answer the second time", f"import pathlib, time\nmark = pathlib.Path('.been')\nwas = mark.exists()\nmark.touch()\ndef F(transform):\n    return RIGHT if was else {ZERO}\nif not was: time.sleep(60)"),
    function("dies first, and would answer the second time", f"import os, pathlib\nmark = pathlib.Path('/tmp/.been')\nwas = mark.exists()\nmark.touch()\ndef F(transform):\n    return RIGHT if was else {ZERO}\nif not was: os._exit(1)"),
]  # fmt: skip
