"""A release hands out what it should, and keeps what it must."""

from __future__ import annotations

import json
import shutil
import stat
from dataclasses import replace
from pathlib import Path

import pytest

from tflab.grading import release as releasing
from tflab.grading.judging import pack as packing
from tflab.grading.judging.pack import (
    POOL,
    PackError,
    graded_cases,
    learners_seed,
    questions_asked,
    read_pack,
    variant_for,
)
from tflab.grading.submissions.roster import Learner
from tflab.workbook.answers.forms import Number
from tflab.workbook.paths import Workbook, read_workbook
from tflab.workbook.tasks import catalog
from tflab.workbook.tasks.generate_cases import task_cases

from . import tiny


def texts_below(folder: Path) -> str:
    return "\n".join(content.decode() for content in tiny.files_below(folder).values())


def asked_in(task: dict) -> set[str]:
    """Return the arguments of every case of a task, as texts."""
    return {json.dumps(case["args"]) for variant in task["variants"] for case in variant["cases"]}


def test_each_learner_has_a_stamped_copy_of_the_class_edition_in_their_language(course: tiny.Course) -> None:
    workbook = read_workbook(course.copy_of("s101"))
    assert (workbook.edition, workbook.language, workbook.learner) == ("class", "ko", "s101")
    assert (course.copy_of("s101") / "exercises" / "ko" / f"E{tiny.STEM}.ipynb").is_file()
    assert not (course.copy_of("s101") / "solutions").exists()
    made, copy = course.exercise("s102"), course.copy_of("s102")
    stamp = made["metadata"]["tflab"]
    assert (stamp["learner"], stamp["release"]) == ("s102", read_pack(course.pack).release)
    assert made["cells"] == tiny.exercise(course.workbook)["cells"]
    name = f"exercises/en/E{tiny.STEM}.ipynb"
    assert (copy / name).read_bytes() == tiny.files_below(copy)[f".tflab/pristine.zip/{name}"]


def test_a_stamp_bears_a_seal_that_holds_for_nobody_else_and_nothing_else(course: tiny.Course) -> None:
    pack = read_pack(course.pack)
    stamp = course.exercise("s102")["metadata"]["tflab"]
    assert pack.sealed_this(stamp)
    for name, other in (("learner", "s101"), ("chapter", "02_axes"), ("release", "0"), ("seal", ""), ("seal", "ü")):
        assert not pack.sealed_this(stamp | {name: other})
    assert not replace(pack, seed="00" * 32).sealed_this(stamp)


def test_nothing_that_is_given_away_holds_the_seed_or_a_hidden_case(course: tiny.Course) -> None:
    pack = read_pack(course.pack)
    given_away = texts_below(course.release / "learners")
    assert pack.seed not in given_away
    hidden = graded_cases(course.workbook, tiny.STEM, pack.seed)[0]["E3.2"]["variants"]
    cases = [case for variant in hidden for case in variant["cases"]]
    assert len(cases) >= 3 * 8
    for case in cases:
        assert str(case["args"][0]) not in given_away
        assert str(case["expected"]) not in given_away


def test_a_copy_names_what_its_own_variant_asks_on_which_its_learner_is_graded(course: tiny.Course) -> None:
    pack = read_pack(course.pack)
    for learner in ("s101", "s102"):
        workbook = read_workbook(course.copy_of(learner))
        assert workbook.seed == learners_seed(pack.seed) != pack.seed
        assert workbook.questions == {
            task: digests[variant_for(pack.roster, learner, task, len(digests))]
            for task, digests in pack.questions[tiny.STEM].items()
        }
        (variant,) = course.assigned(learner, "E3.1").variants
        graded = pack.for_learner(learner)[tiny.STEM]["tasks"]["E3.1"]
        assert graded["given"] == variant.given
        assert [case["expected"] for case in graded["cases"]] == [case.expected for case in variant.cases]


def test_learners_have_different_variants_and_classes_have_different_numbers(course: tiny.Course) -> None:
    def given(workbook: Workbook) -> float:
        return catalog.assigned_cases(course.workbook, tiny.STEM, "E3.1", workbook).variants[0].given["a"]

    assert len({given(Workbook(learner=f"s{number}", seed="ab" * 32)) for number in range(30)}) == 5
    assert len({given(Workbook(seed=seed)) for seed in ("ab" * 32, "cd" * 32, "")}) == 3


