"""Write the guide of a chapter as HTML, and the six patients of the last chapter.

    1 what they can do afterwards      4 what is shown live      7 marking
    2 what they bring                  5 votes                   8 the exit ticket
    3 the minutes                      6 questions of the class  9 what follows

A patient is a file in solutions/teaching/patients: `said`, `command` and `text` are shown to
the class; `rules_out`, `next`, `no_timeout` and `truth` are the answers. They were made by
the clinic from a public number; a test compares.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from markupsafe import Markup

from tflab.text import Text, Texts
from tflab.workbook.course.course import Chapter, Course
from tflab.workbook.paths import workbook_data
from tflab.workbook.tasks.misconceptions import MISCONCEPTIONS
from tflab.workbook.tasks.task import Task

from .layout import render
from .lecture import LecturedPage
from .teaching import (
    LATER,
    RULES,
    TEACHING,
    PlanRow,
    Teaching,
    TeachingError,
    as_words,
    read_yaml,
    said_once,
    votes_of,
)

__all__ = ["BoardPatient", "board_patients", "chapter_guide", "patients_section"]

TEXTS = Texts(__file__)
FOLDER = "patients"
SPOKEN = ("said", "rules_out", "next", "no_timeout", "truth")


def chapter_guide(
    teaching: Teaching,
    page: LecturedPage,
    course: Course,
    tasks: Mapping[str, Task],
    marked_in: Mapping[int, int],
) -> Markup:
    """Return a chapter's guide as HTML.

    Args:
        tasks: those of the chapter.
        marked_in: the chapter whose guide has the samples of each practice question.
    """
    chapter = next(chapter for chapter in course.chapters if chapter.stem == teaching.stem)
    return render(
        "chapter.html", TEXTS, page.language,
        number=f"{chapter.number:02}",
        chapter=chapter,
        page=page,
        teaching=teaching,
        minutes=list(_minutes(teaching.plan, page)),
        votes=votes_of(teaching, page),
        rules=RULES,
        later=LATER,
        practice=list(_practice(teaching, chapter, page, course, marked_in)),
        tasks=tasks,
        misconceptions=MISCONCEPTIONS,
    )  # fmt: skip


def _minutes(plan: Sequence[PlanRow], page: LecturedPage) -> Iterator[dict[str, Any]]:
    """Yield each row of a plan with its minutes, the titles of its slides, and the notes on them."""
    clock = {"talk": 0, "lab": 0}
    slides = [row.slide for row in plan if row.slide]
    for row in plan:
        kind = "lab" if row.lab else "talk"
        begin, clock[kind] = clock[kind], clock[kind] + row.minutes
        shown = []
        if row.slide:
            shown = page.screen(row.slide, (*slides[slides.index(row.slide) + 1 :], None)[0])
        yield {
            "plan": row,
            "when": f"{begin}–{clock[kind]}",
            "titles": dict.fromkeys(slide.title for slide in shown),
            "notes": [note for slide in shown for note in page.notes_of(slide)],
        }


def _practice(
    teaching: Teaching, chapter: Chapter, page: LecturedPage, course: Course, marked_in: Mapping[int, int]
) -> Iterator[dict[str, Any]]:
    """Yield each practice question with its rubric and its marked samples, or the chapter that has these."""
    markings = {marking.question: marking for marking in teaching.markings}
    for question, ideas in zip(chapter.practice, page.rubrics(), strict=False):
        yield {
            "number": question,
            "title": course.questions[question - 1],
            "ideas": ideas,
            "marking": markings.get(question),
            "marked_in": marked_in.get(question),
        }


# -- six patients ------------------------------------------------------------------------


class BoardPatient(NamedTuple):
    """One patient; `words` holds what is said, by its name in the file."""

    cause: str
    number: int
    check: str
    command: str
    text: str
    words: dict[str, Text]


def board_patients(data: Path | None = None) -> list[BoardPatient]:
    """Return the patients, in order; none where there are none.

    Raises:
        TeachingError: a file lacks something, or says it in one language.
    """
    found, faults = [], []
    for path in sorted(((data or workbook_data()) / TEACHING / FOLDER).glob("*.yaml")):
        shown = f"{FOLDER}/{path.name}"
        plain = read_yaml(path, shown)
        lacks = [name for name in (*BoardPatient._fields[:-1], *SPOKEN) if name not in plain]
        faults += [f"{shown} lacks `{name}`" for name in lacks] + list(said_once(plain, f"{shown}:"))
        if not lacks:
            words = {name: as_words(plain[name]) for name in SPOKEN}
            found.append(BoardPatient(*(plain[name] for name in BoardPatient._fields[:-1]), words))
    if faults:
        raise TeachingError(*faults)
    return found


def patients_section(patients: Sequence[BoardPatient], language: str) -> Markup:
    """Return the patients as a part of a guide."""
    return render("patients.html", TEXTS, language, patients=patients)
