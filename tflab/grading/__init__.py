"""Release exercises to a class and grade what is handed in, in a sandbox and with hidden cases.

Only answers are taken from a submission. Expected values never enter the learner's process,
the verdict is made outside of it, and one submission can harm neither the grader nor another.
How a notebook becomes a row of `grades.csv`:

    collect  ->  grade_batch  ->  grade_job  ->  grade_submission  ->  grades_csv
                                                   select_safely, merge_submission, execute, score_safely

In reading order:

    release         `tflab release`: folders for learners, and a pack for the instructor; its update
    grade           `tflab grade`: submissions in, results out
    batch           grade many submissions, several at a time
    submissions/    find notebooks, tell whose they are, and read them as strings
    kernels/        run cells in sandboxed kernels
    judging/        run a submission's answers and score them
    reports/        write grades, feedback and the page of the class
    guide/          write an instructor's guide, decks and course plans: `tflab guide`
    check_command   `tflab check`: the same path for a learner, with the public cases
    plugin          `pytest --nbval` fails where an answer is missing or wrong

`docs/grading.md` is the instructor's documentation.
"""
