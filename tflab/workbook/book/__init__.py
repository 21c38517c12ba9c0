"""The pages as a book: a front page, a frame around each page, a search without a server, a gallery.

    reading      what stands on a page: its headings, and words to search
    frame        title, contents, the way on, the other language
    front        the first page, and the conventions on one page
    gallery      every figure, with the line that draws it
    reference    what the docstrings say

Nothing here runs a page: `pages/` does, and hands over its HTML.  Start with `reading.py`.
"""
