"""Refuse system calls that no answer needs and that attacks begin with.

    mount, unshare, ptrace, bpf, ...     EPERM
    memfd_create, vmsplice, ...          EPERM (memory that is in no process, and so in nobody's limit)
    semget, shmget, msgget, ...          EPERM (the same, and it outlives whoever made it: System V's)
    landlock_create_ruleset, ...         EPERM (the same: a list of rules takes 4 MB, and there may be thousands)
    mmap that forks share, of no file    EPERM (the same)
    kill(-1)                             EPERM (that is everybody)
    clone with a new namespace           EPERM
    clone3                               ENOSYS (its flags cannot be seen; libc then uses clone)
    flock, fcntl(F_SETLK, F_NOTIFY), inotify
                                         EPERM (a neighbour would see it on a file of Python's)
    every socket of a network            EAFNOSUPPORT (UDP too: what is on its way is in no process's limit)
    where files are the machine's: a socket that could be connected to a name in them, too

The filter is a small program in the kernel's own language (BPF): it looks at the number of a
call and at one or two of its arguments.  A machine of another architecture goes without.
"""

from __future__ import annotations

import ctypes
import errno
import platform
import struct
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from .namespaces import check_libc, libc

__all__ = ["is_there", "refuse_dangerous_calls"]

ANYWHERE = {
    "io_uring_setup": 425, "io_uring_enter": 426, "io_uring_register": 427, "open_tree": 428, "move_mount": 429,
    "fsopen": 430, "fsconfig": 431, "fsmount": 432, "fspick": 433, "pidfd_getfd": 438, "process_madvise": 440,
    "mount_setattr": 442, "quotactl_fd": 443, "memfd_secret": 447,
    "landlock_create_ruleset": 444, "landlock_add_rule": 445, "landlock_restrict_self": 446,
}  # fmt: skip
X86_64 = {
    "flock": 73, "inotify_init": 253, "inotify_init1": 294, "fanotify_init": 300,
    "shmget": 29, "shmat": 30, "shmctl": 31, "semget": 64, "semop": 65, "semctl": 66, "shmdt": 67, "msgget": 68,
    "msgsnd": 69, "msgrcv": 70, "msgctl": 71, "semtimedop": 220, "mq_open": 240, "vmsplice": 278,
    "memfd_create": 319,
    "ptrace": 101, "pivot_root": 155, "chroot": 161, "acct": 163, "settimeofday": 164, "mount": 165, "umount2": 166,
    "swapon": 167, "swapoff": 168, "reboot": 169, "init_module": 175, "delete_module": 176, "quotactl": 179,
    "clock_settime": 227, "kexec_load": 246, "add_key": 248, "request_key": 249, "keyctl": 250, "unshare": 272,
    "perf_event_open": 298, "name_to_handle_at": 303, "open_by_handle_at": 304, "setns": 308, "process_vm_readv": 310,
    "process_vm_writev": 311, "finit_module": 313, "kexec_file_load": 320, "bpf": 321, "userfaultfd": 323,
}  # fmt: skip
AARCH64 = {
    "inotify_init1": 26, "flock": 32, "fanotify_init": 262,
    "mq_open": 180, "msgget": 186, "msgctl": 187, "msgrcv": 188, "msgsnd": 189, "semget": 190, "semctl": 191,
    "semtimedop": 192, "semop": 193, "shmget": 194, "shmctl": 195, "shmat": 196, "shmdt": 197,
    "memfd_create": 279, "vmsplice": 75,
    "umount2": 39, "mount": 40, "pivot_root": 41, "chroot": 51, "quotactl": 60, "acct": 89, "unshare": 97,
    "kexec_load": 104, "init_module": 105, "delete_module": 106, "clock_settime": 112, "ptrace": 117, "reboot": 142,
    "settimeofday": 170, "add_key": 217, "request_key": 218, "keyctl": 219, "swapon": 224, "swapoff": 225,
    "perf_event_open": 241, "name_to_handle_at": 264, "open_by_handle_at": 265, "setns": 268, "process_vm_readv": 270,
    "process_vm_writev": 271, "finit_module": 273, "bpf": 280, "userfaultfd": 282, "kexec_file_load": 294,
}  # fmt: skip
# Whose a file is, who may read it and how old it is are of no concern to Landlock: where the files are the machine's,
# these calls say that they have done it, and do nothing, as on a disk that knows no such things.
ABOUT_FILES_ANYWHERE = {"fchmodat2": 452, "file_setattr": 469}
ABOUT_FILES_X86_64 = {
    "chmod": 90, "fchmod": 91, "chown": 92, "fchown": 93, "lchown": 94, "utime": 132, "utimes": 235, "fchownat": 260,
    "futimesat": 261, "fchmodat": 268, "utimensat": 280,
}  # fmt: skip
ABOUT_FILES_AARCH64 = {"fchmod": 52, "fchmodat": 53, "fchownat": 54, "fchown": 55, "utimensat": 88}
ATTRIBUTES_ANYWHERE = {"setxattrat": 463, "removexattrat": 466}
ATTRIBUTES_X86_64 = {
    "setxattr": 188, "lsetxattr": 189, "fsetxattr": 190,
    "removexattr": 197, "lremovexattr": 198, "fremovexattr": 199,
}  # fmt: skip
ATTRIBUTES_AARCH64 = {
    "setxattr": 5, "lsetxattr": 6, "fsetxattr": 7,
    "removexattr": 14, "lremovexattr": 15, "fremovexattr": 16,
}  # fmt: skip


