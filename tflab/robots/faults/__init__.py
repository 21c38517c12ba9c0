"""What goes wrong with TF, and how to make it go wrong: faults to put into any clean recording.

    catalogue      the kinds of fault
    streams        which edges are in a stream of transforms
    patient        where a fault could happen
    broken_tree    two parents, two owners, a hole, a loop, a wrong name or topic
    broken_values  quaternions and numbers that are none
    broken_time    stamps that repeat, step back, lag, lead or stop
    inject         a clean recording -> a broken one, and the truth about it

Start with `catalogue.py`.
"""
