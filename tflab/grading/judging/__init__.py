"""Run the answers of a submission between tflab's own cells, and score the results outside the learner's process.

In reading order:

    pack               the instructor's pack: seed, masters, hidden cases
    draw               the hidden cases of one learner, and their order
    cells              match a notebook's cells with those of the master
    plan               the cells to run, in order, with probes
    nbval_run          run cells by nbval on a sandboxed kernel
    execute            run a notebook; set aside what hangs or dies
    task_score         points, mistakes and messages of a task
    job                one submission as plain data
    select_submission  the notebook that counts, of several
    repeatability      one outcome from two runs
    isolated           judge large answers in a subprocess with CPU and memory limits
    isolated_server    that subprocess
    submission         grade one submission
    plain_kernel       run cells in an ordinary kernel, for `tflab check` outside Linux
"""
