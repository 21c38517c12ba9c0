"""A class before and after: matched learners only, and a line for everything else."""

from __future__ import annotations

import html
import json
import re
from typing import Any

import pytest

from tflab.grading.judging.task_score import score_task
from tflab.grading.release import release
from tflab.grading.reports.class_page import class_page, gain_section
from tflab.grading.reports.gain import (
    MisconceptionCount,
    band,
    class_gain,
    misconception_counts,
    normalised_gain,
    uninformative_items,
    unused_options,
)
from tflab.grading.submissions.remarks import Remark
from tflab.grading.submissions.roster import Learner
from tflab.workbook.answers.values import to_plain
from tflab.workbook.copy.lay_out import lay_out
from tflab.workbook.inventory.items import FORMS, RIGHT, read_inventory
from tflab.workbook.paths import Workbook, exercise_file, workbook_data
from tflab.workbook.tasks.catalog import assigned_cases
from tflab.workbook.tasks.misconceptions import MISCONCEPTIONS

from . import tiny

ITEMS = read_inventory()
STEMS = {"A": "00_start", "B": "12_owners_and_diagnosis"}


def believer(form: str, *misconceptions: str) -> dict[str, str]:
    """What somebody answers who chooses what they believe wherever it is offered, and else is right."""
    answers = {}
    for number, item in enumerate(ITEMS, start=1):
        options = item.forms[form].options
        chosen = [letter for letter, option in options.items() if option.shows in misconceptions]
        answers[str(number)] = chosen[0] if chosen else item.forms[form].right
    return answers


def taken(answers: dict[str, str] | None, form: str, language: str = "en", remarks=()) -> dict[str, Any]:
    """The chapter of a record in which a form was answered; in part, or not at all."""
    passed = len(answers or {})
    row = {"status": "right" if passed == 15 else "partly" if passed else "missing", "passed": passed, "of": 15,
           "points": passed / 15, "most": 1.0, "mistakes": {}, "said": None, "remarks": []}  # fmt: skip
    row |= {"answers": answers} if passed == 15 else {}
    return {"file": "a.ipynb", "language": language, "tasks": {FORMS[form]: row}, "remarks": list(remarks)}


def record(learner: str, before=None, after=None, **more: Any) -> dict[str, Any]:
    chapters = {STEMS["A"]: taken(before, "A"), STEMS["B"]: taken(after, "B")}
    return {
        "learner": learner, "name": "", "language": "en", "handed_in": bool(before or after), "remarks": [],
        "seconds": 0.1, "chapters": chapters, "points": 2.0, "most": 2.0,
    } | more  # fmt: skip


def class_of_thirty() -> list[dict[str, Any]]:
    """Ten who believe M3, ten M7, ten M9; afterwards the first are cured, the second are not, the third believe M10."""
    groups = (("M3", ()), ("M7", ("M7",)), ("M9", ("M10",)))
    return [
        record(f"s{10 * group + number:02}", believer("A", before), believer("B", *after))
        for group, (before, after) in enumerate(groups)
        for number in range(10)
    ]


def words_of(page: str) -> str:
    return html.unescape(re.sub(r"<[^>]+>", " ", page)).replace("\N{NO-BREAK SPACE}", " ")


def test_the_class_page_names_what_was_cured_and_what_grew() -> None:
    page = words_of(class_page(class_of_thirty()))
    # M3 is offered on 2 items of form A, M7 on 1, M9 on 3: 13, 14 and 12 right. Afterwards 15, 14, 14.
    assert "30 learners answered both forms. Right of 15, on average: 13.0 before, 14.3 after" in page
    assert "Normalised gain 0.67: medium (0.3 to 0.7)." in page
    assert (
        "Decreased most: the inverse is only a minus sign (M3) 10 → 0; "
        "latest or receive time instead of the stamp (M9) 10 → 0." in page
    )
    assert "Grew: a timeout solves everything (M10) 0 → 10. Teach it again." in page
    assert "guessing alone gives 3.75" in page
    assert re.search(r"localisation publishes map to base_link \(M7\)\s+33 % → 33 %\s+100 % → 100 %", page)
    assert re.search(r"only a minus sign \(M3\)\s+33 % → 0 %\s+100 % → –\s+gone", page)
    assert "not validated yet" in page


