"""From a notebook that was read to marks: only its answers go on, and the verdict is made outside their process.

    pack          what the instructor keeps: seed, hidden cases, masters
    draw          which hidden cases a learner gets, in which order
    run           a cell on its way to a kernel, and what comes back
    cells         which cell of theirs is which of ours
    transplant    its answers, between our cells
    plan          which cells run, in which order
    nbval_items   cells as nbval's test items
    nbval_run     nbval, on such a kernel, within limits
    attempt       what hangs is tried again, alone
    marks         points, mistakes, words
    job           one submission, as plain data
    choose        which of its notebooks counts
    agree         what an answer says that ran twice
    apart         what is large is looked at elsewhere
    apart_server  there, until it has had enough
    submission    all of it, for one submission
    plain_kernel  the same for a learner's own work, without a wall

Start with `pack.py`.
"""
