"""Cases: what is given, expected, and what each mistake would give."""

from __future__ import annotations

import json
import random
import sys

import pytest

from tflab.core import Transform
from tflab.ros import activation
from tflab.workbook.answers.values import from_plain
from tflab.workbook.copy.lay_out import cases_bytes
from tflab.workbook.places import CASES, workbook_data
from tflab.workbook.tasks import cases
from tflab.workbook.tasks.cases import read_chapter, read_outline
from tflab.workbook.tasks.task import TaskError, variant_of

from . import small_chapter as chapter


def make(tmp_path, seed="public", **changes):
    options = {name: changes.pop(name) for name in ("variants", "fewest_inputs") if name in changes}
    return cases.make_cases(chapter.STEM, seed, solutions=chapter.lay_out(tmp_path, **changes), **options)


def test_the_expected_value_is_what_the_solutions_cell_gives(tmp_path):
    for variant in make(tmp_path).tasks["E3.1"].variants:
        given = {name: from_plain(value) for name, value in variant.given.items()}
        right = given["base_T_laser"].apply(given["laser_p_corner"])
        assert from_plain(variant.cases[0].expected) == pytest.approx(right)


def test_one_seed_makes_one_text_and_another_makes_others(tmp_path):
    text = cases.cases_json(make(tmp_path))
    assert text == cases.cases_json(make(tmp_path))
    assert text != cases.cases_json(make(tmp_path, seed="another"))
    assert json.loads(text)["chapter"] == chapter.STEM


def test_a_dict_among_the_arguments_keeps_its_order(tmp_path):
    made = make(tmp_path)
    task = made.tasks["E3.1"]
    case = task.variants[0].cases[0]._replace(args=[{"dict": {"b": 1, "a": 2}}])
    variant = task.variants[0]._replace(cases=(case,))
    text = cases.cases_json(made._replace(tasks={"E3.1": task._replace(variants=(variant,))}))
    read = json.loads(text)["tasks"]["E3.1"]["variants"][0]["cases"][0]
    assert list(from_plain(read["args"][0])) == ["b", "a"]


def test_cases_are_read_back_and_damage_is_named(tmp_path):
    made = make(tmp_path)
    path = tmp_path / "cases.json"
    path.write_text(cases.cases_json(made), encoding="utf-8")
    assert cases.read_chapter(path) == made
    for text in ("{", "[]", '{"format": 99}'):
        path.write_text(text, encoding="utf-8")
        with pytest.raises(cases.CasesError, match=r"cases\.json"):
            cases.read_cases(path)


def test_arguments_come_in_the_order_meant_after_writing_and_handing_out(tmp_path):
    # a file in which `/**` stands last: who lets the last line win is wrong only there
    plain = make(tmp_path).plain()
    case = plain["tasks"]["E3.2"]["variants"][0]["cases"][0]
    case["args"] = [{"dict": {"/mapper": {"dict": {"b": 1, "a": 2}}, "/**": {"dict": {}}}}]
    again = json.loads(cases.cases_json(plain))
    for handed in (again, json.loads(cases_bytes(again))):
        (params,) = handed["tasks"]["E3.2"]["variants"][0]["cases"][0]["args"]
        assert [*params["dict"]] == ["/mapper", "/**"] and [*params["dict"]["/mapper"]["dict"]] == ["b", "a"]


def test_a_function_has_at_least_as_many_inputs_as_asked_for(tmp_path):
    made = make(tmp_path, fewest_inputs=10, variants=1).tasks
    assert len(made["E3.2"].variants[0].cases) >= 10
    assert len(made["E3.1"].variants) == 1


def test_a_twin_that_is_right_is_no_twin(tmp_path):
    tasks = chapter.TASKS.replace("base_T_laser.inverse()", "base_T_laser")
    with pytest.raises(cases.CasesError, match=r'E3\.1, variant 0: the twin "swapped" is the right answer'):
        make(tmp_path, tasks=tasks)


def test_two_twins_that_look_alike_are_refused(tmp_path):
    one = 'Twin("swapped", {"target": "laser", "source": "map"}, both("turned round"), "M1", partly=True)'
    tasks = chapter.TASKS.replace(one, f"{one}, {one.replace('swapped', 'again')}")
    with pytest.raises(cases.CasesError, match=r'E3\.3.*"swapped" and "again" coincide'):
        make(tmp_path, tasks=tasks)


