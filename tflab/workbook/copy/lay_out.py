"""Lay out a learner's copy of the workbook, and bring one up to date around what the learner wrote.

    lay_out(folder, "en")    writes what is not there yet, and nothing else
    update(folder)           brings in new material around what the learner wrote (see `merge.py`)

    .tflab/pristine.zip      each file as it was handed out: what tells the learner's edits from ours
    .tflab/backups/1/...     each file as it was before an update

A copy holds pages and exercises.  What `check` compares answers with is computed from the
installed tflab.  `tflab lab` and `tflab release` make copies with the same function.
"""

from __future__ import annotations

import json
import re
import zipfile
import zlib
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import lru_cache
from io import BytesIO
from pathlib import Path, PurePosixPath

from tflab import __version__

from ...text import LANGUAGES, Text
from ..atomic_files import locked, write_whole
from ..pages.editions import text_of, with_figures
from ..paths import MARK, Workbook, WorkbookError, read_workbook, workbook_data, write_workbook
from .merge import Merged, merge_notebooks

__all__ = [
    "Change",
    "handed_out_in",
    "has_language",
    "hide_outputs",
    "is_free",
    "lay_out",
    "material",
    "read_pristine",
    "strip_notes",
    "update",
]  # fmt: skip

HIDDEN = Path(".tflab")
PRISTINE = HIDDEN / "pristine.zip"
# whichever bytes of an archive are wrong
UNREADABLE_ZIP = (OSError, EOFError, ValueError, RuntimeError, zipfile.BadZipFile, zlib.error)
ZIP_DATE = (1980, 1, 1, 0, 0, 0)  # the same bytes for the same files
BACKUPS = HIDDEN / "backups"
PREDICTED = "predicted"  # the tag of code whose output a text asks to predict, and of a text that tells it
OWN_FOLD = re.compile(r"(<details>.*?</details>)", re.DOTALL)
CAPTION = "그림 읽기:"  # a Korean page says below a figure what its English words mean
UNFOLD = Text(en="Run it first, then open this", ko="먼저 실행한 다음 펼치십시오")


@dataclass(frozen=True)
class Change:
    """What an update did to one file.

    Attributes:
        path: of the file, from the copy's folder on.
        what: "new", "replaced", "merged", or "kept" where the learner's file cannot be read as a notebook.
        kept: how many cells of the learner's stand in it as they were.
        beside: how many cells changed on both sides, and have the new version beside them.
    """

    path: str
    what: str
    kept: int = 0
    beside: int = 0


def lay_out(
    target: Path,
    language: str,
    *,
    edition: str = "self-study",
    learner: str | None = None,
    seed: str = "",
    questions: Mapping[str, str] = {},
    handed_out: Mapping[str, bytes] | None = None,
) -> Path:
    """Write a copy of the workbook into `target`, or add to one what it lacks; nothing there is overwritten.

    Args:
        edition: "self-study", or "class", whose exercises come from an instructor.
        learner: an id, which picks variants.
        seed, questions: as of a Workbook.
        handed_out: the exercises of a class, by path.

    Raises:
        WorkbookError: the folder holds something else, or its `workbook.json` cannot be read.
    """
    target = Path(target)
    if not (target / MARK).is_file() and not is_free(target):
        raise WorkbookError(
            f"{target} holds files that are not a copy of the workbook, and nothing was written there.\n"
            "Name a new or an empty folder for the copy."
        )
    workbook = Workbook(__version__, edition, language, learner, seed, dict(questions))
    if (target / MARK).is_file():
        there = read_workbook(target)
        workbook = replace(there, language=language, questions=there.questions | workbook.questions)
    files = dict(material(language, edition=workbook.edition, handed_out=handed_out))
    target.mkdir(parents=True, exist_ok=True)
    with locked(target):
        write_workbook(target, workbook)  # first, so that a copy that was cut short is known for one
        new = {name: content for name, content in files.items() if not (target / name).exists()}
        if new:
            _write_pristine(target, read_pristine(target) | new)
        for name, content in new.items():
            write_whole(target / name, content)
    return target


