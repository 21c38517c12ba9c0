"""The questions before and after the course: their numbers are right, and nothing tells their key too early."""

from __future__ import annotations

import html
import math
import re
from pathlib import Path

import pytest

from tflab.core import BufferCore, StampedTransform, Transform
from tflab.core.quaternions import rotate
from tflab.views.axes import optical_from_body
from tflab.workbook import check, hint, solution
from tflab.workbook.answers.forms import Number
from tflab.workbook.answers.values import to_plain
from tflab.workbook.copy.lay_out import lay_out
from tflab.workbook.course.progress_page import progress, show_progress
from tflab.workbook.inventory.items import FORMS, RIGHT, imbalances, inventory_file, parsed, read_inventory
from tflab.workbook.inventory.participation import RevealedForms, pending_notice, revealed_forms
from tflab.workbook.inventory.replies import FORM, changes, chosen, fixed_items, replies_to
from tflab.workbook.pages.exercise_rules import form_faults
from tflab.workbook.pages.source import read_page
from tflab.workbook.paths import Workbook, workbook_data
from tflab.workbook.progress import read_progress
from tflab.workbook.tasks import PARTICIPATION, Task, Text
from tflab.workbook.tasks.catalog import assigned_cases
from tflab.workbook.tasks.task import TaskError, read_tasks

KEY = {"A": "badccdbacdbacdd", "B": "ddbadbccbbcdbca"}
TASKS = workbook_data() / "solutions" / "tasks"
ITEMS = read_inventory()
HANGUL = re.compile("[가-힣]")
SECOND = 1_000_000_000


def answers(letters: str) -> dict[str, str]:
    return {str(number): letter for number, letter in enumerate(letters, start=1)}


def texts(item):
    """Every text of an item, in both forms."""
    yield item.about
    for wording in item.forms.values():
        yield wording.stem
        yield from (text for option in wording.options.values() for text in (option.says, option.why))


# -- what is right ------------------------------------------------------------------------


def numbers_of(number: int, form: str) -> list[float]:
    """Return the numbers of an item's right option."""
    wording = ITEMS[number - 1].forms[form]
    says = wording.options[wording.right].says.en.replace("−", "-")
    return [float(found) for found in re.findall(r"[+-]?\d+(?:\.\d+)?", says)]


def planar(x: float, turned_deg: float) -> Transform:
    return Transform.from_rpy(yaw=math.radians(turned_deg), translation=(x, 0.0, 0.0))


def zero_of_the_count(counted: float, on_the_map: float) -> float:
    return (Transform((on_the_map, 0.0, 0.0)) @ Transform((counted, 0.0, 0.0)).inverse()).translation[0]


def post_is_off_by(v: float, w: float, old_s: float, post: float) -> float:
    """Return how far off a post is that was seen `old_s` ago, after an arc at `v` m/s and `w` rad/s [m]."""
    turned = w * old_s
    arc = (v / w * math.sin(turned), v / w * (1.0 - math.cos(turned)), 0.0)
    then_T_now = Transform.from_rpy(yaw=turned, translation=arc)
    return round(math.dist(then_T_now.apply((post, 0.0, 0.0)), (post, 0.0, 0.0)), 2)


@pytest.mark.parametrize(
    ("number", "form", "expected"),
    [
        (1, "A", planar(0.2, 90).apply((2.0, 0.0, 0.0))[:2]),  # where a ball is in the robot's frame
        (1, "B", planar(0.3, -90).apply((1.5, 0.0, 0.0))[:2]),
        (3, "A", planar(2.0, 90).inverse().translation[:2]),  # the way back
        (3, "B", planar(3.0, -90).inverse().translation[:2]),
        (4, "A", optical_from_body((2.0, 0.5, 0.0))),  # what a camera writes
        (4, "B", optical_from_body((3.0, -0.4, 0.0))),
        (7, "A", [zero_of_the_count(10.0, 9.4)]),
        (7, "B", [zero_of_the_count(25.0, 25.8)]),
        (9, "A", [post_is_off_by(1.0, 0.5, 0.2, 5.0)]),
        (9, "B", [post_is_off_by(0.8, 0.6, 0.25, 4.0)]),
    ],
)
def test_the_numbers_of_the_right_option_are_those_of_the_engine(number, form, expected):
    assert numbers_of(number, form) == pytest.approx(expected)


