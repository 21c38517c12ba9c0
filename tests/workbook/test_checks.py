"""What `check`, `hint` and `solution` print."""

from __future__ import annotations

import json
import math
import os
import time
from dataclasses import replace

import pytest
from IPython.core.interactiveshell import InteractiveShell

from tflab.core import LookupException, Transform
from tflab.ros.messages import geometry_msgs, std_msgs
from tflab.ros.time import Time
from tflab.workbook import check, checks, hint, judge_answer, solution, task
from tflab.workbook.answers.forms import Angle, Choice, Number, Parts, Sequence
from tflab.workbook.answers.showing import show, show_in_a_line
from tflab.workbook.answers.values import raised, to_plain
from tflab.workbook.diagnosis import comparison
from tflab.workbook.diagnosis.failure import Failure
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.paths import Workbook, WorkbookError, read_workbook, workbook_data, write_workbook
from tflab.workbook.tasks.case_types import Case
from tflab.workbook.tasks.task import variant_of

from . import small_chapter as chapter


@pytest.fixture
def copy(tmp_path, monkeypatch):
    root = chapter.copy_of_workbook(tmp_path, monkeypatch)
    monkeypatch.chdir(root)
    monkeypatch.delenv("NBGRADER_EXECUTION", raising=False)
    checks._hints_seen.clear()
    return root


def said(capsys, task_id, answer):
    check(task_id, answer)
    return capsys.readouterr().out


def right_corner(capsys):
    given = task("E3.1")
    capsys.readouterr()
    return given, given.base_T_laser.apply(given.laser_p_corner)


def test_each_stage_has_its_own_words(copy, capsys):
    given, right = right_corner(capsys)
    assert "not answered yet" in said(capsys, "E3.1", ...)
    assert "wrong kind (str)" in said(capsys, "E3.1", "left")
    assert "wrong shape (tuple of 2)" in said(capsys, "E3.1", (1.0, 2.0))
    assert "joins them" not in said(capsys, "E3.1", (1.0, 2.0))
    assert "joins them; it does not add their numbers." in said(capsys, "E3.1", [1.0, 2.0, 3.0, 1.0, 2.0, 3.0])
    assert "in mm" in said(capsys, "E3.1", tuple(1000 * x for x in right))
    assert "not the right value" in said(capsys, "E3.1", (9.0, 9.0, 9.0))
    assert "that is the inverse" in said(capsys, "E3.1", given.base_T_laser.inverse().apply(given.laser_p_corner))
    assert "is a function" in said(capsys, "E3.1", lambda: right)
    assert "in degrees" in said(capsys, "E3.4", 90.0)
    place = geometry_msgs.Point(**dict(zip("xyz", right, strict=True)))
    wrong = geometry_msgs.PointStamped(header=std_msgs.Header(frame_id="map"), point=place)
    assert '"map", but the task asks for "base_link"' in said(capsys, "E3.1", wrong)


def test_why_prints_the_explanations_that_were_asked_up_to_the_one_that_answers(copy, capsys):
    given, _ = right_corner(capsys)
    check("E3.1", given.base_T_laser.inverse().apply(given.laser_p_corner), why=True)
    rows = [line.split(maxsplit=1) for line in capsys.readouterr().out.splitlines() if line.startswith("  ")]
    assert rows == [["✓", "one mistake of the task: a known mistake of the task gives just these results"]]
    check("E3.3", {"target": "map", "source": "map"}, why=True)
    out = capsys.readouterr().out
    assert "  ✓ parts of a value: " in out and "  · parts that changed places: " in out


