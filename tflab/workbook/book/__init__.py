"""The web book of all pages: layout, search index, and the reference of the code.

search_index    the headings of a page and the text below each, for the search
pages           the frame of a page, the first page, the gallery
reference       the docstrings as pages, by pdoc
"""
