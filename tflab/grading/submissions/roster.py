"""Read the roster of a class, and tell whose a file is.

    id,name,language
    s101,Kim Minji,ko
    s102,Ada Byron,en          the column `language` may be missing, and so may `name`

The first row names the columns, in any order; their names may be those that Moodle or
Canvas export. A row that is wrong is one line in the report.

The owner of a file follows from its path:

    s101, [s101] 김민지, HW1_s101_attempt        an id, or a word that is one
    Kim Minji_4711_assignsubmission_file_       Moodle: a name that its owner may change, and a number that is theirs
    kimminji_4711_98765_03.ipynb                Canvas: the same

What a learning system calls a learner is taken as a whole: a display name that holds
somebody else's id ("Mallory s102") is not that person's. The stamp in a notebook settles
what the path leaves open, if it bears the release's seal, which learners cannot make.
"""

from __future__ import annotations

import contextlib
import csv
import io
import re
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from tflab.text import LANGUAGES

from .archives import Member
from .listing import NOTEBOOKS, is_notebook
from .reader import Unreadable, read_notebook
from .remarks import printable

__all__ = [
    "MOST_BYTES",
    "IsGenuine",
    "Learner",
    "Roster",
    "StampsIn",
    "group_of",
    "is_learner_id",
    "is_lms_name",
    "owner_of",
    "read_roster",
    "read_stamps",
    "stamped_for",
]

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
    text = _decoded(data)
    delimiter = max(",;\t", key=text.lstrip().split("\n")[0].count)
    lines = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter)
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


MOST_BYTES = 160 << 20  # of all the notebooks of one learner
IsGenuine = Callable[[Mapping[str, str]], bool]  # whether a stamp is as it was handed out
StampsIn = Callable[[Sequence[bytes]], Sequence[Mapping[str, str]]]  # the stamps in files, wherever these are read

MOODLE = re.compile(r"(?P<name>.+?)_(?P<number>\d+)_assignsubmission_")
BRIGHTSPACE = re.compile(r"(?P<number>\d+-\d+) - (?P<name>.+?) - .+")
BLACKBOARD = re.compile(r".+?_(?P<name>[^_]+)_attempt_\d{4}-.*")
CANVAS = re.compile(r"(?P<name>[^_]+)_(?:LATE_)?(?P<user>\d+)_(?P<file>\d+)_(?P<rest>.+)")


def is_lms_name(name: str) -> bool:
    """Return whether a folder or a file has a name that a learning system gives."""
    return bool(CANVAS.fullmatch(name) or MOODLE.match(name) or BRIGHTSPACE.fullmatch(name))


def group_of(parts: tuple[str, ...], chapters: Sequence[str]) -> tuple[str, str]:
    """Return by what name a file's learner goes, and the number that a learning system has for them.

    The name is the folder's, or the file's without the chapter in it.
    """
    if canvas := CANVAS.fullmatch(parts[0]):
        return canvas["name"], canvas["user"]
    for system in (MOODLE, BRIGHTSPACE):
        if named := system.match(parts[0]):
            return named["name"], named["number"]
    if blackboard := BLACKBOARD.fullmatch(parts[0]):
        return blackboard["name"], ""
    stem = parts[0]
    for ending in sorted(NOTEBOOKS, key=len, reverse=True) if len(parts) == 1 else ():
        if stem.lower().endswith(ending):
            stem = stem[: -len(ending)]
            break
    for chapter in chapters:
        if chapter in stem and stem != chapter:
            stem = re.sub(f"E?{re.escape(chapter)}", "", stem)
            stem = re.sub("^[ _-]|[ _-]$", "", stem)  # what joined the two; "s0." and "s0 " are other names than "s0"
    return stem or parts[0], ""


def owner_of(name: str, roster: Mapping[str, Learner], *, whole: bool = False) -> str | None:
    """Return whose name this is: an id, a part of it that is one (unless it is to be taken whole), or a name."""
    name = unicodedata.normalize("NFC", name).strip(" _-.")  # a Mac takes Hangul apart
    by_lower = {unicodedata.normalize("NFC", learner).lower(): learner for learner in roster}
    words = [] if whole else [*re.split(r"[\s_,()+]+", name), *re.split(r"[^A-Za-z0-9.@-]+", name)]
    for word in [name, *words]:
        if word.lower() in by_lower:
            return by_lower[word.lower()]
    pieces = {_letters(piece) for piece in (name, *([] if whole else name.split(" - ")))} - {""}
    named = [learner.id for learner in roster.values() if pieces & _ways(learner.name)]
    return named[0] if len(named) == 1 else None


def stamped_for(
    members: Sequence[Member], roster: Mapping[str, Learner], is_genuine: IsGenuine, stamps_in: StampsIn
) -> str | None:
    """Return the one learner for whom notebooks were handed out, by the stamps in them."""
    room, files = MOST_BYTES, []
    for member in filter(is_notebook, members):
        with contextlib.suppress(Unreadable):
            files.append(member.read())
            room -= len(files[-1])
        if room <= 0:
            break
    stamps = stamps_in(files)
    known = {stamp.get("learner") for stamp in stamps if is_genuine(stamp)} & set(roster)
    return known.pop() if len(known) == 1 else None


def read_stamps(files: Sequence[bytes]) -> list[dict[str, str]]:
    """Return the stamps in notebooks; none of what is no notebook."""
    stamps = []
    for data in files:
        with contextlib.suppress(Unreadable):
            stamps.append(read_notebook(data).stamp)
    return stamps


def _ways(name: str) -> set[str]:
    """Return a name in the orders that learning systems write it in: Kim Minji, Kim, Minji, Minji Kim."""
    words = [word for word in re.split(r"[\s,]+", name) if word]
    return {_letters("".join(words)), _letters("".join(words[1:] + words[:1])), _letters("".join(words[::-1]))} - {""}


def _letters(text: str) -> str:
    return "".join(letter for letter in unicodedata.normalize("NFC", text).casefold() if letter.isalnum())
