"""Who handed in what?  A folder, a zip or one notebook becomes a list of submissions, one for each learner.

    s101/exercises/en/03_target_and_source.ipynb        a folder for each learner
    s101/hw1/03_target_and_source.ipynb                 as nbgrader collects
    Kim Minji_4711_assignsubmission_file_/03.ipynb      as Moodle gives it
    kimminji_4711_98765_03.ipynb                        as Canvas gives it
    s101.ipynb, s101_03_target_and_source.ipynb         a folder of notebooks
    03_target_and_source/s101.ipynb                     a folder for each chapter

Files are only listed here, and read when their turn comes.  Whose they are is
said first by where they were found, then by the stamp in the notebook.

Read `archives.py` next.
"""

from __future__ import annotations

import os
import re
import unicodedata
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from .archives import Member, archive_members, is_zip_name
from .reader import Unreadable, read_bytes, read_notebook
from .remarks import Remark, printable
from .roster import Learner

__all__ = ["Collection", "Submission", "collect"]

NOTEBOOKS = (".ipynb", ".ipynb.txt", ".ipynb.json")  # a browser adds the last ones
SKIPPED = {"__MACOSX", "__pycache__", "Thumbs.db", "desktop.ini"}
WRAPPERS = {"submitted", "submissions", "submission", "exercises"}
MAX_NOTEBOOKS = 60  # of one learner
MAX_DEPTH = 12
MOST_ZIPS = 2  # in each other, in a learner's folder
MOODLE = re.compile(r"(?P<name>.+?)_(?P<number>\d+)_assignsubmission_")
CANVAS = re.compile(r"(?P<name>[^_]+)_(?:LATE_)?(?P<user>\d+)_(?P<file>\d+)_(?P<rest>.+)")


@dataclass(frozen=True)
class Submission:
    """What one learner handed in.

    Attributes:
        learner: the id: the roster's, else the name that the files go by.
        notebooks: the files that call themselves notebooks.
        remarks: one line each, on what is odd about how it was handed in.
    """

    learner: str
    notebooks: tuple[Member, ...]
    remarks: tuple[Remark, ...] = ()
    known: bool = True


@dataclass(frozen=True)
class Collection:
    """Every submission, in the order of the roster, then by name, and remarks on what belongs to nobody."""

    submissions: tuple[Submission, ...]
    remarks: tuple[Remark, ...] = ()


def collect(
    place: Path, roster: Mapping[str, Learner] | None, chapters: Sequence[str], leave_out: Sequence[Path] = ()
) -> Collection:
    """Return what there is in a folder, a zip or a notebook; with a roster, one submission for each who is on it.

    Args:
        leave_out: folders that are no submissions, wherever they are: the results, the pack.

    Raises:
        Unreadable: there is no such thing, or it cannot be listed.
    """
    members, remarks = _listed(place, {path.resolve() for path in leave_out})
    members = _few_of_each(_by_learner(_unwrapped(members, roster or {}), roster or {}, chapters))
    groups: dict[str, list[Member]] = {}
    for member in members:
        groups.setdefault(_group(member.parts, chapters), []).append(member)
    found: dict[str, Submission] = {}
    by_path = {key: _of_path(key, roster) if roster else None for key in groups}
    for key in sorted(groups, key=lambda key: (by_path[key] is None, key)):
        learner, strange = by_path[key], ()
        if roster and learner is None:
            learner = _of_stamps(groups[key], roster)
            if learner in found:  # a stamp is easily copied: it never adds to what somebody handed in themselves
                strange = (Remark("stamped", stamp=learner),)
                learner = None
            elif learner is None:
                strange = (Remark("nobody", stamp=_printable(key)),)
        one = _submission(learner or _printable(key), groups[key], strange, roster is None or learner is not None)
        found[one.learner] = _together(found[one.learner], one, key) if one.learner in found else one
    on_roster = [found.pop(learner, Submission(learner, (), (Remark("no file"),))) for learner in roster or ()]
    return Collection((*on_roster, *(found[learner] for learner in sorted(found))), tuple(remarks))


def _together(there: Submission, one: Submission, key: str) -> Submission:
    """Return as one what a learner handed in at two places; what lies beside a notebook is not worth a line."""
    if bool(there.notebooks) != bool(one.notebooks):
        return there if there.notebooks else one
    remarks = (*there.remarks, *one.remarks, Remark("places", stamp=_printable(key)))
    return replace(one, notebooks=there.notebooks + one.notebooks, remarks=remarks)