def update(root: Path, handed_out: Mapping[str, bytes] = {}) -> list[Change]:
    """Bring a copy's material up to this version, around what the learner wrote; return what changed.

    Args:
        handed_out: what an instructor hands out anew, by path; without it the exercises of a class stay as they are.

    Raises:
        WorkbookError: its `workbook.json` cannot be read.
    """
    root = Path(root)
    workbook = read_workbook(root)
    changes = []
    with locked(root):
        backup = _next_backup(root)
        pristine = read_pristine(root)
        before = dict(pristine)
        try:
            for language in ("en", "ko"):
                files = dict(material(language, edition=workbook.edition)) if has_language(root, language) else {}
                files |= {name: content for name, content in handed_out.items() if _is_in(name, language)}
                for name, content in files.items():
                    change = _update_file(root, name, content, pristine.get(name), backup, workbook.language)
                    pristine[name] = content  # only now: what was cut short before is brought in by the next update
                    if change is not None:
                        changes.append(change)
        finally:
            if pristine != before:
                _write_pristine(root, pristine)
        write_workbook(root, replace(workbook, tflab=__version__))
    return changes


def material(
    language: str, *, edition: str = "self-study", handed_out: Mapping[str, bytes] | None = None
) -> Iterator[tuple[str, bytes]]:
    """Yield each file of a fresh copy: its path from the copy's folder on, and what is in it.

    The exercises of a class are what its instructor handed out.
    """
    data = workbook_data()
    built = sorted((data / "notebooks" / language).glob("*.ipynb"))
    for path in built:
        yield f"notebooks/{language}/{path.name}", _page(path, path.stat().st_mtime_ns, language, edition)
    if handed_out is not None:
        yield from handed_out.items()
    elif edition != "class":
        for path in sorted((data / "exercises" / language).glob("*.ipynb")):
            yield f"exercises/{language}/{path.name}", path.read_bytes()


@lru_cache(maxsize=64)  # a class is handed the same pages, one learner after the other
def _page(path: Path, _mtime_ns: int, language: str, edition: str) -> bytes:
    """Return a page of a copy, with the figures that are stored with the English one."""
    page, english = path.read_bytes(), path.parents[1] / LANGUAGES[0] / path.name
    if language != LANGUAGES[0] and english.is_file():
        page = text_of(with_figures(json.loads(page), json.loads(english.read_bytes()))).encode()
    page = hide_outputs(page, language)
    return strip_notes(page) if edition == "class" else page


def read_pristine(root: Path) -> dict[str, bytes]:
    """Return each file of a copy as it was handed out, by path; nothing where no record can be read."""
    try:
        with zipfile.ZipFile(root / PRISTINE) as archive:
            return {name: archive.read(name) for name in archive.namelist()}
    except UNREADABLE_ZIP:
        return {}


def _write_pristine(root: Path, files: Mapping[str, bytes]) -> None:
    packed = BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files):
            archive.writestr(zipfile.ZipInfo(name, ZIP_DATE), files[name], zipfile.ZIP_DEFLATED)
    write_whole(root / PRISTINE, packed.getvalue())


def hide_outputs(page: bytes, language: str) -> bytes:
    """Return a page without the outputs that it asks to predict, with the texts that describe them folded."""
    if f'"{PREDICTED}"'.encode() not in page:
        return page
    notebook = json.loads(page)
    for cell in notebook["cells"]:
        if PREDICTED not in cell["metadata"].get("tags", ()):
            continue
        if cell["cell_type"] == "code":
            cell.update(execution_count=None, outputs=[])
        else:
            cell["source"] = _folded("".join(cell["source"]), UNFOLD.say(language)).splitlines(keepends=True)
    return text_of(notebook).encode()


def strip_notes(page: bytes) -> bytes:
    """Return a page without what its cells say to the speaker alone; a page that says nothing is returned as it is."""
    notebook = json.loads(page)
    spoken = [cell["metadata"] for cell in notebook["cells"] if "notes" in cell["metadata"].get("tflab", ())]
    for metadata in spoken:
        del metadata["tflab"]["notes"]
        if not metadata["tflab"]:
            del metadata["tflab"]
    return text_of(notebook).encode() if spoken else page


