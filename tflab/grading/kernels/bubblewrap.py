"""Start a kernel behind `bwrap`, as a fresh Python that imports everything again.

    bwrap --unshare-all --ro-bind /usr /usr ... -- python -m tflab.grading.kernels.forkserver --one FD

Read `supervisor.py` for what happens to it then.
"""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from .namespaces import LEARNER_HOME, LEARNER_UID

__all__ = ["WITHOUT_THIS_FOLDER", "command", "start"]

WITHOUT_THIS_FOLDER = ("-P",) if sys.version_info >= (3, 11) else ()  # older Pythons start in a folder that is empty


def start(words: Sequence[str], wire: socket.socket, request: Mapping[str, Any]) -> int:
    """Start a kernel in bubblewrap; return the process to kill."""
    module = "tflab.grading.kernels.forkserver"
    program = [sys.executable, *WITHOUT_THIS_FOLDER, "-m", module, "--one", str(wire.fileno()), json.dumps(request)]
    null = subprocess.DEVNULL
    pass_fds = [wire.fileno()]
    return subprocess.Popen([*words, *program], pass_fds=pass_fds, stdin=null, stdout=null, stderr=null, env={}).pid


def command(shown: Sequence[str], hidden: Sequence[str], file_bytes: int, environment: Mapping[str, str]) -> list[str]:
    """Return the words before the program to run."""
    bwrap = shutil.which("bwrap", path="/usr/local/bin:/usr/bin:/bin")
    if bwrap is None:
        raise FileNotFoundError("there is no program bwrap; Debian and Ubuntu have it in the package bubblewrap")
    words = [bwrap, "--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts", "--die-with-parent"]
    words += ["--new-session", "--hostname", "grader", "--clearenv"]
    if os.getuid() == 0:  # it takes a user of its own as soon as it runs; until then it keeps the two rights for that
        words += ["--cap-drop", "ALL", "--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID"]
    else:
        words += ["--unshare-user", "--uid", str(LEARNER_UID), "--gid", str(LEARNER_UID)]
    words += ["--dir", "/home"]
    for folder in ("/tmp", LEARNER_HOME):
        words += ["--perms", "1777", "--size", str(file_bytes), "--tmpfs", folder]
    above = {str(folder) for path in shown for folder in Path(path).parents}
    for folder in sorted(above - {"/", "/tmp", "/home", *shown}):
        words += ["--perms", "0755", "--dir", folder]
    for path in shown:
        words += ["--symlink", os.readlink(path), path] if os.path.islink(path) else ["--ro-bind", path, path]
    words += ["--proc", "/proc", "--dev", "/dev", "--perms", "1777", "--size", str(file_bytes), "--tmpfs", "/dev/shm"]
    words += ["--ro-bind", "/dev/null", "/dev/zero"]  # mapped, it is memory in no process's limit
    for path in hidden:
        if any(path.startswith(f"{folder}/") for folder in shown):
            words += ["--tmpfs", path] if os.path.isdir(path) else ["--ro-bind", "/dev/null", path]
    words += ["--remount-ro", "/", "--chdir", LEARNER_HOME]
    for name, value in {**environment, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}.items():
        words += ["--setenv", name, value]
    return [*words, "--"]