def test_the_three_that_grew_stand_first_and_the_sure_are_counted_apart() -> None:
    before = [believer("A", "M1"), believer("A")]
    after = [believer("B", "M12", "M14", "M4") | {"12": "b?"}, believer("B", "M12", "M4", "M13")]
    pairs = zip(before, after, strict=True)
    found = class_gain([record(f"s{number}", *pair) for number, pair in enumerate(pairs)], ITEMS)
    rows = misconception_counts(ITEMS, found.matched)
    assert rows[:4] == [
        MisconceptionCount("M4", 0, 2, 0, 2),
        MisconceptionCount("M12", 0, 2, 0, 1),
        MisconceptionCount("M13", 0, 1, 0, 1),
        MisconceptionCount("M1", 1, 0, 1, 0),
    ]
    assert len(rows) == 15


def test_a_misconception_has_as_many_chances_before_as_after() -> None:
    """M10 is offered on items 10, 11 and 15 of form A, on 10 of form B: only 10 counts."""
    before = believer("A", "M10") | {"10": ITEMS[9].forms["A"].right}
    found = class_gain([record("s1", before, believer("B"))], ITEMS)
    assert next(row for row in misconception_counts(ITEMS, found.matched) if row.misconception == "M10").before == 0


def test_whoever_is_not_matched_is_a_line_and_counts_nowhere() -> None:
    everybody = class_of_thirty()
    several = Remark("several", chapter=STEMS["A"], file="E00 (1).ipynb", rule=Remark("by latest")).plain()
    everybody[0]["chapters"][STEMS["A"]]["remarks"] = [several]
    everybody[1]["chapters"][STEMS["B"]]["language"] = "ko"
    everybody += [
        record("first-only", dict.fromkeys(believer("A"), "e")),
        record("second-only", after=dict.fromkeys(believer("A"), "e")),
        record("nothing"),
        record("half", dict(list(believer("A").items())[:9]), believer("B")),
    ]
    found = class_gain(everybody, ITEMS)
    assert [line.en for line in found.lines] == [
        "Not all questions answered: half.",
        "Only the first form, no second: first-only.",
        "Only the second form, no first: second-only.",
        "Neither form: nothing.",
        "In another language than the roster's: s01. The letters are the same, so it counts.",
        "Handed in more than once: s00. 00_start was handed in more than once; E00 (1).ipynb was graded: "
        "the latest, by its name.",
    ]
    assert (len(found.matched), found.means()) == (30, (13.0, pytest.approx(43 / 3)))
    for language in ("en", "ko"):
        page = class_page(everybody, language=language)
        assert all(line.say(language).split(":")[0] in words_of(page) for line in found.lines)


def test_the_gain_is_of_the_means_and_has_three_bands() -> None:
    assert round(normalised_gain(6.2, 12.1, 15), 2) == 0.67
    assert [band(gain).en.split()[0] for gain in (-0.2, 0.29, 0.3, 0.7, 0.71)] == [
        "low", "low", "medium", "medium", "high",
    ]  # fmt: skip
    assert normalised_gain(15.0, 15.0, 15) is None
    found = class_gain([record("s1", believer("A"), believer("B", "M5"))], ITEMS)
    assert "Normalised gain: not defined" in "".join(gain_section(found, ITEMS, "en"))


def test_items_and_options_that_tell_little_are_named_once_enough_have_answered() -> None:
    """Twenty believe M3, which costs items 1 and 3; one of them guesses 5a: 5 % of a class of twenty."""
    everybody = [record(f"s{number:02}", believer("A", "M3"), believer("B")) for number in range(20)]
    everybody[0] = record("s00", believer("A", "M3") | {"5": "a?"}, believer("B"))
    everybody[1:6] = [record(f"s{number:02}", believer("A"), believer("B")) for number in range(1, 6)]
    matched = class_gain(everybody, ITEMS).matched
    assert uninformative_items(matched) == [2, *range(4, 16)]  # 25 % had 1 and 3 right
    unused = unused_options(ITEMS, matched)
    assert not {"1a", "3a", "5a"} & set(unused)
    assert {"1c", "1d", "3b", "3c", "5b", "5d"} <= set(unused)
    assert "should be rewritten: 1c, 1d" in class_page(everybody)
    assert "should be rewritten" not in class_page(everybody[:19])


