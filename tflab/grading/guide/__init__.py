"""Write an instructor's guide, deck and course plans from built pages and teaching files (`tflab guide`).

    lecture     what a built page holds for whoever lectures from it
    teaching    what only a teacher needs: one YAML a chapter
    vote        a question to the room: its options, what is expected, what to say
    misfits     where the two do not fit
    shelf       which files there are, and that they are in order
    sheets      what a guide is set in
    chapter     a chapter's guide
    patients    six sick robots for the board
    deck        the slides, with the votes among them
    plans       a talk, a day, a term
    command     `tflab guide`

Nothing is written twice: objectives, predictions, replies, rubrics and notes are the page's.
Start with `lecture.py`.
"""
