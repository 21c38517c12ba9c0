"""Find what was handed in, tell whose it is, and read it as strings. Nothing in here runs learners' code.

In reading order:

    collect        submissions from folders and zips, as learning systems name them
    listing        the files of a folder, zips included
    archives       zips, within limits
    roster         the class: ids, names and languages
    bounded_json   JSON of limited depth
    reader         a notebook's cells, as strings
    remarks        remarks on a submission, in both languages
"""
