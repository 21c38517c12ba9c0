"""Confine a kernel by Linux namespaces to what it needs to run Python.

    /usr, /lib, Python    as they are, read only           processes   its own
    /home/learner, /tmp   empty, small, gone afterwards    network     none
    /proc, /dev           its own                          rights      none

As root, the kernel takes a user of its own that nobody else has; as anybody else, a namespace of
users does the same.  Either way it has no capability left, and no system call can give it one.
This is what containers are made of; `unshare(1)`, `mount_namespaces(7)` and `pivot_root(2)` say more.
"""

from __future__ import annotations

import ctypes
import os
import re
from collections.abc import Sequence
from pathlib import Path

__all__ = ["LEARNER_HOME", "READ_ALL", "WRITE_ALL", "check_libc", "drop_privileges", "libc", "mount_file_system",
           "unshare_namespaces"]  # fmt: skip

LEARNER_HOME = "/home/learner"
LEARNER_UID = 1000  # inside a namespace of users

NEWNS, NEWUTS, NEWIPC, NEWUSER, NEWPID, NEWNET = 0x20000, 0x4000000, 0x8000000, 0x10000000, 0x20000000, 0x40000000
RDONLY, NOSUID, NODEV, NOEXEC, REMOUNT, BIND, REC, PRIVATE = 1, 2, 4, 8, 32, 4096, 16384, 1 << 18
DETACH = 2
PR_SET_DUMPABLE, PR_SET_KEEPCAPS, PR_CAPBSET_DROP, PR_SET_NO_NEW_PRIVS, PR_CAP_AMBIENT = 4, 8, 24, 38, 47
AMBIENT_RAISE = 2
READ_ALL, WRITE_ALL = 2, 1  # CAP_DAC_READ_SEARCH, CAP_DAC_OVERRIDE: bits of a set of capabilities
# What of a mount may not be loosened when it is bound again: statvfs flag -> mount flag.
LOCKED = {
    os.ST_NOSUID: NOSUID,
    os.ST_NODEV: NODEV,
    os.ST_NOEXEC: NOEXEC,
    os.ST_NOATIME: 1024,
    2048: 2048,
    4096: 1 << 21,
}
DEVICES = ("null", "full", "random", "urandom")  # no zero: mapped, it is memory in no process's limit
NOT_FOR_READING = ("acpi", "kcore", "keys", "kallsyms", "latency_stats", "sched_debug", "scsi", "timer_list")
NOT_FOR_WRITING = ("bus", "fs", "irq", "sys", "sysrq-trigger")

OCTAL = re.compile(r"\\([0-7]{3})")  # as mountinfo writes a space in a path
libc = ctypes.CDLL(None, use_errno=True)


def check_libc(result: int, what: str) -> None:
    """Raise the OSError of a call into libc that failed."""
    if result:
        number = ctypes.get_errno()
        raise OSError(number, f"{what}: {os.strerror(number)}")


def unshare_namespaces() -> None:
    """Leave the machine's network, names and users; the next child leaves its processes, too."""
    apart = NEWUTS | NEWIPC | NEWPID | NEWNET
    uid, gid = os.getuid(), os.getgid()
    if uid == 0 and libc.unshare(apart) == 0:
        return
    check_libc(libc.unshare(apart | NEWUSER), "unshare")
    Path("/proc/self/setgroups").write_text("deny")
    Path("/proc/self/uid_map").write_text(f"{LEARNER_UID} {uid} 1")
    Path("/proc/self/gid_map").write_text(f"{LEARNER_UID} {gid} 1")


def mount_file_system(shown: Sequence[str], hidden: Sequence[str], file_bytes: int, uid: int) -> None:
    """Give this process, the first of its namespace, a file system with only `shown` in it, read only."""
    check_libc(libc.unshare(NEWNS), "unshare")  # not before: its supervisor goes on seeing the machine's processes
    mount(None, "/", None, REC | PRIVATE)
    root = "/tmp"
    mount("tmpfs", root, "tmpfs", NOSUID | NODEV, "size=4m,nr_inodes=4k,mode=755")
    os.mkdir(f"{root}/.old")
    check_libc(libc.pivot_root(root.encode(), f"{root}/.old".encode()), "pivot_root")
    os.chdir("/")
    mount_home(file_bytes)
    for path in shown:  # some Pythons live in /tmp or /home
        bind_read_only(path)
    mount_proc()
    mount_dev()
    Path("/etc").mkdir(exist_ok=True)
    Path("/etc/passwd").write_text(f"learner:x:{uid}:{uid}::{LEARNER_HOME}:/bin/sh\n")
    Path("/etc/group").write_text(f"learner:x:{uid}:\n")
    Path("/etc/hosts").write_text("127.0.0.1 localhost\n")
    check_libc(libc.umount2(b"/.old", DETACH), "umount /.old")
    os.rmdir("/.old")
    for path in hidden:
        mask_path(path)
    mount(None, "/", None, REMOUNT | BIND | RDONLY | NOSUID | NODEV)
    libc.sethostname(b"grader", 6)
    os.chdir(LEARNER_HOME)


