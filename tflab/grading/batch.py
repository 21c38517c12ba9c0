"""Grade many submissions on one or more processes, and keep each record on disk at once.

    collection --jobs, made one by one-->  threads or processes
                                             |
    results/submissions/s101-7f3a....json  <-+   a record for each, under a name that its content determines
                                             |
    what hit a deadline  <-------------------+   once more at the end, alone, with three times the time

A second run takes the records that are there and grades only what changed, in the
submission, the pack or tflab.  Ctrl-C loses nothing that was done.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from tqdm import tqdm

from tflab import __version__
from tflab.workbook.atomic_files import write_whole

from .judging.job import SEVERAL, HandedIn, Job
from .judging.nbval_run import run_cells
from .judging.pack import Pack
from .judging.submission import grade_submission, merge_records
from .kernels.limits import Limits
from .kernels.sandbox import Sandbox
from .reports.gradebook import file_name
from .submissions.collect import Collection, Submission
from .submissions.reader import Unreadable
from .submissions.remarks import Remark, printable
from .submissions.roster import MOST_BYTES

__all__ = ["RECORDS", "GradingOptions", "grade_batch", "grade_job", "job_of"]

RECORDS = "submissions"
RECORD_FORMAT = 3
MOST_THREADS = 8


@dataclass(frozen=True)
class GradingOptions:
    """Within which limits, behind which wall, by how many, and where."""

    limits: Limits
    sandbox: Sandbox
    jobs: int = 1
    quiet: bool = True
    several: str = SEVERAL[0]


def grade_batch(collection: Collection, pack: Pack, out: Path, how: GradingOptions) -> list[dict[str, Any]]:
    """Return a record for each submission, in their order; each is also in `out`."""
    ledger = Ledger(collection, pack, out / RECORDS, how)
    do = partial(grade_job, sandbox=how.sandbox)
    with tqdm(desc="graded", total=len(collection.submissions), leave=False, disable=how.quiet or None) as bar:
        for record in _done(ledger, do, how):
            ledger.take(record)
            bar.update(len(ledger.records) - bar.n)  # some were on the disk already
    with tqdm(desc="graded again", total=len(ledger.set_aside), leave=False, disable=how.quiet or None) as bar:
        for submission in sorted(ledger.set_aside, key=lambda submission: submission.learner):
            record = ledger.records[submission.learner]
            job = replace(job_of(submission, pack, how.limits, how.several), only=record["set_aside"])
            ledger.keep(merge_records(record, do(job)))
            bar.update()
    ledger.remove_old()
    return [ledger.records[submission.learner] for submission in collection.submissions]


def _done(ledger: Ledger, do: Callable[[Job], dict[str, Any]], how: GradingOptions) -> Iterator[dict[str, Any]]:
    """Yield the record of each job as it is done."""
    jobs = ledger.jobs()
    try:
        yield from _on_processes(jobs, do, how)
    except BrokenExecutor:  # a process was killed, for want of memory perhaps: here, one by one
        yield from map(do, ledger.jobs_waiting())
        yield from map(do, jobs)


class Ledger:
    """The records of a run: those that are on the disk already, those that come in, those to be tried once more."""

    def __init__(self, collection: Collection, pack: Pack, folder: Path, how: GradingOptions) -> None:
        self.records: dict[str, dict[str, Any]] = {}
        self.set_aside: list[Submission] = []
        self._collection, self._pack, self._folder, self._how = collection, pack, folder, how
        self._waiting: dict[str, Submission] = {}
        self._paths: dict[str, Path] = {}

    def jobs(self) -> Iterator[Job]:
        """Yield a job for each submission of which there is no record yet, made when its turn comes."""
        for submission in self._collection.submissions:
            job = job_of(submission, self._pack, self._how.limits, self._how.several)
            path = self._folder / f"{file_name(job.learner)}-{_key(job, self._pack, self._how)[:16]}.json"
            self._paths[job.learner] = path
            there = _record_at(path, job.learner)
            if there is not None:
                self.records[job.learner] = there
            else:
                self._waiting[job.learner] = submission
                yield job

    def jobs_waiting(self) -> list[Job]:
        """Return the jobs that were given out and of which no record came."""
        return [
            job_of(submission, self._pack, self._how.limits, self._how.several) for submission in self._waiting.values()
        ]

    def take(self, record: dict[str, Any]) -> None:
        """Take in a record; what hit a deadline waits for its second chance."""
        submission = self._waiting.pop(record["learner"])
        if record["set_aside"]:
            self.records[submission.learner] = record
            self.set_aside.append(submission)
        else:
            self.keep(record)

    def keep(self, record: dict[str, Any]) -> None:
        """Keep a record, on the disk too; what could not be run is tried again the next time."""
        self.records[record["learner"]] = record
        if not record.get("not_run"):
            path = self._paths[record["learner"]]
            write_whole(path, json.dumps(record, ensure_ascii=False, sort_keys=True, indent=1) + "\n")

    def remove_old(self) -> None:
        """Remove the records of what these learners handed in before; those of others stay."""
        names = {file_name(learner) for learner in self.records}
        for path in self._folder.glob("*.json"):
            if path not in self._paths.values() and path.name.rpartition("-")[0] in names:
                path.unlink(missing_ok=True)


def job_of(submission: Submission, pack: Pack, limits: Limits, several: str = SEVERAL[0]) -> Job:
    """Return the job for a submission; its files are read now, within the reader's limits."""
    files, room = [], MOST_BYTES
    for member in submission.notebooks:
        name = printable("/".join(member.parts))[-200:]
        try:
            data = member.read() if room > 0 else b""
            files.append(
                HandedIn(name, data) if room > 0 else HandedIn(name, fault=Remark("too much", most=MOST_BYTES >> 20))
            )
            room -= len(data)
        except Unreadable as error:
            files.append(HandedIn(name, fault=error.remark))
    known = (pack.roster or {}).get(submission.learner)
    return Job(
        learner=submission.learner,
        name=known.name if known else "",
        language=known.language if known else pack.language,
        release=pack.release,
        version=pack.version,
        files=tuple(files),
        chapters=pack.for_learner(submission.learner),
        limits=limits,
        remarks=submission.remarks,
        on_roster=submission.known,
        has_roster=pack.roster is not None,
        several=several,
    )


