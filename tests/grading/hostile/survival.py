"""Attacks on whoever comes after: processes that stay, files that are left, files of others."""

from __future__ import annotations

from .recipe import WRONG, function, value

__all__ = ["SURVIVAL"]


SURVIVAL = [
    value("a daemon of its own", """
import os, sys, time
V = (0, 0, 0)
if os.fork() == 0:
    os.setsid()
    if os.fork() == 0:
        time.sleep(3600)
    os._exit(0)
"""),
    value("a shell that stays", """
import subprocess
subprocess.Popen(['sh', '-c', 'nohup setsid sleep 3600 &'], start_new_session=True)
V = (0, 0, 0)
"""),
    value("a thread that stays", """
import threading, time
threading.Thread(target=time.sleep, args=(3600,)).start()
V = (0, 0, 0)
"""),
    value("kills its parent and everyone", """
import os, signal
V = (0, 0, 0)
for process in (os.getppid(), -1):
    try: os.kill(process, signal.SIGKILL)
    except OSError: pass
""", keeps="any"),
    value("kills whatever it can see", """
import os
V = (0, 0, 0)
for process in range(2, 40000):
    if process != os.getpid():
        try: os.kill(process, 9)
        except OSError: pass
""", keeps="any"),
    value(
        "removes everything",
        "import subprocess\nsubprocess.run('rm -rf / ~ . .. 2>/dev/null', shell=True)\nV = 1",
        keeps="any",
    ),
    value("overwrites tflab", """
import tflab, pathlib
V = (0, 0, 0)
for path in pathlib.Path(tflab.__file__).parent.rglob('*.py'):
    try: path.write_text('raise SystemExit')
    except OSError: pass
"""),
    value("writes to its neighbours", """
import pathlib
V = (0, 0, 0)
for folder in list(pathlib.Path('..').glob('*')) + [pathlib.Path('/tmp'), pathlib.Path('/dev/shm'), pathlib.Path.home()]:
    try: (folder / 'was-here-tflab').write_text('x')
    except OSError: pass
"""),
    value("leaves a start-up file", """
import pathlib
V = (0, 0, 0)
for name in ('.bashrc', '.ipython/profile_default/startup/x.py', '.local/lib/python3.11/site-packages/usercustomize.py'):
    path = pathlib.Path.home() / name
    try: path.parent.mkdir(parents=True, exist_ok=True); path.write_text('x')
    except OSError: pass
"""),
    value("mounts", "import subprocess\nsubprocess.run(['mount', '-t', 'tmpfs', 'none', '/usr'])\nV = 1"),
    function("a task of the loop that stays", "import asyncio\nasync def stay():\n    while True: await asyncio.sleep(0)\nasyncio.get_event_loop().create_task(stay())\n" + WRONG, keeps="any"),
    function("a handler at exit, and one after every fork", "import atexit, os, time\natexit.register(time.sleep, 600)\nos.register_at_fork(after_in_child=lambda: time.sleep(600))\n" + WRONG),
    function("a hundred forks that answer too", "import os\nfor _ in range(5): os.fork()\n" + WRONG, keeps="any"),
    function("a daemon that listens", WRONG + "import os, socket, time\nif os.fork() == 0:\n    os.setsid()\n    s = socket.socket(socket.AF_UNIX); s.bind('\\0tflab-daemon'); s.listen(); time.sleep(600)"),
    function("a finalizer that sleeps", WRONG + "import time\nclass Last:\n    def __del__(self): time.sleep(600)\nLast()"),
    value("a command that stays in the background", "!nohup sleep 1000 &\nV = 1"),
]  # fmt: skip
