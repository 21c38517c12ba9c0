"""What no look at memory, files or processes sees: rules, watches, terminals, filters, timers; and processes apart."""

from __future__ import annotations

from .recipe import WRONG, function

__all__ = ["UNSEEN"]

LIBC = "import ctypes, os, struct\nlibc = ctypes.CDLL(None, use_errno=True)\n"
RULES = (
    LIBC
    + "def rules(ports):\n    made = libc.syscall(444, struct.pack('QQQ', 0, 3, 0), ctypes.c_size_t(24), ctypes.c_uint32(0))\n    return made >= 0 and all(libc.syscall(445, made, 2, struct.pack('QQ', 1, port), ctypes.c_uint32(0)) == 0 for port in range(ports))\n"
)

# Code that fills `won` with what must not be had.
MUST_NOT_BE = {
    "rules of Landlock": RULES + "won = [1] if rules(2) else []",
    "what happens in a folder of Python's": "import fcntl, os, json\nwon = []\ntry: fcntl.fcntl(os.open(os.path.dirname(json.__file__), os.O_RDONLY), fcntl.F_NOTIFY, fcntl.DN_ACCESS); won = [1]\nexcept OSError: pass",
    "a terminal of who grades": "import os, glob\nwon = []\nfor path in [*glob.glob('/dev/pts/[0-9]*'), '/dev/tty', '/dev/console']:\n    for how in (os.O_RDONLY, os.O_WRONLY):\n        try: won.append(os.open(path, how | os.O_NOCTTY | os.O_NONBLOCK))\n        except OSError: pass",
    "names in its mounts": "held = open('/proc/self/mountinfo').read()\nwon = [word for word in ('library-', 'submissions', 'instructor') if word in held]",
    "mounts by the newest calls": LIBC + "won = [n for n in (467, 470) if libc.syscall(n, 0, 0, 0, 0, 0) > 0]",
    "files that are mapped into it": "import os\nwon = [t for n in os.listdir('/proc/self/map_files') for t in [os.readlink(f'/proc/self/map_files/{n}')] if 'pack.json' in t or 'instructor' in t]",
    "tables of others' pages": "import os\nwon = []\nfor n in os.listdir('/proc'):\n    for name in ('stack', 'syscall', 'auxv', 'personality', 'pagemap', 'smaps', 'maps'):\n        try: won += [n] if n.isdigit() and os.stat(f'/proc/{n}').st_uid != os.getuid() and open(f'/proc/{n}/{name}', 'rb').read(64) else []\n        except OSError: pass",
    "what others have open, by kcmp": LIBC + "won = []\nfor n in range(1, 300):\n    try: won += [n] if libc.syscall(312, os.getpid(), n, 0, 0, 0) >= 0 and os.stat(f'/proc/{n}').st_uid != os.getuid() else []\n    except OSError: pass",
    "the limits and the priority of others": "import os, resource\nwon = []\nfor n in map(int, filter(str.isdigit, os.listdir('/proc'))):\n    for change in (lambda: resource.prlimit(n, resource.RLIMIT_NOFILE, (1, 1)), lambda: os.setpriority(0, n, 19)):\n        try: won += [change() or n] if os.stat(f'/proc/{n}').st_uid != os.getuid() else []\n        except (OSError, ValueError): pass",
    "folders above the ones that are open": "import os\nwon = []\nfor n in range(256):\n    for up in ('..', '../..', '../../..'):\n        try: won += [x for x in os.listdir(os.open(up, os.O_RDONLY, dir_fd=n)) if x in ('instructor', 'submissions', 'pack.json')]\n        except OSError: pass",
    "what the forkserver knew": "import gc\nwon = [o for o in gc.get_objects() if isinstance(o, dict) and 'seed' in o and 'release' in o]",
    "a release of its own": "import subprocess, sys\nmade = subprocess.run([sys.executable, '-c', 'import sys; from tflab.cli import main; sys.exit(main())', 'release', 'x', '--chapters', '03'], capture_output=True)\nwon = [1] if made.returncode == 0 else []",
}  # fmt: skip
HELD = {
    "a rule for each port": RULES + "rules(65536)",
    "layers of rules": RULES + "libc.prctl(38, 1, 0, 0, 0)\nfor _ in range(20): libc.syscall(446, libc.syscall(444, struct.pack('Q', 4), ctypes.c_size_t(8), 0), 0)",
    "every descriptor watched by every other": "import select, os\nwatches, held = [select.epoll() for _ in range(100)], [os.eventfd(0) for _ in range(100)] if hasattr(os, 'eventfd') else []\nfor watch in watches:\n    for end in held: watch.register(end, 1)",
    "filters upon filters": LIBC + "libc.prctl(38, 1, 0, 0, 0)\ncode = ctypes.create_string_buffer(struct.pack('HBBI', 6, 0, 0, 0x7FFF0000) * 4000)\nfor _ in range(50): libc.prctl(22, 2, ctypes.create_string_buffer(struct.pack('HxxxxxxP', 4000, ctypes.addressof(code))), 0, 0)",
    "timers of the system": LIBC + "for _ in range(5000): libc.timer_create(1, None, ctypes.byref(ctypes.c_void_p()))",
    "space kept in files that are gone": "import os\nheld = []\ntry:\n    while True:\n        held.append(open(f'r{len(held)}', 'wb')); os.posix_fallocate(held[-1].fileno(), 0, 60 << 20); os.unlink(held[-1].name)\nexcept OSError: pass",
    "files sent into pipes": "import os\nopen('a', 'wb').write(b'x' * (1 << 20))\nheld = []\ntry:\n    while True:\n        r, w = os.pipe(); os.set_blocking(w, False); f = os.open('a', 0); os.sendfile(w, f, 0, 1 << 20); held += [r, w, f]\nexcept OSError: pass",
    "a manager that stays": "import multiprocessing.managers as m\ntry: held = m.SyncManager(); held.start()\nexcept BaseException: pass",
    "a pool that stays": "from concurrent.futures import ProcessPoolExecutor\nimport time\ntry: held = ProcessPoolExecutor(2); held.submit(time.sleep, 60)\nexcept Exception: pass",
    "a fork whenever a child ends": "import os, signal\ndef fork(*_):\n    try: os.fork()\n    except OSError: pass\nsignal.signal(signal.SIGCHLD, fork)\nif os.fork() == 0: os._exit(0)",
    "programs that are spawned": "import os\ntry:\n    for _ in range(60): os.posix_spawn('/bin/sleep', ['sleep', '60'], {})\nexcept OSError: pass",
    "what decides who dies first": "for name in ('oom_score_adj', 'coredump_filter', 'timerslack_ns', 'clear_refs'):\n    for word in ('-1000', '1000', '3'):\n        try: open(f'/proc/self/{name}', 'w').write(word)\n        except OSError: pass",
}  # fmt: skip

UNSEEN = [
    *(function(f"has {name}", f"try:\n    exec({code!r})\nexcept Exception:\n    won = []\ndef F(transform):\n    return RIGHT if won else None") for name, code in MUST_NOT_BE.items()),
    *(function(name, WRONG + code, keeps="any") for name, code in HELD.items()),
]  # fmt: skip
