"""An explanation is written once: `check`, `tflab check`, the feedback page and the class page say the same words."""

from __future__ import annotations

from typing import Any

import pytest

from tflab.grading.judging.draw import asks_of
from tflab.grading.judging.pack import Pack, read_pack
from tflab.grading.judging.task_score import score_task
from tflab.grading.reports.class_page import class_page
from tflab.grading.reports.feedback import feedback_page
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.tasks.case_types import TaskCases

from . import tiny


@pytest.fixture(scope="module")
def pack(course: tiny.Course) -> Pack:
    return read_pack(course.pack)


def record(language: str, row: dict[str, Any]) -> dict[str, Any]:
    chapter = {"tasks": {"E3.2": row}, "remarks": []}
    return {
        "learner": "s102", "name": "", "language": language, "handed_in": True, "remarks": [], "seconds": 1.0,
        "points": row["points"], "most": row["most"], "chapters": {tiny.STEM: chapter},
    }  # fmt: skip


@pytest.mark.parametrize("language", ["en", "ko"])
def test_check_and_both_pages_of_a_class_say_of_a_mistake_the_same_words(pack: Pack, language: str) -> None:
    task = pack.for_learner("s102")[tiny.STEM]["tasks"]["E3.2"]
    got = {place: task["cases"][number]["wrong"]["added"] for place, number in enumerate(asks_of(task))}
    mark = score_task("E3.2", task, got)
    held = TaskCases.of_a_learner(task)
    outcomes = [case.wrong["added"] for case in held.variants[0].cases]
    said = judge_outcomes(held, held.variants[0], outcomes).said.say(language)  # what `check` prints
    assert mark.said.say(language) == said == held.feedback["added"].reply.say(language)
    row = mark.plain()
    assert said in feedback_page(record(language, row), pack.titles, "named")
    assert said in class_page([record(language, row)], language=language)
