"""A submission has one answer, however often it runs."""

from __future__ import annotations

from tflab.grading.judging.repeatability import merge_runs, reverse_order
from tflab.workbook.answers.forms import Number, Parts

TASK = {"form": Number().plain(), "is_function": True, "cases": [{"expected": 1.0}] * 3, "asks": [0, 1, 2, 0]}
PARTS = {"form": Parts({"a": Number(), "b": Number()}).plain(), "is_function": False, "cases": [{"expected": {}}]}
RAISED = {"raises": "TypeError", "text": ""}


def heard(task: dict, first: dict, second: dict) -> dict[int, list]:
    """Return what both runs say of each case."""
    both, outcomes = merge_runs(task, first, second)
    return {
        case: [outcomes[place] for place, asked in enumerate(both["asks"]) if asked == case and place in outcomes]
        for case in range(len(task["cases"]))
    }


def test_the_second_run_asks_the_last_first() -> None:
    assert reverse_order(TASK)["asks"] == [0, 2, 1, 0]


def test_two_runs_that_agree_are_heard_side_by_side() -> None:
    assert heard(TASK, {0: 1.0, 1: 2.0, 2: 3.0, 3: 1.0}, {0: 1.0, 1: 3.0, 2: 2.0, 3: 1.0}) == {
        0: [1.0, 1.0, 1.0, 1.0], 1: [2.0, 2.0], 2: [3.0, 3.0],
    }  # fmt: skip


def test_a_second_guess_stands_beside_the_first_and_not_in_its_place() -> None:
    assert heard(TASK, {1: 5.0}, {2: 2.0}) == {0: [], 1: [5.0, 2.0], 2: []}


def test_where_a_run_has_no_value_the_other_counts() -> None:
    assert heard(TASK, {1: RAISED}, {2: 2.0}) == {0: [], 1: [2.0], 2: []}
    assert heard(TASK, {1: 2.0}, {2: RAISED}) == {0: [], 1: [2.0], 2: []}
    assert heard(TASK, {1: RAISED}, {}) == {0: [], 1: [RAISED], 2: []}


def test_who_gives_a_value_now_and_none_then_in_one_run_has_changed_their_mind() -> None:
    assert heard(TASK, {0: RAISED, 3: 1.0}, {0: 1.0}) == {0: [RAISED, 1.0, 1.0], 1: [], 2: []}
    assert heard(TASK, {0: 1.0}, {0: "x", 3: 1.0}) == {0: [1.0, "x", 1.0], 1: [], 2: []}
    assert heard(TASK, {0: RAISED, 3: RAISED}, {0: 1.0, 3: 1.0}) == {0: [1.0, 1.0], 1: [], 2: []}


def test_an_answer_of_which_a_part_is_missing_is_no_value_so_it_cannot_be_filled_up_later() -> None:
    half, other = {"dict": {"a": 1.0, "b": None}}, {"dict": {"a": 7.0, "b": 2.0}}
    assert heard(PARTS, {0: half}, {0: other}) == {0: [other]}


def test_what_is_very_large_is_read_by_no_form_in_neither_run() -> None:
    large = [1.0] * 90_000
    said = heard(TASK, {0: large, 1: [[[2.0]] * 50_000]}, {2: "x" * 4_000_000})
    assert [outcome for outcomes in said.values() for outcome in outcomes] == [{"object": "something very large"}] * 3