def _listed(place: Path, leave_out: set[Path]) -> tuple[list[Member], list[Remark]]:
    """Return all files, those in zips included."""
    if place.is_dir():
        members, remarks = _walked(place, leave_out)
    elif not place.exists():
        raise Unreadable("nowhere", place=place)
    elif is_zip_name(place.name):
        members, remarks = archive_members(place.resolve())
    else:
        one = Member((place.name,), lambda: read_bytes(place))
        if not _is_notebook(one):
            raise Unreadable("no notebook", stamp=_few([place.name]))
        return [one], []
    listed: list[Member] = []
    for member in members:
        if not any(_is_skipped(part) for part in member.parts):
            listed += _inside(member, remarks) if is_zip_name(member.parts[-1]) else [member]
    return listed, remarks


def _walked(place: Path, leave_out: set[Path]) -> tuple[list[Member], list[Remark]]:
    members, remarks = [], []

    def closed(error: OSError) -> None:
        parts = Path(error.filename).relative_to(place).parts
        remarks.append(Remark("file", file="/".join(parts), why=Remark("closed", error=error.strerror)))
        members.append(Member((*parts, ""), bytes))

    for folder, folders, files in os.walk(place, onerror=closed):
        parts = Path(folder).relative_to(place).parts
        for name in [name for name in folders if os.path.islink(os.path.join(folder, name))]:
            remarks.append(Remark("file", file="/".join((*parts, name)), why=Remark("linked folder")))
        entered = [name for name in folders if not _is_skipped(name)]
        entered = [name for name in entered if (Path(folder) / name).resolve() not in leave_out]
        folders[:] = sorted(entered) if len(parts) < MAX_DEPTH else []
        if not files and not folders and parts:
            members.append(Member((*parts, ""), bytes))  # so that who handed in an empty folder is heard of
        for name in sorted(files):
            path = Path(folder) / name
            members.append(Member((*parts, name), partial(read_bytes, path), path))
    return members, remarks


def _inside(member: Member, remarks: list[Remark], deeper: int = MOST_ZIPS) -> list[Member]:
    """Return what is in a learner's zip, and in zips in it, as if it had been unpacked where it is."""
    name = printable("/".join(member.parts))
    folder = member.parts if len(member.parts) == 1 else member.parts[:-1]
    folder = (*folder[:-1], folder[-1][:-4]) if is_zip_name(folder[-1]) else folder
    try:
        members, refused = archive_members(member.path or member.read, name)
    except Unreadable as error:
        remarks.append(Remark("unreadable", file=name, why=error.remark))
        return [Member((*folder, member.parts[-1]), bytes)]
    remarks += refused
    listed: list[Member] = []
    for one in [replace(one, parts=(*folder, *one.parts)) for one in members if not any(map(_is_skipped, one.parts))]:
        listed += _inside(one, remarks, deeper - 1) if deeper > 1 and is_zip_name(one.parts[-1]) else [one]
    return listed


def _few_of_each(members: list[Member]) -> list[Member]:
    """Return the members without the masses that somebody may have put beside their notebooks."""
    counts: Counter[tuple[str, bool]] = Counter()
    kept = []
    for member in members:
        kind = (member.parts[0] if len(member.parts) > 1 else "", _is_notebook(member))
        counts[kind] += 1
        if not kind[0] or counts[kind] <= MAX_NOTEBOOKS + 1:
            kept.append(member)
    return kept


def _is_skipped(name: str) -> bool:
    """Return whether a folder or file is not the learner's work: checkpoints, what a Mac adds, pristine copies."""
    return name.startswith(".") or name in SKIPPED


def _unwrapped(members: list[Member], roster: Mapping[str, Learner]) -> list[Member]:
    """Return the members without a folder that they all share and that is nobody's."""
    while members:
        tops = {member.parts[0] for member in members}
        inside = {member.parts[1] for member in members if len(member.parts) > 2}
        top = next(iter(tops))
        if len(tops) > 1 or any(len(member.parts) == 1 for member in members) or top in roster:
            return members
        if not (top.lower() in WRAPPERS or any(_of_path(name, roster) for name in inside)):
            return members
        members = [replace(member, parts=member.parts[1:]) for member in members]
    return members


def _by_learner(members: list[Member], roster: Mapping[str, Learner], chapters: Sequence[str]) -> list[Member]:
    """Return the members without the folders above the learners', one for each chapter or each assignment."""
    folders = {member.parts[0] for member in members if len(member.parts) > 1}
    below = {member.parts[1] for member in members if len(member.parts) > 1}
    strange = {folder for folder in folders if not _is_somebodys(folder, roster)}
    strip = {folder for folder in strange if _is_a_chapters(folder, members, roster, chapters)}
    everybody = roster and all(_of_path(_group((name,), chapters), roster) for name in below)
    if everybody and strange == folders:  # nobody's folders, and somebody's in each
        strip = folders
    return [
        replace(member, parts=member.parts[1:]) if len(member.parts) > 1 and member.parts[0] in strip else member
        for member in members
    ]


