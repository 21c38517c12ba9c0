"""The guide of a chapter holds what a lecture needs, and a faulty teaching file is refused."""

from __future__ import annotations

import copy
import re
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
import yaml

from tflab.clinic.checks import CHECKS
from tflab.clinic.practice import worked_patient
from tflab.clinic.table import COMPLAINTS
from tflab.grading.guide.chapter import board_patients
from tflab.grading.guide.command import main as guide_main
from tflab.grading.guide.command import write_guide
from tflab.grading.guide.deck import only, with_votes, write_deck
from tflab.grading.guide.lecture import lectured_page
from tflab.grading.guide.plans import cells_of, read_plans
from tflab.grading.guide.teaching import TEACHING, TeachingError, votes_of
from tflab.grading.guide.validate import stems_there, teachings_called
from tflab.grading.release import release
from tflab.grading.submissions.roster import Learner
from tflab.workbook.pages.slides import slides_of
from tflab.workbook.paths import chapters, workbook_data
from tflab.workbook.tasks.catalog import task_ids

STEM = "11_tools_and_rviz"
LANGUAGES = ("en", "ko")


@pytest.fixture
def shelf(tmp_path: Path) -> Path:
    """A folder with the page and the teaching file of one chapter, to spoil."""
    for language in LANGUAGES:
        page = Path("notebooks", language, f"{STEM}.ipynb")
        (tmp_path / page).parent.mkdir(parents=True)
        shutil.copyfile(workbook_data() / page, tmp_path / page)
    (tmp_path / TEACHING).mkdir(parents=True)
    shutil.copyfile(workbook_data() / TEACHING / f"{STEM}.yaml", tmp_path / TEACHING / f"{STEM}.yaml")
    return tmp_path


def spoilt(shelf: Path, change: Callable[[dict], object]) -> str:
    """Return what is said of the file after a change."""
    path = shelf / TEACHING / f"{STEM}.yaml"
    plain = yaml.safe_load(path.read_text(encoding="utf-8"))
    change(plain)
    path.write_text(yaml.safe_dump(plain, allow_unicode=True), encoding="utf-8")
    with pytest.raises(TeachingError) as error:
        teachings_called([], shelf)
    return str(error.value)


# -- what is refused -----------------------------------------------------------------------


def test_all_teaching_files_fit_their_pages_and_mark_each_question_once() -> None:
    assert [teaching.stem for teaching in teachings_called([])] == stems_there()


@pytest.mark.parametrize(
    "change, said",
    [
        (lambda plain: plain["plan"][1].update(slide="predicted"), "the page has no slide with the cell `predicted`"),
        (lambda plain: plain["plan"][1].update(slide="load"), "the page has no slide with the cell `load`"),
        (lambda plain: plain["plan"].insert(0, plain["plan"].pop(3)), "follow the deck"),
        (lambda plain: plain["plan"][0].update(minutes=7), "51 minutes of talk; course.yaml says 50"),
        (lambda plain: plain["plan"][-1].update(minutes=39), "39 minutes of lab; course.yaml says 40"),
        (lambda plain: plain["plan"][0].update(who="nobody"), 'nobody is called "nobody"'),
        (lambda plain: plain["demos"][0].update(cell="panel"), "the page has no cell `panel`"),
        (lambda plain: plain["votes"][1]["options"][0]["text"].update(en="17"), '"17" is no option of the page'),
        (lambda plain: plain["votes"][1]["options"][0]["text"].update(ko="17번"), '"17번" is no option of the page'),
        (lambda plain: plain["votes"][3]["options"].pop(), "3 options; the page has 4"),
        (lambda plain: plain["votes"][1]["options"][0].update(expect=16), "sums to 101 %, not to 100"),
        (lambda plain: plain["votes"][1]["options"][0].pop("say"), "an option without a reply: 10"),
        (lambda plain: plain["votes"][1]["options"][1].pop("right"), "one option is right"),
        (lambda plain: plain["votes"][1].update(item=9), "has no question 9"),
        (lambda plain: plain["votes"][0].update(answered="load"), "`load`, where it is answered, stands on no slide"),
        (lambda plain: plain.pop("marking"), "practice question 9 has no marking"),
        (lambda plain: plain["marking"].append(plain["marking"][0]), "practice question 9 is marked twice"),
        (lambda plain: plain["marking"][0].update(question=1), "the chapter does not ask it; it asks 9"),
        (lambda plain: plain["marking"][0].update(half_has=[6]), "the page's rubric has 5 ideas"),
        (lambda plain: plain["handover"].pop("ko"), "en without ko"),
        (lambda plain: plain["votes"][1]["options"][0]["say"].update(ko=" "), "en without ko"),
        (lambda plain: plain["demos"][0].pop("see"), "demos 1 lacks `see`"),
        (lambda plain: plain["plan"][0].update(lat="x"), "has `lat`, which means nothing"),
    ],
)
def test_a_file_that_does_not_fit_is_refused_with_its_place(
    shelf: Path, change: Callable[[dict], object], said: str
) -> None:
    assert said in spoilt(shelf, change)