def test_functions_are_called_on_the_public_inputs(copy, capsys):
    calls = []

    def growing(transform):
        calls.append(id(transform))
        return Transform((len(calls), 0, 0))

    def your_turn(transform):
        raise NotImplementedError("your turn")

    assert said(capsys, "E3.2", lambda T: T.inverse()).startswith("E3.2 ✓ 2/2 points")
    assert "only the sign" in said(capsys, "E3.2", lambda T: Transform([-x for x in T.translation], T.rotation))
    assert "not answered yet" in said(capsys, "E3.2", your_turn)
    assert "should be a function" in said(capsys, "E3.2", Transform())
    assert "ZeroDivisionError" in said(capsys, "E3.2", lambda T: 1 / 0)
    assert "two different results" in said(capsys, "E3.2", growing)


def test_arguments_are_fresh_copies(copy, capsys):
    seen = []

    def keeps(transform):
        seen.append(id(transform))
        return transform.inverse()

    said(capsys, "E3.2", keeps)
    assert len(seen) == 2 * 4 + 1  # at last the first call once more


def test_parts_have_credit_and_a_mistake_in_one_is_named(copy, capsys):
    assert said(capsys, "E3.3", {"target": "laser", "source": "map"}).startswith("E3.3 ✗ 0/2 points: turned round")
    assert said(capsys, "E3.3", {"target": "map", "source": "map"}).startswith(
        'E3.3 ✗ 1/2 points: "source": turned round'
    )
    assert '"source"' in said(capsys, "E3.3", {"target": "map"})
    assert "not among" in said(capsys, "E3.3", {"target": "odom", "source": "map"})


class Hostile:
    def __eq__(self, other):
        return True

    def __getattr__(self, name):
        raise RuntimeError(name)

    def __iter__(self):
        raise RuntimeError


RUBBISH = [
    Hostile(),
    [Hostile()],
    {"target": Hostile()},
    object,
    print,
    10**400,
    float("nan"),
    b"x",
    {1: 2},
    {"dict": []},
]


@pytest.mark.parametrize("task_id", ["E3.1", "E3.2", "E3.3", "E3.4"])
def test_check_never_raises_and_never_gives_points_for_rubbish(copy, capsys, task_id):
    for answer in RUBBISH:
        assert "✗ 0/" in said(capsys, task_id, answer)


def test_an_unknown_task_is_answered_with_those_there_are(copy, capsys):
    there = "The tasks are E3.1, E3.2, E3.3, E3.4."
    for task_id in ("E3.9", "E7.1", "foo", "", 3, None, "E3", "03"):
        for ask in (check, hint, solution):
            ask(task_id)
            printed = capsys.readouterr().out
            assert there in printed and not (task_id in ("E3", "03") and "Did you mean" in printed)
        with pytest.raises(WorkbookError):
            task(task_id)
    for ask in (hint, solution):
        ask()
        printed = capsys.readouterr().out
        assert printed.startswith("E?: for which task?") and there in printed


def test_in_a_page_an_unknown_task_is_one_line_without_where_it_was_found(copy, capsys):
    assert isinstance(
        InteractiveShell().run_cell("from tflab.workbook import task\ntask('E9.9')").error_in_exec, WorkbookError
    )
    (line,) = capsys.readouterr().out.splitlines()
    assert line == "there is no such task here. The tasks are E3.1, E3.2, E3.3, E3.4."


def test_what_was_meant_by_a_call_is_understood_or_asked_for(copy, capsys):
    for task_id in ("e3.1", "3.1", " E3.1 ", "e3-1"):
        assert said(capsys, task_id, "rubbish").startswith("E3.1 ✗")
    _, right = right_corner(capsys)
    assert said(capsys, right, "E3.1").startswith("E3.1 ✓")
    assert said(capsys, right, "elsewhere").startswith(str(right))
    check("E3.1")
    assert 'check("E3.1", base_p_corner)' in capsys.readouterr().out
    hint("e31")
    assert 'Did you mean "E3.1"?' in capsys.readouterr().out


def test_hints_come_one_by_one_below_those_before_and_are_counted(copy, capsys):
    lines = ["1. hint 1", "2. hint 2", "3. hint 3"]
    for shown in (["hint 1"], lines[:2], lines, lines):
        hint("E3.1")
        assert [line.rpartition(": ")[2] for line in capsys.readouterr().out.splitlines()] == shown
    assert json.loads((copy / "progress.json").read_text())["tasks"]["E3.1"]["hints"] == 4