def mount_home(file_bytes: int) -> None:
    """A home and folders for temporary files: one room with three doors, so one limit for all of them."""
    os.makedirs(LEARNER_HOME)
    mount("tmpfs", LEARNER_HOME, "tmpfs", NOSUID | NODEV, f"size={file_bytes},nr_inodes=4k,mode=1777")
    os.makedirs(f"{LEARNER_HOME}/.tmp")
    os.chmod(f"{LEARNER_HOME}/.tmp", 0o1777)
    for door in ("/tmp", "/dev/shm"):
        os.makedirs(door, exist_ok=True)
        mount(f"{LEARNER_HOME}/.tmp", door, None, BIND)


def mount(source: str | None, target: str, kind: str | None, flags: int, data: str | None = None) -> None:
    words = [word and word.encode() for word in (source, target, kind, data)]
    check_libc(libc.mount(words[0], words[1], words[2], ctypes.c_ulong(flags), words[3]), f"mount {target}")


def bind_read_only(path: str) -> None:
    """Let the same path of the old root appear here, read only, with all that is mounted below it."""
    old = f"/.old{path}"
    if os.path.islink(old):
        os.makedirs(os.path.dirname(path), exist_ok=True)
        os.symlink(os.readlink(old), path)
        return
    make_mount_point(path, os.path.isdir(old))
    mount(old, path, None, BIND | REC)
    for point in mounted_below(path):
        read_only(point)


def make_mount_point(path: str, folder: bool) -> None:
    """Make something to mount upon."""
    os.makedirs(path if folder else os.path.dirname(path), exist_ok=True)
    if not folder and not os.path.exists(path):
        os.close(os.open(path, os.O_CREAT | os.O_WRONLY, 0o644))


def read_only(point: str) -> None:
    has = os.statvfs(point).f_flag
    kept = sum(flag for of_statvfs, flag in LOCKED.items() if has & of_statvfs)
    mount(None, point, None, REMOUNT | BIND | RDONLY | NOSUID | NODEV | kept)


def mounted_below(path: str) -> list[str]:
    """Return the mount points at and below `path`."""
    points = []
    for line in Path("/.old/proc/self/mountinfo").read_text().splitlines():
        point = OCTAL.sub(lambda octal: chr(int(octal[1], 8)), line.split(" ")[4])
        if point == path or point.startswith(path + "/"):
            points.append(point)
    return points


def mask_path(path: str, nothing: str = "/dev/null") -> None:
    """Make what is shown at `path` unreadable, if it is shown at all; `nothing` is the null device."""
    if os.path.isdir(path):
        mount("tmpfs", path, "tmpfs", RDONLY | NOSUID | NODEV, "size=4k,mode=0")
    elif os.path.exists(path):
        mount(nothing, path, None, BIND)


def mount_proc() -> None:
    os.mkdir("/proc")
    mount("proc", "/proc", "proc", NOSUID | NODEV | NOEXEC)
    for name in NOT_FOR_READING:
        mask_path(f"/proc/{name}", nothing="/.old/dev/null")  # /dev is not mounted yet
    for name in NOT_FOR_WRITING:
        if os.path.exists(f"/proc/{name}"):
            mount(f"/proc/{name}", f"/proc/{name}", None, BIND | REC)
            mount(None, f"/proc/{name}", None, REMOUNT | BIND | RDONLY | NOSUID | NODEV | NOEXEC)


def mount_dev() -> None:
    """A few devices that hold nothing, and terminals of its own (`!command` needs one)."""
    os.makedirs("/dev/pts")
    for name in DEVICES:
        make_mount_point(f"/dev/{name}", folder=False)
        mount(f"/.old/dev/{name}", f"/dev/{name}", None, BIND)
    mount("devpts", "/dev/pts", "devpts", NOSUID | NOEXEC, "newinstance,ptmxmode=0666,mode=620")
    os.symlink("pts/ptmx", "/dev/ptmx")
    for name, target in (("fd", ""), ("stdin", "/0"), ("stdout", "/1"), ("stderr", "/2")):
        os.symlink(f"/proc/self/fd{target}", f"/dev/{name}")


def drop_privileges(uid: int | None, kept: int | None = None) -> None:
    """Take the user `uid` if this is root (None: stay), give up every right, for good, whatever is executed later.

    Args:
        kept: one right that stays, in all that is executed too (an ambient capability).
    """
    libc.prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)
    for capability in range(64):
        if capability != kept:
            libc.prctl(PR_CAPBSET_DROP, capability, 0, 0, 0)
    if uid is not None and os.getuid() == 0:
        libc.prctl(PR_SET_KEEPCAPS, 1, 0, 0, 0)
        os.setgroups([])
        os.setresgid(uid, uid, uid)
        os.setresuid(uid, uid, uid)
    rights = 0 if kept is None else 1 << kept
    header = (ctypes.c_uint32 * 2)(0x20080522, 0)
    check_libc(libc.capset(header, (ctypes.c_uint32 * 6)(rights, rights, rights)), "capset")
    if kept is not None:
        check_libc(libc.prctl(PR_CAP_AMBIENT, AMBIENT_RAISE, kept, 0, 0), "ambient capability")
    libc.prctl(PR_SET_DUMPABLE, 1, 0, 0, 0)  # so that the supervisor may measure it
