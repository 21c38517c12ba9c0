"""Only answers pass from a notebook into the master, and honest ones always."""

from __future__ import annotations

import json

import pytest

from tflab.grading.judging.cells import Master, answers_most
from tflab.grading.judging.pack import read_pack
from tflab.grading.judging.plan import MergedNotebook, merge_submission
from tflab.grading.submissions.reader import read_notebook

from . import tiny


@pytest.fixture(scope="module")
def master(course: tiny.Course) -> Master:
    return read_pack(course.pack).masters[tiny.STEM]


@pytest.fixture
def notebook(course: tiny.Course) -> dict:
    """The exercise with every task answered."""
    return tiny.answered(course.exercise())


def merge(master: Master, notebook: dict) -> MergedNotebook:
    return merge_submission(master, read_notebook(json.dumps(notebook).encode()))


def kinds(done: MergedNotebook) -> list[str]:
    return [f"{placed.kind} {placed.name}" for placed in done.cells]


def source(done: MergedNotebook, name: str) -> str:
    return next(placed.source for placed in done.cells if placed.name == name)


def said(done: MergedNotebook) -> list[str]:
    return [f"{remark.kind} {remark.task}".strip() for remark in done.remarks]


def cell(notebook: dict, name: str) -> dict:
    return notebook["cells"][tiny.index_of(notebook, name)]


def insert(notebook: dict, behind: str, *sources: str) -> None:
    place = tiny.index_of(notebook, behind) + 1
    notebook["cells"][place:place] = [tiny.own_cell(text, f"own-{n}") for n, text in enumerate(sources)]


def test_answers_stand_in_the_master_with_a_probe_where_a_check_stood(master: Master, notebook: dict) -> None:
    done = merge(master, notebook)
    assert kinds(done) == [
        "ours load", "ours imports",
        "ours e3-1-given", "answer e3-1-answer", "probe e3-1-check",
        "answer e3-2-answer", "probe e3-2-check",
        "answer e3-3-answer", "probe e3-3-check",
    ]  # fmt: skip
    assert source(done, "e3-2-answer") == tiny.RIGHT["e3-2-answer"]
    assert done.answered == ("E3.1", "E3.2", "E3.3")
    assert said(done) == []


@pytest.mark.parametrize("language", ["s101", "s102"])
def test_the_language_of_the_page_is_no_matter(master: Master, course: tiny.Course, language: str) -> None:
    assert merge(master, tiny.answered(course.exercise(language))).answered == ("E3.1", "E3.2", "E3.3")


def test_what_is_given_is_never_the_learners(master: Master, notebook: dict) -> None:
    cell(notebook, "e3-1-given")["source"] = "e3_1 = easier"
    done = merge(master, notebook)
    assert source(done, "e3-1-given") == 'e3_1 = task("E3.1")'
    assert "easier" not in str(done.cells)
    assert said(done) == ["changed E3.1"]


def test_an_answer_in_the_check_cell_is_looked_for_there(master: Master, notebook: dict) -> None:
    cell(notebook, "e3-1-answer")["source"] = "total = ..."
    cell(notebook, "e3-1-check")["source"] = "total = 3\ncheck('E3.1', total)"
    done = merge(master, notebook)
    order = [name for name in kinds(done) if "e3-1" in name]
    assert order[:2] == ["ours e3-1-given", "stub e3-1-answer-stub"]
    assert order[-3:] == ["probe e3-1-check", "own e3-1-check+1", "probe e3-1-check-again"]


def test_more_imports_in_our_cell_run_behind_ours(master: Master, notebook: dict) -> None:
    cell(notebook, "imports")["source"] = "import math\nimport cmath"
    done = merge(master, notebook)
    assert kinds(done)[1:3] == ["ours imports", "own imports+1"]
    assert said(done) == []


def test_cells_of_ones_own_stay_where_they_were_put(master: Master, notebook: dict) -> None:
    insert(notebook, "imports", "import cmath", "helper = 1")
    insert(notebook, "e3-2-answer", "other = 2")
    notebook["cells"].insert(0, tiny.own_cell("first = 0", "first"))
    done = merge(master, notebook)
    assert kinds(done)[0] == "own top+1"
    assert kinds(done)[2:5] == ["ours imports", "own imports+1", "own imports+2"]
    assert kinds(done)[9:11] == ["own e3-2-answer+1", "probe e3-2-check"]


