"""What is in this zip?  Names that stay inside it, files no larger than they may be; a line for the rest.

    kim_1_2_03.ipynb          a file
    ../../etc/passwd          refused: it leads out of the archive
    link -> /home/you         refused: a link
    zeros.ipynb  42 kB -> 4 GB    refused when it is read: too large

Nothing is ever unpacked to a disk.  Names that Windows wrote in Korean are read
as it meant them.  Read `roster.py` next.
"""

from __future__ import annotations

import io
import lzma
import stat
import struct
import zipfile
import zlib
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import IO

from .reader import MAX_BYTES, Unreadable, too_large
from .remarks import Remark, printable

__all__ = ["Member", "archive_members", "is_zip_name", "safe_parts"]

MAX_MEMBERS = 200_000
MAX_ARCHIVE = 64 * 1024 * 1024  # of a zip inside a zip, which is held in memory while it is read
UTF8_NAME, ENCRYPTED = 0x800, 0x1
END_OF_LIST, LONGEST_END = b"PK\5\6", (1 << 16) + 22
LONGEST_ENTRY = 400  # of a zip's list, in the mean [bytes]
BROKEN = (zipfile.BadZipFile, zlib.error, lzma.LZMAError, EOFError, OSError, NotImplementedError, RuntimeError,
          struct.error, ValueError)  # fmt: skip


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
        if entry.is_dir():
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


@lru_cache(maxsize=2)
def _kept_open(source: Path | Callable[[], bytes], most: int, _state: tuple[int, ...] = ()) -> zipfile.ZipFile:
    """Open an archive; its files are read one after the other, and its list may be long."""
    try:
        if not isinstance(source, Path):
            held = io.BytesIO(source())
            _refuse_long_lists(held, most)
            return zipfile.ZipFile(held)
        with open(source, "rb") as file:
            _refuse_long_lists(file, most)
        return zipfile.ZipFile(source)
    except BROKEN as error:
        raise Unreadable("no zip", error=type(error).__name__) from None


def _refuse_long_lists(file: IO[bytes], most: int) -> None:
    """Raise Unreadable if a zip's list is longer than so many names can be: reading it would take long."""
    file.seek(0, io.SEEK_END)
    size = file.tell()
    file.seek(max(0, size - LONGEST_END))
    end = file.read()
    at = end.rfind(END_OF_LIST)
    if at < 0 or len(end) < at + 20:
        return  # no zip: whoever opens it says so
    count, length = struct.unpack_from("<HI", end, at + 10)
    is_large = count == 0xFFFF or length == 0xFFFFFFFF  # then the true numbers stand elsewhere
    if most < MAX_MEMBERS and (is_large or count > most or length > most * LONGEST_ENTRY):
        raise Unreadable("many files", count=count, most=most)


def _reader(source: Path | Callable[[], bytes], entry: zipfile.ZipInfo) -> Callable[[], bytes]:
    limit = MAX_ARCHIVE if is_zip_name(entry.filename) else MAX_BYTES

    def read() -> bytes:
        if entry.file_size > limit:
            raise too_large(entry.file_size, limit)
        try:
            with _opened(source).open(entry) as file:
                data = file.read(limit + 1)
        except BROKEN as error:
            raise Unreadable("damaged", error=type(error).__name__) from None
        if len(data) > limit:
            raise too_large(len(data), limit)
        return data

    return read


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
