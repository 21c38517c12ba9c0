"""What was tried is written down, also by two notebooks at once, and nothing of it is lost."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tflab.workbook import progress
from tflab.workbook.copy.lay_out import lay_out
from tflab.workbook.course.progress_page import ProgressPage, course_progress
from tflab.workbook.course.progress_page import progress as progress_command
from tflab.workbook.progress import Attempts, attempts, record_hint, record_try
from tflab.workbook.tasks.task import task_file

from .conftest import HandedOut


@pytest.fixture
def copy(handed_out: HandedOut, tmp_path: Path) -> Path:
    return lay_out(tmp_path / "copy", "en")


TASK = """
from tflab.workbook.tasks import Number, Task, Text
LOOK = Text(en="Look.", ko="보십시오.")
TASK = Task("{id}", "N", 2, Text("Which?", "어느 것?"), "answer", Number(), (LOOK, LOOK, LOOK))
"""


def give_tasks(handed_out: HandedOut, stem: str, *names: str) -> None:
    folder = handed_out.root / "solutions" / "tasks" / stem
    folder.mkdir()
    for name in names:
        task_file(folder, name).write_text(TASK.format(id=name), encoding="utf-8")


def test_tries_hints_and_mistakes_are_counted_and_a_pass_stays(copy: Path) -> None:
    record_try(copy, "E3.2", 1, 6, "swapped")
    record_try(copy, "E3.2", 6, 6)
    record_try(copy, "E3.2", 0, 6, "swapped")
    assert [record_hint(copy, "E3.2"), record_hint(copy, "E3.2"), record_hint(copy, "E3.3")] == [1, 2, 1]
    assert attempts(copy, "E3.2") == Attempts(tries=3, hints=2, passed=True, best=6, of=6, twins={"swapped": 2})
    assert attempts(copy, "E3.4") == Attempts()


def test_an_answer_that_was_checked_before_is_no_new_try_and_may_be_right_by_now(copy):
    for outcomes in ([1.0, "a"], [1.0, "a"], [2.0, "a"], [1.0, "a"]):
        record_try(copy, "E3.2", 0, 6, "swapped", outcomes)
    assert attempts(copy, "E3.2").tries == 2
    assert attempts(copy, "E3.2").twins == {"swapped": 2}
    record_try(copy, "E3.2", 6, 6, None, [1.0, "a"])
    assert attempts(copy, "E3.2").passed and attempts(copy, "E3.2").tries == 2


def test_nothing_is_kept_where_there_is_no_copy(tmp_path: Path) -> None:
    record_try(tmp_path, "E3.2", 6, 6)
    assert record_hint(tmp_path, "E3.2") == 0
    assert attempts(tmp_path, "E3.2") == Attempts()
    assert list(tmp_path.iterdir()) == []


def test_notebooks_that_write_at_once_lose_nothing(copy: Path) -> None:
    program = (
        "import sys; from pathlib import Path; from tflab.workbook.progress import record_try\n"
        "for _ in range(40): record_try(Path(sys.argv[1]), 'E3.2', 0, 6, sys.argv[2]); "
        "record_try(Path(sys.argv[1]), sys.argv[3], 0, 6)"
    )
    arguments = [("left", "E3.3"), ("right", "E3.4")]
    running = [subprocess.Popen([sys.executable, "-c", program, str(copy), *words]) for words in arguments]
    assert [process.wait(timeout=60) for process in running] == [0, 0]
    assert attempts(copy, "E3.2").twins == {"left": 40, "right": 40}
    assert [attempts(copy, name).tries for name in ("E3.2", "E3.3", "E3.4")] == [80, 40, 40]


@pytest.mark.parametrize(
    "text",
    [
        '{"format": 1, "tasks": {"E3',
        '{"format": 99, "tasks": {}}',
        '{"format": 1, "tasks": {"E3.2": {"tries": "many"}}}',
    ],
)
def test_a_file_that_cannot_be_read_is_kept_aside_and_said(text: str, copy: Path, capsys) -> None:
    (copy / "progress.json").write_text(text)
    (copy / "progress.kept-1.json").write_text("an earlier one")
    record_try(copy, "E3.2", 6, 6)
    assert (copy / "progress.kept-2.json").read_text() == text
    assert (copy / "progress.kept-1.json").read_text() == "an earlier one"
    assert attempts(copy, "E3.2").passed
    assert "It is kept as progress.kept-2.json" in capsys.readouterr().err


def test_a_place_that_cannot_be_written_to_is_said_and_check_goes_on(copy: Path, capsys, monkeypatch) -> None:
    def refuse(path: Path, text: str) -> None:
        raise PermissionError("read-only")

    monkeypatch.setattr(progress, "write_whole", refuse)
    record_try(copy, "E3.2", 6, 6)
    assert "could not be written" in capsys.readouterr().err


def test_only_passed_checks_tick_and_what_is_not_here_is_later(handed_out: HandedOut, copy: Path) -> None:
    give_tasks(handed_out, "03_target_and_source", "E3.1", "E3.2", "E3.5", "E3.10")
    record_try(copy, "E3.1", 4, 4)
    record_try(copy, "E3.5", 3, 4)
    stands = course_progress(copy)
    chapter = stands.chapters[3]
    assert [task.id for task in chapter.tasks] == ["E3.1", "E3.2", "E3.5", "E3.10"]
    assert chapter.passed == 1
    echo = stands.checklist[1]
    assert (echo.state, echo.passed, echo.here) == ("open", 1, ["E3.1", "E3.5"])
    assert stands.checklist[0].state == "later"
    record_try(copy, "E3.5", 4, 4)
    assert course_progress(copy).checklist[1].state == "passed"
    assert course_progress(copy).objectives[1].state == "open"  # its tasks of chapter 4 are not here


def test_the_page_says_what_is_left_what_its_signs_mean_and_what_to_type_on_a_robot(
    handed_out: HandedOut, copy: Path, tmp_path: Path
) -> None:
    give_tasks(handed_out, "03_target_and_source", "E3.1", "E3.5", "E3.6")
    record_try(copy, "E3.1", 4, 4)
    record_try(copy, "E3.5", 1, 4)
    page = ProgressPage(course_progress(copy))
    assert "Your progress: 1 of 3 tasks passed" in page.text
    assert "03  ■ ◧ □   1/3   Target and source" in page.text
    assert "1 of 2 · to pass: E3.5" in page.text
    assert "$ ros2 run tf2_ros tf2_echo base_link laser_frame" in page.text
    assert "ros2 bag record" not in page.text  # later
    assert "Chapters (■ passed, ◧ tried and not passed yet, □ not tried)" in page.text.splitlines()
    assert 'title="E3.1 · Which? · tries: 1, hints: 0"' in page.html
    assert page.html.index("◧ tried") < page.html.index(">◧</span>")
    assert page.html.count("○ not yet") == 2  # of what one can do, and of what one has done
    korean = ProgressPage(course_progress(lay_out(tmp_path / "korean", "ko"))).text
    assert "학습 현황" in korean and "What you can do" not in korean


def test_tflab_progress_finds_the_copy_below_the_folder_it_is_called_in(
    handed_out: HandedOut, tmp_path: Path, monkeypatch, capsys
) -> None:
    def shown() -> str:
        code = progress_command([])
        out, err = capsys.readouterr()
        assert code == (2 if err else 0)
        return out or err

    give_tasks(handed_out, "03_target_and_source", "E3.1", "E3.5")
    monkeypatch.chdir(tmp_path)
    assert "no workbook copy here" in shown()
    usual = lay_out(tmp_path / "tflab_workbook", "en")
    started = "Your progress: 0 of 2 tasks passed\nNext: E3.1 · Which? (exercises/en/E03_target_and_source.ipynb)\n"
    assert shown() == started
    record_try(usual, "E3.1", 4, 4)
    assert "Next: E3.5" in shown()
    usual.rename(tmp_path / "mine")  # the only one there is
    assert "Next: E3.5" in shown()
    lay_out(tmp_path / "yours", "en")
    assert "no workbook copy here" in shown()
    assert progress_command([str(tmp_path)]) == 2
    assert "create one with: tflab lab" in capsys.readouterr().err
