"""Which teaching files are there, and are they in order?  Those of the chapters that were named, each beside its page.

    teachings_called(["11", "12"])     two, checked; [] has all there are

Nothing is handed on that does not fit: a guide with a wrong minute is worse than none.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from tflab.text import LANGUAGES
from tflab.workbook.course.course import read_course
from tflab.workbook.paths import stems_called, workbook_data

from .lecture import lectured_page
from .teaching import TEACHING, Teaching, TeachingError, read_teaching
from .validate import validate_markings, validate_teaching

__all__ = ["stems_there", "teachings_called"]


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
