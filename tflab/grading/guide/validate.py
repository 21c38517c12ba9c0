"""Find teaching files, and compare each with its page.

    slides      a slide, a cell or a figure that the page lacks; slides out of order
    minutes     that do not sum to course.yaml
    votes       options that are not the page's; shares that do not sum to 100 %; an option without a reply
    marking     a practice question with none, or with two; a sample that counts ideas the rubric lacks

Both languages of the page are compared, and all faults are reported at once.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from tflab.text import LANGUAGES
from tflab.workbook.course.course import Chapter, Course, read_course
from tflab.workbook.paths import stems_called, workbook_data
from tflab.workbook.tasks.misconceptions import MISCONCEPTIONS

from .lecture import LecturedPage, lectured_page
from .teaching import TEACHING, Marking, Teaching, TeachingError, read_teaching

__all__ = ["stems_there", "teachings_called", "validate_markings", "validate_teaching"]


def validate_teaching(teaching: Teaching, pages: Sequence[LecturedPage], chapter: Chapter) -> list[str]:
    """Return the faults of one chapter's file beside its page, which stands in `pages` in each language."""
    found: dict[str, None] = {}
    for page in pages:
        for part in (_plan, _demos, _votes):
            found |= dict.fromkeys(part(teaching, page))
    found |= dict.fromkeys(_minutes(teaching, chapter))
    return [f"{teaching.path}: {fault}" for fault in found]


def validate_markings(teachings: Sequence[Teaching], pages: Mapping[str, LecturedPage], course: Course) -> list[str]:
    """Return which practice questions are marked nowhere, twice, or in a chapter that does not ask them.

    That a question has no marking is known when all chapters that ask it are there.
    """
    marked: dict[int, list[str]] = defaultdict(list)
    found = []
    for teaching in teachings:
        asked = next(chapter.practice for chapter in course.chapters if chapter.stem == teaching.stem)
        rubrics = dict(zip(asked, pages[teaching.stem].rubrics(), strict=False))
        for marking in teaching.markings:
            marked[marking.question].append(teaching.path)
            place = f"{teaching.path}: marking of Q{marking.question}"
            found += [f"{place}: {fault}" for fault in _marking(marking, asked, rubrics)]
    read = {teaching.stem for teaching in teachings}
    for question in range(1, len(course.questions) + 1):
        asking = {chapter.stem for chapter in course.chapters if question in chapter.practice}
        places = marked[question]
        if len(places) > 1:
            found.append(f"practice question {question} is marked twice, in {_list(places)}; leave one")
        elif not places and asking <= read:
            found.append(
                f"practice question {question} has no marking; write it into the file of {_list(sorted(asking))}"
            )
    return found


def _marking(marking: Marking, asked: Sequence[int], rubrics: Mapping[int, Sequence[str]]) -> Iterator[str]:
    if marking.question not in asked:
        yield f"the chapter does not ask it; it asks {_list(asked)}"
        return
    ideas = len(rubrics.get(marking.question, ()))
    if any(not 1 <= idea <= ideas for idea in marking.half.ideas):
        yield f"`half_has` is {_list(marking.half.ideas)}; the page's rubric has {ideas} ideas"
    if marking.because not in MISCONCEPTIONS:
        yield f'there is no misconception "{marking.because}"; there is {_list(MISCONCEPTIONS)}'


def _plan(teaching: Teaching, page: LecturedPage) -> Iterator[str]:
    before = -1
    task = re.compile(rf"E{int(teaching.stem[:2])}\.\d+")
    for row in teaching.plan:
        for name in row.lab:
            if not task.fullmatch(name) and name not in page.cells:
                yield f"plan: `{name}` is no task and no cell of this chapter"
        if not row.slide:
            continue
        at = page.shown.get(row.slide)
        if at is None:
            yield f"plan: the page has no slide with the cell `{row.slide}`; there is {_list(page.shown)}"
        elif at <= before:
            yield f"plan: `{row.slide}` comes on the same slide as the row before it, or earlier; follow the deck"
        before = max(before, at or 0)


def _minutes(teaching: Teaching, chapter: Chapter) -> Iterator[str]:
    for name, wanted, rows in (
        ("talk", chapter.talk, [row for row in teaching.plan if row.slide]),
        ("lab", chapter.lab, [row for row in teaching.plan if row.lab]),
    ):
        total = sum(row.minutes for row in rows)
        if total != wanted:
            yield f"plan: {total} minutes of {name}; course.yaml says {wanted}"


