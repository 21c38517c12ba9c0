"""Record what a learner has tried and passed in `progress.json`, beside `workbook.json`.

    progress.json   {"format": 1, "tasks": {"E3.2": {"tries": 3, "hints": 1, "passed": true, ...}}}

It never leaves the machine.  A copy without `workbook.json` keeps no file: tflab's
own pages are read, not worked in.  What the file means for the course's objectives
and checklist is said in `progress_page.py`.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from hashlib import sha256
from pathlib import Path

from .answers.values import Plain
from .atomic_files import locked, write_whole
from .paths import MARK

__all__ = [
    "FILE",
    "FORMAT",
    "Attempts",
    "attempts",
    "keep_aside",
    "mark_of",
    "read_progress",
    "record_answers",
    "record_hint",
    "record_try",
]

FILE = "progress.json"
FORMAT = 1


@dataclass
class Attempts:
    """What happened with one task.

    Attributes:
        tries: how many answers were checked; one that was checked before is no new try.
        hints: how many hints were asked for.
        passed: whether any try got everything right.
        best: the most that was right at once, and `of` how many, in that try.
        twins: the mistakes that were named, by name, and how often (the name in files that learners have).
        answers: where taking part counts, the first complete answers.
        seen: what came of each of them, hashed.
    """

    tries: int = 0
    hints: int = 0
    passed: bool = False
    best: int = 0
    of: int = 0
    twins: dict[str, int] = field(default_factory=dict)
    answers: dict[str, str] = field(default_factory=dict)
    seen: list[str] = field(default_factory=list)


def record_try(
    root: Path, task_id: str, passed: int, of: int, mistake: str | None = None, outcomes: Sequence[Plain] = ()
) -> None:
    """Write down that an answer was checked: `passed` of `of` were right, and which mistake it was.

    Args:
        outcomes: what came of it.  What has been seen before is the same answer again, and counts once.
    """
    mark = mark_of(outcomes) if outcomes else ""

    def tried(task: Attempts) -> None:
        task.passed = task.passed or (of > 0 and passed >= of)
        if not task.of or passed * task.of >= task.best * of:
            task.best, task.of = passed, of
        if mark in task.seen:
            return
        task.seen += [mark] if mark else []
        task.tries += 1
        if mistake:
            task.twins[mistake] = task.twins.get(mistake, 0) + 1

    _change(Path(root), task_id, tried)


def mark_of(outcomes: Sequence[Plain]) -> str:
    """Return a short mark of what came of an answer, the same for the same."""
    return sha256(repr(outcomes).encode()).hexdigest()[:16]


def record_hint(root: Path, task_id: str) -> int:
    """Write down that a hint was asked for, and return how many now were; 0 where nothing is kept."""

    def hinted(task: Attempts) -> None:
        task.hints += 1

    return _change(Path(root), task_id, hinted).hints


def record_answers(root: Path, task_id: str, answers: dict[str, str]) -> dict[str, str]:
    """Write down somebody's answers if these are the first; return those that are kept, {} where nothing is."""

    def answered(task: Attempts) -> None:
        task.answers = task.answers or dict(answers)

    return _change(Path(root), task_id, answered).answers


def attempts(root: Path, task_id: str) -> Attempts:
    """Return what happened with a task; nothing, where nothing is kept."""
    return read_progress(Path(root)).get(task_id, Attempts())


def read_progress(root: Path) -> dict[str, Attempts]:
    """Return what happened with each task; a file that cannot be read is kept aside, and said."""
    path = Path(root) / FILE
    if not (Path(root) / MARK).is_file() or not path.is_file():
        return {}
    try:
        return _tasks(json.loads(path.read_text(encoding="utf-8")))
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        keep_aside(path, error)
        return {}


def _change(root: Path, task_id: str, change) -> Attempts:
    """Read, change and write a task's line under the lock, so that two notebooks lose nothing."""
    task = Attempts()
    if not (root / MARK).is_file():
        return task
    try:
        with locked(root):
            tasks = read_progress(root)
            task = tasks.setdefault(task_id, task)
            change(task)
            kept = {name: asdict(tasks[name]) for name in sorted(tasks)}
            text = json.dumps({"format": FORMAT, "tasks": kept}, indent=1, ensure_ascii=False)
            write_whole(root / FILE, text + "\n")
    except OSError as error:
        print(f"tflab: your progress could not be written to {root / FILE}: {error}", file=sys.stderr)
    return task


def _tasks(found: dict) -> dict[str, Attempts]:
    if found["format"] != FORMAT:
        raise ValueError(f"it has format {found['format']}, and this tflab knows format {FORMAT}")
    return {name: _attempts(line) for name, line in found["tasks"].items()}


def _attempts(line: dict) -> Attempts:
    read = Attempts(**line)
    for name, value in asdict(Attempts()).items():
        if type(getattr(read, name)) is not type(value):
            raise ValueError(f'"{name}" is {getattr(read, name)!r}')
    return read


def keep_aside(path: Path, error: Exception) -> None:
    """Give a file that cannot be read another name, and say so."""
    number = 1
    while (aside := path.with_name(f"{path.stem}.kept-{number}.json")).exists():
        number += 1
    try:
        path.rename(aside)
    except FileNotFoundError:  # another notebook was quicker, and has said so
        return
    print(
        f"tflab: {path.name} cannot be read ({error}).\n"
        f"It is kept as {aside.name}, and a new one begins; the answers in your notebooks are untouched.\n"
        f"To have it back: repair {aside.name} or install the tflab that wrote it, and rename it to {path.name}.",
        file=sys.stderr,
    )
