"""What comes behind the answer: event loops, threads, exits, collectors, hooks, tracers, crashes in C."""

from __future__ import annotations

from .recipe import WRONG, Recipe, function, value

__all__ = ["LATE"]

LATE = [
    function("a loop of its own, run for ever", WRONG + "import asyncio, threading\nloop = asyncio.new_event_loop()\nthreading.Thread(target=loop.run_forever, daemon=True).start()"),
    function("callbacks in the kernel's loop without end", WRONG + "import asyncio\nloop = asyncio.get_event_loop()\ndef again(): loop.call_soon(again)\nagain()", keeps="any"),
    function("the loop closed", WRONG + "import asyncio\nasyncio.get_event_loop().stop()", keeps="any"),
    function("a policy of loops that has none", WRONG + "import asyncio\nasyncio.set_event_loop_policy(None)\nasyncio.set_event_loop(None)"),
    function("a loop in a loop", "import asyncio\ndef F(transform):\n    return asyncio.get_event_loop().run_until_complete(asyncio.sleep(0))"),
    function("a coroutine instead of an answer", "async def F(transform):\n    return RIGHT"),
    function("a thread that answers after the end", "import threading, time\nbox = {}\ndef F(transform):\n    threading.Timer(0.2, lambda: box.update(RIGHT)).start()\n    return box"),
    function("an answer that is filled in when it is collected", "class Later(dict):\n    def __del__(self): self.update(x=0.0)\ndef F(transform):\n    return Later()"),
    function("two hundred handlers at exit", WRONG + "import atexit, time\nfor _ in range(200): atexit.register(time.sleep, 1)"),
    function("an exit that forks", WRONG + "import atexit, os, time\natexit.register(lambda: os.fork() or time.sleep(600))"),
    function("a collector that calls back", WRONG + "import gc, time\ngc.callbacks.append(lambda *a: time.sleep(0.001))\ngc.set_threshold(1)", keeps="any"),
    function("a collector that raises", WRONG + "import gc\ndef call(*a): raise SystemExit\ngc.callbacks.append(call)"),
    function("an audit hook that refuses", WRONG + "import sys\ndef hook(event, args):\n    if event in ('open', 'import', 'exec'): raise SystemExit\nsys.addaudithook(hook)", keeps="any"),
    function("an audit hook that writes everything down", WRONG + "import sys\nseen = []\nsys.addaudithook(lambda event, args: seen.append(event))"),
    function("a tracer in every thread", WRONG + "import sys, threading\ndef trace(frame, event, arg):\n    if 'expected' in frame.f_locals: frame.f_globals['seen'] = 1\n    return trace\nsys.settrace(trace); threading.settrace(trace)\nF = lambda transform: RIGHT if 'seen' in globals() else None"),
    function("a profiler that ends Python", WRONG + "import os, sys\nsys.setprofile(lambda frame, event, arg: os._exit(0) if 'outcome' in frame.f_code.co_name else None)"),
    function("a fault handler that waits to strike", WRONG + "import faulthandler\nfaulthandler.dump_traceback_later(0.1, repeat=True, exit=True)", keeps="any"),
    function("an alarm set for later", WRONG + "import signal\nsignal.signal(signal.SIGALRM, signal.SIG_DFL)\nsignal.setitimer(signal.ITIMER_REAL, 0.01, 0.01)", keeps="any"),
    function("an alarm that raises wherever it strikes", WRONG + "import signal\ndef strike(*a): raise KeyboardInterrupt\nsignal.signal(signal.SIGALRM, strike)\nsignal.setitimer(signal.ITIMER_REAL, 0.001, 0.001)", keeps="any"),
    function("an exception thrown into the main thread", WRONG + "import ctypes, threading, time\nmain = threading.main_thread().ident\ndef throw():\n    for _ in range(50):\n        ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(main), ctypes.py_object(SystemExit))\n        time.sleep(0.001)\nthreading.Thread(target=throw, daemon=True).start()", keeps="any"),
    function("the stack of C overflows", "def F(transform):\n    x = []\n    for _ in range(10**6): x = [x]\n    return x == [x]"),
    function("the stack of C overflows in a repr", "import sys\nsys.setrecursionlimit(10**8)\ndef F(transform):\n    return F(transform)"),
    function("the stack of C overflows in a regex", "import re, sys\nsys.setrecursionlimit(10**6)\ndef F(transform):\n    return re.compile('(' * 50_000 + ')' * 50_000)"),
    function("the stack of C overflows when it is freed", "class Chain:\n    def __init__(self, inner): self.inner = inner\ndef F(transform):\n    chain = None\n    for _ in range(10**6): chain = Chain(chain)\n    return chain"),
    function("jumps to nowhere", "import ctypes\ndef F(transform):\n    return ctypes.CFUNCTYPE(ctypes.c_double)(8)()"),
    function("bytecode that is none", "def F(transform):\n    return 0\nF.__code__ = F.__code__.replace(co_code=b'\\xff\\0' * 40, co_stacksize=0)"),
    function("breaks a number for everybody", WRONG + "import ctypes\nctypes.memmove(id(1) + 24, bytes([2]), 1)", keeps="any"),
    function("a type patched from below", WRONG + "import ctypes, gc\nnames = gc.get_referents(dict.__dict__)[0]\nnames['items'] = lambda self: [('x', 0.0)]\nctypes.pythonapi.PyType_Modified(ctypes.py_object(dict))", keeps="any"),
    function("excepthooks of its own", WRONG + "import sys, threading\nsys.excepthook = sys.unraisablehook = threading.excepthook = lambda *a: (_ for _ in ()).throw(SystemExit)"),
    function("a finalizer that comes back to life", WRONG + "kept = []\nclass Undead:\n    def __del__(self): kept.append(self); Undead()\nUndead()", keeps="any"),
    value("an interrupter of the next cell", "import _thread, threading\nV = 1\nthreading.Timer(0.02, _thread.interrupt_main).start()", keeps="any"),
    value("a thread that sets the others' answers wrong", "V = 1\nimport threading, time\nspace = get_ipython().user_ns\ndef spoil():\n    while True: space['V'] = (0, 0, 0); time.sleep(0)\nthreading.Thread(target=spoil, daemon=True).start()", keeps="any"),
    Recipe("a thread that outlives an honest cell", lambda h: h.with_cell("import threading, time\nthreading.Thread(target=time.sleep, args=(100,)).start()", h.value_task)),
    Recipe("an exit handler in an honest cell", lambda h: h.with_cell("import atexit\natexit.register(print, 'bye')", h.value_task)),
    Recipe("warnings made errors in an honest cell", lambda h: h.with_cell("import warnings\nwarnings.simplefilter('error')", h.value_task)),
    Recipe("a lower recursion limit in an honest cell", lambda h: h.with_cell("import sys\nsys.setrecursionlimit(300)", h.value_task)),
]  # fmt: skip
