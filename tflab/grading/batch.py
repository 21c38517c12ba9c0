"""Grade many submissions, several at a time, and keep each record on disk at once.

    collection --jobs, made one by one-->  threads, each with kernels of its own
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
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from joblib import Parallel, delayed
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
    submissions = collection.submissions
    ledger = Ledger(pack, out / RECORDS, how)
    do = partial(grade_job, sandbox=how.sandbox)
    # The kernels are processes: threads keep them busy, and only as many jobs wait as there are threads.
    work = Parallel(how.jobs, prefer="threads", return_as="generator_unordered", pre_dispatch="2*n_jobs", batch_size=1)
    with tqdm(desc="graded", total=len(submissions), leave=False, disable=how.quiet or None) as bar:
        for record in work(delayed(do)(job) for job in ledger.jobs(submissions)):
            ledger.keep(record)
            bar.update(len(ledger.records) - bar.n)  # some were on the disk already
    again = [submission for submission in submissions if ledger.records[submission.learner]["set_aside"]]
    for submission in tqdm(again, desc="graded again", leave=False, disable=how.quiet or None):
        record = ledger.records[submission.learner]
        ledger.keep(merge_records(record, do(replace(job_of(submission, pack, how), only=record["set_aside"]))))
    ledger.remove_old()
    return [ledger.records[submission.learner] for submission in submissions]


class Ledger:
    """The records of a run: those that are on the disk already, and those that come in."""

    def __init__(self, pack: Pack, folder: Path, how: GradingOptions) -> None:
        self.records: dict[str, dict[str, Any]] = {}
        self._pack, self._folder, self._how = pack, folder, how
        self._paths: dict[str, Path] = {}

    def jobs(self, submissions: Iterable[Submission]) -> Iterator[Job]:
        """Yield a job for each submission of which there is no record yet, made when its turn comes."""
        for submission in submissions:
            job = job_of(submission, self._pack, self._how)
            path = self._folder / f"{file_name(job.learner)}-{_key(job, self._pack, self._how)[:16]}.json"
            self._paths[job.learner] = path
            there = _record_at(path, job.learner)
            if there is not None:
                self.records[job.learner] = there
            else:
                yield job

    def keep(self, record: dict[str, Any]) -> None:
        """Keep a record, on the disk too, unless it is not final: a deadline was hit, or it could not be run."""
        self.records[record["learner"]] = record
        if not record["set_aside"] and not record.get("not_run"):
            path = self._paths[record["learner"]]
            write_whole(path, json.dumps(record, ensure_ascii=False, sort_keys=True, indent=1) + "\n")

    def remove_old(self) -> None:
        """Remove the records of what these learners handed in before; those of others stay."""
        names = {file_name(learner) for learner in self.records}
        for path in self._folder.glob("*.json"):
            if path not in self._paths.values() and path.name.rpartition("-")[0] in names:
                path.unlink(missing_ok=True)


def job_of(submission: Submission, pack: Pack, how: GradingOptions) -> Job:
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
        limits=how.limits,
        remarks=submission.remarks,
        on_roster=submission.known,
        has_roster=pack.roster is not None,
        several=how.several,
    )


def grade_job(job: Job, *, sandbox: Sandbox) -> dict[str, Any]:
    """Do one job; whatever happens, there is a record of it."""
    run = partial(run_cells, sandbox=sandbox)
    try:
        return grade_submission(job, run) | {"sandbox": sandbox.level}
    except Exception as error:  # a fault of ours; it must not cost the others
        said = Remark("failed", error=f"{type(error).__name__}: {str(error)[:200]}")
        record = grade_submission(replace(job, files=(), remarks=(*job.remarks, said)), run)
        return record | {"sandbox": sandbox.level, "not_run": True}


def _key(job: Job, pack: Pack, how: GradingOptions) -> str:
    """Return a name for all that decides a record: the files, the pack, the limits, the wall, and tflab itself."""
    content = hashlib.sha256()
    rest = [RECORD_FORMAT, __version__, pack.digest, repr(how.limits), how.sandbox.level, job.learner, job.name]
    rest += [job.language, [remark.plain() for remark in job.remarks], job.on_roster, job.several]
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
