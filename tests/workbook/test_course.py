"""The course covers the lecture, its files agree with the pages, and its words are in both languages."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from tflab.workbook.course.contents import (
    EVENING,
    GLOSSARY_PAGE,
    START_PAGE,
    chapter_table,
    form_pages,
    glossary_page,
    start_page,
)
from tflab.workbook.course.course import read_course
from tflab.workbook.course.course_map import draw_course
from tflab.workbook.course.glossary import UnknownTerm, expand, read_glossary
from tflab.workbook.pages.source import read_page
from tflab.workbook.paths import chapters, workbook_data
from tflab.workbook.tasks.catalog import task_ids
from tflab.workbook.tasks.task import chapter_of

# The lecture: 31 sections, 15 questions, 14 things to have done, 8 objectives; which chapter has which.
CHAPTERS = [
    "00_start", "01_value_frame_stamp", "02_axes_and_quaternions", "03_target_and_source", "04_frame_tree",
    "05_map_odom_base_link", "06_static_and_dynamic", "07_urdf_and_sensors", "08_buffer_and_measurement_time",
    "09_exceptions_and_waiting", "10_clocks_and_bags", "11_tools_and_rviz", "12_owners_and_diagnosis",
]  # fmt: skip
SECTIONS = {
    1: {1, 31}, 2: {2, 8, 25, 28, 29}, 3: {3, 13}, 4: {4, 12, 26}, 5: {5, 6}, 6: {7, 8, 9, 10, 29}, 7: {11, 25},
    8: {16, 17, 18}, 9: {19, 20, 21}, 10: {22}, 11: {12, 13, 14, 15}, 12: {23, 24, 27, 28, 29, 30, 31},
}  # fmt: skip
PRACTICE = {
    1: {1}, 2: {2}, 3: {3}, 4: {4, 12}, 5: {5}, 6: {5}, 7: {6}, 8: {2}, 9: {11}, 10: {8}, 11: {9}, 12: {9},
    13: {10}, 14: {7, 12}, 15: {12},
}  # fmt: skip
CHECKLIST = {
    1: {2}, 2: {3}, 3: {6}, 4: {6}, 5: {4, 11}, 6: {11}, 7: {11}, 8: {8}, 9: {8}, 10: {9}, 11: {10}, 12: {10},
    13: {4, 12}, 14: {12},
}  # fmt: skip
OBJECTIVES = {1: {1, 2}, 2: {3, 4}, 3: {5}, 4: {6}, 5: {8}, 6: {11}, 7: {9, 12}, 8: {7, 12}}
HANGUL = re.compile("[가-힣]")


def test_the_chapters_have_their_names_and_build_only_on_earlier_ones() -> None:
    course = read_course()
    assert [chapter.stem for chapter in course.chapters] == CHAPTERS
    for chapter in course.chapters[1:]:
        assert chapter.builds_on
        assert all(before < chapter.number for before in chapter.builds_on)
        page = (workbook_data() / "notebooks" / "src" / f"{chapter.stem}.py").read_text(encoding="utf-8")
        named = page.partition("builds on ")[2].partition("\n")[0]
        assert tuple(int(number) for number in re.findall(r"\d\d", named)) == chapter.builds_on
        assert 15 <= chapter.minutes <= 45


def test_the_path_for_one_evening_takes_three_hours_at_most() -> None:
    assert sum(chapter.minutes for chapter in read_course().chapters if chapter.number in EVENING) <= 180


def test_every_section_and_every_question_of_the_lecture_has_its_chapter() -> None:
    course = read_course()
    assert {chapter.number: set(chapter.sections) for chapter in course.chapters[1:]} == SECTIONS
    assert set().union(*SECTIONS.values()) == set(range(1, 32))
    assert len(course.questions) == len(PRACTICE) == 15
    for number, wanted in PRACTICE.items():
        assert {chapter.number for chapter in course.chapters if number in chapter.practice} == wanted


def test_a_chapter_ends_with_its_practice_questions_and_a_rubric_for_each() -> None:
    for chapter in (chapter for chapter in read_course().chapters if chapter.stem in chapters()):
        page = read_page(workbook_data() / "notebooks" / "src" / f"{chapter.stem}.py")
        rubrics = [cell.source.count("<details>") for cell in page.cells if cell.name == "practice"]  # in en and ko
        assert rubrics == ([len(chapter.practice)] * 2 if chapter.practice else []), chapter.stem


def test_objectives_and_checklist_are_shown_by_tasks_of_their_chapters() -> None:
    course = read_course()
    for goals, wanted in ((course.objectives, OBJECTIVES), (course.checklist, CHECKLIST)):
        found = {number: {chapter_of(task) for task in goal.tasks} for number, goal in enumerate(goals, start=1)}
        assert found == wanted
    for number, goal in enumerate(course.checklist, start=1):
        assert bool(goal.robot) == (number > 1)  # the first needs no robot
        assert all(re.match(r"(ros2 |rviz2$|python3 )", command) for command in goal.robot)


def test_a_goal_names_only_tasks_that_its_chapter_has() -> None:
    course = read_course()
    there = {task for stem in chapters() for task in task_ids(workbook_data(), stem)}
    numbers = {int(stem[:2]) for stem in chapters()}
    named = {task for goal in (*course.objectives, *course.checklist) for task in goal.tasks}
    assert {task for task in named if chapter_of(task) in numbers} <= there


def test_the_map_draws_each_chapter_behind_those_that_it_builds_on() -> None:
    picture = draw_course([2, 3])
    lines = picture.text.splitlines()
    assert "12 Owners and diagnosis, builds on 7 and 10 and 11, to come" in lines
    assert "3 Target and source, builds on 2" in lines  # and so on 1, which is not said again
    assert len(picture.text.splitlines()) == 12
    assert len(picture.png()) < 60_000


def test_pages_that_are_made_from_files_are_in_step_with_them() -> None:
    root = workbook_data()
    remedy = "run: python -m tflab.workbook.course.contents, then: tflab build 00 12 90"
    assert (root / START_PAGE).read_text(encoding="utf-8") == start_page(root), remedy
    for page, text in form_pages(root).items():
        assert (root / page).read_text(encoding="utf-8") == text, remedy
    assert (root / GLOSSARY_PAGE).read_text(encoding="utf-8") == glossary_page(), remedy


def test_the_table_links_the_chapters_that_have_a_page(tmp_path: Path) -> None:
    (tmp_path / "notebooks/src").mkdir(parents=True)
    (tmp_path / "notebooks/src/03_target_and_source.py").write_text("")
    lines = chapter_table("ko", tmp_path).splitlines()
    assert "**[목표 좌표계와 원본 좌표계](03_target_and_source.ipynb)**" in lines[2]
    assert lines[2].count("|") == lines[0].count("|")
    assert len(lines) == 3


def test_the_map_on_the_first_page_knows_which_chapters_are_here() -> None:
    root = workbook_data()
    here = sorted(
        chapter.number
        for chapter in read_course().chapters[1:]
        if (root / "notebooks/src" / f"{chapter.stem}.py").is_file()
    )
    assert f"lesson.draw_course({here})" in (root / START_PAGE).read_text(encoding="utf-8")


def test_the_course_and_the_twenty_words_of_the_lecture_are_in_both_languages() -> None:
    course, glossary = read_course(), read_glossary()
    assert sum(term.lecture for term in glossary.values()) == 20
    said = [*(chapter.question for chapter in course.chapters), *course.questions]
    said += [goal.words for goal in (*course.objectives, *course.checklist)]
    for text in (*said, *(term.definition for term in glossary.values())):
        assert HANGUL.search(text.ko) and not HANGUL.search(text.en)
    for key, term in glossary.items():
        assert key == term.key.lower() and term.chapter in CHAPTERS
        assert term.definition.en.endswith(".") and term.definition.ko.endswith("니다.")


def test_a_marked_word_explains_itself_and_code_stays_as_it_is() -> None:
    shown = expand("A [[target frame]], `[[x]]`, [[frame|place]].\n\n```\n[[no]]\n```\n[[odom|`odom`]] and ```", "en")
    assert '<abbr title="The frame in which you want the data: the first argument of lookup_transform.">' in shown
    assert ">target frame</abbr>, `[[x]]`, <abbr" in shown
    assert ">place</abbr>.\n\n```\n[[no]]\n```\n<abbr" in shown
    assert shown.endswith(">`odom`</abbr> and ```")


def test_no_mark_is_left_in_a_page() -> None:
    for path in sorted((workbook_data() / "notebooks").glob("*/*.ipynb")):
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        prose = "\n\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")
        assert not re.search(r"\[\[[a-z_ -]+(\||\]\])", re.sub(r"(?s)```.*?```", "", prose)), path.name


def test_in_korean_a_bare_word_shows_both() -> None:
    assert ">목표 좌표계(target frame)</abbr>" in expand("[[target frame]]", "ko")
    assert ">tf2_echo(변환 확인 도구)</abbr>" in expand("[[tf2_echo]]", "ko")
    assert ">좌표계</abbr>" in expand("[[frame|좌표계]]", "ko")


def test_a_word_that_is_not_there_is_said_with_the_nearest() -> None:
    with pytest.raises(UnknownTerm, match='no "taget frame"; did you mean "target frame"'):
        expand("[[taget frame]]", "en")


@pytest.mark.parametrize("stem", [chapter.stem for chapter in read_course().chapters if chapter.number])
def test_a_core_has_at_most_three_thousand_words_and_says_where_it_ends(stem: str) -> None:
    page = read_page(workbook_data() / "notebooks" / "src" / f"{stem}.py")
    texts = [cell for cell in page.cells if cell.lang == "en" and cell.slide != "notes"]
    names = [cell.name for cell in texts]
    core = texts[: names.index("core-end") + 1]
    assert sum(len(cell.source.split()) for cell in core) <= 3000