def test_all_faults_are_told_at_once_and_what_is_no_yaml_is_one_line(shelf: Path) -> None:
    def twice(plain: dict) -> None:
        plain["plan"][0]["minutes"] = 7
        plain["votes"][1]["options"][0]["expect"] = 16

    assert len(spoilt(shelf, twice).splitlines()) == 2
    (shelf / TEACHING / f"{STEM}.yaml").write_text("brings: a: b", encoding="utf-8")
    with pytest.raises(TeachingError, match=r"11_tools_and_rviz.yaml: mapping values are not allowed"):
        teachings_called([], shelf)


# -- what is read --------------------------------------------------------------------------


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_guide_holds_what_pages_and_files_say_and_loads_nothing(tmp_path: Path, language: str) -> None:
    teachings = teachings_called([])
    write_guide(tmp_path, teachings, language)
    guide = (tmp_path / "guide.html").read_text(encoding="utf-8")
    for teaching in teachings:
        page = lectured_page(teaching.stem, language)
        assert f'id="ch{teaching.stem[:2]}"' in guide
        for vote in votes_of(teaching, page):
            assert f"<code>{vote.name}</code>" in guide
    assert ("The cause" if language == "en" else "실제 원인") in guide  # of each patient
    assert guide.count("$ ros2 ") == 6
    assert "<script" not in guide and "http" not in re.sub(r"http-equiv", "", guide.split("</style>")[-1])


def test_the_plan_of_a_guide_goes_on_from_row_to_row_and_a_prediction_is_only_counted(tmp_path: Path) -> None:
    write_guide(tmp_path, teachings_called(["11"]), "en")
    guide = (tmp_path / "guide.html").read_text(encoding="utf-8")
    assert re.findall(r"<td>(\d+–\d+)", guide)[:4] == ["0–6", "6–12", "12–16", "16–24"]
    assert guide.count("A prediction: only count. What to say is for the slide “tf2_monitor: how late?”") == 1


# -- the deck ------------------------------------------------------------------------------


@pytest.mark.parametrize("language", LANGUAGES)
def test_each_vote_is_a_slide_behind_the_one_that_asks_or_takes_its_place(language: str) -> None:
    for teaching in teachings_called([]):
        page = lectured_page(teaching.stem, language)
        votes = votes_of(teaching, page)
        before = copy.deepcopy(page.notebook)
        voted = with_votes(page.notebook, votes, language)
        names = [slide.name for slide in slides_of(voted)]
        assert page.notebook == before
        asked_once = {vote.after for vote in votes if f"vote-{vote.name}" not in names}
        assert asked_once >= {"checkpoint"}
        for cell in voted["cells"]:
            if cell["id"] in asked_once:
                assert cell["source"].count("tflab-vote") == 1 and "<details>" not in cell["source"]
        for vote in votes:
            if vote.after in asked_once:
                continue
            behind = names[: names.index(f"vote-{vote.name}")]
            asking = next(name for name in reversed(behind) if not name.startswith("vote-"))
            assert asking == page.slides[page.shown[vote.after]].name


def test_what_a_fragment_tells_comes_after_the_vote() -> None:
    page = lectured_page("05_map_odom_base_link", "en")
    (teaching,) = teachings_called(["05"])
    slides = slides_of(with_votes(page.notebook, votes_of(teaching, page), "en"))
    names = [slide.name for slide in slides]
    assert names[2:6] == ["predict", "vote-farther-off", "vote-larger-steps", "three-pens"]
    assert slides[2].steps == (("predict",),)


def test_of_a_plan_only_its_cells_are_shown_and_each_begins_as_its_slide_did() -> None:
    page = lectured_page(STEM, "en")
    chosen = ["predict", "rates-seen", "checkpoint", "half-a-century"]
    slides = slides_of(only(page.notebook, chosen))
    assert [slide.steps for slide in slides] == [
        (("half-a-century",),), (("predict",),), (("rates-seen",),), (("checkpoint",),),
    ]  # fmt: skip


SMALL = {
    "cells": [
        {"cell_type": "markdown", "id": "predict", "metadata": {"slideshow": {"slide_type": "slide"}}, "source": "# A"},
    ],
    "metadata": {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}},
    "nbformat": 4,
    "nbformat_minor": 5,
}  # fmt: skip


@pytest.mark.browser
def test_counts_that_are_typed_into_a_deck_become_shares_and_what_to_say(tmp_path: Path, page) -> None:
    (teaching,) = teachings_called(["11"])
    votes = [replace(vote, after="predict") for vote in votes_of(teaching, lectured_page(STEM, "en"))][1:2]
    deck = write_deck(SMALL, votes, tmp_path, name="small", language="en")
    page.goto(f"{deck.as_uri()}#vote-wheels-rate")
    vote = page.locator(".deck-current .tflab-vote")
    for number, count in enumerate((4, 9, 15, 2)):
        vote.locator("input").nth(number).fill(str(count))
    assert vote.locator(".share .number").all_inner_texts() == ["13 %", "30 %", "50 %", "7 %"]
    assert vote.locator(".do").inner_text() == "Once more, explained another way."
    assert not vote.locator(".says").is_visible()
    vote.get_by_role("button", name="Vote again").click()
    for number, count in enumerate((0, 18, 12, 0)):
        vote.locator("input").nth(number).fill(str(count))
    assert vote.locator(".do").inner_text().startswith("Convince a neighbour")
    vote.get_by_role("button", name="What to say").click()
    said = vote.locator(".says > div").all_inner_texts()
    assert said[0].startswith("3") and "Whose line is that?" in said[0]
    assert said[-1].startswith("2") and "right" in said[-1]