def test_four_zeros_are_refused_and_the_other_order_is_upside_down():
    buffer = BufferCore()
    assert not buffer.set_transform(
        StampedTransform("map", "part", 0, Transform((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0))), "a"
    )
    assert not buffer.can_transform("map", "part", 0)
    assert rotate((1.0, 0.0, 0.0, 0.0), (0.0, 0.0, 1.0)) == pytest.approx((0.0, 0.0, -1.0))
    assert rotate((1.0, 0.0, 0.0, 0.0), (1.0, 0.0, 0.0)) == pytest.approx((1.0, 0.0, 0.0))


@pytest.mark.parametrize(("form", "one", "other"), [("A", 1.0, 1.4), ("B", 3.0, 3.6)])
def test_two_who_say_one_place_give_places_that_nobody_said(form, one, other):
    buffer = BufferCore()
    for tick in range(20):
        for place, late in ((one, 0), (other, SECOND // 40)):
            stamp_ns = tick * SECOND // 20 + late
            buffer.set_transform(StampedTransform("map", "robot", stamp_ns, Transform((place, 0.0, 0.0))), "")
    asked = (buffer.lookup_transform("map", "robot", ms * SECOND // 1000) for ms in range(950))
    heard = {round(stamped.transform.translation[0], 2) for stamped in asked}
    assert {one, other} <= heard
    assert any(one < place < other for place in heard)
    assert ITEMS[5].forms[form].options[KEY[form][5]].shows == RIGHT


# -- how it is made -----------------------------------------------------------------------


def test_everything_is_said_in_both_languages_each_with_its_own_letters():
    for item in ITEMS:
        for words in texts(item):
            assert not HANGUL.search(words.en)
            assert HANGUL.search(words.ko) or words.en == words.ko
            assert not re.search(r"쪽이 먼저|초에 [^.]{0,40}(묻|물)|안 어디|차선|벽시계|오류문|목표점", words.ko)
        for wording in item.forms.values():
            whys = [option.why.en for option in wording.options.values()]
            assert len(set(whys)) == 4


def test_the_questions_have_no_word_of_ros():
    for item in ITEMS:
        for wording in item.forms.values():
            words = re.sub(r"“[^”]*”", "", wording.stem.en)  # what a program on the screen says
            assert not re.search(
                r"\b(frame|transform|tf2?|odom|stamp|topic|node|publish\w*|lookup|buffer)\b", words, re.I
            )


def test_what_is_still_wrong_leads_to_a_task_that_looks_for_it():
    tasks = {task.id: task for folder in TASKS.glob("[0-9]*") for task in read_tasks(folder)}
    for item in ITEMS:
        assert item.misconception in tasks[item.task].misconceptions


@pytest.mark.parametrize("form", FORMS)
def test_both_forms_are_in_balance_and_have_their_key(form):
    assert list(imbalances(ITEMS, form)) == []
    assert "".join(item.forms[form].right for item in ITEMS) == KEY[form]


def spoilt(old: str, new: str, count: int = 1):
    text = inventory_file().read_text(encoding="utf-8")
    assert old in text
    return parsed(text.replace(old, new, count))


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('says: "(0.2, 2.0)", shows: right', 'says: "(0.2, 2.0)", shows: M1', "form A, item 1: 0 options are right"),
        ('says: "(0, 2.2)", shows: M2', 'says: "(0, 2.2)", shows: ""', 'option "d" shows no misconception'),
        ("- shows: M2", "- shows: M16", "one for each of M1 to M15"),
        ('    d: {says: "(0, 2.2)"', '    z: {says: "(0, 2.2)"', "it has the options a, b, c, not a, b, c, d"),
        ('says: "(0, 1.2)", shows: M1', 'says: "(0, 1.2)", shows: M3', "looks for M1, which no option of form B shows"),
    ],
)  # fmt: skip
def test_what_is_out_of_balance_is_a_fault(old, new, said):
    assert any(said in fault for fault in imbalances(spoilt(old, new), "A"))


def test_more_than_five_right_options_of_one_letter_are_a_fault():
    text = re.sub(r"    b: (.*) shows: \w+,", r"    b: \1 shows: right,", inventory_file().read_text(encoding="utf-8"))
    assert 'form B: "b" is right 13 times, more than 5' in list(imbalances(parsed(text), "B"))


def test_the_build_finds_a_form_out_of_balance_and_a_question_that_was_edited_on_its_page(tmp_path: Path):
    source = workbook_data() / "solutions" / "src" / "00_start.py"
    (tmp_path / "src").mkdir()
    page = tmp_path / "src" / "00_start.py"
    page.write_text(source.read_text(encoding="utf-8").replace("(2, 0), straight", "(3, 0), straight"), "utf-8")
    text = inventory_file().read_text(encoding="utf-8")
    (tmp_path / "inventory.yaml").write_text(text.replace("shows: right", "shows: M1", 1), encoding="utf-8")
    wrong = [fault.wrong for fault in form_faults(read_page(page), read_tasks(TASKS / "00_start"))]
    assert wrong == [
        "form A, item 1: 0 options are right (none), and one has to be",
        "the questions are not those of solutions/inventory.yaml",
    ]
    (tmp_path / "inventory.yaml").write_text("items: 3", encoding="utf-8")
    (fault,) = form_faults(read_page(page), read_tasks(TASKS / "00_start"))
    assert "cannot be read" in fault.wrong


def test_a_task_where_taking_part_counts_has_nothing_that_could_help():
    words = Text("a", "가")
    made = {"id": "E0.1", "kind": "M", "points": 1, "title": words, "answer": "x", "counts": PARTICIPATION}
    Task(**made, form=FORM, hints=())
    with pytest.raises(TaskError, match="without hints or mistakes"):
        Task(**made, form=FORM, hints=(words,) * 3)
    for changed, message in (
        ({"form": Number()}, "the answer is Parts"),
        ({"counts": ""}, "three hints"),
        ({"counts": "showing up"}, 'not "showing up"'),
    ):
        with pytest.raises(TaskError, match=message):
            Task(**made | {"form": FORM, "hints": ()} | changed)


# -- what somebody said -------------------------------------------------------------------


def test_a_letter_is_read_as_it_is_meant():
    given = answers("badccdbacdbacdd") | {"1": "B", "2": "a ?", "3": " E "}
    assert list(chosen(FORM, to_plain(given)).items())[:3] == [("1", "b"), ("2", "a?"), ("3", "e")]
    assert chosen(FORM, to_plain(given | {"4": "f"})) == {}
    assert chosen(FORM, to_plain(["b"])) == {}


def test_sure_and_wrong_is_a_misconception_and_guessed_or_unknown_only_a_gap():
    said = replies_to(ITEMS, "A", answers("badccdbacdbacdd") | {"1": "c", "2": "c?", "3": "e", "4": "c?"})
    assert [reply.kind for reply in said[:5]] == ["wrong", "gap", "gap", "guessed right", "right"]
    assert [reply.shows for reply in said[:5]] == ["M1", "M1", "", "", ""]
    assert replies_to(ITEMS, "A", {"1": ["b"], "2": "", "3": "bad"})[0].kind == "gap"


def test_each_item_is_cured_held_stuck_or_lost_and_what_one_was_sure_of_comes_first():
    before, after = answers(KEY["A"]), answers(KEY["B"])
    before |= {"1": "c", "2": "c?", "3": "e"}
    after |= {"3": "a", "4": "b"}
    found = changes(ITEMS, before, after)
    assert [change.state for change in found[:5]] == ["cured", "cured", "stuck", "lost", "held"]
    assert [change.number for change in fixed_items(found)] == [1]


# -- in a copy ----------------------------------------------------------------------------


@pytest.fixture
def copy(tmp_path, monkeypatch):
    root = lay_out(tmp_path / "mine", "en")
    monkeypatch.chdir(root)
    monkeypatch.delenv("NBGRADER_EXECUTION", raising=False)
    return root


def said(capsys, task_id, answer):
    check(task_id, answer)
    return capsys.readouterr().out


def test_check_counts_answers_and_tells_nothing_before_form_b_is_in(copy, capsys):
    assert pending_notice(copy, "en").startswith("The one task of 00, E0.1, is fifteen questions")
    empty = dict.fromkeys(map(str, range(1, 16)), ...)
    assert "not answered yet" in said(capsys, "E0.1", empty)
    assert "E0.1 13/15: 13 of 15 answered. Not yet: 2, 10." in said(
        capsys, "E0.1", answers(KEY["A"]) | {"2": ..., "10": ...}
    )
    assert "Look at question 3: one of the letters a to e" in said(capsys, "E0.1", answers(KEY["A"]) | {"3": "f"})
    assert "A dict is asked for" in said(capsys, "E0.1", ["b"])
    right, wrong = (said(capsys, "E0.1", answers(letters)) for letters in (KEY["A"], "a" * 15))
    assert right.startswith("E0.1 ✓ 15/15: 15 of 15 answered. Your answers are kept.\nThe answers are shown after")
    assert wrong.startswith("E0.1 ✓ 15/15: 15 of 15 answered. The first answers that you gave are kept")
    assert read_progress(copy)["E0.1"].answers == answers(KEY["A"])
    assert read_progress(copy)["E0.1"].passed
    assert pending_notice(copy, "en").startswith("Fifteen questions") and revealed_forms(copy, "en") is None


def test_form_b_opens_both_and_says_where_to_go(copy, capsys):
    hint("E0.1")
    solution("E12.8")
    assert capsys.readouterr().out.count("no hints and no solution here") == 2
    check("E0.1", answers(KEY["A"]) | {"1": "c", "7": "a", "9": "e"})
    check("E12.8", answers(KEY["B"]) | {"7": "d", "10": "a?"})
    out = capsys.readouterr().out
    assert "Before: 12 right, 12 of them sure. After: 13 right, 13 of them sure." in out
    assert "▲ corrected 2 · ● held 11 · ○ stuck 1 · ▽ lost 1" in out
    assert "  1 · from one part's numbers to another's\n" in out.partition("Where to go now")[0]
    assert "7 · what the map program announces (stuck) → chapter 05, task E5.1" in out
    assert "10 · late, or a wrong clock (lost) → chapter 09, task E9.4" in out
    assert "has not been validated yet" in out
    for item in ITEMS:
        for wording in item.forms.values():
            assert all(option.why.en in out for option in wording.options.values())
    assert pending_notice(copy, "en") == ""


def test_without_form_a_form_b_opens_and_nothing_is_compared(copy, capsys):
    check("E12.8", answers(KEY["B"]))
    assert "15 right, 15 of them sure. Form A was not answered, so there is no before." in capsys.readouterr().out


def test_the_progress_page_waits_and_then_says_what_was_learnt(copy, capsys):
    check("E0.1", answers(KEY["A"]) | {"7": "a"})
    progress([str(copy)])
    assert "Fifteen questions: your first answers are kept." in capsys.readouterr().out
    check("E12.8", answers(KEY["B"]) | {"2": "c"})
    progress([str(copy)])
    out = capsys.readouterr().out.rpartition("Your progress")[2]
    assert "▲ corrected 1 · ● held 13 · ○ stuck 0 · ▽ lost 1" in out
    assert "2 · what an arrow between two parts means (lost) → chapter 03, task E3.1" in out
    assert ITEMS[0].forms["A"].options["a"].why.en not in out  # the forms themselves stand on the page
    assert ITEMS[0].forms["A"].options["a"].why.en in html.unescape(show_progress().html)


def test_the_page_and_the_text_say_the_same_in_korean():
    page = RevealedForms(ITEMS, answers(KEY["A"]), answers(KEY["B"]) | {"7": "d?"}, "ko")
    assert "7 · 지도 프로그램이 알려야 하는 것 (놓침) → 05장, 과제 E5.1" in page.text
    assert "7 · 지도 프로그램이 알려야 하는 것 (놓침) → 05장, 과제 E5.1" in page.html
    assert page.html.count("<details>") == 2


# -- what a copy gives away ---------------------------------------------------------------


@pytest.mark.parametrize("form", FORMS)
def test_what_check_asks_knows_no_right_answer(form):
    stem = "00_start" if form == "A" else "12_owners_and_diagnosis"
    task = assigned_cases(workbook_data(), stem, FORMS[form], Workbook())
    (variant,) = task.variants
    (case,) = variant.cases
    assert set(case.expected["dict"].values()) == {"e"}
    assert (case.wrong, task.feedback, task.hints, task.misconceptions) == ({}, {}, (), ())
