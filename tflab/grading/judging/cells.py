"""Match the cells of a handed-in notebook with those of the exercise as it was released.

    master           handed in                            Theirs
    load             load            (changed)            a remark; ours runs
                     import math                          own, behind "load"
    e3-2-answer      e3-2-answer     x = f(2)             the answer
    e3-3-answer      (deleted)                            lost: another cell may hold it
    e3-4-answer      e3-4-answer     as it was            a stub
    e3-5-answer      e3-5-answer     twice, different     void

A cell is known by the task that its metadata names, then by its id, then by its text.
A copy that answers nothing is a cell of the learner's own (record linkage, in the
words of databases).
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import NamedTuple

from tflab.workbook.tasks.task import slug

from ..submissions.reader import SubmittedCell, SubmittedNotebook
from ..submissions.remarks import Remark

__all__ = ["VOID", "Master", "MasterCell", "NotebookMatch", "answers_most", "defines", "master_of", "match_notebook"]

ROLES = ("given", "answer", "check")
VOID = ("twice", "no code")
LONGEST_PARSED = 20_000  # characters of a cell: the parser takes a second for ten times as many


@dataclass(frozen=True, slots=True)
class MasterCell:
    """A code cell of the exercise as it was handed out, and as it was before, if the release has been updated."""

    name: str
    source: str
    task: str = ""
    role: str = ""
    earlier: Sequence[str] = ()


@dataclass(frozen=True)
class Master:
    """A chapter's exercise as it was handed out: its code cells in order, and its tasks."""

    chapter: str
    cells: tuple[MasterCell, ...]

    @property
    def tasks(self) -> tuple[str, ...]:
        """The tasks in the order of the page."""
        return tuple(dict.fromkeys(cell.task for cell in self.cells if cell.task))

    @cached_property
    def answers(self) -> tuple[MasterCell, ...]:
        """The cells that are to be answered."""
        return tuple(cell for cell in self.cells if cell.role == "answer")

    @cached_property
    def asked(self) -> dict[str, frozenset[str]]:
        """The names that each task's check asks for: of what its answer defines, what the check says."""
        checks = {cell.task: set(re.findall(r"\w+", cell.source)) for cell in self.cells if cell.role == "check"}
        names = {cell.task: defines(cell.source) for cell in self.answers}
        return {task: there & checks.get(task, there) or there for task, there in names.items()}


class ClaimedCell(NamedTuple):
    """What a cell that claims one of our names holds, and which cell of the notebook it is."""

    source: str
    is_code: bool
    place: int


@dataclass(frozen=True)
class NotebookMatch:
    """A notebook, laid beside the master.

    Attributes:
        texts: what it holds under each of our names.
        own: the learner's own cells behind each of our names; "" is the top.
        sources: our cells as they are to run: an answer is theirs, all else ours.
        complaints: what there is to say about a cell of ours.
        lost: tasks whose answer's cell is gone.
        stubs: tasks whose answer's cell is as it was handed out.
        void: tasks that two cells answer, or that a text does.
        kept: what of a cell of ours that is not theirs may still serve: more imports, an answer in the check.
    """

    texts: Mapping[str, Sequence[ClaimedCell]]
    own: Mapping[str, Sequence[str]]
    sources: Mapping[str, str]
    complaints: tuple[Remark, ...]
    lost: frozenset[str]
    stubs: frozenset[str]
    void: frozenset[str]
    kept: Mapping[str, Sequence[str]]
    wrote_elsewhere: bool  # one who has cells of their own may have answered in them: look at every task then


def master_of(notebook: Mapping, chapter: str, tasks: Iterable[str], earlier: Sequence[Mapping] = ()) -> Master:
    """Return the master that an exercise notebook is; `notebook` is one of ours, and so are its `earlier` versions."""
    by_name = {f"{slug(task)}-{role}": (task, role) for task in tasks for role in ROLES}
    before: dict[str, list[str]] = {}
    for name, source in (cell for older in earlier for cell in _code_of(older)):
        before.setdefault(name, []).append(source)
    cells = [
        MasterCell(name, source, *by_name.get(name, ("", "")), tuple(dict.fromkeys(before.get(name, ()))))
        for name, source in _code_of(notebook)
    ]
    return Master(chapter, tuple(cells))