# -- where it is, and where it is not --------------------------------------------------------


def test_the_released_chapters_have_their_guide_beside_the_pack_and_not_in_a_copy(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("TFLAB_WORKBOOK", raising=False)
    release(tmp_path, ["11_tools_and_rviz"], [Learner("s101", "Kim", "ko")], language="ko")
    guide = (tmp_path / "instructor" / "guide" / "guide.html").read_text(encoding="utf-8")
    assert 'id="ch11"' in guide and 'id="ch12"' not in guide and 'lang="ko"' in guide
    names = {path.name for path in (tmp_path / "learners").rglob("*")}
    assert not names & {"guide", "guide.html", "teaching"}


# -- plans and patients ------------------------------------------------------------------------


def test_the_plans_show_cells_and_tasks_that_are_there_and_their_minutes_add_up() -> None:
    plans = read_plans()
    assert {name: plan.minutes for name, plan in plans.items()} == {"talk": 120, "day": 6 * 55, "term": 13 * 90}
    assert [f"{part.label.en}" for part in plans["term"].parts] == [f"Week {number}" for number in range(1, 14)]
    assert not {stem for stem in cells_of(plans["day"]) if stem.startswith("10")}
    assert cells_of(plans["term"])["12_owners_and_diagnosis"] == ()  # week 8 has some of it, week 13 all
    there = {task for stem in chapters() for task in task_ids(workbook_data(), stem)}
    planned = {task for plan in plans.values() for part in plan.parts for task in part.tasks}
    in_the_lab = {name for one in teachings_called([]) for row in one.plan for name in row.lab if name.startswith("E")}
    assert planned | in_the_lab <= there


@pytest.mark.parametrize(
    "old, new, said",
    [
        ("minutes: 23", "minutes: 24", "talk: its parts sum to 121 minutes, not to 120"),
        ("the-sentence, inverse", "a-sentence, inverse", "03_target_and_source has no cell `a-sentence`"),
        ("03_target_and_source: [predict", "03_target: [predict", "there is no page `03_target`"),
        ('ko: "두 시간 강연"', 'ko: ""', "en without ko"),
    ],
)
def test_a_plan_that_does_not_fit_is_refused(tmp_path: Path, old: str, new: str, said: str) -> None:
    for folder in ("notebooks", "solutions"):
        (tmp_path / folder).mkdir()
    for language in LANGUAGES:
        (tmp_path / "notebooks" / language).symlink_to(workbook_data() / "notebooks" / language)
    (tmp_path / TEACHING).mkdir()
    text = (workbook_data() / TEACHING / "plans.yaml").read_text(encoding="utf-8")
    assert old in text
    (tmp_path / TEACHING / "plans.yaml").write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(TeachingError, match=re.escape(said)):
        read_plans(tmp_path)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_plan_is_printed_with_its_minutes(tmp_path: Path, capsys: pytest.CaptureFixture, language: str) -> None:
    assert guide_main(["--plan", "talk", "--lang", language, "--out", str(tmp_path), "--no-deck"]) == 0
    printed = capsys.readouterr().out
    assert "80–110" in printed and "110–120" in printed
    assert "80–110" in (tmp_path / "talk.html").read_text(encoding="utf-8")
    assert guide_main(["--plan", "week", "--out", str(tmp_path)]) == 2
    assert 'there is no plan "week"; there is talk, day, term' in capsys.readouterr().err


def test_a_plan_shows_a_deck_of_only_its_cells() -> None:
    for stem, cells in cells_of(read_plans()["talk"]).items():
        shown = slides_of(only(lectured_page(stem, "en").notebook, cells))
        assert [name for slide in shown for step in slide.steps for name in step] == [
            cell["id"] for cell in lectured_page(stem, "en").notebook["cells"] if cell["id"] in cells
        ]


@pytest.mark.proof(reads=["solutions/teaching/**/*.yaml"])
@pytest.mark.parametrize("number", range(6))
def test_what_stands_on_the_board_is_what_the_ward_prints(number: int) -> None:
    told = board_patients()[number]
    patient = worked_patient(told.cause, told.number)
    assert COMPLAINTS[patient.complaint].en == told.words["said"].en
    assert COMPLAINTS[patient.complaint].ko == told.words["said"].ko
    assert CHECKS[told.check].command == told.command
    printed = [line.strip() for line in patient.reading(told.check)[1].splitlines()]
    assert [line for line in told.text.splitlines() if line.strip() not in printed] == []