def grade_job(job: Job, *, sandbox: Sandbox) -> dict[str, Any]:
    """Do one job, in whichever process this is; whatever happens, there is a record of it."""
    run = partial(run_cells, sandbox=sandbox)
    try:
        return grade_submission(job, run) | {"sandbox": sandbox.level}
    except Exception as error:  # a fault of ours; it must not cost the others
        said = Remark("failed", error=f"{type(error).__name__}: {str(error)[:200]}")
        record = grade_submission(replace(job, files=(), remarks=(*job.remarks, said)), run)
        return record | {"sandbox": sandbox.level, "not_run": True}


def _on_processes(
    jobs: Iterator[Job], do: Callable[[Job], dict[str, Any]], how: GradingOptions
) -> Iterator[dict[str, Any]]:
    """Do jobs as they come, and yield records as they are done; only as many jobs wait as there are processes."""
    from joblib import Parallel, delayed

    if how.jobs == 1:
        yield from map(do, jobs)
        return
    # The kernels are processes anyway: a few threads keep them busy, and have nothing to import.
    kind = "threads" if how.jobs <= MOST_THREADS else "processes"
    work = Parallel(
        n_jobs=how.jobs, prefer=kind, return_as="generator_unordered", pre_dispatch="2*n_jobs", batch_size=1
    )
    try:
        yield from work(delayed(do)(job) for job in jobs)
    except BaseException:
        if kind == "processes":
            from joblib.externals.loky import get_reusable_executor

            get_reusable_executor().shutdown(wait=True, kill_workers=True)
        raise


def _key(job: Job, pack: Pack, how: GradingOptions) -> str:
    """Return a name for all that decides a record: the files, the pack, the limits, the wall, and tflab itself."""
    content = hashlib.sha256()
    rest = [RECORD_FORMAT, __version__, pack.digest, repr(how.limits), how.sandbox.level]
    rest += [
        job.learner,
        job.name,
        job.language,
        [remark.plain() for remark in job.remarks],
        job.on_roster,
        job.several,
    ]
    content.update(json.dumps(rest, ensure_ascii=False).encode("utf-8", "replace"))
    for file in job.files:
        fault = file.fault.plain() if file.fault else None
        content.update(repr((file.name, fault, hashlib.sha256(file.data).hexdigest())).encode())
    return content.hexdigest()


def _record_at(path: Path, learner: str) -> dict[str, Any] | None:
    try:
        record = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    is_ours = isinstance(record, dict) and record.get("learner") == learner and "chapters" in record
    return record if is_ours else None
