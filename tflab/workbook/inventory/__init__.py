"""A test before and after: fifteen questions in everyday words, one for each misconception, in two parallel forms.

    items       what is asked, and what each wrong option shows
    balance     whether the two forms weigh the same
    questions   the questions as an exercise's page has them
    replies     which options somebody chose, and how sure they were
    change      what came of it between the two: cured, held, stuck, lost
    opened      what a learner is shown once both are in
    taking_part what `check` says meanwhile

Nothing in it is marked, and nothing of the key is in a learner's copy.  The field
calls such a test a *concept inventory*.  Start with `items.py`.
"""
