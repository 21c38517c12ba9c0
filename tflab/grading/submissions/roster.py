"""Who is in the class?  A CSV file, one learner a row, and one clear line for each row that is wrong.

    id,name,language
    s101,Kim Minji,ko
    s102,Ada Byron,en          the column `language` may be missing, and so may `name`

The first row names the columns, in any order; their names may be those that
Moodle or Canvas export.
"""

from __future__ import annotations

import csv
import io
import re
from dataclasses import dataclass, field

from tflab.text import LANGUAGES

from .remarks import printable

__all__ = ["Learner", "Roster", "is_learner_id", "read_roster"]

ENCODINGS = ("utf-8-sig", "cp949")
COLUMNS = {
    "id": ("id", "learner", "learner id", "student id", "id number", "sis user id", "sis login id", "username", "학번"),
    "name": ("name", "full name", "student", "first name", "이름", "성명"),
    "language": ("language", "lang", "언어"),
}
ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9._@-]{0,63}")
RESERVED = {"con", "prn", "aux", "nul", *(f"{port}{n}" for port in ("com", "lpt") for n in range(1, 10))}
MAX_NAME = 120
UNCLOSED = "a quotation mark is not closed; nothing behind it is read"
SPOKEN = {"korean": "ko", "kr": "ko", "한국어": "ko", "english": "en", "영어": "en"}


@dataclass(frozen=True, slots=True)
class Learner:
    """One learner: the id is also the name of a folder."""

    id: str
    name: str = ""
    language: str = "en"


@dataclass(frozen=True, slots=True)
class Roster:
    """The learners by id, and one line for each row that is not one."""

    learners: dict[str, Learner] = field(default_factory=dict)
    faults: tuple[str, ...] = ()


def is_learner_id(text: str) -> bool:
    """Return whether a text can be a learner's id: letters, digits and . _ @ -, and the name of a folder anywhere."""
    return (
        bool(ID.fullmatch(text)) and ".." not in text and text[-1] != "." and text.split(".")[0].lower() not in RESERVED
    )


def read_roster(data: bytes, language: str = "en") -> Roster:
    """Return the class in a CSV file; `language` is for those whose row names none."""
    if data[:2] == b"PK":
        return Roster(faults=("it is a zip or an Excel file; save it as CSV",))
    rows, faults = _rows(data)
    if not rows:
        return Roster(faults=(*faults, "it is empty; its first row names the columns: id,name,language"))
    first, header = rows[0]
    columns = _columns(header)
    if "id" not in columns:
        there = ", ".join(f'"{printable(name[:40])}"' for name in header[:12])
        return Roster(faults=(*faults, f'row {first}: no column "id"; there is {there}'))
    learners: dict[str, Learner] = {}
    for number, row in rows[1:]:
        learner, fault = _learner(row, columns, language)
        if learner is not None and learner.id.lower() in {other.lower() for other in learners}:
            fault = f'the id "{learner.id}" is there twice; the first row is taken'
        if fault:
            faults.append(f"row {number}: {fault}")
        elif learner is not None:
            learners[learner.id] = learner
    return Roster(learners, tuple(faults))


def _rows(data: bytes) -> tuple[list[tuple[int, list[str]]], list[str]]:
    """Return the rows in which anything stands, with their numbers, and what is wrong with the file."""
    rows: list[tuple[int, list[str]]] = []
    lines = csv.reader(io.StringIO(_decoded(data), newline=""), dialect=_dialect(data))
    while True:
        number = lines.line_num + 1
        try:
            row = next(lines, None)
        except csv.Error:  # a field as long as that
            return rows, [f"row {number}: {UNCLOSED}"]
        if row is None:
            open_end = rows and len(rows[-1][1][-1].splitlines()) > 1  # it took in all that was left
            return (rows[:-1], [f"row {rows[-1][0]}: {UNCLOSED}"]) if open_end else (rows, [])
        if any(word.strip() for word in row) and not (number == 1 and row[0].startswith("sep=")):
            rows.append((number, row))


def _decoded(data: bytes) -> str:
    for encoding in ENCODINGS if data[:2] not in (b"\xff\xfe", b"\xfe\xff") else ("utf-16",):
        try:
            return data.decode(encoding).replace("\0", "")
        except UnicodeDecodeError:
            continue
    return data.decode("utf-8", errors="replace").replace("\0", "")


def _dialect(data: bytes) -> type[csv.Dialect]:
    class Dialect(csv.excel):
        delimiter = max(",;\t", key=_decoded(data).lstrip().split("\n")[0].count)

    return Dialect


def _columns(header: list[str]) -> dict[str, int]:
    """Return where each column that we know is; of several names for one, the earlier in our list."""
    found = {name.strip().lower(): place for place, name in reversed(list(enumerate(header)))}
    columns = {}
    for column, names in COLUMNS.items():
        places = [found[name] for name in names if name in found]
        if places:
            columns[column] = places[0]
    return columns


def _learner(row: list[str], columns: dict[str, int], language: str) -> tuple[Learner | None, str]:
    words = {column: row[place].strip() if place < len(row) else "" for column, place in columns.items()}
    identity, spoken = words["id"], words.get("language", "").lower() or language
    spoken = SPOKEN.get(spoken, re.split("[-_]", spoken)[0])  # en-US is English
    if not identity:
        return None, "no id"
    if len(words.get("name", "").splitlines()) > 1:
        return None, "a quotation mark is not closed in its line"
    if not is_learner_id(identity):
        return None, f'"{printable(identity[:64])}" cannot be an id; use letters, digits and . _ @ -, as in s101'
    if spoken not in LANGUAGES:
        return None, f'the language "{printable(spoken[:20])}" is not there; there is {" and ".join(LANGUAGES)}'
    return Learner(identity, printable(words.get("name", "")[:MAX_NAME]), spoken), ""
