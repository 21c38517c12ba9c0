"""Grading: what a class handed in becomes points, and a page that says what the class misunderstands.

Only answers are taken from a submission; expected values never enter the learner's
process; the verdict is made outside of it; one submission can harm neither the
grader nor another.

    release, pack, roster          a folder to give away, and one to keep: seed, hidden cases, masters
    grade, submissions, archives   who handed in what: folders, zips, as a learning system gives them
    reader, remarks, transplant    a stranger's file as strings; what is said of it; only its answers go on
    plan, inside                   which cells run; the one page of ours that runs among them
    limits, sandbox                how much a submission may take, and what stands between it and us
    namespaces, bubblewrap, seccomp, shell, keeper, forkserver, wire, kernels
    running, items                 cells on nbval, each within its limits
    attempt, one, batch            what hangs is tried again alone; one submission; two hundred
    verdicts, gradebook            points, mistakes; CSV and JSON
    feedback, class_page, html     what a learner reads, and what the instructor does
    check_command, plain_kernel    the same path for a learner, with the public cases

Start with `release.py`.
"""
