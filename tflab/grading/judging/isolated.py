"""Judge large answers in a subprocess with CPU and memory limits.

    a few numbers, a notebook as people write it     here, in a millisecond
    ninety thousand numbers, a file of 80 MB         server --fork--> child: so many seconds of processor and
                                                     so much memory; what came of it, or OverLimit

Processor time decides, not the clock on the wall, so that a busy machine costs nobody
a point.
"""

from __future__ import annotations

import atexit
import contextlib
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Mapping, Sequence
from dataclasses import replace
from multiprocessing.connection import Connection, Pipe
from typing import Any

from ..submissions.remarks import Remark
from ..submissions.roster import read_stamps
from .draw import asks_of
from .job import HandedIn, Job
from .repeatability import merge_runs
from .select_submission import Candidate, select_counting
from .task_score import TaskScore, members, score_task

__all__ = ["CPU_S", "MEMORY", "WORK", "OverLimit", "run_isolated", "score_safely", "select_safely", "stamps_safely"]

CPU_S, MEMORY = 10, 1 << 30  # of one look; an honest one takes some milliseconds
PATIENCE = 12  # times as long by the clock on the wall
LARGE_ANSWERS = 1_000  # values of a task's outcomes beyond those expected; fewer are judged in a fifth of a second
LARGE_FILES = 1 << 20  # bytes of all files together
IS_POSSIBLE = sys.platform == "linux"  # elsewhere only learners look at their own work
SERVER = f"{__package__}.isolated_server"

Outcomes = Mapping[int, Any]
Chosen = tuple[dict[str, Candidate], tuple[Remark, ...]]


class OverLimit(Exception):
    """The look at something took too long, or too much memory."""


def score_safely(
    task_id: str, task: Mapping[str, Any], runs: Sequence[Outcomes], trouble: Sequence[Remark] = ()
) -> TaskScore:
    """Return the score of a task that was run once, or twice.

    What fails here or has no end costs no other task anything, and says nothing of what is expected.
    """
    try:
        if IS_POSSIBLE and _are_large(task, runs):
            return run_isolated("score", task_id, task, runs, trouble)
        return _score(task_id, task, runs, trouble)
    except OverLimit:
        said = Remark("endless to judge", task_id, seconds=CPU_S, most=MEMORY >> 20)
    except Exception as error:
        said = Remark("failed", task_id, error=type(error).__name__)
    return TaskScore(task_id, "trouble", 0, 0, 0.0, float(task["points"]), remarks=(said,))


def select_safely(job: Job) -> Chosen:
    """Return for each chapter the notebook that counts; a large file whose reading has no end is left out."""
    if not IS_POSSIBLE or sum(len(file.data) for file in job.files) < LARGE_FILES:
        return select_counting(job)
    with contextlib.suppress(OverLimit):
        return run_isolated("select", job)
    return select_counting(replace(job, files=tuple(_readable(job, file) for file in job.files)))


def _readable(job: Job, file: HandedIn) -> HandedIn:
    """Return a file; in its place, if its reading has no end, the reason."""
    if len(file.data) * len(job.files) < LARGE_FILES:
        return file
    try:
        run_isolated("select", replace(job, files=(file,)))
    except OverLimit:
        return HandedIn(file.name, fault=Remark("endless to read", seconds=CPU_S, most=MEMORY >> 20))
    return file


def stamps_safely(files: Sequence[bytes]) -> list[dict[str, str]]:
    """Return the stamps in notebooks whose owner nothing else says; none if reading them has no end."""
    if not IS_POSSIBLE or sum(map(len, files)) < LARGE_FILES:
        return read_stamps(files)
    with contextlib.suppress(OverLimit):
        return run_isolated("stamps", files)
    return []


def _score(task_id: str, task: Mapping[str, Any], runs: Sequence[Outcomes], trouble: Sequence[Remark]) -> TaskScore:
    if len(runs) == 1:
        return score_task(task_id, task, runs[0], trouble)
    asked, outcomes = merge_runs(task, *runs)
    return score_task(task_id, asked, outcomes, trouble)


def _select(job: Job) -> Chosen:
    """Choose, and do not hand back what was read: that can be many megabytes."""
    found, remarks = select_counting(job)
    return {stem: candidate.without_data() for stem, candidate in found.items()}, remarks


WORK = {"score": _score, "select": _select, "stamps": read_stamps}


def _are_large(task: Mapping[str, Any], runs: Sequence[Outcomes]) -> bool:
    """Return whether the outcomes are more than anybody is asked for."""
    expected = sum(members(task["cases"][case]["expected"], LARGE_ANSWERS) for case in asks_of(task))
    room = LARGE_ANSWERS + expected * len(runs)
    for outcome in (outcome for outcomes in runs for outcome in outcomes.values()):
        room -= members(outcome, room)
        if room <= 0:
            return True
    return False


# -- a server for this process -------------------------------------------------------------

_lock = threading.Lock()
_servers: dict[int, tuple[subprocess.Popen[bytes], Connection]] = {}  # by the process that has started it


def run_isolated(work: str, *arguments: Any) -> Any:
    """Return what one of WORK gives, in a process of its own.

    Raises:
        OverLimit: it took too long, or too much memory.
    """
    with _lock:
        for _ in range(2):  # the server may have been killed meanwhile
            try:
                _, line = _servers.get(os.getpid()) or _started()
                line.send((CPU_S, MEMORY))
                line.send((work, arguments))
                if not line.poll(PATIENCE * CPU_S):
                    break
                is_done, result = line.recv()
            except (OSError, EOFError):
                _stop()
                continue
            if is_done:
                return result
            raise result
        _stop()
    raise OverLimit


def _started() -> tuple[subprocess.Popen[bytes], Connection]:
    """Start the server of this process."""
    ours, its = Pipe()
    one_thread = dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"), "1")  # before a fork
    null = subprocess.DEVNULL
    with its:
        process = subprocess.Popen(
            [sys.executable, "-m", SERVER, str(its.fileno())],
            pass_fds=[its.fileno()],
            start_new_session=True,  # Ctrl-C is for the grader
            stdin=null, stdout=null, stderr=null,
            cwd="/",
            env=os.environ | one_thread | {"PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
        )  # fmt: skip
    _servers[os.getpid()] = process, ours
    return _servers[os.getpid()]


@atexit.register
def _stop() -> None:
    """End the server of this process, and what it looks at, if there is one."""
    process, line = _servers.pop(os.getpid(), (None, None))
    if process is not None and line is not None:
        line.close()
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