class Machine(NamedTuple):
    """How the system names an architecture, what is refused on it, and the numbers of calls that are looked into."""

    name: int
    refused: Mapping[str, int]
    about_files: Mapping[str, int]
    attributes: Mapping[str, int]
    clone: int
    socket: int
    socketpair: int
    kill: int
    mmap: int
    fcntl: int


MACHINES = {
    "x86_64": Machine(
        0xC000003E, {**X86_64, **ANYWHERE}, {**ABOUT_FILES_X86_64, **ABOUT_FILES_ANYWHERE},
        {**ATTRIBUTES_X86_64, **ATTRIBUTES_ANYWHERE}, clone=56, socket=41, socketpair=53, kill=62, mmap=9, fcntl=72,
    ),
    "aarch64": Machine(
        0xC00000B7, {**AARCH64, **ANYWHERE}, {**ABOUT_FILES_AARCH64, **ABOUT_FILES_ANYWHERE},
        {**ATTRIBUTES_AARCH64, **ATTRIBUTES_ANYWHERE}, clone=220, socket=198, socketpair=199, kill=129, mmap=222,
        fcntl=25,
    ),
}  # fmt: skip
CLONE3 = 435
NEW_NAMESPACES = 0x7E020000  # CLONE_NEWNS, NEWCGROUP, NEWUTS, NEWIPC, NEWUSER, NEWPID, NEWNET
AF_UNIX, NO_FAMILY = 1, 0xFFFF
STREAM, SEQUENCED, SOCKET_TYPES = 1, 5, 0xF
# F_GETLK and F_SETLK, with and without waiting, of processes and of files; leases; what happens in a folder (dnotify).
LOCKS = (5, 6, 7, 36, 37, 38, 1024, 1026)
X32 = 0x40000000

SHARED_WITH_FORKS = 0x21  # MAP_SHARED and MAP_ANONYMOUS

LOAD, AND, EQUAL, AT_LEAST, ANY_OF, RETURN = 0x20, 0x54, 0x15, 0x35, 0x45, 0x06
ALLOW, KILL, REFUSE, NO_ERROR = 0x7FFF0000, 0x80000000, 0x00050000, 0
AT_NUMBER, AT_MACHINE, AT_ARGUMENT = 0, 4, (16, 24, 32, 40)
PR_SET_SECCOMP, MODE_FILTER = 22, 2

Step = tuple[int, int, int, int]  # code, jump if true, jump if false, number


