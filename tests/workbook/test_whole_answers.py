"""What `check` replies to whole answers: what is wrong with them, and nothing untrue.

whole_answers_of/chapter_NN.yaml has for each task some answers, each with rows. A row changes texts of the answer
and says what the reply has:

    mistakes, includes        the named mistakes, all or one among them
    mistake                   how the answer failed, by its name; `any` or `none`
    said, not said            what the explanation holds, and what it does not
    tip, tip is, certain      what these details hold, or are; `certain begins`
    says nothing, part        that there is no explanation; the part of which the detail is
"""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import pytest
import yaml

from tflab.workbook import checks
from tflab.workbook.answers.values import to_plain

from .whole_answers import task_of, verdict_on

ROWS = [
    pytest.param(task, answer["answer"], row, range(answer.get("variants", 1)), id=f"{task} {answer['about']} {number}")
    for path in sorted(Path(__file__).with_name("whole_answers_of").glob("*.yaml"))
    for task, answers in yaml.safe_load(path.read_text(encoding="utf-8")).items()
    for answer in answers
    for number, row in enumerate(answer["rows"])
]
CHECKS = {
    "mistakes": lambda verdict, want: list(verdict.mistakes) == want,
    "includes": lambda verdict, want: want in verdict.mistakes,
    "mistake": lambda verdict, want: want in (verdict.failure.name, "any") if verdict.failure else want == "none",
    "said": lambda verdict, want: want in verdict.said.en,
    "not said": lambda verdict, want: want not in verdict.said.en,
    "says nothing": lambda verdict, want: (verdict.said is None) is want,
    "tip": lambda verdict, want: want in verdict.detail["tip"].en,
    "tip is": lambda verdict, want: want == verdict.detail["tip"].en,
    "certain": lambda verdict, want: want in verdict.detail["certain"].en,
    "certain begins": lambda verdict, want: verdict.detail["certain"].en.startswith(want),
    "part": lambda verdict, want: want == verdict.detail["part"],
}


@pytest.mark.parametrize(("task", "source", "row", "variants"), ROWS)
def test_the_reply_to_a_whole_answer(task: str, source: str, row: dict, variants: range) -> None:
    changes = row.get("changes", {})
    marks = {old: f"<{number}>" for number, old in enumerate(changes)}  # one may hold what another is replaced by
    for old, mark in marks.items():
        assert source.count(old) == 1, old
        source = source.replace(old, mark)
    for old, new in changes.items():
        source = source.replace(marks[old], new)
    wanted = {key: want for key, want in row.items() if key != "changes"}
    assert wanted
    for variant in variants:
        verdict = verdict_on(task, source, variant)
        for key, want in wanted.items():
            assert CHECKS[key](verdict, want), (key, want, verdict)


def test_a_word_that_is_right_and_counts_nothing_is_explained_where_it_is_chosen_everywhere():
    task = task_of("E9.4")
    one = dict.fromkeys("abc", "transforms arrive late") | {f"{name} do": "wait a little" for name in "abc"}
    two = one | {"a": "laser clock is fast", "a do": "set the laser's clock"}
    held = SimpleNamespace(cases=task, variant=task.variants[0])
    assert len(checks._said_too_often(held, [to_plain(one)])) == 2
    assert checks._said_too_often(held, [to_plain(two)]) == []


def test_a_list_on_which_all_is_healthy_is_reported_beside_what_it_does_not_distinguish():
    form = task_of("E12.4").form.parts["a checks"]
    said = form.remark(["node list"], {"a cause": "localizer waits for /clock"})
    assert "differ from the card" in said.en
    assert "Fixed Frame misspelt" in said.en
    assert "as on the card" not in form.remark(["rviz"], {"a cause": "localizer waits for /clock"}).en
