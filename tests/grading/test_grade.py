"""A class is graded correctly, from a folder of files to the pages that are read."""

from __future__ import annotations

import csv
import io
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Mapping
from pathlib import Path

import pytest

from tflab.grading import batch, grade
from tflab.grading.judging.job import Job
from tflab.grading.judging.pack import graded_cases, read_pack
from tflab.grading.kernels.sandbox import Sandbox
from tflab.grading.submissions.remarks import Remark

from . import tiny

ADDED = "def length(x, y):\n    return x + y"
HANG = "def length(x, y):\n    while True: pass"
HANG_ONCE = """
calls = []
def length(x, y):
    calls.append(x)
    while len(calls) == 4: pass
    return math.hypot(x, y)
"""


def graded(course: tiny.Course, submissions: Path, out: Path, *words: str) -> dict[str, dict]:
    """Grade, and return the records by learner."""
    code = grade.main([str(submissions), "--pack", str(course.pack), "--out", str(out), "--quiet", *words])
    assert code == 0
    held = json.loads((out / "results.json").read_text(encoding="utf-8"))
    return {record["learner"]: record for record in held["submissions"]}


def points(record: Mapping) -> dict[str, float]:
    return {task: row["points"] for task, row in record["chapters"][tiny.STEM]["tasks"].items()}


def remarks(record: Mapping) -> list[str]:
    chapters = [remark for chapter in record["chapters"].values() for remark in chapter["remarks"]]
    return [remark["kind"] for remark in (*record["remarks"], *chapters)]


def hand_in(course: tiny.Course, folder: Path, learner: str, answers: Mapping[str, str] = tiny.RIGHT) -> dict:
    notebook = tiny.answered(course.exercise(learner), answers)
    tiny.hand_in(folder, learner, notebook)
    return notebook


@pytest.fixture(scope="module")
def results(course: tiny.Course, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, dict]]:
    """s101 answered rightly; s102 made a mistake, left a task, and has cells and files that are odd."""
    folder = tmp_path_factory.mktemp("class")
    hand_in(course, folder / "in", "s101")
    notebook = hand_in(course, folder / "in", "s102", {"e3-2-answer": ADDED, "e3-1-answer": "total = 1 / 0"})
    notebook["cells"][tiny.index_of(notebook, "e3-1-given")]["source"] = "e3_1 = None"
    tiny.hand_in(folder / "in", "s102", notebook)
    tiny.hand_in(folder / "in", "s102", b"no notebook", "notes.ipynb")
    tiny.hand_in(folder / "in", "=cmd|'C calc'!A0", tiny.answered(tiny.exercise(course.workbook)), "03_<b>tiny.ipynb")
    return folder / "out", graded(course, folder / "in", folder / "out", "--feedback", "full")


def test_honest_work_gets_all_points_a_mistake_is_named_and_what_is_malformed_stops_nothing(
    results: tuple[Path, dict],
) -> None:
    records = results[1]
    assert records["s101"]["points"] == records["s101"]["most"] == 8.0
    tasks = records["s102"]["chapters"][tiny.STEM]["tasks"]
    assert (list(tasks["E3.2"]["mistakes"]), tasks["E3.2"]["points"]) == (["added"], 0.0)
    assert [remark["words"]["error"] for remark in tasks["E3.1"]["remarks"]] == ["ZeroDivisionError"]
    assert tasks["E3.3"]["status"] == "unanswered"
    assert "unreadable" in remarks(records["s102"])
    assert "nobody" in remarks(records["=cmd_'C calc'!A0"])


def test_the_table_has_a_row_for_each_learner_and_no_formula(results: tuple[Path, dict]) -> None:
    text = (results[0] / "grades.csv").read_text(encoding="utf-8-sig")
    rows = {row["learner"]: row for row in csv.DictReader(io.StringIO(text))}
    assert (rows["s101"]["name"], rows["s101"]["total"], rows["s101"]["E3.2"]) == ("Kim Minji", "8", "4")
    assert "'=cmd_'C calc'!A0" in rows
    cells = [cell for row in csv.reader(io.StringIO(text)) for cell in row]
    assert not [cell for cell in cells if cell[:1] in tuple("=+-@\t")]


