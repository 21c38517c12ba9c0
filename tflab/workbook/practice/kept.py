"""What was asked, when, and what comes next?  A small file in the copy, beside `progress.json`, and apart from it.

    practice.json   {"format": 1, "open": {"number": 18, "task": "E3.2", ...},
                     "ideas": {"M3": {"box": 1, "shown": 2, ...}},
                     "asked": [{"number": 17, "task": "E1.4", "idea": "M9", "at_s": ..., "came": "right"}, ...]}

What is asked stands there before it is shown, and what was typed as soon as it was:
whatever ends the program, the next one goes on from there.  No mark, no objective and
no line of the checklist is read from it.  Where there is no copy, it lasts as long as
the program.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path

from ..places import MARK
from ..progress import keep_aside
from ..whole_files import locked, write_whole
from .spacing import LAST_BOX, Idea, Pick

__all__ = ["FILE", "Kept", "Open", "Practised", "change_kept", "read_kept"]

FILE = "practice.json"
FORMAT = 1
_unwritten: dict[Path, Kept] = {}  # where there is no copy


@dataclass(frozen=True)
class Open:
    """The question that waits for an answer.

    Attributes:
        number: of the question, from 1; its draw is made from it.
        tries, hints: how many wrong answers were given to it, each counted once, and how many hints were read.
        seen: what came of each of these answers, hashed.
        shown: the misconceptions that its answers showed.
        typed: what was typed at the prompt, by part.
    """

    number: int
    task: str
    idea: str
    why: str
    tries: int = 0
    hints: int = 0
    shown: tuple[str, ...] = ()
    typed: dict[str, str] = field(default_factory=dict)
    seen: tuple[str, ...] = ()

    @property
    def choice(self) -> Pick:
        """Return what was chosen."""
        return Pick(self.task, self.idea, self.why)


@dataclass(frozen=True)
class Practised:
    """A question that is over: "right", "wrong" (at first), or "skipped"."""

    number: int
    task: str
    idea: str
    at_s: int
    came: str
    shown: tuple[str, ...] = ()


@dataclass(frozen=True)
class Kept:
    """All that practice knows of a learner.

    Attributes:
        exercises: how often each misconception stood in `progress.json` when it was looked at last.
    """

    open: Open | None = None
    ideas: dict[str, Idea] = field(default_factory=dict)
    asked: tuple[Practised, ...] = ()
    exercises: dict[str, int] = field(default_factory=dict)

    @property
    def number(self) -> int:
        """Return the number of the question that comes next."""
        return 1 + max((line.number for line in self.asked), default=0)

    @property
    def last_asked(self) -> dict[str, int]:
        """Return the number with which each task was asked last."""
        return {line.task: line.number for line in self.asked}


def read_kept(root: Path) -> Kept:
    """Return what is kept in a copy; a file that cannot be read is kept aside, and said."""
    path = root / FILE
    if not (root / MARK).is_file():
        return _unwritten.get(root, Kept())
    if not path.is_file():
        return Kept()
    try:
        return _from_plain(json.loads(path.read_text(encoding="utf-8")))
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        keep_aside(path, error)
        return Kept()


def change_kept(root: Path, change: Callable[[Kept], Kept]) -> Kept:
    """Read, change and write what is kept under the copy's lock; return what it is then."""
    if not (root / MARK).is_file():
        _unwritten[root] = change(read_kept(root))
        return _unwritten[root]
    try:
        with locked(root):
            kept = change(read_kept(root))
            plain = {"format": FORMAT, **asdict(kept)}
            write_whole(root / FILE, json.dumps(plain, indent=1, ensure_ascii=False, sort_keys=True) + "\n")
            _unwritten.pop(root, None)
    except OSError as error:
        print(f"tflab: your practice could not be written to {root / FILE}: {error}", file=sys.stderr)
        kept = _unwritten[root] = change(_unwritten.get(root) or read_kept(root))
    return kept


def _from_plain(found: dict) -> Kept:
    if found["format"] != FORMAT:
        raise ValueError(f"it has format {found['format']}, and this tflab knows format {FORMAT}")
    ideas = {name: _idea(line) for name, line in found["ideas"].items()}
    asked = tuple(_with_tuple(Practised(**line)) for line in found["asked"])
    opened = None if found["open"] is None else _with_tuple(Open(**found["open"]))
    opened = opened and replace(opened, seen=tuple(map(str, opened.seen)))
    exercises = {str(name): int(count) for name, count in found["exercises"].items()}
    if opened is not None and not (isinstance(opened.typed, dict) and opened.number > 0):
        raise ValueError("the open question is damaged")
    return Kept(opened, ideas, asked, exercises)


def _idea(line: dict) -> Idea:
    idea = Idea(**line)
    if not all(type(value) is int for value in asdict(idea).values()) or not 1 <= idea.box <= LAST_BOX:
        raise ValueError(f"an idea is {line!r}")
    return idea


def _with_tuple(line):
    if not isinstance(line.number, int) or not all(isinstance(text, str) for text in (line.task, line.idea)):
        raise ValueError(f"a question is {line!r}")
    return replace(line, shown=tuple(map(str, line.shown)))
