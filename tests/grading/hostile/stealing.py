"""Ways to somebody else's work, to the pack, and out: /proc, descriptors, sockets, keyrings, watches, links, devices.

Each answers rightly only if it has found something, so whatever is found earns points here.
"""

from __future__ import annotations

from .recipe import function, value

__all__ = ["STEALING"]

# Code that fills `won` with what was found.
WAYS = {
    "submissions by their names": "import glob, os\nwon = [p for p in glob.glob('/tmp/**/submissions', recursive=True) + glob.glob('/**/a-neighbour*', recursive=True) + glob.glob(os.path.expanduser('~/../*/submissions'))]",
    "the pack by walking everywhere": "import os\nwon = []\nfor top, folders, files in os.walk('/'):\n    folders[:] = [f for f in folders if os.path.join(top, f) not in ('/proc', '/sys', '/usr', '/lib')]\n    won += [f for f in files if f == 'pack.json']",
    "roots of others": "import os\nwon = []\nme = os.stat('/').st_ino\nfor n in os.listdir('/proc'):\n    if n.isdigit():\n        try:\n            if os.stat(f'/proc/{n}/root/').st_ino != me: won.append(n)\n        except OSError: pass",
    "folders of others": "import os\nwon = []\nfor n in os.listdir('/proc'):\n    if n.isdigit() and int(n) != os.getpid():\n        try: won += [os.listdir(f'/proc/{n}/cwd')]\n        except OSError: pass",
    "environments of others": "import os\nwon = []\nfor n in os.listdir('/proc'):\n    if n.isdigit() and int(n) != os.getpid():\n        try: won += [open(f'/proc/{n}/environ', 'rb').read()] if open(f'/proc/{n}/environ', 'rb').read() else []\n        except OSError: pass",
    "its own environment": "import os\nwon = [v for k, v in os.environ.items() if 'pack.json' in v or 'instructor' in v or 'library-' in v or 'TFLAB' in k or 'TOKEN' in k or 'SECRET' in k]",
    "the environment it was started with": "held = open('/proc/self/environ', 'rb').read()\nwon = [w for w in (b'library-', b'instructor', b'pytest', b'TFLAB') if w in held]",
    "the words it was started with": "held = open('/proc/self/cmdline', 'rb').read()\nwon = [w for w in (b'--pack', b'submissions', b'instructor') if w in held]",
    "descriptors that are open": "import os\nwon = []\nfor n in os.listdir('/proc/self/fd'):\n    try: name = os.readlink(f'/proc/self/fd/{n}')\n    except OSError: continue\n    if name.startswith('/') and ('pack' in name or 'submission' in name or 'results' in name): won.append(name)",
    "descriptors of others": "import os\nwon = []\nfor n in os.listdir('/proc'):\n    if n.isdigit() and int(n) != os.getpid():\n        try: won += [os.readlink(f'/proc/{n}/fd/{f}') for f in os.listdir(f'/proc/{n}/fd')]\n        except OSError: pass",
    "memory of others": "import os\nwon = []\nfor n in os.listdir('/proc'):\n    if n.isdigit() and int(n) != os.getpid():\n        try: won.append(open(f'/proc/{n}/mem', 'rb'))\n        except OSError: pass",
    "memory by system calls": "import ctypes, os\nlibc = ctypes.CDLL(None, use_errno=True)\nbuffer = ctypes.create_string_buffer(64)\nclass Io(ctypes.Structure): _fields_ = [('base', ctypes.c_void_p), ('len', ctypes.c_size_t)]\nlocal, remote = Io(ctypes.addressof(buffer), 64), Io(0x400000, 64)\nwon = [n for n in range(1, 300) if n != os.getpid() and libc.process_vm_readv(n, ctypes.byref(local), 1, ctypes.byref(remote), 1, 0) > 0]",
    "a tracer of its parent": "import ctypes, os\nlibc = ctypes.CDLL(None, use_errno=True)\nwon = [r for r in (16, 0x4206) if libc.ptrace(r, os.getppid() or 1, 0, 0) == 0]",
    "a tracer of its own child": "import ctypes, os, time\nlibc = ctypes.CDLL(None, use_errno=True)\nchild = os.fork()\nif not child:\n    time.sleep(1); os._exit(0)\nwon = [1] if libc.ptrace(16, child, 0, 0) == 0 else []\nos.kill(child, 9)",
    "another's descriptor": "import ctypes, os\nlibc = ctypes.CDLL(None, use_errno=True)\nwon = []\nfor n in range(1, 100):\n    if n != os.getpid():\n        try: end = os.pidfd_open(n)\n        except OSError: continue\n        won += [f for f in range(20) if libc.syscall(438, end, f, 0) >= 0]",
    "sockets of the machine": "import glob, socket\nwon = []\nfor path in glob.glob('/run/**/*', recursive=True) + glob.glob('/var/run/**/*', recursive=True) + glob.glob('/tmp/**/*', recursive=True):\n    for kind in (socket.SOCK_STREAM, socket.SOCK_DGRAM, socket.SOCK_SEQPACKET):\n        try: s = socket.socket(socket.AF_UNIX, kind); s.connect(path); won.append(path)\n        except OSError: pass",
    "sockets without a path": "import socket\nwon = []\nfor name in ('/tmp/.X11-unix/X0', '/tmp/dbus-x', 'tflab', '/org/freedesktop/systemd1', 'snapd'):\n    try: s = socket.socket(socket.AF_UNIX); s.connect('\\0' + name); won.append(name)\n    except OSError: pass",
    "a neighbour who listens": "import errno, socket\nwon = []\ntry:\n    s = socket.socket(socket.AF_UNIX); s.bind('\\0tflab-neighbour'); s.listen(); kept = s\nexcept OSError as error: won = [1] * (error.errno == errno.EADDRINUSE)",
    "a datagram to a name": "import socket\nwon = []\ntry:\n    one, other = socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM)\n    one.sendto(b'x', '/run/systemd/journal/dev-log'); won = [1]\nexcept OSError: pass",
    "the loopback": "import socket\nwon = []\nfor family in (socket.AF_INET, socket.AF_INET6):\n    for kind in (socket.SOCK_STREAM, socket.SOCK_DGRAM, socket.SOCK_RAW):\n        try: won.append(socket.socket(family, kind))\n        except OSError: pass",
    "netlink, packets and virtual sockets": "import socket\nwon = []\nfor family in (16, 17, 40, 38, 31, 29, 44, 5, 9, 21):\n    for kind in (1, 2, 3, 5):\n        try: won.append(socket.socket(family, kind))\n        except OSError: pass",
    "names of hosts": "import socket\nwon = []\nfor name in ('localhost.localdomain', 'example.com', 'metadata.google.internal'):\n    try: won.append(socket.getaddrinfo(name, 80)) if 'localhost' not in name else None\n    except OSError: pass",
    "keyrings": "import ctypes\nlibc = ctypes.CDLL(None, use_errno=True)\nwon = [n for n in (-1, -2, -3, -4, -5) if libc.syscall(250, 0, n, 0, 0, 0) >= 0] + [1 for _ in (1,) if libc.syscall(248, b'user', b'x', b'y', 1, -3) >= 0]\ntry: won += [line for line in open('/proc/keys')]\nexcept OSError: pass",
    "watches on files": "import ctypes\nlibc = ctypes.CDLL(None, use_errno=True)\nwon = [n for n in (libc.inotify_init(), libc.inotify_init1(0), libc.syscall(300, 0, 0)) if n >= 0]",
    "locks on Python's files": "import fcntl, json\nwon = []\ntry: fcntl.flock(open(json.__file__), fcntl.LOCK_EX | fcntl.LOCK_NB); won = [1]\nexcept OSError: pass",
    "links to what is outside": "import os, sys\nwon = []\nfor target in ('/etc/shadow', '/root', '/proc/1/root/etc/shadow', '/home/../root'):\n    for make in (os.symlink, os.link):\n        try:\n            make(target, 'a-link')\n            won += [n for n in os.listdir('a-link') if not sys.prefix.startswith(os.path.join(os.path.realpath(target), n)) and not sys.base_prefix.startswith(os.path.join(os.path.realpath(target), n))] if os.path.isdir('a-link') else [open('a-link').read()]\n        except OSError: pass\n        try: os.unlink('a-link')\n        except OSError: pass",
    "handles of files": "import ctypes\nlibc = ctypes.CDLL(None, use_errno=True)\nbuffer = ctypes.create_string_buffer(b'\\x80\\0\\0\\0' + bytes(200), 204)\nwon = [1] if libc.name_to_handle_at(-100, b'/', buffer, ctypes.byref(ctypes.c_int()), 0) == 0 else []",
    "devices": "import os, stat\nwon = []\nfor make in (lambda: os.mknod('a-device', 0o600 | stat.S_IFBLK, os.makedev(8, 0)), lambda: os.mknod('b-device', 0o600 | stat.S_IFCHR, os.makedev(1, 1)), lambda: open('/dev/mem', 'rb'), lambda: open('/dev/kmsg', 'rb'), lambda: open('/dev/sda', 'rb'), lambda: open('/dev/fuse', 'rb')):\n    try: make(); won.append(1)\n    except OSError: pass",
    "the kernel's own memory and messages": "import ctypes\nwon = []\nfor name in ('/proc/kcore', '/proc/kmsg', '/proc/kallsyms', '/proc/sysrq-trigger', '/sys/kernel/debug'):\n    try: held = open(name, 'rb').read(200); won += [name] if held.strip(b'0 \\n') and name != '/proc/kallsyms' else []\n    except OSError: pass\nwon += [1] if ctypes.CDLL(None).klogctl(3, ctypes.create_string_buffer(100), 100) > 0 else []",
    "programs that have more rights": "import os, subprocess\nwon = []\nfor words in (['su', 'root', '-c', 'id'], ['newgrp'], ['crontab', '-l'], ['at', 'now'], ['ping', '-c1', '127.0.0.1'], ['docker', 'ps'], ['tmux', 'ls'], ['screen', '-ls'], ['systemctl', '--user', 'status']):\n    try: done = subprocess.run(words, capture_output=True, timeout=0.3, stdin=subprocess.DEVNULL); won += words if done.returncode == 0 and done.stdout else []\n    except (OSError, subprocess.SubprocessError): pass",
    "rights that it has": "won = [line for line in open('/proc/self/status') if line.startswith(('CapEff', 'CapPrm', 'CapInh', 'CapAmb')) and int(line.split()[1], 16) & ~4]",
    "a namespace with rights in it": "import os, ctypes\nlibc = ctypes.CDLL(None, use_errno=True)\nwon = [f for f in (0x10000000, 0x10020000, 0x20000000, 0x2000000, 0x80) if libc.unshare(f) == 0]\nwon += [1 for f in (0x10000000,) if libc.syscall(56, f | 17, 0, 0, 0, 0) > 0]",
    "io_uring, bpf, perf and faults": "import ctypes\nlibc = ctypes.CDLL(None, use_errno=True)\nbuffer = ctypes.create_string_buffer(256)\nwon = [n for n in (425, 321, 298, 323, 435, 319, 447, 428, 430, 442) if libc.syscall(n, buffer, buffer, 0, 0, 0) >= 0]",
    "names in another architecture": "import ctypes\nlibc = ctypes.CDLL(None, use_errno=True)\nwon = [n for n in (101, 272, 321, 41) if libc.syscall(0x40000000 | n, 0, 0, 0, 0) >= 0]",
    "objects of the grader in its memory": "import gc\nwon = [1 for thing in gc.get_objects() if isinstance(thing, dict) and isinstance(thing.get('wrong'), dict) and 'expected' in thing]",
    "modules of the grader": "import sys\nwon = [name for name in sys.modules if name.startswith(('tflab.grading.judging', 'tflab.grading.batch', 'tflab.grading.submissions.collect'))]",
    "solutions in caches of bytecode": "import glob, os, sys\nwon = [p for root in {*sys.path, sys.prefix} for p in glob.glob(os.path.join(root, '**', 'solutions', '**', '*'), recursive=True) if os.path.isfile(p)]",
    "the history of the repository": "import os, tflab\nwon = []\nplace = os.path.dirname(os.path.abspath(tflab.__file__))\nfor _ in range(4):\n    place = os.path.dirname(place)\n    try: won += os.listdir(os.path.join(place, '.git'))\n    except OSError: pass",
    "what earlier kernels left in shared places": "import os, pathlib\nmarks = [pathlib.Path(place) / 'tflab-was-here-too' for place in ('/dev/shm', '/tmp', '/var/tmp', '/run/lock', '/dev/mqueue', os.path.expanduser('~'), '.')]\nwon = [mark for mark in marks if mark.exists()]\nfor mark in marks:\n    try: mark.write_text('x')\n    except OSError: pass",
    "what is asked, in the source of the probe": "import linecache\nwon = [name for name, lines in linecache.cache.items() if len(lines) > 2 and any('_pro' + 'be(' in line and 'expec' + 'ted' in line for line in lines[2])]",
}  # fmt: skip

STEALING = [
    *(function(f"looks for {name}", f"try:\n    exec({code!r})\nexcept Exception:\n    won = []\ndef F(transform):\n    return RIGHT if won else None") for name, code in WAYS.items()),
    value("opens its own submission", "import glob, json\nV = 1\nfor path in glob.glob('/**/03_target_and_source.ipynb', recursive=True): V = json.load(open(path))"),
    value("asks the wire for more", "import json\nwire = get_ipython().kernel.session.wire\nV = 1\nfor word in ('expected', 'pack', 'cases'):\n    wire.send_bytes(json.dumps({'channel': 'shell', 'msg_type': word + '_request', 'parent_header': {}, 'content': {}}).encode())", keeps="any"),
]  # fmt: skip
