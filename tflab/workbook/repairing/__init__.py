"""Which one change would make a wrong function right?  Where no known mistake fits, its own text is asked.

    sums        how a sum can differ as a whole: its brackets, whose numbers it takes
    edits       how a function can differ from the one that was meant, in one place
    calling     an edited function, called on copies and with an end
    one_place   the place where one edit makes every call right, and what is said of it
    lint        what is plain to see in its text

Start with `sums.py`.
"""
