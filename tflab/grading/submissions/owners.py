"""Whose is it?  A learner of the roster, by the name that a file or a folder goes by, or by the stamps in it.

    s101, [s101] 김민지, HW1_s101_attempt        an id, or a word that is one
    Kim Minji_4711_assignsubmission_file_       Moodle: a name that its owner may change, and a number that is theirs
    kimminji_4711_98765_03.ipynb                Canvas: the same

What a learning system calls a learner is taken as a whole: a display name that holds
somebody else's id ("Mallory s102") is not that person's.  A stamp counts if it bears the
release's seal: whoever writes another's name into a notebook has not got that.
"""

from __future__ import annotations

import contextlib
import re
import unicodedata
from collections.abc import Callable, Mapping, Sequence

from .archives import Member
from .listing import NOTEBOOKS, is_notebook
from .reader import Unreadable, read_notebook
from .roster import Learner

__all__ = [
    "MOST_BYTES",
    "IsGenuine",
    "StampsIn",
    "group_of",
    "is_of_a_system",
    "owner_of",
    "read_stamps",
    "stamped_for",
]

MOST_BYTES = 160 << 20  # of all the notebooks of one learner
IsGenuine = Callable[[Mapping[str, str]], bool]  # whether a stamp is as it was handed out
StampsIn = Callable[[Sequence[bytes]], Sequence[Mapping[str, str]]]  # the stamps in files, wherever these are read

MOODLE = re.compile(r"(?P<name>.+?)_(?P<number>\d+)_assignsubmission_")
BRIGHTSPACE = re.compile(r"(?P<number>\d+-\d+) - (?P<name>.+?) - .+")
BLACKBOARD = re.compile(r".+?_(?P<name>[^_]+)_attempt_\d{4}-.*")
CANVAS = re.compile(r"(?P<name>[^_]+)_(?:LATE_)?(?P<user>\d+)_(?P<file>\d+)_(?P<rest>.+)")


def is_of_a_system(name: str) -> bool:
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
