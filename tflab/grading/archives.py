"""What is in this zip?  Names that stay inside it, files no larger than they may be; a line for the rest.

    kim_1_2_03.ipynb          a file
    ../../etc/passwd          refused: it leads out of the archive
    link -> /home/you         refused: a link
    zeros.ipynb  42 kB -> 4 GB    refused when it is read: too large

Nothing is ever unpacked to a disk.  Names that Windows wrote in Korean are read
as it meant them.  Read `reader.py` next.
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
from pathlib import Path

from .reader import MAX_BYTES, Unreadable, too_large

__all__ = ["Member", "archive_members", "is_zip_name", "safe_parts"]

MAX_MEMBERS = 50_000
MAX_ARCHIVE = 200 * 1024 * 1024  # of a zip inside a zip, which is held in memory
UTF8_NAME, ENCRYPTED = 0x800, 0x1
BROKEN = (zipfile.BadZipFile, zlib.error, lzma.LZMAError, EOFError, OSError, NotImplementedError, RuntimeError,
          struct.error, ValueError)  # fmt: skip


@dataclass(frozen=True)
class Member:
    """One file: where it is, and how to read it; reading raises Unreadable."""

    parts: tuple[str, ...]
    read: Callable[[], bytes]


def is_zip_name(name: str) -> bool:
    """Return whether a file calls itself a zip."""
    return name.lower().endswith(".zip")


def archive_members(file: Path | bytes) -> tuple[list[Member], list[str]]:
    """Return the files in a zip, and one line for each that is refused.

    Raises:
        Unreadable: no zip.
    """
    try:
        archive = zipfile.ZipFile(file if isinstance(file, Path) else io.BytesIO(file))
        entries = archive.infolist()
    except BROKEN as error:
        raise Unreadable(f"not a zip file that can be read ({type(error).__name__})") from None
    if len(entries) > MAX_MEMBERS:
        raise Unreadable(f"{len(entries)} files in it, more than {MAX_MEMBERS}")
    members, refused = [], []
    for entry in entries:
        if entry.is_dir():
            continue
        name = _name(entry)
        parts = safe_parts(name)
        if parts is None:
            refused.append(f"{_short(name)}: it leads out of the archive; refused")
        elif stat.S_ISLNK(entry.external_attr >> 16):
            refused.append(f"{_short(name)}: a link to another file; refused")
        elif entry.flag_bits & ENCRYPTED:
            refused.append(f"{_short(name)}: it is locked with a password; refused")
        else:
            members.append(Member(parts, _reader(archive, entry)))
    return members, refused


def safe_parts(name: str) -> tuple[str, ...] | None:
    """Return a name's folders and its file, or None if it leads elsewhere."""
    name = name.replace("\\", "/")
    parts = tuple(part for part in name.split("/") if part not in ("", "."))
    drive = len(name) > 1 and name[1] == ":"
    if name.startswith("/") or drive or ".." in parts or not parts or "\0" in name:
        return None
    return parts


def _reader(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> Callable[[], bytes]:
    limit = MAX_ARCHIVE if is_zip_name(entry.filename) else MAX_BYTES

    def read() -> bytes:
        if entry.file_size > limit:
            raise Unreadable(too_large(entry.file_size, limit))
        try:
            with archive.open(entry) as file:
                data = file.read(limit + 1)
        except BROKEN as error:
            raise Unreadable(f"damaged in the archive ({type(error).__name__})") from None
        if len(data) > limit:
            raise Unreadable(too_large(len(data), limit))
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
    printable = "".join(letter if letter.isprintable() else "?" for letter in name)
    return printable if len(printable) <= 80 else f"{printable[:77]}..."
