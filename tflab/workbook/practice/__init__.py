"""Practice without end: the course's tasks, drawn anew, those again that went wrong, ever later.

    from tflab.workbook import practice
    practice.ask()             a question, and a cell for its answer
    practice.check(corner)     what is right or wrong with it, and when it comes again

    spacing    when one meets an idea again: spaced repetition
    deck       what can be asked, drawn from a number
    kept       what was asked and when: a file in the copy
    question   what is shown, and the cell to fill in
    session    ask, answer, go on
    sentences  what is said of it
    terminal   a question as plain text
    prompt     an answer that is typed
    command    `tflab practice`
    cells      the same in a notebook

Start with `spacing.py`.
"""

from __future__ import annotations

from .cells import ask, boxes, check, given, hint, skip, solution, standing

__all__ = ["ask", "boxes", "check", "given", "hint", "skip", "solution", "standing"]
