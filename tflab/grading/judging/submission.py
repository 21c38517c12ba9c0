"""How is one submission graded?  Its files become notebooks, each chapter's answers run, and a record comes out.

    Job(learner, files, chapters)  --read, transplant, attempt, judge-->  {"points": 11.5, "chapters": {...}}

A job is plain data and holds all that is needed, so it can be done in any process,
here or elsewhere.  Nothing that a submission does ends a job: every fault becomes a
line in the record.  Read `plain_kernel.py` next.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from ..submissions.reader import SubmittedNotebook, Unreadable, read_notebook
from ..submissions.remarks import Remark
from .attempt import Attempt, NotRun, Ran, attempt
from .marks import TaskMark, judged
from .plan import PlannedCell
from .transplant import Master, MasterCell, Transplant, answers_most, transplant

__all__ = ["File", "Job", "RunCells", "graded", "graded_twice", "record_with"]

if TYPE_CHECKING:
    from ..kernels.limits import Limits  # which needs Linux

RunCells = Callable[[Sequence[PlannedCell], "Limits"], Ran]
ODD = {"raised", "raises", "unfit", "no result", "unstable"}  # more than a wrong number
ANSWER = re.compile(r"(e\d{1,3}-\d{1,3})-answer")
COPY = re.compile(r"-Copy\d+$|^Copy of |/Copy of |checkpoint$")
WORTH_A_LINE = re.compile(r"(^|/)(notebooks|solutions)/")


@dataclass(frozen=True)
class File:
    """A notebook as it was handed in: its bytes, or why there are none."""

    name: str
    data: bytes = b""
    fault: Remark | None = None


@dataclass(frozen=True)
class Job:
    """All that is needed to grade one submission.

    Attributes:
        chapters: by stem: "master" (name, source, task, role of each code cell) and "tasks" (as in the cases, with
            this learner's "given" and hidden "cases").
        only: by stem, the tasks to look at closely, alone; None for a first look at everything.
    """

    learner: str
    name: str
    language: str
    release: str
    version: str
    files: tuple[File, ...]
    chapters: Mapping[str, Mapping[str, Any]]
    limits: Limits
    remarks: tuple[Remark, ...] = ()
    on_roster: bool = True
    has_roster: bool = False
    only: Mapping[str, Sequence[str]] | None = None


@dataclass
class _Chapter:
    """The notebook that is graded for a chapter, and its transplant."""

    file: File
    notebook: SubmittedNotebook
    transplanted: Transplant
    remarks: list[Remark] = field(default_factory=list)


def graded(job: Job, run_cells: RunCells) -> dict[str, Any]:
    """Return the record of a submission, as JSON has it."""
    remarks = list(job.remarks)
    masters = {stem: _master(stem, chapter["master"]) for stem, chapter in job.chapters.items()}
    found = _by_chapter(job, masters, remarks)
    chapters: dict[str, Any] = {}
    set_aside: dict[str, list[str]] = {}
    seconds = 0.0
    for stem, held in job.chapters.items():
        if stem not in found:
            if found or not job.only:
                chapters[stem] = _not_handed_in(stem, held["tasks"], any_file=bool(job.files))
            continue
        one = found[stem]
        wanted = [task for task in one.transplanted.answered if task in held["tasks"]]
        if job.only is not None:
            wanted = [task for task in wanted if task in job.only.get(stem, ())]
        made = _attempted(one.transplanted, held["tasks"], wanted, job, run_cells)
        verdicts = _verdicts(one.transplanted, held["tasks"], made, job.only.get(stem, ()) if job.only else None)
        apart = _apart(one.transplanted, held["tasks"], verdicts, made, job, run_cells)
        seconds += made.seconds
        lines = [*one.remarks, *_about_cells(one.transplanted, verdicts), *made.remarks, *apart]
        chapters[stem] = {
            "file": one.file.name,
            "tasks": {verdict.task: verdict.plain() for verdict in verdicts},
            "remarks": [remark.plain() for remark in lines],
        }
        if made.set_aside and job.only is None:
            set_aside[stem] = made.set_aside
    record = {
        "learner": job.learner,
        "name": job.name,
        "language": job.language,
        "on_roster": job.on_roster,
        "handed_in": bool(found),
        "chapters": chapters,
        "remarks": [remark.plain() for remark in remarks],
        "seconds": round(seconds, 3),
        "set_aside": set_aside,
    }
    not_run = any(remark["kind"] == "not run" for chapter in chapters.values() for remark in chapter["remarks"])
    return record | _sums(chapters) | ({"not_run": True} if not_run else {})


def graded_twice(job: Job, grade: Callable[[Job], dict[str, Any]]) -> dict[str, Any]:
    """Return a job's record by `grade`; what does not end has its second chance, alone, right behind the first."""
    record = grade(job)
    if not record["set_aside"]:
        return record
    return record_with(record, grade(replace(job, only=record["set_aside"])))


def record_with(record: dict[str, Any], alone: dict[str, Any]) -> dict[str, Any]:
    """Return a record in which the tasks that were tried alone have their new verdicts."""
    chapters = {stem: dict(chapter) for stem, chapter in record["chapters"].items()}
    for stem, chapter in alone["chapters"].items():
        if stem in record["set_aside"]:
            chapters[stem] = chapter | {"tasks": chapters[stem]["tasks"] | chapter["tasks"]}
    seconds = round(record["seconds"] + alone["seconds"], 3)
    tried = {stem: list(tasks) for stem, tasks in record["set_aside"].items()}
    kept = {name: held for name, held in record.items() if name != "not_run"}
    kept |= {"chapters": chapters, "seconds": seconds, "set_aside": {}, "tried_alone": tried} | _sums(chapters)
    return kept | ({"not_run": True} if alone.get("not_run") else {})


def _master(stem: str, cells: Iterable[Sequence[str]]) -> Master:
    return Master(stem, tuple(MasterCell(*cell) for cell in cells))


def _by_chapter(job: Job, masters: Mapping[str, Master], remarks: list[Remark]) -> dict[str, _Chapter]:
    """Return for each chapter the notebook that counts, with what is to be said of the others."""
    candidates: dict[str, list[_Chapter]] = {}
    strangers = []

    def add(stem: str, file: File, notebook: SubmittedNotebook) -> None:
        lines = [Remark("file", file=file.name, why=why) for why in notebook.remarks]
        lines += _stamp_remarks(job, file.name, notebook)
        transplanted = transplant(masters[stem], notebook)
        candidates.setdefault(stem, []).append(_Chapter(file, notebook, transplanted, lines))

    for file in job.files:
        if file.fault is not None:
            remarks.append(Remark("unreadable", file=file.name, why=file.fault))
            continue
        try:
            notebook = read_notebook(file.data)
        except Unreadable as error:
            remarks.append(Remark("unreadable", file=file.name, why=error.remark))
            continue
        stem = _chapter_of(notebook, masters)
        if stem is None:
            strangers.append((file, notebook))
        else:
            add(stem, file, notebook)
    for file, notebook in strangers:  # all in one cell of their own, perhaps
        stem = notebook.stamp.get("chapter")
        if stem in masters and stem not in candidates and answers_most(masters[stem], notebook):
            add(stem, file, notebook)
    taken = {one.file.name for several in candidates.values() for one in several}
    for name in [file.name for file, _ in strangers if file.name not in taken]:
        if not candidates or (any(stem in name for stem in masters) and not WORTH_A_LINE.search(name)):
            remarks.append(Remark("no exercise", file=name))
    chosen = {}
    for stem, several in candidates.items():
        best = max(several, key=lambda one: (len(one.transplanted.answered), _age(one.file.name)))
        others = [one for one in several if one is not best and one.transplanted.answered]
        if any(_texts(one) != _texts(best) for one in others):
            best.remarks.append(Remark("several", chapter=stem, file=best.file.name))
        chosen[stem] = best
    known = {cell.name for master in masters.values() for cell in master.cells}
    for stem, one in chosen.items():
        claims = {claim for cell in one.notebook.cells for claim in cell.claims[:1]} - known
        tasks = sorted(match[1] for match in map(ANSWER.fullmatch, claims) if match)
        chosen[stem].remarks.extend(
            Remark("unknown task", file=one.file.name, stamp=task.upper().replace("-", ".")) for task in tasks[:5]
        )
    return chosen


def _age(name: str) -> tuple[bool, list[tuple[int, str]]]:
    """Return what sorts a later attempt behind an earlier one, by its name; an editor's copies come first."""
    stem = name.rpartition(".")[0]
    runs = re.findall(r"\d+|\D+", stem)
    return not COPY.search(stem), [(int(run[:18]), "") if run.isdecimal() else (-1, run) for run in runs]


def _texts(one: _Chapter) -> list[tuple[str, str]]:
    return [(piece.name, piece.source) for piece in one.transplanted.pieces]


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


def _stamp_remarks(job: Job, name: str, notebook: SubmittedNotebook) -> list[Remark]:
    stamp, lines = notebook.stamp, []
    if stamp.get("release") and stamp["release"] != job.release:
        lines.append(Remark("other release", file=name, stamp=stamp["release"][:16], ours=job.release))
    elif stamp.get("version") and stamp["version"] != job.version:
        lines.append(Remark("other version", file=name, stamp=stamp["version"][:16], ours=job.version))
    if job.has_roster and stamp.get("learner") and stamp["learner"] != job.learner:
        lines.append(Remark("other learner", file=name, stamp=stamp["learner"][:64], ours=job.learner))
    return lines


def _attempted(
    transplanted: Transplant,
    tasks: Mapping[str, Any],
    wanted: Sequence[str],
    job: Job,
    run_cells: RunCells,
    leave_out: Sequence[str] = (),
) -> Attempt:
    alone = job.only is not None and not leave_out
    patient = job.limits.times(3)

    def run(cells: Sequence[PlannedCell], patiently: bool) -> Ran:
        return run_cells(cells, patient if patiently else job.limits)

    for last_time in (False, True):
        try:
            return attempt(
                transplanted, tasks, run, wanted=wanted, cell_s=job.limits.cell_s,
                notebook_s=(patient if alone else job.limits).notebook_s, closely=alone, leave_out=leave_out,
            )  # fmt: skip
        except NotRun as error:
            if last_time:
                line = Remark("not run", why=error)
                return Attempt(trouble={task: [line] for task in wanted}, set_aside=list(wanted), remarks=[line])
    raise AssertionError("unreachable")


def _about_cells(transplanted: Transplant, verdicts: Sequence[TaskMark]) -> list[Remark]:
    """Return the remarks on cells; of a lost cell whose answer was found elsewhere, that it was."""
    found = {verdict.task for verdict in verdicts if verdict.points}
    return [
        Remark("elsewhere", remark.task, **remark.words)
        if remark.kind == "missing" and remark.task in found
        else remark
        for remark in transplanted.remarks
    ]


def _apart(
    transplanted: Transplant,
    tasks: Mapping[str, Any],
    verdicts: list[TaskMark],
    made: Attempt,
    job: Job,
    run_cells: RunCells,
) -> list[Remark]:
    """Run what failed oddly once more, without the other answers: one of them may have got in its way.

    An answer that took another name's place (`math = 3`, a patched function) spoils what follows; what is better
    counts, and is put into `verdicts`.
    """
    remarks = []
    enough = made.seconds + job.limits.notebook_s  # a slow notebook is not run again for each of its tasks
    for number, verdict in enumerate(verdicts):
        if made.seconds > enough:
            break
        others = [task for task in transplanted.answered if task != verdict.task]
        odd = verdict.points < verdict.most and ODD & {remark.kind for remark in verdict.remarks}
        if not odd or not others or verdict.task not in transplanted.answered or verdict.task in made.set_aside:
            continue
        alone = _attempted(transplanted, tasks, [verdict.task], job, run_cells, leave_out=others)
        made.seconds += alone.seconds
        better = _verdicts(transplanted, tasks, alone, [verdict.task])[0]
        if better.points > verdict.points and not alone.set_aside:
            verdicts[number] = better
            remarks.append(Remark("apart", verdict.task))
    return remarks


def _verdicts(
    transplanted: Transplant, tasks: Mapping[str, Any], made: Attempt, only: Sequence[str] | None
) -> list[TaskMark]:
    verdicts = []
    for task_id, task in tasks.items():
        if only is not None and task_id not in only:
            continue
        trouble = [
            remark for remark in transplanted.remarks if remark.task == task_id and remark.kind in ("twice", "no code")
        ]
        trouble = trouble or made.trouble.get(task_id, [])
        if task_id not in transplanted.answered and not trouble:
            outcomes: Mapping[int, Any] = {number: {"unanswered": True} for number in range(len(task["cases"]))}
        else:
            outcomes = made.outcomes.get(task_id, {})
        verdicts.append(judged(task_id, task, outcomes, trouble))
    return verdicts


def _not_handed_in(stem: str, tasks: Mapping[str, Any], any_file: bool) -> dict[str, Any]:
    rows = {}
    for task_id, task in tasks.items():
        nothing = {number: {"unanswered": True} for number in range(len(task["cases"]))}
        rows[task_id] = judged(task_id, task, nothing).plain() | {"status": "missing", "remarks": []}
    remarks = [Remark("nothing", chapter=stem).plain()] if any_file else []
    return {"file": "", "tasks": rows, "remarks": remarks}


def _sums(chapters: Mapping[str, Any]) -> dict[str, float]:
    rows = [row for chapter in chapters.values() for row in chapter["tasks"].values()]
    return {name: round(sum(row[name] for row in rows), 3) + 0.0 for name in ("points", "most")}
