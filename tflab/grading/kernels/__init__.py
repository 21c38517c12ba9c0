"""Run cells in sandboxed kernels that wait ready, and end them with all that they started.

In reading order:

    limits       time, memory, output, processes and files that a submission may use
    rlimits      the limits that the operating system enforces (`setrlimit`)
    sandbox      the three kinds of sandbox, and what each does not protect from
    namespaces   a sandbox of Linux namespaces
    seccomp      a filter of system calls
    landlock     rules for files where there are no namespaces
    bubblewrap   a sandbox by the program `bwrap`
    wire         messages between grader and kernel
    ipython      the kernel that runs a cell
    probe_answer our code beside the learner's: calls an answer and sends the outcomes
    supervisor   the process that watches a kernel and ends it
    forkserver   the process that forks supervisors
    kernel_pool  the grader's side: kernels on request, and the choice of the sandbox
"""
