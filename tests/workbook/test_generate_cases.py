"""The cases of a task: what is given, what is expected, and what each mistake would give."""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path

import pytest
import yaml

from tflab.ros import activation
from tflab.text import Text
from tflab.workbook.answers.values import from_plain
from tflab.workbook.tasks import generate_cases
from tflab.workbook.tasks.case_types import TaskCases
from tflab.workbook.tasks.reference import in_process_ros
from tflab.workbook.tasks.task import TaskError, WrongStep, read_tasks, variant_of

from . import small_chapter as chapter
from .each_task import solution_of, task_in

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))


def make(tmp_path, seed="public", **changes):
    options = {name: changes.pop(name) for name in ("variants", "fewest_inputs") if name in changes}
    return chapter.make_cases(seed, chapter.lay_out(tmp_path, **changes), **options)


def test_the_expected_value_is_what_the_solutions_cell_gives(tmp_path):
    for variant in make(tmp_path)["E3.1"].variants:
        given = {name: from_plain(value) for name, value in variant.given.items()}
        right = given["base_T_laser"].apply(given["laser_p_corner"])
        assert from_plain(variant.cases[0].expected) == pytest.approx(right)


def test_one_seed_makes_the_same_cases_and_another_makes_others(tmp_path):
    one, same, other = ({n: task.variants for n, task in make(tmp_path, seed).items()} for seed in ("a", "a", "b"))
    assert one == same and one["E3.1"] != other["E3.1"]
    assert list(one) == ["E3.1", "E3.2", "E3.3", "E3.4"]
    made = make(tmp_path, fewest_inputs=10, variants=1)
    assert len(made["E3.2"].variants[0].cases) >= 10
    assert len(made["E3.1"].variants) == 1
    for task in made.values():
        assert TaskCases.from_plain(json.loads(json.dumps(task.plain()))) == task._replace(pairs=None)


def test_a_dict_among_the_arguments_keeps_its_order(tmp_path):
    tasks = chapter.TASKS
    for old, new in CASES["order_kept"]:
        tasks = tasks.replace(old, new)
    cell = "def invert(rows):\n    return len(rows)"
    made = make(tmp_path, tasks=tasks, cells=chapter.CELLS | {"e3-2-answer": cell})
    (params,) = made["E3.2"].variants[0].cases[0].args
    assert [*params["dict"]] == ["/mapper", "/**"] and [*params["dict"]["/mapper"]["dict"]] == ["b", "a"]


def test_an_alternative_that_the_model_does_not_have_is_refused():
    stem = "05_map_odom_base_link"
    typo = WrongStep("pitch for yaw", {"yaw": "pich"}, Text("Pitch.", "피치."))
    task = replace(task_in(stem, "e5_5"), mistakes=(typo,))
    with pytest.raises(TaskError, match=r"E5\.5: \"pitch for yaw\" .* alternative {'yaw': 'pich'}"), in_process_ros():
        generate_cases.make_variant(task, "s", 0, solution_of(stem))


AGAIN = "mistakes:\n  - {name: again, answer: {target: laser, source: map}, en: again, ko: 다시}\n"


@pytest.mark.parametrize(
    ("old", "new", "cells", "message"),
    [
        ("base_T_laser.inverse()", "base_T_laser", {}, r'E3\.1, variant 0: .* "swapped" gives the right answer'),
        ("mistakes:\n", AGAIN, {}, r'E3\.3.*"again" and "swapped" give the same answer'),
        ("", "", {"e3-4-answer": "angle_rad = '90 degrees'"}, r"E3\.4: the solution's answer is not one number"),
    ],
)
def test_a_mistake_or_a_solution_that_cannot_be_told_apart_or_read_is_refused(tmp_path, old, new, cells, message):
    with pytest.raises(generate_cases.CasesError, match=message):
        make(tmp_path, tasks=chapter.TASKS.replace(old, new) if old else chapter.TASKS, cells=chapter.CELLS | cells)


def test_inputs_are_drawn_again_if_two_mistakes_give_the_same_answer(tmp_path, monkeypatch):
    usual, refused = generate_cases._refuse_look_alikes, []

    def refuse_the_first(task, variant, made):
        if (task.id, variant) == ("E3.1", 0) and not refused:
            refused.append(made)
            raise generate_cases.EqualAnswersError("these two meet")
        usual(task, variant, made)

    drawn_once = make(tmp_path)
    monkeypatch.setattr(generate_cases, "_refuse_look_alikes", refuse_the_first)
    drawn_anew = make(tmp_path)
    assert refused[0][0].expected == drawn_once["E3.1"].variants[0].cases[0].expected
    assert drawn_anew["E3.1"].variants[0] != drawn_once["E3.1"].variants[0]
    assert drawn_anew["E3.1"].variants[1:] == drawn_once["E3.1"].variants[1:]
    assert drawn_anew["E3.2"].variants == drawn_once["E3.2"].variants


@pytest.mark.parametrize(("cell", "says"), [("x = 1", "does not define angle_rad"), ("1 / 0", "ZeroDivisionError")])
def test_a_solution_without_an_answer_is_refused(tmp_path, cell, says):
    with pytest.raises(TaskError, match=rf"e3-4-answer.*{says}"):
        make(tmp_path, cells=chapter.CELLS | {"e3-4-answer": cell})


@pytest.mark.parametrize(("old", "new", "says"), CASES["faulty_files"])
def test_a_faulty_task_file_is_refused_with_the_reason(tmp_path, old, new, says):
    with pytest.raises(TaskError, match=says):
        make(tmp_path, tasks=chapter.TASKS.replace(old, new))


def test_making_cases_leaves_no_ros_modules(tmp_path):
    activation.deactivate()  # another test's, which would stay
    before = {name for name in sys.modules if name.partition(".")[0] in ("rclpy", "tf2_ros")}
    made = chapter.CELLS | {"imports": "import math\nfrom tf2_ros import Buffer"}
    make(tmp_path, cells=made)
    assert {name for name in sys.modules if name.partition(".")[0] in ("rclpy", "tf2_ros")} == before


def test_variants_are_spread_evenly_over_learners():
    ids = [f"learner{number}" for number in range(300)]
    counts = [[variant_of(one, "E3.1", 3) for one in ids].count(variant) for variant in range(3)]
    assert min(counts) > 60
    assert variant_of("ada", "E3.1", 3) == variant_of("ada", "E3.1", 3)
    assert variant_of(None, "E3.1", 3) == 0


def test_an_outline_is_the_task_without_variants(tmp_path):
    for task, made in zip(
        read_tasks(chapter.lay_out(tmp_path) / "tasks" / chapter.STEM), make(tmp_path).values(), strict=True
    ):
        outline = generate_cases.outline_of(task)
        assert outline.variants == () != made.variants
        assert outline.plain() == made._replace(variants=()).plain()
