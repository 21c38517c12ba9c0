"""Grading: what a class handed in becomes points, and a page that says what the class misunderstands.

Only answers are taken from a submission; expected values never enter the learner's
process; the verdict is made outside of it; one submission can harm neither the
grader nor another.

    release       a folder to give away, and one to keep
    mend          what was mended, brought into a release that is out
    grade         `tflab grade`: submissions in, results out
    batch         two hundred submissions, on one core or on many
    submissions/  what came in: whose it is, and what can be read of it
    kernels/      where it runs: behind a wall, gone without a trace
    judging/      only its answers go on; points, mistakes, words
    reports/      what the instructor and the learners read
    guide/        what an instructor lectures from
    check_command the same path for a learner, with the public cases
    plugin        tasks as test items: `pytest --tflab-grade PACK NOTEBOOK`

`docs/grading.md` is the instructor's page.  Start with `release.py`.
"""
