"""How is a kernel started behind `bwrap`?  As a fresh Python: nothing can be forked into it, so it imports all again.

    bwrap --unshare-all --ro-bind /usr /usr ... -- python -m tflab.grading.forkserver --one FD

Read `keeper.py` for what happens to it then.
"""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import sys
from collections.abc import Mapping
from typing import Any

from .limits import Limits
from .namespaces import LEARNER_HOME, LEARNER_UID

__all__ = ["command", "start"]


def start(
    order: Mapping[str, Any], wire: socket.socket, limits: Limits, uid: int, environment: Mapping[str, str]
) -> int:
    """Start a kernel in bubblewrap; return the process to kill."""
    words = command(order["shown"], order["hidden"], limits, environment, root=os.getuid() == 0)
    inside = {"limits": order["limits"], "uid": uid}
    words += [sys.executable, "-P", "-m", "tflab.grading.forkserver", "--one", str(wire.fileno()), json.dumps(inside)]
    devnull = subprocess.DEVNULL
    return subprocess.Popen(words, pass_fds=[wire.fileno()], stdin=devnull, stdout=devnull, stderr=devnull, env={}).pid


def command(
    shown: list[str], hidden: list[str], limits: Limits, environment: Mapping[str, str], *, root: bool
) -> list[str]:
    """Return the words before the program to run."""
    bwrap = shutil.which("bwrap", path="/usr/local/bin:/usr/bin:/bin")
    if bwrap is None:
        raise FileNotFoundError("there is no program bwrap; Debian and Ubuntu have it in the package bubblewrap")
    words = [bwrap, "--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts", "--die-with-parent"]
    words += ["--new-session", "--hostname", "grader", "--clearenv"]
    if root:  # it takes a user of its own as soon as it runs; for that it keeps these two rights until then
        words += ["--cap-drop", "ALL", "--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID"]
    else:
        words += ["--unshare-user", "--uid", str(LEARNER_UID), "--gid", str(LEARNER_UID)]
    for path in shown:
        words += ["--symlink", os.readlink(path), path] if os.path.islink(path) else ["--ro-bind", path, path]
    words += [
        "--proc",
        "/proc",
        "--dev",
        "/dev",
        "--perms",
        "1777",
        "--size",
        str(limits.file_bytes),
        "--tmpfs",
        "/tmp",
    ]
    words += ["--dir", "/home", "--perms", "1777", "--size", str(limits.file_bytes), "--tmpfs", LEARNER_HOME]
    for path in hidden:
        if any(path.startswith(f"{folder}/") for folder in shown):
            words += ["--tmpfs", path] if os.path.isdir(path) else ["--ro-bind", "/dev/null", path]
    words += ["--remount-ro", "/", "--chdir", LEARNER_HOME]
    for name, value in environment.items():
        words += ["--setenv", name, value]
    return [*words, "--"]
