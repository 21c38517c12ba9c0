"""Kernels that are there before they are asked for, behind a wall, and gone without a trace.

    limits       how much a submission may take
    rlimits      which of that the operating system enforces
    sandbox      which wall this machine has
    namespaces   the first: a process that sees nothing
    seccomp      which system calls are refused
    landlock     where the kernel allows nothing better
    bubblewrap   the second: the same, by bwrap
    wire         two ends that talk
    ipython      what runs a cell in there
    probe        the one page of ours among the learner's cells
    keeper       supervisor of one kernel, and of all that it starts
    forkserver   makes keepers, quickly
    take         the grader's side: a kernel, please

Start with `limits.py`.
"""
