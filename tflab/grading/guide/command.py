"""Write an instructor's guide: `tflab guide 11 12 --lang ko --out teach/`; `tflab release` adds one, too.

teach/guide.html        what to read; prints well
teach/11_....html       the deck, with notes (key s) and the votes among the slides

teach/talk.html, teach/talk-03_....html     with `--plan talk`: the plan, and decks of only its cells
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from tflab.text import LANGUAGES, Text
from tflab.workbook.atomic_files import write_whole
from tflab.workbook.course.course import read_course
from tflab.workbook.pages.html import PageRunError
from tflab.workbook.paths import TASKS, WorkbookError, read_workbook, workbook_data
from tflab.workbook.tasks.catalog import tasks_of

from .chapter import board_patients, chapter_guide, patients_section
from .deck import write_deck
from .layout import STATIC, render, sheet
from .lecture import lectured_page
from .plans import CoursePlan, cells_of, plan_lines, plan_sheet, read_plans
from .teaching import Teaching, TeachingError, votes_of
from .validate import stems_there, teachings_called

__all__ = ["main", "write_guide"]

CLINIC = "12_owners_and_diagnosis"  # the chapter that has patients
TITLE = Text("The instructor's guide", "강사 안내서")


def main(words: Sequence[str]) -> int:
    """Write a guide; return 0, 1 if a deck failed, 2 if nothing was written."""
    options = _options(words)
    out = Path(options.out)
    try:
        language = options.lang or read_workbook().language
        teachings = teachings_called(options.chapters)
        plan = _plan_called(options.plan) if options.plan else None
    except (FileNotFoundError, LookupError, TeachingError, WorkbookError) as error:
        print(f"tflab guide: {error}", file=sys.stderr)
        return 2
    if plan is not None:
        return _planned(out, plan, language, with_decks=not options.no_deck)
    print(write_guide(out, teachings, language))
    return 0 if options.no_deck or not _decks(out, {one.stem: () for one in teachings}, language) else 1


def _planned(out: Path, plan: CoursePlan, language: str, *, with_decks: bool) -> int:
    """Print a plan, write it, and decks of only its cells; return 0, or 1 if a deck failed."""
    print(*plan_lines(plan, language), sep="\n")
    write_whole(out / f"{plan.name}.html", plan_sheet(plan, language))
    print(out / f"{plan.name}.html")
    return 1 if with_decks and _decks(out, cells_of(plan), language, f"{plan.name}-") else 0


def write_guide(out: Path, teachings: Sequence[Teaching], language: str) -> Path:
    """Write the guide of some chapters; return its file. Nothing is run."""
    course, data = read_course(), workbook_data()
    lectures = [(teaching, lectured_page(teaching.stem, language)) for teaching in teachings]
    marked_in = {
        marking.question: int(teaching.stem[:2]) for teaching in teachings_called([]) for marking in teaching.markings
    }
    guides, chapters = [], []
    for teaching, page in lectures:
        chapter = next(chapter for chapter in course.chapters if chapter.stem == teaching.stem)
        tasks = tasks_of(data, teaching.stem) if (data / TASKS / teaching.stem).is_dir() else {}
        guides.append(chapter_guide(teaching, page, course, tasks, marked_in))
        chapters.append(chapter)
    if any(teaching.stem == CLINIC for teaching in teachings):
        guides.append(patients_section(board_patients(), language))
    title, front = TITLE.say(language), (STATIC / f"front.{language}.md").read_text(encoding="utf-8")
    body = render("guide.html", {}, language, title=title, front=front, chapters=chapters, guides=guides)
    path = out / "guide.html"
    write_whole(path, sheet(title, language, body))
    return path


def _decks(out: Path, shown: Mapping[str, Sequence[str]], language: str, prefix: str = "") -> int:
    """Write a deck for each chapter, with some of its cells or all; return how many failed."""
    failed = 0
    for teaching in teachings_called(shown):
        page, name = lectured_page(teaching.stem, language), prefix + teaching.stem
        votes, cells = votes_of(teaching, page), shown[teaching.stem]
        try:
            deck = write_deck(page.notebook, votes, out, name=name, language=language, cells=cells)
        except PageRunError as failure:
            print(failure, file=sys.stderr)
            failed += 1
        else:
            print(deck, flush=True)
    return failed


def _plan_called(name: str) -> CoursePlan:
    plans = read_plans()
    if name not in plans:
        raise LookupError(f'there is no plan "{name}"; there is {", ".join(plans)}')
    return plans[name]


def _options(words: Sequence[str]) -> argparse.Namespace:
    there = ", ".join(stem[:2] for stem in stems_there())
    parser = argparse.ArgumentParser(prog="tflab guide", description="Write what an instructor lectures from.")
    parser.add_argument("chapters", nargs="*", metavar="CHAPTER", help=f"such as 11; all of {there} if left out")
    parser.add_argument("--lang", choices=LANGUAGES, help="the workbook's language if left out")
    parser.add_argument("--out", default="guide", metavar="DIR", help="where to; %(default)s if left out")
    parser.add_argument("--plan", metavar="PLAN", help="talk, day or term: the plan, and decks of only its cells")
    parser.add_argument("--no-deck", action="store_true", help="nothing is run: only what is read and printed")
    return parser.parse_args(list(words))
