"""Grading: what a class handed in becomes points, and a page that says what the class misunderstands.

Only answers are taken from a submission; expected values never enter the learner's
process; the verdict is made outside of it; one submission can harm neither the
grader nor another.

    release, pack, roster             a folder to give away, and one to keep: seed, hidden cases, masters
    grade, submissions, archives      who handed in what: folders, zips, as a learning system gives them
    shallow_json, reader,             a stranger's file as strings; what is said of it
      reasons, remarks
    transplant                        only its answers go on
    plan, inside                      which cells run; the one page of ours that runs among them
    limits, sandbox, namespaces,      how much a submission may take, and what stands between it and us
      seccomp, bubblewrap, landlock
    wire, shell, keeper, forkserver,  kernels that are there before they are asked for, and gone without a trace
      kernels
    items, running                    cells on nbval, each within its limits
    attempt, verdicts                 what hangs is tried again alone; points, mistakes, words
    one, batch, progress_bar          one submission; two hundred
    gradebook, feedback, html,        CSV and JSON; what a learner reads, and what the instructor does
      class_page, misconceptions, class_figures
    check_command, plain_kernel       the same path for a learner, with the public cases
    plugin                            tasks as test items: `pytest --tflab-grade PACK NOTEBOOK`

`docs/grading.md` is the instructor's page.  Start with `release.py`.
"""
