"""An answer that understands nothing earns at most a twentieth of a function, whoever is asked."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from tflab.grading.judging.pack import Pack, read_pack

from . import tiny

TINY = "E3.2"


@pytest.fixture(scope="module")
def guessing() -> ModuleType:
    page = Path(__file__).parents[2] / "benchmarks" / "guessing.py"
    spec = importlib.util.spec_from_file_location("guessing", page)
    sys.modules["guessing"] = module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def asked_of(pack: Pack, stem: str, task_id: str, learners: int) -> list[dict[str, Any]]:
    return [pack.for_learner(f"s{number}")[stem]["tasks"][task_id] for number in range(learners)]


def test_a_function_gives_next_to_nothing_to_who_does_not_look_at_its_input(
    guessing: ModuleType, course: tiny.Course
) -> None:
    asked = asked_of(read_pack(course.pack), tiny.STEM, TINY, 20)
    assert not guessing.is_above(guessing.of_task(TINY, asked, [3.0, 4.0, 5.0]))


def test_who_knows_what_is_asked_is_above(guessing: ModuleType, course: tiny.Course) -> None:
    (asked,) = asked_of(read_pack(course.pack), tiny.STEM, TINY, 1)
    in_order = [asked["cases"][case]["expected"] for case in asked["asks"]]
    row = guessing.of_task(TINY, [asked], in_order)
    assert guessing.is_above(row)
    assert row.strategy == "replays what was shown"


def test_the_share_without_reasons_is_the_share_that_judging_gives(guessing: ModuleType, course: tiny.Course) -> None:
    (task,) = asked_of(read_pack(course.pack), tiny.STEM, TINY, 1)
    share = guessing.shares_of(task)
    asks, cases = task["asks"], task["cases"]
    right = {place: cases[case]["expected"] for place, case in enumerate(asks)}
    for outcomes in (right, right | {0: -1.0}, dict.fromkeys(right, 3.0), right | {len(asks) - 1: None}):
        judged = guessing.score_task(TINY, task, outcomes)
        assert share(outcomes) * judged.most == pytest.approx(judged.points, abs=1e-3)
    assert share(right) == 1.0


@pytest.mark.proof(reads=["solutions/tasks/{stem}/*", "solutions/en/{stem}.ipynb"])
@pytest.mark.parametrize("stem", ["02_axes_and_quaternions", "09_exceptions_and_waiting"])
def test_no_function_of_words_is_worth_guessing(
    guessing: ModuleType, stem: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("TFLAB_WORKBOOK", raising=False)  # the course itself, not the tiny one
    rows = [row for row in guessing.of_chapter(stem, pack=None, learners=20) if row.is_function]
    assert rows
    assert [row for row in rows if guessing.is_above(row)] == []