def _demos(teaching: Teaching, page: LecturedPage) -> Iterator[str]:
    for demo in teaching.demos:
        for cell in filter(None, (demo.cell, demo.figure)):
            if cell not in page.cells:
                yield f"demos: the page has no cell `{cell}`"


def _votes(teaching: Teaching, page: LecturedPage) -> Iterator[str]:
    names = [vote["name"] for vote in teaching.votes]
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield f"votes: two are called `{name}`"
    for vote in teaching.votes:
        for fault in _vote(vote, page):
            yield f"votes: `{vote['name']}`: {fault}"


def _vote(vote: Mapping[str, Any], page: LecturedPage) -> Iterator[str]:
    cell, options = vote["cell"], vote["options"]
    if cell not in page.cells:
        yield f"the page has no cell `{cell}`"
        return
    if vote.get("after", cell) not in page.shown:
        yield f"`{vote.get('after', cell)}` stands on no slide"
    if vote.get("answered", cell) not in page.shown:
        yield f"`{vote.get('answered')}`, where it is answered, stands on no slide"
    total = sum(option["expect"] for option in options)
    if total != 100:
        yield f"what is expected sums to {total} %, not to 100"
    if sum(bool(option.get("right")) for option in options) != 1:
        yield "one option is right; write `right: true` to it"
    if "item" in vote and page.item(cell, vote["item"]) is None:
        yield f"`{cell}` has no question {vote['item']} ({page.language})"
        return
    if all("text" in option or option.get("unsure") for option in options):
        yield from _named_options(vote, page)
    else:
        yield from _replied_options(vote, page)


def _named_options(vote: Mapping[str, Any], page: LecturedPage) -> Iterator[str]:
    """Yield what is wrong where the page asks in prose: an option has to stand in it, or in what the speaker says."""
    cell = vote.get("options_in", vote["cell"])
    if cell not in page.cells:
        yield f"the page has no cell `{cell}`"
        return
    item = page.item(vote["cell"], vote["item"]) if "item" in vote and "options_in" not in vote else page.cells[cell]
    said = f"{item}\n{page.notes.get(cell, '')}"
    for option in vote["options"]:
        if "text" in option and option.get("quote", option["text"])[page.language] not in said:
            yield f'"{option["text"][page.language]}" is no option of the page, cell `{cell}` ({page.language})'
        if "say" not in option:
            yield f"an option without a reply: {option.get('text', {'en': 'unsure'})['en']}; write `say`"


def _replied_options(vote: Mapping[str, Any], page: LecturedPage) -> Iterator[str]:
    there = page.choices(vote["cell"])
    if len(there) != len(vote["options"]):
        yield f"{len(vote['options'])} options; the page has {len(there)} in `{vote['cell']}` ({page.language})"
    for option, choice in zip(vote["options"], there, strict=False):
        if not choice.text:
            yield f"the page's option {choice.label} has no text ({page.language})"
        if not (choice.reply or "say" in option):
            yield f"an option without a reply: {choice.label} ({page.language}); write `say`"


def _list(names: Iterable[object]) -> str:
    return ", ".join(str(name) for name in names) or "none"


def stems_there(data: Path | None = None) -> list[str]:
    """Return the chapters that have a teaching file, in order."""
    course = {chapter.stem for chapter in read_course().chapters}
    return sorted(path.stem for path in ((data or workbook_data()) / TEACHING).glob("*.yaml") if path.stem in course)


def teachings_called(words: Iterable[str], data: Path | None = None) -> list[Teaching]:
    """Return what the named chapters' files say; all of them if none is named.

    Raises:
        LookupError: a chapter has no such file.
        TeachingError: a file has a fault, or does not fit its page; every fault is in it.
    """
    there = stems_there(data)
    stems = stems_called(words, there, what="teaching file") or there
    course, faults, found, english = read_course(), [], [], {}
    for stem in stems:
        chapter = next(chapter for chapter in course.chapters if chapter.stem == stem)
        pages = [lectured_page(stem, language, data) for language in LANGUAGES]
        try:
            teaching = read_teaching(stem, data)
        except TeachingError as error:
            faults += error.faults
            continue
        faults += validate_teaching(teaching, pages, chapter)
        found.append(teaching)
        english[stem] = pages[0]
    faults += validate_markings(found, english, course)
    if faults:
        raise TeachingError(*faults)
    return found
