"""Hand out exercises: `tflab release DIR` makes a folder to give away, and one to keep.

    tflab release autumn --roster class.csv --chapters 02,03

    autumn/learners/s101/     pages and exercises, stamped
    autumn/instructor/        the pack: a secret seed, master notebooks (see pack.py)
    autumn/instructor/guide/  what to lecture these chapters from (see guide/)

Each learner on the roster gets variants of their own.  Nothing under learners/ says
what is graded.  A pack is never overwritten: `--add` brings in more learners and
chapters, with the seed it has, and finishes what was interrupted; `--update` brings in
what a newer tflab has fixed, with every learner's answers kept:

    as released                   this version                     after --update
    E3.2  asks about a = 2.31     asks about a = 2.31, new text    the new text, replies, right answers
    E3.4  asks about b = 1.07     asks about b = 2.4               nothing is changed: grade with the old version
    -                             E3.8                             not in this release: nobody's points change

Seed, roster, stamps and points stay, so what was handed in before is graded as well as
what comes after.  Each exercise as it was is kept in the pack.  The learners' copies are
brought up to date cell by cell (a three-way merge, see `merge.py` of the workbook).
"""

from __future__ import annotations

import argparse
import json
import re
import secrets
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from tqdm import tqdm

from tflab import __version__
from tflab.text import LANGUAGES
from tflab.workbook import paths
from tflab.workbook.copy.lay_out import lay_out, read_pristine, update
from tflab.workbook.pages.editions import text_of
from tflab.workbook.paths import WorkbookError
from tflab.workbook.tasks.task import TaskError, slug

from .guide.command import write_guide
from .guide.teaching import TeachingError
from .guide.validate import stems_there, teachings_called
from .judging.pack import (
    PACK,
    Pack,
    PackError,
    keep_chapter,
    learners_seed,
    questions_asked,
    read_pack,
    variant_for,
    write_master,
    write_pack,
)
from .submissions.reader import Unreadable, read_bytes
from .submissions.roster import Learner, Roster, read_roster

__all__ = ["main", "release", "update_release"]

INSTRUCTOR, LEARNERS, GUIDE = "instructor", "learners", "guide"
TASK_CELL = re.compile(r"e\d+-\d+(?=-|$)")
TITLE = "title"  # says how many tasks there are, and how many points


def main(words: Sequence[str]) -> int:
    """Release, and return 0; 1 if rows of the roster were left out, 2 if nothing was released."""
    options = _options(words)
    folder = Path(options.folder)
    try:
        pack, has_faults = _updated(options) if options.update else _released(options)
    except (PackError, TaskError, TeachingError, WorkbookError) as error:
        print(f"tflab release: {error}", file=sys.stderr)
        return 2
    who = "everybody, the same folder"
    if pack.roster is not None:
        who = f"{len(pack.roster)} learner{'' if len(pack.roster) == 1 else 's'}"
    print(f"{folder / LEARNERS}: for {who}: {', '.join(pack.chapters)}")
    print(f"{folder / INSTRUCTOR}: your pack. Keep it to yourself; grading needs it.")
    if (folder / INSTRUCTOR / GUIDE).is_dir():
        print(f"{folder / INSTRUCTOR / GUIDE}: what to lecture from; `tflab guide` makes its decks.")
    return 1 if has_faults else 0


def _released(options: argparse.Namespace) -> tuple[Pack, bool]:
    """Release what was asked for; return the pack, and whether rows of the roster were left out."""
    adds_no_chapter = options.add and not options.chapters
    stems = [] if adds_no_chapter else _chapters(options.chapters, paths.chapters())
    roster = _roster(options.roster, options.lang)
    for fault in roster.faults if roster else ():
        print(f"tflab release: {options.roster}, {fault}; left out", file=sys.stderr)
    if roster is not None and not roster.learners:
        raise PackError("no learner on the roster")
    learners = list(roster.learners.values()) if roster else None
    folder = Path(options.folder)
    pack = release(folder, stems, learners, language=options.lang, add=options.add, quiet=options.quiet)
    return pack, bool(roster and roster.faults)


def _updated(options: argparse.Namespace) -> tuple[Pack, bool]:
    """Update what was released, and say what there is to say."""
    if options.add or options.roster or options.chapters:
        raise PackError("--update brings in what was corrected, and nothing else; call it again with --add for more")
    pack, lines = update_release(Path(options.folder), quiet=options.quiet)
    print("\n".join([*lines, f"up to date with tflab {__version__}"]))
    return pack, False


