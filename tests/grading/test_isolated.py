"""Judging ends, whatever was answered or handed in, and costs that part alone."""

from __future__ import annotations

import json
import os
import signal
from collections.abc import Iterator
from typing import Any

import pytest

from tflab.grading.judging import isolated
from tflab.grading.judging.draw import asks_of
from tflab.grading.judging.job import HandedIn, Job
from tflab.grading.judging.pack import read_pack
from tflab.grading.judging.task_score import members, score_task
from tflab.grading.kernels.limits import Limits

from . import tiny


@pytest.fixture(scope="module")
def task(course: tiny.Course) -> dict[str, Any]:
    return read_pack(course.pack).for_learner("s102")[tiny.STEM]["tasks"]["E3.2"]


def outcomes(task: dict[str, Any], one: Any = None) -> dict[int, Any]:
    """Return the same outcome for whatever is asked; the right ones if there is none."""
    return {place: one or task["cases"][case]["expected"] for place, case in enumerate(asks_of(task))}


@pytest.fixture(autouse=True)
def its_own_server() -> Iterator[None]:
    isolated._stop()  # that of a test of another module
    yield
    isolated._stop()


def hog(count: int) -> bytes:
    """Return a notebook whose cells take the parser long, all of them under one name."""
    named = {"cell_type": "code", "metadata": {"name": "e3-2-answer"}, "outputs": [], "execution_count": None}
    cells = [named | {"id": f"n{n}", "source": "a=b;" * 4900 + f"\n# {n}"} for n in range(count)]
    return json.dumps({"cells": cells, "nbformat": 4, "nbformat_minor": 5, "metadata": {}}).encode()


def job(course: tiny.Course, *files: HandedIn) -> Job:
    pack = read_pack(course.pack)
    return Job("s102", "", "en", pack.release, pack.version, files, pack.for_learner("s102"), Limits())


def test_as_much_as_is_asked_for_is_judged_here_however_much_that_is(task: dict[str, Any]) -> None:
    assert isolated.score_safely("E3.2", task, [outcomes(task)]).points == 4
    many = [0.0] * (isolated.LARGE_ANSWERS // 3)
    asking = task | {"cases": [case | {"expected": many} for case in task["cases"]]}
    isolated.score_safely("E3.2", asking, [outcomes(asking)] * 2)
    assert isolated._servers == {}
    sizes = ((1.0, 1), ([1.0, 2.0], 5), ({"dict": {"a": [1.0]}}, 7), ("x" * 250, 3))  # values, hundreds of letters
    assert [members(plain, 1_000) for plain, _ in sizes] == [size for _, size in sizes]


def test_what_is_large_is_judged_apart_and_its_mark_is_the_same(task: dict[str, Any]) -> None:
    large = outcomes(task, [0.0] * 1_900)
    mark = isolated.score_safely("E3.2", task, [large])
    assert len(isolated._servers) == 1
    assert mark == score_task("E3.2", task, large)
    assert mark.status == "wrong"


def test_two_runs_are_large_together(task: dict[str, Any]) -> None:
    third = outcomes(task, [0.0] * (isolated.LARGE_ANSWERS // (3 * len(asks_of(task)))))
    for runs, servers in ((1, 0), (2, 1)):
        isolated.score_safely("E3.2", task, [third] * runs)
        assert len(isolated._servers) == servers


def test_a_judging_that_does_not_end_is_ended_and_costs_its_own_task(
    task: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(isolated, "MEMORY", 1 << 20)
    mark = isolated.score_safely("E3.2", task, [outcomes(task, "x" * 8_000_000)])
    assert (mark.points, mark.most, [remark.kind for remark in mark.remarks]) == (0.0, 4.0, ["endless to judge"])
    assert isolated.score_safely("E3.2", task, [outcomes(task)]).points == 4


def test_a_notebook_that_cannot_be_read_in_time_is_left_out_and_another_counts(
    course: tiny.Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(isolated, "CPU_S", 1)
    honest = HandedIn("03.ipynb", json.dumps(tiny.answered(tiny.exercise(course.release / "learners/s102"))).encode())
    found, remarks = isolated.select_safely(job(course, HandedIn("hog.ipynb", hog(90)), honest))
    assert {stem: candidate.file for stem, candidate in found.items()} == {tiny.STEM: "03.ipynb"}
    assert [remark.words["why"].kind for remark in remarks] == ["endless to read"]


def test_a_large_honest_notebook_is_read_apart_as_it_is_here(course: tiny.Course) -> None:
    notebook = tiny.answered(tiny.exercise(course.release / "learners/s102"))
    notebook["cells"][-1]["outputs"] = [{"output_type": "stream", "name": "stdout", "text": "x" * 2_000_000}]
    large = job(course, HandedIn("03.ipynb", json.dumps(notebook).encode()))
    isolated_, here = isolated.select_safely(large), isolated.select_counting(large)
    assert len(isolated._servers) == 1
    assert {stem: one.merged for stem, one in isolated_[0].items()} == {
        stem: one.merged for stem, one in here[0].items()
    }
    assert [one.page.file.data for one in isolated_[0].values()] == [b""]


@pytest.mark.parametrize("count", [1, 40])
def test_a_strangers_files_are_read_for_their_stamps_within_the_same_end(
    course: tiny.Course, count: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    stamped = json.dumps({"cells": [], "metadata": {"tflab": {"learner": "s102"}}}).encode()
    assert isolated.stamps_safely([stamped, b"no notebook"] * count) == [{"learner": "s102"}] * count
    monkeypatch.setattr(isolated, "MEMORY", 8 << 20)
    assert isolated.stamps_safely([stamped, b'{"cells": [' + b'"x", ' * 4_000_000 + b"0]}"]) == []


def test_a_server_that_was_killed_is_started_anew(task: dict[str, Any]) -> None:
    large = [outcomes(task, [0.0] * 1_900)]
    first = isolated.score_safely("E3.2", task, large)
    process, _ = isolated._servers[os.getpid()]
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    assert isolated.score_safely("E3.2", task, large) == first
