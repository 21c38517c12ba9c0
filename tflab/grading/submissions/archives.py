"""Read zips within limits: names that stay inside, sizes that are allowed; a line for the rest.

    kim_1_2_03.ipynb          a file
    ../../etc/passwd          refused: it leads out of the archive
    link -> /home/you         refused: a link
    zeros.ipynb  42 kB -> 4 GB    refused when it is read: too large, however it was packed

Nothing is ever unpacked to a disk, and of nothing more than the limit to memory: of a list of
names as long as no learner's work has, whatever number stands beside it; of files that are
packed by bzip2 or LZMA, which `zipfile` unpacks whole and no learning system writes, nothing.
Names that Windows wrote in Korean are read as it meant them.
"""

from __future__ import annotations

import io
import stat
import weakref
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from .reader import MAX_BYTES, Unreadable, too_large
from .remarks import Remark, printable

__all__ = ["Member", "archive_members", "is_zip_name", "safe_parts"]

MAX_MEMBERS = 200_000
MAX_ARCHIVE = 64 * 1024 * 1024  # of a zip inside a zip, which is held in memory while it is read
UTF8_NAME, ENCRYPTED = 0x800, 0x1
LONGEST_ENTRY = 400  # of a zip's list, in the mean [bytes]
LONGEST_END = 1 << 17  # what stands behind that list [bytes]


@dataclass(frozen=True)
class Member:
    """One file: where it is, and how to read it; reading raises Unreadable.

    Attributes:
        path: that of a file on the disk.
        size: what it has, or, in a zip, says that it has [bytes].
        outside: of a file in somebody's zip, how many of the parts were not named by whoever made the zip; else 0.
    """

    parts: tuple[str, ...]
    read: Callable[[], bytes]
    path: Path | None = None
    size: int = 0
    outside: int = 0


def is_zip_name(name: str) -> bool:
    """Return whether a file calls itself a zip."""
    return name.lower().endswith(".zip")


def archive_members(
    source: Path | Callable[[], bytes], name: str = "", most: int = MAX_MEMBERS
) -> tuple[list[Member], list[Remark]]:
    """Return the files in a zip on the disk, or in one whose bytes can be had, and a remark on each that is refused.

    `name` is the zip's, if it is to stand before theirs; at most `most` files are in it.  Only the last two zips
    stay open, so a thousand of them cost neither memory nor handles, and one with a long list costs no time.

    Raises:
        Unreadable: no zip.
    """
    entries = _opened(source, most).infolist()
    if len(entries) > most:
        raise Unreadable("many files", count=len(entries), most=most)
    members, refused = [], []
    before = f"{name}: " if name else ""
    for entry in entries:
        if entry.filename.endswith("/"):  # a folder; `is_dir` fails where there is no name at all
            continue
        called = _name(entry)
        parts = safe_parts(called)
        reason = _reason_to_refuse(entry, parts)
        if reason:
            refused.append(Remark("file", file=f"{before}{_short(called)}", why=Remark(reason)))
        elif parts is not None:
            members.append(Member(parts, _reader(source, entry), size=entry.file_size))
    return members, refused


def _reason_to_refuse(entry: zipfile.ZipInfo, parts: tuple[str, ...] | None) -> str:
    """Return a kind of remark, or "" for a file that may be read."""
    if parts is None:
        return "leads out"
    if stat.S_ISLNK(entry.external_attr >> 16):
        return "link in a zip"
    return "locked" if entry.flag_bits & ENCRYPTED else ""


def safe_parts(name: str) -> tuple[str, ...] | None:
    """Return a name's folders and its file, or None if it leads elsewhere."""
    name = name.replace("\\", "/")
    parts = tuple(part for part in name.split("/") if part not in ("", "."))
    drive = len(name) > 1 and name[1] == ":"
    if name.startswith("/") or drive or ".." in parts or not parts or "\0" in name:
        return None
    return parts


def _opened(source: Path | Callable[[], bytes], most: int = MAX_MEMBERS) -> zipfile.ZipFile:
    if not isinstance(source, Path):
        return _kept_open(source, most)
    try:
        status = source.lstat()
    except OSError as error:
        raise Unreadable("closed", error=error.strerror) from None
    if not stat.S_ISREG(status.st_mode):
        raise Unreadable("pipe")
    return _kept_open(source, most, (status.st_ino, status.st_mtime_ns, status.st_size))


class _LongList(Exception):
    """The list of a zip is longer than so many names can be."""


class _BoundedZip(io.BufferedReader):
    """A zip of which no more is read at once than `longest`, if that is set."""

    longest: int | None = None

    def read(self, size: int | None = -1, /) -> bytes:
        if self.longest is not None and size is not None and size > self.longest:
            raise _LongList
        return super().read(size)


@lru_cache(maxsize=2)
def _kept_open(source: Path | Callable[[], bytes], most: int, _state: tuple[int, ...] = ()) -> zipfile.ZipFile:
    """Open an archive; its files are read one after the other, and its list, which is read at once, may be long."""
    try:
        held = _BoundedZip(io.FileIO(source) if isinstance(source, Path) else io.BytesIO(source()))
    except OSError as error:
        raise Unreadable("closed", error=error.strerror) from None
    try:
        held.longest = most * LONGEST_ENTRY + LONGEST_END
        archive = zipfile.ZipFile(held)
    except _LongList:
        held.close()
        raise Unreadable("many names", most=most) from None
    except Exception as error:  # whatever its numbers lead to
        held.close()
        raise Unreadable("no zip", error=type(error).__name__) from None
    held.longest = None
    weakref.finalize(archive, held.close)
    return archive


def _reader(source: Path | Callable[[], bytes], entry: zipfile.ZipInfo) -> Callable[[], bytes]:
    limit = MAX_ARCHIVE if is_zip_name(entry.filename) else MAX_BYTES

    def read() -> bytes:
        if entry.file_size > limit:
            raise too_large(entry.file_size, limit)
        try:
            data = _unpacked(_opened(source), entry, limit)
        except Unreadable:
            raise
        except Exception as error:  # an OverflowError, say: a file can be said to begin anywhere
            raise Unreadable("damaged", error=type(error).__name__) from None
        if len(data) > limit:
            raise too_large(len(data), limit)
        return data

    return read


def _unpacked(archive: zipfile.ZipFile, entry: zipfile.ZipInfo, limit: int) -> bytes:
    """Return what a file in a zip holds, and no more of it than a byte above the limit."""
    if entry.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise NotImplementedError("a way of packing that `zipfile` unpacks whole, or not at all")
    with archive.open(entry) as file:
        return file.read(limit + 1)


def _name(entry: zipfile.ZipInfo) -> str:
    """Return a name as its writer meant it: zip says cp437 for all that is not marked as UTF-8."""
    if entry.flag_bits & UTF8_NAME:
        return entry.filename
    try:
        raw = entry.orig_filename.encode("cp437")
    except UnicodeEncodeError:
        return entry.filename
    for encoding in ("utf-8", "cp949"):
        try:
            return raw.decode(encoding)
        except UnicodeDecodeError:
            continue
    return entry.filename


def _short(name: str) -> str:
    shown = printable(name)
    return shown if len(shown) <= 80 else f"{shown[:77]}..."
