"""Practice draws tasks with new numbers, judges answers as an exercise does, and writes nothing."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tflab.workbook import judge_answer, practice, progress
from tflab.workbook.paths import workbook_data
from tflab.workbook.tasks.reference import in_process_ros

from . import small_chapter
from .conftest import notebook
from .each_task import FILES, READS, STEMS, each_task, solution_of, task_in


@pytest.mark.proof(reads=READS)
@each_task
def test_a_drawn_task_accepts_the_solution(stem: str, file: str) -> None:
    task = task_in(stem, file)
    if task.is_costly or task.counts:
        return  # never asked
    question = practice.draw_question(stem, task.id, 1001, workbook_data())
    with in_process_ros():
        inputs = question.given if question.assigned.variant.given is not None else None
        verdict, _ = judge_answer.judge_answer(question.assigned, solution_of(stem).answer(task, inputs))
    assert verdict.failure is None
    assert f"{task.id} · " in question.text.splitlines()[0]
    assert " points)" not in question.text.splitlines()[0]
    assert task.answer in question.starter
    assert "task(" not in question.starter


def test_a_number_draws_the_same_inputs_each_time_and_inventory_and_costly_tasks_are_not_asked() -> None:
    first, same, other = (
        practice.draw_question("03_target_and_source", "E3.2", number, workbook_data()).given for number in (7, 7, 8)
    )
    assert first == same != other
    tasks = {file.replace("_", ".").upper() for _, file in FILES}
    assert tasks - set(practice.practice_tasks(STEMS)) == {"E0.1", "E12.2", "E12.4", "E12.7", "E12.8"}


@pytest.fixture
def copy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A learner's copy of a small chapter, and the workbook that it comes from."""
    root = small_chapter.copy_of_workbook(tmp_path, monkeypatch)
    for language, title in (("en", "Corner"), ("ko", "모서리")):
        folder = tmp_path / "workbook" / "exercises" / language
        folder.mkdir(parents=True)
        asked = notebook(
            load="%load_ext tflab\nfrom tflab.workbook import check, task", imports="import math",
            e3_1=f"## E3.1 · {title} (3 points)\n\nWhere is it in `base_link`?", e3_1_given='e3_1 = task("E3.1")',
            e3_1_answer="base_p_corner = ...", e3_2_answer='def invert(T):\n    raise NotImplementedError("your turn")',
        )  # fmt: skip
        (folder / f"E{small_chapter.STEM}.ipynb").write_text(asked, encoding="utf-8")
    monkeypatch.chdir(root)
    monkeypatch.setattr(practice, "_question", None)
    monkeypatch.setattr(practice, "_asked", practice.Counter())
    return root


def ask_for(task_id: str) -> None:
    """Ask until a task comes; four calls ask all four."""
    for _ in range(4):
        practice.ask()
        if practice._question.assigned.id == task_id:
            return
    pytest.fail(f"{task_id} was not asked")


def test_a_notebook_gets_a_cell_for_the_answer(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ask_for("E3.1")
    shown = capsys.readouterr().out
    assert "## E3.1 · Corner\n\nWhere is it in `base_link`?" in shown
    cell = "import math\n\ne3_1 = practice.given()\nbase_p_corner = ...\n\npractice.check(base_p_corner)\n"
    assert shown.endswith(cell)
    assert practice.given().laser_p_corner == (2.0, 0.5, 0.0)


def test_every_task_is_asked_before_one_comes_again(copy: Path) -> None:
    asked = []
    for _ in range(8):
        practice.ask()
        asked.append(practice._question.assigned.id)
    assert set(asked[:4]) == set(asked[4:]) == {"E3.1", "E3.2", "E3.3", "E3.4"}


def test_an_answer_gets_the_reply_of_an_exercise_and_leaves_no_trace(copy: Path, capsys) -> None:
    before = sorted(path.name for path in copy.iterdir())
    ask_for("E3.3")
    practice.check({"target": "laser", "source": "map"})
    assert "E3.3 ✗ 0/2 points: turned round" in capsys.readouterr().out
    practice.hint()
    assert "hint 1 of 3: hint 1" in capsys.readouterr().out
    practice.check({"target": "map", "source": "laser"})
    assert "E3.3 ✓ 2/2 points\npractice.ask() gives the next one." in capsys.readouterr().out
    assert sorted(path.name for path in copy.iterdir()) == before


def test_a_solution_opens_after_three_different_answers_and_never_in_a_class(copy: Path, capsys) -> None:
    ask_for("E3.3")
    for ends in (("laser", "map"), ("laser", "map"), ("laser", "laser"), ("map", "map")):
        practice.solution()
        assert "the solution opens after a pass or three tries" in capsys.readouterr().out
        practice.check(dict(zip(("target", "source"), ends, strict=True)))
    practice.solution()
    assert 'roles = {"target": "map", "source": "laser"}' in capsys.readouterr().out
    mark = json.loads((copy / "workbook.json").read_text())
    (copy / "workbook.json").write_text(json.dumps(mark | {"edition": "class", "questions": {"E3.3": "a digest"}}))
    practice.ask()
    practice.solution()
    assert "in a class, the solutions are with your instructor" in capsys.readouterr().out


def test_texts_are_in_the_language_of_the_copy(copy: Path, capsys) -> None:
    mark = json.loads((copy / "workbook.json").read_text())
    (copy / "workbook.json").write_text(json.dumps(mark | {"language": "ko"}))
    practice.check(1)
    assert "practice.ask()를 실행하면 다음 문제가 나옵니다." in capsys.readouterr().out
    ask_for("E3.1")
    shown = capsys.readouterr().out
    assert "아래 셀에 답을 쓰고 실행하면 바로 확인합니다." in shown
    assert "E3.1 · 모서리" in shown


def test_only_chapters_so_far_are_asked_unless_others_are_named(tmp_path: Path, capsys, monkeypatch) -> None:
    mark = {"tflab": "0.1.0", "edition": "self-study", "language": "en", "learner": None}
    (tmp_path / "workbook.json").write_text(json.dumps(mark))
    assert [stem[:2] for stem in practice._chosen_stems(tmp_path, ())] == ["01"]
    progress.record_try(tmp_path, "E3.5", 0, 1)
    assert [stem[:2] for stem in practice._chosen_stems(tmp_path, ())] == ["01", "02", "03"]
    assert [stem[:2] for stem in practice._chosen_stems(tmp_path, (8, "11"))] == ["08", "11"]
    monkeypatch.chdir(tmp_path)
    practice.ask(14)
    assert 'unknown chapter "14"' in capsys.readouterr().out
