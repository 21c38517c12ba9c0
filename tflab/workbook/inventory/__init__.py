"""A concept inventory before and after the course: fifteen questions, one for each misconception, in two forms.

    items           the items of `solutions/inventory.yaml`, their balance, and their questions on a page
    replies         which options somebody chose, how sure they were, and what changed between the forms
    participation   reply to an answered form, and show both forms once both are answered

Nothing in it is marked, and a learner's copy holds nothing of the key.
"""
