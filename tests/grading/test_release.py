"""Does a release give away what it should, and keep what it must?"""

from __future__ import annotations

import json
import shutil
import stat
from dataclasses import replace
from pathlib import Path

import pytest
import tiny

from tflab.grading import release as releasing
from tflab.grading.judging.pack import PackError, chapter_cases, learners_cases, read_pack
from tflab.grading.submissions.roster import Learner
from tflab.workbook.answers.sealed import is_sealed
from tflab.workbook.places import read_workbook


def texts_below(folder: Path) -> str:
    return "\n".join(path.read_text(encoding="utf-8") for path in sorted(folder.rglob("*")) if path.is_file())


def public_cases(course: tiny.Course, learner: str) -> dict:
    path = course.release / "learners" / learner / "exercises" / "cases" / f"{tiny.STEM}.json"
    return json.loads(path.read_text(encoding="utf-8"))["tasks"]


def test_each_learner_has_a_copy_of_the_class_edition_in_their_language(course: tiny.Course) -> None:
    workbook = read_workbook(course.release / "learners" / "s101")
    assert (workbook.edition, workbook.language, workbook.learner) == ("class", "ko", "s101")
    assert (course.release / "learners" / "s101" / "exercises" / "ko" / f"E{tiny.STEM}.ipynb").is_file()
    assert not (course.release / "learners" / "s101" / "solutions").exists()


def test_the_exercises_are_stamped_and_nothing_else_in_them_changes(course: tiny.Course) -> None:
    made, source = course.exercise("s102"), tiny.exercise(course.workbook)
    stamp = made["metadata"]["tflab"]
    assert stamp["learner"] == "s102"
    assert stamp["release"] == read_pack(course.pack).release
    assert made["cells"] == source["cells"]


def test_a_stamp_bears_a_seal_that_holds_for_nobody_else_and_nothing_else(course: tiny.Course) -> None:
    pack = read_pack(course.pack)
    stamp = course.exercise("s102")["metadata"]["tflab"]
    assert pack.sealed_this(stamp)
    for name, other in (("learner", "s101"), ("chapter", "02_axes"), ("release", "0"), ("seal", ""), ("seal", "ü")):
        assert not pack.sealed_this(stamp | {name: other})
    assert not replace(pack, seed="00" * 32).sealed_this(stamp)


def test_the_copy_as_it_was_handed_out_is_stamped_alike(course: tiny.Course) -> None:
    copy = course.release / "learners" / "s102"
    name = f"exercises/en/E{tiny.STEM}.ipynb"
    assert (copy / name).read_bytes() == (copy / ".tflab" / "pristine" / name).read_bytes()


def test_the_exercises_carry_what_nbgrader_reads(course: tiny.Course) -> None:
    cells = {cell["id"]: cell["metadata"].get("nbgrader") for cell in course.exercise()["cells"]}
    answer, check = cells["e3-2-answer"], cells["e3-2-check"]
    names = ("grade_id", "solution", "grade", "locked")
    assert [answer[name] for name in names] == ["e3-2-answer", True, False, False]
    assert [check[name] for name in names] == ["e3-2-check", False, True, True]
    assert check["points"] == 4


def test_nothing_that_is_given_away_holds_the_seed_or_a_hidden_case(course: tiny.Course) -> None:
    pack = read_pack(course.pack)
    given_away = texts_below(course.release / "learners")
    assert pack.seed not in given_away
    hidden = [case for variant in pack.cases[tiny.STEM]["tasks"]["E3.2"]["variants"] for case in variant["cases"]]
    assert len(hidden) >= 3 * 8
    for case in hidden:
        assert str(case["args"][0]) not in given_away
        assert str(case["expected"]) not in given_away


def test_the_values_that_are_asked_for_are_sealed_and_so_are_the_mistakes(course: tiny.Course) -> None:
    for task_id in ("E3.1", "E3.3"):
        (variant,) = public_cases(course, "s102")[task_id]["variants"]
        (case,) = variant["cases"]
        assert is_sealed(case["expected"])
        assert all(map(is_sealed, case["twins"].values()))


def test_a_learner_has_one_variant_and_is_graded_on_it(course: tiny.Course) -> None:
    pack = read_pack(course.pack)
    for learner in ("s101", "s102"):
        (variant,) = public_cases(course, learner)["E3.1"]["variants"]
        graded = pack.for_learner(learner)[tiny.STEM]["tasks"]["E3.1"]
        assert graded["given"] == variant["given"]
        assert not is_sealed(graded["cases"][0]["expected"])