def release(
    folder: Path,
    stems: Sequence[str],
    learners: Sequence[Learner] | None,
    *,
    language: str = "en",
    add: bool = False,
    quiet: bool = True,
) -> Pack:
    """Write the pack and the learners' folders; return the pack.

    Raises:
        PackError: there is a pack already, and nothing is to be added; or, adding, there is none.
        TaskError: a chapter's solution or cases are no good.
    """
    pack = _pack_to_fill(folder, learners, language, add)
    new = [stem for stem in dict.fromkeys(stems) if stem not in pack.questions]
    masters = {stem: _master(stem) for stem in [*pack.questions, *new]}
    pack.questions.update(questions_asked(new, pack.seed, quiet=quiet))
    for stem in new:
        write_master(folder / INSTRUCTOR, stem, masters[stem])
    write_pack(folder / INSTRUCTOR, pack)
    for learner in tqdm(_everybody(pack), desc="released", leave=False, disable=quiet or None):
        _lay_out_for(folder / LEARNERS, learner, pack, language)
    if new or not (folder / INSTRUCTOR / GUIDE).is_dir():
        _lay_out_guide(folder / INSTRUCTOR / GUIDE, pack)
    return read_pack(folder / INSTRUCTOR)


def _everybody(pack: Pack) -> list[Learner | None]:
    """Return who has a folder; None is everybody together."""
    return [None] if pack.roster is None else list(pack.roster.values())


def _master(stem: str) -> bytes:
    path = paths.workbook_data() / "exercises" / "en" / paths.exercise_file(stem)
    if not path.is_file():
        raise PackError(f"{stem} has no exercise; `tflab build {stem}` makes it")
    return path.read_bytes()


def update_release(folder: Path, *, quiet: bool = True) -> tuple[Pack, list[str]]:
    """Bring what was corrected into a release that is out; return its pack, and what there is to say.

    What was cut short is finished when it is called again.

    Raises:
        PackError: there is no pack, or one of its chapters is not here any more.
        TaskError: a chapter's solution or cases are no good.
    """
    pack = read_pack(folder / INSTRUCTOR)
    there = paths.chapters()
    missing = [stem for stem in pack.chapters if stem not in there]
    if missing:
        raise PackError(f"{', '.join(missing)} is not part of tflab {__version__}; nothing was changed")
    now = questions_asked(pack.chapters, pack.seed, quiet=quiet)
    pack.refuse_other_questions(now)
    lines = []
    for stem, asked in pack.questions.items():
        if added := [task for task in now[stem] if task not in asked]:
            lines.append(f"{stem}: {', '.join(added)} is new, and no part of this release")
        old = json.loads((folder / INSTRUCTOR / "masters" / f"{stem}.ipynb").read_text(encoding="utf-8"))
        new = _update_exercise(old, json.loads(_master(stem)), asked)
        if new != old:
            keep_chapter(folder / INSTRUCTOR, stem)
            write_master(folder / INSTRUCTOR, stem, text_of(new).encode())
    write_pack(folder / INSTRUCTOR, replace(pack, version=__version__))
    pack = read_pack(folder / INSTRUCTOR)
    for learner in tqdm(_everybody(pack), desc="updated", leave=False, disable=quiet or None):
        lines += _update_for(folder / LEARNERS, learner, pack)
    _lay_out_guide(folder / INSTRUCTOR / GUIDE, pack)
    return pack, lines


def _update_exercise(released: Mapping[str, Any], new: Mapping[str, Any], tasks: Iterable[str]) -> dict[str, Any]:
    """Return an exercise: new, with the tasks of the release and no others.

    Args:
        tasks: those of the release.
    """
    names = {slug(task) for task in tasks}
    cells = [cell for cell in new["cells"] if _task_of(cell) in names | {""}]
    if {_task_of(cell) for cell in new["cells"]} - {""} != names:
        titles = [cell for cell in released["cells"] if cell["id"] == TITLE]  # it counts the released tasks
        cells = [titles[0] if titles and cell["id"] == TITLE else cell for cell in cells]
    return {**new, "cells": cells}


def _task_of(cell: Mapping[str, Any]) -> str:
    """Return the task that a cell belongs to, as cells are named after it; "" if none."""
    found = TASK_CELL.match(cell["id"])
    return found[0] if found else ""


def _update_for(place: Path, learner: Learner | None, pack: Pack) -> list[str]:
    """Bring one learner's folder up to date, around what is written there; return what there is to say."""
    identity = learner.id if learner else None
    target = place / (identity or paths.COPY)
    if not (target / paths.MARK).is_file():
        return [f"{target} is not there any more; --add lays it out again"]
    spoken = paths.read_workbook(target).language
    changes = update(target, _exercises_for(pack, spoken, identity, read_pristine(target)))
    kept = sum(change.kept for change in changes)
    return [f"{target}: {len(changes)} files brought up to date, {kept} cells of the learner's kept"] if changes else []


