"""Confine a process to files by Landlock, where the machine gives no namespaces.

    rules = what is shown: read · its own folder: all · a few devices: read, write
    abi() = 6 or more: it also signals nobody outside and connects to nobody

This needs no right at all, and works in most containers.  A confined process can neither trace
nor read the memory of one that is not.  `landlock(7)` says more.
"""

from __future__ import annotations

import ctypes
import os
import struct
from collections.abc import Iterator, Sequence
from pathlib import Path

from .namespaces import libc

__all__ = ["CONFINES", "abi", "confine"]

CONFINES = 6  # from this version on: files, TCP, signals, abstract sockets
CREATE, ADD_RULE, RESTRICT = 444, 445, 446
VERSION, PATH_BENEATH = 1, 1
EXECUTE, WRITE, READ, LIST, TRUNCATE, DEVICE = 1 << 0, 1 << 1, 1 << 2, 1 << 3, 1 << 14, 1 << 15
OF_A_FILE = EXECUTE | WRITE | READ | TRUNCATE | DEVICE
ALL_OF_FILES = (1 << 16) - 1
TCP, SIGNALS_AND_SOCKETS = 3, 3
# No shm: all share it. No terminals: whoever grades types into one, and a rule for a new one is a rule for all.
DEVICES = ("/dev/null", "/dev/full", "/dev/random", "/dev/urandom")


def abi() -> int:
    """Return the version of Landlock that this machine has; 0 if it has none."""
    return max(0, libc.syscall(CREATE, None, ctypes.c_size_t(0), ctypes.c_uint32(VERSION)))


def confine(shown: Sequence[str], hidden: Sequence[str], folder: str) -> bool:
    """Confine this process, and all that it starts, for good; return False where that cannot be done."""
    if abi() < CONFINES:
        return False
    attributes = struct.pack("QQQ", ALL_OF_FILES, TCP, SIGNALS_AND_SOCKETS)
    rules = libc.syscall(CREATE, attributes, ctypes.c_size_t(len(attributes)), ctypes.c_uint32(0))
    if rules < 0:
        return False
    for path, rights in allowed(shown, hidden, folder):
        rule(rules, path, rights)
    done = libc.syscall(RESTRICT, rules, ctypes.c_uint32(0)) == 0
    os.close(rules)
    return done


def allowed(shown: Sequence[str], hidden: Sequence[str], folder: str) -> Iterator[tuple[str, int]]:
    """Yield what may be done where."""
    yield folder, ALL_OF_FILES
    yield "/proc", READ | LIST
    for device in DEVICES:
        yield device, ALL_OF_FILES & ~EXECUTE
    for path in shown:
        yield from readable(Path(path), tuple(map(Path, hidden)))


def readable(path: Path, hidden: tuple[Path, ...]) -> Iterator[tuple[str, int]]:
    """Yield rules to read `path` and all below it except what is hidden; a right given above cannot be taken back."""
    if path in hidden:
        return
    if not any(path in secret.parents for secret in hidden):
        yield str(path), EXECUTE | READ | LIST
        return
    yield str(path), LIST
    for child in sorted(path.iterdir()):
        yield from readable(child, hidden)


def rule(rules: int, path: str, rights: int) -> None:
    """Add one rule; what is not there needs none."""
    try:
        place = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except OSError:
        return
    if not os.path.isdir(path):
        rights &= OF_A_FILE
    libc.syscall(ADD_RULE, rules, PATH_BENEATH, struct.pack("=Qi", rights, place), ctypes.c_uint32(0))
    os.close(place)
