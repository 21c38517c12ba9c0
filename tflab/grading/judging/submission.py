"""Grade one submission: its files become notebooks, each chapter's answers run, and a record results.

    Job(learner, files, chapters)  --select, merge_submission, execute, score-->  {"points": 11.5, "chapters": {...}}

Nothing that a submission does ends a job: every fault becomes a line in the record.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from tflab.text import LANGUAGES
from tflab.workbook.diagnosis.failure import Failure

from ..submissions.remarks import Remark
from .cells import VOID
from .draw import asks_of
from .execute import Execution, execute
from .isolated import score_safely, select_safely
from .job import Job, NotRun, RunCells
from .plan import MergedNotebook
from .repeatability import reverse_order
from .select_submission import Candidate
from .task_score import TaskScore

__all__ = ["grade_submission", "merge_records"]

ODD = {  # more than a wrong number
    "raised", "no result", Failure.RAISES, Failure.OTHER_EXCEPTION, Failure.TYPE, Failure.SHAPE, Failure.OPTION,
    Failure.A_FUNCTION, Failure.UNSTEADY,
}  # fmt: skip


@dataclass(frozen=True)
class ChapterResult:
    """The result for one chapter: its part of the record, the tasks to be tried alone, and the time it took."""

    plain: Mapping[str, Any]
    set_aside: Sequence[str] = ()
    seconds: float = 0.0


def grade_submission(job: Job, run_cells: RunCells) -> dict[str, Any]:
    """Return the record of a submission, as JSON has it."""
    counting, on_files = select_safely(job)
    chapters = {
        stem: _grade_chapter(job, stem, counting[stem], run_cells) if stem in counting else _not_handed_in(job, stem)
        for stem in job.chapters
        if stem in counting or counting or not job.only
    }
    plain = {stem: chapter.plain for stem, chapter in chapters.items()}
    return {
        "learner": job.learner,
        "name": job.name,
        "language": job.language,
        "on_roster": job.on_roster,
        "handed_in": bool(counting),
        "chapters": plain,
        "remarks": [remark.plain() for remark in (*job.remarks, *on_files)],
        "seconds": round(sum(chapter.seconds for chapter in chapters.values()), 3),
        "set_aside": {stem: list(chapter.set_aside) for stem, chapter in chapters.items() if chapter.set_aside},
        **_sums(plain),
        **_not_run(plain),
    }


def merge_records(record: dict[str, Any], alone: dict[str, Any]) -> dict[str, Any]:
    """Return a record in which the tasks that were tried alone have their new scores."""
    chapters = {stem: dict(chapter) for stem, chapter in record["chapters"].items()}
    for stem, chapter in alone["chapters"].items():
        if stem in record["set_aside"]:
            chapters[stem] = chapter | {"tasks": chapters[stem]["tasks"] | chapter["tasks"]}
    seconds = round(record["seconds"] + alone["seconds"], 3)
    tried = {stem: list(tasks) for stem, tasks in record["set_aside"].items()}
    kept = {name: held for name, held in record.items() if name != "not_run"}
    kept |= {"chapters": chapters, "seconds": seconds, "set_aside": {}, "tried_alone": tried} | _sums(chapters)
    return kept | ({"not_run": True} if alone.get("not_run") else {})


# -- one chapter ---------------------------------------------------------------------------


def _grade_chapter(job: Job, stem: str, candidate: Candidate, run_cells: RunCells) -> ChapterResult:
    """Return the result of the notebook that counts for a chapter."""
    grader = ChapterGrader(job, job.chapters[stem]["tasks"], candidate.merged, run_cells)
    only = job.only.get(stem, ()) if job.only is not None else None
    wanted = [task for task in grader.answered if only is None or task in only]
    first = grader.execute(wanted, alone=job.only is not None)
    before = grader.scores(first, only if job.only else None)
    again = dict(grader.looked_at_again(before, first))
    scores = [again[score.task].score if score.task in again else score for score in before]
    remarks = [*candidate.remarks, *_about_cells(candidate.merged, scores), *first.remarks]
    remarks += [Remark("apart", task) for task, second in again.items() if second.needed_to_be_apart]
    written_in = candidate.page.notebook.stamp.get("language", "")
    plain = {
        "file": candidate.file,
        "language": written_in if written_in in LANGUAGES else "",
        "tasks": {score.task: score.plain() for score in scores},
        "remarks": [remark.plain() for remark in remarks],
    }
    seconds = first.seconds + sum(second.seconds for second in again.values())
    return ChapterResult(plain, first.set_aside if job.only is None else (), seconds)


@dataclass(frozen=True)
class SecondLook:
    """What a task got after a second run, the time of that, and whether it only works without the other answers."""

    score: TaskScore
    seconds: float
    needed_to_be_apart: bool = False


@dataclass(frozen=True)
class ChapterGrader:
    """Runs a chapter's answers, together or apart, and scores what comes out."""

    job: Job
    tasks: Mapping[str, Any]
    merged: MergedNotebook
    run_cells: RunCells

    @property
    def answered(self) -> list[str]:
        """The tasks that are worth a look."""
        return [task for task in self.merged.answered if task in self.tasks]

    def execute(
        self, wanted: Sequence[str], *, alone: bool = False, leave_out: Sequence[str] = (), again: bool = False
    ) -> Execution:
        """Run what it takes to hear of some tasks; if our own cells do not run, once more."""
        tasks = {name: reverse_order(task) if again else task for name, task in self.tasks.items()}
        for _ in range(2):
            try:
                return execute(
                    self.merged, tasks, self.run_cells, self.job.limits,
                    wanted=wanted, closely=alone, leave_out=leave_out,
                )  # fmt: skip
            except NotRun as error:
                line = Remark("not run", why=error)
        return Execution(trouble={task: [line] for task in wanted}, set_aside=list(wanted), remarks=[line])

    def scores(self, made: Execution, only: Sequence[str] | None = None) -> list[TaskScore]:
        """Return what the tasks got."""
        return [self._score(task_id, made) for task_id in self.tasks if only is None or task_id in only]

    def _score(self, task_id: str, made: Execution) -> TaskScore:
        task = self.tasks[task_id]
        void = [remark for remark in self.merged.remarks if remark.task == task_id and remark.kind in VOID]
        trouble = void or made.trouble.get(task_id, [])
        if task_id not in self.merged.answered and not trouble:
            return score_safely(task_id, task, [_nothing(task)])
        return score_safely(task_id, task, [made.outcomes.get(task_id, {})], trouble)

    def looked_at_again(self, scores: Sequence[TaskScore], first: Execution) -> Iterator[tuple[str, SecondLook]]:
        """Run what is not all right or all wrong once more, and take what both runs say.

        What failed oddly runs without the other answers: one of these may have got in its way (`math = 3`, a patched
        function). What is right in part runs with them, in a fresh kernel. A slow notebook is not run again for each
        of its tasks.
        """
        ended = set(self.merged.answered) - set(first.set_aside)
        left = [score for score in scores if score.task in ended and score.points < score.most]
        odd = [score for score in left if ODD & {remark.kind for remark in score.remarks}]
        partly = [score for score in left if score not in odd and score.points]
        yield from self._in_a_fresh_kernel([score for score in partly if self.tasks[score.task]["is_function"]], first)
        yield from self._apart(odd, first)

    def _in_a_fresh_kernel(self, partly: Sequence[TaskScore], first: Execution) -> Iterator[tuple[str, SecondLook]]:
        second = self.execute([score.task for score in partly], again=True) if partly else Execution()
        for score in partly:
            yield score.task, SecondLook(self._agreed(score, first, second), second.seconds / len(partly))

    def _apart(self, odd: Sequence[TaskScore], first: Execution) -> Iterator[tuple[str, SecondLook]]:
        seconds = 0.0
        for score in odd:
            others = [task for task in self.merged.answered if task != score.task]
            if not others or seconds > self.job.limits.notebook_s:
                continue
            second = self.execute([score.task], leave_out=others, again=True)
            seconds += second.seconds
            agreed = self._agreed(score, first, second)
            yield score.task, SecondLook(agreed, second.seconds, agreed.points > score.points)

    def _agreed(self, score: TaskScore, first: Execution, second: Execution) -> TaskScore:
        """Return what a task gets for what both runs say of it."""
        if score.task in second.set_aside:
            return score
        outcomes = [made.outcomes.get(score.task, {}) for made in (first, second)]
        ran_without = [made.trouble.get(score.task, []) for made in (first, second)]
        return score_safely(score.task, self.tasks[score.task], outcomes, min(ran_without, key=len))