def _exercises_for(
    pack: Pack, language: str, learner: str | None, handed_out: Mapping[str, bytes] = {}
) -> dict[str, bytes]:
    """Return the exercises as one learner gets them, by path; the title of one that was handed out stays."""
    files = {}
    for stem, asked in pack.questions.items():
        name = f"exercises/{language}/{paths.exercise_file(stem)}"
        new = json.loads((paths.workbook_data() / name).read_bytes())
        old = json.loads(handed_out[name]) if name in handed_out else new
        files[name] = _stamped(_update_exercise(old, new, asked), _stamp_of(pack, stem, language, learner))
    return files


def _lay_out_guide(place: Path, pack: Pack) -> None:
    """Write what the released chapters are lectured from, of those that have it."""
    stems = [stem for stem in pack.chapters if stem in stems_there()]
    if stems:
        write_guide(place, teachings_called(stems), pack.language)


def _pack_to_fill(folder: Path, learners: Sequence[Learner] | None, language: str, add: bool) -> Pack:
    there = (folder / INSTRUCTOR / PACK).exists() or (folder / LEARNERS).exists()
    roster = {learner.id: learner for learner in learners} if learners is not None else None
    if not add:
        if there:
            raise PackError(
                f"{folder} holds a release already, and nothing in it is changed. "
                "Name another folder, or add chapters and learners to this one with --add, "
                "which also finishes what was interrupted."
            )
        return Pack(secrets.token_hex(4), secrets.token_hex(32), language=language, roster=roster)
    pack = read_pack(folder / INSTRUCTOR)
    if pack.version != __version__:
        raise PackError(f"{folder} was released by tflab {pack.version}, this is {__version__}; add with that version")
    if roster and pack.roster is None and (folder / LEARNERS).exists():
        raise PackError(f"{folder} was released without a roster, the same for everybody; release to another folder")
    return replace(pack, roster={**pack.roster, **(roster or {})} if pack.roster is not None else roster)


def _lay_out_for(place: Path, learner: Learner | None, pack: Pack, language: str) -> None:
    identity = learner.id if learner else None
    spoken = learner.language if learner else language
    asked = {task: digests for tasks in pack.questions.values() for task, digests in tasks.items()}
    lay_out(
        place / (identity or paths.COPY),
        spoken,
        edition="class",
        learner=identity,
        seed=learners_seed(pack.seed),
        questions={
            task: digests[variant_for(pack.roster, identity or "", task, len(digests))]
            for task, digests in asked.items()
        },
        handed_out=_exercises_for(pack, spoken, identity),
    )


def _stamp_of(pack: Pack, stem: str, language: str, learner: str | None) -> dict[str, str]:
    """Return what says whose an exercise is."""
    stamp = {"release": pack.release, "version": pack.version} | ({"learner": learner} if learner else {})
    said = stamp | {"chapter": stem, "language": language}
    return said | {"seal": pack.seal_of(said)}


def _stamped(notebook: Mapping[str, Any], stamp: Mapping[str, str]) -> bytes:
    metadata = notebook["metadata"]
    held = {**notebook, "metadata": {**metadata, "tflab": {**metadata.get("tflab", {}), **stamp}}}
    return text_of(held).encode()


def _chapters(words: str | None, there: Sequence[str]) -> list[str]:
    """Return the stems that "02,03" names; all if there are no words."""
    if not there:
        raise PackError("there is no chapter with an exercise; `tflab build` makes them")
    try:
        chosen = paths.stems_called((words or "").replace(",", " ").split(), there, what="exercise")
    except LookupError as nothing:
        raise PackError(f"{nothing}") from None
    return chosen or list(there)


def _roster(path: str | None, language: str) -> Roster | None:
    if path is None:
        return None
    try:
        return read_roster(read_bytes(Path(path).resolve()), language)
    except Unreadable as error:
        raise PackError(f"the roster {path}: {error}") from None


def _options(words: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="tflab release", description="Hand out exercises, and keep what grades them.")
    parser.add_argument("folder", metavar="DIR", help="a new folder: DIR/learners to give away, DIR/instructor to keep")
    parser.add_argument("--roster", metavar="CSV", help="the class, a learner a row: id,name,language")
    parser.add_argument("--chapters", metavar="02,03", help="all that have exercises if left out; with --add, no more")
    parser.add_argument("--lang", choices=LANGUAGES, default="en", help="for whom the roster names none; %(default)s")
    parser.add_argument("--add", action="store_true", help="add chapters or learners to a release that is there")
    parser.add_argument("--update", action="store_true", help="bring later corrections into a release that is out")
    parser.add_argument("--quiet", action="store_true", help="no progress bar")
    return parser.parse_args(list(words))
