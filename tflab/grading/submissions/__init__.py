"""What came in: whose it is, and what can be read of it, as strings.

    collect       folders, zips, names as learning systems give them
    listing       which files there are, zips included
    owners        whose they are
    archives      a zip, without being harmed by it
    roster        who is in the class
    shallow_json  a stranger's JSON
    skimmed       a notebook without what nobody reads
    reader        a stranger's notebook, as strings
    reasons       why it could not be read
    remarks       what is said of what was found

Nothing in here runs a line of what was handed in.  Start with `collect.py`.
"""
