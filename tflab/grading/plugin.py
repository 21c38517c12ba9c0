"""Show tasks as test items of pytest, and let `pytest --nbval` fail where an answer is wrong.

    pytest --tflab-grade DIR/instructor NOTEBOOK ...
        s101_03_target_and_source.ipynb::E3.1 PASSED
        s101_03_target_and_source.ipynb::E3.2 FAILED     E3.2: 2 of 4 points. ...

    pytest --nbval exercises/en/E03_target_and_source.ipynb
        E03_target_and_source.ipynb::Cell 9 FAILED       E3.2 ✗ 0/4: You ...

pytest finds this module by its entry point.  Without these options it does nothing.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest

__all__ = ["TaskItem", "TasksFile"]

PASSED = re.compile(r"E\d+\.\d+ ✓")  # how a reply of `check` begins
PACK: pytest.StashKey[Any] = pytest.StashKey()


def pytest_addoption(parser: pytest.Parser) -> None:
    """Offer --tflab-grade."""
    group = parser.getgroup("tflab", "tflab: graded notebooks")
    group.addoption("--tflab-grade", metavar="PACK", help="grade notebooks with the pack in this folder")


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """Take notebooks, if asked to."""
    if file_path.suffix == ".ipynb" and parent.config.getoption("--tflab-grade"):
        return TasksFile.from_parent(parent, path=file_path)
    return None


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Iterator[None]:
    """Fail a check cell that nbval has run, unless `check` says that the answer is right."""
    yield
    cell = getattr(item, "cell", None)  # an IPyNbCell
    if cell is None or "check" not in cell.metadata.get("tags", ()):
        return
    replies = [out.get("text") or out.get("data", {}).get("text/plain", "") for out in item.test_outputs]
    if not any(map(PASSED.match, replies)):
        pytest.fail("\n".join(replies).strip() or "check printed no reply", pytrace=False)


class TasksFile(pytest.File):
    """A notebook that was handed in; it is graded once, when its first task is asked for."""

    _record: dict[str, Any] | None = None

    def collect(self) -> Iterator[TaskItem]:
        """Yield the tasks of the chapter that the notebook is of, or of every one if it does not tell."""
        for stem in self._chapters():
            for task_id in self.read_pack().questions[stem]:
                yield TaskItem.from_parent(self, name=task_id, chapter=stem)

    def _chapters(self) -> list[str]:
        """Return the chapter that the file's name tells, or all chapters."""
        chapters = self.read_pack().chapters
        return [stem for stem in chapters if stem in self.path.name] or chapters

    def read_pack(self) -> Any:
        """Return the pack, read once for each run of pytest."""
        from .judging.pack import PackError, read_pack

        if PACK not in self.config.stash:
            folder = Path(self.config.getoption("--tflab-grade"))
            try:
                self.config.stash[PACK] = read_pack(folder)
            except PackError as error:
                raise pytest.UsageError(f"--tflab-grade {folder}: {error}") from None
        return self.config.stash[PACK]

    def record(self) -> dict[str, Any]:
        """Return the record of grading it."""
        if self._record is None:
            from tflab.workbook.tasks.task import TaskError

            from .batch import grade_job, job_of
            from .judging.isolated import stamps
            from .judging.pack import PackError
            from .judging.submission import grade_with_retry
            from .kernels.kernel_pool import choose_sandbox
            from .kernels.limits import Limits
            from .submissions.collect import collect

            pack = self.read_pack()
            found = collect(
                self.path, pack.roster, pack.chapters, is_genuine=pack.sealed_this, stamps_in=stamps
            ).submissions
            submission = next(submission for submission in found if submission.notebooks)
            hide = (str(Path(self.config.getoption("--tflab-grade")).resolve()),)
            try:
                job = job_of(submission, pack, Limits())
            except (PackError, TaskError) as error:
                pytest.fail(f"--tflab-grade: {error}", pytrace=False)
            self._record = grade_with_retry(job, partial(grade_job, sandbox=choose_sandbox(hide)))
        return self._record


class TaskItem(pytest.Item):
    """A task: passed if all of it is right."""

    def __init__(self, *, chapter: str, **of_pytest: Any) -> None:
        super().__init__(**of_pytest)
        self.chapter = chapter

    def runtest(self) -> None:
        from tflab.workbook.phrases import points

        from .submissions.remarks import Remark

        record = self.parent.record()
        row = record["chapters"][self.chapter]["tasks"][self.name]
        self.user_properties += [(name, row[name]) for name in ("points", "most", "status")]
        if row["status"] != "right":
            remarks = row["remarks"] or (record["remarks"] if row["status"] == "missing" else [])
            said = [Remark.from_plain(remark).say("en") for remark in remarks]
            mistake = [f"As the mistake {name!r} would have it." for name in row["mistakes"]]
            worth = f"{self.name}: {points(row['points'])} of {points(row['most'])} points, {row['status']}."
            pytest.fail(" ".join([worth, *mistake, *said]), pytrace=False)

    def reportinfo(self) -> tuple[Path, int, str]:
        return self.path, 0, self.name
