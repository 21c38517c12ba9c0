"""A learner's copy is laid out once, and an update never overwrites what was written."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest

from tflab.workbook.copy.lay_out import PRISTINE, Change, lay_out, read_pristine, update
from tflab.workbook.paths import Workbook, WorkbookError, read_workbook, workbook_data, workbook_root

from .conftest import HandedOut

PAGE, START = "exercises/en/E03_small.ipynb", "notebooks/en/00_start.ipynb"


@pytest.fixture
def copy(handed_out: HandedOut, tmp_path: Path) -> Path:
    return lay_out(tmp_path / "copy", "en")


def cells(path: Path) -> dict[str, str]:
    return {cell["id"]: "".join(cell["source"]) for cell in json.loads(path.read_text())["cells"]}


def write_into(path: Path, name: str, source: str) -> None:
    page = json.loads(path.read_text())
    next(cell for cell in page["cells"] if cell["id"] == name)["source"] = source
    path.write_text(json.dumps(page))


def test_a_copy_knows_its_edition_language_and_learner(handed_out: HandedOut, tmp_path: Path) -> None:
    copy = lay_out(
        tmp_path / "copy", "ko", edition="class", learner="s17", seed="ours", questions={"E3.1": "a"}, handed_out={}
    )
    assert read_workbook(copy) == Workbook(
        edition="class", language="ko", learner="s17", seed="ours", questions={"E3.1": "a"}
    )
    assert workbook_root(copy / "notebooks" / "ko") == copy
    assert workbook_root(tmp_path) == workbook_data() == handed_out.root


def test_a_class_copy_has_the_exercises_that_were_handed_out_and_no_others(
    handed_out: HandedOut, tmp_path: Path
) -> None:
    handed_out.write("exercises/en/E09_other.ipynb", title="# E9")
    copy = lay_out(tmp_path / "copy", "en", edition="class", handed_out={PAGE: b"stamped"})
    assert [path.name for path in (copy / "exercises/en").iterdir()] == ["E03_small.ipynb"]
    assert (copy / PAGE).read_bytes() == b"stamped" == read_pristine(copy)[PAGE]
    assert not (copy / "solutions").exists()


@pytest.mark.parametrize("language", ["en", "ko"])
def test_a_copy_holds_pages_and_exercises_and_no_cases(language: str, tmp_path: Path) -> None:
    copy = lay_out(tmp_path / "copy", language)
    files = [path.relative_to(copy) for path in copy.rglob("*") if path.is_file()]
    pages = {path for path in files if path.suffix == ".ipynb"}
    assert set(files) - pages == {Path("workbook.json"), Path(".tflab/lock"), PRISTINE}
    assert {path.parts[:2] for path in pages} == {("notebooks", language), ("exercises", language)}
    for path in pages:
        assert not re.search(r'"(feedback|expected|variants)\\?":', (copy / path).read_text(encoding="utf-8")), path
    assert sum((copy / path).stat().st_size for path in files) < 5_000_000
    assert not (copy / "solutions").exists()


def test_the_same_files_are_kept_as_the_same_bytes(handed_out: HandedOut, tmp_path: Path) -> None:
    one, other = (lay_out(tmp_path / name, "en") for name in ("one", "other"))
    assert (one / PRISTINE).read_bytes() == (other / PRISTINE).read_bytes()
    assert read_pristine(one) == {name: (handed_out.root / name).read_bytes() for name in (PAGE, START)}


def test_what_was_deleted_comes_back_and_what_was_written_stays(handed_out: HandedOut, copy: Path) -> None:
    (copy / "notebooks/en/00_start.ipynb").unlink()
    (copy / PAGE).write_text("mine")
    lay_out(copy, "en")
    assert (copy / "notebooks/en/00_start.ipynb").exists()
    assert (copy / PAGE).read_text() == "mine"


def test_a_folder_with_something_else_in_it_is_refused(handed_out: HandedOut, tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "letter.txt").write_text("dear")
    with pytest.raises(WorkbookError, match="not a copy of the workbook, and nothing was written"):
        lay_out(tmp_path / "mine", "en")
    (tmp_path / "hidden").mkdir()
    (tmp_path / "hidden" / ".DS_Store").write_text("")
    assert lay_out(tmp_path / "hidden", "en").is_dir()


@pytest.mark.parametrize("text", ["", "[]", '{"tflab":"1","edition":"x","language":"en","learner":null}'])
def test_a_workbook_json_that_is_broken_is_said_and_kept(text: str, handed_out: HandedOut, copy: Path) -> None:
    (copy / "workbook.json").write_text(text)
    for attempt in (lambda: read_workbook(copy), lambda: update(copy), lambda: lay_out(copy, "ko")):
        with pytest.raises(WorkbookError, match="Nothing was changed"):
            attempt()
    assert (copy / "workbook.json").read_text() == text


def test_an_answer_stays_where_the_page_around_it_is_new(handed_out: HandedOut, copy: Path) -> None:
    write_into(copy / PAGE, "answer", "x = 42")
    handed_out.write(PAGE, title="# E3, better", answer="x = ...", more="print(x)", check="check('E3.1', x)")
    assert update(copy) == [Change(PAGE, "merged", kept=1)]
    assert cells(copy / PAGE) == {
        "title": "# E3, better",
        "answer": "x = 42",
        "more": "print(x)",
        "check": "check('E3.1', x)",
    }
    assert cells(copy / ".tflab/backups/1" / PAGE)["title"] == "# E3"


def test_a_cell_that_both_changed_stays_and_has_the_new_one_beside_it_once(handed_out: HandedOut, copy: Path) -> None:
    write_into(copy / PAGE, "answer", "x = 42")
    handed_out.write(PAGE, title="# E3", answer="y = ...", check="check('E3.1', y)")
    assert update(copy) == [Change(PAGE, "merged", kept=1, beside=1)]
    now = list(cells(copy / PAGE).items())
    assert now[1] == ("answer", "x = 42")
    assert now[2][1].endswith("```python\ny = ...\n```")
    assert update(copy) == []
    assert list(cells(copy / PAGE).items()) == now


def test_cells_of_ones_own_stay_behind_the_cell_that_they_stood_behind(handed_out: HandedOut, copy: Path) -> None:
    page = json.loads((copy / PAGE).read_text())
    for place, name in ((2, "own-2"), (2, "own-1"), (0, "own-0")):
        page["cells"].insert(place, {"cell_type": "code", "id": name, "metadata": {}, "source": name, "outputs": []})
    (copy / PAGE).write_text(json.dumps(page))
    handed_out.write(PAGE, first="# first", title="# E3, better", answer="x = ...", check="check('E3.1', x)")
    update(copy)
    assert list(cells(copy / PAGE)) == ["own-0", "first", "title", "answer", "own-1", "own-2", "check"]


def test_a_cell_that_is_no_longer_part_goes_unless_it_was_written_in(handed_out: HandedOut, copy: Path) -> None:
    write_into(copy / PAGE, "check", "check('E3.1', x)  # mine")
    handed_out.write(PAGE, answer="x = ...")
    update(copy)
    assert cells(copy / PAGE) == {"answer": "x = ...", "check": "check('E3.1', x)  # mine"}


def test_outputs_stay_where_a_cell_is_the_same_and_two_cells_with_one_id_are_both_kept(
    handed_out: HandedOut, copy: Path
) -> None:
    page = json.loads((copy / PAGE).read_text())
    page["cells"][2]["outputs"] = [{"output_type": "stream", "name": "stdout", "text": "E3.1 ✓ 6/6\n"}]
    (copy / PAGE).write_text(json.dumps(page))
    handed_out.write(PAGE, title="# E3, better", answer="x = ...", check="check('E3.1', x)")
    assert update(copy) == [Change(PAGE, "replaced")]
    assert "E3.1 ✓ 6/6" in (copy / PAGE).read_text()
    page["cells"].insert(2, {**page["cells"][1], "source": "x = 'the copy'"})
    (copy / PAGE).write_text(json.dumps(page))
    handed_out.write(PAGE, title="# E3, best", answer="x = ...", check="check('E3.1', x)")
    update(copy)
    assert "x = 'the copy'" in cells(copy / PAGE).values()


SAID = {"output_type": "stream", "name": "stdout", "text": "hello\n"}


def ask_to_predict(handed_out: HandedOut, name: str, **sources: str) -> None:
    """Write a page that has been run, and whose cell `name` a text asks to predict."""
    handed_out.write(START, **sources)
    page = json.loads((handed_out.root / START).read_text())
    for cell in page["cells"]:
        if cell["cell_type"] == "code":
            cell |= {"execution_count": 3, "outputs": [SAID]}
        if cell["id"] in (name, f"{name}-told"):
            cell["metadata"]["tags"] = ["predicted", "raises-exception"]
    (handed_out.root / START).write_text(json.dumps(page))


def outputs(path: Path) -> dict[str, list]:
    return {cell["id"]: cell.get("outputs", []) for cell in json.loads(path.read_text())["cells"]}


def test_what_a_text_asks_to_predict_is_not_there_before_it_is_run(handed_out: HandedOut, tmp_path: Path) -> None:
    ask_to_predict(handed_out, "guess", title="# Start", hello="print('hello')", guess="print('hello')")
    copy = lay_out(tmp_path / "copy", "en")
    assert outputs(copy / START) == {"title": [], "hello": [SAID], "guess": []}
    assert outputs(handed_out.root / START)["guess"] == [SAID]
    guess = json.loads((copy / START).read_text())["cells"][2]
    assert (guess["execution_count"], guess["metadata"]["tags"]) == (None, ["predicted", "raises-exception"])
    assert update(copy) == []


def test_a_text_that_tells_what_was_to_be_predicted_is_folded_under_its_heading(
    handed_out: HandedOut, tmp_path: Path
) -> None:
    ask_to_predict(handed_out, "guess", guess="print('hello')", guess_told="## So it is\n\nIt says hello.\n\nTwice.")
    copy = lay_out(tmp_path / "copy", "en")
    summary = "<details><summary>Run it first, then open this</summary>"
    told = f"## So it is\n\n{summary}\n\nIt says hello.\n\nTwice.\n\n</details>"
    assert cells(copy / START)["guess-told"] == told
    ask_to_predict(handed_out, "guess", guess="print('hello')", guess_told="## So it is\n\nIt says it.")
    assert update(copy) == [Change(START, "replaced")]
    assert "\n\nIt says it.\n\n</details>" in cells(copy / START)["guess-told"]


def test_what_is_folded_holds_no_fold_and_no_caption_of_a_figure(handed_out: HandedOut, tmp_path: Path) -> None:
    own = "<details><summary>I said 2</summary>\n\nNo.\n\n</details>"
    for told, laid_out in (
        (f"{own}\n{own}", f"{own}\n\n{own}"),
        (f"Three.\n\n{own}", f"{{0}}\n\nThree.\n\n</details>\n\n{own}"),
        ("*그림 읽기:* same = 같음.\n셋입니다.", "*그림 읽기:* same = 같음.\n\n{0}\n\n셋입니다.\n\n</details>"),
        ("*그림 읽기:* ball = 공.", "*그림 읽기:* ball = 공."),
    ):
        ask_to_predict(handed_out, "guess", guess="print('hello')", guess_told=f"## So?\n\n{told}")
        copy = lay_out(tmp_path / str(len(told)), "en")
        summary = "<details><summary>Run it first, then open this</summary>"
        assert cells(copy / START)["guess-told"] == "## So?\n\n" + laid_out.replace("{0}", summary)


def test_a_prediction_that_was_run_keeps_its_output_where_the_page_around_it_is_new(
    handed_out: HandedOut, tmp_path: Path
) -> None:
    ask_to_predict(handed_out, "guess", title="# Start", guess="print('hello')", other="print('hello')")
    copy = lay_out(tmp_path / "copy", "en")
    page = json.loads((copy / START).read_text())
    page["cells"][1] |= {"execution_count": 1, "outputs": [{**SAID, "text": "mine\n"}]}
    page["cells"][2]["source"] = "print('changed')"
    (copy / START).write_text(json.dumps(page))
    ask_to_predict(handed_out, "guess", title="# Start, better", guess="print('hello')", other="print('hello')")
    assert update(copy) == [Change(START, "merged", kept=1)]
    assert outputs(copy / START)["guess"] == [{**SAID, "text": "mine\n"}]
    ask_to_predict(handed_out, "guess", title="# Start, better", guess="print('new')", other="print('hello')")
    update(copy)
    assert outputs(copy / START)["guess"] == []  # another question, to be predicted again


def test_an_older_copy_loses_the_outputs_that_gave_predictions_away_unless_they_are_the_learners(
    handed_out: HandedOut, tmp_path: Path
) -> None:
    sources = {"title": "# Start", "guess": "print('hello')", "run": "print('hello')"}
    ask_to_predict(handed_out, "none", **sources)
    copy = lay_out(tmp_path / "copy", "en")
    page = json.loads((copy / START).read_text())
    page["cells"][2]["outputs"] = [{**SAID, "text": "mine\n"}]
    (copy / START).write_text(json.dumps(page))
    ask_to_predict(handed_out, "guess", **sources)
    update(copy)
    assert outputs(copy / START) == {"title": [], "guess": [], "run": [SAID]}


def test_a_page_that_is_no_notebook_any_more_stays_and_the_new_one_is_put_beside(
    handed_out: HandedOut, copy: Path
) -> None:
    (copy / PAGE).write_text("half a noteb")
    handed_out.write(PAGE, title="# E3, better")
    assert update(copy) == [Change(PAGE, "kept")]
    assert (copy / PAGE).read_text() == "half a noteb"
    assert len(list((copy / PAGE).parent.glob("E03_small.new-*.ipynb"))) == 1


def test_without_the_pages_as_they_were_handed_out_answers_stay(handed_out: HandedOut, copy: Path) -> None:
    write_into(copy / PAGE, "answer", "x = 42")
    shutil.rmtree(copy / ".tflab")
    handed_out.write(PAGE, title="# E3, better", answer="x = ...", check="check('E3.1', x)")
    update(copy)
    assert cells(copy / PAGE)["answer"] == "x = 42"


def test_what_an_instructor_handed_out_is_not_updated(handed_out: HandedOut, tmp_path: Path) -> None:
    given = {PAGE: (handed_out.root / PAGE).read_bytes()}
    copy = lay_out(tmp_path / "copy", "en", edition="class", handed_out=given)
    handed_out.write(PAGE, title="# E3, better")
    handed_out.write("notebooks/en/00_start.ipynb", title="# Start, better")
    assert [change.path for change in update(copy)] == ["notebooks/en/00_start.ipynb"]
    assert cells(copy / PAGE)["title"] == "# E3"