def test_the_seed_in_a_copy_does_not_give_the_hidden_cases(course: tiny.Course) -> None:
    """Whoever has a copy can do with its seed whatever tflab does with one."""
    seed = read_workbook(course.copy_of("s102")).seed
    hidden = asked_in(graded_cases(course.workbook, tiny.STEM, read_pack(course.pack).seed)[0]["E3.2"])
    task, solution = (
        catalog.tasks_of(course.workbook, tiny.STEM)["E3.2"],
        catalog.solution_of(course.workbook, tiny.STEM),
    )
    tried = asked_in(graded_cases(course.workbook, tiny.STEM, seed)[0]["E3.2"])
    for guess in (seed, bytes.fromhex(seed), learners_seed(seed), packing._derived(seed, "hidden")):
        tried |= asked_in(task_cases(task, guess, solution, fewest_inputs=POOL).plain())
    assert len(hidden) >= 3 * POOL and len(tried) > 4 * POOL
    assert not hidden & tried


def test_the_cases_depend_on_the_seed_alone(course: tiny.Course) -> None:
    one, same, other = (graded_cases(course.workbook, tiny.STEM, seed * 32) for seed in ("ab", "ab", "cd"))
    assert one == same
    assert one[0]["E3.1"] != other[0]["E3.1"] and one[0]["E3.2"] != other[0]["E3.2"]
    assert one[1]["E3.1"] != other[1]["E3.1"]
    assert one[1]["E3.3"] == other[1]["E3.3"]  # where nothing varies


def test_a_question_is_the_same_with_another_text_or_tolerance_and_another_with_other_points(
    course: tiny.Course,
) -> None:
    task = course.assigned("s102", "E3.1")
    (variant,) = task.variants
    asked = catalog.question_digest(task, variant)
    for same in (task._replace(hints=(), feedback={}), task._replace(form=Number(unit="m", tolerance=0.5))):
        assert catalog.question_digest(same, variant) == asked
    for other in (task._replace(points=3), task._replace(answer="sum"), task._replace(form=Number(unit="deg"))):
        assert catalog.question_digest(other, variant) != asked
    assert catalog.question_digest(task, variant._replace(given={"a": 1.0, "b": 7.0})) != asked


def test_without_a_roster_there_is_one_folder_for_all_and_no_seed_comes_twice(
    course: tiny.Course, tmp_path: Path
) -> None:
    pack, ours = releasing.release(tmp_path / "all", [tiny.STEM], None), read_pack(course.pack)
    assert pack.seed != ours.seed and pack.release != ours.release
    assert len(pack.seed) == 64
    assert [path.name for path in (tmp_path / "all" / "learners").iterdir()] == ["tflab_workbook"]
    one, other = (pack.for_learner(name)[tiny.STEM]["tasks"] for name in ("whoever", "whoever else"))
    assert {task: held["given"] for task, held in one.items()} == {task: held["given"] for task, held in other.items()}


def test_the_pack_is_its_owners_only(course: tiny.Course) -> None:
    assert stat.S_IMODE((course.pack / "pack.json").stat().st_mode) == 0o600
    assert stat.S_IMODE(course.pack.stat().st_mode) == 0o700