def test_learners_have_different_variants() -> None:
    task = {"E3.1": {"is_function": True, "variants": [{"given": number, "cases": []} for number in range(5)]}}
    roster = {f"s{number}": Learner(f"s{number}") for number in range(30)}
    got = {
        learners_cases({"tasks": task}, roster, learner)["tasks"]["E3.1"]["variants"][0]["given"] for learner in roster
    }
    assert got == set(range(5))


def test_functions_are_asked_other_inputs_than_the_public_ones(course: tiny.Course) -> None:
    public = public_cases(course, "s102")["E3.2"]["variants"][0]["cases"]
    hidden = read_pack(course.pack).for_learner("s102")[tiny.STEM]["tasks"]["E3.2"]["cases"]
    assert not {json.dumps(case["args"]) for case in public} & {json.dumps(case["args"]) for case in hidden}


def test_the_cases_depend_on_the_seed_alone(course: tiny.Course) -> None:
    one, same, other = (
        chapter_cases(tiny.STEM, seed * 32, course.workbook / "solutions") for seed in ("ab", "ab", "cd")
    )
    assert one == same
    assert one[0] != other[0] and one[1] != other[1]
    assert one[0]["tasks"]["E3.2"] != one[1]["tasks"]["E3.2"]


def test_two_releases_have_nothing_in_common(course: tiny.Course, tmp_path: Path) -> None:
    other = releasing.release(tmp_path / "other", [tiny.STEM], None)
    ours = read_pack(course.pack)
    assert other.seed != ours.seed and other.release != ours.release
    assert len(other.seed) == 64


def test_the_pack_is_its_owners_only(course: tiny.Course) -> None:
    assert stat.S_IMODE((course.pack / "pack.json").stat().st_mode) == 0o600
    assert stat.S_IMODE(course.pack.stat().st_mode) == 0o700


def test_without_a_roster_there_is_one_folder_for_all(course: tiny.Course, tmp_path: Path) -> None:
    pack = releasing.release(tmp_path / "all", [tiny.STEM], None)
    assert [path.name for path in (tmp_path / "all" / "learners").iterdir()] == ["tflab_workbook"]
    one, other = (pack.for_learner(name)[tiny.STEM]["tasks"] for name in ("whoever", "whoever else"))
    assert {task: held["given"] for task, held in one.items()} == {task: held["given"] for task, held in other.items()}