def test_a_class_that_was_not_asked_has_no_such_section_and_one_that_is_half_way_says_so() -> None:
    tasks = {"E3.2": taken(None, "A")["tasks"]["E0.1"]}
    assert class_gain([record("s1", chapters={"03_x": {"file": "", "tasks": tasks, "remarks": []}})], ITEMS) is None
    assert class_gain([record("s1", believer("A"))], ()) is None
    page = class_page([record(f"s{number:02}", believer("A")) for number in range(20)])
    assert "No learner has answered both forms yet." in page
    assert "s11 and 8 more" in page


@pytest.mark.parametrize("form", FORMS)
def test_grading_gives_points_for_answering_and_keeps_the_letters_of_a_complete_answer(form: str) -> None:
    plain = assigned_cases(workbook_data(), STEMS[form], FORMS[form], Workbook()).plain()
    task = plain | plain["variants"][0]
    wrong = dict.fromkeys(map(str, range(1, 16)), "a?")
    mark = score_task(FORMS[form], task, {0: to_plain(wrong | {"3": " C "})})
    assert (mark.status, mark.points, mark.plain()["answers"]) == ("right", 1.0, wrong | {"3": "c"})
    some = score_task(FORMS[form], task, {0: to_plain(wrong | {"3": ..., "5": "x"})})
    assert (some.status, some.passed, some.points) == ("partly", 13, 0.867)
    assert "answers" not in some.plain()
    assert [remark.kind for remark in some.remarks] == ["missing parts"]
    assert score_task(FORMS[form], task, {0: {"unanswered": True}}).status == "unanswered"
    assert score_task(FORMS[form], task, {0: to_plain([1, 2])}).status == "wrong"


# -- what a release gives away ------------------------------------------------------------


@pytest.fixture(scope="module")
def given_away(tmp_path_factory: pytest.TempPathFactory) -> str:
    """All that learners of a class can read, and those who learn alone, in the files of forms A and B."""
    folder = tmp_path_factory.mktemp("release") / "autumn"
    learners = [Learner("s101", "", "en"), Learner("s102", "", "ko")]
    release(folder, [STEMS["A"]], learners)
    last = f"exercises/en/{exercise_file(STEMS['B'])}"
    handed_out = {last: (workbook_data() / last).read_bytes()}
    lay_out(folder / "learners" / "s103", "en", edition="class", learner="s103", handed_out=handed_out)
    lay_out(folder / "learners" / "alone", "en")
    texts = []
    for content in set(tiny.files_below(folder / "learners").values()):
        text = content.decode()
        texts.append(json.dumps(json.loads(text), ensure_ascii=False) if text[:1] == "{" else text)
    return re.sub(r'"image/png": "[^"]*"', "", "\n".join(texts))


@pytest.mark.parametrize("form", FORMS)
def test_a_release_holds_every_question_no_row_of_right_letters_and_no_misconception_beside_an_option(
    given_away: str, form: str
) -> None:
    assert all(item.forms["A"].stem.ko in given_away and item.forms["B"].stem.en in given_away for item in ITEMS)
    counted = [(number, item.forms[form].right) for number, item in enumerate(ITEMS, start=1)]
    for rows in (counted, sorted(counted, key=lambda row: str(row[0]))):  # as one counts, and as JSON sorts
        row = r"\W{0,6}".join(letter for _, letter in rows[:8])
        numbered = r"\W{1,8}".join(rf"{number}\W{{1,6}}{letter}" for number, letter in rows[:5])
        assert not re.search(rf"\b(?:{row}|{numbered})", given_away)
        for told in ("".join(dict(rows).values()), str([*dict(rows).values()]), json.dumps(dict(rows))):
            assert re.search(rf"\b(?:{row}|{numbered})", told)  # these would be found
    beside = {f'"{letter}": "{shown}"' for letter in "abcd" for shown in (RIGHT, *MISCONCEPTIONS)}
    assert [pair for pair in beside if pair in given_away] == []
