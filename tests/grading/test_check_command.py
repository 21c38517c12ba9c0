"""`tflab check` shows a learner what grading will see, before it does."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import pytest

from tflab.grading import check_command
from tflab.grading.check_command import main
from tflab.grading.judging.job import RunCell
from tflab.grading.judging.plain_kernel import run_plainly
from tflab.grading.kernels.limits import Limits

from . import tiny


@pytest.fixture
def copy(course: tiny.Course, tmp_path: Path) -> Path:
    """A learner's own copy of what was handed out to s102."""
    return Path(shutil.copytree(course.release / "learners" / "s102", tmp_path / "copy"))


def answer(copy: Path, answers: dict[str, str], name: str = f"E{tiny.STEM}") -> Path:
    path = copy / "exercises" / "en" / f"{name}.ipynb"
    path.write_text(json.dumps(tiny.answered(tiny.exercise(copy), answers)), encoding="utf-8")
    return path


def test_what_is_right_is_right_a_mistake_is_named_and_what_is_open_is_said(
    copy: Path, capsys: pytest.CaptureFixture
) -> None:
    assert main([str(answer(copy, tiny.RIGHT))]) == 0
    said = capsys.readouterr().out
    assert said.startswith("E3.1  ✓ 2/2 points\nE3.2  ✓ 4/4 points\nE3.3  ✓ 2/2 points\n")
    assert "8 of 8 points on the public cases" in said
    stub = 'def length(x, y):\n    raise NotImplementedError("your turn")'
    assert main([str(answer(copy, {"e3-1-answer": "total = e3_1.a - e3_1.b", "e3-2-answer": stub}))]) == 1
    said = capsys.readouterr().out
    assert "E3.1  ✗ 0/2 points   You subtracted." in said
    assert "E3.2  – not answered" in said


def test_an_exercise_is_called_by_its_number_too(copy: Path, monkeypatch, capsys) -> None:
    path = answer(copy, tiny.RIGHT)
    copy = copy.rename(copy.with_name("tflab_workbook"))
    for below in ("..", "exercises"):
        monkeypatch.chdir(copy / below)
        assert main(["3"]) == 0
        assert "8 of 8 points" in capsys.readouterr().out
    assert main(["E3.2"]) == 0
    assert capsys.readouterr().out == "E3.2  ✓ 4/4 points\n"
    assert main(["E3.9"]) == 2
    assert "unknown task E3.9; available: E3.1, E3.2, E3.3" in capsys.readouterr().err
    monkeypatch.chdir(copy.parents[1])
    assert main(["3"]) == 2
    assert "no workbook copy here" in capsys.readouterr().err
    monkeypatch.chdir(copy)
    path = copy / path.relative_to(copy.with_name("copy"))
    path.rename(path.with_name("mine.ipynb"))
    renamed = "is not there; the folder has mine.ipynb. Renamed? Type `tflab check` with its path."
    for word, words in (
        ("3", renamed),
        ("99", 'unknown exercise "99"; available: 03'),
        ("mine_of_yesterday.ipynb", "cannot be opened"),
    ):
        assert main([word]) == 2
        assert words in capsys.readouterr().err


def test_what_grading_would_ignore_is_said_before_it_is_too_late(copy: Path, capsys: pytest.CaptureFixture) -> None:
    notebook = tiny.answered(tiny.exercise(copy), {**tiny.RIGHT, "e3-1-given": "e3_1 = 3"})
    original = notebook["cells"][tiny.index_of(notebook, "e3-2-answer")]
    notebook["cells"].append(original | {"id": "copy", "source": "def length(x, y): return 3"})
    path = tiny.hand_in(copy / "exercises", "en", notebook)
    assert main([str(path)]) == 1
    said = capsys.readouterr().out
    assert 'E3.2: two different cells are called "e3-2-answer"' in said
    assert 'E3.1: the cell "e3-1-given" was changed; grading uses its own.' in said


def test_a_learner_is_answered_in_their_language(
    course: tiny.Course, tmp_path: Path, capsys: pytest.CaptureFixture
) -> None:
    copy = shutil.copytree(course.release / "learners" / "s101", tmp_path / "copy")
    path = tiny.hand_in(copy / "exercises", "ko", tiny.answered(tiny.exercise(copy, "ko")))
    assert main([str(path)]) == 0
    assert "공개 문제 기준 8점 만점에 8점" in capsys.readouterr().out


def test_a_system_that_is_not_linux_is_called_as_its_user_calls_it(monkeypatch) -> None:
    for platform, name in (("win32", "Windows"), ("darwin", "macOS"), ("freebsd14", "freebsd14")):
        monkeypatch.setattr(check_command, "sys", SimpleNamespace(platform=platform))
        runs, _, note = check_command._runner(plainly=False, language="en")
        assert runs is run_plainly
        assert note == f"Checked in an ordinary kernel (this is {name}, grading is on Linux)."