def test_a_release_is_not_overwritten(course: tiny.Course, tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    assert releasing.main([str(tmp_path / "r"), "--quiet"]) == 0
    before = texts_below(tmp_path / "r")
    assert releasing.main([str(tmp_path / "r"), "--quiet"]) == 2
    assert "nothing in it is changed" in capsys.readouterr().err
    assert texts_below(tmp_path / "r") == before


def test_what_was_interrupted_before_the_pack_was_whole_is_released_anew(course, tmp_path, monkeypatch) -> None:
    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
        patch.setattr(releasing, "write_pack", stop)
        releasing.main([str(tmp_path / "r"), "--quiet"])
    assert releasing.main([str(tmp_path / "r"), "--quiet"]) == 0
    pack = read_pack(tmp_path / "r" / "instructor")
    assert pack.cases[tiny.STEM] == chapter_cases(tiny.STEM, pack.seed, course.workbook / "solutions")[1]


def test_what_was_interrupted_while_learners_got_theirs_is_finished_by_adding(course, tmp_path, monkeypatch) -> None:
    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    roster = tmp_path / "class.csv"
    roster.write_text("id\ns101\ns102\n")
    command = [str(tmp_path / "r"), "--roster", str(roster), "--quiet"]
    with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
        patch.setattr(releasing, "_stamp", stop)
        releasing.main(command)
    assert releasing.main([*command, "--add"]) == 0
    for learner in ("s101", "s102"):
        exercise = tmp_path / "r" / "learners" / learner / "exercises" / "en" / f"E{tiny.STEM}.ipynb"
        assert json.loads(exercise.read_text())["metadata"]["tflab"]["learner"] == learner


def test_learners_can_be_added_and_nobody_elses_cases_change(course: tiny.Course, tmp_path: Path) -> None:
    first = releasing.release(tmp_path / "r", [tiny.STEM], [Learner("a")])
    (tmp_path / "r" / "learners" / "a" / "exercises" / "en" / f"E{tiny.STEM}.ipynb").write_text("mine")
    both = releasing.release(tmp_path / "r", [tiny.STEM], [Learner("b")], add=True)
    assert both.seed == first.seed
    assert sorted(both.roster) == ["a", "b"]
    assert both.for_learner("a") == first.for_learner("a")
    assert (tmp_path / "r" / "learners" / "a" / "exercises" / "en" / f"E{tiny.STEM}.ipynb").read_text() == "mine"
    assert tiny.exercise(tmp_path / "r" / "learners" / "b")["metadata"]["tflab"]["learner"] == "b"


def test_adding_learners_adds_no_chapter(course: tiny.Course, tmp_path: Path, monkeypatch, capsys) -> None:
    releasing.release(tmp_path / "r", [tiny.STEM], [Learner("a")])
    (tmp_path / "more.csv").write_text("id\nb\n")
    monkeypatch.setattr(releasing.places, "chapters", lambda: [tiny.STEM, "09_later"])
    assert releasing.main([str(tmp_path / "r"), "--add", "--roster", str(tmp_path / "more.csv"), "--quiet"]) == 0
    assert f"for 2 learners: {tiny.STEM}\n" in capsys.readouterr().out
    assert list(read_pack(tmp_path / "r" / "instructor").cases) == [tiny.STEM]


def test_adding_to_nothing_is_one_line(tmp_path: Path) -> None:
    with pytest.raises(PackError, match="there is no pack"):
        releasing.release(tmp_path / "r", [tiny.STEM], None, add=True)


def test_wrong_rows_of_a_roster_are_said_and_the_rest_is_released(
    course: tiny.Course, tmp_path: Path, capsys: pytest.CaptureFixture
) -> None:
    (tmp_path / "r.csv").write_text("id,name\ns1,A\nb/d,B\n")
    assert releasing.main([str(tmp_path / "r"), "--roster", str(tmp_path / "r.csv"), "--quiet"]) == 1
    assert 'row 3: "b/d" cannot be an id' in capsys.readouterr().err
    assert [path.name for path in (tmp_path / "r" / "learners").iterdir()] == ["s1"]


@pytest.mark.parametrize("roster", ["", "id\n", "name\nA\n"])
def test_a_roster_of_nobody_releases_nothing(course: tiny.Course, tmp_path: Path, roster: str) -> None:
    (tmp_path / "r.csv").write_text(roster)
    assert releasing.main([str(tmp_path / "r"), "--roster", str(tmp_path / "r.csv"), "--quiet"]) == 2
    assert not (tmp_path / "r").exists()


@pytest.mark.parametrize(
    ("words", "found"), [("3", True), ("03", True), (tiny.STEM, True), ("4", False), ("tiny", False)]
)
def test_chapters_are_named_by_number_or_stem(
    course: tiny.Course, tmp_path: Path, words: str, found: bool, capsys: pytest.CaptureFixture
) -> None:
    assert releasing.main([str(tmp_path / "r"), "--chapters", words, "--quiet"]) == (0 if found else 2)
    assert found or f"there is {tiny.STEM}" in capsys.readouterr().err


@pytest.mark.parametrize("text", ["", "{", "[]", '{"format": 99}', '{"format": 1}', '{"format": 1, "roster": 3}'])
def test_a_damaged_pack_is_one_line(tmp_path: Path, text: str) -> None:
    (tmp_path / "pack.json").write_text(text)
    with pytest.raises(PackError) as caught:
        read_pack(tmp_path)
    assert "\n" not in str(caught.value)


def test_a_chapter_whose_tasks_have_changed_is_not_added_to(
    course: tiny.Course, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    workbook = tiny.write_tiny_workbook(tmp_path / "workbook")
    monkeypatch.setenv("TFLAB_WORKBOOK", str(workbook))
    releasing.release(tmp_path / "r", [tiny.STEM], [Learner("a")])
    tasks = workbook / "solutions" / "tasks" / tiny.STEM / "draws.py"
    tasks.write_text(tasks.read_text(encoding="utf-8").replace("uniform(1, 5)", "uniform(1, 4)"), encoding="utf-8")
    with pytest.raises(PackError, match="have changed"):
        releasing.release(tmp_path / "r", [tiny.STEM], [Learner("b")], add=True)


@pytest.mark.parametrize("gone", ["form", "twins", "variants", "answer", "points"])
def test_a_pack_in_which_something_is_missing_is_one_line(course: tiny.Course, tmp_path: Path, gone: str) -> None:
    pack = shutil.copytree(course.pack, tmp_path / "pack")
    path = pack / "cases" / f"{tiny.STEM}.json"
    cases = json.loads(path.read_text(encoding="utf-8"))
    for task in cases["tasks"].values():
        del task[gone]
    path.write_text(json.dumps(cases), encoding="utf-8")
    with pytest.raises(PackError, match="damaged"):
        read_pack(pack)


def test_a_chapter_without_teaching_files_is_released_without_a_guide(course: tiny.Course) -> None:
    assert not (course.release / "instructor" / "guide").exists()
