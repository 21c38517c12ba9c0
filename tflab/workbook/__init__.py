"""The workbook: pages that are written once, tasks whose wrong answers are named, and a learner's own copy of it all.

In an exercise one calls four functions:

    from tflab.workbook import check, hint, task, solution

    words         what a person reads, in English and in Korean
    whole_files   files that are written whole or not at all: atomic writes
    places        where the workbook is
    answers/      what an answer may be, and when two are the same
    tasks/        a task, its right answer, its wrong ones, what it is tried on
    mistakes/     those that any answer can have: a bug library
    explaining/   how a wrong answer came about
    verdicts/     what became of an answer, in words
    repairing/    the one place in a function that is wrong
    trying        what became of an answer, and what is said of it
    inventory/    a test before and after; nothing in it is marked
    checks        check, hint, solution, task
    reply         how a reply looks
    again         what a cell finds that runs again
    elsewhere     what is said of a cell that runs again when its world has gone
    unmade        what is said of a cell that fails, and of a name that no cell has made yet
    first_question    a question to be wrong at, before there is an exercise
    progress      what was tried, and what was passed
    course/       chapters, objectives, checklist, terms; where a learner stands
    book/         the frame, the front page and the gallery of the pages as a book
    pages/        from a page's source to notebooks in two languages, HTML, a deck
    copy/         a learner's own copy, and JupyterLab on it
    practice      the tasks again, with new numbers
    lesson/       what a page draws, drives and looks at

"""

from __future__ import annotations

from .checks import check, hint, solution, task

__all__ = ["check", "hint", "solution", "task"]