def test_a_release_is_not_overwritten(course: tiny.Course, tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    assert releasing.main([str(tmp_path / "r"), "--quiet"]) == 0
    before = texts_below(tmp_path / "r")
    assert releasing.main([str(tmp_path / "r"), "--quiet"]) == 2
    assert "nothing in it is changed" in capsys.readouterr().err
    assert texts_below(tmp_path / "r") == before


@pytest.mark.parametrize(("where", "words"), [("write_pack", []), ("_stamp_of", ["--add"])])
def test_what_was_interrupted_is_released_anew_or_finished_by_adding(
    course, tmp_path, monkeypatch, where: str, words: list[str]
) -> None:
    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    roster = tmp_path / "class.csv"
    roster.write_text("id\ns101\ns102\n")
    command = [str(tmp_path / "r"), "--roster", str(roster), "--quiet"]
    with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
        patch.setattr(releasing, where, stop)
        releasing.main(command)
    assert releasing.main([*command, *words]) == 0
    pack = read_pack(tmp_path / "r" / "instructor")
    assert pack.questions == questions_asked([tiny.STEM], pack.seed)
    for learner in ("s101", "s102"):
        assert tiny.exercise(tmp_path / "r" / "learners" / learner)["metadata"]["tflab"]["learner"] == learner


def test_learners_can_be_added_which_computes_nothing_and_changes_nobody_elses_cases(
    course: tiny.Course, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = releasing.release(tmp_path / "r", [tiny.STEM], [Learner("a")])
    before = first.for_learner("a")
    (tmp_path / "r" / "learners" / "a" / "exercises" / "en" / f"E{tiny.STEM}.ipynb").write_text("mine")

    def computed(*_: object, **__: object) -> None:
        raise AssertionError("a case was computed")

    with monkeypatch.context() as patch:
        patch.setattr(packing, "task_cases", computed)
        patch.setattr(catalog, "make_variant", computed)
        both = releasing.release(tmp_path / "r", [tiny.STEM], [Learner("b")], add=True)
    assert (both.seed, both.questions, sorted(both.roster)) == (first.seed, first.questions, ["a", "b"])
    assert both.for_learner("a") == before
    assert (tmp_path / "r" / "learners" / "a" / "exercises" / "en" / f"E{tiny.STEM}.ipynb").read_text() == "mine"
    assert tiny.exercise(tmp_path / "r" / "learners" / "b")["metadata"]["tflab"]["learner"] == "b"
    assert read_workbook(tmp_path / "r" / "learners" / "b").questions


def test_adding_learners_adds_no_chapter(course: tiny.Course, tmp_path: Path, monkeypatch, capsys) -> None:
    releasing.release(tmp_path / "r", [tiny.STEM], [Learner("a")])
    (tmp_path / "more.csv").write_text("id\nb\n")
    monkeypatch.setattr(releasing.paths, "chapters", lambda: [tiny.STEM, "09_later"])
    assert releasing.main([str(tmp_path / "r"), "--add", "--roster", str(tmp_path / "more.csv"), "--quiet"]) == 0
    assert f"for 2 learners: {tiny.STEM}\n" in capsys.readouterr().out
    assert read_pack(tmp_path / "r" / "instructor").chapters == [tiny.STEM]


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


def test_chapters_are_named_by_number_or_stem(course: tiny.Course, tmp_path: Path, capsys) -> None:
    for words in ("3", "03", tiny.STEM):
        assert releasing.main([str(tmp_path / words), "--chapters", words, "--quiet"]) == 0
    for words in ("4", "tiny"):
        assert releasing.main([str(tmp_path / words), "--chapters", words, "--quiet"]) == 2
        assert f"available: {tiny.STEM[:2]}" in capsys.readouterr().err


@pytest.mark.parametrize("text", ["", "{", "[]", '{"format": 99}', '{"format": 1}', '{"format": 1, "roster": 3}'])
def test_a_damaged_pack_is_one_line(tmp_path: Path, text: str) -> None:
    (tmp_path / "pack.json").write_text(text)
    with pytest.raises(PackError) as caught:
        read_pack(tmp_path)
    assert "\n" not in str(caught.value)


def test_a_pack_in_which_something_is_missing_or_of_another_type_is_damaged(
    course: tiny.Course, tmp_path: Path
) -> None:
    held = json.loads((course.pack / "pack.json").read_text(encoding="utf-8"))
    missing = [{name: held[name] for name in held if name != gone} for gone in MEMBERS]
    for damaged in [*missing, *(held | {"questions": questions} for questions in DAMAGED)]:
        pack = shutil.copytree(course.pack, tmp_path / "pack", dirs_exist_ok=True)
        (pack / "pack.json").write_text(json.dumps(damaged), encoding="utf-8")
        with pytest.raises(PackError, match="damaged"):
            read_pack(pack)


MEMBERS = ("release", "seed", "version", "language", "roster", "questions")
DAMAGED = (
    3, [], {"03_tiny": []}, {"03_tiny": {}}, {"03_tiny": {"E3.1": 3}}, {"03_tiny": {"E3.1": [3]}},
    {"03_tiny": {"E3.1": []}}, {"03_other": {"E3.1": ["a"]}},
)  # fmt: skip
