"""An update of a release takes in what was fixed, and keeps questions, points and answers."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest
import yaml

from tflab import __version__
from tflab.grading import check_command, grade
from tflab.grading import release as releasing
from tflab.grading.judging import pack as packing
from tflab.grading.judging.pack import PackError, read_pack
from tflab.workbook import atomic_files, check
from tflab.workbook.copy import lab, lay_out
from tflab.workbook.paths import WorkbookError, read_workbook

from . import tiny

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

MENDED_SOURCE = tiny.SOURCE.replace("## E3.2 · Length", "## E3.2 · Length of the long leg").replace(
    'e3_1 = task("E3.1")', 'e3_1 = task("E3.1")  # two numbers'
)
MENDED_TASKS = tiny.TASKS.replace("You subtracted.", "You took one from the other.")
OTHER_QUESTIONS = CASES["other_questions"]
OTHER_NUMBERS = MENDED_TASKS.replace(*OTHER_QUESTIONS["numbers"][1:])
ANOTHER_TASK = MENDED_TASKS + CASES["another_task"]
ANOTHER_CELL = MENDED_SOURCE + CASES["another_cell"]
NAME = f"exercises/en/E{tiny.STEM}.ipynb"


@pytest.fixture
def out(course: tiny.Course, tmp_path: Path) -> tiny.Course:
    """A release of one's own, with answers of s102 in the folder that was handed out."""
    shutil.copytree(course.release, tmp_path / "release")
    mine = tiny.Course(tmp_path / "workbook", tmp_path / "release")
    path = mine.release / "learners" / "s102" / NAME
    path.write_text(json.dumps(tiny.answered(tiny.exercise(path.parents[2]))), encoding="utf-8")
    return mine


def comes_out(
    course: tiny.Course, monkeypatch: pytest.MonkeyPatch, source: str = MENDED_SOURCE, tasks: str = MENDED_TASKS
) -> None:
    """Let a version of the workbook be installed."""
    tiny.write_tiny_workbook(course.workbook, source, tasks)
    monkeypatch.setenv("TFLAB_WORKBOOK", str(course.workbook))


def cells(notebook: dict) -> dict[str, str]:
    return {cell["id"]: "".join(cell["source"]) for cell in notebook["cells"]}


