"""A task: its right answer, its wrong ones, and what is said of each.

    task        what a task is
    reference   its right answer comes from its solution; there is no other
    cases       what an answer is tried on
    evidence    what an answer shows, beyond luck: guess correction
    verdict     what became of an answer
    replies     how that is said
    comparison  the wrong answer drawn beside the right one
    blank       a solution with its answers taken out

Start with `task.py`; each page names the next.
"""
