"""`tflab build` makes every edition from the sources, the same bytes each time, and says what is stale and why."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import nbformat
import pytest
from joblib import Parallel, delayed

from tflab.workbook.pages.build import build, build_pages, sources
from tflab.workbook.pages.exercise_rules import exercise_faults
from tflab.workbook.pages.source import read_page
from tflab.workbook.pages.stale import difference
from tflab.workbook.tasks.task import read_tasks

from .making_pages import HALF, LOAD, TASKS, THIRD, TITLE, code, exercise, text, written

pytestmark = pytest.mark.proof  # pages are executed: seconds each
LECTURE = (
    TITLE,
    text("note", "Wait for it.", "기다립니다.", ' slide="notes"'),
    text("term", "A [[frame]].", "[[frame]]입니다.", ' slide="slide"'),
    code("look", "print(6 * 7)\n'seen'"),
)


def bytes_below(root: Path) -> dict[str, bytes]:
    """Return what was built, by its path."""
    there = [*root.glob("*/*/*.ipynb"), *root.glob("*/*/*.json")]
    return {path.relative_to(root).as_posix(): path.read_bytes() for path in there}


def cells_of(root: Path, name: str) -> dict[str, dict]:
    return {cell["id"]: cell for cell in json.loads((root / name).read_text(encoding="utf-8"))["cells"]}


@pytest.fixture(scope="module")
def workbook(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A workbook of one chapter, built."""
    root = tmp_path_factory.mktemp("workbook")
    written(root, *LECTURE)
    exercise(root)
    assert build(["--root", str(root)]) == 0
    return root


def test_a_chapter_becomes_six_notebooks_and_no_cases(workbook: Path) -> None:
    names = ("notebooks/{}/03_x.ipynb", "solutions/{}/03_x.ipynb", "exercises/{}/E03_x.ipynb")
    built = bytes_below(workbook)
    assert set(built) == {name.format(language) for name in names for language in ("en", "ko")}
    assert [name for name, text in built.items() if b'"feedback"' in text or b"expected" in text] == []
    for name in built:
        nbformat.validate(nbformat.read(workbook / name, as_version=4))
    en, ko = (cells_of(workbook, f"notebooks/{language}/03_x.ipynb") for language in ("en", "ko"))
    assert list(en) == list(ko)
    assert en["look"] == ko["look"]
    assert en["look"]["execution_count"] == 2
    assert [output["output_type"] for output in en["look"]["outputs"]] == ["stream", "execute_result"]
    assert (en["title"]["source"], ko["title"]["source"]) == (["# A page"], ["# 한 쪽"])


def test_two_builds_are_the_same_bytes_and_nothing_is_stale(workbook: Path, capsys) -> None:
    before = bytes_below(workbook)
    again = build_pages(sources(workbook), jobs=1)
    assert {name: text.encode() for name, text in again.files.items()} == before
    assert build(["--root", str(workbook), "--check"]) == 0
    assert "nothing is stale" in capsys.readouterr().out
    assert Parallel(n_jobs=2)(delayed(abs)(number) for number in (-1, -2)) == [1, 2]  # in processes of its own


SPEAKS = "from tflab.workbook.paths import language_here\nprint({'en': 'Hello', 'ko': '안녕하십니까'}[language_here()])"


def test_what_is_printed_in_the_readers_language_is_tagged_and_stored_in_it(tmp_path: Path, capsys) -> None:
    hello, two = code("hello", SPEAKS, ' tags=["translated"]'), code("day", SPEAKS.replace("Hello", "Good day"))
    needless = code("look", "print(6 * 7)", ' tags=["translated"]')
    written(tmp_path, TITLE, hello, two, needless)
    assert build(["--root", str(tmp_path)]) == 1
    said = capsys.readouterr().err
    assert 'cell "day": prints in the reader\'s language' in said
    assert 'cell "look": prints the same in each language' in said
    assert bytes_below(tmp_path) == {}
    written(tmp_path, TITLE, hello, code("look", "print(6 * 7)"))
    assert build(["--root", str(tmp_path)]) == 0
    en, ko = (cells_of(tmp_path, f"notebooks/{language}/03_x.ipynb") for language in ("en", "ko"))
    assert (en["hello"]["outputs"][0]["text"], ko["hello"]["outputs"][0]["text"]) == (["Hello\n"], ["안녕하십니까\n"])
    assert en["look"] == ko["look"]