def test_cells_in_another_order_run_in_the_masters(master: Master, notebook: dict) -> None:
    notebook["cells"].reverse()
    assert [name for name in kinds(merge(master, notebook)) if "answer" in name] == [
        "answer e3-1-answer", "answer e3-2-answer", "answer e3-3-answer",
    ]  # fmt: skip


@pytest.mark.parametrize("is_beside", [True, False])
def test_two_different_cells_of_one_name_void_that_answer_only(master: Master, notebook: dict, is_beside: bool) -> None:
    second = cell(notebook, "e3-2-answer") | {"source": "def length(x, y): return 7", "id": "other"}
    notebook["cells"].insert(tiny.index_of(notebook, "e3-2-answer") if is_beside else len(notebook["cells"]), second)
    done = merge(master, notebook)
    assert said(done) == ["twice E3.2"]
    assert done.answered == ("E3.1", "E3.3")
    assert "probe e3-2-check" not in kinds(done)


def test_a_copy_that_is_the_same_or_was_left_empty_or_is_text_is_no_second_answer(
    master: Master, notebook: dict
) -> None:
    same = cell(notebook, "e3-2-answer")
    stub = same | {"source": 'def length(x, y):\n    raise NotImplementedError("your turn")', "id": "stub"}
    noted = same | {"cell_type": "markdown", "source": "my first try", "id": "noted"}
    notebook["cells"] += [same | {"id": "copy"}, stub | {"source": ""}, stub, noted]
    done = merge(master, notebook)
    assert said(done) == []
    assert source(done, "e3-2-answer") == tiny.RIGHT["e3-2-answer"]
    assert not any(placed.kind == "own" for placed in done.cells)


def test_metadata_says_more_than_the_id_which_serves_without_it(master: Master, notebook: dict) -> None:
    cell(notebook, "e3-2-answer")["id"] = "4f2a"  # as some editors do
    for one in notebook["cells"]:
        one["metadata"] = one["metadata"] if one["id"] == "4f2a" else {}
    done = merge(master, notebook)
    assert done.answered == ("E3.1", "E3.2", "E3.3")
    assert source(done, "e3-2-answer") == tiny.RIGHT["e3-2-answer"]


def test_without_both_our_cells_are_known_by_their_text_and_the_answers_lie_between(
    master: Master, notebook: dict
) -> None:
    for number, one in enumerate(notebook["cells"]):
        one["metadata"], one["id"] = {}, str(number)
    done = merge(master, notebook)
    assert done.answered == ("E3.1", "E3.2", "E3.3")
    assert [placed.source for placed in done.cells if placed.kind == "own"] == list(tiny.RIGHT.values())


def test_an_answer_that_was_turned_into_text_or_lost_is_said(master: Master, notebook: dict) -> None:
    cell(notebook, "e3-3-answer")["cell_type"] = "markdown"
    del notebook["cells"][tiny.index_of(notebook, "e3-2-answer")]
    done = merge(master, notebook)
    assert sorted(said(done)) == ["missing E3.2", "no code E3.3"]
    assert done.answered == ("E3.1",)


def test_blanks_at_the_ends_of_lines_are_no_change(master: Master, course: tiny.Course) -> None:
    notebook = course.exercise()
    for one in notebook["cells"]:
        one["source"] = "".join(one["source"]).replace("\n", "  \r\n") + "\n\n"
    done = merge(master, notebook)
    assert done.answered == ()
    assert said(done) == []


def test_an_answer_in_front_of_a_cell_that_was_left_as_it_was_is_not_undone_by_it(
    master: Master, course: tiny.Course
) -> None:
    notebook = course.exercise()
    insert(notebook, "e3-1-given", "total = e3_1.a + e3_1.b")
    insert(notebook, "e3-1-check", "def length(x, y): return math.hypot(x, y)")
    order = kinds(merge(master, notebook))
    assert order.index("stub e3-1-answer-stub") < order.index("own e3-1-given+1") < order.index("probe e3-1-check")
    assert order.index("stub e3-2-answer-stub") < order.index("own e3-1-check+1") < order.index("probe e3-2-check")


