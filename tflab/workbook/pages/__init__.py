"""Build the notebooks of a page in two languages, its HTML and its slides.

source          read a page's source
rules           check what every page must keep to
exercise_rules  check what an exercise must keep to
editions        make a page's notebooks: lecture, exercise and solution, in each language
execute         run a page in a kernel
stale           compare what was built with what would be built
build           build one page, or all of them
html            write a notebook as HTML
site            write all pages as one book
slides          write a page as slides
"""
