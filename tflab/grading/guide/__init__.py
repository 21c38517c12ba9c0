"""Write an instructor's guide, decks and course plans from built pages and teaching files (`tflab guide`).

Objectives, predictions, replies, rubrics and notes come from the built pages. In reading order:

    lecture    read a built page: slides, notes, options, rubrics, exit ticket
    teaching   read a chapter's teaching file: solutions/teaching/*.yaml
    validate   compare a teaching file with its page
    layout     HTML that guides and plans share
    chapter    the guide of a chapter
    deck       slides with votes
    plans      course plans: a talk, a day, a term
    command    `tflab guide`
"""
