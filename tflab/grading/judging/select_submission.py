"""Select the notebook that counts for each chapter, of all files that a learner handed in.

    03.ipynb  03 (1).ipynb  notes.ipynb  broken.ipynb
       |          |             |            `-- unreadable: a line
       |          |             `-- of no chapter: a line
       `----------`-- candidates for 03: the one with most answers counts, or the latest, or the first

Nothing in here changes what it is handed: each step returns what it found.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from ..submissions.reader import SubmittedNotebook, Unreadable, read_notebook
from ..submissions.remarks import Remark
from .cells import Master, answers_most
from .job import HandedIn, Job
from .plan import MergedNotebook, merge_submission

__all__ = ["Candidate", "select_counting"]

ANSWER = re.compile(r"(e\d{1,3}-\d{1,3})-answer")
COPY = re.compile(r"-copy\d*$|(^|/)copy[ _-]of[ _-]|checkpoint$|[ _-]\(?copy\)?$|[ _-]복사본$|의 사본$", re.IGNORECASE)
WORTH_A_LINE = re.compile(r"(^|/)(notebooks|solutions)/")
MOST_UNKNOWN_TASKS = 5


class ReadFile(NamedTuple):
    """A file that could be read."""

    file: HandedIn
    notebook: SubmittedNotebook


@dataclass(frozen=True)
class Candidate:
    """A notebook that may be graded for a chapter, and what is to be said about it."""

    page: ReadFile
    merged: MergedNotebook
    remarks: tuple[Remark, ...] = ()

    @property
    def file(self) -> str:
        """The name of the file."""
        return self.page.file.name

    def without_data(self) -> Candidate:
        """Return the same without the bytes that were handed in."""
        return replace(self, page=self.page._replace(file=HandedIn(self.file)))


def select_counting(job: Job) -> tuple[dict[str, Candidate], tuple[Remark, ...]]:
    """Return for each chapter the notebook that counts, and what is to be said of the other files."""
    masters = job.masters()
    pages, unreadable = _pages(job.files)
    found = _candidates(pages, masters, job)
    taken = {candidate.file for several in found.values() for candidate in several}
    rest = [page for page in pages if page.file.name not in taken]
    known = {cell.name for master in masters.values() for cell in master.cells}
    chosen = {stem: _with_unknown_tasks(_best(stem, several, job.several), known) for stem, several in found.items()}
    return chosen, (*unreadable, *_remarks_on_the_rest(rest, masters, nothing_found=not found))


def _pages(files: Sequence[HandedIn]) -> tuple[list[ReadFile], list[Remark]]:
    """Return the files that are notebooks, and why the others are not."""
    pages, remarks = [], []
    for file in files:
        fault = file.fault
        if fault is None:
            try:
                pages.append(ReadFile(file, read_notebook(file.data)))
            except Unreadable as error:
                fault = error.remark
        if fault is not None:
            remarks.append(Remark("unreadable", file=file.name, why=fault))
    return pages, remarks


def _candidates(pages: Sequence[ReadFile], masters: Mapping[str, Master], job: Job) -> dict[str, list[Candidate]]:
    """Return the notebooks of each chapter; of one nobody handed in, those that say they are and answer most of it."""
    found: dict[str, list[Candidate]] = {}
    strangers = []
    for page in pages:
        stem = _chapter_of(page.notebook, masters)
        if stem is None:
            strangers.append(page)
        else:
            found.setdefault(stem, []).append(_candidate(page, masters[stem], job))
    for page in strangers:  # all in one cell of their own, perhaps
        stem = page.notebook.stamp.get("chapter", "")
        if stem in masters and stem not in found and answers_most(masters[stem], page.notebook):
            found[stem] = [_candidate(page, masters[stem], job)]
    return found


def _candidate(page: ReadFile, master: Master, job: Job) -> Candidate:
    remarks = [Remark("file", file=page.file.name, why=why) for why in page.notebook.remarks]
    return Candidate(page, merge_submission(master, page.notebook), (*remarks, *_remarks_on_the_stamp(page, job)))


def _chapter_of(notebook: SubmittedNotebook, masters: Mapping[str, Master]) -> str | None:
    """Return the chapter most of whose task cells are in a notebook, whatever the file says it is."""
    claims = {claim for cell in notebook.cells for claim in cell.claims}
    texts = {cell.source.strip() for cell in notebook.cells if cell.kind == "code"}
    share = {
        stem: sum(cell.name in claims or cell.source.strip() in texts for cell in master.cells if cell.task)
        for stem, master in masters.items()
    }
    best = max(share, key=lambda stem: share[stem], default=None)
    return best if best is not None and share[best] else None


def _best(stem: str, several: Sequence[Candidate], rule: str) -> Candidate:
    """Return the candidate that counts by the instructor's rule; with a line if another differs."""
    by_age = sorted(several, key=lambda candidate: _age(candidate.file), reverse=rule == "first")
    answered = {candidate.file: len(candidate.merged.answered) for candidate in several}
    best = max(reversed(by_age), key=lambda one: answered[one.file] if rule == "answers" else answered[one.file] > 0)
    others = [other for other in several if other is not best and answered[other.file]]
    if all(_texts(other) == _texts(best) for other in others):
        return best
    line = Remark("several", chapter=stem, file=best.file, rule=Remark(f"by {rule}"))
    return replace(best, remarks=(*best.remarks, line))