def _code_of(notebook: Mapping) -> list[tuple[str, str]]:
    return [(cell["id"], "".join(cell["source"])) for cell in notebook["cells"] if cell["cell_type"] == "code"]


def answers_most(master: Master, handed_in: SubmittedNotebook) -> bool:
    """Return whether a notebook in which none of our cells is left answers most tasks all the same.

    A page to read may define one of the names, too.
    """
    there = set().union(*(defines(cell.source) for cell in handed_in.cells if cell.kind == "code"))
    asked = master.asked.values()
    return 2 * sum(bool(names & there) for names in asked) > len(asked)


def match_notebook(master: Master, handed_in: SubmittedNotebook) -> NotebookMatch:
    """Return a notebook laid beside the master."""
    cells = handed_in.cells
    names = _without_scratch(master, cells, _names(master, cells))
    texts, own = _sorted_by_name(cells, names)
    texts = _as_handed_out_now(master, texts)
    judged = {cell.name: _source(cell, texts.get(cell.name, ()), master.asked) for cell in master.cells}
    sources = {name: source for name, (source, _) in judged.items()}
    complaints = tuple(complaint for _, complaint in judged.values() if complaint is not None)
    lost = frozenset(cell.task for cell in master.answers if cell.name not in texts)
    kept = {cell.name: _kept(cell, texts.get(cell.name, ()), master.asked, lost) for cell in master.cells}
    return NotebookMatch(
        texts=texts,
        own=own,
        sources=sources,
        complaints=complaints,
        lost=lost,
        stubs=frozenset(cell.task for cell in master.answers if _same(sources[cell.name], cell.source)),
        void=frozenset(remark.task for remark in complaints if remark.kind in VOID),
        kept=kept,
        wrote_elsewhere=bool(own) or any(kept.values()) or _holds_what_is_lost(texts, master.asked, lost),
    )


# -- whose is this cell? -------------------------------------------------------------------


def _names(master: Master, cells: Sequence[SubmittedCell]) -> dict[int, str]:
    """Return which cells are which of ours."""
    known = {cell.name for cell in master.cells}
    texts = {_bare(text): cell.name for cell in master.cells for text in (*cell.earlier, cell.source)}
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


def _without_scratch(master: Master, cells: Sequence[SubmittedCell], names: Mapping[int, str]) -> dict[int, str]:
    """Return the names without those of copies that answer nothing."""
    scratch = {number for answer in master.answers for number in _scratch(answer, cells, names, master.asked)}
    return {number: name for number, name in names.items() if number not in scratch}


def _scratch(
    answer: MasterCell, cells: Sequence[SubmittedCell], names: Mapping[int, str], asked: Mapping[str, frozenset[str]]
) -> list[int]:
    """Return the cells that only have an answer's name: copies to try something in, while one other cell answers."""
    mine = [number for number, name in names.items() if name == answer.name and cells[number].kind == "code"]
    changed = {number: text for number in mine if (text := _bare(cells[number].source)) != _bare(answer.source)}
    answering = {number for number, text in changed.items() if defines(text) & asked[answer.task]}
    halves = list(changed) == list(range(min(changed, default=0), min(changed, default=0) + len(changed)))
    if halves or len({changed[number] for number in answering}) != 1:
        return []
    return [number for number in changed if number not in answering]


def _sorted_by_name(
    cells: Sequence[SubmittedCell], names: Mapping[int, str]
) -> tuple[dict[str, list[ClaimedCell]], dict[str, list[str]]]:
    """Return the texts under each of our names, and the own cells behind each."""
    texts: dict[str, list[ClaimedCell]] = {}
    own: dict[str, list[str]] = {}
    last = ""
    for number, cell in enumerate(cells):
        name = names.get(number)
        if name is not None:
            texts.setdefault(name, []).append(ClaimedCell(cell.source, cell.kind == "code", number))
            last = name
        elif cell.kind == "code" and cell.source.strip():
            own.setdefault(last, []).append(cell.source)
    return texts, own