def handed_out_in(folder: Path, copy: Path) -> dict[str, bytes]:
    """Return what an instructor handed out in a folder, whatever was written there since, for a learner's copy.

    Raises:
        WorkbookError: it is no such folder, or another learner's, or of another release.
    """
    theirs, mine = (read_workbook(root) if (root / MARK).is_file() else None for root in (folder, copy))
    if theirs is None or theirs.edition != "class":
        raise WorkbookError(f"{folder} is no folder that an instructor handed out; nothing was changed")
    if mine is None or (mine.edition, mine.learner) != (theirs.edition, theirs.learner):
        raise WorkbookError(f"{folder} is for {theirs.learner or 'a class'}, and your copy is not; nothing was changed")
    if (there := _releases(folder)) != (here := _releases(copy)):
        raise WorkbookError(
            f"{folder} is of the release {', '.join(there) or '(none)'}, your copy of {', '.join(here) or '(none)'}; "
            "nothing was changed"
        )
    return read_pristine(folder)


def _releases(root: Path) -> list[str]:
    """Return the releases whose stamps the exercises of a copy bear."""
    found = set()
    for name, content in read_pristine(root).items():
        if name.startswith("exercises/"):
            with suppress(ValueError, TypeError, KeyError):
                found.add(str(json.loads(content)["metadata"]["tflab"]["release"]))
    return sorted(found)


def _is_in(name: str, language: str) -> bool:
    """Return whether a file belongs to an edition in a language."""
    return PurePosixPath(name).parts[1] == language


def _folded(text: str, summary: str) -> str:
    """Return a text to be opened with a click; its heading, its own folds and what explains a figure stay in sight."""
    heading, rest = re.match(r"((?:#[^\n]*\n+)?)(.*)", text, re.DOTALL).groups()
    parts = []
    for part in OWN_FOLD.split(rest.strip()):
        if OWN_FOLD.fullmatch(part) or not part.strip():
            parts.append(part.strip())
            continue
        lines = part.strip().splitlines(keepends=True)
        last = [lines.pop()] if CAPTION in lines[-1] and len(lines) > 1 else []
        captions = [line for line in lines if CAPTION in line]
        told = "".join(line for line in lines if CAPTION not in line).strip()
        fold = f"<details><summary>{summary}</summary>\n\n{told}\n\n</details>" if told else ""
        parts += ["".join(captions).strip(), fold, *last]
    return heading + "\n\n".join(filter(None, parts))


def is_free(folder: Path) -> bool:
    """Return whether a copy may be laid out in a folder: it is not there yet, or holds nothing but hidden files."""
    if not folder.exists():
        return True
    return folder.is_dir() and all(path.name.startswith(".") for path in folder.iterdir())


def has_language(root: Path, language: str) -> bool:
    """Return whether a copy has pages in a language."""
    return any((root / "notebooks" / language).glob("*.ipynb"))


def _update_file(
    root: Path, name: str, content: bytes, base: bytes | None, backup: Path, language: str
) -> Change | None:
    """Bring one file up to date that was handed out as `base`; None if nothing had to change."""
    path = root / name
    if not path.exists():
        write_whole(path, content)
        return Change(name, "new")
    mine = path.read_bytes()
    if mine == content or base == content:  # the same already, or nothing new
        return None
    merged: Merged | None = Merged(content)
    if mine != base and path.suffix == ".ipynb":
        merged = merge_notebooks(base, mine, content, language=language, version=__version__)
    if merged is None:
        write_whole(path.with_name(f"{path.stem}.new-{__version__}.ipynb"), content)
        return Change(name, "kept")
    if merged.content != mine:
        write_whole(root / backup / name, mine)
        write_whole(path, merged.content)
    return Change(name, "merged" if merged.kept or merged.beside else "replaced", merged.kept, merged.beside)


def _next_backup(root: Path) -> Path:
    number = 1
    while (root / BACKUPS / str(number)).exists():
        number += 1
    return BACKUPS / str(number)