def _is_somebodys(folder: str, roster: Mapping[str, Learner]) -> bool:
    return bool(CANVAS.fullmatch(folder) or MOODLE.match(folder) or (roster and _of_path(folder, roster)))


def _is_a_chapters(
    folder: str, members: Sequence[Member], roster: Mapping[str, Learner], chapters: Sequence[str]
) -> bool:
    """Return whether a folder that has a chapter's name holds learners, and is not a learner's own."""
    if folder in chapters or not any(chapter in folder for chapter in chapters):
        return folder in chapters
    inside = {_group(member.parts[1:2], chapters) for member in members if member.parts[0] == folder}
    if roster:
        return all(_of_path(name, roster) for name in inside)
    return len(inside) > 1 and not inside & set(chapters)


def _group(parts: tuple[str, ...], chapters: Sequence[str]) -> str:
    """Return by what name a file's learner goes: the folder's, or the file's without the chapter in it."""
    canvas = CANVAS.fullmatch(parts[0])
    if canvas:
        return f"{canvas['name']}_{canvas['user']}"
    moodle = MOODLE.match(parts[0])
    if moodle:
        return moodle["name"]
    stem = parts[0]
    for ending in sorted(NOTEBOOKS, key=len, reverse=True) if len(parts) == 1 else ():
        if stem.lower().endswith(ending):
            stem = stem[: -len(ending)]
            break
    for chapter in chapters:
        if chapter in stem and stem != chapter:
            stem = stem.replace(chapter, "")
    return stem.strip(" _-.") or parts[0]


def _submission(learner: str, members: list[Member], strange: tuple[Remark, ...], known: bool) -> Submission:
    notebooks = tuple(member for member in members if _is_notebook(member))
    others = sorted({member.parts[-1] for member in members} - {member.parts[-1] for member in notebooks} - {""})
    remarks = list(strange)
    if not notebooks:
        remarks.append(Remark("no notebook", stamp=_few(others)) if others else Remark("empty"))
    if len(notebooks) > MAX_NOTEBOOKS:
        remarks.append(Remark("many", stamp=len(notebooks), ours=MAX_NOTEBOOKS))
    return Submission(learner, notebooks[:MAX_NOTEBOOKS], tuple(remarks), known)


def _is_notebook(member: Member) -> bool:
    return member.parts[-1].lower().endswith(NOTEBOOKS)


def _of_path(key: str, roster: Mapping[str, Learner]) -> str | None:
    """Return whose name a folder or a file has: an id, a part of it that is one, or a name."""
    key = unicodedata.normalize("NFC", key)  # a Mac takes Hangul apart
    by_lower = {unicodedata.normalize("NFC", learner).lower(): learner for learner in roster}
    for word in [key, *re.split(r"[\s_,()+]+", key), *re.split(r"[^A-Za-z0-9.@-]+", key)]:
        if word.lower() in by_lower:
            return by_lower[word.lower()]
    pieces = {_letters(re.sub(r"_\d+$", "", piece)) for piece in (key, *key.split(" - "))} - {""}
    named = [learner.id for learner in roster.values() if pieces & _ways(learner.name)]
    return named[0] if len(named) == 1 else None


def _ways(name: str) -> set[str]:
    """Return a name in the orders that learning systems write it in: Kim Minji, Kim, Minji, Minji Kim."""
    words = [word for word in re.split(r"[\s,]+", name) if word]
    return {_letters("".join(words)), _letters("".join(words[1:] + words[:1])), _letters("".join(words[::-1]))} - {""}


def _letters(text: str) -> str:
    return "".join(letter for letter in unicodedata.normalize("NFC", text).casefold() if letter.isalnum())


def _of_stamps(notebooks: Sequence[Member], roster: Mapping[str, Learner]) -> str | None:
    stamps = set()
    for member in filter(_is_notebook, notebooks):
        try:
            stamps.add(read_notebook(member.read()).stamp.get("learner"))
        except Unreadable:
            continue
    known = stamps & set(roster)
    return known.pop() if len(known) == 1 else None


def _printable(key: str) -> str:
    """Return a name that can stand in a report and as a file's name."""
    key = unicodedata.normalize("NFC", key)
    return (
        "".join(letter if letter.isprintable() and letter not in '/\\:*?"<>|' else "_" for letter in key)[:64].strip(
            " ."
        )
        or "unnamed"
    )


def _few(names: list[str]) -> str | Remark:
    shown = ", ".join(_printable(name) for name in names[:3])
    return shown if len(names) <= 3 else Remark("and more", names=shown, count=len(names) - 3)