def test_numbers_with_which_two_mistakes_meet_are_drawn_anew(tmp_path, monkeypatch):
    usual, refused = cases._refuse_look_alikes, []

    def refuse_the_first(task, variant, made):
        if (task.id, variant) == ("E3.1", 0) and not refused:
            refused.append(made)
            raise cases.LookAlikes("these two meet")
        usual(task, variant, made)

    drawn_once = make(tmp_path).tasks
    monkeypatch.setattr(cases, "_refuse_look_alikes", refuse_the_first)
    drawn_anew = make(tmp_path).tasks
    assert refused[0][0].expected == drawn_once["E3.1"].variants[0].cases[0].expected
    assert drawn_anew["E3.1"].variants[0] != drawn_once["E3.1"].variants[0]
    assert drawn_anew["E3.1"].variants[1:] == drawn_once["E3.1"].variants[1:]
    assert drawn_anew["E3.2"] == drawn_once["E3.2"]


def test_no_seed_is_refused_because_its_first_draws_meet(tmp_path, monkeypatch):
    usual, dice = cases._refuse_look_alikes, random.Random(0)

    def refuse_half(task, variant, made):
        if dice.random() < 0.5:
            raise cases.LookAlikes("these two meet")
        usual(task, variant, made)

    monkeypatch.setattr(cases, "_refuse_look_alikes", refuse_half)
    source = chapter.lay_out(tmp_path)
    for number in range(30):
        assert cases.make_cases(chapter.STEM, f"seed {number}", solutions=source).tasks


def test_a_solution_that_is_not_of_its_form_is_refused(tmp_path):
    with pytest.raises(cases.CasesError, match=r"E3\.4: the solution's answer is not one number"):
        make(tmp_path, cells=chapter.CELLS | {"e3-4-answer": "angle_rad = '90 degrees'"})


@pytest.mark.parametrize(
    ("cell", "says"),
    [("x = 1", "does not define angle_rad"), ("angle_rad = ...", "does not define"), ("1 / 0", "ZeroDivisionError")],
)
def test_a_solution_that_does_not_answer_is_named(tmp_path, cell, says):
    with pytest.raises(TaskError, match=rf"e3-4-answer.*{says}"):
        make(tmp_path, cells=chapter.CELLS | {"e3-4-answer": cell})


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('"E3.4"', '"E4.4"', "should be called e4_4.py"),
        ('"E3.4"', '"E3.3"', "should be called e3_3.py"),
        ('"E3.4"', '"3.4"', "no task id"),
        ('"E3.4", "N"', '"E3.4", "Q"', "no kind"),
        ("import math", "import nothing_of_that_name", "cannot be run"),
    ],
)
def test_a_task_file_that_is_wrong_says_what(tmp_path, old, new, says):
    with pytest.raises(TaskError, match=says):
        make(tmp_path, tasks=chapter.TASKS.replace(old, new))


def test_making_cases_leaves_no_ros_behind(tmp_path):
    activation.deactivate()  # another test's, which would stay
    before = {name for name in sys.modules if name.partition(".")[0] in ("rclpy", "tf2_ros")}
    made = chapter.CELLS | {"imports": "import math\nfrom tf2_ros import Buffer"}
    make(tmp_path, cells=made)
    assert {name for name in sys.modules if name.partition(".")[0] in ("rclpy", "tf2_ros")} == before


def test_variants_are_spread_over_learners_and_stay_theirs():
    ids = [f"learner{number}" for number in range(300)]
    counts = [[variant_of(one, "E3.1", 3) for one in ids].count(variant) for variant in range(3)]
    assert min(counts) > 60
    assert variant_of("ada", "E3.1", 3) == variant_of("ada", "E3.1", 3)
    assert variant_of(None, "E3.1", 3) == 0


def test_given_values_come_back_as_values(tmp_path):
    given = make(tmp_path).tasks["E3.1"].variants[0].given
    assert isinstance(from_plain(given["base_T_laser"]), Transform)


def test_an_outline_is_the_chapter_without_variants():
    for path in sorted((workbook_data() / CASES).glob("*.json")):
        whole, outline = read_chapter(path), read_outline(path)
        assert outline.tasks == {name: task._replace(variants=()) for name, task in whole.tasks.items()} != {}