def test_notes_are_kept_with_the_cell_before_them_and_a_marked_term_is_explained(workbook: Path) -> None:
    page = cells_of(workbook, "notebooks/ko/03_x.ipynb")
    assert "note" not in page
    assert page["load"]["metadata"]["tflab"]["notes"] == "기다립니다."
    assert page["term"]["metadata"]["slideshow"] == {"slide_type": "slide"}
    assert "".join(cells_of(workbook, "notebooks/en/03_x.ipynb")["term"]["source"]).startswith('A <abbr title="')


def test_an_exercise_has_its_regions_taken_out_and_nothing_run(workbook: Path) -> None:
    page = cells_of(workbook, "exercises/en/E03_x.ipynb")
    assert "".join(page["e3-1-answer"]["source"]) == "half = ...  # [m]"
    assert "".join(page["e3-2-answer"]["source"]).endswith('    raise NotImplementedError("your turn")')
    code_cells = [cell for cell in page.values() if cell["cell_type"] == "code"]
    assert all(cell["outputs"] == [] and cell["execution_count"] is None for cell in code_cells)
    printed = cells_of(workbook, "solutions/en/03_x.ipynb")["e3-1-check"]["outputs"][0]["text"]
    assert "".join(printed) == "E3.1 ✓ 2/2 points\n"


def test_an_exercise_says_to_nbgrader_and_to_us_which_cells_are_a_task(workbook: Path) -> None:
    page = cells_of(workbook, "exercises/ko/E03_x.ipynb")
    answer, check = page["e3-1-answer"]["metadata"], page["e3-1-check"]["metadata"]
    assert answer["tflab"] == check["tflab"] == page["e3-1-given"]["metadata"]["tflab"] == {"task": "E3.1"}
    told = {"grade": False, "grade_id": "e3-1-answer", "locked": False, "schema_version": 3, "solution": True}
    assert answer["nbgrader"] == told | {"cell_type": "code", "task": False}
    assert (check["nbgrader"]["grade"], check["nbgrader"]["locked"], check["nbgrader"]["points"]) == (True, True, 2)
    assert "nbgrader" not in page["e3-1"]["metadata"]


def test_what_is_stale_is_said_with_the_cell_and_what_to_run(tmp_path: Path, workbook: Path, capsys) -> None:
    written(tmp_path, *LECTURE)
    for name, data in bytes_below(workbook).items():
        if name.startswith("notebooks"):
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_bytes(data.replace(b'"42\\n"', b'"43\\n"'))
    (tmp_path / "notebooks" / "en" / "04_old.ipynb").write_text("{}")
    (tmp_path / "notebooks" / "ko" / "03_x.ipynb").unlink()
    before = bytes_below(tmp_path)
    assert build(["--root", str(tmp_path), "--check"]) == 1
    said = capsys.readouterr().out.splitlines()
    assert said[0].startswith("notebooks/en/03_x.ipynb: cell \"look\": prints '43\\n' and would be '42\\n'")
    assert said[0].endswith("run: tflab build 03_x")
    assert said[1] == "notebooks/ko/03_x.ipynb: is not there; run: tflab build 03_x"
    assert said[2] == "notebooks/en/04_old.ipynb: has no source any more; delete it"
    assert bytes_below(tmp_path) == before


def test_a_page_with_a_fault_is_not_written_the_others_are(tmp_path: Path, capsys) -> None:
    written(tmp_path, TITLE, code("Look", "1 / 0"))
    written(tmp_path, TITLE, code("look", "1"), stem="04_y")
    assert build(["--root", str(tmp_path)]) == 1
    assert set(bytes_below(tmp_path)) == {"notebooks/en/04_y.ipynb", "notebooks/ko/04_y.ipynb"}
    said = capsys.readouterr().err
    assert 'notebooks/src/03_x.py:10: cell "Look": this is no name for a cell' in said
    assert 'notebooks/src/03_x.py:10: cell "Look": raised ZeroDivisionError: division by zero' in said
    assert build(["--root", str(tmp_path), "--draft", "03"]) == 1
    assert cells_of(tmp_path, "notebooks/en/03_x.ipynb")["Look"]["outputs"][0]["ename"] == "ZeroDivisionError"


