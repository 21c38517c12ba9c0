"""Write a file whole or not at all, and lock a folder.

    write_whole(path, text)       a new file beside it takes its place at once: an atomic write
    with locked(folder): ...      one process at a time; the lock ends with whoever holds it

Two notebooks of one learner are two processes, and both write down what was tried.
"""

from __future__ import annotations

import errno
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

__all__ = ["locked", "write_whole"]

LOCK = Path(".tflab", "lock")
NO_LOCKS_HERE = (errno.ENOLCK, errno.ENOSYS, errno.EOPNOTSUPP)


def write_whole(path: Path, text: str | bytes) -> None:
    """Write a file such that it is there as it was or as it will be, whatever happens in between."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.", suffix=".new")
    try:
        with os.fdopen(handle, "wb") as new:
            new.write(text.encode() if isinstance(text, str) else text)
            new.flush()
            os.fsync(new.fileno())
        with suppress(OSError):  # a share may have no such rights
            os.chmod(name, path.stat().st_mode if path.exists() else 0o644)
        _replace(name, path)
    except BaseException:
        with suppress(OSError):
            os.unlink(name)
        raise


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Wait until no other process holds the folder, and hold it for as long as the context lasts.

    Where the file system has no locks, as some shares have none, it goes on without.
    """
    path = folder / LOCK
    path.parent.mkdir(exist_ok=True)
    with path.open("a+b") as file:
        _hold(file.fileno())
        yield  # closing the file lets go


if os.name == "nt":
    import msvcrt
    import time

    def _replace(new: str, path: Path) -> None:
        for _ in range(100):  # Windows refuses while somebody reads the old one
            try:
                return os.replace(new, path)
            except PermissionError:
                time.sleep(0.02)
        return os.replace(new, path)

    def _hold(handle: int) -> None:
        for _ in range(600):  # half a minute: a share without locks refuses for ever
            try:
                os.lseek(handle, 0, os.SEEK_SET)
                return msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
            except OSError:
                time.sleep(0.05)
        return None

else:
    import fcntl

    def _replace(new: str, path: Path) -> None:
        os.replace(new, path)

    def _hold(handle: int) -> None:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX)
        except OSError as error:
            if error.errno not in NO_LOCKS_HERE:
                raise