def test_each_learner_has_a_page_in_their_language(results: tuple[Path, dict]) -> None:
    korean = (results[0] / "feedback" / "s101.html").read_text(encoding="utf-8")
    english = (results[0] / "feedback" / "s102.html").read_text(encoding="utf-8")
    assert '<html lang="ko">' in korean and "정답" in korean
    assert "You added the legs." in english
    assert "ZeroDivisionError" in english


def test_pages_hold_no_input_no_expected_value_no_reference_and_no_code(
    course: tiny.Course, results: tuple[Path, dict]
) -> None:
    pages = "".join(path.read_text(encoding="utf-8") for path in results[0].rglob("*.html"))
    assert "<b>tiny" not in pages and "<script" not in pages
    pages += (results[0] / "grades.csv").read_text(encoding="utf-8")
    cases, _ = graded_cases(course.workbook, tiny.STEM, read_pack(course.pack).seed)
    for task in ("E3.1", "E3.2"):
        for variant in cases[task]["variants"]:
            for case in variant["cases"]:
                assert str(case["expected"])[:8] not in pages
                assert all(str(arg)[:8] not in pages for arg in case["args"] or ())
    assert "hypot" not in pages


def test_the_class_page_says_the_same_in_pictures_and_in_words(results: tuple[Path, dict]) -> None:
    page = (results[0] / "class.html").read_text(encoding="utf-8")
    assert page.count('<img src="data:image/png;base64,') == 4
    assert page.count("<details>") == 4
    assert "E3.2 added (M1): 1" in page
    assert "http" not in page.replace("http-equiv", "")


@pytest.mark.parametrize(
    ("level", "seen", "unseen", "lms", "columns", "first"),
    [
        ("none", [], [], "canvas", ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "TF2"], "Ada Byron"),
        ("score", ["of 8 points"], ["added the legs"], "moodle", ["ID number", "Full name", "Grade"], "s102"),
        ("named", ["added the legs"], ["checks right"], "csv", ["learner", "name"], "s102"),
    ],
)
def test_the_instructor_decides_what_learners_and_the_learning_system_see(
    course: tiny.Course, tmp_path: Path, level: str, seen: list, unseen: list, lms: str, columns: list, first: str
) -> None:
    hand_in(course, tmp_path / "in", "s102", {**tiny.RIGHT, "e3-2-answer": ADDED})
    words = () if lms == "csv" else ("--lms", lms, "--assignment", "TF2")
    graded(course, tmp_path / "in", tmp_path / "out", "--feedback", level, *words)
    page = tmp_path / "out" / "feedback" / "s102.html"
    assert page.exists() == (level != "none")
    text = page.read_text(encoding="utf-8") if page.exists() else ""
    assert all(words in text for words in seen)
    assert not any(words in text for words in unseen)
    rows = list(csv.reader(io.StringIO((tmp_path / "out" / "grades.csv").read_text(encoding="utf-8-sig"))))
    assert (rows[0][: len(columns)], rows[-1][0]) == (columns, first)


