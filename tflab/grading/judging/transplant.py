"""What of a notebook counts?  The answers, and the learner's own cells between ours; everything else is the master's.

    master                    handed in                 what runs
    load                      load (changed)            load            the master's
                              import math               import math     the learner's own
    e3-2-given                e3-2-given                e3-2-given      the master's
    e3-2-answer  x = ...      e3-2-answer  x = f(2)     e3-2-answer     the learner's
    e3-2-check                e3-2-check                <probe E3.2>

A cell is known by the task that its metadata names, then by its id, then by its
text.  Two different cells that answer under one name void that answer and no other;
a copy that answers nothing is a cell of the learner's own.  Own cells stay behind the
cell of ours that they were put behind.  An answer that only a cell behind the check
completes is seen by a second probe there.

Read `plan.py` next.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from tflab.workbook.tasks.task import slug

from ..submissions.reader import SubmittedCell, SubmittedNotebook
from ..submissions.remarks import Remark

__all__ = ["Master", "MasterCell", "Piece", "Transplant", "answers_most", "master_of", "transplant"]

ROLES = ("given", "answer", "check")


@dataclass(frozen=True, slots=True)
class MasterCell:
    """A code cell of the exercise as it was handed out."""

    name: str
    source: str
    task: str = ""
    role: str = ""


@dataclass(frozen=True, slots=True)
class Master:
    """A chapter's exercise as it was handed out: its code cells in order, and its tasks."""

    chapter: str
    cells: tuple[MasterCell, ...]

    @property
    def tasks(self) -> tuple[str, ...]:
        """The tasks in the order of the page."""
        return tuple(dict.fromkeys(cell.task for cell in self.cells if cell.task))

    def asked(self) -> dict[str, set[str]]:
        """Return for each task the names that its check asks for: of what its answer defines, what the check says."""
        checks = {cell.task: set(re.findall(r"\w+", cell.source)) for cell in self.cells if cell.role == "check"}
        defined = {cell.task: _defined(cell.source) for cell in self.cells if cell.role == "answer"}
        return {task: names & checks.get(task, names) or names for task, names in defined.items()}


@dataclass(frozen=True, slots=True)
class Piece:
    """One thing to run, or the place of a probe.

    Attributes:
        kind: "ours", "own" (the learner's helper cell), "answer", "stub" (an answer cell left as it was), or "probe".
        name: the cell's name; an own cell has one of ours with a number.
    """

    kind: str
    name: str
    source: str = ""
    task: str = ""


@dataclass(frozen=True)
class Transplant:
    """What to run, which tasks have an answer at all, and what is to be said about it."""

    pieces: tuple[Piece, ...]
    answered: tuple[str, ...]
    remarks: tuple[Remark, ...] = ()


class _Text(NamedTuple):
    """What a cell that claims one of our names holds, and which cell of the notebook it is."""

    source: str
    is_code: bool
    place: int


@dataclass
class _Found:
    """What was found in a notebook: for each of our names its texts, and the own cells behind it."""

    texts: dict[str, list[_Text]] = field(default_factory=dict)
    own: dict[str, list[str]] = field(default_factory=dict)


def master_of(notebook: Mapping, chapter: str, tasks: Iterable[str]) -> Master:
    """Return the master that an exercise notebook is; `notebook` is one of ours."""
    by_name = {f"{slug(task)}-{role}": (task, role) for task in tasks for role in ROLES}
    cells = [
        MasterCell(cell["id"], "".join(cell["source"]), *by_name.get(cell["id"], ("", "")))
        for cell in notebook["cells"]
        if cell["cell_type"] == "code"
    ]
    return Master(chapter, tuple(cells))


def answers_most(master: Master, handed_in: SubmittedNotebook) -> bool:
    """Return whether a notebook in which none of our cells is left answers most tasks all the same.

    A page to read may define one of the names, too.
    """
    defined = set().union(*(_defined(cell.source) for cell in handed_in.cells if cell.kind == "code"))
    asked = master.asked().values()
    return 2 * sum(bool(names & defined) for names in asked) > len(asked)