def everything_below(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_what_was_corrected_comes_in_and_answers_seed_roster_stamps_and_questions_stay(
    out, course, monkeypatch
) -> None:
    before, stamp = read_pack(out.pack), out.exercise()["metadata"]["tflab"]
    given = course.assigned("s102", "E3.1").variants[0].given
    comes_out(out, monkeypatch)
    assert releasing.main([str(out.release), "--update", "--quiet"]) == 0
    now = read_pack(out.pack)
    assert (now.seed, now.release, now.roster) == (before.seed, before.release, before.roster)
    assert out.exercise()["metadata"]["tflab"] == stamp
    there = cells(out.exercise())
    assert there["e3-2"] == "## E3.2 · Length of the long leg"
    assert there["e3-1-given"] == 'e3_1 = task("E3.1")  # two numbers'
    assert {name: there[name] for name in tiny.RIGHT} == tiny.RIGHT
    assert now.questions == before.questions
    task = out.assigned("s102", "E3.1")
    assert task.feedback["subtracted"].reply.en == "You took one from the other."
    assert task.variants[0].given == given
    assert "긴" not in cells(out.exercise("s101"))["e3-2"]  # the Korean text was not mended


def test_an_update_without_anything_new_changes_no_file(out, course, monkeypatch) -> None:
    monkeypatch.setenv("TFLAB_WORKBOOK", str(course.workbook))
    before = everything_below(out.release)
    _, lines = releasing.update_release(out.release)
    assert lines == []
    assert everything_below(out.release) == before


@pytest.mark.parametrize("what", OTHER_QUESTIONS)
def test_an_update_that_would_change_a_question_is_refused_and_changes_nothing(
    what: str, out, monkeypatch, capsys
) -> None:
    task, old, new = OTHER_QUESTIONS[what]
    assert old in MENDED_TASKS
    before = everything_below(out.release)
    comes_out(out, monkeypatch, tasks=MENDED_TASKS.replace(old, new))
    assert releasing.main([str(out.release), "--update", "--quiet"]) == 2
    said = capsys.readouterr().err
    assert f"{task} asks something else in tflab" in said and "Nothing was changed" in said
    assert said.count("\n") == 1
    assert everything_below(out.release) == before


def test_an_update_without_a_released_task_is_refused_and_changes_nothing(out, monkeypatch) -> None:
    before = everything_below(out.release)
    source, tasks = MENDED_SOURCE.partition('# %% [markdown] lang="en" name="e3-3"')[0], MENDED_TASKS
    comes_out(out, monkeypatch, source, tasks.partition("# -- e3_3.py")[0])
    with pytest.raises(PackError, match=r"^E3\.3 asks something else"):
        releasing.update_release(out.release)
    assert everything_below(out.release) == before


@pytest.mark.parametrize("lacks", ["a question", "the chapter"])
def test_grading_with_a_version_that_asks_something_else_is_refused(
    lacks: str, out, monkeypatch, tmp_path: Path, capsys
) -> None:
    tiny.hand_in(tmp_path / "in", "s102", out.exercise())
    comes_out(out, monkeypatch, tasks=OTHER_NUMBERS)
    if lacks == "the chapter":
        shutil.rmtree(out.workbook / "solutions" / "tasks" / tiny.STEM)
    words = [str(tmp_path / "in"), "--pack", str(out.pack), "--out", str(tmp_path / "out"), "--quiet"]
    assert grade.main(words) == 2
    said = capsys.readouterr().err
    other = f"E3.1 asks something else in tflab {__version__} than when it was released"
    assert (other if lacks == "a question" else "there are no tasks in") in said and said.count("\n") == 1
    assert not (tmp_path / "out" / "results.json").exists()


def test_check_refuses_a_question_that_is_not_the_one_that_was_handed_out(out, monkeypatch, capsys) -> None:
    copy = out.copy_of("s102")
    monkeypatch.chdir(copy)
    comes_out(out, monkeypatch, tasks=OTHER_NUMBERS)
    check("E3.1", 7.0)
    assert "your class got E3.1 from another version of tflab" in capsys.readouterr().out
    assert check_command.main([str(copy / NAME)]) == 2
    said = capsys.readouterr().err
    assert "your class got E3.1 from another version of tflab" in said and said.count("\n") == 1


def test_a_new_task_is_no_part_of_a_release_that_is_out(out, monkeypatch, capsys) -> None:
    comes_out(out, monkeypatch, ANOTHER_CELL, ANOTHER_TASK)
    assert releasing.main([str(out.release), "--update", "--quiet"]) == 0
    assert f"{tiny.STEM}: E3.4 is new, and no part of this release" in capsys.readouterr().out
    assert not [name for name in cells(out.exercise()) if name.startswith("e3-4")]
    graded = read_pack(out.pack).for_learner("s102")[tiny.STEM]["tasks"]
    assert sum(task["points"] for task in graded.values()) == 8
    assert list(read_workbook(out.copy_of("s102")).questions) == list(graded)


@pytest.mark.parametrize("cut", [1, 2, 4, 8])
def test_an_update_that_was_cut_short_loses_nothing_and_is_finished_by_calling_it_again(cut: int, out, monkeypatch):
    whole = out.release.with_name("whole")
    shutil.copytree(out.release, whole)
    comes_out(out, monkeypatch)
    releasing.update_release(whole)
    written, write = [], lay_out.write_whole

    def write_some(path: Path, text: str | bytes) -> None:
        written.append(path)
        if len(written) == cut:
            raise KeyboardInterrupt
        write(path, text)

    with monkeypatch.context() as cutting:
        for module in (lay_out, packing, atomic_files):
            cutting.setattr(module, "write_whole", write_some)
        with pytest.raises(KeyboardInterrupt):
            releasing.update_release(out.release)
    assert {name: cells(out.exercise())[name] for name in tiny.RIGHT} == tiny.RIGHT
    assert read_pack(out.pack).seed == read_pack(whole / "instructor").seed
    releasing.update_release(out.release)
    for learner in ("s101", "s102"):
        ours, theirs = (everything_below(root / "learners" / learner) for root in (out.release, whole))
        kept = ("exercises", "notebooks", "workbook.json", ".tflab/pristine.zip")
        assert {name: ours[name] for name in theirs if name.startswith(kept)} == {
            name: theirs[name] for name in theirs if name.startswith(kept)
        }
    assert read_pack(out.pack).digest == read_pack(whole / "instructor").digest


def test_what_was_handed_in_before_is_graded_as_it_was_and_nobody_is_told_that_they_changed_a_cell(
    out, monkeypatch, tmp_path: Path
) -> None:
    tiny.hand_in(tmp_path / "before", "s102", out.exercise())
    tiny.hand_in(tmp_path / "before", "s101", tiny.answered(out.exercise("s101"), {"e3-1-answer": "total = 1.0"}))

    def results(name: str) -> str:
        words = [str(tmp_path / "before"), "--pack", str(out.pack), "--out", str(tmp_path / name), "--quiet"]
        assert grade.main(words) in (0, 1)
        return (tmp_path / name / "results.json").read_text()

    first = results("first")
    comes_out(out, monkeypatch)
    releasing.update_release(out.release)
    second = results("second")
    points = r'"points": [^,}\n]+'
    assert re.findall(points, second) == re.findall(points, first) != []
    assert "changed" not in second


def test_a_copy_at_home_takes_in_what_is_handed_out_anew(out, monkeypatch, tmp_path: Path, capsys) -> None:
    home = tmp_path / "home"
    shutil.copytree(out.release / "learners" / "s102", home)
    comes_out(out, monkeypatch)
    releasing.update_release(out.release)
    monkeypatch.setattr(lab, "start_jupyterlab", lambda options: None)
    assert lab.lab([str(home), "--from", str(out.release / "learners" / "s102"), "--copy-only"]) == 0
    there = cells(tiny.exercise(home))
    assert there["e3-2"] == "## E3.2 · Length of the long leg"
    assert {name: there[name] for name in tiny.RIGHT} == tiny.RIGHT
    assert tiny.exercise(home)["metadata"]["tflab"] == out.exercise()["metadata"]["tflab"]
    assert "cells kept" in capsys.readouterr().out


@pytest.mark.parametrize("fault", ["another learner", "another release", "no release", "nothing there"])
def test_what_was_not_handed_out_to_this_learner_is_refused(fault: str, out, course, tmp_path: Path) -> None:
    home, source = tmp_path / "home", out.release / "learners" / "s102"
    shutil.copytree(source, home)
    if fault == "another learner":
        source = out.release / "learners" / "s101"
    elif fault == "another release":
        record = tiny.files_below(source)[f".tflab/pristine.zip/{NAME}"]
        tiny.change_record(source, NAME, record.replace(read_pack(out.pack).release.encode(), b"deadbeef"))
    elif fault == "no release":
        source = lay_out.lay_out(tmp_path / "own", "en")
    else:
        source = tmp_path / "nowhere"
    before = everything_below(home)
    with pytest.raises(WorkbookError, match="nothing was changed"):
        lay_out.handed_out_in(source, home)
    assert everything_below(home) == before


def test_a_folder_that_is_gone_is_said_and_the_others_are_updated(out, monkeypatch, tmp_path: Path, capsys) -> None:
    shutil.rmtree(out.release / "learners" / "s101")
    comes_out(out, monkeypatch)
    _, lines = releasing.update_release(out.release)
    assert f"{out.release / 'learners' / 's101'} is not there any more; --add lays it out again" in lines
    assert cells(out.exercise())["e3-2"] == "## E3.2 · Length of the long leg"
    with pytest.raises(PackError, match="there is no pack"):
        releasing.update_release(tmp_path)
    assert releasing.main([str(tmp_path), "--update", "--add"]) == 2
    assert "call it again with --add for more" in capsys.readouterr().err
