"""Outcomes get the points they should, and what went wrong is said without giving anything away."""

from __future__ import annotations

import json
import string
from typing import Any

import pytest

from tflab.grading.judging.draw import asks_of
from tflab.grading.judging.pack import read_pack
from tflab.grading.judging.task_score import TaskScore, safe_error_name, score_task
from tflab.grading.submissions.remarks import KINDS, Remark

from . import tiny


@pytest.fixture(scope="module")
def tasks(course: tiny.Course) -> dict[str, Any]:
    return read_pack(course.pack).for_learner("s102")[tiny.STEM]["tasks"]


def expected(task: dict[str, Any]) -> dict[int, Any]:
    return {place: task["cases"][number]["expected"] for place, number in enumerate(asks_of(task))}


def places_of(task: dict[str, Any], *numbers: int) -> list[int]:
    """Return where some cases stand in the order of asking."""
    return [place for place, number in enumerate(asks_of(task)) if number in numbers]


def outcomes_of(task: dict[str, Any], name: str) -> dict[int, Any]:
    return {place: task["cases"][number]["wrong"][name] for place, number in enumerate(asks_of(task))}


def said(mark: TaskScore) -> list[str]:
    return [remark.kind for remark in mark.remarks]


@pytest.mark.parametrize(("task_id", "name"), [("E3.1", "subtracted"), ("E3.2", "added"), ("E3.3", "swapped")])
def test_what_the_solution_gives_gets_all_points_and_a_mistake_is_named(tasks: dict, task_id: str, name: str) -> None:
    mark = score_task(task_id, tasks[task_id], expected(tasks[task_id]))
    assert (mark.status, mark.points, mark.remarks) == ("right", tasks[task_id]["points"], ())
    mark = score_task(task_id, tasks[task_id], outcomes_of(tasks[task_id], name))
    assert (mark.status, mark.points, list(mark.mistakes)) == ("wrong", 0.0, [name])


def test_points_are_for_each_probe(tasks: dict) -> None:
    cases = [case | {"expected": 10.0 + number} for number, case in enumerate(tasks["E3.2"]["cases"])]
    task = tasks["E3.2"] | {"cases": cases}  # by chance two drawn ones might be the same, and could be guessed then
    outcomes = expected(task) | dict.fromkeys(places_of(task, 1), -1.0)
    outcomes |= {place: {"message": []} for place in places_of(task, 2)}
    mark = score_task("E3.2", task, outcomes)
    count = len(task["cases"])
    assert (mark.status, mark.passed, mark.of) == ("partly", count - 2, count)
    assert mark.points == pytest.approx(4 * (count - 2) / count, abs=1e-3)


def test_a_part_that_most_learners_have_alike_earns_nothing_by_itself(tasks: dict) -> None:
    one_part = {0: {"dict": {"target": "map", "source": "map"}}}
    for usual, points in (([True, False], 0.0), ([False, True], 1.0), ([], 1.0)):  # "target" stands first
        assert score_task("E3.3", tasks["E3.3"] | {"usual": usual}, one_part).points == points
    task = tasks["E3.3"] | {"usual": [True, False]}
    assert score_task("E3.3", task, expected(task)).points == task["points"]


def test_a_function_that_changes_its_mind_loses_that_case(tasks: dict) -> None:
    task = tasks["E3.2"]
    again = next(place for place, number in enumerate(asks_of(task)) if number in asks_of(task)[:place])
    mark = score_task("E3.2", task, expected(task) | {again: 0.0})
    assert (mark.passed, said(mark)) == (len(task["cases"]) - 1, ["unsteady"])


@pytest.mark.parametrize(
    "answer",
    [
        None, True, "440", [], {}, {"dict": {}}, {"object": "Everything"}, {"float": "nan"}, {"float": "x"},
        {"raises": 3}, {"raises": "Secret"}, {"tuple": None}, {"message": []}, {"Transform": 3}, {3: 4}, 10**400,
        {"array": [[1], [1, 2]]}, {"unanswered": False}, {"dict": {"target": {"dict": {}}}}, {"sealed": {}},
    ],
)  # fmt: skip
@pytest.mark.parametrize("task_id", ["E3.1", "E3.2", "E3.3"])
def test_whatever_comes_back_is_judged_and_gets_nothing(tasks: dict, task_id: str, answer: Any) -> None:
    task = tasks[task_id]
    mark = score_task(task_id, task, dict.fromkeys(range(len(asks_of(task))), answer))
    assert mark.points == 0.0
    json.dumps(mark.plain())


