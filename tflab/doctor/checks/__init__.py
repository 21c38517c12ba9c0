"""Seven questions in this order, one page each: what could be wrong, and what the evidence says of it.

    motion        steps, and two stories told at once: what the others measure with
    names         1  are the names right?
    spelling         how alike two names are
    tree          2  is it one tree?
    values        3  are the numbers transforms?
    timing        4  is it there in time?  stamps,
    silence          gaps and rates,
    delay            and how late it is heard
    clocks        5  whose clock is it?
    owners        6  who says so?
    statics       7  is what is fixed published as fixed?
    time_sources  what only a living graph can tell

A check takes the evidence and returns findings; it knows no other check.
Start with `motion.py`.
"""
