"""What takes from others: processes, signals, memory, disk, priorities, files of the machine."""

from __future__ import annotations

from .recipe import WRONG, function, value

__all__ = ["HARM"]

FORK = "import os, time\ndef child(body):\n    if os.fork() == 0:\n        try: body()\n        finally: os._exit(0)\n"

HARM = [
    function("forks in its function", "import os\ndef F(transform):\n    os.fork()\n    return None", keeps="any"),
    function("forks until it cannot, then waits", "import os, time\ndef F(transform):\n    try:\n        while os.fork(): pass\n    except OSError: pass\n    time.sleep(30)", keeps="any"),
    function("forks that end their parents", WRONG + "import os, time\nbegin = time.time()\nif os.fork() == 0:\n    while time.time() < begin + 2:\n        if os.fork(): os._exit(0)\n    os._exit(0)"),
    function("shells in shells", WRONG + "!sh -c 'f() { f | f & }; f' >/dev/null 2>&1", keeps="any"),
    function("zombies", WRONG + "import os\nfor _ in range(60):\n    try:\n        if os.fork() == 0: os._exit(0)\n    except OSError: break", keeps="any"),
    function("stopped children", WRONG + FORK + "import signal\nfor _ in range(20): child(lambda: os.kill(os.getpid(), signal.SIGSTOP))"),
    function("children in sessions of their own", WRONG + FORK + "for _ in range(20): child(lambda: (os.setsid(), time.sleep(600)))"),
    function("children that trace their death", WRONG + FORK + "import ctypes\nchild(lambda: (ctypes.CDLL(None).prctl(1, 0, 0, 0, 0), os.setsid(), time.sleep(600)))"),
    function("a subreaper of its own", WRONG + FORK + "import ctypes\nctypes.CDLL(None).prctl(36, 1, 0, 0, 0)\nchild(lambda: child(lambda: time.sleep(600)))"),
    function("vfork and exec", WRONG + "import os\nfor _ in range(10): os.posix_spawn('/bin/sleep', ['sleep', '600'], {})"),
    function("signals to its parent and its group", WRONG + "import os, signal\nfor pid in (os.getppid(), -os.getpgid(0), 0):\n    for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT, signal.SIGSTOP):\n        try: os.kill(pid, number) if pid else None\n        except OSError: pass", keeps="any"),
    function("signals by descriptors and threads", WRONG + "import os, signal, ctypes\nfor pid in range(1, 400):\n    try: signal.pidfd_send_signal(os.pidfd_open(pid), 15) if pid != os.getpid() else None\n    except OSError: pass\n    ctypes.CDLL(None).syscall(200, pid + 100_000, 9)", keeps="any"),
    function("queued signals without end", WRONG + "import ctypes, signal, os\nsignal.pthread_sigmask(signal.SIG_BLOCK, {40})\nlibc = ctypes.CDLL(None)\nfor n in range(10**5): libc.sigqueue(os.getpid(), 40, ctypes.c_void_p(n))"),
    function("first in every queue", WRONG + "import os\nfor change in (lambda: os.nice(-20), lambda: os.setpriority(os.PRIO_USER, 0, -20), lambda: os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(50)), lambda: open('/proc/self/oom_score_adj', 'w').write('-1000')):\n    try: change()\n    except OSError: pass"),
    function("everybody else's priority", WRONG + "import os\nfor pid in range(1, 5000):\n    try: os.setpriority(os.PRIO_PROCESS, pid, 19) if pid != os.getpid() else None\n    except OSError: pass"),
    function("the processors kept busy", WRONG + FORK + "def busy():\n    while True: pass\nfor _ in range(10): child(busy)"),
    function("limits lifted", WRONG + "import resource as r\nfor what in (r.RLIMIT_AS, r.RLIMIT_NPROC, r.RLIMIT_FSIZE, r.RLIMIT_NOFILE, r.RLIMIT_CPU):\n    try: r.setrlimit(what, (r.RLIM_INFINITY, r.RLIM_INFINITY)); V = 1\n    except (OSError, ValueError): pass"),
    function("memory in small pieces", "def F(transform):\n    held = []\n    while True: held.append(object())"),
    function("memory in its text", "def F(transform):\n    return 'x' * (1 << 40)"),
    function("memory in an array of nothing, touched", "import numpy as np\ndef F(transform):\n    return [np.ones(10**8) for _ in range(100)]"),
    function("memory locked", WRONG + "import ctypes, mmap\nctypes.CDLL(None).mlockall(3)\nm = mmap.mmap(-1, 1 << 28, mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS); ctypes.CDLL(None).mlockall(1)"),
    function("memory in files that are removed", WRONG + "import os, tempfile\nheld = []\ntry:\n    while True:\n        f = tempfile.TemporaryFile(); f.write(bytes(8 << 20)); f.flush(); held.append(f)\nexcept OSError: pass", keeps="any"),
    function("memory in a file without a folder", WRONG + "import os\ntry: d = os.memfd_create('x'); [os.write(d, bytes(1 << 20)) for _ in range(3000)]\nexcept OSError: pass", keeps="any"),
    function("holes in files", WRONG + "try:\n    with open('hole', 'wb') as f: f.truncate(1 << 45)\nexcept OSError: pass"),
    function("names as long as they can be", WRONG + "for n in range(3000):\n    try: open(f'{n:0250}', 'w').close()\n    except OSError: break"),
    function("links without end", WRONG + "import os\nopen('one', 'w').close()\nfor n in range(10**5):\n    try: os.link('one', f'l{n}')\n    except OSError: break"),
    function("links in a circle", WRONG + "import os\nos.symlink('b', 'a'); os.symlink('a', 'b'); os.makedirs('c/d'); os.symlink('..', 'c/d/e')"),
    function("attributes of files", WRONG + "import os\nopen('one', 'w').close()\nfor n in range(10**4):\n    try: os.setxattr('one', f'user.{n}', b'x' * 1000)\n    except OSError: break"),
    function("folders that nobody can enter", WRONG + "import os\nos.makedirs('a/b/c'); open('a/b/c/f', 'w').close(); os.chmod('a/b/c', 0); os.chmod('a/b', 0); os.chmod('a', 0)"),
    function("terminals without end", WRONG + "import pty\nheld = []\ntry:\n    while True: held.append(pty.openpty())\nexcept OSError: pass", keeps="any"),
    function("timers and events without end", WRONG + "import ctypes\nlibc = ctypes.CDLL(None)\nfor n in range(10**4): libc.timerfd_create(1, 0); libc.eventfd(0, 0); libc.epoll_create1(0)", keeps="any"),
    function("descriptors on their way", WRONG + "import os, socket\nheld = []\ntry:\n    while True:\n        a, b = socket.socketpair(); socket.send_fds(a, [b'x'], [a.fileno(), b.fileno()]); held += [a, b]\nexcept OSError: pass", keeps="any"),
    function("the clock and the name of the machine", WRONG + "import time, socket\nfor change in (lambda: time.clock_settime(time.CLOCK_REALTIME, 0), lambda: socket.sethostname('owned')):\n    try: change()\n    except OSError: pass"),
    function("Python's own files", WRONG + "import json, os, sys, numpy, tflab\nfor path in (json.__file__, numpy.__file__, tflab.__file__, sys.executable):\n    for change in (lambda: open(path, 'a').write('x'), lambda: os.unlink(path), lambda: os.rename(path, path + '~'), lambda: os.chmod(path, 0o777), lambda: os.utime(path), lambda: os.truncate(path, 0)):\n        try: change()\n        except OSError: pass"),
    function("mapped files of Python, written to", WRONG + "import mmap, json\ntry:\n    with open(json.__file__, 'r+b') as f: mmap.mmap(f.fileno(), 0)[0:1] = b'x'\nexcept OSError: pass"),
    function("files with the rights of others", WRONG + "import os, shutil\nshutil.copy('/bin/sh', 'sh')\nfor mode in (0o4777, 0o2777, 0o6777):\n    try: os.chmod('sh', mode)\n    except OSError: pass\nfor to in (0, 1000):\n    try: os.chown('sh', to, to)\n    except OSError: pass"),
    value("a cell of four megabytes", "V = 1\n" + "# " + "x" * (4 << 20)),
    value("twenty thousand statements", "V = 1\n" + "x = 1\n" * 20_000, keeps="any"),
    value("a cell that fills memory as it is compiled", "V = 1\nx = 0\n" + "x = ((((1 << 60000) << 60000) << 60000) ** 2) * 'x'\n" * 2, keeps="any"),
    value("a number of a million digits as a value", "V = 10 ** 10 ** 6"),
]  # fmt: skip
