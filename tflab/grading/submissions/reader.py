"""Read a notebook that was handed in as strings, or say in one line why not.

    path  --read_bytes-->  bytes  --read_notebook-->  SubmittedNotebook(cells=(name, id, kind, source), ...)

Nothing of the file is believed, and nothing of it is run: it is opened without
following links and without waiting for a pipe, read up to a limit, and parsed as
plain JSON.  Whatever is not of the type it should be is left out.  What honest
machines do to notebooks is undone: a byte order mark, UTF-16, Korean code page
949, the third format of 2012.
"""

from __future__ import annotations

import json
import os
import re
import stat
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tflab.workbook.tasks.task import slug

from . import bounded_json
from .remarks import Remark

__all__ = [
    "MAX_BYTES",
    "SubmittedCell",
    "SubmittedNotebook",
    "Unreadable",
    "read_bytes",
    "read_notebook",
    "strip_outputs",
]

UNREAD = {'"outputs"', '"attachments"', '"widgets"'}
# A string that nobody closed ends with the text: else each of its quotes is one more beginning, in a text without end.
TOKEN = re.compile(r'"[^"\\]*(?:\\.[^"\\]*)*(?:"|\\?\Z)|[\[\]{}]', re.DOTALL)
EMPTY = {"[": "[]", "{": "{}"}


def strip_outputs(text: str) -> str:
    """Return a notebook's JSON with what nobody reads emptied; what is no JSON comes back as it was."""
    kept: list[str] = []
    begin, depth = 0, 0  # of what is kept next; of the brackets that are being dropped
    key_end = -1
    for match in TOKEN.finditer(text):
        token = match[0]
        if depth:
            depth += (token in EMPTY) - (token in ("]", "}"))
            begin = match.end()
        elif token in EMPTY and key_end >= 0 and text[key_end : match.start()].strip() == ":":
            kept += [text[begin : match.start()], EMPTY[token]]
            depth = 1
        key_end = match.end() if token in UNREAD and not depth else -1
    return text if depth else "".join([*kept, text[begin:]])


MAX_BYTES = 100 * 1024 * 1024
MAX_CONTAINERS = 1_000_000  # of lists and objects: a parsed one is twenty times as large as its brackets
MAX_CELLS = 10_000
MAX_SOURCE = 200_000  # characters of one cell
MAX_SOURCES = 2_000_000  # of all; what is behind that is cut off
ENCODINGS = ("utf-8", "cp949")
LONGEST_INT = 300  # digits; Python refuses the very long ones, and no notebook needs them


class Unreadable(Exception):
    """This is no notebook that can be graded; `remark` says why, in each language, and the text does in English."""

    def __init__(self, kind: str, **words: object) -> None:
        self.remark = Remark(kind, **words)
        super().__init__(self.remark.say("en"))


@dataclass(frozen=True, slots=True)
class SubmittedCell:
    """One cell: what it calls itself (several claims, the strongest first), and its source."""

    claims: tuple[str, ...]
    kind: str
    source: str


@dataclass(frozen=True, slots=True)
class SubmittedNotebook:
    """A notebook as strings; `stamp` holds what it says of itself: chapter, language, version, learner, release."""

    cells: tuple[SubmittedCell, ...]
    stamp: dict[str, str] = field(default_factory=dict)
    remarks: tuple[Remark, ...] = ()


def read_bytes(path: Path, at_most: int = MAX_BYTES) -> bytes:
    """Return what a regular file holds.

    Raises:
        Unreadable: it is a link, a pipe, a device or a folder; it is too large, or cannot be read.
    """
    try:
        if stat.S_ISLNK(os.lstat(path).st_mode):
            raise Unreadable("link")
        flags = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
        descriptor = os.open(path, flags)
    except (OSError, ValueError) as error:
        raise Unreadable("closed", error=getattr(error, "strerror", None) or error) from None
    try:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode):
            raise Unreadable("no file there")
        if status.st_size > at_most:
            raise too_large(status.st_size, at_most)
        with os.fdopen(descriptor, "rb", closefd=False) as file:
            data = file.read(at_most + 1)
    except OSError as error:
        raise Unreadable("not read", error=error.strerror) from None
    finally:
        os.close(descriptor)
    if len(data) > at_most:
        raise too_large(len(data), at_most)
    return data


