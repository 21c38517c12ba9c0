"""pytest shows tasks as test items, and nothing where nobody asked."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from tflab.grading.judging.pack import read_pack

from . import tiny

PLUGIN = "tflab.grading.plugin"


def run_pytest(*words: object, workbook: Path) -> str:
    command = [sys.executable, "-m", "pytest", "-p", PLUGIN, "-p", "no:cacheprovider", "-c", os.devnull, "-v", *words]
    environment = os.environ | {"TFLAB_WORKBOOK": str(workbook), "PYTEST_ADDOPTS": "", "COLUMNS": "200"}
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env=environment, cwd="/")
    return done.stdout + done.stderr


def test_each_task_is_an_item_that_says_what_it_is_worth_if_somebody_asks(course: tiny.Course, tmp_path: Path) -> None:
    answers = {**tiny.RIGHT, "e3-2-answer": "def length(x, y):\n    return x + y"}
    path = tiny.hand_in(tmp_path, "s101", tiny.answered(course.exercise("s101"), answers))
    (tmp_path / "s102.ipynb").write_text("{}")
    said = run_pytest("--tflab-grade", course.pack, path, tmp_path / "s102.ipynb", workbook=course.workbook)
    outcomes = re.findall(r"(s10\d).*E3.{1,2}\d (PASSED|FAILED)", said)
    assert sorted(outcomes) == [("s101", "FAILED"), *[("s101", "PASSED")] * 2, *[("s102", "FAILED")] * 3], said
    assert re.search(r"E3\.2: \d.* points, (partly|wrong)\.", said)
    assert "missing. s102.ipynb: not a notebook: no cells in it." in said
    assert "return x + y" not in said
    said = run_pytest(path.parent, workbook=course.workbook)
    assert "no tests ran" in said
    assert "E3.1" not in said


def test_what_does_not_end_is_tried_once_more(
    course: tiny.Course, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    from tflab.grading import batch, plugin
    from tflab.grading.judging import submission as one

    asked = []
    monkeypatch.setattr(
        batch, "grade_job", lambda job, **_: asked.append(job.only) or {"set_aside": {tiny.STEM: ["E3.1"]}}
    )
    monkeypatch.setattr(one, "merge_records", lambda record, alone: {"both": [record, alone]})
    path = tiny.hand_in(tmp_path, "s101", course.exercise("s101"))
    folder = SimpleNamespace(config=SimpleNamespace(getoption=lambda _: course.pack), path=path, _record=None)
    folder.read_pack = lambda: read_pack(course.pack)
    assert "both" in plugin.TasksFile.record(folder)
    assert asked == [None, {tiny.STEM: ["E3.1"]}]


def test_a_folder_that_is_no_pack_is_refused_in_one_line(course: tiny.Course, tmp_path: Path) -> None:
    path = tiny.hand_in(tmp_path, "s101", course.exercise("s101"))
    said = run_pytest("--tflab-grade", tmp_path, path, workbook=course.workbook)
    assert "--tflab-grade" in said
    assert "Traceback" not in said


def test_a_pack_of_a_version_that_asks_something_else_fails_every_task_in_one_line(
    course: tiny.Course, tmp_path: Path
) -> None:
    path = tiny.hand_in(tmp_path, "s101", tiny.answered(course.exercise("s101")))
    workbook = tiny.write_tiny_workbook(
        tmp_path / "workbook", tasks=tiny.TASKS.replace("uniform(1, 5))", "uniform(2, 5))")
    )
    said = run_pytest("--tflab-grade", course.pack, path, workbook=workbook)
    assert re.findall(r"E3.{1,2}\d (PASSED|FAILED)", said) == ["FAILED"] * 3
    assert "E3.1 asks something else in tflab" in said
    assert "Traceback" not in said and "raise " not in said