def _age(name: str) -> tuple[bool, list[tuple[int, str]]]:
    """Return what sorts a later attempt behind an earlier one, by its name; an editor's copies come first."""
    stem = name.rpartition(".")[0]
    runs = re.findall(r"\d+|\D+", stem)
    return not COPY.search(stem), [(int(run[:18]), "") if run.isdecimal() else (-1, run) for run in runs]


def _texts(candidate: Candidate) -> list[tuple[str, str]]:
    return [(cell.name, cell.source) for cell in candidate.merged.cells]


def _with_unknown_tasks(candidate: Candidate, known: set[str]) -> Candidate:
    """Return a candidate with a line for each answer cell of a task that is nowhere in the release."""
    claims = {claim for cell in candidate.page.notebook.cells for claim in cell.claims[:1]} - known
    tasks = sorted(match[1].upper().replace("-", ".") for match in map(ANSWER.fullmatch, claims) if match)
    lines = [Remark("unknown task", file=candidate.file, stamp=task) for task in tasks[:MOST_UNKNOWN_TASKS]]
    return replace(candidate, remarks=(*candidate.remarks, *lines))


def _remarks_on_the_stamp(page: ReadFile, job: Job) -> list[Remark]:
    stamp, name, lines = page.notebook.stamp, page.file.name, []
    if stamp.get("release") and stamp["release"] != job.release:
        lines.append(Remark("other release", file=name, stamp=stamp["release"][:16], ours=job.release))
    elif stamp.get("version") and stamp["version"] != job.version:
        lines.append(Remark("other version", file=name, stamp=stamp["version"][:16], ours=job.version))
    if job.has_roster and stamp.get("learner") and stamp["learner"] != job.learner:
        lines.append(Remark("other learner", file=name, stamp=stamp["learner"][:64], ours=job.learner))
    return lines


def _remarks_on_the_rest(
    rest: Sequence[ReadFile], masters: Mapping[str, Master], *, nothing_found: bool
) -> list[Remark]:
    """Return a line for each notebook of no chapter that calls itself one, or for all if there is no other."""
    names = [page.file.name for page in rest]
    calls_itself_one = [any(stem in name for stem in masters) and not WORTH_A_LINE.search(name) for name in names]
    worth = [name for name, calls in zip(names, calls_itself_one, strict=True) if nothing_found or calls]
    return [Remark("no exercise", file=name) for name in worth]
