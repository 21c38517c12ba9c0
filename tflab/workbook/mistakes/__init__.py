"""The mistakes that any answer can have, and whether outcomes are just what one of them gives: a bug library.

    units       in which other unit it may be
    by_place    which of a point's numbers has the wrong sign, which two have changed places
    written     which place holds the number of another
    angles      whether a quaternion's numbers are its angles
    universal   mistakes that any answer can have
    names       what is wrong with a name: its slashes, or nothing was filled in
    losses      what was lost and cannot be put back
    trees       what is wrong with a tree
    shell_words where a command line goes wrong
    python_errors   what one of Python's own errors means
    lint        what is plain to see in a function's text
    fields      which parts an answer has
    fitting     whether outcomes are just what a mistake gives

Start with `units.py`.
"""