def _as_handed_out_now(master: Master, texts: Mapping[str, list[ClaimedCell]]) -> dict[str, list[ClaimedCell]]:
    """Return the texts under our names, what was handed out before an update as what is handed out now."""
    now = {}
    for cell in (cell for cell in master.cells if cell.name in texts):
        before = {_bare(text) for text in cell.earlier}
        now[cell.name] = [
            text._replace(source=cell.source) if _bare(text.source) in before else text for text in texts[cell.name]
        ]
    return now


# -- what of it counts? --------------------------------------------------------------------


def _source(
    cell: MasterCell, there: Sequence[ClaimedCell], asked: Mapping[str, frozenset[str]]
) -> tuple[str, Remark | None]:
    """Return the text of one of our cells as it is to run, and what there is to say about it."""
    code = {_bare(text.source): text for text in there if text.is_code}
    changed = [text for bare, text in code.items() if bare and bare != _bare(cell.source)]
    if cell.role != "answer":
        return cell.source, Remark("changed", cell.task, cell=cell.name) if changed and cell.task else None
    fault = _fault_of_an_answer(there, changed, asked[cell.task])
    if fault:
        return cell.source, Remark(fault, cell.task, cell=cell.name)
    return "\n".join(text.source for text in changed) if changed else cell.source, None


def _fault_of_an_answer(there: Sequence[ClaimedCell], changed: Sequence[ClaimedCell], asked: frozenset[str]) -> str:
    """Return the kind of remark on an answer's cell that cannot be taken as it is, or ""."""
    if not there:
        return "missing"
    if not any(text.is_code for text in there):
        return "no code"
    return "twice" if len(changed) > 1 and not _is_split(changed, asked) else ""


def _is_split(texts: Sequence[ClaimedCell], asked: frozenset[str]) -> bool:
    """Return whether these are one answer that was split over neighbouring cells, not several answers.

    An editor that splits a cell gives both halves its name. Then only one of them defines what is asked for.
    """
    places = [text.place for text in texts]
    if places != list(range(places[0], places[0] + len(places))):
        return False
    return sum(bool(defines(text.source) & asked) for text in texts) == 1


def _kept(
    cell: MasterCell, there: Sequence[ClaimedCell], asked: Mapping[str, frozenset[str]], lost: frozenset[str]
) -> Sequence[str]:
    """Return what the learner wrote into a cell of ours that is not theirs, where it can still serve.

    More imports in the imports, or the answer in the check; what is given only where the answer's cell was merged
    into it.
    """
    if cell.role == "answer" or (cell.role == "given" and cell.task not in lost):
        return []
    texts = dict.fromkeys(text.source for text in there if text.is_code)
    kept = [text for text in texts if text.strip() and not _same(text, cell.source)][:1]
    return kept if cell.role != "given" or any(defines(text) & asked[cell.task] for text in kept) else []


def _holds_what_is_lost(
    texts: Mapping[str, Sequence[ClaimedCell]], asked: Mapping[str, frozenset[str]], lost: frozenset[str]
) -> bool:
    """Return whether a task whose cell is gone is answered in a cell of another."""
    wanted = set().union(*(asked[task] for task in lost))
    return bool(wanted) and any(
        defines(text.source) & wanted for there in texts.values() for text in there if text.is_code
    )


# -- what is in a cell? --------------------------------------------------------------------


@lru_cache(maxsize=4096)
def defines(source: str) -> frozenset[str]:
    """Return the names that a cell defines at its top level; what cannot be parsed, or is very long, may define any."""
    lines = (line for line in source.splitlines() if not line.startswith(("%", "!")))
    try:
        body = ast.parse("\n".join(lines)).body if len(source) <= LONGEST_PARSED else None
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        body = None
    if body is None:
        return frozenset(re.findall(r"^(?:(?:async )?def |class )?(\w+)", source, flags=re.MULTILINE))
    names = {node.name for node in body if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef)}
    lines_of_code = [line for line in body if not hasattr(line, "name")]
    stored = [node for line in lines_of_code for node in ast.walk(line) if isinstance(node, ast.Name)]
    return frozenset(names | {node.id for node in stored if isinstance(node.ctx, ast.Store)})


def _same(mine: str, other: str) -> bool:
    return _bare(mine) == _bare(other)


def _bare(text: str) -> str:
    return "\n".join(line.rstrip() for line in text.strip().split("\n"))
