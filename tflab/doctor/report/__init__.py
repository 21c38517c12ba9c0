"""What the doctor says, and how it is written down.

    texts    the sentences
    faults   which finding names which fault
    text     the report in a terminal
    history  each edge through time, as pictures
    html     the report as a page

Start with `texts.py`; each page names the next.
"""
