"""List the files of a folder, and those in zips as if each had been unpacked into a folder of its name.

    hw1/s101.zip                  hw1/s101/03.ipynb            what is behind "s101" was named by whoever made the zip
    s102/work.zip/more.zip        s102/work/more/03.ipynb
    a zip of 60 000 names         refused before it is opened: its list is too long for one learner's work

What is in a zip stays below the zip's own name: nothing in it can stand beside it, or in
somebody else's folder.  Zips in a zip are opened within a budget, for each zip that
somebody handed in.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from .archives import Member, archive_members, is_zip_name
from .reader import Unreadable, read_bytes
from .remarks import Remark, printable

__all__ = ["few_of_each", "is_notebook", "largest", "listed"]

NOTEBOOKS = (".ipynb", ".ipynb.txt", ".ipynb.json")  # a browser adds the last ones
SKIPPED = {"__MACOSX", "__pycache__", "Thumbs.db", "desktop.ini"}
MAX_NOTEBOOKS = 60  # of one learner
MAX_DEPTH = 12
MOST_DEEP = 2  # zips in each other, in what a learner handed in
MOST_ZIPS = 8  # in what a learner handed in, all together
MOST_SAID = 20  # lines on what a learner handed in as a zip
MOST_MEMBERS = 10_000  # in each of them
MIB = 1 << 20
MOST_BYTES = 64 * MIB  # of the zips in a zip


@dataclass
class Budget:
    """What may still be opened of one zip that somebody handed in."""

    zips: int = MOST_ZIPS
    bytes: int = MOST_BYTES
    is_too_deep: bool = False

    def take(self, size: int) -> None:
        """Spend one zip of a size; raise Unreadable if there is no more."""
        self.zips -= 1
        self.bytes -= size
        if self.zips < 0 or self.bytes < 0:
            raise Unreadable("many zips", most=MOST_ZIPS, megabytes=MOST_BYTES // MIB)


def listed(place: Path, leave_out: set[Path]) -> tuple[list[Member], list[Remark]]:
    """Return all files, those in zips included."""
    if place.is_dir():
        members, remarks = _walked(place, leave_out)
    elif not place.exists():
        raise Unreadable("nowhere", place=place)
    elif is_zip_name(place.name):
        members, remarks = archive_members(place.resolve())
    else:
        notebook = Member((place.name,), lambda: read_bytes(place))
        if not is_notebook(notebook):
            raise Unreadable("no notebook", stamp=printable(place.name))
        return [notebook], []
    found: list[Member] = []
    for member in members:
        if not any(map(_is_skipped, member.parts)):
            said: list[Remark] = []
            found += _inside(member, said, Budget()) if is_zip_name(member.parts[-1]) else [member]
            remarks += _few(said, member)
    return found, remarks


def is_notebook(member: Member) -> bool:
    """Return whether a file calls itself a notebook."""
    return member.parts[-1].lower().endswith(NOTEBOOKS)


def few_of_each(members: list[Member]) -> list[Member]:
    """Return the members without the masses that somebody may have put beside their notebooks."""
    kinds: dict[tuple[str, bool], list[Member]] = {}
    for member in members:
        kind = (member.parts[0] if len(member.parts) > 1 else "", is_notebook(member))
        kinds.setdefault(kind, []).append(member)
    crowded = {kind for kind, those in kinds.items() if kind[0] and len(those) > MAX_NOTEBOOKS + 1}
    kept = {id(member) for kind in crowded for member in largest(kinds[kind], MAX_NOTEBOOKS + 1)}
    left_out = {id(member) for kind in crowded for member in kinds[kind]} - kept
    return [member for member in members if id(member) not in left_out]


def largest(members: Sequence[Member], most: int) -> list[Member]:
    """Return at most so many of the members, in their order; an answered notebook is larger than an empty one."""
    by_size = sorted(range(len(members)), key=lambda place: members[place].size, reverse=True)
    return [members[place] for place in sorted(by_size[:most])]


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
            members.append(Member((*parts, name), partial(read_bytes, path), path, _size_of(path)))
    return members, remarks


def _size_of(path: Path) -> int:
    try:
        return path.lstat().st_size
    except OSError:
        return 0


def _inside(zipped: Member, remarks: list[Remark], budget: Budget, depth: int = 1) -> list[Member]:
    """Return what is in a learner's zip, and in zips in it, below the zip's own name."""
    name = printable("/".join(zipped.parts))
    folder = (*zipped.parts[:-1], zipped.parts[-1][:-4] or zipped.parts[-1])
    outside = zipped.outside or len(folder)
    try:
        if depth > 1:
            budget.take(zipped.size)
        members, refused = archive_members(zipped.path or zipped.read, name, most=MOST_MEMBERS)
    except Unreadable as error:
        remarks.append(Remark("unreadable", file=name, why=error.remark))
        return [Member((*folder, zipped.parts[-1]), bytes, outside=outside)]
    remarks += refused
    found: list[Member] = []
    for member in members:
        if any(map(_is_skipped, member.parts)):
            continue
        below = replace(member, parts=(*folder, *member.parts), outside=outside)
        is_zip = is_zip_name(member.parts[-1])
        if is_zip and depth == MOST_DEEP and not budget.is_too_deep:
            budget.is_too_deep = True
            remarks.append(Remark("unreadable", file=printable("/".join(below.parts)), why=Remark("deep zip")))
        found += _inside(below, remarks, budget, depth + 1) if is_zip and depth < MOST_DEEP else [below]
    return found


def _few(said: list[Remark], zipped: Member) -> list[Remark]:
    """Return what is said of a learner's zip, in few lines: there may be ten thousand names that lead out."""
    if len(said) <= MOST_SAID:
        return said
    more = Remark("more like these", count=len(said) - MOST_SAID)
    return [*said[:MOST_SAID], Remark("file", file=printable("/".join(zipped.parts)), why=more)]


def _is_skipped(name: str) -> bool:
    """Return whether a folder or file is not the learner's work: checkpoints, what a Mac adds, pristine copies."""
    return name.startswith(".") or name in SKIPPED
