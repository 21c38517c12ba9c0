"""Check the evidence, one module for each subject.

    motion    distances of poses, and two sequences of values on one edge: used by the others
    names     1  are the names right?
    tree      2  is it one tree?
    values    3  are the numbers transforms?
    stamps    4  is it there in time? stamps and delays
    silence      gaps, late starts and rates
    clocks    5  do the clocks agree?
    time_bases   whose clock stamped what?
    lookups      do lookups at the stamps of messages work?
    owners    6  has each transform one owner?
    statics   7  is what is fixed published as fixed?

A check takes the evidence and yields findings. No check uses another.
"""