def transplant(master: Master, handed_in: SubmittedNotebook) -> Transplant:
    """Return what runs of a notebook in the place of the master's answers."""
    asked = master.asked()
    found = _find(master, handed_in.cells, asked)
    answers = [cell for cell in master.cells if cell.role == "answer"]
    lost = {cell.task for cell in answers if cell.name not in found.texts}
    kept_texts = {cell.name: _kept_texts(cell, found, asked, lost) for cell in master.cells}
    # With cells of their own, or an answer in another's cell, one may stand anywhere: look at every task then.
    wrote_elsewhere = bool(found.own) or any(kept_texts.values()) or _holds(found, asked, lost)
    sources = {cell.name: _source(cell, found, asked) for cell in master.cells}
    stubs = {cell.task: cell for cell in answers if _same(sources[cell.name][0], cell.source)}
    to_fill = {task: _stub(cell, asked[task] if task in lost else ()) for task, cell in stubs.items()}
    before_tasks = [cell.name for cell in master.cells[: _first_task(master)]]
    with_given = {cell.task for cell in master.cells if cell.role == "given"}
    pieces: list[Piece] = [_own("", number, text) for number, text in enumerate(found.own.get("", ()))]
    answered = []
    for cell in master.cells:
        source, complaint = sources[cell.name]
        if cell.role in ("", "given"):
            pieces.append(Piece("ours", cell.name, cell.source, cell.task))
        # What was left as it was comes first, so that it undoes no answer that stands in a cell of the learner's.
        if cell.role == "given" and cell.task in stubs:
            pieces.append(to_fill[cell.task])
        if before_tasks and cell.name == before_tasks[-1]:
            pieces += [stub for task, stub in to_fill.items() if task not in with_given]
        if cell.role == "answer" and cell.task not in stubs:
            pieces.append(Piece("answer", cell.name, source, cell.task))
        if cell.role == "answer" and (wrote_elsewhere or cell.task not in stubs) and not _is_void(complaint):
            answered.append(cell.task)
        texts = kept_texts[cell.name] + found.own.get(cell.name, [])
        own = [_own(cell.name, number, text, cell.task) for number, text in enumerate(texts)]
        probe = [Piece("probe", cell.name, task=cell.task)] if cell.role == "check" else []
        # It may also be completed behind the check: look again there.
        again = [Piece("probe", f"{cell.name}-again", task=cell.task)] if probe and own else []
        pieces += [*probe, *own, *again]
    if wrote_elsewhere:  # what was left as it was may be answered there, wherever it stands
        open_ = {cell.task for cell in answers if not _defined(sources[cell.name][0]) & _defined(cell.source)}
        checks = [cell for cell in master.cells if cell.role == "check" and cell.task in open_ | set(stubs)]
        pieces += [
            Piece("probe", f"{cell.name}-again", task=cell.task)
            for cell in checks
            if _is_written_behind(pieces, cell, lost)
        ]
    remarks = tuple(complaint for _, complaint in sources.values() if complaint)
    void = {remark.task for remark in remarks if _is_void(remark)}
    kept = tuple(piece for piece in pieces if piece.kind != "probe" or piece.task not in void)
    return Transplant(kept, tuple(answered), remarks)


def _first_task(master: Master) -> int:
    return next((number for number, cell in enumerate(master.cells) if cell.task), len(master.cells))


def _is_written_behind(pieces: Sequence[Piece], check: MasterCell, lost: set[str]) -> bool:
    """Return whether there is a cell behind the last probe of a task that may answer it."""
    kinds = ("own", "answer") if check.task in lost else ("own",)
    last = max(number for number, piece in enumerate(pieces) if (piece.kind, piece.task) == ("probe", check.task))
    return any(piece.kind in kinds for piece in pieces[last:])


def _stub(cell: MasterCell, unless: Iterable[str]) -> Piece:
    """Return what fills the place of an answer; if its cell is gone, unless another cell has answered already."""
    names = ", ".join(map(repr, sorted(unless)))
    source = f"if not {{{names}}} & set(globals()): exec({cell.source!r})" if names else cell.source
    return Piece("stub", f"{cell.name}-stub", source, cell.task)


def _find(master: Master, cells: Iterable[SubmittedCell], asked: Mapping[str, set[str]]) -> _Found:
    cells = tuple(cells)
    names = _names(master, cells)
    for cell in master.cells:
        if cell.role == "answer":
            for number in _scratch(cell, cells, names, asked[cell.task]):
                del names[number]
    found, last = _Found(), ""
    for number, cell in enumerate(cells):
        name = names.get(number)
        if name is not None:
            found.texts.setdefault(name, []).append(_Text(cell.source, cell.kind == "code", number))
            last = name
        elif cell.kind == "code" and cell.source.strip():
            found.own.setdefault(last, []).append(cell.source)
    return found