def test_no_answer_is_no_answer_and_a_value_that_never_came_is_said(tasks: dict) -> None:
    your_turn = {"raises": "NotImplementedError", "text": "your turn"}
    assert score_task("E3.1", tasks["E3.1"], {0: {"unanswered": True}}).status == "unanswered"
    places = range(len(asks_of(tasks["E3.2"])))
    assert score_task("E3.2", tasks["E3.2"], dict.fromkeys(places, your_turn)).status == "unanswered"
    assert said(score_task("E3.1", tasks["E3.1"], {})) == ["no result"]


def test_the_name_of_an_unknown_exception_is_not_repeated() -> None:
    assert safe_error_name("ExtrapolationException") == "ExtrapolationException"
    assert safe_error_name("hidden_3_14") == safe_error_name(None) == Remark("own error")
    assert safe_error_name("_IncompleteInputError") == "SyntaxError"  # Python 3.13


def test_trouble_of_the_run_is_forgotten_if_all_is_right_nevertheless(tasks: dict) -> None:
    trouble = [Remark("raised", "E3.1", error="NameError")]
    assert score_task("E3.1", tasks["E3.1"], expected(tasks["E3.1"]), trouble).remarks == ()
    assert score_task("E3.1", tasks["E3.1"], {0: 1e9}, trouble).status == "trouble"


def test_a_number_counts_within_its_tolerance_and_true_is_not_one(tasks: dict) -> None:
    task = json.loads(json.dumps(tasks["E3.1"]))
    task["cases"][0]["expected"], tolerance = 1.0, task["form"]["tolerance"]
    for tolerances, points in ((0.9, 2.0), (-0.9, 2.0), (1.1, 0.0), (-1.1, 0.0)):
        assert score_task("E3.1", task, {0: 1.0 + tolerances * tolerance}).points == points
    assert score_task("E3.1", task, {0: True}).points == 0.0
    assert score_task("E3.1", task, {0: 1}).points == 2.0


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_every_remark_can_be_said_in_both_languages(kind: str) -> None:
    gaps = {gap for text in KINDS[kind] for _, gap, _, _ in string.Formatter().parse(text) if gap}
    remark = Remark(kind, "E3.2", **dict.fromkeys(gaps, "X"))
    assert Remark.from_plain(json.loads(json.dumps(remark.plain()))) == remark
    for language in ("en", "ko"):
        text = remark.say(language)
        assert text.startswith("E3.2: ")
        assert "{" not in text and "\n" not in text
    assert remark.say("en") != remark.say("ko") or kind in ("file", "unreadable")


def test_a_remark_inside_a_remark_is_said_in_the_same_language() -> None:
    remark = Remark("unreadable", file="a.ipynb", why=Remark("no JSON", line=3))
    assert remark.say("en") == "a.ipynb: not a notebook: no valid JSON, line 3."
    assert remark.say("ko").startswith("a.ipynb: 노트북이 아닙니다.")
    assert remark.plain()["words"]["why"]["kind"] == "no JSON"
    assert Remark.from_plain(json.loads(json.dumps(remark.plain()))) == remark


@pytest.mark.parametrize(
    ("raised", "often", "named"),
    [
        ("MemoryError", False, "an exception"),
        ("LookupException", False, "LookupException"),
        ("MemoryError", True, "MemoryError"),
    ],
)
def test_which_exception_a_hidden_input_led_to_is_named_only_where_it_cannot_tell_of_that(
    tasks: dict, raised: str, often: bool, named: str
) -> None:
    task = tasks["E3.2"]
    outcome = {"raises": raised, "text": "hidden 3.14"}
    some = expected(task) | dict.fromkeys(places_of(task, 0, 1), outcome)
    mark = score_task("E3.2", task, dict.fromkeys(expected(task), outcome) if often else some)
    (remark,) = mark.remarks
    assert f"raises {named} where" in remark.say("en")
    assert "3.14" not in json.dumps(mark.plain())