def test_a_second_run_grades_only_what_changed(
    course: tiny.Course, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    done: list[str] = []
    really = batch.grade_job

    def counted(job: Job, sandbox: Sandbox) -> dict:
        done.append(job.learner)
        return really(job, sandbox=sandbox)

    monkeypatch.setattr(batch, "grade_job", counted)
    for learner in ("s101", "s102"):
        hand_in(course, tmp_path / "in", learner)
    first = graded(course, tmp_path / "in", tmp_path / "out")
    table = (tmp_path / "out" / "grades.csv").read_bytes()
    assert graded(course, tmp_path / "in", tmp_path / "out") == first
    assert sorted(done) == ["s101", "s102"]
    assert (tmp_path / "out" / "grades.csv").read_bytes() == table
    hand_in(course, tmp_path / "in", "s102", {"e3-3-answer": tiny.RIGHT["e3-3-answer"]})
    again = graded(course, tmp_path / "in", tmp_path / "out")
    assert sorted(done) == ["s101", "s102", "s102"]
    assert again["s102"]["points"] == 2.0
    assert len(list((tmp_path / "out" / "submissions").iterdir())) == 2


def test_what_does_not_end_is_tried_once_more_alone_and_costs_its_own_points(
    course: tiny.Course, tmp_path: Path
) -> None:
    hand_in(course, tmp_path / "in", "s101", {**tiny.RIGHT, "e3-2-answer": HANG})
    hand_in(course, tmp_path / "in", "s102", {**tiny.RIGHT, "e3-2-answer": HANG_ONCE})
    records = graded(course, tmp_path / "in", tmp_path / "out", "--seconds", "1")
    assert points(records["s101"]) == {"E3.1": 2.0, "E3.2": 0.0, "E3.3": 2.0}
    assert "E3.2" in records["s101"]["tried_alone"][tiny.STEM]
    got = points(records["s102"])
    assert got["E3.1"] == got["E3.3"] == 2.0
    assert 0.0 < got["E3.2"] < 4.0


def test_two_processes_give_what_one_process_gives(course: tiny.Course, tmp_path: Path) -> None:
    for learner in ("s101", "s102"):
        hand_in(course, tmp_path / "in", learner, {**tiny.RIGHT, "e3-2-answer": ADDED})
    graded(course, tmp_path / "in", tmp_path / "one")
    graded(course, tmp_path / "in", tmp_path / "two", "--jobs", "2")
    assert (tmp_path / "one" / "grades.csv").read_bytes() == (tmp_path / "two" / "grades.csv").read_bytes()


def test_ctrl_c_keeps_what_is_done_and_the_same_command_goes_on(course: tiny.Course, tmp_path: Path) -> None:
    hand_in(course, tmp_path / "in", "s101")
    hand_in(course, tmp_path / "in", "s102", {"e3-1-answer": "while True: pass"})
    command = [sys.executable, "-c", "import sys; from tflab.cli import main; sys.exit(main())", "grade"]
    process = subprocess.Popen(
        [*command, str(tmp_path / "in"), "--pack", str(course.pack), "--out", str(tmp_path / "out"), "--seconds", "60"],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env={**os.environ},
    )  # fmt: skip
    while process.poll() is None and not list((tmp_path / "out" / "submissions").glob("s101-*.json")):
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "the same command goes on from there" in said
    hand_in(course, tmp_path / "in", "s102")
    assert graded(course, tmp_path / "in", tmp_path / "out", "--seconds", "60")["s102"]["points"] == 8.0


def test_an_empty_folder_is_a_class_that_handed_in_nothing(course: tiny.Course, tmp_path: Path) -> None:
    (tmp_path / "in").mkdir()
    records = graded(course, tmp_path / "in", tmp_path / "out")
    assert [(record["points"], remarks(record)) for record in records.values()] == [(0.0, ["no file"])] * 2


def test_an_answer_in_the_way_of_the_others_and_a_notebook_saved_oddly_cost_no_honest_point(
    course: tiny.Course, tmp_path: Path
) -> None:
    patched = "import IPython.display\nIPython.display.display = lambda *_, **__: None\ntotal = None"
    hand_in(course, tmp_path / "in", "s101", {**tiny.RIGHT, "e3-1-answer": patched})
    hand_in(course, tmp_path / "in", "s102", {**tiny.RIGHT, "e3-1-answer": "math = 3\ntotal = None"})
    bare = tiny.answered(tiny.exercise(course.workbook))
    for number, cell in enumerate(bare["cells"]):  # an editor that knows neither ids nor metadata
        cell["metadata"], cell["id"] = {}, f"c{number}"
    tiny.hand_in(tmp_path / "in", "bare", bare)
    elsewhere = tiny.exercise(course.workbook)
    for name, where in (("e3-3-answer", "e3-3-check"), ("e3-2-answer", "e3-1-check"), ("e3-1-answer", "e3-1-given")):
        elsewhere["cells"].insert(tiny.index_of(elsewhere, where) + 1, tiny.own_cell(tiny.RIGHT[name], f"own-{name}"))
    tiny.hand_in(tmp_path / "in", "elsewhere", elsewhere)
    records = graded(course, tmp_path / "in", tmp_path / "out")
    for learner in ("s101", "s102"):
        assert points(records[learner]) == {"E3.1": 0.0, "E3.2": 4.0, "E3.3": 2.0}
        assert "apart" in remarks(records[learner])
    assert [records[learner]["points"] for learner in ("bare", "elsewhere")] == [8.0, 8.0]


@pytest.mark.parametrize(
    ("rule", "file", "points", "said"),
    [
        ("answers", "03_tiny_2.ipynb", 8.0, "the one with most answers, of these the later"),
        ("latest", "03_tiny_3.ipynb", 4.0, "the latest, by its name"),
        ("first", "03_tiny_1.ipynb", 4.0, "the first, by its name"),
    ],
)
def test_which_of_several_hand_ins_counts_is_the_instructors_to_say(
    course: tiny.Course, tmp_path: Path, rule: str, file: str, points: float, said: str
) -> None:
    short = {name: answer for name, answer in tiny.RIGHT.items() if name != "e3-2-answer"}
    attempts = [short, tiny.RIGHT, {**short, "e3-1-answer": "total = e3_1.a + e3_1.b  # again"}, {}]
    for number, answers in enumerate(attempts, 1):  # the fourth is as it was handed out
        tiny.hand_in(tmp_path / "in", "s102", tiny.answered(course.exercise(), answers), f"03_tiny_{number}.ipynb")
    record = graded(course, tmp_path / "in", tmp_path / "out", "--several", rule)["s102"]
    assert (record["points"], record["chapters"][tiny.STEM]["file"].rpartition("/")[2]) == (points, file)
    lines = [Remark.from_plain(remark).say("en") for remark in record["chapters"][tiny.STEM]["remarks"]]
    assert any(file in line and said in line for line in lines)


def test_what_cannot_be_graded_is_one_line(
    course: tiny.Course, tmp_path: Path, capsys: pytest.CaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("all.tar.gz", "03.py"):
        (tmp_path / name).write_bytes(b"x")
    pack = str(course.pack)
    for words, said in (
        ([tmp_path / "all.tar.gz", "--pack", pack], "tflab grade: no notebook was found, only all.tar.gz."),
        ([tmp_path / "03.py", "--pack", pack], "tflab grade: no notebook was found, only 03.py."),
        ([tmp_path / "nowhere", "--pack", pack], "there is no"),
        ([tmp_path, "--pack", tmp_path], "there is no pack in"),
        ([tmp_path, "--pack", pack, "--out", tmp_path], "would be taken for submissions"),
    ):
        words = ["--out", tmp_path / "out", *words]
        assert grade.main([str(word) for word in words]) == 2
        err = capsys.readouterr().err
        assert said in err and err.count("\n") == 1
    for words in (["--seconds", "0"], ["--seconds", "x"]):
        with pytest.raises(SystemExit):
            grade.main(["x", "--pack", "y", *words])
        assert " is no " in capsys.readouterr().err
    monkeypatch.setattr(sys, "platform", "win32")
    assert grade.main(["in", "--pack", "pack"]) == 2
    assert "Linux" in capsys.readouterr().err