def test_what_does_not_end_is_stopped_once_and_costs_its_own_points(
    copy: Path, capsys: pytest.CaptureFixture, monkeypatch
) -> None:
    monkeypatch.setattr("tflab.grading.check_command.Limits", partial(Limits, cell_s=2.0, notebook_s=12.0))
    path = answer(copy, {**tiny.RIGHT, "e3-3-answer": "while True: pass"})
    assert main([str(path)]) == 1
    said = capsys.readouterr().out
    assert said.startswith("E3.1  ✓ 2/2 points\nE3.2  ✓ 4/4 points\n")
    assert "did not end within 2 s." in said and "second run" not in said


def test_without_a_sandbox_an_ordinary_kernel_does_and_an_answer_that_ends_python_costs_its_own_points(
    copy: Path, capsys: pytest.CaptureFixture
) -> None:
    path = answer(copy, {**tiny.RIGHT, "e3-1-answer": "import os\nos._exit(3)", "e3-3-answer": "frames = 1 / 0"})
    assert main([str(path), "--plain"]) == 1
    said = capsys.readouterr().out
    assert said.startswith("Checked in an ordinary kernel (--plain).\nE3.1  ! 0/2 points")
    assert "E3.2  ✓ 4/4 points\n" in said and "the answer cell stops with ZeroDivisionError." in said
    ran = run_plainly([RunCell("answer", "endless", "while True: pass")], Limits(cell_s=1.0))
    assert ran.stopped == "timed out"


def test_what_is_no_notebook_of_a_chapter_that_is_here_is_one_line(copy: Path, capsys: pytest.CaptureFixture) -> None:
    path = answer(copy, tiny.RIGHT)
    (copy / "mine.ipynb").write_text(json.dumps({"cells": [tiny.own_cell("x = 1")]}))
    for name, words in (("nowhere.ipynb", ""), ("workbook.json", ""), (".", ""), ("mine.ipynb", tiny.STEM)):
        assert main([str(copy / name)]) == 2
        said = capsys.readouterr().err
        assert said.startswith("tflab check: ") and words in said and said.count("\n") == 1
    (copy / "workbook.json").write_text("{")
    assert main([str(path)]) == 2
    assert "workbook.json cannot be read" in capsys.readouterr().err


def test_a_damaged_master_is_one_line(copy: Path, capsys: pytest.CaptureFixture) -> None:
    path = answer(copy, tiny.RIGHT)
    for text in ("{", "[]", "{}", '{"cells": [1]}'):
        tiny.change_record(copy, f"exercises/en/E{tiny.STEM}.ipynb", text.encode())
        assert main([str(path)]) == 2
        said = capsys.readouterr().err
        assert "is damaged" in said and said.count("\n") == 1


def test_without_a_record_the_installed_exercise_is_the_master_and_a_wrong_byte_is_no_traceback(
    copy: Path, capsys: pytest.CaptureFixture
) -> None:
    path, record = answer(copy, tiny.RIGHT), copy / ".tflab" / "pristine.zip"
    held = record.read_bytes()
    record.write_bytes(b"PK\x03\x04")
    assert main([str(path)]) == 0
    assert "8 of 8 points" in capsys.readouterr().out
    for place in range(40, 400, 120):
        record.write_bytes(held[:place] + bytes([held[place] ^ 0xFF]) + held[place + 1 :])
        assert main([str(path)]) in (0, 2)
        assert capsys.readouterr().err.count("\n") <= 1


def test_a_task_that_cannot_be_read_is_one_line(copy: Path, tmp_path: Path, monkeypatch, capsys) -> None:
    path = answer(copy, tiny.RIGHT)
    workbook = tiny.write_tiny_workbook(tmp_path / "workbook")
    (workbook / "solutions" / "tasks" / tiny.STEM / "e3_2.py").write_text("TASK = 1 / 0")
    monkeypatch.setenv("TFLAB_WORKBOOK", str(workbook))
    assert main([str(path)]) == 2
    said = capsys.readouterr().err
    assert "e3_2.py cannot be run: ZeroDivisionError" in said and said.count("\n") == 1


def test_a_renamed_exercise_is_known_by_its_stamp_and_without_it_by_its_cells(copy: Path, capsys) -> None:
    path = answer(copy, tiny.RIGHT, "mine")
    assert main([str(path)]) == 0
    notebook = json.loads(path.read_text(encoding="utf-8"))
    del notebook["metadata"]["tflab"]
    path.write_text(json.dumps(notebook), encoding="utf-8")
    assert main([str(path)]) == 0
    assert capsys.readouterr().out.count("8 of 8 points") == 2


def test_what_learners_and_releases_need_is_there_where_linux_is_not() -> None:
    gone = "import sys; sys.modules.update(dict.fromkeys(('resource', 'pwd', 'grp')))"
    modules = "check_command", "release", "grade", "judging.plain_kernel"
    imports = "; ".join(f"import tflab.grading.{name}" for name in modules)
    subprocess.run([sys.executable, "-c", f"{gone}; {imports}"], check=True)
