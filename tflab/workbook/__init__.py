"""The workbook: pages that are written once, tasks whose wrong answers are named, and a learner's own copy of it all.

In an exercise one calls four functions:

    from tflab.workbook import check, hint, task, solution

The rooms within the room, in reading order:

    words, values                     what a person reads, twice; what an answer may be, as plain JSON
    measures, structures,
    command_lines, forms              what an answer looks like, and when two are the same
    tasks, reference, cases, sealed   a task, its right answer, its wrong ones; what an answer is tried on
    evidence, verdict, replies,
    showing, comparison, checks       what became of an answer, how it is said, drawn and shown
    places, learner, merge, lab       where the workbook is, a learner's copy, JupyterLab on it
    whole_files, progress             files that are written whole; what was tried and what was passed
    course, standing, progress_page   chapters, objectives, checklist; what a learner has shown of them
    glossary, contents, course_map    terms, and what of the pages is made from files
    environment                       whether this machine has what the pages need
    source, rules, editions,
    one_page, build                   from a page's source to its notebooks in two languages
    html, slides                      the same pages for reading and for lecturing

Start with `words.py`.
"""

from __future__ import annotations

from .checks import check, hint, solution, task

__all__ = ["check", "hint", "solution", "task"]
