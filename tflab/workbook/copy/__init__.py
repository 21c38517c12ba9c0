"""A learner's own copy of the workbook.

lay_out      write a copy, and bring it up to date
merge        merge a new page with the learner's: a three-way merge
environment  check that this machine has what the pages need
lab          open the copy in JupyterLab, offline
"""