@pytest.mark.parametrize(
    "halves",
    [
        ("leg = math.hypot", "def length(x, y):\n    return leg(x, y)"),
        ("def length(x, y):", "    return math.hypot(x, y)"),
        ("def leg(x):\n    return x", "def other(x):\n    return x", "def length(x, y):\n    return math.hypot(x, y)"),
    ],
)
def test_an_answer_that_was_split_over_cells_is_one_answer(
    master: Master, notebook: dict, halves: tuple[str, ...]
) -> None:
    place = tiny.index_of(notebook, "e3-2-answer")
    first = notebook["cells"][place]
    notebook["cells"][place : place + 1] = [first | {"source": half, "id": f"x{n}"} for n, half in enumerate(halves)]
    done = merge(master, notebook)
    assert said(done) == []
    assert source(done, "e3-2-answer") == "\n".join(halves)


def test_a_last_cell_that_answers_everything_is_asked_for_all_that_was_left(
    master: Master, course: tiny.Course
) -> None:
    notebook = course.exercise()
    notebook["cells"].append(tiny.own_cell("\n".join(tiny.RIGHT.values()), "all"))
    probes = ["probe e3-3-check-again", "probe e3-1-check-again", "probe e3-2-check-again"]
    assert kinds(merge(master, notebook))[-4:] == ["own e3-3-check+1", *probes]


@pytest.mark.parametrize(
    ("merged", "into"),
    [
        (("e3-1-given", "e3-1-answer"), "e3-1-given"),
        (("e3-1-answer", "e3-1-check"), "e3-1-check"),
        (("imports", "e3-2-answer"), "imports"),
        (("e3-2-answer", "e3-2-check", "e3-3-answer"), "e3-2-answer"),
    ],
)
def test_cells_that_were_merged_lose_no_answer(
    master: Master, notebook: dict, merged: tuple[str, ...], into: str
) -> None:
    cell(notebook, into)["source"] = "\n".join("".join(cell(notebook, name)["source"]) for name in merged)
    notebook["cells"] = [one for one in notebook["cells"] if one["id"] == into or one["id"] not in merged]
    done = merge(master, notebook)
    assert done.answered == ("E3.1", "E3.2", "E3.3")
    ran = "\n".join(placed.source for placed in done.cells if placed.kind in ("own", "answer"))
    assert all(text in ran for name, text in tiny.RIGHT.items())


def test_a_place_is_not_filled_where_a_merged_cell_has_answered(master: Master, notebook: dict) -> None:
    cell(notebook, "e3-1-answer")["source"] += "\n" + tiny.RIGHT["e3-2-answer"]
    del notebook["cells"][tiny.index_of(notebook, "e3-2-answer")]
    stub = source(merge(master, notebook), "e3-2-answer-stub")
    kept = {"length": 7}
    exec(stub, kept)
    assert kept["length"] == 7
    empty: dict = {}
    exec(stub, empty)
    assert callable(empty["length"])


@pytest.mark.parametrize("place", [0, 3, -1])
@pytest.mark.parametrize("text", ["length(3, 4)", "# an idea", "print(length(1, 1))\n1 / 0"])
def test_a_copy_that_answers_nothing_is_a_cell_of_ones_own(
    master: Master, notebook: dict, place: int, text: str
) -> None:
    notebook["cells"].insert(place, cell(notebook, "e3-2-answer") | {"source": text, "id": "scratch"})
    done = merge(master, notebook)
    assert said(done) == []
    assert source(done, "e3-2-answer") == tiny.RIGHT["e3-2-answer"]
    assert text in [placed.source for placed in done.cells if placed.kind == "own"]


def test_a_notebook_without_our_cells_may_answer_all_the_same(master: Master, notebook: dict) -> None:
    def answers(text: str) -> bool:
        cells = {"cells": [tiny.own_cell(text, "all")], "metadata": notebook["metadata"], "nbformat": 4}
        return answers_most(master, read_notebook(json.dumps(cells).encode()))

    assert answers("\n".join(tiny.RIGHT.values()))
    assert not answers("print('a page to read')\ntotal = 3")