def test_a_build_that_cannot_begin_says_why(workbook: Path, tmp_path: Path, monkeypatch, capsys) -> None:
    assert [path.parent.parent.name for path in sources(workbook, ["03"])] == ["notebooks", "solutions"]
    assert build(["--root", str(workbook), "99"]) == 2
    assert 'unknown page "99"; available: 03' in capsys.readouterr().err
    assert build(["--root", str(tmp_path)]) == 2
    assert "a wheel holds only what was built" in capsys.readouterr().err
    monkeypatch.setattr("tflab.workbook.pages.build.find_spec", lambda name: None)
    assert build(["--root", str(workbook)]) == 2
    assert "pip install 'tflab[dev]'" in capsys.readouterr().err


BROKEN = {
    "no text": (HALF.replace('name="e3-1"', 'name="half"'), "E3.1 has no text"),
    "a heading without the id": (HALF.replace("## E3.1 ·", "##"), "its heading does not name E3.1"),
    "no given": (HALF.replace("e3-1-given", "given"), "E3.1 has no given"),
    "a given of another task": (HALF.replace('task("E3.1")', 'task("E3.2")'), "it does not call for its task"),
    "no answer": (HALF.replace("e3-1-answer", "answer"), "E3.1 has no answer"),
    "an answer without its tag": (HALF.replace(' tags=["answer"]', ""), "it is not tagged"),
    "no region": (HALF.replace("# BEGIN SOLUTION\n", "").replace("# END SOLUTION", ""), "nothing is marked"),
    "a region without its end": (HALF.replace("# END SOLUTION", ""), 'has no "# END SOLUTION"'),
    "a region elsewhere": (HALF + code("x", "# BEGIN SOLUTION\nx = 1\n# END SOLUTION"), "in a cell that is no answer"),
    "no check": (HALF.replace("e3-1-check", "last"), "E3.1 has no check"),
    "a check with something else": (
        HALF.replace('check("E3.1", half)', 'check("E3.1", 1)'),
        "does not hold the check alone",
    ),
    "a task nobody knows": (HALF + code("more", 'task("E3.7")'), 'task names the task "E3.7"'),
    "a hint on the page": (HALF + code("more", 'hint("E3.1")'), "hint prints in one language"),
    "an answer of no task": (
        HALF + code("x", "# BEGIN SOLUTION\nx = 1\n# END SOLUTION", ' tags=["answer"]'),
        "no task",
    ),
    "the check first": (
        HALF.replace("e3-1-check", "e3-1-last").replace("e3-1-answer", "e3-1-check").replace("last", "answer"),
        "not in order",
    ),
}


@pytest.mark.parametrize("half, wrong", BROKEN.values(), ids=BROKEN.keys())
def test_a_fault_of_an_exercise_is_found_before_it_is_run(tmp_path: Path, half: str, wrong: str) -> None:

    page = read_page(exercise(tmp_path, TITLE, LOAD, half, THIRD))
    found = exercise_faults(page, read_tasks(tmp_path / "solutions" / "tasks" / "03_x"))
    assert any(wrong in str(fault) for fault in found), [str(fault) for fault in found]


IN_GIVEN = 'cell "e3-1-given": raised WorkbookError: this task cannot be checked: '
IN_CHECK = 'cell "e3-2-check": the solution does not pass: E3.2: this task cannot be checked: '


@pytest.mark.parametrize(
    "old, new, said",
    [
        ("length * 2", "length / 2", IN_GIVEN + 'E3.1, variant 0: the mistake "double" gives the right answer'),
        ("rng.uniform(1.0, 9.0))", "rng.nothing())", IN_GIVEN + "E3.1: AttributeError: 'Draws' object has no"),
        ("e3_1.length / 2", "e3_1.width / 2", IN_GIVEN + '03_x: the answer cell "e3-1-answer" fails: AttributeError'),
        ("rng.uniform(1.0, 9.0, 3)", "rng.nothing()", IN_CHECK + "E3.2: AttributeError: 'Draws' object has no"),
    ],
    ids=["a mistake that is right", "a generator", "an answer", "a function's generator"],
)
def test_what_fails_while_cases_are_computed_is_said_at_the_cell_that_asks_for_them(
    tmp_path: Path, capsys, old: str, new: str, said: str
) -> None:
    exercise(tmp_path, TITLE, LOAD, HALF.replace(old, new), THIRD, tasks=TASKS.replace(old, new))
    assert build(["--root", str(tmp_path)]) == 1
    assert said in capsys.readouterr().err
    assert bytes_below(tmp_path) == {}


