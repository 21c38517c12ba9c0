"""How `check` explains an answer by all its parts and all its calls together."""

from __future__ import annotations

import pytest

from tflab.workbook.answers.forms import Choice, Name, Number, Parts, Sequence, form_from_plain
from tflab.workbook.answers.values import to_plain
from tflab.workbook.diagnosis.explanation import PartFound, merge_found
from tflab.workbook.diagnosis.verdict import judge_outcomes
from tflab.workbook.tasks import Text
from tflab.workbook.tasks.case_types import Case, Feedback

from .small_chapter import bare
from .test_explain import judged, judged_function

PLACES = ("third", "first", "second", "last")  # in another order than the alphabet's
CARDS = ("names", "tree", "mount", "rates", "wait")
IN_ORDER = Parts({place: Choice(CARDS) for place in PLACES})


def test_parts_keep_the_order_of_the_work_in_a_file():
    assert list(form_from_plain(IN_ORDER.plain()).parts) == list(PLACES)
    assert "order" not in Parts({"a": Number(), "b": Number()}).plain()


def test_what_a_part_shows_is_said_beside_its_sign_and_of_a_list_by_the_place():
    words = Text("It turns about its own z.", "제 z축으로 돕니다.")
    form = Parts({"a": Number("m"), "b": Sequence(Choice(("in", "out")))})
    task, variant = bare(form, Case(None, to_plain({"a": 1.0, "b": ["in", "out"]}), {}))
    task = task._replace(shows={"a": words, "[1]": Text("The second.", "둘째입니다.")})
    verdict = judge_outcomes(task, variant, [to_plain({"a": -1.0, "b": ["in", "in"]})])
    assert verdict.said.en == '"a": the size is right, the sign is not. It turns about its own z. "b[1]": The second.'


def test_of_a_part_that_nothing_explains_it_is_said_how_far_it_is_off():
    form = Parts({"a": Number("m"), "b": Number("m")})
    verdict = judged(form, {"a": 1.0, "b": 2.0}, {}, {"a": -1.0, "b": 2.1})
    assert verdict.said.en.endswith('"b": not right yet (too large, by less than 10 %).')


def test_a_part_whose_name_the_reply_says_already_is_named_once():
    replies = {"a": Text("a: it was turned.", "a: 돌렸습니다."), "b": Text("b: it was moved.", "b: 옮겼습니다.")}
    found = [PartFound({name: Feedback(reply, "")}, reply, {name}) for name, reply in replies.items()]
    said = merge_found(found, {}, ["a", "b"]).said
    assert said == Text('"a": it was turned. "b": it was moved.', '"a": 돌렸습니다. "b": 옮겼습니다.')


def test_which_word_is_said_for_which_comes_after_a_cause():
    form = Parts({"a": Choice(("in", "out")), "b": Number("m")})
    asked = [({"a": "in", "b": 1.0}, {"a": "out", "b": -1.0}), ({"a": "in", "b": 2.0}, {"a": "out", "b": -2.0}),
             ({"a": "out", "b": 3.0}, {"a": "out", "b": -3.0})]  # fmt: skip
    assert list(judged_function(form, asked).mistakes) == ["sign", "a: out for in"]


# -- words, each on its own --------------------------------------------------------------------


WORDS = Sequence(Choice(("sim", "wall", "off")))


def test_of_mistakes_that_give_some_of_the_words_none_is_named():
    asked = [(["sim", "off", "wall"], ["wall", "off", "off"]), (["sim", "wall"], ["wall", "wall"])]
    by_mistake = {"never sim": [["wall", "off", "wall"], ["wall", "wall"]]}
    assert list(judged_function(WORDS, asked, by_mistake).mistakes) == ["wall for sim"]


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (("out", "out", "out", "off"), " There the door is open."),
        (("out", "out", "out", "out"), '"in": There the door is open.'),  # of several words, of which one it is
    ],
)
def test_beside_words_that_are_confused_stands_what_there_is_to_see(given, said):
    cases = [Case([place], want, {}) for place, want in enumerate(("in", "in", "out", "off", "ok"))]
    task, variant = bare(Choice(("in", "out", "off", "ok")), *cases, is_function=True)
    task = task._replace(seen={"in": Text("There the door is open.", "문이 열려 있습니다.")})
    assert said in judge_outcomes(task, variant, [*given, "ok"]).said.en


def test_the_call_that_is_shown_is_one_of_which_the_reply_speaks():
    asked, said = ("in", "off", "off", "out"), ("out", "out", "out", "out")
    cases = [Case([place], want, {}) for place, want in enumerate((*asked, "in"))]
    task, variant = bare(Choice(("in", "out", "off")), *cases, is_function=True)
    verdict = judge_outcomes(task, variant, [*said, "in"])
    assert verdict.said.en.startswith('you never answer "off"')
    assert verdict.case == 1


# -- what is lost of lists, and of numbers that are counted -------------------------------------

COUNT, NAMES = Number(), Sequence(Name())
ROWS = [["c", "a", "b"], ["b", "c"], ["d"]]


@pytest.mark.parametrize(
    ("form", "asked", "name"),
    [
        (NAMES, [(row, row[:1]) for row in ROWS], "first alone"),
        (NAMES, [(row, row[-1:]) for row in ROWS], "last alone"),
        (NAMES, [(row, row[:-1]) for row in ROWS], "all but the last"),
        (NAMES, [(row, row[1:]) for row in ROWS], "all but the first"),
        (COUNT, [(3, 4), (5, 6), (0, 1)], "one too many"),
        (COUNT, [(3, 2), (5, 4), (1, 0)], "one too few"),
        (Number("m"), [(3.0, 3.0), (-5.0, 5.0), (-1.0, 1.0)], "no sign"),
        (Number("m"), [(3.0, 4.0), (5.0, 6.0), (7.0, 8.0)], None),
    ],
)
def test_what_a_function_loses_in_every_call_is_named(form, asked, name):
    assert next(iter(judged_function(form, asked).mistakes), None) == name