def is_there() -> bool:
    """Return whether this machine has a filter."""
    return platform.machine() in MACHINES


def refuse_dangerous_calls(*, names_are_shared: bool = False) -> bool:
    """Install the filter for this process and all that it starts; return whether this machine has one.

    Args:
        names_are_shared: the names in the file system are the machine's; then no socket may be connected to by name,
            and nothing about a file can be changed.
    """
    if not is_there():
        return False
    code = program(MACHINES[platform.machine()], names_are_shared)
    buffer = ctypes.create_string_buffer(code, len(code))
    filter_ = struct.pack("HxxxxxxP", len(code) // 8, ctypes.addressof(buffer))
    check_libc(libc.prctl(PR_SET_SECCOMP, MODE_FILTER, ctypes.create_string_buffer(filter_), 0, 0), "seccomp")
    return True


def program(machine: Machine, names_are_shared: bool) -> bytes:
    """Return the filter."""
    steps = [
        (LOAD, 0, 0, AT_MACHINE),
        (EQUAL, 1, 0, machine.name),
        (RETURN, 0, 0, KILL),
        (LOAD, 0, 0, AT_NUMBER),
        (AT_LEAST, 0, 1, X32),
        (RETURN, 0, 0, REFUSE | errno.ENOSYS),
        (EQUAL, 0, 1, CLONE3),
        (RETURN, 0, 0, REFUSE | errno.ENOSYS),
    ]
    for number in sorted(machine.refused.values()):
        steps += [(EQUAL, 0, 1, number), (RETURN, 0, 0, REFUSE | errno.EPERM)]
    if names_are_shared:
        for number in sorted(machine.about_files.values()):
            steps += [(EQUAL, 0, 1, number), (RETURN, 0, 0, REFUSE | NO_ERROR)]
        for number in sorted(machine.attributes.values()):
            steps += [(EQUAL, 0, 1, number), (RETURN, 0, 0, REFUSE | errno.EOPNOTSUPP)]
    shared_with_forks = (AND, 0, 0, SHARED_WITH_FORKS), (EQUAL, 0, 1, SHARED_WITH_FORKS)
    no_network = (EQUAL, 1, 0, NO_FAMILY if names_are_shared else AF_UNIX)
    steps += [
        *refuse_if(machine.mmap, AT_ARGUMENT[3], *shared_with_forks),
        *refuse_if(machine.kill, AT_ARGUMENT[0], (EQUAL, 0, 1, 0xFFFFFFFF)),
        *refuse_if(machine.clone, AT_ARGUMENT[0], (ANY_OF, 0, 1, NEW_NAMESPACES)),
        *refuse_if(machine.fcntl, AT_ARGUMENT[1], *one_of(LOCKS)),
        *refuse_if(machine.socket, AT_ARGUMENT[0], no_network, error=errno.EAFNOSUPPORT),
    ]
    if names_are_shared:  # a pair that keeps no connection could still be sent to a name
        with_connection = (AND, 0, 0, SOCKET_TYPES), (EQUAL, 2, 0, STREAM), (EQUAL, 1, 0, SEQUENCED)
        steps += refuse_if(machine.socketpair, AT_ARGUMENT[1], *with_connection)
    return b"".join(struct.pack("HBBI", *step) for step in [*steps, (RETURN, 0, 0, ALLOW)])


def refuse_if(call: int, argument: int, *tests: Step, error: int = errno.EPERM) -> list[Step]:
    """Return the steps that refuse a call by one of its arguments; a test that jumps over the refusal allows it."""
    return [
        (EQUAL, 0, len(tests) + 3, call),
        (LOAD, 0, 0, argument),
        *tests,
        (RETURN, 0, 0, REFUSE | error),
        (RETURN, 0, 0, ALLOW),
    ]


def one_of(numbers: Sequence[int]) -> list[Step]:
    """Return the tests that jump over a refusal unless an argument is one of these numbers."""
    last = len(numbers) - 1
    return [(EQUAL, last - place, int(place == last), number) for place, number in enumerate(numbers)]