def test_a_solution_that_its_own_check_refuses_is_a_fault(tmp_path: Path, capsys) -> None:
    wrong = HALF.replace("half = e3_1.length / 2", "half = float(len(globals()) > 20) + e3_1.length / 2")
    exercise(tmp_path, TITLE, LOAD, wrong, THIRD)  # where cases are made there are few names, in a kernel many
    assert build(["--root", str(tmp_path)]) == 1
    assert 'cell "e3-1-check": the solution does not pass: E3.1 ✗' in capsys.readouterr().err


def test_an_exercise_that_stops_or_passes_untouched_is_a_fault(tmp_path: Path, capsys) -> None:
    stops = THIRD.replace("# END SOLUTION", "# END SOLUTION\n\n\nthird(3.0)")
    passes = HALF.replace("# BEGIN", "half = e3_1.length / 2\n# BEGIN").replace(
        "half = e3_1.length / 2  # [m]", "x = 1"
    )
    exercise(tmp_path, TITLE, LOAD, passes, stops)
    assert build(["--root", str(tmp_path)]) == 1
    said = capsys.readouterr().err
    assert 'cell "e3-1-check": untouched, the exercise passes' in said
    assert 'cell "e3-2-answer": untouched, the exercise raises NotImplementedError: your turn' in said
    shutil.rmtree(tmp_path / "solutions" / "tasks" / "03_x")
    assert build(["--root", str(tmp_path)]) == 1
    assert "there are no tasks in" in capsys.readouterr().err


@pytest.mark.parametrize(
    "there, new, said",
    [
        ('{"cells": [], "metadata": {}}', '{"cells": [{"id": "a"}], "metadata": {}}', 'cell "a" is missing'),
        ('{"cells": [{"id": "a"}]}', '{"cells": []}', 'cell "a" is no longer in the source'),
        ('{"cells": [{"id": "a"}, {"id": "b"}]}', '{"cells": [{"id": "b"}, {"id": "a"}]}', "in another order"),
        ('{"tasks": {"E3.1": {"points": 1}}}', '{"tasks": {"E3.1": {"points": 2}}}', "tasks.E3.1.points is 1"),
        ('{"cells": [], "metadata": {"x": 1}}', '{"cells": [], "metadata": {"x": 2}}', "metadata.x is 1"),
        (
            json.dumps({"cells": [{"id": "a", "source": ["x" * 99 + "1"]}]}),
            json.dumps({"cells": [{"id": "a", "source": ["x" * 99 + "2"]}]}),
            "xxx1' and would be '...xxx",
        ),
        ("<<<<", '{"cells": []}', "cannot be read"),
        ('{"a":1}', '{"a": 1}', "written in another way"),
    ],
)
def test_where_two_files_part_is_said(there: str, new: str, said: str) -> None:
    assert said in difference(there, new)


@pytest.mark.skipif(os.name == "nt", reason="Windows has no SIGINT to send to one process")
@pytest.mark.parametrize("command", ["build --root {root}", "build --html {page} --out {out}"])
def test_ctrl_c_ends_the_kernels_and_leaves_no_half_of_a_file(command: str, tmp_path: Path) -> None:
    mark = tmp_path / "running"
    wait = f"import os, time\nopen({str(mark)!r}, 'w').write(str(os.getpid()))\ntime.sleep(100)"
    written(tmp_path, TITLE, code("waits", wait))
    page, out = tmp_path / "page.ipynb", tmp_path / "out" / "out"
    page.write_text(json.dumps({"cells": [cell_of(wait)], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}))
    tflab = [sys.executable, "-c", "import sys, tflab.cli; sys.exit(tflab.cli.main(sys.argv[1:]))"]
    words = command.format(root=tmp_path, page=page, out=out).split()
    process = subprocess.Popen([*tflab, *words], stderr=subprocess.PIPE)
    while not (mark.exists() and mark.read_text()):
        assert process.poll() is None, process.communicate()
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=30) == 130
    with pytest.raises(ProcessLookupError):
        os.kill(int(mark.read_text()), 0)
    assert bytes_below(tmp_path) == {}
    assert not out.exists()


def cell_of(source: str) -> dict:
    return {"cell_type": "code", "id": "a", "metadata": {}, "execution_count": None, "outputs": [], "source": source}
