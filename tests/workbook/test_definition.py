"""Tasks that are defined by a Python file and a YAML file beside it."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from tflab.text import Text
from tflab.workbook.tasks import Number, Parts, WrongAnswer, WrongStep, define_task
from tflab.workbook.tasks.task import TaskError

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

TEXTS = CASES["texts"]
SWAPPED = "  - {name: swapped, at: {order: backward}, misconception: M1, part: x, partly: true, en: Back., ko: 뒤.}\n"
ALONE = "  - {name: alone, at: {signs: [-1, 1]}, combines: false, en: Alone., ko: 혼자.}\n"
ZERO = "  - {name: zero, answer: [0, 0.5], en: Zero., ko: 영.}\n"
COMPUTED = "  - {name: half, en: Half., ko: 반.}\n"


def distance(given, *, order="forward", signs=(1, 1)):
    return order, signs


def defined(folder, texts, **changes):
    (folder / "e3_1.yaml").write_text(texts, encoding="utf-8")
    fields = {"kind": "N", "points": 1, "answer": "a", "form": Parts({"x": Number()}), "model": distance}
    return define_task(str(folder / "e3_1.py"), **fields | changes)


def test_a_task_has_the_texts_and_the_mistakes_of_its_file_in_order(tmp_path):
    def half(given):
        return 0.5

    task = defined(tmp_path, TEXTS + SWAPPED + ALONE + ZERO + COMPUTED, answers={"half": half})
    assert (task.id, task.title, task.hints[1]) == ("E3.1", Text("Range", "거리"), Text("Two.", "둘."))
    assert (task.misconceptions, task.means) == (("M1",), {"odom": Text("No.", "아니요.")})
    assert task.equivalent == {"a + b -> b + a": "a sum has no order"}
    swapped, alone, zero, computed = task.mistakes
    assert swapped == WrongStep("swapped", {"order": "backward"}, Text("Back.", "뒤."), "M1", "x", partly=True)
    assert isinstance(alone, WrongAnswer) and alone.answer(None) == ("forward", (-1, 1))
    assert zero == WrongAnswer("zero", [0, 0.5], Text("Zero.", "영."))
    assert (computed.name, computed.answer) == ("half", half)


@pytest.mark.parametrize(
    ("texts", "message"),
    [
        (SWAPPED.replace("order", "unit"), 'line 12: there is no step "unit"; there is order, signs'),
        (SWAPPED.replace("M1", "M99"), 'line 12: there is no misconception "M99"; there is M1'),
        (SWAPPED.replace("partly", "party"), 'line 12: "party" is no key of a task'),
        (SWAPPED.replace("partly: true", "part: x"), 'line 12: "part" is there twice'),
        (SWAPPED.replace(", ko: 뒤.", ""), "line 12: a text has `en` and `ko`, and nothing else"),
        (
            SWAPPED + SWAPPED.replace("Back.", "Other.").replace("뒤", "앞"),
            'line 13: two mistakes are called "swapped"',
        ),
        (SWAPPED + ZERO.replace("영", "뒤"), 'line 13: "zero" has the reply of another mistake'),
        (SWAPPED.replace("name: swapped, ", ""), "line 12: a mistake has a `name`"),
        (COMPUTED, 'line 12: "half" has one of `at`, `answer` and an entry in ANSWERS of e3_1.py'),
        (SWAPPED.replace("misc", "answer: 1, misc"), 'line 12: "swapped" has one of `at`, `answer` and an entry'),
        ("  - swapped\n", "line 12: a mapping is expected"),
        ("  swapped: {}\n", "line 12: a list is expected"),
        (SWAPPED.replace("part: x", "part: y"), 'line 12: there is no part "y"; there is x'),
    ],
)
def test_a_faulty_file_is_refused_with_its_line(tmp_path, texts, message):
    with pytest.raises(TaskError, match=r"^e3_1\.yaml, ") as refused:
        defined(tmp_path, TEXTS + texts)
    assert message in str(refused.value)


def test_a_computed_answer_without_a_mistake_and_a_task_without_its_yaml_file_are_refused(tmp_path):
    with pytest.raises(TaskError, match=r'e3_1\.yaml has no mistake "half", which e3_1\.py computes'):
        defined(tmp_path, TEXTS + SWAPPED, answers={"half": 0.5})
    with pytest.raises(TaskError, match=r"there is no e3_2\.yaml"):
        define_task(str(tmp_path / "e3_2.py"), form=Number())
