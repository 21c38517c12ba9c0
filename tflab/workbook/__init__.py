"""The workbook: pages that are written once, tasks whose wrong answers are named, and a learner's own copy.

In an exercise one calls five functions:

    from tflab.workbook import call, check, hint, task, solution

    checks        check, hint, solution, task
    assigned_task a task as a learner has it
    judge_answer  tries an answer on its cases, and words the reply
    answers/      what an answer may be, and when two are the same
    tasks/        a task, its right answer, its wrong ones, what it is tried on
    diagnosis/    judges an answer, and explains a wrong one by the mistakes that would produce it
    call_limits   bounds the time and memory of a learner's function
    replay        shows one call of a function, and where its result differs
    reply_card    how a reply looks
    phrases       texts that `check` prints besides
    progress      what was tried, and what was passed
    practice      the tasks again, with new numbers
    warm_up       the ungraded question before the exercises
    inventory/    a test before and after; nothing in it is marked
    lesson/       what a page draws, drives and looks at
    rerun_cleanup end what a cell's last run started
    stale_graph   tell the reader when a cell runs in another graph than before
    cell_errors   explain why a cell failed
    course/       chapters, objectives, checklist, terms; where a learner stands
    pages/        from a page's source to notebooks in two languages, HTML, a deck
    book/         the frame, the front page and the gallery of the pages as a book
    copy/         a learner's own copy, and JupyterLab on it
    paths         where the workbook and its files are
    atomic_files  write a file whole or not at all, and lock a folder

The list is the reading order.
"""

from __future__ import annotations

from .checks import call, check, hint, solution, task

__all__ = ["call", "check", "hint", "solution", "task"]