def _names(master: Master, cells: Sequence[SubmittedCell]) -> dict[int, str]:
    """Return which cells are which of ours."""
    known = {cell.name for cell in master.cells}
    texts = {_bare(cell.source): cell.name for cell in master.cells}
    claimed = {claim for cell in cells for claim in cell.claims if claim in known}
    names = {}
    for number, cell in enumerate(cells):
        name = next((claim for claim in cell.claims if claim in known), None)
        if name is None and cell.kind == "code":
            by_text = texts.get(_bare(cell.source))
            name = by_text if by_text not in claimed else None
        if name is not None:
            names[number] = name
    return names


def _scratch(
    answer: MasterCell, cells: Sequence[SubmittedCell], names: Mapping[int, str], asked: set[str]
) -> list[int]:
    """Return the cells that only have an answer's name: copies to try something in, while one other cell answers."""
    mine = [number for number, name in names.items() if name == answer.name and cells[number].kind == "code"]
    changed = {number: text for number in mine if (text := _bare(cells[number].source)) != _bare(answer.source)}
    answering = {number for number, text in changed.items() if _defined(text) & asked}
    halves = list(changed) == list(range(min(changed, default=0), min(changed, default=0) + len(changed)))
    if halves or len({changed[number] for number in answering}) != 1:
        return []
    return [number for number in changed if number not in answering]


def _holds(found: _Found, asked: Mapping[str, set[str]], lost: set[str]) -> bool:
    """Return whether a task whose cell is gone is answered in a cell of another."""
    wanted = set().union(*(asked[task] for task in lost))
    return bool(wanted) and any(
        _defined(text.source) & wanted for texts in found.texts.values() for text in texts if text.is_code
    )


def _source(cell: MasterCell, found: _Found, asked: Mapping[str, set[str]]) -> tuple[str, Remark | None]:
    """Return the text of one of our cells as it is to run, and what there is to say about it."""
    there = found.texts.get(cell.name, [])
    code = {_bare(text.source): text for text in there if text.is_code}
    changed = [text for bare, text in code.items() if bare and bare != _bare(cell.source)]
    if cell.role != "answer":
        return cell.source, Remark("changed", cell.task, cell=cell.name) if changed and cell.task else None
    if len(changed) > 1 and not _is_split(changed, asked[cell.task]):
        return cell.source, Remark("twice", cell.task, cell=cell.name)
    if there and not code:
        return cell.source, Remark("no code", cell.task, cell=cell.name)
    if not there:
        return cell.source, Remark("missing", cell.task, cell=cell.name)
    return "\n".join(text.source for text in changed) if changed else cell.source, None


def _is_split(texts: list[_Text], asked: set[str]) -> bool:
    """Return whether these are one answer that was split over neighbouring cells, not several answers.

    An editor that splits a cell gives both halves its name. Then only one of them defines what is asked for.
    """
    places = [text.place for text in texts]
    if places != list(range(places[0], places[0] + len(places))):
        return False
    return sum(bool(_defined(text.source) & asked) for text in texts) == 1


def _defined(source: str) -> set[str]:
    """Return the names that a cell defines at its top level; what cannot be parsed may define any."""
    lines = (line for line in source.splitlines() if not line.startswith(("%", "!")))
    try:
        body = ast.parse("\n".join(lines)).body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return set(re.findall(r"^(?:(?:async )?def |class )?(\w+)", source, flags=re.MULTILINE))
    names = {node.name for node in body if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef)}
    lines_of_code = [line for line in body if not hasattr(line, "name")]
    stored = [node for line in lines_of_code for node in ast.walk(line) if isinstance(node, ast.Name)]
    return names | {node.id for node in stored if isinstance(node.ctx, ast.Store)}


def _is_void(remark: Remark | None) -> bool:
    return remark is not None and remark.kind in ("twice", "no code")


def _kept_texts(cell: MasterCell, found: _Found, asked: Mapping[str, set[str]], lost: set[str]) -> list[str]:
    """Return what the learner wrote into a cell of ours that is not theirs, where it can still serve.

    More imports in the imports, or the answer in the check; what is given only where the answer's cell was merged
    into it.
    """
    if cell.role == "answer" or (cell.role == "given" and cell.task not in lost):
        return []
    texts = dict.fromkeys(text.source for text in found.texts.get(cell.name, ()) if text.is_code)
    kept = [text for text in texts if text.strip() and not _same(text, cell.source)][:1]
    return kept if cell.role != "given" or any(_defined(text) & asked[cell.task] for text in kept) else []


def _own(behind: str, number: int, text: str, task: str = "") -> Piece:
    return Piece("own", f"{behind or 'top'}+{number + 1}", text, task)


def _same(one: str, other: str) -> bool:
    return _bare(one) == _bare(other)


def _bare(text: str) -> str:
    return "\n".join(line.rstrip() for line in text.strip().split("\n"))