def test_replies_are_in_the_learners_language(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(chapter.copy_of_workbook(tmp_path, monkeypatch, language="ko"))
    assert "한국어: turned round" in said(capsys, "E3.3", {"target": "laser", "source": "map"})
    assert "아직 답하지 않았습니다" in said(capsys, "E3.1", ...)
    assert said(capsys, "E3.3", {"target": "map", "source": "laser"}).startswith("E3.3 ✓ 2/2점\n")


def test_a_learner_has_a_variant_of_their_own(tmp_path, monkeypatch, capsys):
    learners = {variant_of(name, "E3.1", 3): name for name in ("ada", "grace", "alan", "edsger", "barbara", "ken")}
    assert len(learners) == 3
    seen = []
    for number, name in learners.items():
        monkeypatch.chdir(chapter.copy_of_workbook(tmp_path / str(number), monkeypatch, learner=name))
        given, right = right_corner(capsys)
        assert "E3.1 ✓" in said(capsys, "E3.1", right)
        assert "E3.1 ✗" in said(capsys, "E3.1", given.base_T_laser.inverse().apply(given.laser_p_corner))
        seen.append(given.base_T_laser)
    assert seen[0] != seen[1] != seen[2] != seen[0]


def test_the_solution_opens_after_three_tries(copy, capsys):
    solution("E3.4")
    assert "0 so far" in capsys.readouterr().out
    for wrong in (7.0, 8.0, 8.0, 7.0):  # the same answer again is no new try
        said(capsys, "E3.4", wrong)
    solution("E3.4")
    assert "2 so far" in capsys.readouterr().out
    assert "solution(" in said(capsys, "E3.4", 9.0)
    for wrong in ("no function", "none, either"):  # stopped by the same thing
        said(capsys, "E3.2", wrong)
    said(capsys, "E3.1", ...)
    said(capsys, "E3.3", {"target": "laser", "source": "map"})
    kept = json.loads((copy / "progress.json").read_text())["tasks"]
    assert (kept["E3.2"]["tries"], kept["E3.3"]["twins"]) == (1, {"swapped": 1}) and "E3.1" not in kept


def test_an_answer_that_lacks_a_part_is_no_try_yet_and_a_solution_is_shown_without_its_marks(copy, capsys):
    for unfinished in (..., {"target": "map"}, {"target": "map", "source": ...}):
        said(capsys, "E3.3", unfinished)
    solution("E3.3")
    assert "0 so far" in capsys.readouterr().out
    cell = "# BEGIN SOLUTION\nangle_rad = 1.57\n# END SOLUTION"
    chapter.lay_out(workbook_data() / "solutions", cells=chapter.CELLS | {"e3-4-answer": cell})
    for wrong in (7.0, 8.0, 9.0):
        said(capsys, "E3.4", wrong)
    solution("E3.4")
    assert capsys.readouterr().out == "angle_rad = 1.57\n"


def test_words_are_shown_before_a_picture_is_made(copy, capsys, monkeypatch):
    shown = []
    monkeypatch.setattr(judge_answer, "show_reply", lambda *_: shown.append("words"))
    monkeypatch.setattr(judge_answer, "shell", lambda: "IPython")
    monkeypatch.setattr(comparison, "picture_of", lambda *_: shown.append("picture"))
    for wrong in (7.0, 8.0, 9.0):
        check("E3.4", wrong)
    assert shown == ["words"] * 3 + ["picture"]


def test_a_class_has_no_solutions(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(chapter.copy_of_workbook(tmp_path, monkeypatch, edition="class"))
    solution("E3.4")
    assert "instructor" in capsys.readouterr().out


def test_nbgrader_gets_the_points_for_partial_credit(copy, capsys, monkeypatch):
    monkeypatch.setenv("NBGRADER_EXECUTION", "autograde")
    assert check("E3.3", {"target": "map", "source": "map"}) == 1.0
    assert check("E3.3", ...) == 0.0
    assert check("E3.9", 1) == 0.0


def test_a_pass_states_what_was_tried_and_the_next_task(copy, capsys):
    _, right = right_corner(capsys)
    assert said(capsys, "E3.1", right).endswith("Your answer is right for the numbers given to you. Next: E3.2.\n")
    assert "All 4 test calls are right. Next: E3.3." in said(capsys, "E3.2", lambda transform: transform.inverse())
    assert "Your answer is right. " in said(capsys, "E3.4", math.pi / 2)


@pytest.mark.parametrize(
    "breaks",
    ["no solution", "half a solution", "no notebook", "a solution without the cell", "half a task", "a generator"],
)
def test_a_task_that_cannot_be_computed_is_said_in_one_line(copy, capsys, breaks):
    solutions = workbook_data() / "solutions"
    path = solutions / "en" / f"{chapter.STEM}.ipynb"
    if breaks == "no solution":
        path.unlink()
    elif breaks == "half a solution":
        path.write_text(path.read_text()[:99])
    elif breaks == "no notebook":
        path.write_text("{}")
    elif breaks == "a generator":
        chapter.lay_out(solutions, tasks=chapter.TASKS.replace("rng.uniform(0.5", "rng.nothing(0.5"))
    elif breaks == "half a task":
        (solutions / "tasks" / chapter.STEM / "e3_1.py").write_text("TASK =")
    else:
        chapter.lay_out(solutions, cells={"load": "x = 1"})
    (line,) = said(capsys, "E3.1", (1.0, 2.0, 3.0)).splitlines()
    assert line.startswith("E3.1: this task cannot be checked: ") and "install tflab again." in line
    assert not (copy / "progress.json").exists()


def test_a_task_is_read_again_after_its_file_has_changed(copy, capsys):
    assert "E3.4 ✓" in said(capsys, "E3.4", math.pi / 2)
    path = workbook_data() / "solutions" / "en" / f"{chapter.STEM}.ipynb"
    chapter.lay_out(workbook_data() / "solutions", cells=chapter.CELLS | {"e3-4-answer": "angle_rad = 1.0"})
    os.utime(path, ns=(0, time.time_ns() + 10**9))
    assert "E3.4 ✗" in said(capsys, "E3.4", math.pi / 2)
    assert "E3.4 ✓" in said(capsys, "E3.4", 1.0)


def test_a_class_copy_whose_task_asks_about_other_values_is_told_so(tmp_path, monkeypatch, capsys):
    root = chapter.copy_of_workbook(tmp_path, monkeypatch, edition="class")
    monkeypatch.chdir(root)
    _, right = right_corner(capsys)
    assert "E3.1 ✓" in said(capsys, "E3.1", right)
    solutions = workbook_data() / "solutions"
    reworded = chapter.TASKS.replace("that is the inverse", "that is its inverse").replace("0.005", "0.004")
    chapter.lay_out(solutions, tasks=reworded)
    os.utime(solutions / "en" / f"{chapter.STEM}.ipynb", ns=(0, time.time_ns() + 10**9))
    assert "E3.1 ✓" in said(capsys, "E3.1", right)  # a text and a tolerance may be fixed
    chapter.lay_out(solutions, tasks=chapter.TASKS.replace("rng.uniform(0.5, 2.6)", "rng.uniform(0.5, 2.5)"))
    os.utime(solutions / "en" / f"{chapter.STEM}.ipynb", ns=(0, time.time_ns() + 2 * 10**9))
    tried = (root / "progress.json").read_text()
    for ask in (lambda: check("E3.1", right), lambda: hint("E3.1")):
        ask()
        assert capsys.readouterr().out.startswith("E3.1: your class got E3.1 from another version of tflab.")
    with pytest.raises(WorkbookError, match="asks about other values"):
        task("E3.1")
    assert (root / "progress.json").read_text() == tried
    assert "E3.4 ✓" in said(capsys, "E3.4", math.pi / 2)  # which asks the same


def test_a_class_copy_has_the_tasks_that_were_handed_out_and_draws_from_its_seed(tmp_path, monkeypatch, capsys):
    root = chapter.copy_of_workbook(tmp_path, monkeypatch, edition="class", seed="of the class")
    monkeypatch.chdir(root)
    of_the_class, right = right_corner(capsys)
    assert "E3.1 ✓" in said(capsys, "E3.1", right)
    questions = dict(read_workbook(root).questions)
    del questions["E3.4"]
    write_workbook(root, replace(read_workbook(root), questions=questions))
    assert "The tasks are E3.1, E3.2, E3.3." in said(capsys, "E3.4", math.pi / 2)
    write_workbook(root, Workbook())
    assert task("E3.1").base_T_laser != of_the_class.base_T_laser


LISTS = Parts({"a": Sequence(Choice(("map", "laser_frame")))})
PLANAR = Parts({"x": Number(), "yaw": Angle()})


@pytest.mark.parametrize(
    ("form", "right", "answer", "mistake", "detail"),
    [
        (LISTS, {"a": ["map", "laser_frame"]}, {"a": ["map", "laser"]}, "option", {"answer": "laser", "part": "a"}),
        (PLANAR, {"x": 1.0, "yaw": 0.5}, {"x": 1.0, "theta": 0.5}, "missing parts", {"parts": ["yaw"]}),
    ],
)
def test_a_name_that_is_no_option_or_no_part_is_said(form, right, answer, mistake, detail):
    task, variant = chapter.bare(form, Case(None, to_plain(right), {}))
    verdict = judge_outcomes(task, variant, [to_plain(answer)])
    assert verdict.failure == mistake and detail.items() <= verdict.detail.items()
    assert mistake == "option" or verdict.detail["tip"].en == 'Nobody asked for "theta"'


a_point = geometry_msgs.PointStamped()
a_point.header.frame_id, a_point.header.stamp = "laser_frame", Time(nanoseconds=2_500_000_000).to_msg()


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ({"x": -3.87, "kept": ["a", 1]}, '{"x": -3.870, "kept": ["a", 1]}'),
        (-1.03e-13, "0.000"),
        ([23.0005, 23.0], "[23.0005, 23.000]"),
        (Transform(), "translation (0.000, 0.000, 0.000), rotation xyzw (0.000, 0.000, 0.000, 1.000)"),
        ("two\nlines", "two …"),
        (a_point, 'PointStamped in "laser_frame" at 2.500000000 s'),
    ],
)
def test_a_value_is_shown_in_a_line(value, text):
    assert show_in_a_line(value) == text


def test_rows_of_numbers_stand_below_their_name_and_in_line():
    rows = [[20.0 + i, 20.1 + i] for i in range(6)]
    assert show({"scan": rows}).splitlines()[:2] == ["scan:", "    [20.000, 20.100]"]


def test_an_exception_that_is_asked_for_has_to_be_raised_and_the_right_one():
    case = Case([], {"raises": "LookupException", "text": ""}, {})
    task, variant = chapter.bare(Number("m", 0.01), case, is_function=True)

    def verdict(outcome):
        return judge_outcomes(task, variant, [outcome]).failure

    assert verdict(raised(LookupException("no such frame"))) is None
    assert verdict(to_plain(LookupException("no such frame"))) is Failure.NO_REFUSAL
    assert verdict(to_plain(None)) is Failure.NO_REFUSAL  # it was to raise: "need a return" would be no help
    assert verdict(raised(ValueError("no such frame"))) is Failure.OTHER_EXCEPTION
    assert verdict(raised(KeyError("no such frame"))) is Failure.RAISES