def _about_cells(merged: MergedNotebook, scores: Sequence[TaskScore]) -> list[Remark]:
    """Return the remarks on cells; of a lost cell whose answer was found elsewhere, that it was."""
    found = {score.task for score in scores if score.points}
    return [
        Remark("elsewhere", remark.task, **remark.words)
        if remark.kind == "missing" and remark.task in found
        else remark
        for remark in merged.remarks
    ]


def _not_handed_in(job: Job, stem: str) -> ChapterResult:
    tasks = job.chapters[stem]["tasks"]
    rows = {
        task_id: score_safely(task_id, task, [_nothing(task)]).plain() | {"status": "missing", "remarks": []}
        for task_id, task in tasks.items()
    }
    remarks = [Remark("nothing", chapter=stem).plain()] if job.files else []
    return ChapterResult({"file": "", "tasks": rows, "remarks": remarks})


def _nothing(task: Mapping[str, Any]) -> dict[int, Any]:
    """Return the outcomes of a task that nobody answered."""
    return {place: {"unanswered": True} for place in range(len(asks_of(task)))}


def _sums(chapters: Mapping[str, Any]) -> dict[str, float]:
    rows = [row for chapter in chapters.values() for row in chapter["tasks"].values()]
    return {name: round(sum(row[name] for row in rows), 3) + 0.0 for name in ("points", "most")}


def _not_run(chapters: Mapping[str, Any]) -> dict[str, bool]:
    kinds = {remark["kind"] for chapter in chapters.values() for remark in chapter["remarks"]}
    return {"not_run": True} if "not run" in kinds else {}
