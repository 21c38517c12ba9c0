"""Inject TF faults into a clean recording.

    catalogue       the kinds of fault
    streams         the edges of a stream, and where a fault can be put
    broken_tree     two parents, two publishers, a missing edge, a loop, a wrong name or topic
    broken_samples  invalid numbers, and stamps that repeat, step back, lag, lead or stop
    inject          a clean recording -> a broken recording and its diagnosis

The list is the reading order.
"""