def too_large(size: int, at_most: int) -> Unreadable:
    """Return what to raise for a file above the limit; both are bytes."""
    megabytes = 1024 * 1024
    return Unreadable("too large", size=f"{size / megabytes:.0f}", most=at_most // megabytes)


def read_notebook(data: bytes) -> SubmittedNotebook:
    """Return the cells of a notebook of the third or fourth format.

    Raises:
        Unreadable: not a notebook.
    """
    text, remarks = _decoded(data)
    text = strip_outputs(text)
    if max(text.count("["), text.count("{")) > MAX_CONTAINERS:
        raise Unreadable("many lists")
    page = _parsed(text)
    if not isinstance(page, dict):
        raise Unreadable("no cells")
    cells = _cells_of(page)
    if len(cells) > MAX_CELLS:
        raise Unreadable("many cells", count=len(cells), most=MAX_CELLS)
    read = tuple(_cell(cell) for cell in cells if isinstance(cell, dict))
    if len(read) < len(cells):
        remarks.append(Remark("no cell", count=len(cells) - len(read)))
    return SubmittedNotebook(_not_too_much(read), _stamp(page), tuple(remarks))


def _decoded(data: bytes) -> tuple[str, list[Remark]]:
    if not data.strip(b"\0 \t\r\n"):
        raise Unreadable("empty file")
    if data[:2] == b"PK":
        raise Unreadable("zip")
    wide = json.detect_encoding(data)  # by a byte order mark, or by where the zeros are
    for encoding in (wide, *ENCODINGS):
        try:
            text = data.decode(encoding)
        except (UnicodeDecodeError, LookupError):
            continue
        remarks = [Remark("encoding", encoding=encoding)] if encoding not in ("utf-8", "utf-8-sig") else []
        return text.removeprefix("\ufeff").rstrip("\0\x1a"), remarks
    return data.decode("utf-8", errors="replace"), [Remark("letters")]


def _parsed(text: str) -> Any:
    try:
        return bounded_json.read(text, parse_int=lambda digits: int(digits[:LONGEST_INT]), strict=False)
    except bounded_json.TooDeep:
        raise Unreadable("too deep") from None
    except ValueError as error:
        raise Unreadable("no JSON", line=getattr(error, "lineno", 1)) from None


def _cells_of(page: dict) -> list:
    cells = page.get("cells")
    if isinstance(cells, list):
        return cells
    sheets = page.get("worksheets")  # the third format
    if not isinstance(sheets, list):
        raise Unreadable("no cells")
    lists = [sheet["cells"] for sheet in sheets if isinstance(sheet, dict) and isinstance(sheet.get("cells"), list)]
    return [cell for cells in lists for cell in cells]


def _cell(cell: dict) -> SubmittedCell:
    kind = cell.get("cell_type")
    source = _text(cell["source"] if "source" in cell else cell.get("input"))
    kind = kind if isinstance(kind, str) else "code"
    return SubmittedCell(tuple(_claims(cell)), kind, source)


def _not_too_much(cells: Sequence[SubmittedCell]) -> tuple[SubmittedCell, ...]:
    """Return the cells until they hold more than anybody writes."""
    room, kept = MAX_SOURCES, []
    for cell in cells:
        room -= len(cell.source)
        if room < 0:
            break
        kept.append(cell)
    return tuple(kept)


def _text(source: Any) -> str:
    """Return a cell's source, one string or a list of lines; what is no text is none."""
    lines = source if isinstance(source, list) else [source]
    text = "".join(line for line in lines if isinstance(line, str))
    text = text.encode("utf-8", errors="replace").decode("utf-8")  # half a surrogate is no letter
    return text.replace("\0", "").replace("\r\n", "\n")[:MAX_SOURCE]


def _claims(cell: dict) -> list[str]:
    """Return the names that a cell claims: its name in the metadata, its place in a task, its id."""
    metadata = _dict(cell.get("metadata"))
    nbgrader, ours = _dict(metadata.get("nbgrader")), _dict(metadata.get("tflab"))
    tags = metadata.get("tags")
    roles = [tag for tag in tags if isinstance(tag, str)] if isinstance(tags, list) else []
    task = ours.get("task")
    in_task = [f"{slug(task)}-{role}" for role in roles] if isinstance(task, str) else []
    claims = [metadata.get("name"), *in_task, nbgrader.get("grade_id"), cell.get("id")]
    return list(dict.fromkeys(claim for claim in claims if isinstance(claim, str) and 0 < len(claim) <= 100))


def _stamp(page: dict) -> dict[str, str]:
    stamp = _dict(_dict(page.get("metadata")).get("tflab"))
    return {key: value[:200] for key, value in stamp.items() if isinstance(key, str) and isinstance(value, str)}


def _dict(value: Any) -> dict:
    return value if isinstance(value, dict) else {}
