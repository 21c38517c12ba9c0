"""Write an instructor's guide, decks and course plans from built pages and teaching files (`tflab guide`).

Objectives, predictions, replies, rubrics and notes come from the built pages. In reading order:

    lecture    read a built page: slides, notes, options, rubrics, exit ticket
    teaching   read a chapter's teaching file: solutions/teaching/*.yaml
    vote       questions to the class
    validate   compare a teaching file with its page
    files      the teaching files that there are
    layout     HTML that guides and plans share
    chapter    the guide of a chapter
    patients   six patients of the clinic for the board
    deck       slides with votes
    plans      course plans: a talk, a day, a term
    command    `tflab guide`
"""
