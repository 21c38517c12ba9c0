"""From a page's source to its notebooks in two languages, its HTML and its deck.

    source          a page as text, read
    rules           what a page must keep to
    exercise_rules  what an exercise must, besides
    editions        one page, in English and in Korean, as lecture, exercise and solution
    kernel          a kernel that prints the same every time
    execute         a notebook, run
    one_page        all of this for one page
    stale           what was built of another source
    build           all of this for all pages
    html            pages for reading without Python
    site            all pages as one book
    slides          a page as a deck

Start with `source.py`.
"""
